//! The quality card of an exported phase function: what its look-up is worth against the table it came from.
//!
//! The look-up is that of the values as the container stores them (f64, f32 or f16). Integrals are ½∫ f sinΘ dΘ by
//! Gauss's rule between the nodes of table and texels. Relative errors are those at these points and at the nodes, where
//! P > 0; they leave out the cells that a jump of P turns into a ramp, which `total_variation` counts.

use crate::TablesError;
use crate::sampled::{Quadrature, TEXELS, coordinate, look_up};
use serde::{Deserialize, Serialize};
use stratiform_optics::phase::PhaseTable;
use stratiform_quantities::{Range, angle_map};

const FINITE: Range = Range::closed(-f64::MAX, f64::MAX);
/// Where the fogbow is looked for, degrees.
const FOGBOW_DEG: [f64; 2] = [130.0, 150.0];
/// The glory, degrees.
const GLORY_DEG: [f64; 2] = [170.0, 180.0];

/// Errors of one exported function. Relative errors are |look-up/P - 1| where no sign is stated.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Card {
    /// ½∫ look-up sinΘ dΘ.
    pub integral: f64,
    /// g of the look-up.
    pub asymmetry: f64,
    /// That less g of the table.
    pub asymmetry_error: f64,
    /// P(0°) of the look-up.
    pub peak: f64,
    /// Relative error at 0°, signed; none where P(0°) = 0.
    pub peak_error: Option<f64>,
    /// Largest relative error from 130° to 150°.
    pub fogbow_error: f64,
    /// Largest relative error from 170° to 180°.
    pub glory_error: f64,
    /// Largest relative error.
    pub largest_error: f64,
    /// Where that is, degrees.
    pub largest_at_deg: f64,
    /// Median relative error over the points.
    pub median_error: f64,
    /// ¼∫|look-up - P| sinΘ dΘ: the share of light that is sent elsewhere.
    pub total_variation: f64,
}

impl Card {
    /// Names of the columns of [`Card::csv`].
    pub const COLUMNS: &'static str = "integral,asymmetry,asymmetry_error,peak,peak_error,fogbow_error,glory_error,\
                                       largest_error,largest_at_deg,median_error,total_variation";

    /// The card of `values`, as stored, for `table`.
    ///
    /// # Errors
    /// [`TablesError::Domain`] unless there are 64 to 1024 values, all finite.
    pub fn new(table: &PhaseTable, values: &[f64]) -> Result<Self, TablesError> {
        TEXELS.check("texels", values.len() as f64)?;
        for value in values {
            FINITE.check("p", *value)?;
        }
        Ok(Self::measure(table, values))
    }

    fn measure(table: &PhaseTable, values: &[f64]) -> Self {
        let quadrature = Quadrature::new(table, values.len());
        let (p, found) = (|theta: f64| table.at(theta.to_radians()), |theta| look_up(values, theta));
        let g = |f: &dyn Fn(f64) -> f64| quadrature.integral(|t| f(t) * libm::cos(t.to_radians()));
        let errors = relative_errors(table, values, &quadrature);
        let largest =
            errors.iter().copied().fold((0.0, 0.0), |worst, e| if e.1 > worst.1 { e } else { worst });
        let peak = p(0.0);
        Self {
            integral: quadrature.integral(found),
            asymmetry: g(&found),
            asymmetry_error: g(&found) - g(&p),
            peak: values[0],
            peak_error: (peak > 0.0).then(|| values[0] / peak - 1.0),
            fogbow_error: largest_within(&errors, FOGBOW_DEG),
            glory_error: largest_within(&errors, GLORY_DEG),
            largest_error: largest.1,
            largest_at_deg: largest.0,
            median_error: median(errors),
            total_variation: 0.5 * quadrature.integral(|t| (found(t) - p(t)).abs()),
        }
    }

    /// The row under [`Card::COLUMNS`]; an absent peak error is empty.
    pub fn csv(&self) -> String {
        let numbers = [
            Some(self.integral),
            Some(self.asymmetry),
            Some(self.asymmetry_error),
            Some(self.peak),
            self.peak_error,
            Some(self.fogbow_error),
            Some(self.glory_error),
            Some(self.largest_error),
            Some(self.largest_at_deg),
            Some(self.median_error),
            Some(self.total_variation),
        ];
        numbers.map(|number| number.map_or(String::new(), |n| n.to_string())).join(",")
    }
}

/// Θ in degrees and |look-up/P - 1|.
fn relative_errors(table: &PhaseTable, values: &[f64], quadrature: &Quadrature) -> Vec<(f64, f64)> {
    let jumps: Vec<f64> = table
        .theta_deg()
        .windows(2)
        .filter(|pair| pair[0] == pair[1])
        .map(|pair| angle_map::coordinate(pair[0]))
        .collect();
    let reach = 2.0 * coordinate(1, values.len());
    let smooth = |theta_deg: f64| {
        let u = angle_map::coordinate(theta_deg);
        jumps.iter().all(|jump| (u - jump).abs() >= reach)
    };
    let inner = quadrature.points.iter().map(|&(theta_deg, _)| theta_deg);
    let all = quadrature.borders.iter().copied().chain(inner).filter(|&theta_deg| smooth(theta_deg));
    let with_p = all.map(|theta_deg| (theta_deg, table.at(theta_deg.to_radians()))).filter(|(_, p)| *p > 0.0);
    with_p.map(|(theta_deg, p)| (theta_deg, (look_up(values, theta_deg) / p - 1.0).abs())).collect()
}

fn largest_within(errors: &[(f64, f64)], [from, to]: [f64; 2]) -> f64 {
    errors.iter().filter(|(t, _)| (from..=to).contains(t)).fold(0.0, |worst, (_, error)| error.max(worst))
}

/// The lower median; 0 of nothing.
fn median(errors: Vec<(f64, f64)>) -> f64 {
    let mut sorted: Vec<f64> = errors.into_iter().map(|(_, error)| error).collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len().saturating_sub(1) / 2).copied().unwrap_or(0.0)
}
