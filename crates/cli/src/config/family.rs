//! `[family]`: the effective radii that get a table each.

use super::{Fault, Source, TransportConfig};
use serde::{Deserialize, Serialize};
use stratiform_optics::OpticsConfig;
use stratiform_quantities::Range;

/// Effective radii that a family may have, µm.
const RADIUS_UM: Range = Range::closed(1.0, 50.0);

/// `[family]`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FamilyConfig {
    /// Effective radii, rising, at least two. Droplets keep the law and the relative width of `optics.droplets`.
    pub effective_radius_um: Vec<f64>,
}

impl FamilyConfig {
    pub(super) fn validate(&self, optics: &OpticsConfig, transport: &TransportConfig) -> Result<(), Fault> {
        const KEY: &str = "family.effective_radius_um";
        let fault = |message: String| Fault { key: Some(KEY.to_owned()), message };
        if self.effective_radius_um.len() < 2 {
            let count = self.effective_radius_um.len();
            return Err(fault(format!("{KEY} has {count} radii: a family needs at least 2")));
        }
        let mut allowed = RADIUS_UM;
        for &radius in &self.effective_radius_um {
            allowed.check(KEY, radius)?;
            optics.droplets.at_effective_radius(radius).map_err(|error| fault(error.to_string()))?;
            allowed = Range { min: radius, min_included: false, ..allowed };
        }
        if transport.source == Source::Trace {
            return Err(fault("[family] needs transport.source = \"solve\"".to_owned()));
        }
        Ok(())
    }
}
