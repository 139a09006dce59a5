//! Files of other programs, and files that are none.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::f64::consts::PI;
use std::fmt::Write;
use stratiform_optics::phase::{HenyeyGreenstein, PhaseFunction};
use stratiform_quantities::Asymmetry;
use stratiform_tables::read::{AngleUnit, Choice, Layout, Normalisation, RawTable, Understanding, read};

/// Henyey–Greenstein, g = 0.6, at whole degrees.
fn p(degrees: u32) -> f64 {
    let phase = HenyeyGreenstein::new(Asymmetry::new(0.6).unwrap());
    phase.value(1.0 - libm::cos(f64::from(degrees).to_radians()))
}

/// The same at any angle, radians.
fn p_at(theta: f64) -> f64 {
    HenyeyGreenstein::new(Asymmetry::new(0.6).unwrap()).value(1.0 - libm::cos(theta))
}

fn read_with(text: &[u8], choice: &Choice) -> Result<RawTable, String> {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("table.txt");
    std::fs::write(&path, text).unwrap();
    read(&path, choice).map_err(|error| error.to_string().replace(&path.display().to_string(), "FILE"))
}

fn read_text(text: &str) -> Result<RawTable, String> {
    read_with(text.as_bytes(), &Choice::default())
}

/// One line per whole degree.
fn lines(head: &str, line: impl Fn(u32) -> String) -> String {
    (0..=180).fold(head.to_owned(), |mut text, degrees| {
        let _ = writeln!(text, "{}", line(degrees));
        text
    })
}

fn understood(text: &str) -> Understanding {
    Understanding::of(&read_text(text).unwrap(), None).unwrap()
}

fn assert_is_the_table(table: &RawTable) {
    assert_eq!(table.value.len(), 181);
    for (i, (theta, value)) in table.theta_deg.iter().zip(&table.value).enumerate() {
        assert!((theta - i as f64).abs() < 1e-4, "{theta} {i}");
        assert!((value / p(i as u32) - 1.0).abs() < 1e-3, "{i}: {value}");
    }
}

#[test]
fn separators_headers_and_comments_do_not_matter() {
    let texts = [
        lines("theta_deg,p\n", |d| format!("{d},{}", p(d))),
        lines("", |d| format!("{d};{}", p(d))),
        lines("theta_deg;p\n", |d| format!("{d};{}", p(d)).replace('.', ",")),
        lines("theta_deg;p\r\n", |d| format!("{d};{}\r", p(d))),
        lines("# a comment\n# theta  p11\n\n", |d| format!("  {d}\t{:e}", p(d))),
        lines("\u{feff}Angle (deg)\tP11\tP12\n", |d| format!("{d}\t{}\t0.1", p(d))),
        lines("! from Fortran\n", |d| format!("{d}.  {:.6}", p(d)).replace('E', "D")) + "! end\n",
        lines("", |d| format!("{} {}", 180 - d, p(180 - d))),
    ];
    for text in &texts {
        assert_is_the_table(&read_text(text).unwrap());
    }
    assert_eq!(read_text(&texts[5]).unwrap().left_out, ["P12"]);
}

/// SHDOM's plotscattab: comments with `!`, the cosine beside the angle, one column per effective radius.
#[test]
fn plotscattab_columns_are_told_by_number() {
    let head = "!  Scattering table phase functions: water_w164c.scat\n! Angle cos(angle)  Phase functions for effective radii (um)\n!                      5.00       10.00\n";
    let text = lines(head, |d| {
        let cosine = libm::cos(f64::from(d).to_radians());
        format!("{:9.2} {cosine:9.6} {:11.4E} {:11.4E}", f64::from(d), 2.0 * p(d), p(d))
    });
    assert!(
        (read_text(&text).unwrap().value[0] / p(0) - 2.0).abs() < 1e-3,
        "the first of several without names"
    );
    let choice = Choice { column: Some("4".to_owned()), ..Choice::default() };
    let table = read_with(text.as_bytes(), &choice).unwrap();
    assert_is_the_table(&table);
    assert_eq!(table.unit, AngleUnit::Degrees);
}

