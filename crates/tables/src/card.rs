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
        let jumps: Vec<f64> = jumps_deg(table).map(angle_map::coordinate).collect();
        let reach = 2.0 * coordinate(1, values.len());
        let smooth = |theta_deg: f64| {
            let u = angle_map::coordinate(theta_deg);
            jumps.iter().all(|jump| (u - jump).abs() >= reach)
        };
        let found = |theta_deg: f64| look_up(values, theta_deg);
        Ok(Self::of_look_up(table, &Quadrature::new(table, values.len()), smooth, found))
    }

    /// The card of any look-up `found` of Θ in degrees, with a rule between whose borders it is smooth; relative
    /// errors are those where `smooth`.
    pub(crate) fn of_look_up(
        table: &PhaseTable,
        quadrature: &Quadrature,
        smooth: impl Fn(f64) -> bool,
        found: impl Fn(f64) -> f64,
    ) -> Self {
        let sample = |theta_deg: f64| Sample {
            theta_deg,
            p: table.at(theta_deg.to_radians()),
            found: found(theta_deg),
        };
        let inside: Vec<Sample> = quadrature.points.iter().map(|(theta_deg, _)| sample(*theta_deg)).collect();
        let integral = |f: &dyn Fn(&Sample) -> f64| {
            let weights = quadrature.points.iter().map(|(_, weight)| weight);
            weights.zip(&inside).fold(0.0, |sum, (weight, sample)| sum + weight * f(sample))
        };
        let asymmetry = integral(&|s| s.found * s.cosine());
        let borders = quadrature.borders.iter().map(|theta_deg| sample(*theta_deg));
        let errors = relative_errors(borders.chain(inside.iter().copied()), smooth);
        let largest =
            errors.iter().copied().fold((0.0, 0.0), |worst, e| if e.1 > worst.1 { e } else { worst });
        let peak = sample(0.0);
        Self {
            integral: integral(&|s| s.found),
            asymmetry,
            asymmetry_error: asymmetry - integral(&|s| s.p * s.cosine()),
            peak: peak.found,
            peak_error: (peak.p > 0.0).then(|| peak.found / peak.p - 1.0),
            fogbow_error: largest_within(&errors, FOGBOW_DEG),
            glory_error: largest_within(&errors, GLORY_DEG),
            largest_error: largest.1,
            largest_at_deg: largest.0,
            median_error: median(errors),
            total_variation: 0.5 * integral(&|s| (s.found - s.p).abs()),
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

/// Where a table jumps, degrees.
pub(crate) fn jumps_deg(table: &PhaseTable) -> impl Iterator<Item = f64> {
    table.theta_deg().windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}

/// Table and look-up at an angle.
#[derive(Clone, Copy)]
struct Sample {
    theta_deg: f64,
    p: f64,
    found: f64,
}

impl Sample {
    fn cosine(&self) -> f64 {
        libm::cos(self.theta_deg.to_radians())
    }
}

/// Θ in degrees and |look-up/P - 1|.
fn relative_errors(samples: impl Iterator<Item = Sample>, smooth: impl Fn(f64) -> bool) -> Vec<(f64, f64)> {
    let counted = samples.filter(|s| s.p > 0.0 && smooth(s.theta_deg));
    counted.map(|s| (s.theta_deg, (s.found / s.p - 1.0).abs())).collect()
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
