//! The viewer: a mesh, a camera and a style in, a picture on a canvas out.

use glam::{Vec2, Vec3, Vec4};
use web_sys::HtmlCanvasElement;

use super::background_pass::BackgroundPass;
use super::bindings::Bindings;
use super::device::Gpu;
use super::line_pass::{EdgeSet, LinePass, SegmentSet};
use super::readback::{Picture, Readback};
use super::signal::Signal;
use super::surface_pass::SurfacePass;
use crate::viewer::camera::Camera;
use crate::viewer::colour::{ColourMap, Theme, linear};
use crate::viewer::drawing::{Drawing, expect_range};
use crate::viewer::edges::edges;
use crate::viewer::error::ViewerError;
use crate::viewer::frame::{Frame, Line};
use crate::viewer::pick::{Hit, nearest_edge, pick};
use crate::viewer::segments::segments;

/// How the surface is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// One normal a triangle instead of one a vertex.
    pub is_flat: bool,
    /// Draws the mesh's own edges.
    pub wireframe: bool,
    /// Draws the boundary loops.
    pub boundary: bool,
    /// Light or dark surroundings.
    pub theme: Theme,
    /// Colours a field by the maps of high contrast.
    pub contrast: bool,
    /// Width of an edge in device pixels; the boundary is drawn [`BOUNDARY_WIDTH`] times
    /// as wide.
    pub line_width: f32,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            is_flat: false,
            wireframe: false,
            boundary: true,
            theme: Theme::Dark,
            contrast: false,
            line_width: 1.2,
        }
    }
}

/// Width of the boundary in widths of an edge.
const BOUNDARY_WIDTH: f32 = 3.0;
/// The same of segments over the surface.
const OVERLAY_WIDTH: f32 = 1.6;
/// Opacity of the edges of the mesh.
const WIRE_OPACITY: f32 = 0.75;
/// Edges of the mesh vanish where they are shorter on screen than the first, and are drawn
/// in full where they are longer than the second number of line widths.
const WIRE_FADE: (f32, f32) = (3.0, 14.0);

/// Cosines up to which a back counts as front. The inside of a closed surface is seen only
/// through self-intersections; an open one shows its back up to the silhouette.
const GRAZING_CLOSED: f32 = 0.3;
const GRAZING_OPEN: f32 = 0.02;

/// Colours for the values of a field.
#[derive(Clone, Copy)]
struct FieldRange {
    low: f32,
    high: f32,
    signed: bool,
}

/// What has changed since the last picture.
#[derive(Default)]
struct Stale {
    picture: bool,
    vertices: bool,
    normals: bool,
    flags: bool,
}

/// Everything needed to draw one surface on one canvas.
pub struct Viewer {
    gpu: Gpu,
    bindings: Bindings,
    background: BackgroundPass,
    surface: SurfacePass,
    lines: LinePass,
    wire: EdgeSet,
    boundary: EdgeSet,
    highlight: EdgeSet,
    overlay: SegmentSet,
    /// Opacity of the overlay where the surface hides it.
    overlay_hidden: f32,
    drawing: Drawing,
    camera: Camera,
    style: Style,
    field: Option<FieldRange>,
    stale: Stale,
}

impl Viewer {
    /// Opens a device and makes the pipelines; nothing is drawn yet.
    ///
    /// # Errors
    /// `NoAdapter`, `NoDevice`, `NoCanvas`.
    pub async fn open(canvas: HtmlCanvasElement, samples: u32) -> Result<Self, ViewerError> {
        let gpu = Gpu::open(canvas, samples).await?;
        let mut bindings = Bindings::new(&gpu);
        bindings.set_map(&gpu, ColourMap::default());
        let lines = LinePass::new(&gpu, &bindings);
        let mut camera = Camera::default();
        let (width, height) = gpu.size();
        camera.resize(width, height);
        Ok(Self {
            background: BackgroundPass::new(&gpu, &bindings),
            surface: SurfacePass::new(&gpu, &bindings),
            wire: lines.edge_set(&gpu),
            boundary: lines.edge_set(&gpu),
            highlight: lines.edge_set(&gpu),
            overlay: lines.segment_set(&gpu),
            overlay_hidden: 0.0,
            lines,
            bindings,
            gpu,
            drawing: Drawing::default(),
            camera,
            style: Style::default(),
            field: None,
            stale: Stale {
                picture: true,
                ..Stale::default()
            },
        })
    }

