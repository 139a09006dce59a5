//! What a device can refuse.

/// A device that is missing, or that refused work.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GpuError {
    /// The machine has no adapter.
    #[error("no Vulkan adapter: {reason}")]
    NoAdapter {
        /// What the driver layer said.
        reason: String,
    },
    /// The adapter could not be opened.
    #[error("cannot open the graphics device: {reason}")]
    Device {
        /// What the driver layer said.
        reason: String,
    },
    /// A buffer whose size no device takes.
    #[error("buffer {binding} has {bytes} bytes: a positive multiple of 4 is needed")]
    BufferSize {
        /// Index of the binding.
        binding: usize,
        /// Its size.
        bytes: usize,
    },
    /// The driver takes no SPIR-V.
    #[error("{adapter} takes no SPIR-V module as it is")]
    NoSpirv {
        /// The adapter.
        adapter: String,
    },
    /// The shader or the dispatch is not valid.
    #[error("the device refused the shader: {reason}")]
    Refused {
        /// The validation message.
        reason: String,
    },
    /// A buffer that the device has no room for.
    #[error("the device has no room for {bytes} bytes: {reason}")]
    OutOfMemory {
        /// Its size.
        bytes: usize,
        /// What the device said.
        reason: String,
    },
    /// The device is gone: a driver that crashed, a card that was taken away, or [`Gpu::lose`](crate::Gpu::lose).
    #[error("the graphics device was lost: {reason}")]
    Lost {
        /// What the driver layer said.
        reason: String,
    },
    /// No adapter can show pictures in the window.
    #[error("no Vulkan adapter can show pictures in this window: {reason}")]
    NoScreen {
        /// What the driver layer said.
        reason: String,
    },
    /// The window's surface is gone; another one may serve.
    #[error("the window's surface was lost")]
    ScreenLost,
    /// The work did not end, or its result could not be read.
    #[error("the device failed: {reason}")]
    Failed {
        /// What the driver layer said.
        reason: String,
    },
}

impl GpuError {
    pub(crate) fn failed(error: impl std::fmt::Display) -> Self {
        Self::Failed { reason: error.to_string() }
    }
}
