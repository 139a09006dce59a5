//! A window's surface, and the pass that shows a buffer of pixels on it.

mod pipeline;

use crate::{Buffer, Gpu, GpuError, preferred};
use pollster::block_on;
use wgpu::{CurrentSurfaceTexture, SurfaceTexture, TextureFormat};

/// Formats in the order in which they are taken, and whether they encode sRGB themselves.
const FORMATS: [(TextureFormat, bool); 4] = [
    (TextureFormat::Bgra8Unorm, false),
    (TextureFormat::Rgba8Unorm, false),
    (TextureFormat::Bgra8UnormSrgb, true),
    (TextureFormat::Rgba8UnormSrgb, true),
];

/// Bytes of the uniform buffer.
const FRAME: u64 = 24;

/// Where pictures are shown.
#[derive(Debug)]
pub struct Screen {
    gpu: Gpu,
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    encodes: bool,
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
    frame: wgpu::Buffer,
}

impl Gpu {
    /// Opens the adapter that the system prefers of those that can show pictures in `window`, a window of `size` pixels. `shown` is WGSL
    /// that defines `fn shown(radiance: vec3<f32>, exposure_ev: f32) -> vec3<f32>`, stored sRGB.
    ///
    /// # Errors
    /// [`GpuError::NoScreen`] if there is none, [`GpuError::Device`] if it cannot be opened, [`GpuError::Refused`] for text or size.
    pub fn for_window(
        window: impl Into<wgpu::SurfaceTarget<'static>>,
        size: [u32; 2],
        shown: &str,
    ) -> Result<(Self, Screen), GpuError> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let none = |reason: String| GpuError::NoScreen { reason };
        let surface = instance.create_surface(window).map_err(|error| none(error.to_string()))?;
        let adapter = preferred(&instance, Some(&surface)).map_err(none)?;
        let gpu = Self::open(&adapter)?;
        let formats = surface.get_capabilities(&adapter).formats;
        let (format, encodes) = FORMATS
            .into_iter()
            .find(|(format, _)| formats.contains(format))
            .ok_or_else(|| none(format!("{} offers none of 8 bits, but {formats:?}", gpu.adapter)))?;
        let config = surface
            .get_default_config(&adapter, size[0], size[1])
            .ok_or_else(|| none(format!("{} does not serve it", gpu.adapter)))?;
        let config = wgpu::SurfaceConfiguration { format, present_mode: wgpu::PresentMode::Fifo, ..config };
        let screen = Screen::new(&gpu, surface, config, encodes, shown)?;
        Ok((gpu, screen))
    }
}

impl Screen {
    fn new(
        gpu: &Gpu,
        surface: wgpu::Surface<'static>,
        config: wgpu::SurfaceConfiguration,
        encodes: bool,
        shown: &str,
    ) -> Result<Self, GpuError> {
        let scope = gpu.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let layout = pipeline::layout(gpu);
        let pipeline = pipeline::pipeline(gpu, &layout, config.format, shown);
        let frame = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("frame"),
            size: FRAME,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        refused(scope)?;
        let screen = Self { gpu: gpu.clone(), surface, config, encodes, layout, pipeline, frame };
        screen.configure()?;
        Ok(screen)
    }

    /// Follows the window to another size in pixels, if it is another.
    ///
    /// # Errors
    /// [`GpuError::Refused`] for a size that the device cannot show, 0 among them.
    pub fn resize(&mut self, [width, height]: [u32; 2]) -> Result<(), GpuError> {
        if [self.config.width, self.config.height] == [width, height] {
            return Ok(());
        }
        (self.config.width, self.config.height) = (width, height);
        self.configure()
    }

