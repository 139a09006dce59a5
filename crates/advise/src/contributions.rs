//! Which parts of a picture a scene does not need, from `ablation.csv`.
//!
//! The rms difference between the pictures with and without a contribution bounds what leaving it out does to the error; those of several
//! add up to a bound for all of them (triangle inequality). Contributions are taken in the order of their difference as long as the
//! sum stays within the budget.

use crate::text::percent;
use stratiform_artifact::AblationRow;

/// Contributions that may be left out together.
#[derive(Clone, Debug, PartialEq)]
pub struct Unneeded {
    /// Their names, the least first.
    pub contributions: Vec<String>,
    /// Bound of what that does to the rms error of luminance, a share of the picture's mean.
    pub error: f64,
    /// Milliseconds that it saves on the machine of the table, one by one; empty without a clock.
    pub ms: Option<f64>,
}

/// Those of `scene` whose absence costs at most `max_error` in all; `None` if the table does not know the scene.
pub fn unneeded(table: &[AblationRow], scene: &str, max_error: f64) -> Option<Unneeded> {
    let of_scene = |row: &&AblationRow| row.scene == scene && row.without().is_some();
    let mut rows: Vec<&AblationRow> = table.iter().filter(of_scene).collect();
    if rows.is_empty() {
        return None;
    }
    rows.sort_by(|a, b| a.difference.total_cmp(&b.difference));
    let mut found = Unneeded { contributions: Vec::new(), error: 0.0, ms: Some(0.0) };
    for row in rows {
        if found.error + row.difference > max_error {
            break;
        }
        found.contributions.extend(row.without().map(str::to_owned));
        found.error += row.difference;
        found.ms = found.ms.zip(row.ms_saved).map(|(sum, ms)| sum + ms);
    }
    Some(found)
}

impl std::fmt::Display for Unneeded {
    /// One line for people.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.contributions.is_empty() {
            return write!(f, "contributions: the picture needs every one within this error");
        }
        let names = self.contributions.join(", ");
        write!(f, "contributions: leaving out {names} changes the picture by at most {}", percent(self.error))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(scene: &str, change: &str, difference: f64) -> AblationRow {
        AblationRow {
            scene: scene.to_owned(),
            change: change.to_owned(),
            error: 0.1,
            noise: 0.01,
            rise: 0.0,
            difference,
            flip: 0.0,
            width: 1,
            height: 1,
            ms: Some(1.0),
            ms_saved: Some(0.25),
        }
    }

    #[test]
    fn the_least_are_left_out_while_their_sum_is_within_the_budget() {
        let table = [
            row("a", "nothing", 0.0),
            row("a", "without sky", 0.3),
            row("a", "without halo", 0.01),
            row("a", "without single", 0.02),
            row("a", "radiosity passes 0", 0.001),
            row("b", "without sky", 0.0),
        ];
        let found = unneeded(&table, "a", 0.04).unwrap();
        assert_eq!(found.contributions, ["halo", "single"]);
        assert!((found.error - 0.03).abs() < 1e-15 && found.ms == Some(0.5));
        assert_eq!(
            unneeded(&table, "a", 0.025).unwrap().contributions,
            ["halo"],
            "alone 0.02 would do, together not"
        );
        assert!(unneeded(&table, "a", 0.005).unwrap().contributions.is_empty());
        assert_eq!(unneeded(&table, "c", 1.0), None);
    }
}
