//! One number held against the truth, and what many of them amount to.

use super::report::short;
use std::collections::BTreeMap;
use stratiform_artifact::RowIncidence;
use stratiform_quantities::{Medium, Order};

/// What is checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// The accepted table.
    Model,
    /// The photon tracer.
    Tracer,
    /// Another implementation's values.
    Values,
}

impl std::fmt::Display for Part {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Part::Model => "model",
            Part::Tracer => "tracer",
            Part::Values => "values",
        })
    }
}

/// Where a number stands; what does not apply is absent.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Incidence.
    pub theta_l_deg: RowIncidence,
    /// View.
    pub theta_v_deg: Option<f64>,
    /// View's azimuth.
    pub phi_deg: Option<f64>,
    /// Optical thickness of the full medium.
    pub tau: Option<f64>,
    /// Medium.
    pub medium: Option<Medium>,
    /// Order.
    pub order: Option<Order>,
}

impl Place {
    /// An incidence, and nothing else known.
    pub fn of(theta_l_deg: RowIncidence) -> Self {
        Self { theta_l_deg, theta_v_deg: None, phi_deg: None, tau: None, medium: None, order: None }
    }
}

/// Everything but the order, which stands in a [label](Comparison::label).
impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let light = self.theta_l_deg.degrees().map(short);
        write!(f, "theta_l {}", light.unwrap_or_else(|| self.theta_l_deg.to_string()))?;
        let mut part =
            |name: &str, value: Option<String>| value.map_or(Ok(()), |value| write!(f, ", {name} {value}"));
        part("theta_v", self.theta_v_deg.map(short))?;
        part("phi", self.phi_deg.map(short))?;
        part("tau", self.tau.map(short))?;
        part("medium", self.medium.map(|medium| medium.to_string()))
    }
}

/// A number beside the truth.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// What it is, in the words of its part.
    pub quantity: String,
    /// Where.
    pub place: Place,
    /// The number.
    pub value: f64,
    /// The truth.
    pub truth: f64,
    /// Largest difference allowed, what is not known of the truth included.
    pub bound: f64,
}

impl Comparison {
    /// The quantity, with its order if it has one.
    pub fn label(&self) -> String {
        self.place
            .order
            .map_or_else(|| self.quantity.clone(), |order| format!("{} order {order}", self.quantity))
    }

    /// Number less truth.
    pub fn difference(&self) -> f64 {
        self.value - self.truth
    }

    /// Whether the difference is within the bound. NaN is not.
    pub fn passes(&self) -> bool {
        self.difference().abs() <= self.bound
    }

    /// The difference in units of the bound; infinite for any difference where none is allowed, and for NaN.
    pub fn severity(&self) -> f64 {
        let off = self.difference().abs();
        match off / self.bound {
            _ if off == 0.0 => 0.0,
            severity if severity.is_nan() => f64::INFINITY,
            severity => severity,
        }
    }
}

/// Everything that was compared, part by part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// The parts that were run.
    pub parts: BTreeMap<Part, Vec<Comparison>>,
}

/// What the comparisons of one quantity and order amount to.
pub struct Summary<'a> {
    /// The quantity, with its order if it has one.
    pub label: String,
    /// How often it was compared.
    pub compared: usize,
    /// How often it was out of bounds.
    pub failed: usize,
    /// Where it was worst in units of the bound.
    pub worst: &'a Comparison,
}

impl Verdict {
    /// Number of comparisons.
    pub fn compared(&self) -> usize {
        self.parts.values().map(Vec::len).sum()
    }

    /// Comparisons out of bounds, with their parts; worst first, equals in the order of the parts.
    pub fn failures(&self) -> Vec<(Part, &Comparison)> {
        let all = self.parts.iter().flat_map(|(part, list)| list.iter().map(|one| (*part, one)));
        let mut failures: Vec<_> = all.filter(|(_, one)| !one.passes()).collect();
        failures.sort_by(|a, b| b.1.severity().total_cmp(&a.1.severity()));
        failures
    }

