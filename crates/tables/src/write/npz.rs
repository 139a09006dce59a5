//! npz: `numpy.load(file)` gives theta_deg, coordinate, p\[function, channel, texel\], scaled_by\[function, channel\],
//! functions, channels, wavelength_um (where channels are wavelengths) and metadata (JSON). f64; nothing is pickled.

use super::npy::{doubles, string, strings};
use super::{Metadata, Precision, zip};
use crate::TablesError;
use crate::sampled::{coordinate, theta_deg};
use crate::set::{Channel, SampledSet};

/// The set as npz.
///
/// # Errors
/// [`TablesError::Domain`] for values that are not finite.
pub fn phase_npz(set: &SampledSet) -> Result<Vec<u8>, TablesError> {
    Precision::F64.check_set(set)?;
    let along =
        |f: fn(usize, usize) -> f64| -> Vec<f64> { (0..set.texels).map(|i| f(i, set.texels)).collect() };
    let (functions, channels) = (set.functions.len(), set.channels.len());
    let p: Vec<f64> = set.rows.iter().flatten().flat_map(|sample| sample.values.iter().copied()).collect();
    let scaled: Vec<f64> = set.rows.iter().flatten().map(|sample| sample.scaled_by).collect();
    let function_names: Vec<_> = set.functions.iter().map(|f| f.name().to_owned()).collect();
    let channel_names: Vec<_> = set.channels.iter().map(Channel::name).collect();
    let wavelengths: Vec<f64> = set
        .channels
        .iter()
        .filter_map(|channel| match channel {
            Channel::WavelengthUm(um) => Some(*um),
            Channel::LinearSrgb(_) => None,
        })
        .collect();
    let mut arrays = vec![
        ("theta_deg", doubles(&[set.texels], &along(theta_deg))),
        ("coordinate", doubles(&[set.texels], &along(coordinate))),
        ("p", doubles(&[functions, channels, set.texels], &p)),
        ("scaled_by", doubles(&[functions, channels], &scaled)),
        ("functions", strings(&function_names)),
        ("channels", strings(&channel_names)),
        ("metadata", string(&Metadata::new(set).line()?)),
    ];
    if !wavelengths.is_empty() {
        arrays.push(("wavelength_um", doubles(&[wavelengths.len()], &wavelengths)));
    }
    let files: Vec<_> = arrays.into_iter().map(|(name, bytes)| (format!("{name}.npy"), bytes)).collect();
    Ok(zip::stored(&files))
}
