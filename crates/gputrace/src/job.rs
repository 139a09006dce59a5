//! A request on the device, done in parts as [`TraceJob`](stratiform_transport::TraceJob) does it on the CPU.

use crate::flock::Flock;
use crate::{GpuTraceError, GpuTracer};
use std::time::{Duration, Instant};
use stratiform_quantities::Range;
use stratiform_transport::{Control, Identity, Kernel, Part, Share, TraceMedium, TraceRequest};

/// Photons of the first stretch, and most of any.
const STRETCH: [u64; 2] = [1 << 18, 1 << 30];
/// What a stretch should take at least: much more than its last photons by themselves, and not more than one can afford to lose.
const LONG: Duration = Duration::from_secs(1);

/// A request with its medium and tracer.
pub struct GpuJob<'a> {
    tracer: &'a GpuTracer,
    medium: &'a TraceMedium,
    part: Part,
}

impl<'a> GpuJob<'a> {
    /// Checks the request, and takes the fingerprint of the medium (some milliseconds).
    ///
    /// # Errors
    /// [`GpuTraceError::Transport`] naming the number that is out of domain. Slabs deeper than 300 are: the CPU traces them in double
    /// precision.
    pub fn new(
        tracer: &'a GpuTracer,
        medium: &'a TraceMedium,
        request: &TraceRequest,
    ) -> Result<Self, GpuTraceError> {
        let identity = Identity::new("half-space on a graphics device", tracer.adapter(), medium);
        let part = Part::of_engine(identity, request, true)?;
        for tau in &request.tau {
            let deepest = Range::closed(0.0, Kernel::SINGLE_DEPTH);
            deepest.check(
                "extinction of the medium times tau, on a graphics device",
                tau * medium.extinction(),
            )?;
        }
        Ok(Self { tracer, medium, part })
    }

    /// A part with no photon in it yet.
    pub fn part(&self) -> Part {
        self.part.clone()
    }

    /// Traces those photons of `share` that `part` lacks. `keep` sees the part whenever more photons are in it, about once a second.
    ///
    /// # Errors
    /// [`GpuTraceError::Transport`] as a [`TraceJob`](stratiform_transport::TraceJob) has them: when cancelled, the part has all stretches that were done
    /// by then. [`GpuTraceError`] if the device fails or its books do not balance.
    pub fn trace(
        &self,
        part: &mut Part,
        share: Share,
        control: Control<'_>,
        mut keep: impl FnMut(&Part),
    ) -> Result<(), GpuTraceError> {
        part.check_same(&self.part)?;
        let photons = part.share(share)?;
        let total = photons.end - photons.start;
        let mut flock = Flock::new(&self.tracer.gpu, &self.tracer.kernel, self.medium, part.request())?;
        let empty = part.empty_tally();
        let [mut longest, most] = STRETCH;
        while let Some(stretch) = part.next_stretch(share, longest)? {
            let start = Instant::now();
            let before = part.photons();
            let ended = |ended: u64| {
                if let Some(progress) = control.progress {
                    progress.advanced((before + ended).min(total), total);
                }
            };
            let batches = flock.trace(&stretch, &empty, control, ended)?;
            part.add_stretch(&stretch, &batches)?;
            keep(part);
            if start.elapsed() < LONG {
                longest = (2 * longest).min(most);
            }
        }
        Ok(())
    }
}
