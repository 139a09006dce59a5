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
use trial::{Effort, Pool, random_error, random_scene, trial};

const SEED: u64 = 6_2026;

const FEW: Effort = Effort { suns: 4, thicknesses: 6, views: 30, effects: 2 };

/// The paper's cloud from its committed phase function.
fn paper() -> Pool {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    let phase = PhaseTable::read(Path::new(path), Norm::Strict).unwrap();
    let omega = SingleScatteringAlbedo::new(1.0).unwrap();
    let cloud = Cloud::new(phase, omega, 5.0, Some(7.0)).unwrap();
    Pool::new(7.0, vec![cloud], SEED, FEW).unwrap()
}

/// Scenes of the paper's cloud, green alone: how often the promise held.
fn held(data: &Data, pool: &Pool, scenes: u64) -> usize {
    let one = |index: &u64| {
        let scene = random_scene(SEED, *index, pool, false);
        trial(data, &scene, random_error(SEED, *index), pool).unwrap().held()
    };
    (0..scenes).filter(one).count()
}

/// A small version of `examples/verify-advice.rs`. With a true share of 95 % fewer than 16 of 20 hold in 1 of 390 sets of independent
/// scenes; the seed is fixed. The same with a data column that claims no error: that method is advised, and most promises break.
#[test]
fn promises_hold_where_nobody_looked_and_a_wrong_column_is_found() {
    let (data, pool) = (Data::committed().unwrap(), paper());
    assert!(held(&data, &pool, 20) >= 16);
    let mut tables = data.tables().clone();
    let column =
        ErrorData::ORDERS.len() + tables.methods.iter().position(|one| one.name == "octaves:1").unwrap();
    tables.errors.rows.iter_mut().for_each(|row| row.values[column] = row.truth.map(|_| 0));
    let place = column - ErrorData::ORDERS.len();
    tables.methods[place].ns = Some(0.1);
    assert!(held(&Data::new(tables).unwrap(), &pool, 20) <= 5);
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
