//! What the passes share in making pipelines and buffers.

use super::device::{DEPTH_FORMAT, Gpu};

/// How one pipeline differs from the others.
pub(super) struct Plan<'a> {
    pub(super) label: &'static str,
    pub(super) shader: &'a wgpu::ShaderModule,
    pub(super) vertex: &'static str,
    pub(super) fragment: &'static str,
    pub(super) groups: &'a [Option<&'a wgpu::BindGroupLayout>],
    pub(super) buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    pub(super) topology: wgpu::PrimitiveTopology,
    pub(super) target: Target,
}

/// What a pipeline draws into, and how.
#[derive(Clone, Copy)]
pub(super) enum Target {
    /// The picture, writing depth.
    Opaque,
    /// Blended over the picture, where it lies in front …
    Blended,
    /// … or only where it lies behind.
    BlendedBehind,
    /// A picture for another pass, with a depth buffer.
    Offscreen(wgpu::TextureFormat),
    /// Without a depth buffer.
    Flat(wgpu::TextureFormat),
    /// Likewise, where the brightest of what is drawn stays.
    Brightest(wgpu::TextureFormat),
}

/// A shader of this folder by its name, made bare when the crate is compiled.
macro_rules! bare_shader {
    ($name:literal) => {{
        const TEXT: &[u8] = include_bytes!(concat!($name, ".wgsl"));
        const SIZE: usize = $crate::viewer::bare::bare::<0>(TEXT).1;
        const BARE: [u8; SIZE] = $crate::viewer::bare::bare(TEXT).0;
        str::from_utf8(&BARE).expect("comments alone may leave ASCII")
    }};
}
pub(super) use bare_shader;

/// Compiles a shader, with the common part in front.
pub(super) fn shader(gpu: &Gpu, label: &str, source: &str) -> wgpu::ShaderModule {
    let source = [bare_shader!("frame"), source].concat();
    gpu.device
        .create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(label),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        })
}

/// Makes a pipeline. Equal depth passes: highlights lie on what they highlight, and the
/// background on the far plane.
pub(super) fn pipeline(gpu: &Gpu, plan: &Plan<'_>) -> wgpu::RenderPipeline {
    let target = plan.target;
    let layout = gpu
        .device
        .create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(plan.label),
            bind_group_layouts: plan.groups,
            ..Default::default()
        });
    let writes_depth = matches!(target, Target::Opaque | Target::Offscreen(_));
    let depth = wgpu::DepthStencilState {
        format: DEPTH_FORMAT,
        depth_write_enabled: Some(writes_depth),
        depth_compare: Some(match target {
            Target::BlendedBehind => wgpu::CompareFunction::Greater,
            _ => wgpu::CompareFunction::LessEqual,
        }),
        stencil: Default::default(),
        bias: Default::default(),
    };
    let brightest = wgpu::BlendComponent {
        src_factor: wgpu::BlendFactor::One,
        dst_factor: wgpu::BlendFactor::One,
        operation: wgpu::BlendOperation::Max,
    };
    let (format, samples, blend, depth) = match target {
        Target::Opaque => (gpu.format(), gpu.samples, None, Some(depth)),
        Target::Blended | Target::BlendedBehind => {
            let blend = wgpu::BlendState::ALPHA_BLENDING;
            (gpu.format(), gpu.samples, Some(blend), Some(depth))
        }
        Target::Offscreen(format) => (format, 1, None, Some(depth)),
        Target::Flat(format) => (format, 1, None, None),
        Target::Brightest(format) => {
            let blend = wgpu::BlendState {
                color: brightest,
                alpha: brightest,
            };
            (format, 1, Some(blend), None)
        }
    };
    gpu.device
        .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(plan.label),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: plan.shader,
                entry_point: Some(plan.vertex),
                compilation_options: Default::default(),
                buffers: plan.buffers,
            },
            primitive: wgpu::PrimitiveState {
                topology: plan.topology,
                ..Default::default()
            },
            depth_stencil: depth,
            multisample: wgpu::MultisampleState {
                count: samples,
                ..Default::default()
            },
            fragment: Some(wgpu::FragmentState {
                module: plan.shader,
                entry_point: Some(plan.fragment),
                compilation_options: Default::default(),
                targets: &[Some(wgpu::ColorTargetState {
                    format,
                    blend,
                    write_mask: wgpu::ColorWrites::ALL,
                })],
            }),
            multiview_mask: None,
            cache: None,
        })
}

/// A buffer rewritten in place, replaced only when it must grow.
pub(super) struct GrowingBuffer {
    buffer: wgpu::Buffer,
    length: u64,
}

impl GrowingBuffer {
    pub(super) fn new(gpu: &Gpu, usage: wgpu::BufferUsages) -> Self {
        Self {
            buffer: buffer(gpu, 4, usage | wgpu::BufferUsages::COPY_DST),
            length: 0,
        }
    }

    /// Replaces the contents.
    pub(super) fn set<T: bytemuck::Pod>(&mut self, gpu: &Gpu, data: &[T]) {
        let bytes: &[u8] = bytemuck::cast_slice(data);
        self.length = bytes.len() as u64;
        if self.length > self.buffer.size() {
            self.buffer = buffer(gpu, self.length, self.buffer.usage());
        }
        gpu.queue.write_buffer(&self.buffer, 0, bytes);
    }

    /// The contents; there must be some.
    pub(super) fn slice(&self) -> wgpu::BufferSlice<'_> {
        self.buffer.slice(..self.length)
    }

    /// Number of elements of `T` in the contents.
    pub(super) fn count<T>(&self) -> u32 {
        (self.length / size_of::<T>() as u64) as u32
    }
}

fn buffer(gpu: &Gpu, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size,
        usage,
        mapped_at_creation: false,
    })
}
