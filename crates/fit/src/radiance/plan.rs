//! Where reference radiances are asked for: spread evenly over θ_l, θ_v, φ and ln τ.
//!
//! θ_l and τ form grids, because the solver shares work between thicknesses and between views of one sun; θ_v and φ follow
//! the additive sequence of the plastic number (Roberts 2018), n·(1/ρ, 1/ρ²) mod 1 with ρ³ = ρ + 1, over all suns.
//! Another start of the sequence, with θ_l and τ in mid-grid, gives points that are never fitted.

use super::RadianceConfig;
use stratiform_artifact::RadianceSample;
use stratiform_model::angular::Sight;
use stratiform_quantities::Side;

/// 1/ρ and 1/ρ².
const STEP: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];

/// Which points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Draw {
    /// Those that are fitted.
    Fitted,
    /// Others, in the range where the model's error is stated: half as many thicknesses, suns and views.
    Check,
}

/// A range of points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadianceDraw {
    /// Optical thickness: smallest, largest.
    pub tau: [f64; 2],
    /// Largest θ_l and θ_v, degrees.
    pub up_to_deg: f64,
}

/// The range of stratocumulus in which errors are stated.
pub const STRATOCUMULUS: RadianceDraw = RadianceDraw { tau: [1.0, 50.0], up_to_deg: 80.0 };

/// One θ_l and its views.
#[derive(Clone, Debug, PartialEq)]
pub struct SunViews {
    /// μ_l.
    pub mu_l: f64,
    /// Face, μ_v, φ in degrees.
    pub views: Vec<(Side, f64, f64)>,
}

/// All thicknesses are asked for at every sun and view.
#[derive(Clone, Debug, PartialEq)]
pub struct RadiancePlan {
    /// What the points span.
    pub sample: RadianceSample,
    /// Optical thicknesses of the full medium.
    pub tau: Vec<f64>,
    /// Suns with their views.
    pub suns: Vec<SunViews>,
}

impl RadiancePlan {
    /// The points of `config`, which was checked.
    pub fn new(config: &RadianceConfig, draw: Draw) -> Self {
        let (range, counts, offset) = match draw {
            Draw::Fitted => {
                let range =
                    RadianceDraw { tau: [config.tau_min, config.tau_max], up_to_deg: config.up_to_deg };
                (range, [config.tau_count, config.suns, config.views], 0.0)
            }
            Draw::Check => {
                let half = |count: usize| count.div_ceil(2);
                (STRATOCUMULUS, [config.tau_count, config.suns, config.views].map(half), 0.5)
            }
        };
        let [taus, suns, views] = counts;
        let sun = |i: usize| {
            SunViews::new(range.up_to_deg * place(i, suns, offset), i * views, views, config, &range, draw)
        };
        let [low, high] = range.tau.map(libm::log);
        let tau = |i| libm::exp(low + (high - low) * place(i, taus, offset));
        Self {
            sample: RadianceSample {
                tau: range.tau,
                theta_deg: [0.0, range.up_to_deg],
                aureole_deg: config.aureole_deg,
            },
            tau: (0..taus).map(tau).collect(),
            suns: (0..suns).map(sun).collect(),
        }
    }
}

/// Place i of n in \[0, 1\]: with both ends at offset 0, in the middle of n cells at ½.
fn place(i: usize, n: usize, offset: f64) -> f64 {
    (i as f64 + offset) / (n as f64 - 1.0 + 2.0 * offset)
}

impl SunViews {
    fn new(
        theta_l_deg: f64,
        first: usize,
        count: usize,
        config: &RadianceConfig,
        range: &RadianceDraw,
        draw: Draw,
    ) -> Self {
        let mu_l = libm::cos(theta_l_deg.to_radians());
        let start = if draw == Draw::Fitted { 0.5 } else { 0.123 };
        let mut views = Vec::new();
        for n in first..first + count {
            let [a, b] = STEP.map(|step| (start + n as f64 * step).fract());
            let (mu_v, phi_deg) = (libm::cos((range.up_to_deg * a).to_radians()), 180.0 * b);
            for side in Side::BOTH {
                if !in_aureole(mu_l, mu_v, phi_deg, side, config.aureole_deg) {
                    views.push((side, mu_v, phi_deg));
                }
            }
        }
        Self { mu_l, views }
    }
}

fn in_aureole(mu_l: f64, mu_v: f64, phi_deg: f64, side: Side, aureole_deg: f64) -> bool {
    let rim = 1.0 - libm::cos(aureole_deg.to_radians());
    side == Side::Bottom && Sight::new(mu_l, mu_v, phi_deg, side).is_ok_and(|sight| sight.v < rim)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_span_their_range_and_are_not_drawn_twice() {
        let config = RadianceConfig::default();
        let [fitted, check] = [Draw::Fitted, Draw::Check].map(|draw| RadiancePlan::new(&config, draw));
        assert!((fitted.tau[0] / 0.1 - 1.0).abs() < 1e-12 && (fitted.tau[12] / 300.0 - 1.0).abs() < 1e-12);
        assert!(check.tau.iter().all(|tau| *tau > 1.0 && *tau < 50.0));
        assert_eq!([fitted.suns.len(), check.suns.len()], [12, 6]);
        let views =
            |plan: &RadiancePlan| plan.suns.iter().flat_map(|sun| sun.views.clone()).collect::<Vec<_>>();
        let (fitted, check) = (views(&fitted), views(&check));
        assert!(check.iter().all(|view| !fitted.contains(view)));
        assert!(fitted.len() > 2 * 12 * 24 - 10);
    }
}
