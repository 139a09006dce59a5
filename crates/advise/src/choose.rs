//! The choice.

use crate::cover::{Population, fluxes, populations};
use crate::predict::{Points, predict};
use crate::{Advice, AdviseError, Bounce, Budget, Channels, Data, Prediction, Rejected};
use crate::{emitted, extent};
use std::cmp::Ordering;
use stratiform_artifact::ErrorMethod;
use stratiform_scene::{Effect, Ground, Interval, Scene};

/// ρ where the scene's ground is seen and nobody says: grass and soil.
const GROUND_ALBEDO: f64 = 0.2;

/// A method in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Its record.
    pub method: ErrorMethod,
    /// One value for all channels, or one each.
    pub channels: Channels,
    /// What it promises.
    pub prediction: Prediction,
    /// Nanoseconds for a pixel.
    pub ns: f64,
    /// Tables of all channels.
    pub table_bytes: u64,
}

impl Candidate {
    fn meets(&self, budget: &Budget) -> bool {
        budget.allows_error(self.prediction.error)
            && budget.allows_ns(self.ns)
            && self.prediction.refused == 0.0
    }

    /// Cheaper first; among equals smaller tables, then smaller errors.
    fn by_cost(&self, other: &Self) -> Ordering {
        let cost = |one: &Self| (one.ns, one.table_bytes as f64, one.prediction.error);
        let ([a, b], [c, d], [e, f]) = {
            let (x, y) = (cost(self), cost(other));
            ([x.0, y.0], [x.1, y.1], [x.2, y.2])
        };
        a.total_cmp(&b).then(c.total_cmp(&d)).then(e.total_cmp(&f))
    }

    /// What refuses nothing first, then smaller errors, then cheaper.
    fn by_error(&self, other: &Self) -> Ordering {
        let refused = self.prediction.refused.total_cmp(&other.prediction.refused);
        refused.then(self.prediction.error.total_cmp(&other.prediction.error)).then(self.by_cost(other))
    }
}

/// Every listed method that gives radiances, in the order of the data, in grey and in colours.
///
/// # Errors
/// [`AdviseError`] if the scene is not covered by the data.
pub fn candidates(data: &Data, scene: &Scene, tau: Interval) -> Result<Vec<Candidate>, AdviseError> {
    data.check(scene, tau)?;
    Ok(weigh(data, &Points::new(data, &populations(scene, tau).0), scene.wavelengths_um.len()))
}

/// Each method twice: one value for all channels, and one each; once where there is one wavelength.
fn weigh(data: &Data, points: &Points, wavelengths: usize) -> Vec<Candidate> {
    let listed = data.methods().iter().zip(0..);
    let mut all = Vec::new();
    for (method, column) in listed {
        let Some(ns) = method.ns else { continue };
        for (channels, count) in [(Channels::Grey, 1), (Channels::Rgb, wavelengths)] {
            if channels == Channels::Grey || wavelengths > 1 {
                let prediction = predict(data, points, column, channels == Channels::Grey && wavelengths > 1);
                let table_bytes = count as u64 * method.table_bytes.unwrap_or(0);
                let method = method.clone();
                all.push(Candidate { method, channels, prediction, ns: count as f64 * ns, table_bytes });
            }
        }
    }
    all
}

