//! A cloud's files for each program.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod containers_common;

use containers_common::{cloud, henyey_greenstein, set};
use std::sync::OnceLock;
use stratiform_tables::peer::Program;
use stratiform_tables::set::PhaseSet;

/// Smooth functions at 0.65, 0.55 and 0.5325 µm.
fn three() -> &'static PhaseSet {
    static SET: OnceLock<PhaseSet> = OnceLock::new();
    SET.get_or_init(|| set(vec![henyey_greenstein(0.85), henyey_greenstein(0.84), henyey_greenstein(0.83)]))
}

#[test]
fn every_program_gets_its_files_and_every_function_its_card() {
    let expected = [
        (
            Program::MitsubaIrregular,
            vec!["phase.650nm.irregular.xml", "phase.550nm.irregular.xml", "phase.532,5nm.irregular.xml"],
        ),
        (Program::Mcx, vec!["phase.650nm.mcx.json", "phase.550nm.mcx.json", "phase.532,5nm.mcx.json"]),
        (Program::Disort, vec!["phase.650nm.pmom.txt", "phase.550nm.pmom.txt", "phase.532,5nm.pmom.txt"]),
        (Program::Eradiate, vec!["particles.nc"]),
        (Program::Bevy, vec!["phase.bevy.ktx2"]),
    ];
    for (program, names) in expected {
        let files = program.files(three()).unwrap();
        assert_eq!(files.iter().map(|file| file.name.as_str()).collect::<Vec<_>>(), names);
        let cards: Vec<_> = files.iter().flat_map(|file| &file.cards).collect();
        assert_eq!(cards.len(), 3, "{program:?}");
        for named in cards {
            assert!((named.card.integral - 1.0).abs() < 1e-4, "{program:?} {named:?}");
            assert!(named.card.asymmetry_error.abs() < 1e-4, "{program:?} {named:?}");
        }
    }
}

/// Measured for the paper's cloud: what each form is worth at the peak and at the glory.
#[test]
fn the_papers_cloud_is_represented_as_well_as_the_docs_say() {
    let set = set(vec![cloud()]);
    let card = |program: Program| program.files(&set).unwrap()[0].cards[0].card;
    for (program, peak, glory) in [
        (Program::Mitsuba, 0.01, 0.015),
        (Program::MitsubaIrregular, 1e-4, 5e-4),
        (Program::Eradiate, 1e-4, 5e-4),
        (Program::Mcx, 0.01, 0.6),
        (Program::Disort, 1e-3, 1e-3),
    ] {
        let card = card(program);
        assert!(card.peak_error.unwrap().abs() < peak && card.glory_error < glory, "{program:?} {card:?}");
    }
}

/// Bevy takes the image as one-dimensional only if it has one row.
#[test]
fn bevys_image_is_one_row_of_rgba32f_with_forward_last() {
    let file = &Program::Bevy.files(three()).unwrap()[0];
    let reader = ktx2::Reader::new(&file.bytes).unwrap();
    let header = reader.header();
    assert_eq!(header.format, Some(ktx2::Format::R32G32B32A32_SFLOAT));
    assert_eq!((header.pixel_width, header.pixel_height, header.pixel_depth), (8192, 1, 0));
    assert_eq!((header.layer_count, header.face_count, header.level_count), (0, 1, 1));
    let level = reader.levels().next().unwrap().data;
    let number = |at: usize| f32::from_le_bytes(level[at..at + 4].try_into().unwrap());
    let texel = |x: usize| [0, 4, 8, 12].map(|c| number(16 * x + c));
    assert_eq!(level.len(), 16 * 8192);
    assert!(texel(8191)[0] > 100.0 * texel(0)[0] && texel(0)[3] == 1.0);
    let sum: f64 = (0..8192).map(|x| f64::from(texel(x)[1]) * if x % 8191 == 0 { 0.5 } else { 1.0 }).sum();
    assert!((sum * 2.0 / 8191.0 * 2.0 * std::f64::consts::PI - 1.0).abs() < 1e-5, "{sum}");
}

#[test]
fn two_wavelengths_are_no_colour() {
    let two = set(vec![henyey_greenstein(0.85), henyey_greenstein(0.8)]);
    let message = Program::Bevy.files(&two).unwrap_err().to_string();
    assert_eq!(message, "wavelengths of a colour = 2 is outside [3, infinity)");
}