    /// Shows another mesh from the standard direction, without field and marks.
    ///
    /// # Errors
    /// As [`replace_mesh`](Self::replace_mesh).
    pub fn set_mesh(
        &mut self,
        positions: &[f32],
        triangles: &[u32],
        wire_edges: &[u32],
        boundary_edges: &[u32],
    ) -> Result<(), ViewerError> {
        self.replace_mesh(positions, triangles, wire_edges, boundary_edges)?;
        self.camera.home();
        Ok(())
    }

    /// Shows another mesh from where the camera stands, without field and marks.
    ///
    /// # Errors
    /// `WrongLength`, `OutOfRange`, `TooLarge`; the mesh shown before then stays.
    pub fn replace_mesh(
        &mut self,
        positions: &[f32],
        triangles: &[u32],
        wire_edges: &[u32],
        boundary_edges: &[u32],
    ) -> Result<(), ViewerError> {
        let drawing = Drawing::new(positions, triangles, boundary_edges.is_empty())?;
        expect_range("wireEdges", wire_edges, drawing.n_vertices())?;
        expect_range("boundaryEdges", boundary_edges, drawing.n_vertices())?;
        self.gpu.expect_room_for(drawing.vertices().len())?;
        self.drawing = drawing;
        self.surface.set_mesh(&self.gpu, &self.drawing);
        let vertices = self.drawing.vertices();
        self.wire.set_edges(&self.gpu, &edges(vertices, wire_edges));
        self.boundary
            .set_edges(&self.gpu, &edges(vertices, boundary_edges));
        self.highlight.set_edges(&self.gpu, &[]);
        self.field = None;
        self.camera.set_bounds(self.drawing.bounds());
        self.stale = Stale {
            picture: true,
            vertices: true,
            normals: true,
            flags: true,
        };
        Ok(())
    }

    /// Moves the vertices; the camera stays.
    ///
    /// # Errors
    /// `WrongLength`.
    pub fn set_positions(&mut self, positions: &[f32]) -> Result<(), ViewerError> {
        self.drawing.set_positions(positions)?;
        self.camera.set_bounds(self.drawing.bounds());
        self.stale.vertices = true;
        self.stale.normals = true;
        self.stale.picture = true;
        Ok(())
    }

    /// Colours the surface by a value a vertex, from `low` to `high`; `signed` takes the
    /// diverging colour map.
    ///
    /// # Errors
    /// `WrongLength`.
    pub fn set_field(
        &mut self,
        values: &[f32],
        low: f32,
        high: f32,
        signed: bool,
    ) -> Result<(), ViewerError> {
        self.drawing.set_field(values)?;
        self.field = Some(FieldRange { low, high, signed });
        self.send_map();
        self.stale.vertices = true;
        self.stale.flags = true;
        self.stale.picture = true;
        Ok(())
    }

    fn send_map(&mut self) {
        let map = ColourMap {
            signed: self.field.is_some_and(|field| field.signed),
            contrast: self.style.contrast,
        };
        self.bindings.set_map(&self.gpu, map);
    }

    /// Shows the surface in its plain colour.
    pub fn clear_field(&mut self) {
        self.field = None;
        self.stale.picture = true;
    }

    /// Highlights these triangles and no others.
    ///
    /// # Errors
    /// `OutOfRange`.
    pub fn set_marked_triangles(&mut self, marked: &[u32]) -> Result<(), ViewerError> {
        self.drawing.set_marked_triangles(marked)?;
        self.surface.set_marked(&self.gpu, &self.drawing);
        self.stale.picture = true;
        Ok(())
    }

