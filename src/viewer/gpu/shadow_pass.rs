//! The shadow on the floor: the footprint of the surface, blurred.

use super::bindings::Bindings;
use super::device::Gpu;
use super::filter::{Canvas, Reading, apply, record};
use super::pipeline::{Plan, Target, bare_shader, pipeline, shader};
use super::surface_pass::SurfacePass;

/// Pixels of a side of the footprint.
const SIDE: u32 = 128;
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R8Unorm;

/// Pipelines and pictures of the shadow.
pub(super) struct ShadowPass {
    footprint: wgpu::RenderPipeline,
    across: wgpu::RenderPipeline,
    down: wgpu::RenderPipeline,
    /// The footprint; blurred in the end.
    first: Canvas,
    second: Canvas,
}

impl ShadowPass {
    pub(super) fn new(gpu: &Gpu, bindings: &Bindings, reading: &Reading) -> Self {
        let shader = shader(gpu, "shadow", bare_shader!("shadow"));
        let footprint = Plan {
            label: "footprint",
            shader: &shader,
            vertex: "vertex_footprint",
            fragment: "fragment_footprint",
            groups: &[Some(&bindings.layout)],
            buffers: &[],
            topology: wgpu::PrimitiveTopology::TriangleList,
            target: Target::Brightest(FORMAT),
        };
        let filter = |name| reading.filter(gpu, bindings, &shader, name, FORMAT);
        Self {
            footprint: pipeline(gpu, &footprint),
            across: filter("fragment_across"),
            down: filter("fragment_down"),
            first: reading.canvas(gpu, FORMAT, (SIDE, SIDE)),
            second: reading.canvas(gpu, FORMAT, (SIDE, SIDE)),
        }
    }

    /// How dark the floor is.
    pub(super) fn picture(&self) -> &wgpu::TextureView {
        &self.first.view
    }

    /// Draws it for the present frame.
    pub(super) fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        bindings: &Bindings,
        surface: &SurfacePass,
    ) {
        let light = wgpu::Color::TRANSPARENT;
        record(encoder, bindings, &self.first.view, None, light, |pass| {
            surface.draw_with(pass, &self.footprint);
        });
        apply(encoder, bindings, &self.across, &self.first, &self.second);
        apply(encoder, bindings, &self.down, &self.second, &self.first);
    }
}
