//! `[colour]`: at which wavelengths the phase functions in colour are computed.

use super::Fault;
use crate::pipeline::colour;
use serde::{Deserialize, Serialize};
use stratiform_optics::OpticsConfig;

/// 0.39 to 0.71 µm in steps of 0.04: of the paper's cloud no channel is off by more than 0.6 % of the luminance
/// (`cargo run -p stratiform-tables --example colour_error`).
const WAVELENGTHS_UM: [f64; 9] = [0.39, 0.43, 0.47, 0.51, 0.55, 0.59, 0.63, 0.67, 0.71];

/// `[colour]`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ColourConfig {
    /// λ in µm, ascending, three or more; none: no phase functions in colour.
    pub wavelengths_um: Vec<f64>,
}

impl Default for ColourConfig {
    fn default() -> Self {
        Self { wavelengths_um: WAVELENGTHS_UM.to_vec() }
    }
}

impl ColourConfig {
    /// Whether no colour is wanted.
    pub fn is_off(&self) -> bool {
        self.wavelengths_um.is_empty()
    }

    pub(super) fn validate(&self, optics: &OpticsConfig) -> Result<(), Fault> {
        if self.is_off() {
            return Ok(());
        }
        let fault = |message: String| Fault { key: Some("colour.wavelengths_um".to_owned()), message };
        stratiform_tables::colour::check_wavelengths(&self.wavelengths_um)
            .map_err(|error| fault(error.to_string()))?;
        colour::optics(optics, self).resolve().map_err(|error| fault(error.to_string()))?;
        Ok(())
    }
}