    /// Tints held vertices: one byte each, 0 or 1; empty for none.
    ///
    /// # Errors
    /// `WrongLength`.
    pub fn set_marked_vertices(&mut self, held: &[u8]) -> Result<(), ViewerError> {
        self.drawing.set_marked_vertices(held)?;
        self.stale.flags = true;
        self.stale.picture = true;
        Ok(())
    }

    /// Draws these edges, two vertices each, over all others, and no others so.
    ///
    /// # Errors
    /// `OutOfRange`.
    pub fn set_highlight(&mut self, ends: &[u32]) -> Result<(), ViewerError> {
        expect_range("highlight", ends, self.drawing.n_vertices())?;
        let edges = edges(self.drawing.vertices(), ends);
        self.highlight.set_edges(&self.gpu, &edges);
        self.stale.picture = true;
        Ok(())
    }

    /// Draws these segments of space over the surface, two ends and a colour each, and no
    /// others; `hidden` is their opacity where the surface hides them.
    ///
    /// # Errors
    /// `WrongLength`.
    pub fn set_overlay(
        &mut self,
        ends: &[f32],
        colours: &[u8],
        hidden: f32,
    ) -> Result<(), ViewerError> {
        let segments = segments(ends, colours)?;
        self.overlay.set_segments(&self.gpu, &segments);
        self.overlay_hidden = hidden;
        self.stale.picture = true;
        Ok(())
    }

    /// Size of a pixel in the world, at a point.
    pub fn pixel_size_at(&self, point: Vec3) -> f32 {
        let depth = self.camera.project(point).map_or(0.0, |(_, depth)| depth);
        depth * self.camera.pixel_size()
    }

    /// What lies under a pixel.
    pub fn pick(&self, at: Vec2) -> Option<Hit> {
        let (origin, direction) = self.camera.ray(at.x, at.y);
        pick(&self.drawing, origin, direction)
    }

    /// Which of these edges, two vertices each, is seen next to a pixel.
    ///
    /// # Errors
    /// `OutOfRange`.
    pub fn nearest_edge(
        &self,
        ends: &[u32],
        at: Vec2,
        reach: f32,
    ) -> Result<Option<usize>, ViewerError> {
        expect_range("edges", ends, self.drawing.n_vertices())?;
        Ok(nearest_edge(&self.drawing, &self.camera, ends, at, reach))
    }

    /// How the surface is drawn.
    pub fn style(&self) -> Style {
        self.style
    }

    /// Draws the surface in another way.
    pub fn set_style(&mut self, style: Style) {
        self.stale.picture |= self.style != style;
        self.style = style;
        self.send_map();
    }

    /// Resizes the picture, in device pixels. Clears the canvas: draw in the same turn.
    pub fn resize(&mut self, width: u32, height: u32) {
        if self.gpu.size() != (width, height) {
            self.gpu.resize(width, height);
            let (width, height) = self.gpu.size();
            self.camera.resize(width, height);
            self.stale.picture = true;
        }
    }

    /// Where the picture is taken from.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// The same, to be moved.
    pub fn camera_mut(&mut self) -> &mut Camera {
        self.stale.picture = true;
        &mut self.camera
    }

    /// Draws at the next call of [`draw`](Self::draw), even if nothing has changed.
    pub fn invalidate(&mut self) {
        self.stale.picture = true;
    }

    /// Draws, if anything has changed; says whether it did.
    pub fn draw(&mut self) -> bool {
        if !self.stale.picture || self.lost().get().is_some() {
            return false;
        }
        let Some(texture) = self.gpu.next_texture() else {
            return false;
        };
        self.upload();
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        self.render(
            &mut encoder,
            &texture.texture.create_view(&Default::default()),
        );
        self.gpu.queue.submit([encoder.finish()]);
        self.gpu.queue.present(texture);
        self.stale.picture = false;
        true
    }

    /// Draws once more into a texture and reads it back. The future borrows nothing, so
    /// that drawing can go on meanwhile.
    ///
    /// # Errors
    /// `GpuLost`.
    pub fn read_picture(&mut self) -> impl Future<Output = Result<Picture, ViewerError>> + use<> {
        self.upload();
        Readback::start(&self.gpu, |encoder, target| self.render(encoder, target)).finish()
    }

