//! The files for other programs, read by those programs' documented rules, written here once more from their side.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod classic_netcdf;

use stratiform_optics::phase::{HenyeyGreenstein, Norm, PhaseFunction, PhaseTable, read_moments};
use stratiform_quantities::Asymmetry;
use stratiform_tables::colour::{SrgbPhase, srgb_phase};
use stratiform_tables::peer::{bevy, disort, eradiate, mcx, mitsuba};

const G: f64 = 0.85;

/// Henyey–Greenstein at 0.1°.
fn hg() -> PhaseTable {
    let law = HenyeyGreenstein::new(Asymmetry::new(G).unwrap());
    let theta: Vec<f64> = (0..=1800).map(|i| 0.1 * f64::from(i)).collect();
    let p = theta.iter().map(|t| law.value(1.0 - libm::cos(t.to_radians()))).collect();
    PhaseTable::new(theta, p, Norm::Strict).unwrap()
}

/// The numbers of the string called `name` in a plugin's XML.
fn strings(xml: &str, name: &str) -> Vec<f64> {
    let start = xml.find(&format!("name=\"{name}\" value=\"")).unwrap();
    let value = &xml[start..].split('"').nth(3).unwrap();
    value.split([',', ' ', '\n']).filter(|word| !word.is_empty()).map(|word| word.parse().unwrap()).collect()
}

/// Linear between nodes.
fn lookup(nodes: &[f64], values: &[f64], x: f64) -> f64 {
    let i = (1..nodes.len() - 1).find(|i| nodes[*i] >= x).unwrap_or(nodes.len() - 1);
    values[i - 1] + (x - nodes[i - 1]) / (nodes[i] - nodes[i - 1]) * (values[i] - values[i - 1])
}

fn equidistant(count: usize) -> Vec<f64> {
    (0..count).map(|i| 2.0 * i as f64 / (count - 1) as f64 - 1.0).collect()
}

fn trapezoid(x: &[f64], y: &[f64]) -> f64 {
    (1..x.len()).map(|i| 0.5 * (x[i] - x[i - 1]) * (y[i] + y[i - 1])).sum()
}

/// The largest relative error of `p(μ)` over 0, 5, … 180°.
fn disagreement(table: &PhaseTable, p: impl Fn(f64) -> f64) -> f64 {
    (0..=36).map(|k| error_at(table, f64::from(5 * k), &p)).fold(0.0, f64::max)
}

fn error_at(table: &PhaseTable, degrees: f64, p: impl Fn(f64) -> f64) -> f64 {
    let theta = degrees.to_radians();
    (p(libm::cos(theta)) / table.at(theta) - 1.0).abs()
}

#[test]
fn mitsuba_reads_the_table_and_a_flip_or_two_percent_are_seen() {
    let table = hg();
    let file = mitsuba::tabphase(&table, 4097).unwrap();
    let values = strings(&file.content, "values");
    let nodes = equidistant(4097);
    assert_eq!(values.len(), 4097);
    assert!((trapezoid(&nodes, &values) - 2.0).abs() < 1e-6);
    let error = disagreement(&table, |mu| lookup(&nodes, &values, mu));
    assert!(error < 1.01 * file.cards[0].largest_error + 1e-6 && error < 1e-3, "{error} {:?}", file.cards);
    let flipped = disagreement(&table, |mu| lookup(&nodes, &values, -mu));
    assert!(flipped > 100.0, "a flipped sign: {flipped}");
    let scaled = disagreement(&table, |mu| 1.02 * lookup(&nodes, &values, mu));
    assert!(scaled > 0.015, "two percent too much: {scaled}");
}

#[test]
fn what_a_program_reconstructs_is_what_the_writer_says() {
    let table = hg();
    for count in [3, 33, 257] {
        let file = mitsuba::tabphase(&table, count).unwrap();
        let (nodes, values) = (equidistant(count), strings(&file.content, "values"));
        let card = file.cards[0];
        let integral = 0.5 * trapezoid(&nodes, &values);
        assert!((integral - card.integral).abs() < 1e-6 && (integral - 1.0).abs() < 1e-6);
        assert!((values[count - 1] / table.at(0.0) - 1.0 - card.peak_error.unwrap()).abs() < 1e-6);
        // Simpson's rule is exact for the cubic μp.
        let cell = |i: usize| {
            let [a, b, p, q] = [nodes[i - 1], nodes[i], values[i - 1], values[i]];
            (b - a) / 6.0 * (a * p + (a + b) * (p + q) + b * q)
        };
        let g: f64 = (1..count).map(|i| 0.5 * cell(i)).sum();
        assert!((g - card.asymmetry).abs() < 1e-6, "{count}: {g} {card:?}");
    }
}

