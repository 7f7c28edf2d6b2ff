//! The ways of drawing: the ground, solid parts, faded and clear ones, lines in sight, lines behind a part, clouds of
//! points, the whole path.

use wgpu::{BindGroupLayout, CompareFunction, PipelineLayout, RenderPipeline, ShaderModule};

use crate::gpu::Gpu;
use crate::layout;
use crate::target::DEPTH;

/// All pipelines; they share one bind group.
pub struct Pipelines {
    /// The ground, behind everything.
    pub ground: RenderPipeline,
    /// Parts, and lines before and behind them.
    pub lit: Lit,
    /// Points of a cloud.
    pub point: RenderPipeline,
    /// The whole path.
    pub path: RenderPipeline,
    /// A picture that was made in several goes.
    pub made: RenderPipeline,
    module: ShaderModule,
    plain: PipelineLayout,
}

/// The ways of drawing that depend on [`Light`].
pub struct Lit {
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
}

/// What the light of parts is worked out from.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Light {
    /// Each pixel is lit, by what stands around too; else the corners of the surfaces only.
    pub all: bool,
    /// Something of the part is cut away.
    pub cut: bool,
}

/// What the shaders find beside their vertices: the uniform block, and for a cloud its texture too.
pub struct Bindings {
    /// The uniform block, and the map over the ground.
    pub view: BindGroupLayout,
    /// A texture that is read pixel by pixel: the points of a cloud, or a picture.
    pub texture: BindGroupLayout,
}

#[derive(Clone)]
struct Way<'a> {
    vertex: &'a str,
    fragment: &'a str,
    /// What a vertex is made of; none where the shader fetches it by its number.
    buffer: Option<wgpu::VertexBufferLayout<'static>>,
    layout: &'a PipelineLayout,
    writes_depth: bool,
    compare: CompareFunction,
    cull: Option<wgpu::Face>,
    /// It is made of strips of lines, else of triangles.
    strips: bool,
    /// Of the shader, by name.
    constants: &'a [(&'a str, f64)],
}

/// Compiles the pipelines.
pub fn build(gpu: &Gpu, bindings: &Bindings, light: Light) -> Pipelines {
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
    let with_texture = layout(&[Some(&bindings.view), Some(&bindings.texture)]);
    let make = |way: &Way<'_>| pipeline(gpu, &module, way);
    let point = Way {
        vertex: "point_vertex",
        fragment: "point_fragment",
        buffer: None,
        layout: &with_texture,
        writes_depth: true,
        compare: CompareFunction::LessEqual,
        cull: None,
        strips: false,
        constants: &[],
    };
    let ground = Way {
        vertex: "ground_vertex",
        fragment: "ground_fragment",
        buffer: None,
        layout: &plain,
        writes_depth: false,
        compare: CompareFunction::LessEqual,
        cull: None,
        strips: false,
        constants: &[],
    };
    let path = Way {
        vertex: "path_vertex",
        fragment: "path_fragment",
        buffer: Some(layout::path()),
        layout: &plain,
        strips: true,
        ..point.clone()
    };
    let made = Way {
        vertex: "made_vertex",
        fragment: "made_fragment",
        writes_depth: false,
        compare: CompareFunction::Always,
        ..point.clone()
    };
    Pipelines {
        ground: make(&ground),
        lit: lit(gpu, &module, &plain, light),
        path: make(&path),
        made: make(&made),
        point: make(&point),
        module,
        plain,
    }
}

impl Pipelines {
    /// Parts stand in another light from now on.
    pub fn relight(&mut self, gpu: &Gpu, light: Light) {
        self.lit = lit(gpu, &self.module, &self.plain, light);
    }
}

fn lit(gpu: &Gpu, module: &ShaderModule, layout: &PipelineLayout, light: Light) -> Lit {
    let constants = [("ALL", f64::from(light.all)), ("CUT", f64::from(light.cut))];
    let mesh = |fragment, writes_depth, cull| Way {
        vertex: "mesh_vertex",
        fragment,
        buffer: Some(layout::vertex()),
        layout,
        writes_depth,
        compare: CompareFunction::LessEqual,
        cull,
        strips: false,
        constants: &constants,
    };
    let line = |fragment, compare| Way {
        vertex: "line_vertex",
        buffer: Some(layout::line()),
        compare,
        ..mesh(fragment, false, None)
    };
    let make = |way: Way<'_>| pipeline(gpu, module, &way);
    Lit {
        solid: make(mesh("mesh_fragment", true, None)),
        faded: make(mesh("mesh_faded_fragment", false, Some(wgpu::Face::Back))),
        clear: make(mesh("mesh_fragment", false, None)),
        line: make(line("line_fragment", CompareFunction::LessEqual)),
        hidden: make(line("line_hidden_fragment", CompareFunction::Greater)),
    }
}

fn pipeline(gpu: &Gpu, module: &ShaderModule, way: &Way<'_>) -> RenderPipeline {
    let buffers: Vec<_> = way.buffer.iter().cloned().map(Some).collect();
    let options = wgpu::PipelineCompilationOptions { constants: way.constants, ..Default::default() };
    let descriptor = wgpu::RenderPipelineDescriptor {
        label: Some(way.fragment),
        layout: Some(way.layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(way.vertex),
            compilation_options: options.clone(),
            buffers: &buffers,
        },
        primitive: primitive(way),
        depth_stencil: Some(depth(way)),
        multisample: wgpu::MultisampleState { count: gpu.samples, ..Default::default() },
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(way.fragment),
            compilation_options: options,
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

fn primitive(way: &Way<'_>) -> wgpu::PrimitiveState {
    let plain = wgpu::PrimitiveState { cull_mode: way.cull, ..Default::default() };
    if !way.strips {
        return plain;
    }
    let strip_index_format = Some(wgpu::IndexFormat::Uint16);
    wgpu::PrimitiveState { topology: wgpu::PrimitiveTopology::LineStrip, strip_index_format, ..plain }
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
