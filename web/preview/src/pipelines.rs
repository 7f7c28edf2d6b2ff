//! The ways of drawing: the ground, solid parts, faded and clear ones, lines in sight, lines behind a part, clouds of
//! points.

use wgpu::{BindGroupLayout, CompareFunction, RenderPipeline};

use crate::gpu::Gpu;
use crate::layout;
use crate::target::DEPTH;

/// All pipelines; they share one bind group.
pub struct Pipelines {
    /// The ground, behind everything.
    pub ground: RenderPipeline,
    /// Parts that hide what is behind them.
    pub solid: RenderPipeline,
    /// Parts that fade, as else they would hide another.
    pub faded: RenderPipeline,
    /// Parts that are seen through.
    pub clear: RenderPipeline,
    /// Lines before the parts.
    pub line: RenderPipeline,
    /// Lines behind the parts, fainter.
    pub hidden: RenderPipeline,
    /// Points of a cloud.
    pub point: RenderPipeline,
}

/// What the shaders find beside their vertices: the uniform block, and for a cloud its texture too.
pub struct Bindings {
    /// The uniform block, and the map over the ground.
    pub view: BindGroupLayout,
    /// The texture that holds the points of a cloud.
    pub cloud: BindGroupLayout,
}

struct Way<'a> {
    vertex: &'a str,
    fragment: &'a str,
    /// What a vertex is made of; none where the shader fetches it by its number.
    buffer: Option<wgpu::VertexBufferLayout<'static>>,
    layout: &'a wgpu::PipelineLayout,
    writes_depth: bool,
    compare: CompareFunction,
    cull: Option<wgpu::Face>,
}

/// Compiles the pipelines.
pub fn build(gpu: &Gpu, bindings: &Bindings) -> Pipelines {
    let device = &gpu.device;
    let module = device.create_shader_module(wgpu::include_wgsl!("shader.wgsl"));
    let layout = |bound: &[Option<&BindGroupLayout>]| {
        device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: bound,
            immediate_size: 0,
        })
    };
    let plain = layout(&[Some(&bindings.view)]);
    let with_cloud = layout(&[Some(&bindings.view), Some(&bindings.cloud)]);
    let make = |way: &Way<'_>| pipeline(gpu, &module, way);
    let mesh = |fragment, writes_depth| Way {
        vertex: "mesh_vertex",
        fragment,
        buffer: Some(layout::vertex()),
        layout: &plain,
        writes_depth,
        compare: CompareFunction::LessEqual,
        cull: None,
    };
    let line = |fragment, compare| Way {
        vertex: "line_vertex",
        fragment,
        buffer: Some(layout::line()),
        layout: &plain,
        writes_depth: false,
        compare,
        cull: None,
    };
    let point = Way {
        vertex: "point_vertex",
        fragment: "point_fragment",
        buffer: None,
        layout: &with_cloud,
        writes_depth: true,
        compare: CompareFunction::LessEqual,
        cull: None,
    };
    let ground = Way {
        vertex: "ground_vertex",
        fragment: "ground_fragment",
        buffer: None,
        layout: &plain,
        writes_depth: false,
        compare: CompareFunction::LessEqual,
        cull: None,
    };
    Pipelines {
        ground: make(&ground),
        solid: make(&mesh("mesh_fragment", true)),
        faded: make(&Way { cull: Some(wgpu::Face::Back), ..mesh("mesh_faded_fragment", false) }),
        clear: make(&mesh("mesh_fragment", false)),
        line: make(&line("line_fragment", CompareFunction::LessEqual)),
        hidden: make(&line("line_hidden_fragment", CompareFunction::Greater)),
        point: make(&point),
    }
}

fn pipeline(gpu: &Gpu, module: &wgpu::ShaderModule, way: &Way<'_>) -> RenderPipeline {
    let buffers: Vec<_> = way.buffer.iter().cloned().map(Some).collect();
    let descriptor = wgpu::RenderPipelineDescriptor {
        label: Some(way.fragment),
        layout: Some(way.layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(way.vertex),
            compilation_options: Default::default(),
            buffers: &buffers,
        },
        primitive: wgpu::PrimitiveState { cull_mode: way.cull, ..Default::default() },
        depth_stencil: Some(depth(way)),
        multisample: wgpu::MultisampleState { count: gpu.samples, ..Default::default() },
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
