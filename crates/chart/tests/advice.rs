//! The adviser: its promise at points that it did not choose, and its choice.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod trial;

use std::path::Path;
use stratiform_advise::{Advice, Budget, Data, advise, candidates};
use stratiform_artifact::ErrorData;
use stratiform_methods::Cloud;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::SingleScatteringAlbedo;
use stratiform_scene::{Interval, NAMES, Scene, named};
use trial::{Effort, Sampled, random_error, random_scene, trial};

const SEED: u64 = 6_2026;

/// The paper's cloud from its committed phase function.
fn paper() -> Sampled {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    let phase = PhaseTable::read(Path::new(path), Norm::Strict).unwrap();
    let omega = SingleScatteringAlbedo::new(1.0).unwrap();
    let cloud = Cloud::new(phase, omega, 5.0, Some(7.0)).unwrap();
    Sampled::new(7.0, vec![cloud]).unwrap()
}

const FEW: Effort = Effort { suns: 2, thicknesses: 3, views: 4 };

/// Scenes of the paper's cloud, green alone: how often the promise held.
fn held(data: &Data, scenes: u64) -> u64 {
    let cloud = paper();
    let trial = |index| {
        let scene = Scene { wavelengths_um: vec![0.55], ..random_scene(SEED, index, 7.0, false) };
        trial(data, &scene, random_error(SEED, index), &cloud, SEED + index, FEW).unwrap()
    };
    (0..scenes).map(|index| u64::from(trial(index).held())).sum()
}

/// A small version of `examples/verify-advice.rs`. With a true share of 95 % fewer than 8 of 10 hold in 1 of 90 sets of scenes; the
/// seed is fixed.
#[test]
fn promises_hold_where_nobody_looked() {
    assert!(held(&Data::committed().unwrap(), 10) >= 8);
}

/// The same with a data column that claims no error: the method is advised, and most promises break.
#[test]
fn a_wrong_column_is_found() {
    let mut tables = Data::committed().unwrap().tables().clone();
    let column = ErrorData::ORDERS.len() + tables.methods.iter().position(|method| method.radiance).unwrap();
    tables.errors.rows.iter_mut().for_each(|row| row.values[column] = row.truth.map(|_| 0));
    assert!(held(&Data::new(tables).unwrap(), 5) <= 1);
}

fn answer(scene: &Scene, max_error: Option<f64>, max_ns: Option<f64>) -> Advice {
    let tau = scene.layer.optical_thickness.unwrap_or(Interval { min: 1.0, max: 30.0 });
    let budget = Budget::new(max_error, max_ns).unwrap();
    advise(&Data::committed().unwrap(), scene, tau, &budget, None).unwrap()
}

/// No listed method that promises as much is cheaper, and within a cost none promises more.
#[test]
fn the_answer_is_the_best_of_what_is_promised() {
    let data = Data::committed().unwrap();
    for name in NAMES {
        let scene = named(name).unwrap();
        let tau = scene.layer.optical_thickness.unwrap_or(Interval { min: 1.0, max: 30.0 });
        let advice = answer(&scene, Some(0.5), None);
        let ground = advice.bounce.as_ref().map_or(0.0, |bounce| bounce.ns);
        for one in candidates(&data, &scene, tau).unwrap() {
            let does = one.prediction.error <= 0.5 && one.prediction.refused == 0.0;
            assert!(!does || one.ns + ground >= advice.ns, "{name}: {}", one.method.name);
        }
        let dear = answer(&scene, None, Some(1e9));
        assert!(dear.prediction.error <= advice.prediction.error || dear.met, "{name}");
        assert_eq!(advice.rejected.len() + 1, data.methods().len(), "{name}");
        assert!(!answer(&scene, Some(1e-6), None).met, "{name}");
    }
}
