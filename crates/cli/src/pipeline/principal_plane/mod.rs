//! `figures/principal-plane.csv`: reflectance per order in the plane of the sun, from photons, models and solver.
//!
//! Modified medium: local estimates. Full medium: order 1 by local estimates, which its peak does not trouble and few photons
//! settle; later orders in angular bins, 4° wide in θ_v and about 6° to either side of the plane. The model has the fitted parameters
//! and spreads I3+ isotropically, as the paper does.

mod modelled;

use super::cut::Cut;
use super::optics::Cloud;
use super::reference::Media;
use super::{stream_of_hash, trace_error};
use crate::config::{Config, PlaneScene, PrincipalPlaneConfig};
use crate::output::Talk;
use crate::{CliError, interrupt, progress};
use modelled::Models;
use std::path::Path;
use stratiform_artifact::{
    ParametersDocument, PlaneOrder, PlaneSource, PrincipalPlaneRow, create_folder, hash_of, write_csv,
};
use stratiform_model::table::cos_degrees;
use stratiform_quantities::{Medium, Order, Side};
use stratiform_stats::Estimate;
use stratiform_transport::TraceMedium;
use stratiform_transport::radiance::{
    AngularBins, BinRadiance, RadianceRequest, ViewRadiance, trace_radiance, trace_radiance_bins,
};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, View};

/// Largest order by itself.
const ORDERS: u32 = 5;
/// Of the solver's totals; where it is not met, their errors say so.
const TOLERANCE: f64 = 5e-3;
/// Within so many degrees of the glory, and beyond so many ahead, the solver is asked at every angle; elsewhere at every other.
const GLORY: f64 = 6.0;
const AHEAD: f64 = 70.0;
/// Share of the views' photons that settles order 1 of the full medium far better than its bins settle the rest.
const ONCE: u64 = 8;
/// Width of a bin, and |θ_v| of the last edge, degrees.
const WIDTH: u32 = 4;
const LAST: u32 = 88;
/// |φ| between bins, degrees: the same on both sides of the zenith.
const AZIMUTHS: [f64; 11] = [0.0, 6.0, 12.0, 24.0, 48.0, 90.0, 132.0, 156.0, 168.0, 174.0, 180.0];

/// Runs the stage.
///
/// # Errors
/// [`CliError::Interrupted`]; [`CliError::Input`] if a number is out of domain or the file cannot be written.
pub fn write(
    config: &Config,
    settings: &PrincipalPlaneConfig,
    cloud: &Cloud,
    cut: &Cut,
    parameters: &ParametersDocument,
    dir: &Path,
    talk: Talk,
) -> Result<Vec<String>, CliError> {
    const FILE: &str = "figures/principal-plane.csv";
    let media = Media::new(config, cloud)?;
    let models = Models::new(config, cloud, cut, parameters, dir)?;
    let spinner = progress::spinner("principal plane", talk.quiet);
    let mut rows = Vec::new();
    for scene in &settings.scenes {
        let plane = Plane::new(config, cloud, scene);
        let [full, modified] = [Medium::Full, Medium::Modified].map(|medium| media.get(medium));
        plane.modified(&mut rows, modified, settings)?;
        plane.full(&mut rows, full, settings)?;
        plane.solved(&mut rows, full)?;
        rows.extend(models.rows(&plane)?);
    }
    spinner.finish_and_clear();
    create_folder(&dir.join("figures"))?;
    write_csv(&dir.join(FILE), &rows)?;
    Ok(vec![FILE.to_owned()])
}

/// The view at a signed angle.
fn view(theta_v_deg: f64) -> View {
    let phi_deg = if theta_v_deg < 0.0 { 180.0 } else { 0.0 };
    View { side: Side::Top, mu: cos_degrees(theta_v_deg.abs()), phi_deg }
}

/// Signed angles from -`last` to `last` in steps of `step`, shifted by `first`.
fn angles(last: u32, step: u32, first: u32) -> Vec<f64> {
    let positive: Vec<f64> =
        (0..=last).filter(|a| a % step == first).map(f64::from).filter(|a| *a > 0.0).collect();
    let middle = (first == 0).then_some(0.0);
    positive.iter().rev().map(|a| -a).chain(middle).chain(positive.iter().copied()).collect()
}

/// Rows of photons: orders 1…5, the rest, the total.
fn plane_order(order: Order) -> PlaneOrder {
    match order {
        Order::Exactly(n) => PlaneOrder::Exactly(n),
        Order::Tail => PlaneOrder::From(ORDERS + 1),
        Order::Total => PlaneOrder::Total,
    }
}

/// One slab under one sun.
struct Plane {
    scene: PlaneScene,
    mu0: f64,
    tau: f64,
    seed: u64,
}

impl Plane {
    fn new(config: &Config, cloud: &Cloud, scene: &PlaneScene) -> Self {
        Self {
            scene: *scene,
            mu0: cos_degrees(scene.theta_l_deg),
            tau: cloud.extinction_per_m * scene.thickness_m,
            seed: config.transport.seed.unwrap_or_default(),
        }
    }

    fn request(&self, medium: Medium, photons: u64) -> RadianceRequest {
        let stream = stream_of_hash(&hash_of(&(&self.scene, medium)));
        RadianceRequest { tau: self.tau, mu0: self.mu0, photons, max_order: ORDERS, seed: self.seed, stream }
    }

    fn row(
        &self,
        source: PlaneSource,
        medium: Medium,
        theta_v_deg: f64,
        order: PlaneOrder,
        value: Estimate,
    ) -> PrincipalPlaneRow {
        let PlaneScene { theta_l_deg, thickness_m } = self.scene;
        let std_error = matches!(source, PlaneSource::Mc | PlaneSource::Solver).then_some(value.std_error);
        PrincipalPlaneRow {
            medium,
            theta_l_deg,
            thickness_m,
            theta_v_deg,
            order,
            value: value.value,
            std_error,
            source,
        }
    }

