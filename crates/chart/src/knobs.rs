//! The curves of one method as its knob turns.

use crate::cost::Effort;
use crate::{ChartError, Quantity, Sample, Tested, assess};
use stratiform_artifact::KnobRow;
use stratiform_methods::{Card, Cloud, Method, MethodError, Ready};
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::{Range, angle_map};

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
    pub method: Box<dyn Tested>,
}

/// Errors and cost of every setting in one scene.
///
/// # Errors
/// [`ChartError`] if a cost cannot be measured.
pub fn knobs(sample: &Sample, knobs: &[Knob], effort: Effort) -> Result<Vec<KnobRow>, ChartError> {
    let mut rows = Vec::new();
    for knob in knobs {
        for KnobSetting { setting, method } in &knob.settings {
            for found in assess(method.as_ref(), sample, effort)? {
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

/// `method` with its phase function read from `texels` of the angle map that emitted phase textures use.
///
/// # Errors
/// [`ChartError::Domain`] for less than 8 texels.
pub fn coarse_phase(method: Box<dyn Method>, texels: usize) -> Result<Box<dyn Tested>, ChartError> {
    Range::closed(8.0, 65_536.0).check("phase table texels", texels as f64)?;
    Ok(Box::new(Coarse { method, texels }))
}

struct Coarse {
    method: Box<dyn Method>,
    texels: usize,
}

impl Tested for Coarse {
    fn card(&self) -> &Card {
        self.method.card()
    }

    fn prepare(&self, cloud: &Cloud) -> Result<Box<dyn Ready>, MethodError> {
        let failed = |reason: String| MethodError::Failed { method: self.card().name.clone(), reason };
        let last = (self.texels - 1) as f64;
        let mut angles: Vec<f64> = (0..self.texels).map(|i| angle_map::angle_deg(i as f64 / last)).collect();
        angles[self.texels - 1] = 180.0;
        let values = angles.iter().map(|theta| cloud.phase().at(theta.to_radians())).collect();
        let phase = PhaseTable::new(angles, values, Norm::Any).map_err(|error| failed(error.to_string()))?;
        let coarse = Cloud::new(phase, cloud.omega(), cloud.theta_f_deg(), cloud.r_eff_um())?;
        self.method.prepare(&coarse)
    }
}
