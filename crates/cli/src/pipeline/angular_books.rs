//! `angular-books.csv`: the energy books of the angular model (Bouthors, Neyret & Lefebvre 2006, section 4), corrected and as
//! printed, against the 1-D model's orders and the solver's, in the modified medium.

use super::cut::Cut;
use super::hemisphere::{AtAngle, Hemisphere, Leaving};
use super::optics::Cloud;
use super::reference::Media;
use super::{curves, trace_error};
use crate::CliError;
use crate::config::Config;
use rayon::prelude::*;
use std::path::Path;
use stratiform_artifact::{AngularBooksRow, AngularForm, ParametersDocument, write_csv};
use stratiform_model::Fluxes;
use stratiform_model::angular::{Angular, Emission, Sight, as_printed};
use stratiform_model::table::cos_degrees;
use stratiform_quantities::{Incidence, Medium, Order, Side};
use stratiform_transport::solve::{Solved, Solver};

/// Slabs of the books, metres.
pub const THICKNESS_M: [f64; 6] = [1.0, 5.0, 20.0, 100.0, 300.0, 1000.0];

/// The solver's error, absolute: below that of the integrals.
const TOLERANCE: f64 = 1e-5;

/// What is integrated, in the order of [`radiances`].
const COLUMNS: [(Order, AngularForm); 9] = [
    (Order::Exactly(1), AngularForm::Corrected),
    (Order::Exactly(1), AngularForm::AsPrinted),
    (Order::Exactly(2), AngularForm::Corrected),
    (Order::Exactly(2), AngularForm::AsPrinted),
    (Order::Exactly(2), AngularForm::AsPrintedPerUnit),
    (Order::Tail, AngularForm::Corrected),
    (Order::Tail, AngularForm::Isotropic),
    (Order::Tail, AngularForm::Escape),
    (Order::Tail, AngularForm::AsPrinted),
];

/// Writes the table and returns its name.
///
/// # Errors
/// As [`rows`], or a file that cannot be written.
pub fn write(
    config: &Config,
    cloud: &Cloud,
    cut: &Cut,
    parameters: &ParametersDocument,
    dir: &Path,
) -> Result<Vec<String>, CliError> {
    write_csv(&dir.join("angular-books.csv"), &rows(config, cloud, cut, parameters, &THICKNESS_M)?)?;
    Ok(vec!["angular-books.csv".to_owned()])
}

/// The books of every angle of the table below 90°, where the 1-D model cannot fit, and of these thicknesses; `cut` is of the same cloud.
///
/// # Errors
/// [`CliError::Failed`] if the solver misses its tolerance, [`CliError::Input`] for numbers out of domain.
pub fn rows(
    config: &Config,
    cloud: &Cloud,
    cut: &Cut,
    parameters: &ParametersDocument,
    thickness_m: &[f64],
) -> Result<Vec<AngularBooksRow>, CliError> {
    let hemisphere = Hemisphere::new(cut, parameters.medium.theta_f_deg);
    let table = &parameters.metres;
    let slanted = table.rows.iter().filter_map(|row| Some((row.theta_l_deg.degrees()?, row)));
    let lights: Vec<_> = slanted.filter(|(theta, _)| *theta < 90.0).collect();
    let angles: Vec<f64> = lights.iter().map(|(theta, _)| *theta).collect();
    let solved = solve(config, cloud, thickness_m, &angles)?;
    let leaving: Vec<Leaving> =
        angles.par_iter().map(|theta| hemisphere.under(cos_degrees(*theta))).collect();
    let mut slabs = Vec::new();
    for (i, (theta, row)) in lights.iter().enumerate() {
        let values = curves::emitted(table, row);
        for (k, h) in thickness_m.iter().enumerate() {
            let fluxes = curves::fluxes(&values, *theta, *h)?;
            slabs.push(Slab { cloud, place: (i, k), theta_l_deg: *theta, thickness_m: *h, fluxes });
        }
    }
    let books: Vec<Vec<AngularBooksRow>> =
        slabs.par_iter().map(|slab| slab.books(&leaving[slab.place.0], &solved)).collect();
    Ok(books.concat())
}

