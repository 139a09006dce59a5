//! The library of fluxes: header, table, functions, self-test.

use crate::error_card::{STEEP_DEG, error_card};
use crate::language::Library;
use crate::tables::{angles, diffuse_values};
use crate::text::{banner, fill, literal};
use crate::{CodegenError, ErrorCard, Inputs, embedded_test, leave_one_out};
use std::fmt::Write as _;
use stratiform_artifact::Flag;
use stratiform_model::table::cos_degrees;
use stratiform_model::{Real, Values};

/// The whole library.
pub(crate) fn library(inputs: &Inputs) -> Result<Library<'static>, CodegenError> {
    let mut head =
        banner(inputs, "Fluxes of a stratiform layer: the one-dimensional model of Bouthors et al. 2006.");
    head.push_str(&header(inputs)?);
    let code = constants(inputs) + &functions(inputs)? + &accessors() + &embedded_test::text(inputs)?;
    Ok(Library { head, name: "stratiform", code, owner: None, glue: None, needs: Vec::new() })
}

fn header(inputs: &Inputs) -> Result<String, CodegenError> {
    let medium = &inputs.parameters.medium;
    let [thin, thick] = inputs.parameters.thickness_range_m.map(|h| h * medium.extinction_per_m);
    let mut text = format!(
        "//\n\
         // Use        @USE@.\n\
         // Check      stratiform_self_test() returns the number of wrong values: 0, each held to 2e-5 (0.1 + |value|),\n\
         //            the error of single precision at most. Made to see a thousandth of any number of the table.\n\
         // Units      tau is the extinction optical thickness of the full medium along the slab's normal, tau = kappa H.\n\
         //            mu_l = cos(theta_l), the sun's zenith angle. Fluxes are shares of the flux incident on the slab.\n\
         // Orders     count scattering by more than theta_f: t_zero is light that no event turned further, not the sun's\n\
         //            sharp image (that is exp(-tau / mu_l)). t_ms and r_ms hold all orders.\n\
         // Phase      1/2 integral of P over cosTheta is 1; cosTheta = +1 is forward.\n\
         {}\
         // Domain     mu_l in [0, 1], tau in [0, 1e6]; fitted over tau {} to {}. Nothing is checked or clamped here.\n\
         //            three_plus are differences and may fall below 0; theta_l = 90 deg is beyond the model's form.\n\
         // Error      |value - reference| below; the reference is this cloud's flux by the method above, before any model.\n",
        medium_line(inputs),
        brief(thin),
        brief(thick),
    );
    let titles = [
        format!("at the table's angles up to {STEEP_DEG} deg"),
        format!("between the table's angles up to {STEEP_DEG} deg"),
        format!("beyond {STEEP_DEG} deg, where the model's form fails"),
        "in diffuse light".to_owned(),
    ];
    let claimed = inputs.parameters.provenance.error_name();
    for (title, cards) in titles.iter().zip(error_card(inputs)?) {
        let sigma = format!("; sigma is the reference's own largest {claimed}");
        push_card(&mut text, &format!("Error against the reference {title}"), &cards, &sigma);
    }
    let inner = leave_one_out(&inputs.parameters.optical)?;
    push_card(
        &mut text,
        "Interpolation error with every other gap doubled (a row left out at a time)",
        &inner,
        "; against the whole table, which is exact here",
    );
    push_flags(&mut text, inputs);
    Ok(text)
}

/// The medium, for a header.
pub(crate) fn medium_line(inputs: &Inputs) -> String {
    let medium = &inputs.parameters.medium;
    format!(
        "// Medium     wavelength {} um, single-scattering albedo {}, g {}; modified: theta_f {} deg, P_f {}.\n",
        medium.wavelength_um,
        medium.single_scattering_albedo,
        brief(medium.asymmetry),
        medium.theta_f_deg,
        brief(medium.forward_fraction),
    )
}

/// Four significant digits.
fn brief(value: f64) -> String {
    if value == 0.0 || (1e-3..1e4).contains(&value.abs()) {
        format!("{value:.4}")
    } else {
        format!("{value:.3e}")
    }
}

fn push_card(text: &mut String, title: &str, cards: &[ErrorCard], remark: &str) {
    if cards.is_empty() {
        let _ = writeln!(text, "//\n// {title}: no reference values were given.");
        return;
    }
    let _ = writeln!(
        text,
        "//\n// {title}, absolute{remark}:\n//   quantity    values     median        95 %       worst       sigma"
    );
    for card in cards {
        let ErrorCard { quantity, count, median, percentile_95, worst, reference_error } = card;
        let _ = writeln!(
            text,
            "//   {quantity:<9} {count:>8} {median:>10.2e} {percentile_95:>11.2e} {worst:>11.2e} {reference_error:>11.2e}"
        );
    }
}

