//! The photons of one trace on the device, and the dispatches that move them.

use crate::books::{Books, LEDGER};
use crate::lanes::Lanes;
use crate::pace::Pace;
use crate::rounds::{BATCHES, Queue};
use crate::shader::Settings;
use crate::tallies::{BatchCounts, Tallies};
use crate::{GpuTraceError, table};
use std::ops::Range;
use std::sync::atomic::Ordering;
use std::time::Instant;
use stratiform_gpu::{Buffer, Gpu, Kernel, Pass};
use stratiform_transport::{Control, TraceMedium, TraceRequest, TransportError};

/// One trace on the device.
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
    launched: Vec<u64>,
    books: Books,
    pace: Pace,
}

impl<'a> Flock<'a> {
    /// `tau` ascends; `photons` are to be expected.
    pub fn new(
        gpu: &'a Gpu,
        kernel: &'a Kernel,
        medium: &TraceMedium,
        request: &TraceRequest,
        tau: &[f64],
        photons: u64,
    ) -> Result<Self, GpuTraceError> {
        let settings = Settings::new(medium, request);
        let bottoms = tau.iter().map(|tau| (tau * medium.extinction()) as f32);
        let bottoms: Vec<f32> = bottoms.chain([f32::MAX]).collect();
        Ok(Self {
            gpu,
            kernel,
            settings,
            uniform: gpu.upload(bytemuck::bytes_of(&settings))?,
            bottoms: gpu.upload(bytemuck::cast_slice(&bottoms))?,
            table: gpu.upload(bytemuck::cast_slice(&table::pieces(medium.table().phase().as_ref())))?,
            ledger: gpu.zeroed(4 * LEDGER)?,
            lanes: Lanes::new(gpu, photons)?,
            tallies: Tallies::new(gpu, tau.len(), settings.bins as usize)?,
            launched: vec![0; BATCHES as usize],
            books: Books::default(),
            pace: Pace::new(),
        })
    }

    /// Traces these photons, which begin with a round, to their ends.
    pub fn trace(&mut self, photons: Range<u64>, control: Control<'_>) -> Result<(), GpuTraceError> {
        self.lanes.open();
        let end = photons.end;
        for queue in Queue::all(photons) {
            self.empty(queue, control)?;
            if queue.end() == end {
                self.land(control)?;
            }
            self.tallies.flush(self.gpu)?;
        }
        Ok(())
    }

    /// Launches all photons of a queue.
    fn empty(&mut self, queue: Queue, control: Control<'_>) -> Result<(), GpuTraceError> {
        (0..).zip(&mut self.launched).for_each(|(batch, launched)| *launched += queue.share(batch));
        self.settings.enqueue(queue);
        let start = self.books.launched;
        let mut taken = 0;
        while taken < queue.count {
            self.dispatch(taken, control)?;
            taken = (self.books.launched - start) as u32;
        }
        Ok(())
    }

    /// Lets the photons in flight come to their ends.
    fn land(&mut self, control: Control<'_>) -> Result<(), GpuTraceError> {
        while let in_flight @ 1.. = self.books.in_flight {
            self.lanes.close_up(self.gpu, in_flight.unsigned_abs())?;
            self.dispatch(self.settings.count, control)?;
        }
        Ok(())
    }

    /// One dispatch after `taken` photons of the queue were launched.
    fn dispatch(&mut self, taken: u32, control: Control<'_>) -> Result<(), GpuTraceError> {
        if control.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed)) {
            return Err(TransportError::Cancelled.into());
        }
        let start = Instant::now();
        self.settings.steps = self.pace.steps();
        self.gpu.replace(&self.uniform, bytemuck::bytes_of(&self.settings))?;
        self.gpu.replace(&self.ledger, bytemuck::bytes_of(&[taken, 0, 0, 0, 0, 0]))?;
        let [counts, scatterings] = self.tallies.buffers();
        let buffers = [
            &self.uniform,
            &self.bottoms,
            &self.table,
            &self.lanes.photons,
            &self.ledger,
            counts,
            scatterings,
        ];
        let groups = [self.lanes.groups, 1, 1];
        self.gpu.submit_passes(&[Pass { name: "trace", kernel: self.kernel, buffers: &buffers, groups }])?;
        let ledger = self.gpu.download(&self.ledger)?;
        self.books.enter(&bytemuck::pod_read_unaligned(&ledger))?;
        self.pace.took(start.elapsed());
        Ok(())
    }

    /// Counts of every batch.
    pub fn batches(&self) -> Vec<BatchCounts> {
        (0..).zip(&self.launched).map(|(batch, &launched)| self.tallies.batch(batch, launched)).collect()
    }
}
