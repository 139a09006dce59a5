//! What the tests share: media, requests, and the comparator.

#![allow(dead_code, reason = "each test program uses a part")]
#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;
use std::sync::Arc;
use stratiform_optics::phase::{HenyeyGreenstein, Isotropic, Modified, Norm, PhaseFunction, PhaseTable};
use stratiform_quantities::{Asymmetry, Incidence, Order, SingleScatteringAlbedo};
use stratiform_stats::{Estimate, family_threshold, z_score};
use stratiform_transport::{Control, Stop, TraceMedium, TraceRequest, Traced, trace_half_space, trace_plain};

pub mod agreement;
pub mod published;

pub fn hg(g: f64) -> Arc<dyn PhaseFunction> {
    Arc::new(HenyeyGreenstein::new(Asymmetry::new(g).unwrap()))
}

pub fn isotropic() -> Arc<dyn PhaseFunction> {
    Arc::new(Isotropic)
}

pub fn full(phase: Arc<dyn PhaseFunction>, omega: f64) -> TraceMedium {
    TraceMedium::full(phase, SingleScatteringAlbedo::new(omega).unwrap())
}

pub fn modified(phase: Arc<dyn PhaseFunction>, omega: f64, forward_fraction: f64) -> TraceMedium {
    TraceMedium::modified(phase, SingleScatteringAlbedo::new(omega).unwrap(), forward_fraction).unwrap()
}

/// The paper's cloud at 0.55 µm as accepted in fit-configs.
pub fn cloud() -> Arc<dyn PhaseFunction> {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    Arc::new(PhaseTable::read(Path::new(file), Norm::Strict).unwrap())
}

/// The cloud's modified medium, θ_f = 5°.
pub fn modified_cloud() -> TraceMedium {
    let cut = Modified::new(cloud(), 5.0).unwrap();
    let forward_fraction = cut.forward_fraction();
    modified(Arc::new(cut), 1.0, forward_fraction)
}

pub fn request(tau: &[f64], incidence: Incidence, photons: u64) -> TraceRequest {
    TraceRequest {
        tau: tau.to_vec(),
        incidence,
        stop: Stop::Photons(photons),
        max_order: 2,
        seed: 20_060_905,
        stream: 0,
    }
}

pub fn half_space(medium: &TraceMedium, request: &TraceRequest) -> Traced {
    trace_half_space(medium, request, Control::default()).unwrap()
}

pub fn plain(medium: &TraceMedium, request: &TraceRequest) -> Traced {
    trace_plain(medium, request, Control::default()).unwrap()
}

pub fn beam(mu0: f64) -> Incidence {
    Incidence::beam(mu0).unwrap()
}

pub fn exact(value: f64) -> Estimate {
    Estimate { value, std_error: 0.0 }
}

/// A family of comparisons: it fails if any |z| exceeds the Šidák threshold of the whole.
#[derive(Default)]
pub struct Family {
    scores: Vec<(String, f64)>,
}

impl Family {
    pub fn compare(&mut self, name: impl Into<String>, a: Estimate, b: Estimate) {
        self.scores.push((name.into(), z_score(a, b)));
    }

    /// Reflectance and transmittance of every order, absorptance and number of scatterings.
    pub fn compare_all(&mut self, name: &str, a: &Traced, b: &Traced) {
        for (i, tau) in a.tau().iter().enumerate() {
            for order in a.orders() {
                let ((ra, ta), (rb, tb)) = (a.estimate(i, order), b.estimate(i, order));
                self.compare(format!("{name}, tau {tau}, R {order}"), ra, rb);
                self.compare(format!("{name}, tau {tau}, T {order}"), ta, tb);
            }
            self.compare(format!("{name}, tau {tau}, absorbed"), a.absorptance(i), b.absorptance(i));
            let (na, nb) = (a.mean_scatterings(i), b.mean_scatterings(i));
            self.compare(format!("{name}, tau {tau}, scatterings"), na, nb);
        }
    }

    pub fn worst(&self) -> (&str, f64) {
        let worst = self.scores.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).unwrap();
        (&worst.0, worst.1)
    }

    /// Whether the family passes with false-alarm rate `alpha`.
    pub fn accepts(&self, alpha: f64) -> bool {
        self.worst().1.abs() <= family_threshold(alpha, self.scores.len()).unwrap()
    }

    pub fn assert(&self, alpha: f64) {
        let (name, z) = self.worst();
        assert!(self.accepts(alpha), "{name}: z = {z:.2}, the worst of {}", self.scores.len());
    }
}

pub fn reflectance(traced: &Traced, i: usize, order: Order) -> Estimate {
    traced.estimate(i, order).0
}

pub fn transmittance(traced: &Traced, i: usize, order: Order) -> Estimate {
    traced.estimate(i, order).1
}

/// `rest`, mixed with no deflection at all.
pub struct ForwardDelta {
    pub share: f64,
    pub rest: Arc<dyn PhaseFunction>,
}

impl PhaseFunction for ForwardDelta {
    fn value(&self, v: f64) -> f64 {
        (1.0 - self.share) * self.rest.value(v)
    }

    fn cumulative(&self, v: f64) -> f64 {
        self.share + (1.0 - self.share) * self.rest.cumulative(v)
    }

    fn invert(&self, xi: f64) -> f64 {
        if xi < self.share { 0.0 } else { self.rest.invert((xi - self.share) / (1.0 - self.share)) }
    }

    fn asymmetry(&self) -> f64 {
        self.share + (1.0 - self.share) * self.rest.asymmetry()
    }

    fn moments(&self, count: usize) -> Vec<f64> {
        self.rest.moments(count).iter().map(|chi| self.share + (1.0 - self.share) * chi).collect()
    }
}

/// H(μ) of isotropic scattering: ln H = -(μ/π)∫ ln(1 - ωθ cotθ)/(cos²θ + μ²sin²θ) dθ over a quarter circle (Stibbs & Weir 1959).
pub fn h_function(omega: f64, mu: f64) -> f64 {
    const PANELS: usize = 20_000;
    let f = |theta: f64| {
        let (s, c) = (libm::sin(theta), libm::cos(theta));
        let cotangent = if theta == 0.0 { 1.0 } else { theta * c / s };
        libm::log1p(-omega * cotangent) / (c * c + mu * mu * s * s)
    };
    let h = FRAC_PI_2 / PANELS as f64;
    let simpson = (0..=PANELS).fold(0.0, |sum, i| {
        let weight = if i == 0 || i == PANELS { 1.0 } else { [2.0, 4.0][i % 2] };
        sum + weight * f(h * i as f64)
    });
    libm::exp(-mu / PI * simpson * h / 3.0)
}
