//! Two rungs compared at the same points: root mean square, worst, and where the worst is.

use crate::CliError;
use crate::pipeline::fluxes::light;
use stratiform_artifact::{LadderRow, RowIncidence};
use stratiform_codegen::{QUANTITIES, ReferencePoint};

/// One incidence and thickness.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Angle or diffuse.
    pub row: RowIncidence,
    /// Optical thickness of the full medium.
    pub tau: f64,
}

/// Fluxes in the order of [`QUANTITIES`].
pub type Nine = [f64; 9];

/// Every thickness at every row.
pub fn places(rows: &[RowIncidence], tau: &[f64]) -> Vec<Place> {
    rows.iter().flat_map(|row| tau.iter().map(|tau| Place { row: row.clone(), tau: *tau })).collect()
}

/// Values and errors of the reference points at some places, in the order of [`QUANTITIES`].
pub struct Fluxes {
    /// Of each quantity, whether it is known at every place; 0 stands for what is not.
    pub known: [bool; 9],
    /// Place by place.
    pub values: Vec<Nine>,
    /// Place by place.
    pub errors: Vec<Nine>,
}

/// The reference points at `places`.
///
/// # Errors
/// [`CliError::Input`] if a place is missing, or has other quantities than the first one.
pub fn at(places: &[Place], points: &[ReferencePoint]) -> Result<Fluxes, CliError> {
    let mut fluxes = Fluxes { known: [false; 9], values: Vec::new(), errors: Vec::new() };
    let mut groups = points.chunk_by(|a, b| (a.incidence, a.tau) == (b.incidence, b.tau));
    for place in places {
        let (incidence, tau) = (light(&place.row)?, place.tau);
        // Files have the places in this order, perhaps with others between.
        let group = groups.find(|group| group[0].incidence == incidence && group[0].tau.get() == tau);
        let group = group.unwrap_or_default();
        let nine = QUANTITIES.map(|quantity| group.iter().find(|point| point.quantity == quantity));
        let known = nine.map(|point| point.is_some());
        if group.is_empty() || !fluxes.values.is_empty() && known != fluxes.known {
            return Err(CliError::Input(format!(
                "reference.csv lacks fluxes at theta_l = {}, tau = {tau}",
                place.row
            )));
        }
        fluxes.known = known;
        fluxes.values.push(nine.map(|point| point.map_or(0.0, |point| point.value)));
        fluxes.errors.push(nine.map(|point| point.map_or(0.0, |point| point.std_error)));
    }
    Ok(fluxes)
}

/// The step from one rung to the next.
pub struct Step<'a> {
    /// Name of the upper rung.
    pub rung: &'static str,
    /// Where both are compared.
    pub places: &'a [Place],
    /// The rung before.
    pub before: &'a [Nine],
    /// The rung.
    pub after: &'a [Nine],
    /// Standard errors of the difference, if there is chance in it.
    pub chance: Option<&'a [Nine]>,
    /// Quantities that both rungs have.
    pub known: [bool; 9],
    /// What measured it.
    pub note: String,
}

impl Step<'_> {
    /// Rows of every quantity, up to 80 degrees and for all points.
    pub fn rows(&self) -> Vec<LadderRow> {
        const STEEP_DEG: f64 = 80.0;
        let steep = |place: &Place| place.row.degrees().is_some_and(|degrees| degrees <= STEEP_DEG);
        let steep: Vec<usize> = (0..self.places.len()).filter(|i| steep(&self.places[*i])).collect();
        let all: Vec<usize> = (0..self.places.len()).collect();
        let mut rows = Vec::new();
        for (angles, chosen) in [(LadderRow::TO_80, steep), (LadderRow::ALL, all)] {
            for (i, quantity) in QUANTITIES.iter().enumerate() {
                if self.known[i] && LadderRow::QUANTITIES.contains(quantity) {
                    rows.extend(self.row(angles, quantity, i, &chosen));
                }
            }
        }
        rows
    }

    fn row(&self, angles: &str, quantity: &str, i: usize, chosen: &[usize]) -> Option<LadderRow> {
        let loss = |k: usize| (self.after[k][i] - self.before[k][i]).abs();
        let worst = chosen.iter().copied().max_by(|a, b| loss(*a).total_cmp(&loss(*b)))?;
        Some(LadderRow {
            rung: self.rung.to_owned(),
            angles: angles.to_owned(),
            quantity: quantity.to_owned(),
            rms: Some(root_mean_square(chosen.iter().map(|k| loss(*k)))),
            worst: Some(loss(worst)),
            worst_theta_l_deg: self.places[worst].row.to_string(),
            worst_tau: Some(self.places[worst].tau),
            points: chosen.len() as u64,
            expected_rms: self.chance.map(|errors| root_mean_square(chosen.iter().map(|k| errors[*k][i]))),
            note: self.note.clone(),
        })
    }
}

/// The row of a rung that could not be measured.
pub fn not_measured(rung: &str, reason: &str) -> LadderRow {
    LadderRow {
        rung: rung.to_owned(),
        angles: LadderRow::ALL.to_owned(),
        quantity: String::new(),
        rms: None,
        worst: None,
        worst_theta_l_deg: String::new(),
        worst_tau: None,
        points: 0,
        expected_rms: None,
        note: format!("not measured: {reason}"),
    }
}

fn root_mean_square(values: impl Iterator<Item = f64>) -> f64 {
    let (count, sum) = values.fold((0.0, 0.0), |(count, sum), x| (count + 1.0, sum + x * x));
    (sum / f64::max(count, 1.0)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_is_named_and_angles_are_kept_apart() {
        let rows = [RowIncidence::Degrees(0.0), RowIncidence::Degrees(85.0), RowIncidence::diffuse()];
        let places = places(&rows, &[1.0, 2.0]);
        let before = vec![[0.0; 9]; 6];
        let mut after = before.clone();
        (after[1][3], after[2][3], after[5][3]) = (-3e-3, 4e-3, 5e-3);
        let step = Step {
            rung: "model",
            places: &places,
            before: &before,
            after: &after,
            chance: None,
            known: [true; 9],
            note: String::new(),
        };
        let rows = step.rows();
        assert_eq!(rows.len(), 16);
        let of = |angles: &str| {
            rows.iter().find(|row| row.angles == angles && row.quantity == "t_1").unwrap().clone()
        };
        let steep = of("to-80");
        assert_eq!((steep.worst, steep.worst_tau, steep.points), (Some(3e-3), Some(2.0), 2));
        assert!((steep.rms.unwrap() - 3e-3 / 2_f64.sqrt()).abs() < 1e-15);
        let all = of("all");
        assert_eq!((all.worst, all.worst_theta_l_deg.as_str(), all.points), (Some(5e-3), "diffuse", 6));
    }
}
