//! Darkened corners: how open the surface is at each pixel, in a picture of half the size.

use super::bindings::Bindings;
use super::device::Gpu;
use super::filter::{Canvas, Reading, apply, record};
use super::pipeline::{bare_shader, shader};
use super::surface_pass::{DEPTH_PICTURE, SurfacePass};
use super::texture;

/// Pipelines and pictures of the search for corners.
pub(super) struct OcclusionPass {
    search: wgpu::RenderPipeline,
    blur: wgpu::RenderPipeline,
    pictures: Pictures,
}

/// What the passes draw into; a single pixel each until they are needed.
struct Pictures {
    size: (u32, u32),
    /// Normals and depths that are seen; the final picture as well.
    seen: Canvas,
    /// Openness as it is found, with noise.
    found: Canvas,
    depth: wgpu::TextureView,
}

impl OcclusionPass {
    pub(super) fn new(gpu: &Gpu, bindings: &Bindings, reading: &Reading) -> Self {
        let shader = shader(gpu, "occlusion", bare_shader!("occlusion"));
        let filter = |name| reading.filter(gpu, bindings, &shader, name, DEPTH_PICTURE);
        Self {
            search: filter("fragment"),
            blur: filter("fragment_blur"),
            pictures: Pictures::new(gpu, reading, (1, 1)),
        }
    }

    /// Makes pictures for one of such a size on screen; says whether they are others.
    pub(super) fn resize(
        &mut self,
        gpu: &Gpu,
        reading: &Reading,
        (width, height): (u32, u32),
    ) -> bool {
        let size = (width.div_ceil(2), height.div_ceil(2));
        let is_other = self.pictures.size != size;
        if is_other {
            self.pictures = Pictures::new(gpu, reading, size);
        }
        is_other
    }

    /// Openness in the first byte, depth in the last two.
    pub(super) fn openness(&self) -> &wgpu::TextureView {
        &self.pictures.seen.view
    }

    /// Finds it for the present frame.
    pub(super) fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        bindings: &Bindings,
        surface: &SurfacePass,
    ) {
        let Pictures {
            seen, found, depth, ..
        } = &self.pictures;
        let far = wgpu::Color::WHITE;
        record(encoder, bindings, &seen.view, Some(depth), far, |pass| {
            surface.draw_depth(pass);
        });
        apply(encoder, bindings, &self.search, seen, found);
        apply(encoder, bindings, &self.blur, found, seen);
    }
}

impl Pictures {
    fn new(gpu: &Gpu, reading: &Reading, size: (u32, u32)) -> Self {
        Self {
            size,
            seen: reading.canvas(gpu, DEPTH_PICTURE, size),
            found: reading.canvas(gpu, DEPTH_PICTURE, size),
            depth: texture::depth(gpu, size),
        }
    }
}
