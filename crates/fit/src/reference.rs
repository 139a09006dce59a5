//! What the model is fitted to: fluxes of one incidence over the thickness grid, with covariances.

use crate::{FitError, Matrix};
use serde::{Deserialize, Serialize};
use stratiform_artifact::RowIncidence;
use stratiform_model::table::cos_degrees;
use stratiform_quantities::{Incidence, Range};

/// Names of the orders, in the sequence of [`Reference::orders`].
pub const ORDERS: [&str; 4] = ["t_1", "t_2", "r_1", "r_2"];

/// Reference fluxes of one incidence. All lists follow the thickness grid of the config.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reference {
    /// Angle or diffuse light.
    pub incidence: RowIncidence,
    /// Optical thickness of the full medium.
    pub tau: Vec<f64>,
    /// T_ms of the full medium.
    pub t_ms: Vec<f64>,
    /// Its covariance between thicknesses, row by row.
    pub t_ms_covariance: Vec<f64>,
    /// T_1, T_2, R_1, R_2 of the modified medium.
    pub orders: [Vec<f64>; 4],
    /// Their covariance, row by row; quantity q at thickness k has index q·count + k.
    pub orders_covariance: Vec<f64>,
}

impl Reference {
    /// The incidence in the model's words.
    ///
    /// # Errors
    /// [`FitError`] for an angle outside \[0, 90\] or a word other than `diffuse`.
    pub fn light(&self) -> Result<Incidence, FitError> {
        match &self.incidence {
            RowIncidence::Degrees(degrees) => {
                Range::closed(0.0, 90.0).check("theta_l_deg", *degrees)?;
                Ok(Incidence::beam(cos_degrees(*degrees))?)
            }
            RowIncidence::Word(word) => word.parse().map_err(FitError::Inconsistent),
        }
    }

    /// Checks lengths, ranges and covariances; `tau` is the grid they must stand on.
    pub(crate) fn check(&self, tau: &[f64]) -> Result<(), FitError> {
        let at = |what: &str| format!("{what} of theta_l = {}", self.incidence);
        self.light()?;
        FitError::check_length(at("tau"), self.tau.len(), tau.len())?;
        for (own, grid) in self.tau.iter().zip(tau) {
            Range::closed(grid * (1.0 - 1e-9), grid * (1.0 + 1e-9)).check(&at("tau"), *own)?;
        }
        check_fluxes(&at("t_ms"), &self.t_ms, tau.len())?;
        for (name, order) in ORDERS.iter().zip(&self.orders) {
            check_fluxes(&at(name), order, tau.len())?;
        }
        self.t_ms_covariance()?;
        self.orders_covariance()?;
        Ok(())
    }

    /// Covariance of T_ms.
    pub(crate) fn t_ms_covariance(&self) -> Result<Matrix, FitError> {
        let what = format!("the covariance of t_ms of theta_l = {}", self.incidence);
        covariance(&what, &self.t_ms_covariance, self.t_ms.len())
    }

    /// Covariance of the orders.
    pub(crate) fn orders_covariance(&self) -> Result<Matrix, FitError> {
        let what = format!("the covariance of the orders of theta_l = {}", self.incidence);
        covariance(&what, &self.orders_covariance, ORDERS.len() * self.t_ms.len())
    }
}

fn check_fluxes(what: &str, values: &[f64], count: usize) -> Result<(), FitError> {
    FitError::check_length(what, values.len(), count)?;
    for &value in values {
        Range::closed(0.0, 1.0).check(what, value)?;
    }
    Ok(())
}

/// A covariance matrix is finite and symmetric, and no correlation in it exceeds 1.
fn covariance(what: &str, values: &[f64], size: usize) -> Result<Matrix, FitError> {
    FitError::check_length(what, values.len(), size * size)?;
    let at = |i: usize, j: usize| values[i * size + j];
    for i in 0..size {
        Range::at_least(0.0).check(what, at(i, i))?;
        for j in 0..i {
            let limit = (at(i, i) * at(j, j)).sqrt() * (1.0 + 1e-9);
            Range::closed(-limit, limit).check(what, at(i, j))?;
            if (at(i, j) - at(j, i)).abs() > 1e-9 * limit {
                return Err(FitError::Inconsistent(format!("{what} is not symmetric at ({i}, {j})")));
            }
        }
    }
    Ok(Matrix::square(size, at))
}
