//! The inverse cumulative distribution of MCX and MCX-CL (`Domain.InverseCDF` of the JSON input, `cfg.invcdf` of pmcx).
//!
//! Convention, checked with pmcx 0.8.1: n ascending μ = cosΘ (1 is forward) at the cumulative probabilities i/(n+1),
//! i = 1 … n, of μ. The program adds -1 and 1 at the ends itself and is linear in μ between, so P is constant between
//! two values: 2/((n+1)Δμ). n must be even, or the program pads with a second 1 and shifts every probability. Values
//! are f32 and live in 48 KiB of a GPU's shared memory beside the photons. One table holds for all media.

use super::{PeerFile, text, worth};
use crate::TablesError;
use crate::card::Card;
use stratiform_optics::phase::{PhaseTable, versine};
use stratiform_quantities::Range;

/// Numbers of values that fit the program.
pub const VALUES: Range = Range::closed(2.0, 8192.0);

/// A JSON input's `Domain` with nothing but the distribution, in `count` values.
///
/// # Errors
/// [`TablesError::Domain`] unless `count` is even and in \[2, 8192\], or if two values are the same in f32: fewer are needed.
pub fn inverse_cdf(table: &PhaseTable, count: usize) -> Result<PeerFile<String>, TablesError> {
    VALUES.check("values of InverseCDF", count as f64)?;
    Range::closed(0.0, 0.0).check("values of InverseCDF modulo 2", (count % 2) as f64)?;
    let mu = values(table, count);
    let padded: Vec<f64> = [-1.0].into_iter().chain(mu.iter().copied()).chain([1.0]).collect();
    for pair in padded.windows(2) {
        Range::above(0.0).check("step of InverseCDF in f32", pair[1] - pair[0])?;
    }
    let content = format!("{{\"Domain\": {{\"InverseCDF\": [\n{}\n]}}}}\n", text::list(&mu, ",", ""));
    Ok(PeerFile { content, values: count, cards: vec![card(table, &padded)] })
}

/// μ at i/(n+1), rounded to f32.
fn values(table: &PhaseTable, count: usize) -> Vec<f64> {
    let at = |i: usize| {
        // The probability of a smaller μ is that of a larger Θ.
        let theta = table.invert_theta((count + 1 - i) as f64 / (count + 1) as f64);
        f64::from((1.0 - versine(theta)) as f32)
    };
    (1..=count).map(at).collect()
}

fn card(table: &PhaseTable, mu: &[f64]) -> Card {
    let share = 1.0 / (mu.len() - 1) as f64;
    let p = |theta: f64| {
        let right = mu.partition_point(|node| *node < libm::cos(theta)).clamp(1, mu.len() - 1);
        2.0 * share / (mu[right] - mu[right - 1])
    };
    let nodes: Vec<f64> = mu.iter().rev().map(|mu| worth::degrees(*mu)).collect();
    worth::card(table, &nodes, p)
}
