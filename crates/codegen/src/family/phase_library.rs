//! The library that looks the phase functions up over (Θ, r_e). It stands below the library of phase
//! functions of one cloud, whose table has the family's rows below its own two: P of every radius, then P_S convolved with itself.

use crate::language::Library;
use crate::phase::COUNT;
use crate::phase_library::versine;
use crate::shader::cases;
use crate::text::{banner, fill, literal};
use crate::{CodegenError, Inputs};
use stratiform_artifact::{FamilyDocument, FamilyMember};
use stratiform_model::family::{PhaseFamily, PhaseMember};
use stratiform_quantities::angle_map::coordinate;

/// Angles of the embedded self-test, degrees; radii are half-way between the tables', and the ends.
const TESTED_DEG: [f64; 6] = [0.3, 2.0, 20.0, 90.0, 142.0, 178.0];

/// The rows that the table of phase functions holds for the family.
///
/// # Errors
/// [`CodegenError::FamilyTexels`] if one has another length than the table.
pub(super) fn rows(family: &FamilyDocument) -> Result<Vec<Vec<f64>>, CodegenError> {
    let of = [|one: &FamilyMember| one.phase.clone(), |one: &FamilyMember| one.phase_squared.clone()];
    let mut rows = Vec::new();
    for values in of {
        for member in &family.members {
            let row = values(member);
            if row.len() != COUNT {
                let effective_radius_um = member.effective_radius_um;
                return Err(CodegenError::FamilyTexels {
                    effective_radius_um,
                    got: row.len(),
                    expected: COUNT,
                });
            }
            rows.push(row);
        }
    }
    Ok(rows)
}

/// The library.
///
/// # Errors
/// [`CodegenError`] for phase functions out of domain.
pub(super) fn library<'a>(
    inputs: &Inputs,
    family: &FamilyDocument,
    phase: &'a Library<'a>,
) -> Result<Library<'a>, CodegenError> {
    Ok(Library {
        head: head(inputs),
        name: "stratiform_family_phase",
        code: fill(include_str!("../wgsl/family_phase.wgsl"), &places(family)?),
        owner: Some("StratiformFamilyPhase"),
        glue: None,
        needs: vec![phase],
    })
}

fn places(family: &FamilyDocument) -> Result<[(&'static str, String); 6], CodegenError> {
    let forward = |one: &FamilyMember| one.parameters.medium.forward_fraction;
    let twin = Twin::new(family)?;
    let radii: Vec<f64> = family.members.iter().map(|one| one.effective_radius_um).collect();
    let between = radii.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let ends = [radii[0], radii[radii.len() - 1]];
    let mut vectors = Vec::new();
    for radius in ends.into_iter().chain(between) {
        for theta_deg in TESTED_DEG {
            let values = twin.vector(theta_deg, radius)?;
            let text = values.map(literal).join(", ");
            vectors.push(format!("StratiformFamilyPhaseVector({text})"));
        }
    }
    Ok([
        ("SQUARED_ROW", (2 + family.members.len()).to_string()),
        ("TABLES", family.members.len().to_string()),
        ("RADII", cases(&radii.iter().map(|radius| literal(*radius)).collect::<Vec<_>>())),
        ("FORWARD", cases(&family.members.iter().map(|one| literal(forward(one))).collect::<Vec<_>>())),
        ("TEST_COUNT", vectors.len().to_string()),
        ("TEST_VECTORS", cases(&vectors)),
    ])
}

/// The look-up in double precision.
struct Twin {
    full: PhaseFamily<f64>,
    squared: PhaseFamily<f64>,
    forward: PhaseFamily<f64>,
    theta_f_deg: f64,
}

impl Twin {
    fn new(family: &FamilyDocument) -> Result<Self, CodegenError> {
        let table = |values: &dyn Fn(&FamilyMember) -> Vec<f64>| {
            let member = |one: &FamilyMember| PhaseMember {
                effective_radius_um: one.effective_radius_um,
                values: values(one),
            };
            PhaseFamily::new(&family.members.iter().map(member).collect::<Vec<_>>())
        };
        Ok(Self {
            full: table(&|one| one.phase.clone())?,
            squared: table(&|one| one.phase_squared.clone())?,
            // The same at every angle.
            forward: table(&|one| vec![one.parameters.medium.forward_fraction; 2])?,
            theta_f_deg: family.members[0].parameters.medium.theta_f_deg,
        })
    }

    /// v, r_e, P, P_S, P_S convolved with itself.
    fn vector(&self, theta_deg: f64, radius_um: f64) -> Result<[f64; 5], CodegenError> {
        let u = coordinate(theta_deg);
        let full = self.full.at(u, radius_um)?;
        let wide = full / (1.0 - self.forward.at(u, radius_um)?);
        let modified = if theta_deg < self.theta_f_deg { 0.0 } else { wide };
        Ok([versine(theta_deg), radius_um, full, modified, self.squared.at(u, radius_um)?])
    }
}

fn head(inputs: &Inputs) -> String {
    banner(inputs, "Phase functions of a cloud of any effective radius, looked up in a table.")
        + "//\n\
           // Use        @USE@.\n\
           // Check      stratiform_family_phase_self_test() returns the number of wrong values: 0 if the table is in place.\n\
           // Table      that of stratiform_phase: below its two rows P of every radius, then P_S convolved with itself of\n\
           //            every radius, as in family_phase.csv.\n\
           // Units      v = 1 - cosTheta, cosTheta = +1 is forward; radius_um is the effective radius in um.\n\
           // Domain     v in [0, 2], radius_um between the first and the last radius. Values are linear in the\n\
           //            logarithm of the radius, so that 1/2 integral of P over cosTheta stays 1.\n"
}
