//! Compute on the first graphics adapter: one dispatch, bytes in and bytes out ([`Gpu::run`]), or a sequence of passes over buffers that
//! stay on the device ([`Gpu::submit_passes`]).
//!
//! For tests that hold emitted shaders against the f64 model, for the renderer and for tracers on the device. No window and no
//! display are needed; where there is a window, a [`Screen`] shows a buffer of pixels in it. Any Vulkan driver serves, software ones
//! included; which one answered is [`Gpu::adapter`].
//!
//! Mesa's software driver stops loops silently after 65535 iterations per invocation, summed over all its loops:
//! keep dispatches short and count in the shader what was done.

mod dispatch;
mod error;
mod fault;
mod screen;
mod sequence;

pub use error::GpuError;
pub use screen::Screen;
pub use sequence::{Access, Buffer, Kernel, Pass};

use fault::Fault;
use pollster::block_on;

/// A device and its queue; a clone is the same device.
#[derive(Clone, Debug)]
pub struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    adapter: String,
    fault: Fault,
}

impl Gpu {
    /// Opens the adapter that the system prefers.
    ///
    /// # Errors
    /// [`GpuError::NoAdapter`] if there is none, [`GpuError::Device`] if it cannot be opened.
    pub fn new() -> Result<Self, GpuError> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = preferred(&instance, None).map_err(|reason| GpuError::NoAdapter { reason })?;
        Self::open(&adapter)
    }

    fn open(adapter: &wgpu::Adapter) -> Result<Self, GpuError> {
        let info = adapter.get_info();
        let closed = |error: wgpu::RequestDeviceError| GpuError::Device { reason: error.to_string() };
        let descriptor = wgpu::DeviceDescriptor {
            required_features: adapter.features()
                & (wgpu::Features::PASSTHROUGH_SHADERS | wgpu::Features::TIMESTAMP_QUERY),
            ..Default::default()
        };
        let (device, queue) = block_on(adapter.request_device(&descriptor)).map_err(closed)?;
        let fault = Fault::watch(&device);
        let adapter = format!("{} ({}, {})", info.name, info.backend, info.driver_info);
        Ok(Self { device, queue, adapter, fault })
    }

    /// Gives the device up, as a crashed driver would: whatever is asked of it afterwards is [`GpuError::Lost`].
    pub fn lose(&self) {
        self.device.destroy();
        // The callback comes with the next poll; a device that is gone need not answer it.
        let _ = self.device.poll(wgpu::PollType::Poll);
    }

    /// Name, backend and driver version of the adapter.
    pub fn adapter(&self) -> &str {
        &self.adapter
    }
}

/// The adapter that the system prefers, of those that can show pictures on the surface.
fn preferred(instance: &wgpu::Instance, surface: Option<&wgpu::Surface>) -> Result<wgpu::Adapter, String> {
    let options = wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::HighPerformance,
        compatible_surface: surface,
        ..Default::default()
    };
    block_on(instance.request_adapter(&options)).map_err(|error| error.to_string())
}