    fn at_views(&self, medium: &TraceMedium, angles: &[f64], photons: u64) -> Result<ViewRadiance, CliError> {
        let views: Vec<View> = angles.iter().map(|theta| view(*theta)).collect();
        let (quiet, watch) = (|_: u64, _: u64| (), interrupt::watch());
        let request = self.request(medium.medium(), photons);
        trace_radiance(medium, &request, &views, super::control(&quiet, &watch)).map_err(trace_error)
    }

    fn modified(
        &self,
        rows: &mut Vec<PrincipalPlaneRow>,
        medium: &TraceMedium,
        settings: &PrincipalPlaneConfig,
    ) -> Result<(), CliError> {
        let angles = angles(LAST, 2, 0);
        let traced = self.at_views(medium, &angles, settings.view_photons)?;
        for order in traced.orders() {
            rows.extend(angles.iter().enumerate().map(|(v, theta)| {
                let estimate = traced.estimate(v, order);
                self.row(PlaneSource::Mc, Medium::Modified, *theta, plane_order(order), estimate)
            }));
        }
        Ok(())
    }

    fn full(
        &self,
        rows: &mut Vec<PrincipalPlaneRow>,
        medium: &TraceMedium,
        settings: &PrincipalPlaneConfig,
    ) -> Result<(), CliError> {
        let angles = angles(LAST, WIDTH, WIDTH / 2);
        let once = self.at_views(medium, &angles, (settings.view_photons / ONCE).max(2))?;
        let bins = bins()?;
        let (quiet, watch) = (|_: u64, _: u64| (), interrupt::watch());
        let request = self.request(Medium::Full, settings.full_photons);
        let binned = trace_radiance_bins(medium, &request, &bins, super::control(&quiet, &watch))
            .map_err(trace_error)?;
        for order in binned.orders() {
            for (v, theta) in angles.iter().enumerate() {
                let later = match order {
                    Order::Total => later(&binned, *theta, &LATER),
                    Order::Exactly(1) => Estimate { value: 0.0, std_error: 0.0 },
                    _ => later(&binned, *theta, &[order]),
                };
                let first = match order {
                    Order::Total | Order::Exactly(1) => once.estimate(v, Order::Exactly(1)),
                    _ => Estimate { value: 0.0, std_error: 0.0 },
                };
                let estimate = Estimate {
                    value: first.value + later.value,
                    std_error: libm::hypot(first.std_error, later.std_error),
                };
                rows.push(self.row(PlaneSource::Mc, Medium::Full, *theta, plane_order(order), estimate));
            }
        }
        Ok(())
    }

    fn solved(&self, rows: &mut Vec<PrincipalPlaneRow>, medium: &TraceMedium) -> Result<(), CliError> {
        let glory = -self.scene.theta_l_deg;
        let steep = |theta: f64| (theta - glory).abs() <= GLORY || theta > AHEAD;
        let asked = |theta: &f64| theta % f64::from(WIDTH) == 0.0 || steep(*theta);
        let angles: Vec<f64> = angles(LAST, 2, 0).into_iter().filter(asked).collect();
        let views: Vec<View> = angles.iter().map(|theta| view(*theta)).collect();
        let solver = RadianceSolver::new(SolveMedium::from(medium), TOLERANCE).map_err(trace_error)?;
        let solved = solver
            .radiance_as_reached(RadianceOrder::Total, &[self.tau], &[self.mu0], &views)
            .map_err(trace_error)?;
        rows.extend(angles.iter().enumerate().map(|(v, theta)| {
            let estimate = solved.estimate(0, 0, v, RadianceOrder::Total);
            self.row(PlaneSource::Solver, Medium::Full, *theta, PlaneOrder::Total, estimate)
        }));
        Ok(())
    }
}

/// Orders of photons that are counted in bins.
const LATER: [Order; 5] =
    [Order::Exactly(2), Order::Exactly(3), Order::Exactly(4), Order::Exactly(5), Order::Tail];

/// Bins between multiples of 4°.
fn bins() -> Result<AngularBins, CliError> {
    let edges = (0..=LAST / WIDTH).rev().map(|k| cos_degrees(f64::from(k * WIDTH))).collect();
    AngularBins::new(edges, AZIMUTHS.to_vec()).map_err(trace_error)
}

/// `orders` round the signed angle `theta`, over azimuths that reach about 6° to either side of the plane.
fn later(binned: &BinRadiance, theta: f64, orders: &[Order]) -> Estimate {
    let (mus, phis) = binned.bins().shape();
    let mu = mus - 1 - (theta.abs() / f64::from(WIDTH)) as usize;
    let sine = libm::sin(theta.abs().to_radians());
    let count = (1..phis / 2).find(|k| AZIMUTHS[*k] * sine >= 5.5).unwrap_or(phis / 2);
    let phi = if theta < 0.0 { phis - count..phis } else { 0..count };
    binned.estimate_over(Side::Top, mu, phi, orders)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_signed_and_even() {
        assert_eq!(angles(4, 2, 0), [-4.0, -2.0, 0.0, 2.0, 4.0]);
        assert_eq!(angles(8, 4, 2), [-6.0, -2.0, 2.0, 6.0]);
    }

    /// Every bin that is looked up has the angle in its middle, on its side of the zenith.
    #[test]
    fn bins_lie_round_their_angle() {
        let bins = bins().unwrap();
        assert_eq!(bins.shape(), (22, 10));
        assert_eq!(angles(LAST, WIDTH, WIDTH / 2).len(), 44);
    }
}