/// What to use for `scene`, whose optical thickness runs over `tau`; `ground_albedo`, or else the scene's own, counts where the ground's
/// light is seen.
///
/// # Errors
/// [`AdviseError::Domain`] if the scene is not covered by the data or the albedo is none. A budget that nothing meets is no error:
/// [`Advice::met`] says so.
pub fn advise(
    data: &Data,
    scene: &Scene,
    tau: Interval,
    budget: &Budget,
    ground_albedo: Option<f64>,
) -> Result<Advice, AdviseError> {
    data.check(scene, tau)?;
    let (populations, unseen) = populations(scene, tau);
    let points = Points::new(data, &populations);
    let bounce = bounce(data, scene, tau, budget, ground_albedo)?;
    let extra = bounce.as_ref().map_or(0.0, |bounce| bounce.ns);
    let mut all = weigh(data, &points, scene.wavelengths_um.len());
    all.iter_mut().for_each(|one| one.ns += extra);
    let chosen = choose(&all, budget)
        .ok_or_else(|| AdviseError::Missing { block: "methods of radiance".to_owned() })?;
    let met = chosen.meets(budget) && bounce.as_ref().is_none_or(|bounce| budget.allows_error(bounce.error));
    let allowed = budget.max_error.unwrap_or(chosen.prediction.error);
    let stem = emitted::stem(&chosen.method.name);
    let looked_up = chosen.method.texels.is_some();
    let phase_radii_um =
        if looked_up { extent::radii(data, scene, &populations[0], allowed) } else { Vec::new() };
    let fitted = emitted::is_refitted(stem);
    let parameter_radii_um = if fitted { extent::parameter_radii(scene, allowed) } else { Vec::new() };
    let tables = phase_radii_um.len().max(1) as u64;
    Ok(Advice {
        schema: "stratiform/advice/1".to_owned(),
        title: scene.title.clone(),
        budget: *budget,
        met,
        method: chosen.method.name.clone(),
        method_title: chosen.method.title.clone(),
        channels: chosen.channels,
        prediction: chosen.prediction.clone(),
        ns: chosen.ns,
        table_bytes: chosen.method.table_bytes.map(|_| tables * chosen.table_bytes),
        phase_texels: chosen.method.texels,
        orders: extent::orders(data, &points, allowed),
        emitted: emitted::emitted(&chosen.method.name),
        phase_radii_um,
        parameter_radii_um,
        theta_l_nodes_deg: if fitted { extent::suns(data, scene, tau, allowed) } else { Vec::new() },
        bounce,
        notes: data.notes(scene, &unseen).into_iter().chain(halo_note(chosen)).collect(),
        rejected: rejected(data, &all, chosen, budget),
    })
}

/// Where what the method leaves out round the sun decides.
fn halo_note(chosen: &Candidate) -> Option<String> {
    let decides = chosen.prediction.decided_by == Some(Effect::SilverLining);
    let without = emitted::emitted(&chosen.method.name).is_some() && !chosen.method.name.contains("halo");
    let note = "light that met forward events only is left out of this method: stratiform_halo.* adds it, with what error the data do not say";
    (decides && without).then(|| note.to_owned())
}

/// The cheapest that meets the budget; with a cost alone the most accurate within it; else what comes nearest.
fn choose<'a>(all: &'a [Candidate], budget: &Budget) -> Option<&'a Candidate> {
    let meeting = all.iter().filter(|one| one.meets(budget));
    let best = match budget.max_error {
        Some(_) => meeting.min_by(|a, b| a.by_cost(b)),
        None => meeting.min_by(|a, b| a.by_error(b)),
    };
    let answering = || all.iter().filter(|one| one.prediction.refused == 0.0);
    let within = || answering().filter(|one| budget.allows_ns(one.ns)).min_by(|a, b| a.by_error(b));
    let cheapest = || answering().min_by(|a, b| a.by_cost(b)).or(all.iter().min_by(|a, b| a.by_error(b)));
    best.or_else(within).or_else(cheapest)
}

fn rejected(data: &Data, all: &[Candidate], chosen: &Candidate, budget: &Budget) -> Vec<Rejected> {
    let others = data.methods().iter().filter(|method| method.name != chosen.method.name);
    let of = |method: &ErrorMethod| {
        let own = all.iter().filter(|one| one.method.name == method.name);
        let best = own.clone().filter(|one| one.meets(budget)).min_by(|a, b| a.by_cost(b));
        let Some(one) = best.or_else(|| own.min_by(|a, b| a.by_error(b))) else {
            let reason = "gives no radiance".to_owned();
            return Rejected { method: method.name.clone(), error: None, ns: None, reason };
        };
        let error = Some(one.prediction.error).filter(|_| one.prediction.refused < 1.0);
        let ns = Some(one.ns);
        Rejected { method: method.name.clone(), error, ns, reason: reason(one, chosen, budget) }
    };
    others.map(of).collect()
}

fn reason(one: &Candidate, chosen: &Candidate, budget: &Budget) -> String {
    let refused = one.prediction.refused;
    if refused >= 1.0 {
        return "refuses the scene".to_owned();
    }
    if refused > 0.0 {
        return format!("refuses {:.0} % of the scene", (100.0 * refused).max(1.0));
    }
    if budget.max_error.is_some_and(|most| one.prediction.error > most) {
        return "error over the budget".to_owned();
    }
    if budget.max_ns.is_some_and(|most| one.ns > most) {
        return "cost over the budget".to_owned();
    }
    let why = match one.ns.total_cmp(&chosen.ns) {
        _ if budget.max_error.is_none() => "larger error",
        Ordering::Greater => "dearer",
        _ if one.table_bytes > chosen.table_bytes => "larger tables",
        _ => "no better at that cost",
    };
    why.to_owned()
}

