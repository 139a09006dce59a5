//! How much of a model a scene needs: orders, nodes, passes. All from the truth in the data.

use crate::cover::{Ask, Population, halton};
use crate::data::{Data, Value};
use crate::predict::{Points, percentile};
use stratiform_artifact::ErrorBlock;
use stratiform_quantities::Side;
use stratiform_scene::{Interval, Scene};

/// Points of a check.
const POINTS: usize = 150;

/// The most passes that are worth naming.
const MOST_PASSES: u32 = 64;

/// Orders whose rest is within `allowed` at 95 % of the scene: 1, 2, or `None` for all.
pub(crate) fn orders(data: &Data, points: &Points, allowed: f64) -> Option<u32> {
    let (_, places) = points.populations.first()?;
    let share = |nodes: &[(usize, f64)], column| match data.value(nodes, column) {
        Value::Known(share) => share,
        _ => 0.0,
    };
    (1..=2).find(|count| {
        let rest = |nodes: &[(usize, f64)]| {
            1.0 - (0..*count as usize).map(|column| share(nodes, column)).sum::<f64>()
        };
        let mut rests: Vec<f64> = places.iter().map(|place| rest(&place.nodes)).collect();
        percentile(&mut rests, 0.95) <= allowed
    })
}

/// r_e of phase tables: those between which linear interpolation of the truth in ln r_e stays within `allowed` at 95 % of the points, as far as the data's
/// own nodes tell: one in the middle, or ends and equal steps.
pub(crate) fn radii(data: &Data, scene: &Scene, whole: &Population, allowed: f64) -> Vec<f64> {
    let range = scene.droplets.effective_radius_um;
    if range.min == range.max {
        return vec![range.min];
    }
    let mut checked: Vec<f64> = data.radii().into_iter().filter(|radius| range.contains(*radius)).collect();
    checked.extend([range.min, range.max]);
    for count in 1..checked.len() {
        let nodes = steps(range, count);
        if misfit(data, &whole.asks[..POINTS.min(whole.asks.len())], &nodes, &checked) <= allowed {
            return nodes;
        }
    }
    steps(range, checked.len())
}

/// Ends of the family's range, µm.
const FAMILY_UM: Interval = Interval { min: 4.0, max: 20.0 };

/// Worst error of R and T between tables of fitted parameters, over 4 to 20 µm in equal steps of 1/r_e: as fitted (fit-configs/family).
const PARAMETER_TABLES: [(usize, f64); 2] = [(2, 1.4e-3), (6, 1.2e-4)];

/// r_e of the tables of fitted parameters: as few as leave a tenth of `allowed`.
pub(crate) fn parameter_radii(scene: &Scene, allowed: f64) -> Vec<f64> {
    let range = scene.droplets.effective_radius_um;
    if range.min == range.max {
        return vec![range.min];
    }
    let [few, many] = PARAMETER_TABLES;
    let count = if few.1 <= 0.1 * allowed { few.0 } else { many.0 };
    let inverse = Interval { min: 1.0 / FAMILY_UM.max, max: 1.0 / FAMILY_UM.min };
    inverse.linear(count).into_iter().rev().map(|x| (100.0 / x).round() / 100.0).collect()
}

/// `count` radii in equal ratios, to 0.01 µm between the ends.
fn steps(range: Interval, count: usize) -> Vec<f64> {
    let at = range.geometric(count, libm::pow);
    let rounded = |x: f64| if x == range.min || x == range.max { x } else { (100.0 * x).round() / 100.0 };
    at.into_iter().map(rounded).collect()
}

/// 95th percentile of the error of interpolating the truth between `nodes`, at `checked`.
fn misfit(data: &Data, asks: &[Ask], nodes: &[f64], checked: &[f64]) -> f64 {
    let at = |ask: &Ask, radius: f64| {
        let ask = Ask { effective_radius_um: radius, ..*ask };
        match data.truth(&data.nodes(ErrorBlock::Grid, &ask)) {
            Value::Known(value) => Some(value),
            _ => None,
        }
    };
    let mut sizes = Vec::new();
    for ask in asks {
        let known: Option<Vec<f64>> = nodes.iter().map(|radius| at(ask, *radius)).collect();
        let Some(known) = known else { continue };
        let logs: Vec<f64> = nodes.iter().map(|radius| libm::log(*radius)).collect();
        for radius in checked {
            let Some(truth) = at(ask, *radius) else { continue };
            sizes.push((between(&logs, &known, libm::log(*radius)) / truth - 1.0).abs());
        }
    }
    percentile(&mut sizes, 0.95)
}

