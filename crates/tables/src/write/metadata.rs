//! What every container says beside its numbers, as JSON.

use crate::set::{About, Channel, Function, SampledSet};
use serde::{Deserialize, Serialize};
use stratiform_quantities::angle_map;

/// The angle map in words.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AngleMap {
    /// Its name.
    pub name: String,
    /// u(Θ).
    pub coordinate: String,
    /// Θ(u).
    pub angle: String,
    /// Where the texels stand.
    pub texels: String,
}

/// One row of the file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RowMetadata {
    /// Which function.
    pub function: Function,
    /// In words.
    pub definition: String,
    /// Per channel, what the fitted values were multiplied by to make the look-up's integral 1.
    pub scaled_by: Vec<f64>,
}

/// Units, conventions, medium and provenance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Metadata {
    /// `stratiform/phase-table/1`.
    pub schema: String,
    /// What P is measured in.
    pub units: String,
    /// What its integral is.
    pub normalisation: String,
    /// How angles become texels.
    pub angle_map: AngleMap,
    /// How the values follow from the source table.
    pub sampling: String,
    /// Values of each function and channel.
    pub texels: usize,
    /// What channels are.
    pub channel_meaning: String,
    /// The channels, in order.
    pub channels: Vec<Channel>,
    /// Their names.
    pub channel_names: Vec<String>,
    /// The rows, in order.
    pub rows: Vec<RowMetadata>,
    /// The cloud.
    pub about: About,
}

impl Metadata {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/phase-table/1";

    /// Of a set.
    pub fn new(set: &SampledSet) -> Self {
        let rows = set.functions.iter().zip(&set.rows).map(|(&function, row)| RowMetadata {
            function,
            definition: function.definition().to_owned(),
            scaled_by: row.iter().map(|sample| sample.scaled_by).collect(),
        });
        Self {
            schema: Self::SCHEMA.to_owned(),
            units: "theta in degrees, 0 is forward; p without unit, p/(4 pi) is the density per steradian".to_owned(),
            normalisation: "1/2 integral of p sin(theta) dtheta = 1 of the look-up that is linear in u".to_owned(),
            angle_map: AngleMap {
                name: angle_map::NAME.to_owned(),
                coordinate: angle_map::COORDINATE_FORMULA.to_owned(),
                angle: angle_map::ANGLE_FORMULA.to_owned(),
                texels: "texel i of N stands at u = i/(N - 1); texture coordinate (u (N - 1) + 0.5)/N, linear filter along the texels, none across rows"
                    .to_owned(),
            },
            sampling: "least squares over the sphere; averages beside a jump".to_owned(),
            texels: set.texels,
            channel_meaning: channel_meaning(&set.channels).to_owned(),
            channels: set.channels.clone(),
            channel_names: set.channels.iter().map(Channel::name).collect(),
            rows: rows.collect(),
            about: set.about.clone(),
        }
    }

    /// One line of JSON.
    pub(super) fn line(&self) -> Result<String, crate::TablesError> {
        line(self)
    }
}

fn channel_meaning(channels: &[Channel]) -> &'static str {
    if channels.iter().all(|channel| matches!(channel, Channel::LinearSrgb(_))) {
        "linear sRGB (IEC 61966-2-1 primaries, CIE 1931 observer) of p in light of D65; white balance: a p that does not depend on \
         wavelength is R = G = B; p linear between the wavelengths of `medium`, constant beyond them"
    } else {
        "p at one wavelength each"
    }
}

/// One line of JSON; a number that is not finite is an error, not `null`.
pub(super) fn line<T: Serialize + serde::de::DeserializeOwned>(
    value: &T,
) -> Result<String, crate::TablesError> {
    let refuse = |error: serde_json::Error| crate::TablesError::Container {
        format: "metadata",
        reason: error.to_string(),
    };
    let text = serde_json::to_string(value).map_err(refuse)?;
    serde_json::from_str::<T>(&text).map_err(refuse)?;
    Ok(text)
}
