//! CSV: metadata in one `#` line, then a line per texel. f64.

use super::{Metadata, Precision};
use crate::TablesError;
use crate::sampled::{coordinate, theta_deg};
use crate::set::SampledSet;
use std::fmt::Write;

/// Columns index, coordinate, theta_deg, and `function_channel` for each function and channel (`full_550nm`; a comma
/// in a channel's name is written as `p`: `532p5nm`).
///
/// # Errors
/// [`TablesError::Domain`] for values that are not finite.
pub fn phase_csv(set: &SampledSet) -> Result<Vec<u8>, TablesError> {
    Precision::F64.check_set(set)?;
    let mut text = format!("# {}\nindex,coordinate,theta_deg", Metadata::new(set).line()?);
    for function in &set.functions {
        for channel in &set.channels {
            let _ = write!(text, ",{}_{}", function.name(), channel.name().replace(',', "p"));
        }
    }
    text.push('\n');
    for i in 0..set.texels {
        let _ = write!(text, "{i},{},{}", coordinate(i, set.texels), theta_deg(i, set.texels));
        for sample in set.rows.iter().flatten() {
            let _ = write!(text, ",{}", sample.values[i]);
        }
        text.push('\n');
    }
    Ok(text.into_bytes())
}
