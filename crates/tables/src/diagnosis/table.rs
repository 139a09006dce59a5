//! The diagnosis of a table.

use super::bounds::{INTEGRAL, INTEGRAL_PER_RULES, MISPLACED, RULES};
use super::compare::compare;
use super::sampling::{Sampling, trapezoids};
use super::{Check, Verdict};
use crate::TablesError;
use crate::read::{AngleUnit, Layout, Normalisation, RawTable, Understanding};
use serde::{Deserialize, Serialize};
use stratiform_optics::OpticsError;
use stratiform_optics::phase::{Norm, PhaseFunction, PhaseTable, versine};
use stratiform_quantities::angle_map::angle_deg;

/// What a table is. Numbers of the phase function are those after unit, sign and convention have been undone.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TableFacts {
    /// How the file is laid out.
    pub layout: Layout,
    /// Rows read.
    pub rows: usize,
    /// The column read as the value.
    pub value_column: String,
    /// Columns that were not read.
    pub left_out: Vec<String>,
    /// What the angles are, by their range.
    pub angle_unit: AngleUnit,
    /// Forward is at 180°.
    pub mirrored: bool,
    /// What the values integrate to.
    pub normalisation: Normalisation,
    /// ½∫P sinΘ dΘ as it stands, P linear in Θ.
    pub integral: f64,
    /// The same by trapezoids in cosΘ.
    pub integral_trapezoids: f64,
    /// Estimated share of light that linear interpolation misplaces.
    pub misplaced: f64,
    /// Rows within the half-width of the forward peak.
    pub rows_in_peak: usize,
    /// g.
    pub asymmetry: f64,
    /// θ_f.
    pub theta_f_deg: f64,
    /// P_f, P linear in Θ.
    pub forward_fraction: f64,
    /// P_f by trapezoids in cosΘ.
    pub forward_fraction_trapezoids: f64,
}

/// What a table is and what is wrong with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnosis {
    /// What it is.
    pub facts: TableFacts,
    /// Everything looked at.
    pub checks: Vec<Check>,
}

impl Diagnosis {
    /// Whether nothing is wrong.
    pub fn passes(&self) -> bool {
        self.checks.iter().all(|check| check.verdict == Verdict::Ok)
    }

    /// Names of the faults, without what follows from them.
    pub fn faults(&self) -> Vec<&str> {
        self.checks.iter().filter(|check| check.is_wrong()).map(|check| check.name.as_str()).collect()
    }
}

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Question {
    /// θ_f of P_f.
    pub theta_f_deg: f64,
    /// What the values are meant to integrate to.
    pub normalisation: Normalisation,
}

impl Question {
    /// Mean 1 over the sphere.
    pub const fn mean_one(theta_f_deg: f64) -> Self {
        Self { theta_f_deg, normalisation: Normalisation::MeanOne }
    }
}

/// Looks at `raw`; `mie` is the phase function that it should be, where known.
///
/// # Errors
/// [`TablesError`] if the values have no integral or θ_f is out of domain.
pub fn diagnose(
    raw: &RawTable,
    mie: Option<&PhaseTable>,
    question: Question,
) -> Result<Diagnosis, TablesError> {
    let theta_f_deg = question.theta_f_deg;
    let understood = Understanding::of(raw, mie)?;
    let table = understood.repaired(raw)?;
    let sampling = Sampling::of(&table);
    let facts = facts(raw, &understood, &table, &sampling, theta_f_deg)?;
    let mut checks = conventions(&understood, question.normalisation);
    let sampled = sampling_check(&facts, mie)?;
    let too_coarse = sampled.is_wrong();
    checks.extend([sampled, integral(&understood, &sampling, too_coarse)]);
    if let Some(mie) = mie {
        let mut compared = compare(&table, mie, theta_f_deg)?;
        if too_coarse {
            follow_sampling(&mut compared, &compare(&table, &at_rows_of(&table, mie)?, theta_f_deg)?);
        }
        checks.extend(compared);
    }
    follow(&mut checks);
    Ok(Diagnosis { facts, checks })
}

fn facts(
    raw: &RawTable,
    understood: &Understanding,
    table: &PhaseTable,
    sampling: &Sampling,
    theta_f_deg: f64,
) -> Result<TableFacts, TablesError> {
    Ok(TableFacts {
        layout: raw.layout,
        rows: raw.value.len(),
        value_column: raw.value_name.clone(),
        left_out: raw.left_out.clone(),
        angle_unit: raw.unit,
        mirrored: understood.mirrored,
        normalisation: understood.normalisation,
        integral: understood.integral,
        integral_trapezoids: understood.integral * sampling.rules,
        misplaced: sampling.misplaced,
        rows_in_peak: sampling.rows_in_peak,
        asymmetry: table.asymmetry(),
        theta_f_deg,
        forward_fraction: table.forward_fraction(theta_f_deg)?,
        forward_fraction_trapezoids: trapezoids(table, theta_f_deg) / trapezoids(table, 180.0),
    })
}

