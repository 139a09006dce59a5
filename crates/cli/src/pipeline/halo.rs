//! The halo's table that code is generated from.

use super::input_error;
use crate::CliError;
use stratiform_codegen::HaloTable;
use stratiform_optics::phase::{self, Halo, PhaseTable};

/// Values of s = sin(Θ/2), and of the optical path q.
const SIZE: (usize, usize) = (128, 16);
/// Up to this multiple of θ_f. Light that met two or more forward events is below 1e-4 of its peak there.
const REACH: f64 = 4.0;
/// Longest path: less than 1e-5 of a beam is left with nearly half of all scattering forward.
const LONGEST: f64 = 24.0;

/// The table; none without a forward peak. Linear in s and q it misses 3e-3 of the peak at most in the paper's cloud, and 3e-3 of
/// 95 of 100 values above a hundredth of the peak.
///
/// # Errors
/// [`CliError::Input`] if P_F cannot be formed.
pub fn table(full: &PhaseTable, theta_f_deg: f64) -> Result<Option<HaloTable>, CliError> {
    if theta_f_deg <= 0.0 {
        return Ok(None);
    }
    let halo = Halo::new(full, theta_f_deg).map_err(input_error)?;
    let reach_deg = (REACH * theta_f_deg).min(180.0);
    let table = phase::HaloTable::new(&halo, (SIZE.0, reach_deg), (SIZE.1, LONGEST)).map_err(input_error)?;
    let (angles, _) = table.size();
    let values = table.values().to_vec();
    Ok(Some(HaloTable { reach: table.reach(), longest: table.longest(), angles, values }))
}
