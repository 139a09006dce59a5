//! `family-phase.csv`: phase functions at radii half-way between, interpolated in several ways.
//!
//! P itself is what is used: a mean of normalised functions is normalised, and texture filters do it. `log P` loses up to
//! 8e-3 of the light between radii 1.4 apart. `log P stretched` takes the tables at angles that are stretched like the diffraction peak, Θ r_e/r_a, up to 3°, and
//! less and less up to 20°. Relative errors near 1e-2 are those of the size average itself.

use super::member::Computed;
use crate::CliError;
use crate::pipeline::input_error;
use stratiform_artifact::FamilyPhaseRow;
use stratiform_model::family::{PhaseFamily, PhaseMember};
use stratiform_optics::phase::PhaseTable;
use stratiform_quantities::angle_map::{angle_deg, coordinate};

/// Values of each row of the family's tables.
const TEXELS: usize = stratiform_codegen::PHASE_TEXELS;

/// Steps of the angle map at which functions are compared.
const STEPS: usize = 4096;

/// One of a member's phase functions.
type Function = fn(&Computed) -> &PhaseTable;

/// Those that are emitted.
const FUNCTIONS: [(&str, Function); 2] = [("full", |one| &one.full), ("squared", |one| &one.squared)];

/// `table` at equal steps of the angle map, with seven digits.
pub fn texels(table: &PhaseTable) -> Vec<f64> {
    (0..TEXELS)
        .map(|i| seven_digits(table.at(angle_deg(i as f64 / (TEXELS - 1) as f64).to_radians())))
        .collect()
}

fn seven_digits(value: f64) -> f64 {
    format!("{value:.6e}").parse().unwrap_or(value)
}

/// Every row of the file: `half_way[i]` lies between `members[i]` and the next.
///
/// # Errors
/// [`CliError::Input`] for a phase function out of domain.
pub fn rows(members: &[Computed], half_way: &[Computed]) -> Result<Vec<FamilyPhaseRow>, CliError> {
    let mut rows = Vec::new();
    for (pair, computed) in members.windows(2).zip(half_way) {
        for (function, table) in FUNCTIONS {
            let between = Between::new(&pair[0], &pair[1], computed.radius_um, table);
            for (method, values) in between.methods()? {
                let truth: Vec<f64> = grid().map(|theta| table(computed).at(theta.to_radians())).collect();
                rows.push(FamilyPhaseRow {
                    effective_radius_um: computed.radius_um,
                    table_radii_um: format!("{} {}", pair[0].radius_um, pair[1].radius_um),
                    method: method.to_owned(),
                    function: function.to_owned(),
                    ..compared(&values, &truth)
                });
            }
        }
    }
    Ok(rows)
}

fn grid() -> impl Iterator<Item = f64> {
    (0..=STEPS).map(|i| angle_deg(i as f64 / STEPS as f64))
}

/// Two radii and the one between.
struct Between<'a> {
    radii: [f64; 2],
    tables: [&'a PhaseTable; 2],
    wanted: f64,
}

impl<'a> Between<'a> {
    fn new(a: &'a Computed, b: &'a Computed, wanted: f64, table: Function) -> Self {
        Self { radii: [a.radius_um, b.radius_um], tables: [table(a), table(b)], wanted }
    }

    fn methods(&self) -> Result<[(&'static str, Vec<f64>); 4], CliError> {
        let plain = |f: fn(f64) -> f64, back: fn(f64) -> f64| self.mixed(|theta, _| theta, f, back);
        Ok([
            ("P", plain(|p| p, |p| p)),
            ("log P", plain(libm::log, libm::exp)),
            ("log P stretched", self.mixed(stretched, libm::log, libm::exp)),
            ("texels", self.by_texels()?),
        ])
    }

    /// f(P) linear in ln r_e, with each table taken at `angle`(Θ, r_e/r_a).
    fn mixed(&self, angle: fn(f64, f64) -> f64, f: fn(f64) -> f64, back: fn(f64) -> f64) -> Vec<f64> {
        let [a, b] = self.radii;
        let weight = libm::log(self.wanted / a) / libm::log(b / a);
        let at = |k: usize, theta: f64| {
            f(self.tables[k].at(angle(theta, self.wanted / self.radii[k]).to_radians()))
        };
        grid().map(|theta| back(at(0, theta) * (1.0 - weight) + at(1, theta) * weight)).collect()
    }

    fn by_texels(&self) -> Result<Vec<f64>, CliError> {
        let member =
            |k: usize| PhaseMember { effective_radius_um: self.radii[k], values: texels(self.tables[k]) };
        let family = PhaseFamily::<f64>::new(&[member(0), member(1)]).map_err(input_error)?;
        let at = |theta| family.at(coordinate(theta), self.wanted).map_err(input_error);
        grid().map(at).collect()
    }
}

/// Θ s^w with w = 1 up to 3° falling to 0 at 20°.
fn stretched(theta_deg: f64, s: f64) -> f64 {
    theta_deg * libm::pow(s, ((20.0 - theta_deg) / 17.0).clamp(0.0, 1.0))
}

/// The errors of `values`, with what they are of left open.
fn compared(values: &[f64], truth: &[f64]) -> FamilyPhaseRow {
    let theta: Vec<f64> = grid().collect();
    // ½ sinΘ dΘ of each angle's cell.
    let edge = |i: usize, j: usize| libm::cos(0.5 * (theta[i] + theta[j]).to_radians());
    let weight = |i: usize| 0.5 * (edge(i.saturating_sub(1), i) - edge(i, (i + 1).min(STEPS)));
    let sum = |f: &dyn Fn(usize) -> f64| (0..=STEPS).fold(0.0, |sum, i| sum + weight(i) * f(i));
    let worst = |from: f64, to: f64| {
        let inside = (0..=STEPS).filter(|i| (from..=to).contains(&theta[*i]));
        inside.map(|i| (values[i] / truth[i] - 1.0).abs()).fold(0.0, f64::max)
    };
    FamilyPhaseRow {
        effective_radius_um: 0.0,
        table_radii_um: String::new(),
        method: String::new(),
        function: String::new(),
        elsewhere: 0.5 * sum(&|i| (values[i] - truth[i]).abs()),
        norm_error: sum(&|i| values[i] - truth[i]),
        worst_peak: worst(0.0, 5.0),
        worst_forward: worst(5.0, 30.0),
        worst_side: worst(30.0, 130.0),
        worst_fogbow: worst(130.0, 165.0),
        worst_glory: worst(165.0, 180.0),
    }
}
