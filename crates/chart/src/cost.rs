//! What an evaluation costs, on one thread.
//!
//! Shader code ([`Single`]) is run in f32 over a list of inputs, again and again for [`Effort::repeat`]; the fastest of
//! [`Effort::repeats`] such runs, after one to warm up, divided by the evaluations: other programs only ever add time, and on a
//! busy machine to most runs. Solvers and tracers are timed once over a batch
//! of points, on one thread, with others like them on the other cores: what they cost amortised. Times differ between machines and runs.

use std::hint::black_box;
use std::time::{Duration, Instant};
use stratiform_methods::{FluxPoint, MethodError, Point, Single};
use stratiform_model::angular::Sight;

/// Evaluations between two looks at the clock, at least.
const BETWEEN_READINGS: usize = 256;

/// How long is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Length of one run.
    pub repeat: Duration,
    /// How many.
    pub repeats: usize,
}

impl Effort {
    /// For charts.
    pub const FULL: Self = Self { repeat: Duration::from_millis(1), repeats: 15 };
    /// For a quick look.
    pub const QUICK: Self = Self { repeat: Duration::from_micros(200), repeats: 3 };
}

/// Nanoseconds per radiance in f32; `None` without points.
///
/// # Errors
/// [`MethodError::Domain`] for a point that is no geometry.
pub fn radiance_ns(
    single: &dyn Single,
    points: &[Point],
    effort: Effort,
) -> Result<Option<f64>, MethodError> {
    let inputs = points
        .iter()
        .map(|p| Ok((p.tau as f32, Sight::new(p.mu_l, p.mu_v, p.phi_deg, p.side)?.cast::<f32>())))
        .collect::<Result<Vec<(f32, Sight<f32>)>, MethodError>>()?;
    Ok(ns_each(&inputs, effort, |(tau, sight)| single.radiance(*tau, sight)))
}

/// Nanoseconds per pair of fluxes in f32; `None` without points.
pub fn flux_ns(single: &dyn Single, points: &[FluxPoint], effort: Effort) -> Option<f64> {
    let inputs: Vec<_> = points.iter().map(|p| (p.tau as f32, p.mu_l as f32)).collect();
    ns_each(&inputs, effort, |(tau, mu_l)| {
        let (reflectance, transmittance) = single.fluxes(*tau, *mu_l);
        reflectance + transmittance
    })
}

/// What `work` gives on one thread, and the nanoseconds it took.
///
/// # Errors
/// [`MethodError::Failed`] if no thread could be started.
pub fn alone<T: Send>(work: impl FnOnce() -> T + Send) -> Result<(T, f64), MethodError> {
    let failed = |error: rayon::ThreadPoolBuildError| MethodError::Failed {
        method: "one thread".to_owned(),
        reason: error.to_string(),
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(failed)?;
    let start = Instant::now();
    let done = pool.install(work);
    Ok((done, 1e9 * start.elapsed().as_secs_f64()))
}

/// The time of one call in the fastest run.
fn ns_each<T>(inputs: &[T], effort: Effort, call: impl Fn(&T) -> f32) -> Option<f64> {
    if inputs.is_empty() {
        return None;
    }
    // Reading the clock takes as long as an evaluation.
    let turns = BETWEEN_READINGS.div_ceil(inputs.len());
    let run = || {
        let start = Instant::now();
        let mut rounds = 0_u32;
        while start.elapsed() < effort.repeat {
            for _ in 0..turns {
                let sum = inputs.iter().fold(0.0_f32, |sum, input| sum + call(black_box(input)));
                black_box(sum);
            }
            rounds += 1;
        }
        1e9 * start.elapsed().as_secs_f64() / f64::from(rounds) / (turns * inputs.len()) as f64
    };
    run();
    (0..effort.repeats.max(1)).map(|_| run()).min_by(f64::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_call_takes_some_time_and_none_takes_none() {
        let effort = Effort { repeat: Duration::from_micros(50), repeats: 3 };
        let turn = |turns: &u32| (0..*turns).fold(1.0_f32, |x, _| black_box(0.5 * x + 1.0));
        assert!(ns_each(&[20, 30], effort, turn).unwrap() > 0.0);
        assert_eq!(ns_each(&[], effort, turn), None);
        let (sum, ns) = alone(rayon::current_num_threads).unwrap();
        assert!(sum == 1 && ns > 0.0);
    }
}
