//! The chart as rows for files.

use crate::assess::assess_all;
use crate::cost::Effort;
use crate::front::front;
use crate::truth::SHARE;
use crate::{Assessment, ChartError, CloudSample, Sample, Watch};
use stratiform_artifact::{
    ChartCloud, ChartDocument, ChartMethod, ChartRow, ChartScene, Provenance, hash_of,
};
use stratiform_methods::{Card, Class, Method};

/// Every method against one scene, the front marked.
///
/// # Errors
/// [`ChartError`] if a cost cannot be measured, or [`ChartError::Cancelled`].
pub fn chart(
    sample: &Sample,
    methods: &[Box<dyn Method>],
    effort: Effort,
    watch: Watch<'_>,
) -> Result<Vec<ChartRow>, ChartError> {
    let mut rows = Vec::new();
    let boxed: Vec<&dyn Method> = methods.iter().map(AsRef::as_ref).collect();
    for (method, found) in methods.iter().zip(assess_all(&boxed, sample, effort, watch)?) {
        rows.extend(found.into_iter().map(|one| row(&sample.name, method.card(), one)));
    }
    mark(&mut rows);
    Ok(rows)
}

fn row(scene: &str, card: &Card, found: Assessment) -> ChartRow {
    let statistics = found.statistics;
    ChartRow {
        scene: scene.to_owned(),
        method: card.name.clone(),
        knob: card.name.split_once(':').map(|(_, knob)| knob.to_owned()),
        class: class(card.class),
        quantity: found.quantity.name().to_owned(),
        points: found.points as u64,
        excluded: found.excluded as u64,
        refused: found.refused as u64,
        not_finite: found.not_finite as u64,
        median: statistics.map(|s| s.median),
        p95: statistics.map(|s| s.p95),
        worst: statistics.map(|s| s.worst),
        bias: statistics.map(|s| s.bias),
        cost: if found.single { "f32" } else { "batch" }.to_owned(),
        ns_per_evaluation: found.ns,
        table_bytes: card.table_bytes.map(|bytes| bytes as u64),
        pareto: false,
    }
}

/// As it stands in files.
fn class(class: Class) -> String {
    serde_json::to_value(class).ok().and_then(|value| Some(value.as_str()?.to_owned())).unwrap_or_default()
}

/// Marks the front of each quantity among the methods that answer every point.
fn mark(rows: &mut [ChartRow]) {
    for quantity in ChartRow::QUANTITIES {
        let places: Vec<usize> = (0..rows.len()).filter(|i| rows[*i].quantity == quantity).collect();
        let pair = |row: &ChartRow| match (row.ns_per_evaluation, row.median) {
            (Some(ns), Some(median)) if row.refused + row.not_finite == 0 => (ns, median),
            _ => (f64::NAN, f64::NAN),
        };
        let pairs: Vec<_> = places.iter().map(|i| pair(&rows[*i])).collect();
        for (i, on_front) in places.into_iter().zip(front(&pairs)) {
            rows[i].pareto = on_front;
        }
    }
}

const METHOD: &str = "relative error against discrete ordinates on the full medium; cost on one thread, in f32 where the method is \
                      shader code";

/// What the chart was made of.
pub fn document(samples: &[Sample], methods: &[Box<dyn Method>], quick: bool) -> ChartDocument {
    let scenes: Vec<ChartScene> = samples.iter().map(scene).collect();
    let methods: Vec<ChartMethod> = methods.iter().map(|method| described(method.card())).collect();
    let hash = hash_of(&("stratiform/chart", quick, SHARE, &scenes, &methods));
    ChartDocument {
        schema: ChartDocument::SCHEMA.to_owned(),
        provenance: Provenance::new(hash, None, METHOD),
        quick,
        largest_truth_error: SHARE,
        scenes,
        methods,
    }
}

fn described(card: &Card) -> ChartMethod {
    ChartMethod {
        name: card.name.clone(),
        title: card.title.to_owned(),
        source: card.source.to_owned(),
        class: class(card.class),
    }
}

fn scene(sample: &Sample) -> ChartScene {
    ChartScene {
        name: sample.name.clone(),
        title: sample.scene.title.clone(),
        hash: hash_of(&sample.scene),
        clouds: sample.clouds.iter().map(cloud).collect(),
    }
}

fn cloud(one: &CloudSample) -> ChartCloud {
    let known = one.truth.radiances.iter().flatten().count();
    ChartCloud {
        effective_radius_um: one.effective_radius_um,
        wavelength_um: one.wavelength_um,
        tau: one.grid.tau.clone(),
        theta_l_deg: one.grid.theta_l_deg.clone(),
        theta_v_deg: one.grid.theta_v_deg.clone(),
        phi_deg: one.grid.phi_deg.clone(),
        radiances: known as u64,
        excluded: (one.truth.radiances.len() - known) as u64,
        worst_truth_error: one.truth.worst_error(),
    }
}
