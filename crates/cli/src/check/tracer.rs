//! Fresh photons against stored counts: every share of every medium, incidence, thickness and order.
//!
//! Values at different thicknesses come from the same photons. The threshold is Boole's, α over the number of comparisons,
//! which holds whatever the dependence, and the p-value is [bounded](stratiform_stats::p_value_of_two), not approximated.

use super::config::TracerConfig;
use super::counts::{CountRow, read, trace};
use super::{Comparison, Place};
use crate::CliError;
use crate::config::Config;
use crate::output::Talk;
use crate::pipeline::optics::Cloud;
use std::path::Path;
use stratiform_quantities::Order;
use stratiform_stats::{Hits, p_value_of_two};

/// Traces afresh and holds the result against the counts in `file`.
///
/// # Errors
/// [`CliError`] if the stored counts are missing, damaged or not those of the config; [`CliError::Interrupted`].
pub fn check(
    config: &Config,
    cloud: &Cloud,
    tracer: &TracerConfig,
    file: &Path,
    talk: Talk,
) -> Result<Vec<Comparison>, CliError> {
    let stored = read(file)?;
    let fresh = trace(config, cloud, tracer, tracer.photons, tracer.seed, talk)?;
    compare(&fresh, &stored, config.check.false_alarm_rate)
        .map_err(|message| CliError::Input(format!("{}: {message}", file.display())))
}

/// Holds `fresh` counts against `stored` ones of the same places.
///
/// # Errors
/// A message naming the place that only one of them has.
pub fn compare(
    fresh: &[CountRow],
    stored: &[CountRow],
    false_alarm_rate: f64,
) -> Result<Vec<Comparison>, String> {
    if let Some(row) = stored.iter().find(|row| !fresh.iter().any(|other| other.is_at(row))) {
        return Err(format!("the config counts nothing at {}", row.name()));
    }
    // What cannot differ is not compared: without scattering nothing is reflected.
    let count: usize = fresh.iter().map(|row| row.parts().len()).sum();
    let alpha = false_alarm_rate / count.max(1) as f64;
    let mut comparisons = Vec::with_capacity(count);
    for row in fresh {
        let other = stored.iter().find(|other| other.is_at(row));
        let other = other.ok_or_else(|| format!("there are no counts at {}", row.name()))?;
        for ((quantity, a), (_, b)) in row.parts().into_iter().zip(other.parts()) {
            let bound = largest_difference(a, b, alpha);
            comparisons.push(Comparison {
                quantity: quantity.to_owned(),
                place: row.place(),
                value: a.share(),
                truth: b.share(),
                bound,
            });
        }
    }
    Ok(comparisons)
}

impl CountRow {
    fn name(&self) -> String {
        format!("{}, order {}", self.place(), self.order)
    }

    fn place(&self) -> Place {
        Place {
            tau: Some(self.tau),
            medium: Some(self.medium),
            order: Some(self.order),
            ..Place::of(self.theta_l_deg.clone())
        }
    }

    fn parts(&self) -> Vec<(&'static str, Hits)> {
        let of = |hits| Hits { hits, trials: self.photons };
        let transmitted = ("transmittance", of(self.transmitted));
        match self.order {
            Order::Exactly(0) => vec![transmitted],
            _ => vec![("reflectance", of(self.reflected)), transmitted],
        }
    }
}

/// How far a share may be from the stored one on the side on which it is. Where no count on that side is out of bounds
/// (nothing can be rarer than never) the other side's distance stands, if that is more.
fn largest_difference(fresh: Hits, stored: Hits, alpha: f64) -> f64 {
    let centre = stored.share() * fresh.trials as f64;
    let (below, above) = (centre.floor() as u64, centre.ceil() as u64);
    let agrees = |hits: u64| p_value_of_two(Hits { hits, ..fresh }, stored).is_some_and(|p| p >= alpha);
    let lowest = below - last(below, |steps| agrees(below - steps));
    let highest = above + last(fresh.trials - above, |steps| agrees(above + steps));
    let off = |hits: u64| (Hits { hits, ..fresh }.share() - stored.share()).abs();
    let (own, end) = if fresh.hits as f64 >= centre { (highest, fresh.trials) } else { (lowest, 0) };
    if own == end { off(lowest).max(off(highest)) } else { off(own) }
}

/// The last of 0…`most` for which `holds`, which does up to some number and not beyond; 0 if for none.
fn last(most: u64, holds: impl Fn(u64) -> bool) -> u64 {
    let (mut low, mut high) = (0, most + 1);
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if holds(middle) { low = middle } else { high = middle }
    }
    low
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_artifact::RowIncidence;
    use stratiform_quantities::Medium;

    fn row(order: Order, photons: u64, reflected: u64, transmitted: u64) -> CountRow {
        let (medium, theta_l_deg) = (Medium::Full, RowIncidence::diffuse());
        CountRow { medium, theta_l_deg, tau: 1.0, order, photons, reflected, transmitted }
    }

    #[test]
    fn the_bound_is_the_last_count_that_agrees() {
        let stored = Hits { hits: 30_000, trials: 100_000 };
        for hits in [200, 300, 400, 0, 1000] {
            let fresh = Hits { hits, trials: 1000 };
            let bound = largest_difference(fresh, stored, 1e-6);
            let off = (fresh.share() - 0.3).abs();
            assert_eq!(off <= bound, p_value_of_two(fresh, stored).unwrap() >= 1e-6, "{hits}: {off} {bound}");
            assert!(bound > 0.05 && bound < 0.1, "{bound}");
        }
        let never = Hits { hits: 0, trials: 1000 };
        let rare = Hits { hits: 10, trials: 100_000 };
        assert!(largest_difference(never, Hits { hits: 0, trials: 9999 }, 1e-6) > 0.0);
        assert!(largest_difference(never, rare, 1e-6) > 10.0 * rare.share());
    }

    #[test]
    fn equal_counts_agree_and_a_planted_excess_does_not() {
        let stored = [row(Order::Exactly(1), 1_000_000, 20_000, 300_000)];
        let verdict = |reflected, transmitted| {
            let fresh = [row(Order::Exactly(1), 10_000, reflected, transmitted)];
            let list = compare(&fresh, &stored, 1e-5).unwrap();
            list.iter().map(Comparison::passes).collect::<Vec<_>>()
        };
        assert_eq!(verdict(200, 3000), [true, true]);
        // 7 standard errors of 46 are 321.
        assert_eq!(verdict(200, 3321), [true, false]);
        assert_eq!(verdict(100, 3000), [false, true]);
    }

    #[test]
    fn places_must_be_the_same() {
        let (a, b) = (row(Order::Total, 10, 5, 5), row(Order::Exactly(0), 10, 0, 5));
        assert_eq!(compare(std::slice::from_ref(&b), std::slice::from_ref(&b), 0.1).unwrap().len(), 1);
        let both = [a.clone(), b];
        assert!(
            compare(&both, std::slice::from_ref(&a), 0.1)
                .unwrap_err()
                .contains("no counts at theta_l diffuse, tau 1, medium full, order 0")
        );
        assert!(compare(std::slice::from_ref(&a), &both, 0.1).unwrap_err().contains("counts nothing"));
    }
}