/// Unit, sign and normalisation.
fn conventions(understood: &Understanding, meant: Normalisation) -> Vec<Check> {
    let unit = match understood.stated_unit.filter(|stated| *stated != understood.unit) {
        Some(stated) => {
            let words = format!("the header says {stated}, the range says {}", understood.unit);
            Check::plain("angle-unit", false, words)
        }
        None => Check::plain("angle-unit", true, understood.unit.to_string()),
    };
    let sign = if understood.mirrored {
        "angle sign flipped: forward is at 180 degrees, as if measured between the directions to sun and viewer"
    } else {
        "forward is at 0 degrees"
    };
    let by = understood.normalisation;
    vec![
        unit,
        Check::plain("angle-sign", !understood.mirrored, sign),
        Check::plain("normalisation", by == meant, by.words()),
    ]
}

fn sampling_check(facts: &TableFacts, mie: Option<&PhaseTable>) -> Result<Check, TablesError> {
    let rules = facts.integral_trapezoids / facts.integral;
    let fine = facts.misplaced <= MISPLACED && (rules - 1.0).abs() <= RULES;
    let truth = match mie {
        Some(mie) => format!(" where Mie says {:.3}", mie.forward_fraction(facts.theta_f_deg)?),
        None => String::new(),
    };
    let words = format!(
        "{}: raw integral {:.3} by trapezoids in the cosine, {:.3} linear in the angle; P_f {:.3} and {:.3}{truth}; {} rows in \
         the peak's half-width; found is the share of light misplaced between rows",
        if fine { "fine enough" } else { "too coarse" },
        facts.integral_trapezoids,
        facts.integral,
        facts.forward_fraction_trapezoids,
        facts.forward_fraction,
        facts.rows_in_peak
    );
    let mut check = Check::number("sampling", facts.misplaced, 0.0, MISPLACED, words);
    check.verdict = if fine { Verdict::Ok } else { Verdict::Wrong };
    Ok(check)
}

fn integral(understood: &Understanding, sampling: &Sampling, too_coarse: bool) -> Check {
    let explained = INTEGRAL_PER_RULES * (sampling.rules - 1.0).abs();
    let bound = if too_coarse { INTEGRAL } else { INTEGRAL.max(explained) };
    let found = understood.integral / understood.factor;
    let words = "after the normalisation's factor, P linear in the angle: 1 is right";
    let mut check = Check::number("integral", found, 1.0, bound, words);
    if too_coarse && (found - 1.0).abs() <= explained {
        check.follow("sampling");
    }
    check
}

/// Mie's phase function at the rows of `table`.
fn at_rows_of(table: &PhaseTable, mie: &PhaseTable) -> Result<PhaseTable, TablesError> {
    let p = table.theta_rad().iter().map(|theta| mie.at(*theta)).collect();
    Ok(PhaseTable::new(table.theta_deg().to_vec(), p, Norm::Any)?)
}

/// What is right against Mie at the same rows follows from the rows.
fn follow_sampling(checks: &mut [Check], at_rows: &[Check]) {
    for check in checks {
        if at_rows.iter().any(|same| same.name == check.name && same.verdict == Verdict::Ok) {
            check.follow("sampling");
        }
    }
}

/// What follows from a wrong peak, or from a wrong share or shape.
fn follow(checks: &mut [Check]) {
    let wrong = |checks: &[Check], name: &str| checks.iter().any(|c| c.name == name && c.is_wrong());
    let peak = wrong(checks, "forward-peak") && !wrong(checks, "wide-shape");
    let cause = ["wide-shape", "forward-fraction"].into_iter().find(|name| wrong(checks, name));
    for check in checks {
        match check.name.as_str() {
            "integral" | "forward-fraction" | "asymmetry" if peak => check.follow("forward-peak"),
            "asymmetry" => cause.into_iter().for_each(|cause| check.follow(cause)),
            _ => {}
        }
    }
}

/// A phase function as a table fine enough for any check: 4096 angles of the project's map.
///
/// # Errors
/// [`TablesError`] if a value is not finite, or the peak too sharp for so many angles (|g| above 0.999).
pub fn tabulated(phase: &dyn PhaseFunction) -> Result<RawTable, TablesError> {
    let theta_deg: Vec<f64> = (0..4096).map(|i| angle_deg(f64::from(i) / 4095.0)).collect();
    let p = theta_deg.iter().map(|theta| phase.value(versine(theta.to_radians()))).collect();
    let table = PhaseTable::new(theta_deg.clone(), p, Norm::Strict).map_err(|error| match error {
        OpticsError::NotNormalised { .. } => {
            let reason = format!("too sharp to be looked at in 4096 angles: {error}");
            TablesError::Container { format: "phase function", reason }
        }
        other => other.into(),
    })?;
    Ok(RawTable {
        layout: Layout::Columns,
        unit: AngleUnit::Degrees,
        stated_unit: None,
        value_name: "p".to_owned(),
        left_out: Vec::new(),
        theta_deg,
        value: table.values().to_vec(),
    })
}
