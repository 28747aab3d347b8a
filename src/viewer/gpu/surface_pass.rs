//! The triangles: plain, with the edges of the mesh, or for another pass; and the marked ones
//! once more on top.

use super::bindings::Bindings;
use super::device::Gpu;
use super::material::Material;
use super::pipeline::{GrowingBuffer, Plan, Target, bare_shader, pipeline, shader};
use crate::viewer::drawing::Drawing;
use crate::viewer::edges::corners_with_sides;

/// What of the surface the other passes are given: the normals and depths that are seen.
pub(super) const DEPTH_PICTURE: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// Pipelines and buffers of the surface.
pub(super) struct SurfacePass {
    solid: wgpu::RenderPipeline,
    wire: wgpu::RenderPipeline,
    highlight: wgpu::RenderPipeline,
    depth: wgpu::RenderPipeline,
    triangles: GrowingBuffer,
    marked: GrowingBuffer,
    /// Corners of the triangles with their sides; made when the wireframe is first seen.
    corners: GrowingBuffer,
    has_corners: bool,
}

impl SurfacePass {
    pub(super) fn new(gpu: &Gpu, bindings: &Bindings, material: &Material) -> Self {
        let shader = shader(gpu, "surface", bare_shader!("surface"));
        let corner = wgpu::vertex_attr_array![0 => Uint32];
        let corners = [Some(wgpu::VertexBufferLayout {
            array_stride: 4,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &corner,
        })];
        let groups = [Some(&bindings.layout), Some(&material.layout)];
        let plan = |vertex, fragment, groups, buffers, target| {
            pipeline(
                gpu,
                &Plan {
                    label: "surface",
                    shader: &shader,
                    vertex,
                    fragment,
                    groups,
                    buffers,
                    topology: wgpu::PrimitiveTopology::TriangleList,
                    target,
                },
            )
        };
        let depth = Target::Offscreen(DEPTH_PICTURE);
        Self {
            solid: plan("vertex", "fragment", &groups, &[], Target::Opaque),
            wire: plan(
                "vertex_wire",
                "fragment_wire",
                &groups,
                &corners,
                Target::Opaque,
            ),
            highlight: plan("vertex", "fragment_marked", &groups, &[], Target::Blended),
            depth: plan("vertex", "fragment_depth", &groups[..1], &[], depth),
            triangles: GrowingBuffer::new(gpu, wgpu::BufferUsages::INDEX),
            marked: GrowingBuffer::new(gpu, wgpu::BufferUsages::INDEX),
            corners: GrowingBuffer::new(gpu, wgpu::BufferUsages::VERTEX),
            has_corners: false,
        }
    }

    /// Takes over another mesh.
    pub(super) fn set_mesh(&mut self, gpu: &Gpu, drawing: &Drawing) {
        self.triangles.set(gpu, drawing.triangles());
        self.has_corners = false;
        self.set_marked(gpu, drawing);
    }

    /// Makes what the wireframe needs, unless it is there.
    pub(super) fn prepare_wire(&mut self, gpu: &Gpu, drawing: &Drawing, edges: &[u32]) {
        if !std::mem::replace(&mut self.has_corners, true) {
            let source = |v: u32| drawing.source(v as usize) as u32;
            let corners = corners_with_sides(drawing.triangles(), edges, source);
            self.corners.set(gpu, &corners);
        }
    }

    pub(super) fn set_marked(&mut self, gpu: &Gpu, drawing: &Drawing) {
        self.marked.set(gpu, drawing.marked());
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        draw_triangles(pass, &self.solid, &self.triangles);
    }

    /// Draws the edges of the mesh as well; they must be prepared.
    pub(super) fn draw_wire(&self, pass: &mut wgpu::RenderPass<'_>) {
        let count = self.corners.count::<u32>();
        if count > 0 {
            pass.set_pipeline(&self.wire);
            pass.set_vertex_buffer(0, self.corners.slice());
            pass.draw(0..count, 0..1);
        }
    }

    pub(super) fn draw_marked(&self, pass: &mut wgpu::RenderPass<'_>) {
        draw_triangles(pass, &self.highlight, &self.marked);
    }

    /// Draws normals and depths.
    pub(super) fn draw_depth(&self, pass: &mut wgpu::RenderPass<'_>) {
        draw_triangles(pass, &self.depth, &self.triangles);
    }

    /// The triangles, for pipelines of other passes.
    pub(super) fn draw_with(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        pipeline: &wgpu::RenderPipeline,
    ) {
        draw_triangles(pass, pipeline, &self.triangles);
    }
}

fn draw_triangles(
    pass: &mut wgpu::RenderPass<'_>,
    pipeline: &wgpu::RenderPipeline,
    corners: &GrowingBuffer,
) {
    let count = corners.count::<u32>();
    if count > 0 {
        pass.set_pipeline(pipeline);
        pass.set_index_buffer(corners.slice(), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..count, 0, 0..1);
    }
}
