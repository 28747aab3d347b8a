//! What is drawn beyond surface and lines.

use super::bindings::Bindings;
use super::device::Gpu;
use super::filter::Reading;
use super::occlusion_pass::OcclusionPass;
use super::shadow_pass::ShadowPass;
use super::surface_pass::SurfacePass;
use crate::viewer::quality::{Effects, Quality, Wish};

/// The passes of the effects.
pub(super) struct EffectPasses {
    reading: Reading,
    pub(super) occlusion: OcclusionPass,
    pub(super) shadow: ShadowPass,
    quality: Quality,
}

impl EffectPasses {
    pub(super) fn new(gpu: &Gpu, bindings: &Bindings) -> Self {
        let reading = Reading::new(gpu);
        Self {
            occlusion: OcclusionPass::new(gpu, bindings, &reading),
            shadow: ShadowPass::new(gpu, bindings, &reading),
            reading,
            quality: Quality::new(gpu.is_software),
        }
    }

    /// What is drawn where the page has such a wish, of a picture that moves or is still.
    pub(super) fn chosen(&self, wish: Wish, is_still: bool) -> Effects {
        self.quality.effects(wish, is_still)
    }

    /// Makes the pictures that are needed; says whether they are others than before.
    pub(super) fn prepare(&mut self, gpu: &Gpu, chosen: Effects) -> bool {
        chosen >= Effects::Occlusion && self.occlusion.resize(gpu, &self.reading, gpu.size())
    }

    /// Draws them.
    pub(super) fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        bindings: &Bindings,
        surface: &SurfacePass,
        chosen: Effects,
    ) {
        if chosen >= Effects::Shadow {
            self.shadow.draw(encoder, bindings, surface);
        }
        if chosen >= Effects::Occlusion {
            self.occlusion.draw(encoder, bindings, surface);
        }
    }

    /// Takes note of how long a frame took.
    pub(super) fn record(&mut self, milliseconds: f32) {
        self.quality.record(milliseconds);
    }
}
