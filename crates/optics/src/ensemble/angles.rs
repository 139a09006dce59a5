//! The angles at which P is tabulated: graded so that linear interpolation in Θ is good to about 1e-3 below 60°.
//!
//! With x_e = 2πr_e/λ the forward peak is about 1/x_e wide: steps start at 0.042/x_e and grow to 1 % of Θ, which
//! follows the Θ^-4 or so of the peak's flank, and stay below the width of the supernumerary bows, 0.0813 x_e^{-2/3}. The grid is
//! symmetric about 90°, so that the glory is resolved like the peak. One droplet has interference fringes of width
//! π/x at every angle, which no averaging removes: there the step is 0.06/x throughout.

use crate::OpticsError;
use crate::droplets::SizeDistribution;
use std::f64::consts::PI;
use stratiform_quantities::Range;

/// Most nodes of a grid.
const MOST: f64 = 2e6;

/// Θ in degrees, from 0 to 180, with `theta_f_deg` and its supplement among them.
///
/// # Errors
/// [`OpticsError::Domain`] unless 0 < `theta_f_deg` < 90 and the fringes can be tabulated.
pub fn angle_grid(
    droplets: &SizeDistribution,
    wave_number: f64,
    theta_f_deg: f64,
) -> Result<Vec<f64>, OpticsError> {
    let theta_f = Range::open(0.0, 90.0).check("theta_f_deg", theta_f_deg)?;
    let x = (wave_number * droplets.effective_radius()).max(1.0);
    let half = if droplets.single_radius().is_some() {
        let step = (0.06 / x).min(0.01);
        Range::closed(0.0, MOST).check("angles needed to resolve one droplet's fringes", PI / step)?;
        uniform(step)
    } else {
        graded(x)
    };
    Ok(mirrored(with_node(half, theta_f)))
}

fn uniform(step: f64) -> Vec<f64> {
    let count = (0.5 * PI / step).ceil() as usize;
    (0..count).map(|i| 90.0 * i as f64 / count as f64).collect()
}

/// Degrees below 90.
fn graded(x: f64) -> Vec<f64> {
    const SHARE: f64 = 0.01;
    let (first, widest) = ((0.042 / x).min(0.01), (0.0813 / libm::cbrt(x * x)).min(0.01));
    let (mut theta, mut nodes) = (0.0_f64, Vec::new());
    while theta < 0.5 * PI - 0.5 * widest {
        nodes.push(theta.to_degrees());
        theta += (SHARE * theta).clamp(first.min(widest), widest);
    }
    nodes
}

/// Moves the node nearest to `theta_f` there (the first node stays).
fn with_node(mut nodes: Vec<f64>, theta_f: f64) -> Vec<f64> {
    let right = nodes.partition_point(|t| *t < theta_f);
    let nearest = match (nodes.get(right), nodes.get(right - 1)) {
        (Some(after), Some(before)) if theta_f - before < after - theta_f => right - 1,
        (None, _) => right - 1,
        _ => right,
    };
    if nearest == 0 {
        nodes.insert(1, theta_f);
    } else {
        nodes[nearest] = theta_f;
    }
    nodes
}

/// `half`, 90, and 180 - `half` backwards.
fn mirrored(half: Vec<f64>) -> Vec<f64> {
    let back: Vec<f64> = half.iter().rev().map(|t| 180.0 - t).collect();
    [half, vec![90.0], back].concat()
}
