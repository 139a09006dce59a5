//! What a method promises in a scene.

use crate::cover::{Ask, Population};
use crate::data::Data;
use serde::{Deserialize, Serialize};
use stratiform_artifact::{ErrorBlock, ErrorData, ErrorMethod};
use stratiform_scene::Effect;

/// Times the 95th percentile of the interpolated error: what lies between the nodes. With [`FLOOR`] set from seed 2029 of
/// `scripts/verify-advice`, of whose scenes it holds in 97 of 100; `scripts/results/` has those of another seed.
pub const MARGIN: f64 = 1.5;

/// Added to it: rounding of the data, error of the truth, and what is left of errors that change sign between nodes.
pub const FLOOR: f64 = 0.008;

/// Relative errors of radiance (or of R and T) over a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Prediction {
    /// 95th percentile with the margin, the largest of the scene's and of every visible effect's.
    pub error: f64,
    /// Median over the scene.
    pub median: f64,
    /// Largest at any point.
    pub worst: f64,
    /// The effect whose percentile is the largest; absent where it is the scene as a whole.
    pub decided_by: Option<Effect>,
    /// Share of points where the method refuses, the largest of any population.
    pub refused: f64,
}

/// The 95th percentile: the smallest error that at most 5 % of the points exceed.
pub fn percentile(sizes: &mut [f64], share: f64) -> f64 {
    sizes.sort_by(f64::total_cmp);
    let place = libm::ceil(share * sizes.len() as f64) as usize;
    sizes.get(place.saturating_sub(1)).copied().unwrap_or(0.0)
}

/// Of the listed method `place`: with one value for all channels (`grey`) the worst channel counts.
pub(crate) fn predict(data: &Data, points: &Points, place: usize, grey: bool) -> Prediction {
    let (method, column) = (&data.methods()[place], ErrorData::ORDERS.len() + place);
    let mut prediction = Prediction { error: 0.0, median: 0.0, worst: 0.0, decided_by: None, refused: 0.0 };
    for (effect, places) in &points.populations {
        let known: Vec<&Place> = places.iter().filter(|place| !place.nodes.is_empty()).collect();
        let of = |place: &&Place| {
            let size = |error: f64| if grey { place.worst_channel(error) } else { error.abs() };
            answers(method, &place.ask).then(|| data.size(&place.nodes, column, size)).flatten()
        };
        let mut sizes: Vec<f64> = known.iter().filter_map(of).collect();
        let refused = 1.0 - sizes.len() as f64 / known.len().max(1) as f64;
        let error = MARGIN * percentile(&mut sizes, 0.95) + FLOOR;
        if error > prediction.error {
            (prediction.error, prediction.decided_by) = (error, *effect);
        }
        if effect.is_none() {
            prediction.median = percentile(&mut sizes, 0.5);
        }
        prediction.worst = prediction.worst.max(sizes.last().copied().unwrap_or(0.0));
        prediction.refused = prediction.refused.max(refused);
    }
    prediction
}

/// Whether a place lies in the domain that the method declares.
fn answers(method: &ErrorMethod, ask: &Ask) -> bool {
    let mu = |theta: f64| libm::cos(theta.to_radians());
    let radius = ask.effective_radius_um;
    (method.tau_min..=method.tau_max).contains(&ask.tau)
        && mu(ask.theta_l_deg) >= method.mu_l_min
        && mu(ask.theta_v_deg) >= method.mu_v_min
        && method.r_e_min_um.is_none_or(|least| radius >= least)
        && method.r_e_max_um.is_none_or(|most| radius <= most)
}

/// Populations with the nodes round each point, found once for all methods.
pub(crate) struct Points {
    pub(crate) populations: Vec<(Option<Effect>, Vec<Place>)>,
}

/// A point.
pub(crate) struct Place {
    ask: Ask,
    pub(crate) nodes: Vec<(usize, f64)>,
    /// Red and blue over green, less 1; 0 where not known or not asked.
    hues: [f64; 2],
}

impl Place {
    /// Error of the worst channel where green's value serves all: (1+e)/(1+d) - 1.
    fn worst_channel(&self, error: f64) -> f64 {
        let others = self.hues.map(|hue| ((1.0 + error) / (1.0 + hue) - 1.0).abs());
        others.into_iter().fold(error.abs(), f64::max)
    }
}

impl Points {
    pub(crate) fn new(data: &Data, populations: &[Population]) -> Self {
        let place = |block: ErrorBlock, ask: &Ask| Place {
            ask: *ask,
            nodes: data.nodes(block, ask),
            hues: data.hues(block, ask).unwrap_or([0.0; 2]),
        };
        let of = |one: &Population| (one.effect, one.asks.iter().map(|ask| place(one.block, ask)).collect());
        Self { populations: populations.iter().map(of).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_count_from_below() {
        let mut values: Vec<f64> = (1..=100).rev().map(f64::from).collect();
        assert_eq!((percentile(&mut values, 0.95), percentile(&mut values, 0.5)), (95.0, 50.0));
        assert_eq!(percentile(&mut [], 0.95), 0.0);
    }

    fn nowhere() -> Ask {
        Ask {
            effective_radius_um: 7.0,
            tau: 1.0,
            theta_l_deg: 0.0,
            theta_v_deg: 60.0,
            phi_deg: 0.0,
            scattering_deg: 120.0,
            side: stratiform_quantities::Side::Top,
        }
    }

    #[test]
    fn a_method_answers_in_its_domain_alone() {
        let method = crate::choose::tests::method("one");
        assert!(answers(&method, &nowhere()));
        let narrow = ErrorMethod { r_e_min_um: Some(7.0), r_e_max_um: Some(7.0), tau_min: 1.0, ..method };
        assert!(answers(&narrow, &nowhere()));
        assert!(!answers(&narrow, &Ask { effective_radius_um: 7.1, ..nowhere() }));
        assert!(!answers(&narrow, &Ask { tau: 0.99, ..nowhere() }));
        assert!(!answers(&ErrorMethod { mu_v_min: 0.6, ..narrow }, &nowhere()));
    }

    #[test]
    fn a_grey_value_errs_most_where_colours_differ() {
        let (ask, nodes) = (nowhere(), Vec::new());
        let place = Place { ask, nodes, hues: [0.25, -0.2] };
        assert!((place.worst_channel(0.0) - 0.25).abs() < 1e-15);
        assert!((place.worst_channel(0.25) - 0.5625).abs() < 1e-15);
    }
}
