//! The five ways of drawing: solid parts, clear parts, lines in sight, lines behind a part, clouds of points.

use wgpu::{BindGroupLayout, CompareFunction, RenderPipeline};

use crate::gpu::Gpu;
use crate::layout;
use crate::target::DEPTH;

/// All pipelines; they share one bind group.
pub struct Pipelines {
    /// Parts that hide what is behind them.
    pub solid: RenderPipeline,
    /// Parts that are seen through.
    pub clear: RenderPipeline,
    /// Lines before the parts.
    pub line: RenderPipeline,
    /// Lines behind the parts, fainter.
    pub hidden: RenderPipeline,
    /// Points of a cloud.
    pub point: RenderPipeline,
}

struct Way<'a> {
    vertex: &'a str,
    fragment: &'a str,
    buffer: wgpu::VertexBufferLayout<'static>,
    writes_depth: bool,
    compare: CompareFunction,
}

/// Compiles the pipelines.
pub fn build(gpu: &Gpu, bind: &BindGroupLayout) -> Pipelines {
    let device = &gpu.device;
    let module = device.create_shader_module(wgpu::include_wgsl!("shader.wgsl"));
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: &[Some(bind)],
        immediate_size: 0,
    });
    let make = |way: &Way<'_>| pipeline(gpu, &module, &layout, way);
    let mesh = |writes_depth| Way {
        vertex: "mesh_vertex",
        fragment: "mesh_fragment",
        buffer: layout::vertex(),
        writes_depth,
        compare: CompareFunction::LessEqual,
    };
    let line = |fragment, compare| Way {
        vertex: "line_vertex",
        fragment,
        buffer: layout::line(),
        writes_depth: false,
        compare,
    };
    let point = Way {
        vertex: "point_vertex",
        fragment: "point_fragment",
        buffer: layout::point(),
        writes_depth: true,
        compare: CompareFunction::LessEqual,
    };
    Pipelines {
        solid: make(&mesh(true)),
        clear: make(&mesh(false)),
        line: make(&line("line_fragment", CompareFunction::LessEqual)),
        hidden: make(&line("line_hidden_fragment", CompareFunction::Greater)),
        point: make(&point),
    }
}

fn pipeline(
    gpu: &Gpu,
    module: &wgpu::ShaderModule,
    layout: &wgpu::PipelineLayout,
    way: &Way<'_>,
) -> RenderPipeline {
    let descriptor = wgpu::RenderPipelineDescriptor {
        label: Some(way.fragment),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(way.vertex),
            compilation_options: Default::default(),
            buffers: &[Some(way.buffer.clone())],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(depth(way)),
        multisample: wgpu::MultisampleState {
            count: gpu.samples,
            ..Default::default()
        },
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(way.fragment),
            compilation_options: Default::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format: gpu.config.format,
                blend: Some(wgpu::BlendState::ALPHA_BLENDING),
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    };
    gpu.device.create_render_pipeline(&descriptor)
}

fn depth(way: &Way<'_>) -> wgpu::DepthStencilState {
    wgpu::DepthStencilState {
        format: DEPTH,
        depth_write_enabled: Some(way.writes_depth),
        depth_compare: Some(way.compare),
        stencil: Default::default(),
        bias: Default::default(),
    }
}
