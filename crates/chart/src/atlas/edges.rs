//! One step beyond each end of each declared range: a method must refuse.

use super::clouds::{CloudAt, Phases};
use stratiform_methods::{Card, FluxPoint, Method, Point, Ready};
use stratiform_quantities::{Range, Side};

/// What no range includes.
const NEVER: [f64; 4] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0];

/// The nearest numbers outside of a range, and those that no range includes.
fn outside(range: Range) -> Vec<f64> {
    let step = |end: f64, by: f64| end + by * (1e-9 * end.abs()).max(1e-12);
    let ends = [(range.min, range.min_included, -1.0), (range.max, range.max_included, 1.0)];
    let beyond = ends.map(|(end, included, by)| if included { step(end, by) } else { end });
    beyond.into_iter().chain(NEVER).collect()
}

/// The middle of a range as numbers of inputs go.
fn inside(range: Range, wanted: f64) -> f64 {
    if range.contains(wanted) { wanted } else { range.min.midpoint(range.max) }
}

/// What a method answers although it lies outside of its declared domain; nothing, of a method that is in order.
pub fn answered_outside(method: &dyn Method, phases: &Phases, at: CloudAt) -> Vec<String> {
    let card = method.card();
    let mut answered = clouds_outside(method, phases, at);
    let cloud = phases.cloud(CloudAt { omega: inside(card.domain.omega, at.omega), ..at });
    if let Ok(ready) = cloud.map_err(drop).and_then(|cloud| method.prepare(&cloud).map_err(drop)) {
        answered.extend(points_outside(card, &*ready));
    }
    answered
}

/// ω and r_e beyond their ranges. A cloud that cannot be made cannot be asked about.
fn clouds_outside(method: &dyn Method, phases: &Phases, at: CloudAt) -> Vec<String> {
    let domain = &method.card().domain;
    let omegas = outside(domain.omega).into_iter().map(|omega| CloudAt { omega, ..at });
    let made = omegas.filter_map(|at| Some((format!("omega = {}", at.omega), phases.cloud(at).ok()?)));
    let radii = outside(domain.r_eff_um).into_iter().filter(|radius| *radius > 0.0);
    let relabelled = radii.filter_map(|radius| {
        let cloud = phases.relabelled(at, radius).ok()?;
        Some((format!("r_eff_um = {radius}"), cloud))
    });
    let answered = made.chain(relabelled).filter(|(_, cloud)| method.prepare(cloud).is_ok());
    answered.map(|(what, _)| what).collect()
}

fn points_outside(card: &Card, ready: &dyn Ready) -> Vec<String> {
    let domain = &card.domain;
    let middle = Point {
        tau: inside(domain.tau, 5.0),
        mu_l: inside(domain.mu_l, 0.5),
        mu_v: inside(domain.mu_v, 0.5),
        phi_deg: 90.0,
        side: Side::Top,
    };
    let taus = outside(domain.tau).into_iter().map(|tau| ("tau", tau, Point { tau, ..middle }));
    let suns = outside(domain.mu_l).into_iter().map(|mu_l| ("mu_l", mu_l, Point { mu_l, ..middle }));
    let views = outside(domain.mu_v).into_iter().map(|mu_v| ("mu_v", mu_v, Point { mu_v, ..middle }));
    let turns = [f64::NAN, f64::INFINITY, 361.0, -361.0];
    let turned = turns.into_iter().map(|phi_deg| ("phi_deg", phi_deg, Point { phi_deg, ..middle }));
    let mut answered = Vec::new();
    for (name, value, point) in taus.chain(suns).chain(views).chain(turned) {
        for side in Side::BOTH {
            if ready.radiances(&[Point { side, ..point }]).is_ok() {
                answered.push(format!("{name} = {value}, radiance {side}"));
            }
        }
        let flux = FluxPoint { tau: point.tau, mu_l: point.mu_l };
        if matches!(name, "tau" | "mu_l") && ready.fluxes(&[flux]).is_ok() {
            answered.push(format!("{name} = {value}, flux"));
        }
    }
    answered
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_leave_the_range() {
        for range in
            [Range::closed(0.0, 1e6), Range::open(0.0, 1.0), Range::above(0.0), Range::closed(7.0, 7.0)]
        {
            assert!(outside(range).iter().all(|value| !range.contains(*value)), "{range}");
        }
        assert_eq!(inside(Range::closed(10.0, 20.0), 5.0), 15.0);
    }
}
