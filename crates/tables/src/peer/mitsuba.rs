//! Mitsuba 3's `tabphase` and Eradiate's `tabphase_irregular`, as XML fragments for a `<medium>`.
//!
//! Convention, checked with Mitsuba 3.9.1 and eradiate-mitsuba 0.5.0: values over μ from -1 to 1, linear between, where
//! μ = 1 is forward (the light goes straight on). Both plugins divide by the integral; P itself is written (mean 1 over
//! the sphere), so the plugin evaluates to P/4π per steradian. `tabphase` has equal steps of μ: a droplet's peak needs
//! very many ([`values_for`]); the irregular form takes the table's own nodes, in f32.

use super::cosine::OverCosine;
use super::{PeerFile, text};
use crate::TablesError;
use stratiform_optics::phase::PhaseTable;
use stratiform_quantities::Range;

/// Numbers of values that `tabphase` is written with.
pub const VALUES: Range = Range::closed(2.0, MOST as f64);

const MOST: usize = (1 << 20) + 1;

/// A `tabphase` of `count` values.
///
/// # Errors
/// [`TablesError::Domain`] unless 2 ≤ `count` ≤ 2²⁰ + 1.
pub fn tabphase(table: &PhaseTable, count: usize) -> Result<PeerFile<String>, TablesError> {
    VALUES.check("values of tabphase", count as f64)?;
    let over = OverCosine::equidistant(table, count);
    let content = plugin("tabphase", &[("values", &over.p)]);
    Ok(PeerFile { content, values: count, cards: vec![over.card(table)] })
}

/// The smallest 2^k + 1 values with which no angle is off by more than `relative_error`.
///
/// # Errors
/// [`TablesError::Domain`] for an error that 2²⁰ + 1 values do not reach.
pub fn values_for(table: &PhaseTable, relative_error: f64) -> Result<usize, TablesError> {
    let error = |count: usize| OverCosine::equidistant(table, count).card(table).largest_error;
    Range::above(0.0).check("relative error of tabphase", relative_error)?;
    let counts = (1..=20).map(|k| (1_usize << k) + 1);
    let mut reached = f64::INFINITY;
    for count in counts {
        reached = error(count);
        if reached <= relative_error {
            return Ok(count);
        }
    }
    Range::at_least(reached).check("relative error of tabphase", relative_error)?;
    Ok(MOST)
}

/// A `tabphase_irregular` at the table's own nodes.
pub fn tabphase_irregular(table: &PhaseTable) -> PeerFile<String> {
    let over = OverCosine::irregular(table);
    let content = plugin("tabphase_irregular", &[("nodes", &over.mu), ("values", &over.p)]);
    PeerFile { content, values: over.mu.len(), cards: vec![over.card(table)] }
}

fn plugin(kind: &str, lists: &[(&str, &[f64])]) -> String {
    let strings: String = lists
        .iter()
        .map(|(name, numbers)| {
            format!("    <string name=\"{name}\" value=\"{}\"/>\n", text::list(numbers, ",", "        "))
        })
        .collect();
    format!(
        "<!-- Phase function, mean 1 over the sphere, over the cosine of the scattering angle from -1 (back) to 1 (forward). -->\n\
         <phase type=\"{kind}\">\n{strings}</phase>\n"
    )
}
