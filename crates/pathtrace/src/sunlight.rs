//! The last leg of sunlight: how much arrives at a point, and from where.
//!
//! With l the length within the cloud towards the sun, light that met no wide event on it is Σ_m e^{-κl}(κl)^m/m! Π_j ωP_c(Θ_j) over the
//! forward angles Θ_j: in all e^{-κ(1-ωP_f)l}. m and the Θ_j are drawn for the path's own channel h, with density
//! e^{-λ_h}(ωκl)^m/m! Π P_h(Θ_j), λ_h = ωκP_{f,h} l; the balance heuristic takes the mean of the three densities, products of the path so
//! far included. Legs of more than a few mean free paths are roulette along the way.

use crate::carrier::Carrier;
use crate::layer::{End, Ray};
use crate::light::mean;
use crate::random::{exponential, poisson, turned};
use crate::scene::Scene;
use glam::DVec3;
use rand::Rng;
use rand_pcg::Pcg32;

/// Optical length, of wide events, up to which a leg is followed for certain.
const SURE: f64 = 2.0;

/// Light of the sun at one point.
pub(crate) struct Arrival {
    /// Towards where it comes from.
    pub(crate) direction: DVec3,
    /// Of the sun's irradiance, with the weights of colour.
    pub(crate) share: [f64; 3],
}

/// A leg that roulette left over.
struct Leg {
    length: f64,
    /// 1 over the probability of that.
    weight: f64,
}

impl Scene<'_> {
    fn leg(&self, origin: DVec3, rng: &mut Pcg32) -> Option<Leg> {
        let rate = self.extinction * (1.0 - self.albedo * mean(self.forward));
        // Without scattering by wide angles nothing is lost: the leg is followed for certain.
        let most = if rate > 0.0 { (SURE + exponential(rng)) / rate } else { f64::INFINITY };
        match self.layer.follow(&Ray { origin, direction: self.world.sun.direction }, most) {
            End::Inside(_) => None,
            End::Left(length) => Some(Leg { length, weight: libm::exp((rate * length - SURE).max(0.0)) }),
        }
    }

    /// Light that arrives at a droplet, with its forward events.
    pub(crate) fn sunlight(&self, origin: DVec3, mut carrier: Carrier, rng: &mut Pcg32) -> Option<Arrival> {
        let Leg { length, weight } = self.leg(origin, rng)?;
        let path = self.extinction * length;
        let mean_events = self.forward.map(|forward| self.albedo * path * forward);
        let mut direction = self.world.sun.direction;
        for _ in 0..poisson(libm::exp(-mean_events[carrier.channel]), rng) {
            let v = self.phases.sample(carrier.channel, true, rng.next_u32());
            direction = turned(direction, v, rng);
            carrier.scatter(self.phases.values(v));
        }
        // The densities over e^{-κl}.
        let density = mean(std::array::from_fn(|c| carrier.ratio[c] * libm::exp(path - mean_events[c])));
        let scale = weight / density;
        Some(Arrival { direction, share: carrier.ratio.map(|r| r * scale) })
    }

    /// Light that arrives at the ground, its forward events summed: they leave the flux of the beam as it is.
    pub(crate) fn sunlight_on_ground(&self, origin: DVec3, carrier: &Carrier, rng: &mut Pcg32) -> [f64; 3] {
        let Some(Leg { length, weight }) = self.leg(origin, rng) else { return [0.0; 3] };
        let path = self.extinction * length;
        let cosine = self.world.sun.direction.z;
        let through = self.forward.map(|forward| libm::exp(-path * (1.0 - self.albedo * forward)));
        std::array::from_fn(|c| carrier.ratio[c] * weight * cosine * through[c])
    }
}