    /// Shows `pixels`, rows from the top, four f32 each: linear radiance, and 0 for a pixel that is none. False if the window shows
    /// nothing just now, being covered, or in between two sizes.
    ///
    /// # Errors
    /// [`GpuError::Lost`] and [`GpuError::ScreenLost`] if device or surface are gone, [`GpuError::Refused`] if the buffer does not fit.
    pub fn present(&mut self, pixels: &Buffer, size: [u32; 2], exposure_ev: f32) -> Result<bool, GpuError> {
        self.gpu.fault.check()?;
        let needed = 16 * u64::from(size[0]) * u64::from(size[1]);
        if needed == 0 || needed > pixels.inner.size() {
            return Err(GpuError::Refused { reason: format!("the buffer holds no {size:?} pixels") });
        }
        let shown = self.try_present(pixels, size, exposure_ev);
        self.gpu.fault.explain(shown)
    }

    fn try_present(&self, pixels: &Buffer, size: [u32; 2], exposure_ev: f32) -> Result<bool, GpuError> {
        let scope = self.gpu.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let texture = self.acquire()?;
        if let Some(texture) = &texture {
            self.gpu.queue.write_buffer(&self.frame, 0, &self.frame_bytes(size, exposure_ev));
            self.draw(&texture.texture, pixels);
        }
        refused(scope)?;
        let shown = texture.map(|texture| self.gpu.queue.present(texture));
        Ok(shown.is_some())
    }

    /// The next texture of the window; none while it is covered or changes its size.
    fn acquire(&self) -> Result<Option<SurfaceTexture>, GpuError> {
        for _ in 0..2 {
            match self.surface.get_current_texture() {
                CurrentSurfaceTexture::Success(texture) | CurrentSurfaceTexture::Suboptimal(texture) => {
                    return Ok(Some(texture));
                }
                CurrentSurfaceTexture::Timeout | CurrentSurfaceTexture::Occluded => return Ok(None),
                CurrentSurfaceTexture::Outdated => self.configure()?,
                CurrentSurfaceTexture::Lost => return Err(GpuError::ScreenLost),
                CurrentSurfaceTexture::Validation => {
                    return Err(GpuError::Refused { reason: "the next picture of the window".to_owned() });
                }
            }
        }
        Ok(None)
    }

    fn configure(&self) -> Result<(), GpuError> {
        let most = self.gpu.device.limits().max_texture_dimension_2d;
        let (width, height) = (self.config.width, self.config.height);
        if !(1..=most).contains(&width) || !(1..=most).contains(&height) {
            let reason = format!("a window of {width} x {height} pixels: each side must be in [1, {most}]");
            return Err(GpuError::Refused { reason });
        }
        let scope = self.gpu.device.push_error_scope(wgpu::ErrorFilter::Validation);
        self.surface.configure(&self.gpu.device, &self.config);
        self.gpu.fault.explain(refused(scope))
    }

    fn frame_bytes(&self, [width, height]: [u32; 2], exposure_ev: f32) -> Vec<u8> {
        let (across, down) = (self.config.width, self.config.height);
        let words = [width, height, across, down, exposure_ev.to_bits(), u32::from(self.encodes)];
        words.iter().flat_map(|word| word.to_le_bytes()).collect()
    }

    fn draw(&self, texture: &wgpu::Texture, pixels: &Buffer) {
        let group = self.gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("screen"),
            layout: &self.layout,
            entries: &[bound(0, &self.frame), bound(1, &pixels.inner)],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let attachment = wgpu::RenderPassColorAttachment {
            view: &view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                store: wgpu::StoreOp::Store,
            },
        };
        let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("screen"),
                color_attachments: &[Some(attachment)],
                ..Default::default()
            });
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.draw(0..3, 0..1);
        }
        self.gpu.queue.submit([encoder.finish()]);
    }
}

fn refused(scope: wgpu::ErrorScopeGuard) -> Result<(), GpuError> {
    block_on(scope.pop()).map_or(Ok(()), |error| Err(GpuError::Refused { reason: error.to_string() }))
}

fn bound(binding: u32, buffer: &wgpu::Buffer) -> wgpu::BindGroupEntry<'_> {
    wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() }
}
