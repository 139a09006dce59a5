//! What one azimuthal mode sends out of a slab beyond the second order.
//!
//! With S = Σσφ, D = Σδψ (see `solve::modes`) the beam drives σ' = -δ + βe^{-λt}, δ' = -k²σ + αe^{-λt}, α and β
//! being the beam's scattering into the mode. p = kσ+δ and r = kσ-δ run down and up alone: a particular solution
//! in which no p enters above and no r below has closed depth integrals, those of order 2 with k in
//! place of 1/μ' (`depth`), regular at k = 1/μ0. What it lets in at the faces is taken back by a solution
//! without beam, even and odd about the middle, without growing exponentials. The sum over streams of
//! order 2, which the discrete ordinates contain, is subtracted: the exact one stands in its place (`double`).
//!
//! A lossless medium has k = 0 at m = 0, where p and r coincide: k is raised to 1e-8 or 1e-5/τ, which changes
//! nothing by more than 1e-8.

use super::depth::{Exit, Vias, first};
use super::elementary::mean_exponential;
use super::mode::{Mode, Towards};
use super::paths::Paths;
use crate::solve::matrix::Matrix;
use crate::solve::slab::slope;

/// One mode in one slab.
pub(super) struct Response<'a> {
    mode: &'a Mode<'a>,
    tau: f64,
    decay: Vec<f64>,
    /// Amplitudes of the solution without beam, even and odd, for each sun.
    amplitudes: Vec<(Vec<f64>, Vec<f64>)>,
}

/// A direction with its scattering.
pub(super) struct Ray {
    pub(super) mu: f64,
    pub(super) towards: Towards,
}

impl<'a> Response<'a> {
    /// τ of the scaled medium.
    pub(super) fn new(mode: &'a Mode<'a>, tau: f64, suns: &[&Ray]) -> Self {
        let least = f64::max(1e-8, 1e-5 / tau.max(1.0));
        let decay: Vec<f64> = mode.decay.rates.iter().map(|k| k.max(least)).collect();
        let (phi, psi) = (&mode.decay.sum, &mode.decay.difference);
        let slopes: Vec<(f64, f64)> = decay.iter().map(|k| slope(*k, tau)).collect();
        let count = decay.len();
        let even = Matrix::from_fn(count, |i, j| phi[(j, i)] + decay[j] * slopes[j].0 * psi[(j, i)]);
        let odd = Matrix::from_fn(count, |i, j| psi[(j, i)] + slopes[j].1 * phi[(j, i)]);
        let lit: Vec<(Vec<f64>, Vec<f64>)> =
            suns.iter().map(|sun| entering(mode, &decay, tau, sun)).collect();
        let (sums, differences) = lit.into_iter().unzip();
        let amplitudes = even.solve_each(sums).into_iter().zip(odd.solve_each(differences)).collect();
        Self { mode, tau, decay, amplitudes }
    }

    /// Contribution of the mode to πL/(μ0F0), orders 3 and above; `by_streams` are the depth integrals of the streams.
    pub(super) fn beyond_twice(
        &self,
        (place, sun): (usize, &Ray),
        view: &Ray,
        exit: &Exit,
        by_streams: &Vias,
    ) -> f64 {
        let omega = self.mode.medium().albedo;
        let (even, odd) = self.without_beam(&self.amplitudes[place], view);
        let free = 0.5 * omega * if exit.top { even + odd } else { even - odd };
        let (s, v) = (&sun.towards, &view.towards);
        let by_modes = exit.via(&self.decay);
        let driven = self.decay.iter().enumerate().fold(0.0, |sum, (j, &k)| {
            let (into, out) = ((s.sum[j], k * s.difference[j]), (v.sum[j], k * v.difference[j]));
            sum + pair(exit.top, (by_modes.down[j], by_modes.up[j]), into, out) / k
        });
        let second = self.mode.streams().mu.iter().enumerate().fold(0.0, |sum, (i, mu)| {
            let (into, out) = ((s.even[i], s.odd[i]), (v.even[i], v.odd[i]));
            sum + pair(exit.top, (by_streams.down[i], by_streams.up[i]), into, out) / mu
        });
        free + 0.125 * omega * omega * exit.sun * exit.view * (driven - second)
    }

    /// Radiance towards the view above, half of it even, half odd about the middle.
    fn without_beam(&self, (sums, differences): &(Vec<f64>, Vec<f64>), view: &Ray) -> (f64, f64) {
        let towards = &view.towards;
        let paths = Paths::new(&self.decay, self.tau, view.mu);
        let (mut even, mut odd) = (0.0, 0.0);
        for (j, &k) in self.decay.iter().enumerate() {
            let (cosh, sinh_by_k) = (paths.cosh[j], paths.sinh_by_k[j]);
            even += sums[j] * (towards.sum[j] * cosh + towards.difference[j] * k * k * sinh_by_k);
            odd -= differences[j] * (towards.sum[j] * sinh_by_k + towards.difference[j] * cosh);
        }
        (even, odd)
    }
}

/// One way down and one way up, each with the scattering into it and out of it, by their depth integrals.
#[inline]
fn pair(top: bool, (down, up): (f64, f64), into: (f64, f64), out: (f64, f64)) -> f64 {
    let (same, opposite) = if top { (out.0 - out.1, out.0 + out.1) } else { (out.0 + out.1, out.0 - out.1) };
    (into.0 + into.1) * same * down + (into.0 - into.1) * opposite * up
}

/// Sum and difference of what must enter above and below to take back the particular solution.
fn entering(mode: &Mode, decay: &[f64], tau: f64, sun: &Ray) -> (Vec<f64>, Vec<f64>) {
    let count = decay.len();
    let (mut sum, mut difference) = (vec![0.0; count], vec![0.0; count]);
    let rate = 1.0 / sun.mu;
    for (j, &k) in decay.iter().enumerate() {
        let (e, o) = (sun.towards.sum[j], k * sun.towards.difference[j]);
        let scale = -0.125 * mode.medium().albedo * rate * tau / k;
        let above = scale * (e - o) * mean_exponential((k + rate) * tau).0;
        let below = scale * (e + o) * first(k * tau, rate * tau);
        let (phi, psi) = (mode.decay.sum.row(j), mode.decay.difference.row(j));
        for i in 0..count {
            let shape = phi[i] - k * psi[i];
            sum[i] += (above + below) * shape;
            difference[i] += (above - below) * shape;
        }
    }
    (sum, difference)
}
