//! Edges as ribbons of fixed pixel width: the boundary loops and what is chosen. Segments of
//! space likewise, in colours of their own.
//!
//! Each edge is one instance of a four-cornered strip that looks up its two ends in the
//! texture of vertices. So edges are sent once, and follow the surface for nothing.

use bytemuck::bytes_of;

use super::bindings::Bindings;
use super::device::Gpu;
use super::pipeline::{GrowingBuffer, Plan, Target, bare_shader, pipeline, shader};
use super::texture::{self, uniform_entry};
use crate::viewer::frame::Line;
use crate::viewer::segments::Segment;

/// The pipelines of all lines.
pub(super) struct LinePass {
    edges: wgpu::RenderPipeline,
    segments: wgpu::RenderPipeline,
    hidden_segments: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
}

/// How lines are drawn.
struct Pen {
    uniforms: wgpu::Buffer,
    group: wgpu::BindGroup,
}

/// Edges drawn alike.
pub(super) struct EdgeSet {
    edges: GrowingBuffer,
    pen: Pen,
}

/// Segments drawn alike, and alike where the surface hides them.
pub(super) struct SegmentSet {
    segments: GrowingBuffer,
    seen: Pen,
    hidden: Pen,
}

impl LinePass {
    pub(super) fn new(gpu: &Gpu, bindings: &Bindings) -> Self {
        let layout = gpu
            .device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("line"),
                entries: &[uniform_entry(0)],
            });
        let shader = shader(gpu, "line", bare_shader!("line"));
        let plan = |vertex, stride: usize, attributes: &[wgpu::VertexAttribute], target| {
            pipeline(
                gpu,
                &Plan {
                    label: "line",
                    shader: &shader,
                    vertex,
                    fragment: "fragment",
                    groups: &[Some(&bindings.layout), Some(&layout)],
                    buffers: &[Some(wgpu::VertexBufferLayout {
                        array_stride: stride as u64,
                        step_mode: wgpu::VertexStepMode::Instance,
                        attributes,
                    })],
                    topology: wgpu::PrimitiveTopology::TriangleStrip,
                    target,
                },
            )
        };
        let edge = wgpu::vertex_attr_array![0 => Uint32x2];
        let segment = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x4];
        let size = size_of::<Segment>();
        Self {
            edges: plan("vertex", size_of::<[u32; 2]>(), &edge, Target::Blended),
            segments: plan("segment", size, &segment, Target::Blended),
            hidden_segments: plan("segment", size, &segment, Target::BlendedBehind),
            layout,
        }
    }

    fn pen(&self, gpu: &Gpu) -> Pen {
        let uniforms = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("line"),
            size: size_of::<Line>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let group = texture::group(gpu, &self.layout, &[uniforms.as_entire_binding()]);
        Pen { uniforms, group }
    }

    pub(super) fn edge_set(&self, gpu: &Gpu) -> EdgeSet {
        EdgeSet {
            edges: GrowingBuffer::new(gpu, wgpu::BufferUsages::VERTEX),
            pen: self.pen(gpu),
        }
    }

    pub(super) fn segment_set(&self, gpu: &Gpu) -> SegmentSet {
        SegmentSet {
            segments: GrowingBuffer::new(gpu, wgpu::BufferUsages::VERTEX),
            seen: self.pen(gpu),
            hidden: self.pen(gpu),
        }
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, set: &EdgeSet) {
        let count = set.edges.count::<[u32; 2]>();
        strips(pass, &self.edges, &set.pen, &set.edges, count);
    }

    pub(super) fn draw_segments(&self, pass: &mut wgpu::RenderPass<'_>, set: &SegmentSet) {
        let count = set.segments.count::<Segment>();
        let (seen, hidden) = (&self.segments, &self.hidden_segments);
        strips(pass, hidden, &set.hidden, &set.segments, count);
        strips(pass, seen, &set.seen, &set.segments, count);
    }
}

fn strips(
    pass: &mut wgpu::RenderPass<'_>,
    pipeline: &wgpu::RenderPipeline,
    pen: &Pen,
    instances: &GrowingBuffer,
    count: u32,
) {
    if count > 0 {
        pass.set_pipeline(pipeline);
        pass.set_bind_group(1, &pen.group, &[]);
        pass.set_vertex_buffer(0, instances.slice());
        pass.draw(0..4, 0..count);
    }
}

impl EdgeSet {
    /// Takes other edges, two vertices each.
    pub(super) fn set_edges(&mut self, gpu: &Gpu, ends: &[u32]) {
        self.edges.set(gpu, ends);
    }

    pub(super) fn set_line(&self, gpu: &Gpu, line: &Line) {
        gpu.queue
            .write_buffer(&self.pen.uniforms, 0, bytes_of(line));
    }
}

impl SegmentSet {
    pub(super) fn set_segments(&mut self, gpu: &Gpu, segments: &[Segment]) {
        self.segments.set(gpu, segments);
    }

    /// How they are drawn in front of the surface and behind it.
    pub(super) fn set_lines(&self, gpu: &Gpu, seen: &Line, hidden: &Line) {
        for (pen, line) in [(&self.seen, seen), (&self.hidden, hidden)] {
            gpu.queue.write_buffer(&pen.uniforms, 0, bytes_of(line));
        }
    }
}
