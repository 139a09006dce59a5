//! Errors of every method at the nodes of one cloud.

use super::known::Known;
use super::listed::Listed;
use super::truth::{self, TOLERANCE, Truth};
use super::{ErrorsError, Nodes};
use stratiform_artifact::{ErrorBlock, ErrorRow};
use stratiform_methods::{Cloud, FluxPoint, MethodError, Point, Ready};
use stratiform_quantities::{Incidence, Side};
use stratiform_transport::solve::{RadianceSolver, SolveMedium, Solver};

/// Of R and T, absolute.
const FLUX_TOLERANCE: f64 = 1e-6;

/// Radiances of every lattice, then fluxes.
pub(super) fn of_cloud(
    nodes: &Nodes,
    radius: f64,
    cloud: &Cloud,
    methods: &[Listed],
    known: &Known,
) -> Result<Vec<ErrorRow>, ErrorsError> {
    let mut rows = radiances(nodes, radius, cloud, known)?;
    let points: Vec<Point> = rows.iter().map(|(row, _)| point(row)).collect();
    let mut fluxes = fluxes(nodes, radius, cloud)?;
    let places: Vec<FluxPoint> = fluxes.iter().map(flux_point).collect();
    for (row, truth) in &mut rows {
        row.values = match truth {
            Some((_, orders)) => orders.map(|share| Some(per_mille(share))).to_vec(),
            None => vec![None; 2],
        };
    }
    fluxes.iter_mut().for_each(|row| row.values = vec![None; 2]);
    for Listed { method, .. } in methods {
        let ready = method.prepare(cloud).ok();
        let (seen, flown) = (
            ready.as_deref().filter(|_| method.card().radiance),
            ready.as_deref().filter(|_| method.card().flux),
        );
        let seen = answers(seen, &points, |ready, points| ready.radiances(points));
        for ((row, _), answer) in rows.iter_mut().zip(seen) {
            row.values.push(row.truth.and_then(|truth| Some(error(answer?.value, truth))));
        }
        let flown = answers(flown, &places, |ready, points| ready.fluxes(points));
        for (row, answer) in fluxes.iter_mut().zip(flown) {
            let value = answer.map(|pair| match row.side {
                Side::Top => pair.reflectance.value,
                Side::Bottom => pair.transmittance.value,
            });
            row.values.push(row.truth.and_then(|truth| Some(error(value?, truth))));
        }
    }
    Ok(rows.into_iter().map(|(row, _)| row).chain(fluxes).collect())
}

/// An answer or a refusal for each point: all asked together, or, where that is refused, each alone.
fn answers<P, T: Copy>(
    ready: Option<&dyn Ready>,
    points: &[P],
    ask: impl Fn(&dyn Ready, &[P]) -> Result<Vec<T>, MethodError>,
) -> Vec<Option<T>> {
    let Some(ready) = ready else { return points.iter().map(|_| None).collect() };
    let alone = |point| ask(ready, std::slice::from_ref(point)).ok()?.first().copied();
    match ask(ready, points) {
        Ok(values) => values.into_iter().map(Some).collect(),
        Err(_) => points.iter().map(alone).collect(),
    }
}

/// Rows of radiances with their truth, without values; solved where it is not `known`.
pub(super) fn radiances(
    nodes: &Nodes,
    radius: f64,
    cloud: &Cloud,
    known: &Known,
) -> Result<Vec<(ErrorRow, Truth)>, ErrorsError> {
    let medium = SolveMedium::full(cloud.phase().clone(), cloud.omega());
    let solver = RadianceSolver::new(medium, TOLERANCE)?;
    let mut rows = Vec::new();
    for theta_l in &nodes.theta_l_deg {
        for views in nodes.views(*theta_l) {
            let empty = nodes.tau.iter().flat_map(|tau| views.iter().map(|sight| sight.row(radius, *tau)));
            let empty: Vec<ErrorRow> = empty.collect();
            let truths = match known.truths(&empty) {
                Some(truths) => truths,
                None => truth::of_sun(&solver, &nodes.tau, *theta_l, &views)?,
            };
            let with = |(row, truth): (ErrorRow, Truth)| {
                (ErrorRow { truth: truth.map(|(total, _)| rounded(total)), ..row }, truth)
            };
            rows.extend(empty.into_iter().zip(truths).map(with));
        }
    }
    Ok(rows)
}

fn fluxes(nodes: &Nodes, radius: f64, cloud: &Cloud) -> Result<Vec<ErrorRow>, ErrorsError> {
    let solver = Solver::new(SolveMedium::full(cloud.phase().clone(), cloud.omega()), FLUX_TOLERANCE)?;
    let suns = &nodes.flux_theta_l_deg;
    let beam = |theta: &f64| Incidence::beam(libm::cos(theta.to_radians())).map_err(MethodError::from);
    let beams: Vec<Incidence> = suns.iter().map(beam).collect::<Result<_, _>>()?;
    let solved = solver.totals(&nodes.tau, &beams)?;
    let mut rows = Vec::new();
    for (sun, theta_l) in suns.iter().enumerate() {
        for (place, tau) in nodes.tau.iter().enumerate() {
            let (reflectance, transmittance) = solved.total(sun, place);
            for (side, truth) in Side::BOTH.into_iter().zip([reflectance.value, transmittance.value]) {
                rows.push(ErrorRow {
                    block: ErrorBlock::Flux,
                    effective_radius_um: radius,
                    tau: *tau,
                    theta_l_deg: *theta_l,
                    theta_v_deg: 0.0,
                    phi_deg: 0.0,
                    scattering_deg: 0.0,
                    side,
                    truth: (truth > 0.0).then(|| rounded(truth)),
                    values: Vec::new(),
                });
            }
        }
    }
    Ok(rows)
}

/// The point of a row.
pub(super) fn point(row: &ErrorRow) -> Point {
    let mu = |theta: f64| libm::cos(theta.to_radians());
    Point {
        tau: row.tau,
        mu_l: mu(row.theta_l_deg),
        mu_v: mu(row.theta_v_deg),
        phi_deg: row.phi_deg,
        side: row.side,
    }
}

/// The same for a row of fluxes.
pub(super) fn flux_point(row: &ErrorRow) -> FluxPoint {
    FluxPoint { tau: row.tau, mu_l: libm::cos(row.theta_l_deg.to_radians()) }
}

/// Five digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.4e}").parse().unwrap_or(value)
}

fn error(value: f64, truth: f64) -> i32 {
    per_mille(value / truth - 1.0)
}

/// Whole per mille; what is larger than the largest, or no number, is written as that.
pub(super) fn per_mille(share: f64) -> i32 {
    let largest = f64::from(ErrorRow::LARGEST);
    let value = (1000.0 * share).round();
    if value.is_nan() { ErrorRow::LARGEST } else { value.clamp(-largest, largest) as i32 }
}
