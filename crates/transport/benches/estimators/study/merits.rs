//! Figures of merit against analog, by row and for a whole run.

use super::measure::{Measured, measure, rounded};
use super::scores::NAMES;
use super::truth::{ROUNDING, is_common, largest, solve, solved, z_scores};
use super::{ALL, Estimator, Job};
use serde::Serialize;
use stratiform_stats::{Estimate, Purpose, key};
use stratiform_transport::TraceMedium;

pub const PHOTONS: u64 = 4096;
pub const REPLICATES: u64 = 256;

/// A medium lit from μ0, and the slabs that are asked for together.
pub struct Case<'a> {
    pub phase: &'a str,
    pub medium: &'a TraceMedium,
    pub mu0: f64,
    pub bottoms: &'a [f64],
}

/// A row of `estimators.csv`: σ²t of analog over that of each estimator, empty where the estimator is exact. Analog's σ² is
/// p(1-p), p solved.
#[derive(Serialize)]
pub struct MeritRow {
    pub phase: String,
    pub mu0: f64,
    pub tau: f64,
    pub quantity: &'static str,
    pub solved: f64,
    pub half_space: Option<f64>,
    pub expected_values: Option<f64>,
    pub sequence_1_word: Option<f64>,
    pub sequence_4_words: Option<f64>,
    pub sequence_8_words: Option<f64>,
}

/// A row of `runs.csv`: an estimator on all slabs of a case. A run until every row has a standard error takes the time
/// of the row of largest variance.
#[derive(Serialize)]
pub struct RunRow {
    pub phase: String,
    pub mu0: f64,
    pub slabs: u64,
    pub estimator: &'static str,
    /// Of a photon in all slabs.
    pub flights_per_photon: f64,
    /// Differs between machines and runs, and so does the merit.
    pub ns_per_flight: f64,
    /// Largest variance per photon of any row.
    pub worst_variance: f64,
    pub worst_tau: f64,
    pub worst_quantity: &'static str,
    /// (largest variance × seconds) of analog over the estimator's.
    pub merit: f64,
    /// Largest |z| of the rows' means against the solver.
    pub largest_z: f64,
    /// Rows compared.
    pub rows: u64,
}

/// Measured estimators of one case, with the truth.
pub struct Study<'a> {
    case: &'a Case<'a>,
    truth: Vec<Estimate>,
    measured: Vec<(&'static str, Measured)>,
}

impl<'a> Study<'a> {
    /// Measures `estimators`, analog first.
    pub fn new(case: &'a Case<'a>, estimators: &[(&'static str, Estimator)]) -> Self {
        let Case { medium, mu0, bottoms, .. } = *case;
        let job = Job { table: medium.table(), bottoms, mu0, key: key(17, Purpose::Calibration) };
        let measured = estimators.iter().map(|(name, run)| (*name, measure(*run, &job, PHOTONS, REPLICATES)));
        let measured = measured.collect();
        Self { case, truth: solve(medium, bottoms, mu0), measured }
    }

    fn analog(&self) -> &Measured {
        &self.measured[0].1
    }

    fn place(&self, q: usize) -> (f64, &'static str) {
        (self.case.bottoms[q / NAMES.len()], NAMES[q % NAMES.len()])
    }

    /// Every row that analog's photons tell, if all of [`ALL`] were measured.
    pub fn merits(&self) -> Vec<MeritRow> {
        let common = |(_, truth): &(usize, &Estimate)| is_common(**truth, PHOTONS * REPLICATES);
        self.truth
            .iter()
            .enumerate()
            .filter(common)
            .map(|(q, truth)| self.merit_row(q, truth.value))
            .collect()
    }

    fn merit_row(&self, q: usize, p: f64) -> MeritRow {
        let analog = p * (1.0 - p) * self.analog().work.seconds();
        let merit = |(_, measured): &(&str, Measured)| {
            let exact = measured.variance[q] < ROUNDING * ROUNDING * PHOTONS as f64;
            (!exact).then(|| rounded(analog / (measured.variance[q] * measured.work.seconds())))
        };
        let merits: [Option<f64>; ALL.len()] = std::array::from_fn(|e| merit(&self.measured[e]));
        let [_, half_space, expected_values, sequence_1_word, sequence_4_words, sequence_8_words] = merits;
        let (tau, quantity) = self.place(q);
        MeritRow {
            phase: self.case.phase.to_owned(),
            mu0: self.case.mu0,
            tau,
            quantity,
            solved: solved(p),
            half_space,
            expected_values,
            sequence_1_word,
            sequence_4_words,
            sequence_8_words,
        }
    }

    /// Each estimator on the whole.
    pub fn runs(&self) -> Vec<RunRow> {
        self.measured.iter().map(|(name, measured)| self.run_row(name, measured)).collect()
    }

    fn run_row(&self, estimator: &'static str, measured: &Measured) -> RunRow {
        let (worst, variance) = worst(measured);
        let z = z_scores(measured, &self.truth);
        let (worst_tau, worst_quantity) = self.place(worst);
        RunRow {
            phase: self.case.phase.to_owned(),
            mu0: self.case.mu0,
            slabs: self.case.bottoms.len() as u64,
            estimator,
            flights_per_photon: rounded(measured.work.flights_per_photon),
            ns_per_flight: rounded(1e9 * measured.work.seconds_per_flight),
            worst_variance: rounded(variance),
            worst_tau,
            worst_quantity,
            merit: rounded(cost(self.analog()) / cost(measured)),
            largest_z: rounded(largest(&z)),
            rows: z.len() as u64,
        }
    }
}

/// Largest variance times seconds.
fn cost(measured: &Measured) -> f64 {
    worst(measured).1 * measured.work.seconds()
}

/// The row of largest variance, and that.
fn worst(measured: &Measured) -> (usize, f64) {
    let rows = measured.variance.iter().copied().enumerate();
    rows.fold((0, 0.0), |worst, row| if row.1 > worst.1 { row } else { worst })
}