fn push_flags(text: &mut String, inputs: &Inputs) {
    for row in inputs.parameters.optical.rows.iter().filter(|row| !row.flags.is_empty()) {
        let flags = row.flags.iter().map(|flag| meaning(*flag)).collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "//\n// Row theta_l = {}: {flags}.", row.theta_l_deg);
    }
}

/// A flag in words.
fn meaning(flag: Flag) -> &'static str {
    match flag {
        Flag::CNotIdentifiable => "b is so near 1 that c has no influence",
        Flag::BOnBound => "b is on a bound of the fit",
        Flag::COnBound => "c is on a bound of the fit",
        Flag::KappaCOnBound => "kappa_c is on a bound of the fit",
        Flag::TOnBound => "t is on a bound of the fit",
        Flag::ROnBound => "r is on a bound of the fit",
        Flag::BetaFixed => "beta is that of the other rows",
        Flag::NegativeT3Plus => "t_three_plus falls below -1e-3",
        Flag::NegativeR3Plus => "r_three_plus falls below -1e-3",
        Flag::OutsideUnitInterval => "some flux leaves [0, 1]",
        Flag::NotConverged => "the fit did not converge",
    }
}

fn constants(inputs: &Inputs) -> String {
    let (medium, optical) = (&inputs.parameters.medium, &inputs.parameters.optical);
    let beta = optical.beta.value;
    format!(
        "// (1 - beta) / beta: T_ms = (b + (1 - b) exp(-c tau)) / (1 + slope tau).\n\
         const STRATIFORM_SLOPE: f32 = {};\n\
         // Extinction of the modified medium per unit of tau.\n\
         const STRATIFORM_KAPPA_S: f32 = {};\n\
         // Extinction per metre of the fitted cloud by the convention `{convention}`.\n\
         const STRATIFORM_EXTINCTION_PER_M: f32 = {};\n\n\
         // tau of a thickness in metres, for the fitted cloud's droplet number and the convention `{convention}`.\n\
         fn stratiform_tau_from_metres_{convention}(thickness_m: f32) -> f32 {{\n    \
             return STRATIFORM_EXTINCTION_PER_M * thickness_m;\n}}\n\n",
        literal((1.0 - beta) / beta),
        literal(optical.kappa_s),
        literal(medium.extinction_per_m),
        convention = medium.extinction_convention,
    )
}

fn structure(values: &Values<f64>) -> String {
    let numbers = [values.b, values.c, values.kappa_c, values.t, values.r].map(literal);
    format!("StratiformParameters({})", numbers.join(", "))
}

/// The cases of a switch, the last one as default.
pub(crate) fn cases(values: &[String]) -> String {
    let last = values.len().saturating_sub(1);
    let case = |(i, value): (usize, &String)| {
        let label = if i == last { "default:".to_owned() } else { format!("case {i}u:") };
        format!("        {label} {{ return {value}; }}")
    };
    values.iter().enumerate().map(case).collect::<Vec<_>>().join("\n")
}

fn functions(inputs: &Inputs) -> Result<String, CodegenError> {
    let optical = &inputs.parameters.optical;
    let angles = angles(optical);
    let mus: Vec<_> = angles.iter().map(|angle| literal(cos_degrees(angle.theta_l_deg))).collect();
    let rows: Vec<_> = angles.iter().map(|angle| structure(&angle.values)).collect();
    let above = |mu: &String| format!("select(0u, 1u, mu_l < {mu})");
    let inner: Vec<_> = mus[1..mus.len() - 1].iter().map(above).collect();
    let interval = if inner.is_empty() { "0u".to_owned() } else { inner.join("\n        + ") };
    let places = [
        ("NODES", cases(&rows)),
        ("NODE_MUS", cases(&mus)),
        ("INTERVAL", interval),
        ("DIFFUSE", structure(&diffuse_values(optical)?)),
        ("E1_TERMS", f32::E1_TERMS.to_string()),
        ("E3_DEPTH", f32::E3_DEPTH.to_string()),
        ("E3_START", (2 * f32::E3_DEPTH + 3).to_string()),
    ];
    Ok(fill(include_str!("wgsl/model.wgsl"), &places))
}

/// The members of StratiformFluxes.
pub(crate) const FIELDS: [&str; 9] =
    ["t_ms", "r_ms", "t_zero", "t_one", "t_two", "t_three_plus", "r_one", "r_two", "r_three_plus"];

/// One function per flux.
fn accessors() -> String {
    let mut text = "// ---- one flux at a time ".to_owned() + &"-".repeat(90) + "\n\n";
    for field in FIELDS {
        let _ = writeln!(
            text,
            "fn stratiform_{field}(mu_l: f32, tau: f32) -> f32 {{\n    return stratiform_beam(mu_l, tau).{field};\n}}\n"
        );
    }
    for field in FIELDS {
        let _ = writeln!(
            text,
            "fn stratiform_diffuse_{field}(tau: f32) -> f32 {{\n    return stratiform_diffuse(tau).{field};\n}}\n"
        );
    }
    text
}
