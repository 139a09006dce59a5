//! The photons in flight: one per invocation.

use crate::shader::{Photon, WORKGROUP};
use stratiform_gpu::{Buffer, Gpu, GpuError};

/// Most photons in flight at once.
const MOST: u32 = 1 << 17;
/// Photons that one invocation should trace, if there are so many: then few invocations wait for the last photons.
const SHARE: u32 = 8;

/// Invocations with their photons.
pub(crate) struct Lanes {
    pub photons: Buffer,
    /// Workgroups that are dispatched.
    pub groups: u32,
}

impl Lanes {
    /// No photon in any.
    pub fn new(gpu: &Gpu) -> Result<Self, GpuError> {
        Ok(Self { photons: gpu.zeroed(MOST as usize * size_of::<Photon>())?, groups: 0 })
    }

    /// Makes room for so many photons to be traced, when none is in flight.
    pub fn open(&mut self, photons: u32) {
        self.groups = (photons / SHARE).clamp(1, MOST).div_ceil(WORKGROUP);
    }

    /// Gathers the last photons in the first workgroups, and leaves out the rest, if that saves most of them.
    pub fn close_up(&mut self, gpu: &Gpu, in_flight: u64) -> Result<(), GpuError> {
        let needed = in_flight.div_ceil(WORKGROUP.into()) as u32;
        if 4 * needed > self.groups {
            return Ok(());
        }
        let bytes = gpu.download(&self.photons)?;
        let photons = bytes.chunks_exact(size_of::<Photon>()).map(bytemuck::pod_read_unaligned::<Photon>);
        let mut gathered: Vec<Photon> = photons.filter(|photon| photon.fate != 0).collect();
        gathered.resize(MOST as usize, bytemuck::Zeroable::zeroed());
        self.groups = needed;
        gpu.replace(&self.photons, bytemuck::cast_slice(&gathered))
    }
}
