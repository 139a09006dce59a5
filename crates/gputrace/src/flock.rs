//! The photons of one request on the device, and the dispatches that move them.

use crate::GpuTraceError;
use crate::books::{Books, LEDGER};
use crate::lanes::Lanes;
use crate::pace::Pace;
use crate::shader::Settings;
use crate::tallies::Tallies;
use std::sync::atomic::Ordering;
use std::time::Instant;
use stratiform_gpu::{Buffer, Gpu, Kernel, Pass};
use stratiform_transport::{Control, Stretch, Tally, TraceMedium, TraceRequest, TransportError};

/// One request on the device.
pub(crate) struct Flock<'a> {
    gpu: &'a Gpu,
    kernel: &'a Kernel,
    settings: Settings,
    uniform: Buffer,
    bottoms: Buffer,
    table: Buffer,
    ledger: Buffer,
    lanes: Lanes,
    tallies: Tallies,
    pace: Pace,
}

impl<'a> Flock<'a> {
    /// For a request that has been checked.
    pub fn new(
        gpu: &'a Gpu,
        kernel: &'a Kernel,
        medium: &TraceMedium,
        request: &TraceRequest,
    ) -> Result<Self, GpuTraceError> {
        let settings = Settings::new(medium, request);
        let table: Vec<u64> = medium.pieces().words().collect();
        Ok(Self {
            gpu,
            kernel,
            settings,
            uniform: gpu.upload(bytemuck::bytes_of(&settings))?,
            bottoms: gpu.upload(bytemuck::cast_slice(&bottoms(medium, request)))?,
            table: gpu.upload(bytemuck::cast_slice(&table))?,
            ledger: gpu.zeroed(4 * LEDGER)?,
            lanes: Lanes::new(gpu)?,
            tallies: Tallies::new(gpu, request.tau.len(), settings.bins as usize)?,
            pace: Pace::new(),
        })
    }

    /// Traces a stretch of at most 2³⁰ photons to their ends; tells how many have ended after each dispatch.
    pub fn trace(
        &mut self,
        stretch: &Stretch,
        empty: &Tally,
        control: Control<'_>,
        ended: impl Fn(u64),
    ) -> Result<Box<[Tally; Stretch::BATCHES]>, GpuTraceError> {
        self.settings.enqueue(stretch);
        self.lanes.open(self.settings.count);
        let mut books = Books::default();
        while books.ended() < self.settings.count.into() {
            if control.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed)) {
                return Err(TransportError::Cancelled.into());
            }
            if books.launched == u64::from(self.settings.count) {
                self.lanes.close_up(self.gpu, books.in_flight.unsigned_abs())?;
            }
            self.dispatch(&mut books)?;
            ended(books.ended());
        }
        Ok(self.tallies.take(self.gpu, empty, stretch.shares())?)
    }

    fn dispatch(&mut self, books: &mut Books) -> Result<(), GpuTraceError> {
        let start = Instant::now();
        self.settings.looks = self.pace.looks();
        self.gpu.replace(&self.uniform, bytemuck::bytes_of(&self.settings))?;
        self.gpu.replace(&self.ledger, bytemuck::bytes_of(&[books.launched as u32, 0, 0, 0, 0, 0]))?;
        let buffers = [
            &self.uniform,
            &self.bottoms,
            &self.table,
            &self.lanes.photons,
            &self.ledger,
            &self.tallies.counts,
            &self.tallies.scatterings,
        ];
        let groups = [self.lanes.groups, 1, 1];
        self.gpu.submit_passes(&[Pass { name: "trace", kernel: self.kernel, buffers: &buffers, groups }])?;
        let ledger = self.gpu.download(&self.ledger)?;
        let before = books.launched;
        books.enter(&bytemuck::pod_read_unaligned(&ledger))?;
        if books.in_flight == 0 && books.launched == before && before < self.settings.count.into() {
            return Err(GpuTraceError::Stalled(*books));
        }
        self.pace.took(start.elapsed());
        Ok(())
    }
}

/// Depths at which photons are counted, ascending, and one that none reaches.
fn bottoms(medium: &TraceMedium, request: &TraceRequest) -> Vec<f32> {
    let mut depths: Vec<f64> = request.tau.iter().map(|tau| tau * medium.extinction()).collect();
    depths.sort_by(f64::total_cmp);
    depths.into_iter().map(|depth| depth as f32).chain([f32::MAX]).collect()
}
