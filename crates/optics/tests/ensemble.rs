//! What holds for every average: threads, domains, sizes from one droplet to drizzle.

use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::ensemble::{Ensemble, EnsembleSpec, QuadratureTolerance, ensemble};
use stratiform_optics::mie::scatter;
use stratiform_optics::phase::PhaseFunction;
use stratiform_optics::{OpticsConfig, OpticsError, compute};

/// Loose enough to be quick.
const LOOSE: QuadratureTolerance = QuadratureTolerance {
    asymmetry: 3e-3,
    forward_fraction: 3e-3,
    moments: 3e-3,
    phase_below_60_deg: 0.05,
    phase_beyond_60_deg: 0.2,
    most_radii: 1 << 16,
};

fn average(
    law: DropletDistribution,
    index: [f64; 2],
    tolerance: QuadratureTolerance,
) -> Result<Ensemble, OpticsError> {
    ensemble(&EnsembleSpec {
        droplets: &law.resolve()?,
        number_density_per_cm3: 100.0,
        wavelength_um: 0.55,
        refractive_index: index,
        theta_f_deg: 5.0,
        tolerance,
    })
}

fn cloud(effective_radius_um: f64) -> DropletDistribution {
    DropletDistribution::ModifiedGamma { gamma: 6.0, effective_radius_um }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| average(cloud(4.0), [1.333, 1e-8], LOOSE).unwrap())
    };
    assert_eq!(with(1), with(3));
}

/// From Rayleigh's regime to drizzle: the table keeps its norm (else it is refused), and its g is that of the
/// Mie coefficients, an independent sum.
#[test]
fn every_size_of_droplet_is_resolved() {
    for radius in [0.02, 0.3, 2.0, 20.0, 60.0] {
        let one = average(cloud(radius), [1.333, 1e-3], LOOSE).unwrap();
        let off = one.phase.asymmetry() - one.asymmetry;
        assert!(off.abs() < 3e-4, "{radius} um: {off}");
        assert!(one.single_scattering_albedo < 1.0);
    }
}

/// Droplets far smaller than the wavelength scatter like Rayleigh's.
#[test]
fn the_smallest_droplets_are_rayleighs() {
    let one = average(cloud(0.002), [1.333, 0.0], LOOSE).unwrap();
    for theta in [0.0_f64, 45.0, 90.0, 180.0] {
        let mu = libm::cos(theta.to_radians());
        let ratio = one.phase.at(theta.to_radians()) / (0.75 * (1.0 + mu * mu));
        assert!((ratio - 1.0).abs() < 2e-3, "{theta}: {ratio}");
    }
}

/// A single size is one sphere: the same efficiencies, and P = 4|S|²/(x²Q_sca) at the nodes.
#[test]
fn one_size_is_one_sphere() {
    let x = 2.0 * std::f64::consts::PI * 5.0 / 0.55;
    let one = average(DropletDistribution::SingleSize { radius_um: 5.0 }, [1.333, 1e-6], LOOSE).unwrap();
    let angles = [0.0, 90.0, 180.0];
    let sphere = scatter(x, [1.333, 1e-6], &angles).unwrap();
    assert!((one.asymmetry - sphere.efficiencies.g).abs() < 1e-14);
    let area = std::f64::consts::PI * 25.0;
    assert!((one.extinction.mie / (1e-4 * sphere.efficiencies.q_ext * area) - 1.0).abs() < 1e-12);
    for (angle, s) in angles.iter().zip(&sphere.amplitudes) {
        let p = 4.0 * s.intensity() / (x * x * sphere.efficiencies.q_sca);
        let ratio = one.phase.at(angle.to_radians()) / p;
        assert!((ratio - 1.0).abs() < 1e-3, "{angle}: {ratio}");
    }
}

/// A gamma distribution read from a fine table is that distribution, in any unit of number.
#[test]
fn a_tabulated_distribution_is_averaged_like_its_law() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("sizes.csv");
    let law = cloud(4.0).resolve().unwrap();
    let rows: String =
        (1..400).map(|i| 0.04 * f64::from(i)).map(|r| format!("{r},{}\n", 17.0 * law.density(r))).collect();
    std::fs::write(&file, format!("radius_um,number\n{rows}")).unwrap();
    let table = average(DropletDistribution::Tabulated { file }, [1.333, 1e-3], LOOSE).unwrap();
    let closed = average(cloud(4.0), [1.333, 1e-3], LOOSE).unwrap();
    assert!((table.asymmetry - closed.asymmetry).abs() < 1e-3, "{} {}", table.asymmetry, closed.asymmetry);
    assert!((table.extinction.mie / closed.extinction.mie - 1.0).abs() < 1e-3);
}

