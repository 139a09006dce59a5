//! What the device reports outside of any call: that it is lost, or an error that nobody asked for.

use crate::GpuError;
use std::sync::{Arc, Mutex, PoisonError};

/// The first fault of a device, shared by its clones.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fault(Arc<Mutex<Option<GpuError>>>);

impl Fault {
    /// Listens to a device.
    pub fn watch(device: &wgpu::Device) -> Self {
        let fault = Self::default();
        let (lost, refused) = (fault.clone(), fault.clone());
        device.set_device_lost_callback(move |why, message| {
            lost.set(GpuError::Lost { reason: format!("{message} ({why:?})") });
        });
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| refused.set(GpuError::failed(error))));
        fault
    }

    /// Nothing, or the fault.
    ///
    /// # Errors
    /// The first fault.
    pub fn check(&self) -> Result<(), GpuError> {
        let fault = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        fault.clone().map_or(Ok(()), Err)
    }

    /// The fault, if there is one, for whatever came out.
    ///
    /// # Errors
    /// The first fault; that of `result`.
    pub fn explain<T>(&self, result: Result<T, GpuError>) -> Result<T, GpuError> {
        self.check().and(result)
    }

    fn set(&self, error: GpuError) {
        let mut fault = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        fault.get_or_insert(error);
    }
}
