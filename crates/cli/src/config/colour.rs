//! `[colour]`: at which wavelengths the phase functions in colour are computed.

use super::Fault;
use crate::pipeline::colour;
use serde::{Deserialize, Serialize};
use stratiform_optics::OpticsConfig;

/// 0.39 to 0.71 µm in steps of 0.04: of the paper's cloud no channel is off by more than 0.6 % of the luminance
/// (`cargo run -p stratiform-tables --example colour_error`), of droplets with γ = 18 by more than 0.5 % against 17 wavelengths.
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

#[cfg(test)]
mod tests {
    use crate::config::Config;
    use std::path::Path;

    /// The paper's config with a section `[colour]`.
    fn load(section: &str) -> Result<Config, String> {
        let from = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b.toml"));
        let text = std::fs::read_to_string(from).unwrap();
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("cloud.toml");
        std::fs::write(&path, format!("{text}\n[colour]\nwavelengths_um = {section}\n")).unwrap();
        let line = text.lines().count() + 3;
        Config::load(&path).map_err(|error| error.to_string().replace(&format!(":{line}: "), ":LINE: "))
    }

    #[test]
    fn wavelengths_without_a_colour_are_refused_with_their_line() {
        for (section, says) in [
            ("[0.5]", "wavelengths of a colour = 1 is outside [3, infinity)"),
            ("[0.3, 0.5, 0.6]", "wavelength_um = 0.3"),
            ("[0.6, 0.5, 0.4]", "(ascending) = 0.5"),
            ("[0.5, 0.5, 0.6]", "(ascending) = 0.5"),
            ("[0.5, nan, 0.6]", "NaN"),
        ] {
            let error = load(section).unwrap_err();
            assert!(error.contains(":LINE: ") && error.contains(says), "{section}: {error}");
        }
        assert!(load("[]").unwrap().colour.is_off());
        assert_eq!(load("[0.45, 0.55, 0.65]").unwrap().colour.wavelengths_um.len(), 3);
    }
}
