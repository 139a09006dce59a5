//! What to trace, and when to stop.

use crate::TransportError;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use stratiform_quantities::{Incidence, OpticalThickness, Range};

/// Largest number of thicknesses times orders (0…N and the tail) in one trace.
pub const MAX_ROWS: usize = 1 << 16;

/// Photons of one trace: two at least, so that their scatter is known.
pub const PHOTONS: Range = Range::closed(2.0, 281_474_976_710_656.0);

/// When enough photons are traced.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Stop {
    /// After exactly this many, 2…2⁴⁸.
    Photons(u64),
    /// As soon as no row's standard error exceeds `target`, looked at after each round, or after `max_photons`.
    StdError {
        /// Largest standard error wanted of any reflectance or transmittance.
        target: f64,
        /// Upper limit, 2…2⁴⁸.
        max_photons: u64,
    },
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Stop::Photons(photons) => write!(f, "{photons}"),
            Stop::StdError { target, max_photons } => write!(f, "at most {max_photons} to reach {target}"),
        }
    }
}

impl Stop {
    pub(crate) fn max_photons(self) -> u64 {
        match self {
            Stop::Photons(photons) | Stop::StdError { max_photons: photons, .. } => photons,
        }
    }

    pub(crate) fn target(self) -> Option<f64> {
        match self {
            Stop::Photons(_) => None,
            Stop::StdError { target, .. } => Some(target),
        }
    }
}

/// One incidence, any number of thicknesses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TraceRequest {
    /// Optical thicknesses of the full medium, in any order; 0 is allowed.
    pub tau: Vec<f64>,
    /// Beam or diffuse light.
    #[serde(with = "as_text")]
    pub incidence: Incidence,
    /// When to stop.
    pub stop: Stop,
    /// Largest order listed by itself; later ones form the tail.
    pub max_order: u32,
    /// Seed of every random stream.
    pub seed: u64,
    /// Tells media and incidences of one run apart, so that they share no random numbers.
    pub stream: u32,
}

impl TraceRequest {
    /// Rows of one thickness: orders 0…N and the tail.
    pub(crate) fn bins(&self) -> usize {
        self.max_order as usize + 2
    }

    /// Checks every number, as the tracers do before they start.
    ///
    /// # Errors
    /// [`TransportError`] naming the number that is out of domain.
    pub fn check(&self) -> Result<(), TransportError> {
        if self.tau.is_empty() {
            return Err(TransportError::NoThickness);
        }
        for &tau in &self.tau {
            OpticalThickness::new(tau)?;
        }
        PHOTONS.check("photons", self.stop.max_photons() as f64)?;
        if let Some(target) = self.stop.target() {
            Range::above(0.0).check("target standard error", target)?;
        }
        let (thicknesses, orders) = (self.tau.len(), self.bins());
        if thicknesses.saturating_mul(orders) > MAX_ROWS {
            return Err(TransportError::TooManyRows { thicknesses, orders, max: MAX_ROWS });
        }
        Ok(())
    }
}

/// Incidence as text, since not every format tells numbers from words. All digits are kept.
mod as_text {
    use super::{Deserialize, Deserializer, Incidence, Serializer};

    pub fn serialize<S: Serializer>(incidence: &Incidence, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(incidence)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Incidence, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
    }
}