#[test]
fn the_number_of_values_for_an_error_is_the_least_power_of_two() {
    let table = hg();
    let count = mitsuba::values_for(&table, 0.01).unwrap();
    let error = |count| mitsuba::tabphase(&table, count).unwrap().cards[0].largest_error;
    assert!(error(count) <= 0.01 && error(count.div_ceil(2)) > 0.01, "{count}");
    assert!(mitsuba::values_for(&table, -1.0).is_err() && mitsuba::values_for(&table, f64::NAN).is_err());
    assert!(mitsuba::tabphase(&table, 1).is_err());
}

#[test]
fn the_irregular_form_ascends_in_f32_and_keeps_a_jump() {
    for table in [hg(), hg().modified(5.0).unwrap()] {
        let file = mitsuba::tabphase_irregular(&table);
        let (nodes, values) = (strings(&file.content, "nodes"), strings(&file.content, "values"));
        assert!(nodes.windows(2).all(|pair| (pair[0] as f32) < (pair[1] as f32)));
        assert_eq!((nodes[0], nodes[nodes.len() - 1]), (-1.0, 1.0));
        assert!((trapezoid(&nodes, &values) - 2.0).abs() < 1e-6);
        for degrees in [5.001, 5.1, 6.0, 9.99, 45.0, 90.05, 150.0, 179.97, 180.0] {
            let error = error_at(&table, degrees, |mu| lookup(&nodes, &values, mu));
            assert!(error < 1e-4, "{degrees}: {error}");
        }
    }
    let modified = hg().modified(5.0).unwrap();
    let file = mitsuba::tabphase_irregular(&modified);
    let (nodes, values) = (strings(&file.content, "nodes"), strings(&file.content, "values"));
    for (degrees, expected) in [(4.99, 0.0), (5.01, modified.at(5.01_f64.to_radians()))] {
        let p = lookup(&nodes, &values, libm::cos(f64::to_radians(degrees)));
        assert!((p - expected).abs() < 1e-3 * modified.at(0.1), "{degrees}: {p} {expected}");
    }
}

/// MCX: ξ(n+1) picks two neighbours of -1, the values, 1.
fn mcx_lookup(json: &str) -> impl Fn(f64) -> f64 {
    let document: serde_json::Value = serde_json::from_str(json).unwrap();
    let list = document["Domain"]["InverseCDF"].as_array().unwrap().clone();
    let read: Vec<f64> = list.iter().map(|value| value.as_f64().unwrap()).collect();
    assert_eq!(read.len() % 2, 0);
    let padded: Vec<f64> = [vec![-1.0], read, vec![1.0]].concat();
    move |xi| {
        let place = xi * (padded.len() - 1) as f64;
        let i = (place as usize).min(padded.len() - 2);
        let t = place - i as f64;
        (1.0 - t) * padded[i] + t * padded[i + 1]
    }
}

#[test]
fn mcx_draws_the_tables_law_and_a_flip_is_seen() {
    let table = hg();
    let file = mcx::inverse_cdf(&table, 1000).unwrap();
    let draw = mcx_lookup(&file.content);
    let distance = |sign: f64| {
        let of = |k: i32| {
            let xi = f64::from(k) / 1001.0;
            // P(cosΘ' ≤ μ) = P(Θ' ≥ Θ).
            let theta = libm::acos((sign * draw(xi)).clamp(-1.0, 1.0));
            (1.0 - table.cumulative_at(theta) - xi).abs()
        };
        (0..=1001).map(of).fold(0.0, f64::max)
    };
    assert!(distance(1.0) < 1e-5, "{}", distance(1.0));
    assert!(distance(-1.0) > 0.5, "{}", distance(-1.0));
    let mean = (0..100_100).map(|k| draw((f64::from(k) + 0.5) / 100_100.0)).sum::<f64>() / 100_100.0;
    assert!((mean - file.cards[0].asymmetry).abs() < 1e-6 && (mean - table.asymmetry()).abs() < 1e-3);
}