/// Many small droplets with a long tail: a lognormal as wide as aerosols are.
#[test]
fn a_wide_lognormal_is_resolved() {
    let law = DropletDistribution::Lognormal {
        effective_radius_um: Some(1.0),
        median_radius_um: None,
        sigma: Some(0.6),
        effective_variance: None,
    };
    let one = average(law, [1.45, 1e-3], LOOSE).unwrap();
    assert!((one.phase.asymmetry() - one.asymmetry).abs() < 3e-4);
}

#[test]
fn an_error_out_of_reach_is_refused_with_the_one_reached() {
    let tight = QuadratureTolerance { asymmetry: 1e-9, most_radii: 2048, ..LOOSE };
    let error = average(cloud(5.0), [1.333, 0.0], tight).unwrap_err();
    assert!(matches!(error, OpticsError::NotConverged { .. }));
    assert!(error.to_string().contains("stopped at 2048 radii"), "{error}");
}

#[test]
fn spheres_out_of_domain_are_refused() {
    for (radius, index) in
        [(5.0, [1.333, -1e-9]), (5.0, [1.0, 0.0]), (5.0, [f64::NAN, 0.0]), (9000.0, [1.333, 0.0])]
    {
        assert!(
            matches!(average(cloud(radius), index, LOOSE), Err(OpticsError::Domain(_))),
            "{radius} {index:?}"
        );
    }
    for (x, m, angle) in [(0.0, 1.33, 0.0), (2e5, 1.33, 0.0), (1.0, 1.33, 181.0), (1.0, f64::INFINITY, 0.0)] {
        assert!(scatter(x, [m, 0.0], &[angle]).is_err(), "{x} {m} {angle}");
    }
}

const PLAIN: &str = "number_density_per_cm3 = 300\nwavelengths_um = [0.55]\n[droplets]\ndistribution = \"modified-gamma\"\ngamma = 2\neffective_radius_um = 7\n";

#[test]
fn misspelt_and_missing_keys_are_refused() {
    toml::from_str::<OpticsConfig>(PLAIN).unwrap();
    for (from, to) in [
        ("gamma = 2", "gama = 2"),
        ("modified-gamma", "modified_gamma"),
        ("number_density_per_cm3", "number_density"),
        ("wavelengths_um = [0.55]", "wavelengths_um = [0.55]\nrefractive_index = \"hale\""),
        ("[droplets]", "[tolerance]\nassymetry = 1e-3\n[droplets]"),
    ] {
        assert!(toml::from_str::<OpticsConfig>(&PLAIN.replace(from, to)).is_err(), "{to}");
    }
    let unknown = PLAIN.replace("[0.55]", "[0.55]\nrefractive_index = \"hale\"");
    let message = toml::from_str::<OpticsConfig>(&unknown).unwrap_err().to_string();
    assert!(message.contains("hale-querry-1973") && message.contains("line 3"), "{message}");
}

#[test]
fn numbers_out_of_range_are_named() {
    for (from, to, name) in [
        ("[0.55]", "[0.55, 0.55]", "0.55 twice"),
        ("[0.55]", "[]", "wavelengths_um is empty"),
        ("[0.55]", "[3.0]", "wavelength_um (the water table's range) = 3"),
        ("300", "-1", "number_density_per_cm3 = -1"),
        ("300", "300\ntheta_f_deg = 90", "theta_f_deg = 90"),
        ("[droplets]", "[tolerance]\nasymmetry = 0\n[droplets]", "tolerance.asymmetry = 0"),
        ("gamma = 2", "gamma = nan", "gamma = NaN"),
        ("300", "300\nrefractive_index = [1.33, -0.1]", "k of m = n + ik = -0.1"),
    ] {
        let config: OpticsConfig = toml::from_str(&PLAIN.replace(from, to)).unwrap();
        let message = compute(&config).unwrap_err().to_string();
        assert!(message.contains(name), "{message}");
    }
}
