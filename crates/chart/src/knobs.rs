//! The curves of one method as its knob turns.

use crate::assess::assess_all;
use crate::cost::Effort;
use crate::{Assessment, ChartError, Sample, Watch};
use stratiform_artifact::KnobRow;
use stratiform_methods::Method;

/// A knob of a method.
pub struct Knob {
    /// The method without its knob.
    pub method: String,
    /// What is turned.
    pub knob: String,
    /// Its settings.
    pub settings: Vec<KnobSetting>,
}

/// One setting of a knob.
pub struct KnobSetting {
    /// Number of it.
    pub setting: f64,
    /// The method so set.
    pub method: Box<dyn Method>,
}

/// Errors and cost of every setting in one scene.
///
/// # Errors
/// [`ChartError`] if a cost cannot be measured, or [`ChartError::Cancelled`].
pub fn knobs(
    sample: &Sample,
    knobs: &[Knob],
    effort: Effort,
    watch: Watch<'_>,
) -> Result<Vec<KnobRow>, ChartError> {
    let settings = || knobs.iter().flat_map(|knob| knob.settings.iter().map(move |setting| (knob, setting)));
    let methods: Vec<&dyn Method> = settings().map(|(_, setting)| setting.method.as_ref()).collect();
    let mut rows = Vec::new();
    for ((knob, setting), found) in settings().zip(assess_all(&methods, sample, effort, watch)?) {
        rows.extend(found.into_iter().map(|one| row(&sample.name, knob, setting, one)));
    }
    Ok(rows)
}

fn row(
    scene: &str,
    knob: &Knob,
    KnobSetting { setting, method }: &KnobSetting,
    found: Assessment,
) -> KnobRow {
    KnobRow {
        scene: scene.to_owned(),
        method: knob.method.clone(),
        knob: knob.knob.clone(),
        setting: *setting,
        quantity: found.quantity.name().to_owned(),
        points: found.points as u64,
        refused: found.refused as u64,
        median: found.statistics.map(|s| s.median),
        p95: found.statistics.map(|s| s.p95),
        worst: found.statistics.map(|s| s.worst),
        ns_per_evaluation: found.ns,
        table_bytes: method.card().table_bytes.map(|bytes| bytes as u64),
    }
}