/// MiePlot: free lines, `Angle`, angle, wavelength, perpendicular and parallel intensity for every wavelength, asterisks.
#[test]
fn mieplot_is_the_mean_of_both_polarisations() {
    let head = "MiePlot v4.6\nRefractive index of sphere = water\nRadius 10 um\n\nAngle\tWavelength\tPerpendicular\tParallel\n";
    let text = lines(head, |d| {
        let row = |wavelength: f64, scale: f64| {
            format!("{d}\t{wavelength}\t{:e}\t{:e}", 1.5e4 * scale * p(d), 0.5e4 * scale * p(d))
        };
        format!("{}\n{}", row(0.65, 2.0), row(0.55, 1.0))
    }) + "******\nQsca 2.1\n";
    assert!(read_text(&text).unwrap_err().contains("several wavelengths (0.55, 0.65)"));
    // As MiePlot writes it: Latin-1, units in the header.
    let latin = text.replace("10 um", "10 \u{b5}m").replace("Wavelength", "Wavelength (\u{b5}m)");
    let latin: Vec<u8> = latin.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    let more = text.replace("Perpendicular", "Perpendicular\tDebye");
    assert!(
        read_text(&more.replace("\tParallel", "")).unwrap_err().contains("FILE:6: 4 columns are not those")
    );
    let choice = Choice { wavelength: Some(0.55), ..Choice::default() };
    let table = read_with(&latin, &choice).unwrap();
    assert_eq!(table, read_with(text.as_bytes(), &choice).unwrap());
    assert_eq!((table.layout, table.value.len()), (Layout::MiePlot, 181));
    let understanding = Understanding::of(&table, None).unwrap();
    assert_eq!(understanding.normalisation, Normalisation::Unnormalised);
    assert!((understanding.integral / 1e4 - 1.0).abs() < 1e-3, "{}", understanding.integral);
    assert!(table.table().is_err() && (table.repaired().unwrap().asymmetry() - 0.6).abs() < 1e-4);
}

/// Coefficients (2l+1)χ_l as make_mie_table (several lines) and libRadtran's mie (one line per element) write them: those of
/// a Henyey–Greenstein function are (2l+1)g^l.
#[test]
fn legendre_listings_are_summed() {
    let coefficients = |g: f64| -> Vec<String> {
        (0..=40).map(|l| format!(" {:9.5}", f64::from(2 * l + 1) * libm::pow(g, f64::from(l)))).collect()
    };
    let head = "! Mie scattering table vs. effective radius (LWC=1 g/m^3)\n 0.550 0.550  wavelength range (micron)\n";
    let block = |radius: f64, rest: &str, g: f64| {
        let all = coefficients(g);
        format!(
            "{radius:9.4} 1.52E+02 0.999990     40{rest}\n  {}\n  {}\n",
            all[..21].concat(),
            all[21..].concat()
        )
    };
    let shdom = format!(
        "{head}{}{}",
        block(5.0, "  Reff  Ext  Alb  Nleg", 0.3),
        block(10.0, "  Reff  Ext  Alb  Nleg", 0.6)
    );
    let error = read_text(&shdom).unwrap_err();
    assert_eq!(error, "FILE: several effective radii (5, 10): one of them must be named");
    let choice = Choice { effective_radius: Some(10.0), ..Choice::default() };
    let table = read_with(shdom.as_bytes(), &choice).unwrap();
    assert_eq!(table.layout, Layout::Legendre);
    let found = table.table().unwrap();
    assert!((found.asymmetry() - 0.6).abs() < 1e-5 && (found.at(1.0) / p_at(1.0) - 1.0).abs() < 1e-3);
    let libradtran = format!("{head}{}  0.1 0.2\n", block(10.0, "     4 Reff  Ext  Alb  Nleg Nphamat", 0.6));
    assert_eq!(read_text(&libradtran).unwrap().value, table.value);
    let cut = shdom.lines().take(4).collect::<Vec<_>>().join("\n");
    assert_eq!(read_text(&cut).unwrap_err(), "FILE:3: 21 coefficients follow, not 41");
    let word = libradtran.replacen("1.00000", "one", 1);
    assert_eq!(read_text(&word).unwrap_err(), "FILE:4: `one` is not a number");
}

