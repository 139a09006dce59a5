//! The photon tracers against the deterministic solver over a designed grid.
//!
//! Eight phase functions × six thicknesses, each once; incidence, albedo and tracer run through them so that every pair of
//! levels of any two factors meets ([`design`]). Each case is judged by all its numbers: R and T per order (z of every number
//! of which at least [`ENOUGH`] photons are expected, either way) and χ² of the whole list of endings, rare ones pooled.
//! Numbers of one case depend on each other; one of each case, `Row::drawn`, and the χ² of all cases are independent.

use super::{beam, full, hg, isotropic, request};
use std::path::Path;
use std::sync::Arc;
use stratiform_optics::phase::{Draine, Modified, Norm, PhaseFunction, PhaseTable, Rayleigh};
use stratiform_quantities::{Asymmetry, Incidence, Order, SingleScatteringAlbedo};
use stratiform_stats::{
    ChiSquare, Estimate, KolmogorovSmirnov, chi_square, family_threshold, holm, kolmogorov_smirnov, z_score,
};
use stratiform_transport::solve::{SolveMedium, Solver};
use stratiform_transport::{Quantity, TraceMedium, TraceRequest, Traced};

pub const PHASES: [&str; 8] =
    ["isotropic", "rayleigh", "hg 0.75", "hg 0.85", "hg -0.3", "draine", "cloud C1", "cloud cut at 5"];
pub const TAU: [f64; 6] = [0.01, 0.1, 1.0, 4.0, 20.0, 100.0];
pub const OMEGA: [f64; 3] = [1.0, 0.99, 0.9];
pub const INCIDENCES: usize = 5;

/// Photons expected and not expected that make a count nearly normal: at 5 standard errors its skewness changes the tail's
/// probability by less than a factor of 2.
const ENOUGH: f64 = 1000.0;

/// One slab, one incidence, one tracer; places in the lists of levels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    pub phase: usize,
    pub tau: usize,
    pub incidence: usize,
    pub omega: usize,
    pub plain: bool,
}

/// 48 cases in which any two levels of different factors meet.
pub fn design() -> Vec<Case> {
    let case = |phase: usize, tau: usize| Case {
        phase,
        tau,
        incidence: (phase + tau) % INCIDENCES,
        omega: (phase + 2 * tau) % OMEGA.len(),
        plain: (phase / 2 + tau) % 2 == 1,
    };
    (0..PHASES.len()).flat_map(|phase| (0..TAU.len()).map(move |tau| case(phase, tau))).collect()
}

impl Case {
    pub fn incidence(&self) -> Incidence {
        match self.incidence {
            0 => Incidence::Diffuse,
            i => beam([0.0, 0.05, 0.3, 1.0][i - 1]),
        }
    }

    pub fn medium(&self) -> TraceMedium {
        let omega = OMEGA[self.omega];
        match self.phase {
            0 => full(isotropic(), omega),
            1 => full(Arc::new(Rayleigh), omega),
            2 => full(hg(0.75), omega),
            3 => full(hg(0.85), omega),
            4 => full(hg(-0.3), omega),
            5 => full(Arc::new(Draine::new(Asymmetry::new(0.6).unwrap(), 1.0).unwrap()), omega),
            6 => full(cloud_c1(), omega),
            _ => cut_cloud(omega),
        }
    }

    pub fn name(&self) -> String {
        format!(
            "{:<15}{:<11}{:>6} {:>8} {:>5}",
            PHASES[self.phase],
            if self.plain { "plain" } else { "half-space" },
            TAU[self.tau],
            self.incidence().to_string(),
            OMEGA[self.omega]
        )
    }
}

fn cloud_c1() -> Arc<dyn PhaseFunction> {
    let chi = super::published::coefficients("cloud-c1.csv");
    Arc::new(PhaseTable::from_moments(&chi).unwrap())
}

/// The paper's cloud without its forward events: a jump at 5°.
fn cut_cloud(omega: f64) -> TraceMedium {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    let phase = PhaseTable::read(Path::new(file), Norm::Strict).unwrap();
    let cut = Modified::new(Arc::new(phase), 5.0).unwrap();
    let forward = cut.forward_fraction();
    TraceMedium::modified(Arc::new(cut), SingleScatteringAlbedo::new(omega).unwrap(), forward).unwrap()
}

/// Photons of a trace: fewer where they scatter often, `plain_share` of them for the slower tracer.
#[derive(Clone, Copy)]
pub struct Budget {
    pub photons: f64,
    pub plain_share: f64,
    pub seed: u64,
    pub tolerance: f64,
}

/// One number of a case.
pub struct Score {
    pub quantity: Quantity,
    pub traced: f64,
    pub solved: Estimate,
    pub std_error: f64,
    pub z: f64,
}

/// A case and how its numbers compare.
pub struct Row {
    pub case: Case,
    pub photons: u64,
    pub scores: Vec<Score>,
    pub chi_square: ChiSquare,
    /// Place in `scores` of the number that stands for the case where independence counts; none if all are rare.
    drawn: Option<usize>,
}

const ORDERS: [Order; 5] =
    [Order::Exactly(0), Order::Exactly(1), Order::Exactly(2), Order::Tail, Order::Total];

impl Row {
    /// Traces `medium` and judges it by the solver's answer for the case's own medium.
    pub fn new(case: Case, medium: &TraceMedium, stream: u32, budget: Budget) -> Self {
        let tau = TAU[case.tau];
        let share = if case.plain { budget.plain_share } else { 1.0 };
        let photons = (budget.photons * share / (1.0 + 0.1 * tau)) as u64;
        let request =
            TraceRequest { stream, seed: budget.seed, ..request(&[tau], case.incidence(), photons) };
        let traced =
            if case.plain { super::plain(medium, &request) } else { super::half_space(medium, &request) };
        let solved = solve(case, budget.tolerance);
        let scores = scores(&traced, &solved);
        let chi_square = endings(&traced, &solved);
        let drawn = (stream as usize * 5).checked_rem(scores.len());
        Self { case, photons, scores, chi_square, drawn }
    }

