use super::*;

fn gamma_cloud() -> SizeDistribution {
    DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um: 7.0 }.resolve().unwrap()
}

fn lognormal_cloud() -> SizeDistribution {
    let law = DropletDistribution::Lognormal {
        effective_radius_um: Some(10.0),
        median_radius_um: None,
        sigma: None,
        effective_variance: Some(0.1),
    };
    law.resolve().unwrap()
}

/// ∫r^k n dr by the midpoint rule over `range`.
fn integral(law: &SizeDistribution, k: u32, range: [f64; 2]) -> f64 {
    let steps = 200_000;
    let h = (range[1] - range[0]) / f64::from(steps);
    (0..steps).fold(0.0, |sum, i| {
        let r = range[0] + h * (f64::from(i) + 0.5);
        sum + h * (0..k).fold(law.density(r), |power, _| power * r)
    })
}

#[test]
fn closed_moments_are_the_integrals_of_the_density() {
    for law in [gamma_cloud(), lognormal_cloud()] {
        for k in 0..=4 {
            let ratio = integral(&law, k, [1e-9, 200.0]) / law.moment(k);
            assert!((ratio - 1.0).abs() < 1e-7, "{} moment {k}: {ratio}", law.words());
        }
    }
}

/// Bouthors, Neyret & Lefebvre 2006: r_e = (γ+2)r_n, v_e = 1/(γ+2).
#[test]
fn effective_radius_and_variance_are_those_asked_for() {
    let law = gamma_cloud();
    assert!((law.effective_radius() - 7.0).abs() < 1e-12);
    assert!((law.effective_variance() - 0.25).abs() < 1e-12);
    let law = lognormal_cloud();
    assert!((law.effective_radius() - 10.0).abs() < 1e-11);
    assert!((law.effective_variance() - 0.1).abs() < 1e-11);
}

/// Deirmendjian's C1, r^6 e^{-1.5r}: mode 4 µm, r_e = 9/1.5 = 6 µm.
#[test]
fn the_generalised_gamma_is_deirmendjians() {
    let law = DropletDistribution::GeneralisedGamma { alpha: 6.0, b: 1.5, c: 1.0 }.resolve().unwrap();
    assert!((law.effective_radius() - 6.0).abs() < 1e-12);
    assert!(law.density(4.0) > law.density(3.99) && law.density(4.0) > law.density(4.01));
}

#[test]
fn the_range_leaves_out_what_it_says() {
    let law = gamma_cloud();
    let [low, high] = law.scattering_range();
    let below = integral(&law, 2, [1e-9, low]) / law.moment(2);
    let above = integral(&law, 4, [high, 20.0 * high]) / law.moment(4);
    assert!(below < 1.1e-6 && below > 1e-7, "{below}");
    assert!(above < 1.1e-5 && above > 1e-6, "{above}");
}

#[test]
fn a_table_is_linear_between_its_rows() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("sizes.csv");
    std::fs::write(&file, "radius_um,number\n1,0\n2,6\n3,0\n").unwrap();
    let law = DropletDistribution::Tabulated { file }.resolve().unwrap();
    assert!((law.density(1.5) - 0.5).abs() < 1e-15 && law.density(3.5) == 0.0);
    // The triangle's ⟨r²⟩ = 4 + 1/6, ⟨r³⟩ = 8 + 1.
    assert!((law.moment(2) - 25.0 / 6.0).abs() < 1e-13 && (law.moment(3) - 9.0).abs() < 1e-13);
}

#[test]
fn bad_tables_are_refused_with_their_line() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("sizes.csv");
    for (text, place) in [
        ("radius_um,number\n1,1\n1,2\n", ":3: radius_um = 1 does not increase"),
        ("radius_um,number\n1,-1\n2,2\n", ":2: number = -1"),
        ("radius_um,number\n1,NaN\n2,2\n", ":2: number = NaN"),
        ("radius_um,number\n1,0\n2,0\n", "integrate to 0"),
        ("radius_um,number\n", "no rows"),
        ("radius_um,count\n1,1\n", "count"),
    ] {
        std::fs::write(&file, text).unwrap();
        let error = DropletDistribution::Tabulated { file: file.clone() }.resolve().unwrap_err().to_string();
        assert!(error.contains(place), "{error}");
    }
}

#[test]
fn numbers_out_of_domain_are_refused() {
    let refused = [
        DropletDistribution::ModifiedGamma { gamma: 0.0, effective_radius_um: 7.0 },
        DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um: f64::NAN },
        DropletDistribution::SingleSize { radius_um: -1.0 },
        DropletDistribution::GeneralisedGamma { alpha: 6.0, b: 0.0, c: 1.0 },
        DropletDistribution::Lognormal {
            effective_radius_um: Some(1.0),
            median_radius_um: Some(1.0),
            sigma: Some(0.3),
            effective_variance: None,
        },
    ];
    for law in refused {
        assert!(law.resolve().is_err(), "{law:?}");
    }
}

#[test]
fn a_law_keeps_its_width_at_another_effective_radius() {
    let laws = [
        DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um: 7.0 },
        DropletDistribution::GeneralisedGamma { alpha: 6.0, b: 1.5, c: 1.2 },
        DropletDistribution::Lognormal {
            effective_radius_um: None,
            median_radius_um: Some(5.0),
            sigma: Some(0.3),
            effective_variance: None,
        },
        DropletDistribution::SingleSize { radius_um: 3.0 },
    ];
    for law in laws {
        let width = law.resolve().unwrap().effective_variance();
        let other = law.at_effective_radius(12.0).unwrap().resolve().unwrap();
        assert!((other.effective_radius() / 12.0 - 1.0).abs() < 1e-12, "{other:?}");
        assert!((other.effective_variance() - width).abs() < 1e-12, "{other:?}");
        assert!(law.at_effective_radius(f64::NAN).is_err() && law.at_effective_radius(0.0).is_err());
    }
}
