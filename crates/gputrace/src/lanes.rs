//! The photons in flight: one per invocation.

use crate::shader::{Photon, WORKGROUP};
use stratiform_gpu::{Buffer, Gpu, GpuError};

/// Most photons in flight at once.
const MOST: u64 = 1 << 17;
/// Photons that one invocation should trace, if there are so many: then few invocations wait for the last photons.
const SHARE: u64 = 8;

/// Invocations with their photons.
pub(crate) struct Lanes {
    pub photons: Buffer,
    all: u32,
    /// Workgroups that are dispatched.
    pub groups: u32,
}

impl Lanes {
    /// For a trace of so many photons.
    pub fn new(gpu: &Gpu, photons: u64) -> Result<Self, GpuError> {
        let workgroup = u64::from(WORKGROUP);
        let groups = (photons / SHARE).clamp(1, MOST).div_ceil(workgroup) as u32;
        let bytes = (groups * WORKGROUP) as usize * size_of::<Photon>();
        Ok(Self { photons: gpu.zeroed(bytes)?, all: groups, groups })
    }

    /// All invocations again.
    pub fn open(&mut self) {
        self.groups = self.all;
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
        gathered.resize((self.all * WORKGROUP) as usize, bytemuck::Zeroable::zeroed());
        self.groups = needed;
        gpu.replace(&self.photons, bytemuck::cast_slice(&gathered))
    }
}