/// Linear, the end's value beyond an end.
fn between(nodes: &[f64], values: &[f64], x: f64) -> f64 {
    let upper = nodes.partition_point(|node| *node <= x);
    if upper == 0 || upper == nodes.len() {
        return values[upper.saturating_sub(1)];
    }
    let share = (x - nodes[upper - 1]) / (nodes[upper] - nodes[upper - 1]);
    values[upper - 1] + share * (values[upper] - values[upper - 1])
}

/// θ_l of as few rows as interpolate R and T within `allowed` at 95 % of thicknesses and suns: every 40°, 20° or 10°, and 90°.
pub(crate) fn suns(data: &Data, scene: &Scene, tau: Interval, allowed: f64) -> Vec<f64> {
    let table = |step: u32| (0..90).step_by(step as usize).chain([90]).map(f64::from).collect::<Vec<f64>>();
    let enough = |step: &u32| sun_misfit(data, scene, tau, &table(*step)) <= allowed;
    table([40, 20].into_iter().find(enough).unwrap_or(10))
}

fn sun_misfit(data: &Data, scene: &Scene, tau: Interval, nodes: &[f64]) -> f64 {
    let mut sizes = Vec::new();
    for i in 0..POINTS {
        let ask = Ask { side: Side::BOTH[i % 2], ..Ask::within(scene, tau, halton(i as u32 + 1), i) };
        let at = |theta: f64| {
            let ask = Ask { theta_l_deg: theta, ..ask };
            match data.truth(&data.nodes(ErrorBlock::Flux, &ask)) {
                Value::Known(value) => value,
                _ => 0.0,
            }
        };
        let known: Vec<f64> = nodes.iter().map(|theta| at(*theta)).collect();
        for theta in data.flux_suns() {
            let truth = at(*theta);
            if truth > 0.0 {
                sizes.push((between(nodes, &known, *theta) / truth - 1.0).abs());
            }
        }
    }
    percentile(&mut sizes, 0.95)
}

/// R of the thickest cloud of the scene in diffuse light, 2∫R μ dμ.
pub(crate) fn diffuse_albedo(data: &Data, scene: &Scene, tau: Interval) -> f64 {
    let thickest = Interval { min: tau.max, max: tau.max };
    let values: Vec<f64> = (0..POINTS as u32)
        .filter_map(|i| {
            let share = halton(i + 1);
            let theta_l_deg = libm::acos(share[2].sqrt()).to_degrees();
            let ask = Ask { theta_l_deg, side: Side::Top, ..Ask::within(scene, thickest, share, 0) };
            match data.truth(&data.nodes(ErrorBlock::Flux, &ask)) {
                Value::Known(value) => Some(value),
                _ => None,
            }
        })
        .collect();
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

/// Passes after which less than `allowed` of the light is missing: Σ_{i>n} x^i is x^{n+1} of Σ x^i. At least one, at most 64.
pub(crate) fn passes(x: f64, allowed: f64) -> u32 {
    let mut rest = x * x;
    let mut count = 1;
    while rest > allowed && count < MOST_PASSES {
        rest *= x;
        count += 1;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_passes_leave_out_is_within_what_is_allowed() {
        for (x, allowed, count) in [(0.1, 0.02, 1), (0.5, 0.1, 3), (0.5, 0.06, 4), (0.8, 0.02, 17)] {
            assert_eq!(passes(x, allowed), count, "{x}");
            let sum = |n: u32| (0..=n).map(|i| libm::pow(x, f64::from(i))).sum::<f64>();
            assert!(1.0 - sum(count) / sum(500) <= allowed);
        }
        assert_eq!(passes(1.0, 0.01), MOST_PASSES);
    }

    #[test]
    fn values_between_nodes() {
        assert_eq!(between(&[1.0, 3.0], &[10.0, 20.0], 2.0), 15.0);
        assert_eq!(between(&[1.0, 3.0], &[10.0, 20.0], 9.0), 20.0);
        assert_eq!(between(&[1.0], &[10.0], 0.0), 10.0);
    }
}