    /// Parts that compared nothing: they prove nothing.
    pub fn empty_parts(&self) -> Vec<Part> {
        self.parts.iter().filter(|(_, list)| list.is_empty()).map(|(part, _)| *part).collect()
    }

    /// Whether something was compared, in every part, and all of it is within bounds.
    pub fn passes(&self) -> bool {
        !self.parts.is_empty() && self.empty_parts().is_empty() && self.failures().is_empty()
    }

    /// The quantities and orders of a part, in the order in which they were first compared.
    pub fn summaries(&self, part: Part) -> Vec<Summary<'_>> {
        let mut summaries: Vec<Summary<'_>> = Vec::new();
        for one in self.parts.get(&part).into_iter().flatten() {
            let (label, failed) = (one.label(), usize::from(!one.passes()));
            match summaries.iter_mut().find(|summary| summary.label == label) {
                Some(summary) => {
                    summary.compared += 1;
                    summary.failed += failed;
                    if one.severity() > summary.worst.severity() {
                        summary.worst = one;
                    }
                }
                None => {
                    summaries.push(Summary { label, compared: 1, failed, worst: one });
                }
            }
        }
        summaries
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn comparison(quantity: &str, value: f64, bound: f64) -> Comparison {
        let place = Place::of(RowIncidence::Degrees(0.0));
        Comparison { quantity: quantity.to_owned(), place, value, truth: 1.0, bound }
    }

    fn verdict(list: Vec<Comparison>) -> Verdict {
        Verdict { parts: [(Part::Values, list)].into() }
    }

    #[test]
    fn equals_pass_and_errors_just_above_the_bound_do_not() {
        assert!(comparison("a", 1.0, 0.0).passes());
        assert!(comparison("a", 1.125, 0.125).passes());
        assert!(!comparison("a", 1.125 + f64::EPSILON, 0.125).passes());
        assert!(!comparison("a", 0.875 - f64::EPSILON, 0.125).passes());
        assert!(!comparison("a", f64::NAN, 1e9).passes());
        assert!(!comparison("a", 1.0, f64::NAN).passes());
    }

    #[test]
    fn a_place_is_short() {
        let place = Place {
            theta_v_deg: Some(1e-320),
            phi_deg: Some(1.0 / 3.0),
            tau: Some(1e-320),
            ..Place::of(RowIncidence::Degrees(1e-320))
        };
        let tiny = "1.00e-320";
        assert_eq!(place.to_string(), format!("theta_l {tiny}, theta_v {tiny}, phi 0.333333, tau {tiny}"));
        assert_eq!(Place::of(RowIncidence::diffuse()).to_string(), "theta_l diffuse");
        assert_eq!(Place::of(RowIncidence::Degrees(40.0)).to_string(), "theta_l 40");
    }

    #[test]
    fn nothing_compared_is_a_failure() {
        assert!(!Verdict::default().passes());
        assert!(!verdict(Vec::new()).passes());
        assert_eq!(verdict(Vec::new()).empty_parts(), [Part::Values]);
        assert!(verdict(vec![comparison("a", 1.0, 0.0)]).passes());
    }

    #[test]
    fn the_worst_come_first_and_each_quantity_is_summed_up() {
        let verdict = verdict(vec![
            comparison("a", 1.2, 0.1),
            comparison("b", 1.05, 0.1),
            comparison("a", 1.4, 0.1),
            comparison("b", f64::NAN, 0.1),
            comparison("a", 1.0, 0.0),
        ]);
        let failures: Vec<f64> = verdict.failures().iter().map(|(_, one)| one.value).collect();
        assert!(failures[0].is_nan() && failures[1..] == [1.4, 1.2], "{failures:?}");
        let summaries = verdict.summaries(Part::Values);
        let counts: Vec<_> = summaries.iter().map(|s| (s.label.as_str(), s.compared, s.failed)).collect();
        assert_eq!(counts, [("a", 3, 2), ("b", 2, 1)]);
        assert_eq!(summaries[0].worst.value, 1.4);
    }
}
