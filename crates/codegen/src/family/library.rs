//! The library of fluxes over (μ_l, r_e): tables, functions, self-test. It stands below the library of one cloud's fluxes.

use super::tables::members;
use super::vectors::{FamilyVector, vector};
use crate::language::Library;
use crate::shader::{FIELDS, cases, structure};
use crate::text::{banner, fill, literal};
use crate::{CodegenError, Inputs};
use stratiform_artifact::FamilyDocument;
use stratiform_model::ModelError;
use stratiform_model::family::Member;

/// μ_l of the self-test, none for diffuse light, and τ; radii are half-way between the tables', and the ends.
const TESTED: [(Option<f64>, f64); 4] = [(Some(1.0), 2.0), (Some(0.4), 0.5), (Some(0.05), 0.1), (None, 5.0)];

/// The library.
///
/// # Errors
/// [`CodegenError`] if the tables do not fit together or to the fluxes' table.
pub(super) fn library<'a>(
    inputs: &Inputs,
    family: &FamilyDocument,
    fluxes: &'a Library<'a>,
) -> Result<Library<'a>, CodegenError> {
    let members = members(family)?;
    check_angles(inputs, &members)?;
    let code = fill(include_str!("../wgsl/family.wgsl"), &places(family, &members)?);
    let head = head(inputs, family);
    Ok(Library { head, name: "stratiform_family", code, owner: None, glue: None, needs: vec![fluxes] })
}

/// The rows of all tables are those of the fluxes' table.
fn check_angles(inputs: &Inputs, members: &[Member]) -> Result<(), CodegenError> {
    let rows = crate::tables::angles(&inputs.parameters.optical);
    let same = |member: &Member| {
        let angles = member.angles.iter().map(|angle| angle.theta_l_deg);
        angles.eq(rows.iter().map(|row| row.theta_l_deg))
    };
    match members.iter().find(|member| !same(member)) {
        Some(member) => Err(CodegenError::FamilyAngles { effective_radius_um: member.effective_radius_um }),
        None => Ok(()),
    }
}

fn places(family: &FamilyDocument, members: &[Member]) -> Result<Vec<(&'static str, String)>, CodegenError> {
    let per_member = |text: &dyn Fn(&Member) -> String| cases(&members.iter().map(text).collect::<Vec<_>>());
    let nodes = members.iter().flat_map(|member| member.angles.iter().map(|angle| structure(&angle.values)));
    let medium = |member: &Member| {
        let slope = (1.0 - member.diffuse.beta) / member.diffuse.beta;
        format!("StratiformFamilyMedium({}, {})", literal(slope), literal(member.diffuse.kappa_s))
    };
    let radii: Vec<f64> = members.iter().map(|member| member.effective_radius_um).collect();
    let [first, .., last] = radii[..] else {
        return Err(ModelError::TooFewRadii { radii: radii.len() }.into());
    };
    let between = radii.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let mut tested = Vec::new();
    for radius in [first].into_iter().chain(between).chain([last]) {
        for (mu_l, tau) in TESTED {
            tested.push(vector(family, mu_l, radius, tau)?);
        }
    }
    let inputs = |v: &FamilyVector| {
        format!("StratiformFamilyVector({})", [v.mu_l, v.radius_um, v.tau].map(literal).join(", "))
    };
    let outputs = |v: &FamilyVector| format!("StratiformFluxes({})", v.fluxes().map(literal).join(", "));
    let compare = |field: &&str| format!("wrong += stratiform_wrong(f.{field}, e.{field});");
    Ok(vec![
        ("TABLES", members.len().to_string()),
        ("ROWS", members[0].angles.len().to_string()),
        ("SMALLEST", literal(first)),
        ("LARGEST", literal(last)),
        ("RADII", per_member(&|member| literal(member.effective_radius_um))),
        ("NODES", cases(&nodes.collect::<Vec<_>>())),
        ("DIFFUSE", per_member(&|member| structure(&member.diffuse))),
        ("MEDIA", per_member(&medium)),
        ("TEST_COUNT", tested.len().to_string()),
        ("TEST_VECTORS", cases(&tested.iter().map(inputs).collect::<Vec<_>>())),
        ("TEST_FLUXES", cases(&tested.iter().map(outputs).collect::<Vec<_>>())),
        ("COMPARE", FIELDS.iter().map(compare).collect::<Vec<_>>().join("\n        ")),
    ])
}

fn head(inputs: &Inputs, family: &FamilyDocument) -> String {
    let medium = &inputs.parameters.medium;
    let radii: Vec<_> = family.members.iter().map(|one| one.effective_radius_um.to_string()).collect();
    banner(inputs, "Fluxes of a stratiform layer of any effective radius: a table per radius, interpolated.")
        + &format!(
            "//\n\
             // Use        @USE@.\n\
             // Family     {}\n\
             // Check      stratiform_family_self_test() returns the number of wrong values: 0.\n\
             // Units      radius_um is the droplets' effective radius in um; tau the extinction optical thickness of the\n\
             //            full medium, which depends on radius and droplet number: it is yours to compute.\n\
             // Tables     effective radii {} um, wavelength {} um, theta_f {} deg.\n\
             // Domain     radius_um between the first and the last radius; mu_l and tau as in the library of one cloud,\n\
             //            whose error card holds here too: interpolation in radius adds less than a tenth of it.\n",
            family.provenance.config_hash,
            radii.join(", "),
            medium.wavelength_um,
            medium.theta_f_deg,
        )
}
