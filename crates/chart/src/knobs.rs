//! The curves of one method as its knob turns.

use crate::cost::Effort;
use crate::{ChartError, Quantity, Sample, Watch, assess};
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
    let mut rows = Vec::new();
    for knob in knobs {
        for KnobSetting { setting, method } in &knob.settings {
            for found in watch.over(|| assess(method.as_ref(), sample, effort))? {
                rows.push(KnobRow {
                    scene: sample.name.clone(),
                    method: knob.method.clone(),
                    knob: knob.knob.clone(),
                    setting: *setting,
                    quantity: Quantity::name(found.quantity).to_owned(),
                    points: found.points as u64,
                    refused: found.refused as u64,
                    median: found.statistics.map(|s| s.median),
                    p95: found.statistics.map(|s| s.p95),
                    worst: found.statistics.map(|s| s.worst),
                    ns_per_evaluation: found.ns,
                    table_bytes: method.card().table_bytes.map(|bytes| bytes as u64),
                });
            }
        }
    }
    Ok(rows)
}
