//! The background, drawn where the surface is not.

use super::bindings::Bindings;
use super::device::Gpu;
use super::material::Material;
use super::pipeline::{Plan, Target, bare_shader, pipeline, shader};

/// Draws one triangle at the far plane.
pub(super) struct BackgroundPass(wgpu::RenderPipeline);

impl BackgroundPass {
    pub(super) fn new(gpu: &Gpu, bindings: &Bindings, material: &Material) -> Self {
        Self(pipeline(
            gpu,
            &Plan {
                label: "background",
                shader: &shader(gpu, "background", bare_shader!("background")),
                vertex: "vertex",
                fragment: "fragment",
                groups: &[Some(&bindings.layout), Some(&material.layout)],
                buffers: &[],
                topology: wgpu::PrimitiveTopology::TriangleList,
                target: Target::Opaque,
            },
        ))
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.0);
        pass.draw(0..3, 0..1);
    }
}