fn solve(
    config: &Config,
    cloud: &Cloud,
    thickness_m: &[f64],
    theta_l_deg: &[f64],
) -> Result<Solved, CliError> {
    let media = Media::new(config, cloud)?;
    let tau: Vec<f64> = thickness_m.iter().map(|h| h * cloud.extinction_per_m).collect();
    let beams = theta_l_deg.iter().map(|theta| Incidence::beam(cos_degrees(*theta)));
    let beams = beams.collect::<Result<Vec<_>, _>>()?;
    let solver = Solver::new(media.get(Medium::Modified).into(), TOLERANCE).map_err(trace_error)?;
    solver.orders(&tau, &beams, 2).map_err(|error| trace_error(error).at("angular books"))
}

/// One slab in one light.
struct Slab<'a> {
    cloud: &'a Cloud,
    /// Of the light and of the thickness in the solver's answer.
    place: (usize, usize),
    theta_l_deg: f64,
    thickness_m: f64,
    fluxes: Fluxes<f64>,
}

impl Slab<'_> {
    fn books(&self, leaving: &Leaving, solved: &Solved) -> Vec<AngularBooksRow> {
        let side = |side| {
            let integrals = leaving.fluxes(side, |sight, functions| {
                radiances(self.kappa_s(), self.thickness_m, &self.fluxes, sight, functions)
            });
            integrals.into_iter().zip(COLUMNS).map(move |(integral, (order, form))| AngularBooksRow {
                theta_l_deg: self.theta_l_deg,
                tau: self.thickness_m * self.cloud.extinction_per_m,
                side,
                order,
                form,
                integral,
                one_dimensional_model: self.one_dimensional(side, order),
                solver: self.solver(solved, side, order),
            })
        };
        Side::BOTH.into_iter().flat_map(side).collect()
    }

    /// κ_S, 1/m.
    fn kappa_s(&self) -> f64 {
        (1.0 - self.cloud.forward_fraction) * self.cloud.extinction_per_m
    }

    fn one_dimensional(&self, side: Side, order: Order) -> f64 {
        let fluxes = &self.fluxes;
        match (side, order) {
            (Side::Top, Order::Exactly(1)) => fluxes.r_1,
            (Side::Top, Order::Exactly(_)) => fluxes.r_2,
            (Side::Top, _) => fluxes.r_3_plus,
            (Side::Bottom, Order::Exactly(1)) => fluxes.t_1,
            (Side::Bottom, Order::Exactly(_)) => fluxes.t_2,
            (Side::Bottom, _) => fluxes.t_3_plus,
        }
    }

    fn solver(&self, solved: &Solved, side: Side, order: Order) -> f64 {
        let listed = Order::rows(2).take_while(|listed| *listed != order).count();
        let (reflectance, transmittance) = solved.estimate(self.place.0, self.place.1, listed);
        if side == Side::Top { reflectance.value } else { transmittance.value }
    }
}

/// The factors that [`COLUMNS`] names.
fn radiances(
    kappa_s: f64,
    thickness_m: f64,
    fluxes: &Fluxes<f64>,
    sight: Sight<f64>,
    functions: &AtAngle,
) -> [f64; COLUMNS.len()] {
    let slab = Angular::unchecked(kappa_s * thickness_m, sight);
    let printed = as_printed::orders(&slab, kappa_s, functions, fluxes);
    let three_plus = |emission| slab.three_plus(fluxes, emission);
    [
        slab.one(functions),
        printed.one,
        slab.two(functions),
        printed.two,
        as_printed::two_per_unit(&slab, functions),
        three_plus(Emission::Lambertian),
        three_plus(Emission::Isotropic),
        three_plus(Emission::Escape),
        printed.three_plus,
    ]
}
