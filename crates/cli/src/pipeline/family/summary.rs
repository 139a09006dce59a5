//! The family for a terminal.

use crate::CliError;
use std::fmt::Write;
use std::path::Path;
use stratiform_artifact::{FamilyDocument, FamilyErrorRow, LadderRow, read_csv, read_json};

/// Radii, and the worst errors of interpolated and of scaled tables up to 80 degrees, against the fit at the radius.
///
/// # Errors
/// [`CliError::Input`] for a missing or damaged file.
pub fn summary(dir: &Path) -> Result<String, CliError> {
    let document: FamilyDocument = read_json(&dir.join(super::FILES[0]))?;
    let mut text = String::from("  r_e um       g     P_f     g_S   Q_ext\n");
    for one in &document.members {
        let medium = &one.parameters.medium;
        let _ = writeln!(
            text,
            "{:>8} {:>7.4} {:>7.4} {:>7.4} {:>7.4}",
            one.effective_radius_um,
            medium.asymmetry,
            medium.forward_fraction,
            one.modified_asymmetry,
            one.extinction_ratio()
        );
    }
    for (title, file) in [("interpolated", super::FILES[1]), ("one table", super::FILES[2])] {
        let rows: Vec<FamilyErrorRow> = read_csv(&dir.join(file))?;
        let _ = writeln!(text, "\n{title}: worst error against the fit at each radius, up to 80 degrees");
        worst(&mut text, &rows);
    }
    Ok(text)
}

fn worst(text: &mut String, rows: &[FamilyErrorRow]) {
    let counted = |row: &&FamilyErrorRow| row.angles == LadderRow::TO_80 && row.against == "fit";
    let mut heads: Vec<(&str, &str)> = Vec::new();
    for row in rows.iter().filter(counted).filter(|row| row.method != "own") {
        let head = (row.method.as_str(), row.table_radii_um.as_str());
        if !heads.contains(&head) {
            heads.push(head);
        }
    }
    let _ = writeln!(
        text,
        "{:>20} {:>9} {:>9} {:>9} {:>9} {:>9}  tables",
        "", "t_ms", "t_1", "t_2", "r_1", "r_2"
    );
    for (method, tables) in heads {
        let of = |quantity: &str| {
            let same = |row: &&FamilyErrorRow| {
                row.method == method && row.table_radii_um == tables && row.quantity == quantity
            };
            rows.iter().filter(counted).filter(same).fold(0.0, |most, row| f64::max(most, row.worst))
        };
        let [a, b, c, d, e] = ["t_ms", "t_1", "t_2", "r_1", "r_2"].map(of);
        let _ = writeln!(text, "{method:>20} {a:>9.2e} {b:>9.2e} {c:>9.2e} {d:>9.2e} {e:>9.2e}  {tables}");
    }
}