    /// Why the device was lost, once it is.
    pub fn lost(&self) -> &Signal<String> {
        &self.gpu.lost
    }

    /// What the graphics adapter calls itself; browsers often leave it empty.
    pub fn adapter(&self) -> &str {
        &self.gpu.adapter
    }

    /// Sends what is stale. Vertex normals only when they are looked at: they are the
    /// dearest part of a frame.
    fn upload(&mut self) {
        let gpu = &self.gpu;
        if std::mem::take(&mut self.stale.vertices) {
            self.bindings.set_vertices(gpu, self.drawing.vertices());
        }
        if self.stale.normals && !self.style.is_flat {
            self.stale.normals = false;
            self.drawing.update_normals();
            self.surface.set_normals(gpu, &self.drawing);
        }
        if std::mem::take(&mut self.stale.flags) {
            self.surface.set_flags(gpu, &self.drawing);
        }
        self.bindings.set_frame(gpu, &self.frame());
        let palette = self.style.theme.palette();
        let line = |srgb, opacity, width: f32, (fade_from, fade_to): (f32, f32)| Line {
            colour: Vec4::from(linear(srgb)).truncate().extend(opacity),
            half_width: 0.5 * width,
            fade_from: fade_from * width,
            fade_to: fade_to * width,
            lift: 2.0 + width,
        };
        let width = self.style.line_width;
        self.wire
            .set_line(gpu, &line(palette.wire, WIRE_OPACITY, width, WIRE_FADE));
        let (always, width) = ((-2.0, -1.0), BOUNDARY_WIDTH * width);
        self.boundary
            .set_line(gpu, &line(palette.boundary, 1.0, width, always));
        self.highlight
            .set_line(gpu, &line(palette.marked, 1.0, width, always));
        let width = OVERLAY_WIDTH * self.style.line_width;
        let segments = |opacity| line(palette.marked, opacity, width, always);
        self.overlay
            .set_lines(gpu, &segments(1.0), &segments(self.overlay_hidden));
    }

    fn frame(&self) -> Frame {
        let colour = |srgb| Vec4::from(linear(srgb));
        let palette = self.style.theme.palette();
        let (width, height) = self.gpu.size();
        let (low, high) = self
            .field
            .map_or((0.0, 1.0), |field| (field.low, field.high));
        let back = if self.drawing.has_two_sides() {
            palette.back
        } else {
            palette.front
        };
        Frame {
            clip_from_view: self.camera.clip_from_view(),
            view_from_world: self.camera.view_from_world(),
            glow: colour(palette.glow),
            corner: colour(palette.corner),
            front: colour(palette.front),
            back: colour(back),
            fixed: colour(palette.fixed),
            marked: colour(palette.marked),
            viewport: Vec2::new(width as f32, height as f32),
            pixel_size: self.camera.pixel_size(),
            near: self.camera.clip_planes().0,
            // The middle of the map where a range is empty: a constant field is no extreme.
            field_low: if high > low { low } else { low - 0.5 },
            field_scale: if high > low { 1.0 / (high - low) } else { 1.0 },
            field_strength: if self.field.is_some() { 1.0 } else { 0.0 },
            flatness: if self.style.is_flat { 1.0 } else { 0.0 },
            grazing: if self.drawing.is_closed() {
                GRAZING_CLOSED
            } else {
                GRAZING_OPEN
            },
            padding: [0.0; 3],
        }
    }

    fn render(&self, encoder: &mut wgpu::CommandEncoder, target: &wgpu::TextureView) {
        self.gpu.render(encoder, target, |pass| {
            pass.set_bind_group(0, &self.bindings.group, &[]);
            self.surface.draw(pass);
            self.background.draw(pass);
            self.surface.draw_marked(pass);
            if self.style.wireframe {
                self.lines.draw(pass, &self.wire);
            }
            if self.style.boundary {
                self.lines.draw(pass, &self.boundary);
            }
            self.lines.draw(pass, &self.highlight);
            self.lines.draw_segments(pass, &self.overlay);
        });
    }
}