#[test]
fn mcx_is_refused_what_it_would_misread() {
    let message = |count| mcx::inverse_cdf(&hg(), count).unwrap_err().to_string();
    assert_eq!(message(255), "values of InverseCDF modulo 2 = 1 is outside [0, 0]");
    assert_eq!(message(0), "values of InverseCDF = 0 is outside [2, 8192]");
    let law = HenyeyGreenstein::new(Asymmetry::new(0.9999).unwrap());
    let theta: Vec<f64> = (0..=4000).map(|i| 180.0 * libm::pow(f64::from(i) / 4000.0, 4.0)).collect();
    let p = theta.iter().map(|t| {
        let sine = libm::sin(0.5 * t.to_radians());
        law.value(2.0 * sine * sine)
    });
    let peaked = PhaseTable::new(theta.clone(), p.collect(), Norm::Any).unwrap();
    assert!(
        mcx::inverse_cdf(&peaked, 8000).unwrap_err().to_string().starts_with("step of InverseCDF in f32")
    );
}

/// χ_l = g^l (Henyey & Greenstein 1941); with the factor 2l+1 the first would be off by three.
#[test]
fn disort_gets_moments_without_the_factor() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pmom.txt");
    let file = disort::pmom(&hg(), 128).unwrap();
    std::fs::write(&path, &file.content).unwrap();
    let chi = read_moments(&path).unwrap();
    assert_eq!(chi.len(), 128);
    for (l, chi) in chi.iter().enumerate() {
        assert!((chi - libm::pow(G, l as f64)).abs() < 1e-4, "{l}: {chi}");
    }
    assert!((3.0 * chi[1] - G).abs() > 1.0, "the factor is seen");
    assert!(file.cards[0].asymmetry_error.abs() < 1e-12 && file.cards[0].largest_error < 1e-3);
    // Six moments cannot hold the peak: Σ(2l+1)g^l.
    let few = disort::pmom(&hg(), 6).unwrap().cards[0];
    let peak: f64 = (0..6).map(|l| f64::from(2 * l + 1) * libm::pow(G, f64::from(l))).sum();
    assert!((few.peak_error.unwrap() - (peak / hg().at(0.0) - 1.0)).abs() < 1e-3, "{few:?}");
}

fn grey() -> SrgbPhase {
    srgb_phase(&[0.45, 0.55, 0.65].map(|w| (w, hg()))).unwrap()
}

/// Bevy: columns at equal steps of μ, forward last, per steradian.
#[test]
fn bevys_texture_is_per_steradian_with_forward_last() {
    let (table, file) = (hg(), bevy::chromatic_texture(&grey(), 4097, 256).unwrap());
    let texels = &file.content;
    let nodes = equidistant(texels.len());
    for channel in 0..3 {
        let values: Vec<f64> = texels.iter().map(|texel| f64::from(texel[channel])).collect();
        let turn = 2.0 * std::f64::consts::PI;
        assert!((turn * trapezoid(&nodes, &values) - 1.0).abs() < 1e-6);
        let error = disagreement(&table, |mu| 2.0 * turn * lookup(&nodes, &values, mu));
        assert!(error < 1e-3, "{error}");
        assert!(disagreement(&table, |mu| 2.0 * turn * lookup(&nodes, &values, -mu)) > 100.0);
    }
    assert!(texels.iter().all(|texel| texel[3] == 1.0));
}

/// Bevy's medium: the curve at 256 texels' centres, fetched with a linear, clamping sampler.
#[test]
fn bevys_own_table_is_what_is_reported() {
    let (table, resolution) = (hg(), 256);
    let file = bevy::chromatic_texture(&grey(), 8192, resolution).unwrap();
    let nodes = equidistant(8192);
    let curve: Vec<f64> =
        file.content.iter().map(|texel| 4.0 * std::f64::consts::PI * f64::from(texel[0])).collect();
    let texels: Vec<f64> = (0..resolution)
        .map(|j| {
            let s = 2.0 * (j as f64 + 0.5) / resolution as f64 - 1.0;
            lookup(&nodes, &curve, s.signum() * (1.0 - libm::pow(1.0 - s.abs(), 2.0)))
        })
        .collect();
    let fetch = |mu: f64| {
        let v = 0.5 + 0.5 * mu.signum() * (1.0 - libm::pow(1.0 - mu.abs(), 0.5));
        let place = (v * resolution as f64 - 0.5).clamp(0.0, resolution as f64 - 1.0);
        let j = (place as usize).min(resolution - 2);
        texels[j] + (place - j as f64) * (texels[j + 1] - texels[j])
    };
    let card = file.cards[0];
    assert!((fetch(1.0) / table.at(0.0) - 1.0 - card.peak_error.unwrap()).abs() < 1e-6, "{card:?}");
    assert!(disagreement(&table, fetch) < card.largest_error + 1e-6);
    let mu = equidistant(2_000_001);
    let p: Vec<f64> = mu.iter().map(|mu| fetch(*mu)).collect();
    let moment: Vec<f64> = mu.iter().zip(&p).map(|(mu, p)| mu * p).collect();
    assert!((0.5 * trapezoid(&mu, &p) - card.integral).abs() < 1e-7, "{card:?}");
    assert!((0.5 * trapezoid(&mu, &moment) - card.asymmetry).abs() < 1e-7, "{card:?}");
}

