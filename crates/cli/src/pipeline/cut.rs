//! The phase functions of the modified medium that shaders and the paper's model look up.

use super::input_error;
use super::optics::Cloud;
use crate::CliError;
use stratiform_optics::phase::PhaseTable;

/// P_S, and its convolution with itself on the sphere.
pub struct Cut {
    /// P_S.
    pub wide: PhaseTable,
    /// P_S * P_S.
    pub squared: PhaseTable,
}

impl Cut {
    /// Of a cloud whose forward peak ends at `theta_f_deg`.
    ///
    /// # Errors
    /// [`CliError::Input`] for an angle out of domain, or if the table's nodes cannot hold the result.
    pub fn new(cloud: &Cloud, theta_f_deg: f64) -> Result<Self, CliError> {
        let wide = cloud.phase.modified(theta_f_deg).map_err(input_error)?;
        let squared = wide.squared().map_err(input_error)?;
        Ok(Self { wide, squared })
    }
}