#[test]
fn units_are_told_by_the_range() {
    let radians = lines("", |d| format!("{:.5} {}", f64::from(d).to_radians(), p(d)));
    let cosines = lines("", |d| format!("{:.9} {}", libm::cos(f64::from(d).to_radians()), p(d)));
    assert_eq!(read_text(&radians).unwrap().unit, AngleUnit::Radians);
    let cosines = read_text(&cosines).unwrap();
    assert_eq!(cosines.unit, AngleUnit::Cosine);
    assert_is_the_table(&cosines);
    let mislabelled = lines("theta_deg p\n", |d| format!("{} {}", f64::from(d).to_radians(), p(d)));
    assert!(understood(&mislabelled).unusual().unwrap().contains("says degrees, the range says radians"));
    assert!(read_text(&mislabelled).unwrap().table().is_err());
    let both =
        lines("theta,cos_theta,p\n", |d| format!("{d},{},{}", libm::cos(f64::from(d).to_radians()), p(d)));
    assert!(understood(&both).unusual().is_none(), "the cosine's name is not the angle's");
}

#[test]
fn conventions_are_told_by_the_integral() {
    let scaled = |factor: f64| lines("", |d| format!("{d} {}", factor * p(d)));
    let expected = [
        (1.0, Normalisation::MeanOne),
        (0.25 / PI, Normalisation::PerSteradian),
        (0.5, Normalisation::PerCosine),
        (4.0 * PI, Normalisation::FourPi),
        (2.0 * PI, Normalisation::TwoPi),
        (0.5 / PI, Normalisation::PerTwoPi),
        (1.0 / p(0), Normalisation::ForwardOne),
        (3e5, Normalisation::Unnormalised),
        (0.01, Normalisation::Unnormalised),
        // Just within, and just beyond, 15 % of a convention.
        (1.14, Normalisation::MeanOne),
        (1.16, Normalisation::Unnormalised),
    ];
    for (factor, normalisation) in expected {
        let found = understood(&scaled(factor));
        assert_eq!(found.normalisation, normalisation, "{factor}");
        assert_eq!(found.unusual().is_none(), normalisation == Normalisation::MeanOne);
    }
    assert!(read_text(&scaled(1.0)).unwrap().table().is_ok());
    assert!(
        read_text(&scaled(1.01)).unwrap().table().is_err(),
        "1 % is no convention, and no phase function either"
    );
}

#[test]
fn a_flipped_sign_is_named_and_repaired_only_on_request() {
    let flipped = read_text(&lines("", |d| format!("{d} {}", p(180 - d)))).unwrap();
    let words = Understanding::of(&flipped, None).unwrap().unusual().unwrap();
    assert!(words.contains("angle sign flipped"), "{words}");
    assert!(flipped.table().unwrap_err().to_string().contains("angle sign flipped"));
    assert!((flipped.repaired().unwrap().asymmetry() - 0.6).abs() < 1e-3);
}

