//! How far red and blue lie from green.

use super::known::Known;
use super::rows::{per_mille, radiances};
use super::{ErrorsError, Nodes};
use stratiform_artifact::{ErrorBlock, ErrorRow};
use stratiform_methods::Cloud;

/// Rows on a thinner lattice, with the truth in red and blue over that in green, less 1.
pub(super) fn of_cloud(
    nodes: &Nodes,
    radius: f64,
    waves: &[Cloud; 3],
    known: &Known,
) -> Result<Vec<ErrorRow>, ErrorsError> {
    if let Some(rows) = known.hues(radius) {
        return Ok(rows);
    }
    let thin = nodes.thinner();
    let nothing = Known::default();
    let [red, green, blue] =
        [&waves[0], &waves[1], &waves[2]].map(|cloud| radiances(&thin, radius, cloud, &nothing));
    let (red, green, blue) = (red?, green?, blue?);
    let hue = |((row, _), (red, blue)): (&(ErrorRow, _), (&(ErrorRow, _), &(ErrorRow, _)))| {
        let against = |other: &ErrorRow| Some(per_mille(other.truth? / row.truth? - 1.0));
        ErrorRow { values: vec![against(&red.0), against(&blue.0)], ..row.clone() }
    };
    let rows = green.iter().zip(red.iter().zip(&blue)).map(hue);
    Ok(rows.filter(|row| row.block != ErrorBlock::Flux && row.truth.is_some()).collect())
}