#[test]
fn bevy_is_refused_negative_channels_and_too_many_columns() {
    let mut colour = grey();
    colour.rgb[7][2] = -1e-9;
    let message = bevy::chromatic_texture(&colour, 512, 256).unwrap_err().to_string();
    assert!(
        message.starts_with("channel of linear sRGB at 0.7") && message.contains("= -0.000000001 is"),
        "{message}"
    );
    assert!(bevy::chromatic_texture(&grey(), 8193, 256).is_err());
    let mut colour = grey();
    colour.rgb.iter_mut().for_each(|rgb| rgb[0] *= 1.02);
    assert!(bevy::chromatic_texture(&colour, 512, 256).unwrap_err().to_string().contains("norm is 1.0"));
}

fn wavelength(wavelength_um: f64, phase: &PhaseTable) -> eradiate::Wavelength<'_> {
    eradiate::Wavelength { wavelength_um, extinction_per_m: 0.0471, single_scattering_albedo: 0.999, phase }
}

#[test]
fn eradiates_data_set_has_its_layout_and_norm() {
    let (table, modified) = (hg(), hg().modified(5.0).unwrap());
    let file =
        eradiate::particle_properties(&[wavelength(0.45, &table), wavelength(0.55, &modified)], 64).unwrap();
    let data = classic_netcdf::read(&file.content);
    let angles = data.dimensions["iangle"];
    assert_eq!((data.dimensions["w"], data.dimensions["phamat"], data.dimensions["imom"]), (2, 1, 64));
    assert_eq!(data.variables["phase"].dimensions, ["phamat", "w", "iangle"]);
    assert_eq!(data.variables["mu"].dimensions, ["w", "iangle"]);
    assert_eq!(data.variables["w"].values, [450.0, 550.0]);
    assert_eq!(data.variables["w"].attributes["units"], "nm");
    assert_eq!(data.variables["ext"].values, [0.0471; 2]);
    assert_eq!(data.variables["ext"].attributes["units"], "m^-1");
    for (row, table) in [&table, &modified].into_iter().enumerate() {
        let count = data.variables["nangles"].values[row] as usize;
        let of = |name: &str| data.variables[name].values[row * angles..(row + 1) * angles].to_vec();
        let (mu, phase, theta) = (of("mu"), of("phase"), of("theta"));
        assert!(mu[count..].iter().chain(&phase[count..]).all(|pad| pad.is_nan()));
        assert!((trapezoid(&mu[..count], &phase[..count]) - 2.0).abs() < 1e-9);
        assert!((0.98 * trapezoid(&mu[..count], &phase[..count]) - 2.0).abs() > 0.03, "two percent are seen");
        let back = table.at(theta[0].to_radians());
        assert!((theta[0] - 180.0).abs() < 1e-9 && (phase[0] / back - 1.0).abs() < 2e-4, "back comes first");
        let pmom = &data.variables["pmom"].values[row * 64..(row + 1) * 64];
        assert!((pmom[0] - 1.0).abs() < 1e-15 && (pmom[1] - 3.0 * table.asymmetry()).abs() < 1e-9);
    }
}

#[test]
fn eradiate_is_refused_what_it_would_misread() {
    let table = hg();
    let message = |spectrum: &[eradiate::Wavelength<'_>]| {
        eradiate::particle_properties(spectrum, 64).unwrap_err().to_string()
    };
    assert_eq!(message(&[]), "wavelengths of the data set = 0 is outside [1, infinity)");
    let descending = message(&[wavelength(0.55, &table), wavelength(0.45, &table)]);
    assert_eq!(descending, "wavelength_um (ascending) = 0.45 is outside (0.55, infinity)");
    let bright = eradiate::Wavelength { single_scattering_albedo: 1.5, ..wavelength(0.55, &table) };
    assert_eq!(message(&[bright]), "single_scattering_albedo = 1.5 is outside [0, 1]");
}