#[test]
fn what_is_no_table_is_refused_with_its_line() {
    let replaced = |line: usize, by: &str| {
        let text = lines("theta_deg,p\n", |d| format!("{d},{}", p(d)));
        let all: Vec<&str> =
            text.lines().enumerate().map(|(i, l)| if i + 1 == line { by } else { l }).collect();
        all.join("\n")
    };
    let cases = [
        (String::new(), "FILE: the file is empty"),
        ("0,1\n".to_owned(), "FILE: 1 rows of numbers are no phase table"),
        ("hello\nworld\n".to_owned(), "FILE: 0 rows of numbers are no phase table"),
        (replaced(12, "10,NaN"), "FILE:12: the value NaN is outside [0, infinity)"),
        (replaced(12, "10,-1"), "FILE:12: the value -1 is outside [0, infinity)"),
        (replaced(12, "inf,1"), "FILE:12: the angle inf is not finite"),
        (replaced(12, "9,1"), "FILE:12: the angle 9 stands twice"),
        (replaced(12, "8,1"), "FILE:12: the angle 8 after 9 is out of order"),
        (replaced(12, "10,x1"), "FILE:12: `x1` is not a number"),
        (replaced(12, "10,1,2"), "FILE:12: 3 columns, 2 in the rows before"),
        (replaced(182, "179.5,1"), "FILE:182: the angles run from 0 to 179.5, not over 0 to 180 degrees"),
        (replaced(2, "0.5,9"), "FILE:182: the angles run from 0.5 to 180"),
        ("1\n2\n3\n".to_owned(), "FILE:1: one column: an angle and a value are needed"),
        (
            lines("theta,r,g,b\n", |d| format!("{d},1,1,1")),
            "FILE: several columns (r, g, b): one of them must be named",
        ),
    ];
    for (text, expected) in cases {
        let error = read_text(&text).unwrap_err();
        assert!(error.starts_with(expected), "{error} / {expected}");
    }
    let binary = read_with(&[0x89, b'P', b'N', b'G', 0xff, 0xfe, 0], &Choice::default()).unwrap_err();
    assert!(binary.contains("FILE:1: not a text file"), "{binary}");
    let column = Choice { column: Some("q".to_owned()), ..Choice::default() };
    let missing = read_with(lines("theta,p\n", |d| format!("{d},1")).as_bytes(), &column).unwrap_err();
    assert_eq!(missing, "FILE: no column `q`; there are theta, p");
    let crowded = read_text("0,1\n-0.0005,1\n90,1\n180,1\n").unwrap_err();
    assert!(crowded.starts_with("FILE:"), "{crowded}");
    let crowded = read_text("-0.0005,1\n0,1\n90,1\n180,1\n").unwrap_err();
    assert_eq!(crowded, "FILE: two rows stand at 0 degrees");
}

/// What was asked for and is not there is no reason to take something else.
#[test]
fn a_choice_that_the_file_does_not_offer_is_refused() {
    let columns = lines("theta,p\n", |d| format!("{d},1"));
    let wavelengths = lines("theta,wavelength,p\n", |d| format!("{d},0.55,1"));
    let listing = "10.0 1.0 1.0 1 Nleg\n1 0.3\n".to_owned();
    let endless = format!("10.0 1.0 1.0 {} Nleg\n1\n", usize::MAX);
    let wavelength = Choice { wavelength: Some(0.5), ..Choice::default() };
    let radius = Choice { effective_radius: Some(7.0), ..Choice::default() };
    let cases = [
        (&columns, &wavelength, "FILE: no wavelength 0.5: no column is named so"),
        (&columns, &radius, "FILE: no effective radius 7: these are no Legendre coefficients"),
        (&wavelengths, &wavelength, "FILE: no wavelength 0.5; there are 0.55"),
        (&listing, &radius, "FILE: no effective radius 7; there are 10"),
        (&listing, &wavelength, "FILE: Legendre coefficients have neither columns nor wavelengths to choose"),
        (&endless, &Choice::default(), "FILE:1: Nleg = 18446744073709551615 is above 100000"),
    ];
    for (text, choice, expected) in cases {
        assert_eq!(read_with(text.as_bytes(), choice).unwrap_err(), expected);
    }
}

#[test]
fn a_huge_file_is_refused_unread() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("huge.csv");
    std::fs::File::create(&path).unwrap().set_len(65 << 20).unwrap();
    let error = read(&path, &Choice::default()).unwrap_err().to_string();
    assert!(error.contains("bytes are no phase table"), "{error}");
}

/// All zero: no integral.
#[test]
fn a_dark_table_is_no_phase_function() {
    let dark = read_text(&lines("", |d| format!("{d} 0"))).unwrap();
    assert!(Understanding::of(&dark, None).is_err() && dark.table().is_err() && dark.repaired().is_err());
}
