//! What the pass over a window runs.

use crate::Gpu;
use wgpu::{BufferBindingType, ShaderStages, TextureFormat};

/// Bindings of the fragments: the frame, the pixels.
pub fn layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
        count: None,
    };
    gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("screen"),
        entries: &[
            entry(0, BufferBindingType::Uniform),
            entry(1, BufferBindingType::Storage { read_only: true }),
        ],
    })
}

/// The pass for a surface of this format, colours by `shown`.
pub fn pipeline(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    format: TextureFormat,
    shown: &str,
) -> wgpu::RenderPipeline {
    let text = [include_str!("screen.wgsl"), shown].join("\n");
    let source = wgpu::ShaderSource::Wgsl(text.into());
    let module =
        gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some("screen"), source });
    let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("screen"),
        bind_group_layouts: &[Some(layout)],
        immediate_size: 0,
    });
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("screen"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("corner"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("colour"),
            compilation_options: Default::default(),
            targets: &[Some(format.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
