//! Short names of what photons depend on: a medium by its content, a tracer by what it does.
//!
//! Both are BLAKE3 hashes cut to 128 bits, in hexadecimal. Equal media have equal names whatever files they came from;
//! a tracer whose photons fare otherwise than before has another name even if nobody changed a version number.

use crate::trace_job::{Engine, Tracer};
use crate::{Stop, Tally, TraceMedium, TraceRequest, TransportError};
use std::sync::Arc;
use stratiform_optics::phase::HenyeyGreenstein;
use stratiform_quantities::{Asymmetry, Incidence, SingleScatteringAlbedo};

/// Equally probable angles at which a phase function is looked at.
const ANGLES: u32 = 8192;
/// Photons by which a tracer is known.
const PHOTONS: u64 = 500;

/// The medium's name: extinction, albedo, and the phase function at 8192 equally probable angles.
pub(crate) fn of_medium(medium: &TraceMedium) -> String {
    let phase = medium.phase();
    let angles = (0..ANGLES).flat_map(|k| {
        let v = phase.invert((f64::from(k) + 0.5) / f64::from(ANGLES));
        [v, phase.value(v)]
    });
    of_words([medium.extinction(), medium.albedo()].into_iter().chain(angles).map(f64::to_bits))
}

/// The tracer's name: what 500 photons count in three slabs of a fixed medium that absorbs.
pub(crate) fn of_tracer(tracer: Tracer) -> Result<String, TransportError> {
    let phase = Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85)?));
    let medium = TraceMedium::full(phase, SingleScatteringAlbedo::new(0.98)?);
    let tau = vec![0.5, 4.0, 20.0];
    let (incidence, stop) = (Incidence::Diffuse, Stop::Photons(PHOTONS));
    let request = TraceRequest { tau, incidence, stop, max_order: 10, seed: 2006, stream: 1 };
    let engine = Engine::new(tracer, &medium, &request);
    let empty = Tally::new(request.tau.len(), request.bins(), engine.nested());
    Ok(of_words(engine.count(0..PHOTONS, empty).words()))
}

fn of_words(words: impl Iterator<Item = u64>) -> String {
    let mut hash = blake3::Hasher::new();
    words.for_each(|word| {
        hash.update(&word.to_le_bytes());
    });
    hash.finalize().to_hex()[..32].to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_optics::phase::{Modified, PhaseFunction, Rayleigh};

    fn hg(g: f64) -> Arc<dyn PhaseFunction> {
        Arc::new(HenyeyGreenstein::new(Asymmetry::new(g).unwrap()))
    }

    #[test]
    fn media_are_known_by_their_content() {
        let full = |phase, omega| TraceMedium::full(phase, SingleScatteringAlbedo::new(omega).unwrap());
        let omega = SingleScatteringAlbedo::CONSERVATIVE;
        let cut = |angle| {
            let cut = Modified::new(hg(0.85), angle).unwrap();
            let forward = cut.forward_fraction();
            TraceMedium::modified(Arc::new(cut), omega, forward).unwrap()
        };
        let media = [
            full(hg(0.85), 1.0),
            full(hg(0.85), 0.999_999_999),
            full(hg(0.850_000_000_1), 1.0),
            full(Arc::new(Rayleigh), 1.0),
            cut(5.0),
            cut(5.000_001),
        ];
        let names = media.map(|medium| of_medium(&medium));
        for (i, name) in names.iter().enumerate() {
            assert!(!names[..i].contains(name), "medium {i}");
        }
        assert_eq!(names[0], of_medium(&full(hg(0.85), 1.0)));
    }

    #[test]
    fn tracers_are_known_by_their_counts() {
        let name = |tracer| of_tracer(tracer).unwrap();
        assert_eq!(name(Tracer::HalfSpace), name(Tracer::HalfSpace));
        assert_ne!(name(Tracer::HalfSpace), name(Tracer::Plain));
    }
}