/// The cheapest method of R and T within the budget, or the most accurate, and how often light goes to and fro.
fn bounce(
    data: &Data,
    scene: &Scene,
    tau: Interval,
    budget: &Budget,
    ground_albedo: Option<f64>,
) -> Result<Option<Bounce>, AdviseError> {
    let own = scene.ground.as_ref().and_then(Ground::mean_albedo);
    let ground_albedo = ground_albedo.or(own).unwrap_or(GROUND_ALBEDO);
    stratiform_quantities::Range::closed(0.0, 1.0).check("ground albedo", ground_albedo)?;
    if !scene.visible.contains(&Effect::GroundBounce) {
        return Ok(None);
    }
    let everywhere: Population = fluxes(scene, tau, data.flux_suns().last().copied().unwrap_or(0.0));
    let points = Points::new(data, &[everywhere]);
    let listed = data.methods().iter().zip(0..);
    let given: Vec<(&ErrorMethod, f64, f64)> = listed
        .filter_map(|(method, column)| {
            let prediction = predict(data, &points, column, false);
            (prediction.refused == 0.0).then_some((method, prediction.error, method.flux_ns?))
        })
        .collect();
    let cheap = given.iter().filter(|one| budget.max_error.is_some() && budget.allows_error(one.1));
    let chosen = cheap.min_by(|a, b| a.2.total_cmp(&b.2).then(a.1.total_cmp(&b.1)));
    let Some((method, error, ns)) = chosen.or_else(|| given.iter().min_by(|a, b| a.1.total_cmp(&b.1))) else {
        return Err(AdviseError::Missing { block: "methods of fluxes".to_owned() });
    };
    let cloud_albedo = extent::diffuse_albedo(data, scene, tau);
    let passes = extent::passes(ground_albedo * cloud_albedo, budget.max_error.unwrap_or(*error));
    Ok(Some(Bounce {
        method: method.name.clone(),
        error: *error,
        ns: *ns,
        ground_albedo,
        cloud_albedo,
        passes,
    }))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// A method that answers everywhere.
    pub(crate) fn method(name: &str) -> ErrorMethod {
        ErrorMethod {
            name: name.to_owned(),
            title: name.to_owned(),
            radiance: true,
            flux: false,
            ns: Some(1.0),
            flux_ns: None,
            table_bytes: Some(0),
            texels: None,
            tau_min: 0.0,
            tau_max: 1e6,
            mu_l_min: 0.0,
            mu_v_min: 0.0,
            r_e_min_um: None,
            r_e_max_um: None,
        }
    }

    fn candidate(name: &str, error: f64, ns: f64, table_bytes: u64, refused: f64) -> Candidate {
        let method = ErrorMethod { ns: Some(ns), table_bytes: Some(table_bytes), ..method(name) };
        let prediction = Prediction { error, median: error, worst: error, decided_by: None, refused };
        Candidate { method, channels: Channels::Grey, prediction, ns, table_bytes }
    }

    #[test]
    fn the_cheapest_is_chosen_then_the_smallest_and_never_one_that_refuses() {
        let all = [
            candidate("refuses", 0.01, 1.0, 0, 0.1),
            candidate("rough", 0.3, 2.0, 0, 0.0),
            candidate("big", 0.05, 10.0, 4096, 0.0),
            candidate("small", 0.08, 10.0, 256, 0.0),
            candidate("best", 0.01, 50.0, 0, 0.0),
        ];
        let name = |max_error, max_ns| {
            let budget = Budget::new(max_error, max_ns).unwrap();
            let chosen = choose(&all, &budget).unwrap();
            (chosen.method.name.as_str(), chosen.meets(&budget))
        };
        assert_eq!(name(Some(0.1), None), ("small", true));
        assert_eq!(name(Some(0.06), None), ("big", true));
        assert_eq!(name(Some(0.5), None), ("rough", true));
        assert_eq!(name(None, Some(20.0)), ("big", true));
        assert_eq!(name(Some(0.001), None), ("best", false));
        assert_eq!(name(Some(0.02), Some(20.0)), ("big", false));
        assert_eq!(name(None, Some(1.0)), ("rough", false));
    }
}