    pub fn drawn(&self) -> Option<&Score> {
        self.drawn.map(|place| &self.scores[place])
    }
}

/// R and T of each of [`ORDERS`], from the finest of a few tolerances that the solver meets.
fn solve(case: Case, tolerance: f64) -> Vec<(Quantity, Estimate)> {
    let medium = SolveMedium::from(&case.medium());
    let tolerances = std::iter::successors(Some(tolerance), |t| Some(t * 10.0)).take(4);
    let solved = tolerances
        .filter_map(|t| {
            Solver::new(medium.clone(), t).unwrap().orders(&[TAU[case.tau]], &[case.incidence()], 2).ok()
        })
        .next()
        .unwrap();
    assert_eq!(solved.orders(), ORDERS);
    let both = |(n, order): (usize, &Order)| {
        let (r, t) = solved.estimate(0, 0, n);
        [(Quantity::Reflectance(*order), r), (Quantity::Transmittance(*order), t)]
    };
    ORDERS.iter().enumerate().flat_map(both).collect()
}

/// z of every number that is neither rare nor nearly certain; its standard error is that of the solver's probability.
fn scores(traced: &Traced, solved: &[(Quantity, Estimate)]) -> Vec<Score> {
    let n = traced.photons() as f64;
    let score = |(quantity, solved): &(Quantity, Estimate)| {
        let p = solved.value;
        let value = traced.hits(0, *quantity) as f64 / n;
        let std_error = (p * (1.0 - p) / n).max(0.0).sqrt();
        let z = z_score(Estimate { value, std_error }, *solved);
        Score { quantity: *quantity, traced: value, solved: *solved, std_error, z }
    };
    let enough = |(_, p): &&(Quantity, Estimate)| n * p.value.min(1.0 - p.value) >= ENOUGH;
    solved.iter().filter(enough).map(score).collect()
}

/// χ² of all ways a photon can end: orders 0, 1, 2 and later on either side, and absorption.
fn endings(traced: &Traced, solved: &[(Quantity, Estimate)]) -> ChiSquare {
    let n = traced.photons() as f64;
    let ends = solved.iter().filter(|(q, _)| {
        !matches!(q, Quantity::Reflectance(Order::Total) | Quantity::Transmittance(Order::Total))
    });
    let (mut observed, mut expected): (Vec<u64>, Vec<f64>) =
        ends.map(|(q, p)| (traced.hits(0, *q), n * p.value.max(0.0))).unzip();
    observed.push(traced.absorbed_hits(0));
    expected.push((n - expected.iter().fold(0.0, |sum, e| sum + e)).max(0.0));
    chi_square(&observed, &expected).unwrap()
}

/// The whole grid.
pub struct Agreement {
    pub rows: Vec<Row>,
}

impl Agreement {
    pub fn new(budget: Budget) -> Self {
        Self::planted(design(), budget, Case::medium)
    }

    /// `cases` with the media that `traced` names in place of the right ones.
    pub fn planted(cases: Vec<Case>, budget: Budget, traced: impl Fn(&Case) -> TraceMedium) -> Self {
        let row = |(stream, case): (u32, Case)| Row::new(case, &traced(&case), stream, budget);
        Self { rows: (0..).zip(cases).map(row).collect() }
    }

    pub fn numbers(&self) -> usize {
        self.rows.iter().map(|row| row.scores.len()).sum()
    }

    pub fn worst(&self) -> (&Row, &Score) {
        let all = self.rows.iter().flat_map(|row| row.scores.iter().map(move |score| (row, score)));
        all.max_by(|a, b| a.1.z.abs().total_cmp(&b.1.z.abs())).unwrap()
    }

    pub fn threshold(&self, alpha: f64) -> f64 {
        family_threshold(alpha, self.numbers()).unwrap()
    }

    /// Cases whose χ² fails, family-wise rate `alpha`.
    pub fn chi_square_failures(&self, alpha: f64) -> Vec<String> {
        let p: Vec<f64> = self.rows.iter().map(|row| row.chi_square.p_value).collect();
        let fails = holm(&p, alpha).unwrap();
        self.rows.iter().zip(fails).filter(|(_, fails)| *fails).map(|(row, _)| row.case.name()).collect()
    }

    /// One z of each case against the normal distribution.
    pub fn drawn_are_normal(&self) -> KolmogorovSmirnov {
        let drawn: Vec<f64> = self.rows.iter().filter_map(Row::drawn).map(|score| score.z).collect();
        kolmogorov_smirnov(&drawn, |z| 0.5 * libm::erfc(-z * std::f64::consts::FRAC_1_SQRT_2)).unwrap()
    }

    /// The p-values of χ² against the uniform distribution.
    pub fn chi_squares_are_uniform(&self) -> KolmogorovSmirnov {
        let p: Vec<f64> = self.rows.iter().map(|row| row.chi_square.p_value).collect();
        kolmogorov_smirnov(&p, |p| p).unwrap()
    }

    /// Whether tracers and solver agree; each of the four judgements raises a false alarm in a share `alpha` of seeds.
    pub fn accepts(&self, alpha: f64) -> bool {
        self.worst().1.z.abs() <= self.threshold(alpha)
            && self.chi_square_failures(alpha).is_empty()
            && self.drawn_are_normal().p_value > alpha
            && self.chi_squares_are_uniform().p_value > alpha
    }
}
