//! The viewer: a mesh, a camera and a style in, a picture on a canvas out.

use glam::{Vec2, Vec3};
use web_sys::HtmlCanvasElement;

use super::background_pass::BackgroundPass;
use super::bindings::Bindings;
use super::device::Gpu;
use super::effects::EffectPasses;
use super::line_pass::{EdgeSet, LinePass, SegmentSet};
use super::material::Material;
use super::readback::{Picture, Readback};
use super::signal::Signal;
use super::surface_pass::SurfacePass;
use crate::viewer::brush;
use crate::viewer::camera::Camera;
use crate::viewer::colour::ColourMap;
use crate::viewer::drawing::{Drawing, expect_range};
use crate::viewer::error::ViewerError;
use crate::viewer::frame::{Frame, Line};
use crate::viewer::motion::SLOTS;
use crate::viewer::pick::{Hit, nearest_edge, pick};
use crate::viewer::quality::Effects;
use crate::viewer::segments::segments;
use crate::viewer::style::{BOUNDARY_WIDTH, CHOSEN_WIDTH, FieldRange, OVERLAY_WIDTH, Style};

/// What has changed since the last picture.
#[derive(Default)]
struct Stale {
    picture: bool,
    /// Positions and values, by slot.
    steps: [bool; SLOTS],
    flags: bool,
}

/// Everything needed to draw one surface on one canvas.
pub struct Viewer {
    gpu: Gpu,
    bindings: Bindings,
    material: Material,
    background: BackgroundPass,
    surface: SurfacePass,
    effects: EffectPasses,
    lines: LinePass,
    boundary: EdgeSet,
    highlight: EdgeSet,
    overlay: SegmentSet,
    /// Opacity of the overlay where the surface hides it.
    overlay_hidden: f32,
    drawing: Drawing,
    /// The mesh's own edges, two vertices each.
    wire_edges: Vec<u32>,
    camera: Camera,
    style: Style,
    field: Option<FieldRange>,
    stale: Stale,
    /// Whether the next picture is one that stays.
    is_still: bool,
}

impl Viewer {
    /// Opens a device and makes the pipelines; nothing is drawn yet.
    ///
    /// # Errors
    /// `NoAdapter`, `NoDevice`, `NoCanvas`.
    pub async fn open(canvas: HtmlCanvasElement, samples: u32) -> Result<Self, ViewerError> {
        let gpu = Gpu::open(canvas, samples).await?;
        let bindings = Bindings::new(&gpu);
        let effects = EffectPasses::new(&gpu, &bindings);
        let (openness, footprint) = (effects.occlusion.openness(), effects.shadow.picture());
        let mut material = Material::new(&gpu, openness, footprint);
        material.set_map(&gpu, ColourMap::default());
        let lines = LinePass::new(&gpu, &bindings);
        let mut camera = Camera::default();
        let (width, height) = gpu.size();
        camera.resize(width, height);
        Ok(Self {
            background: BackgroundPass::new(&gpu, &bindings, &material),
            surface: SurfacePass::new(&gpu, &bindings, &material),
            boundary: lines.edge_set(&gpu),
            highlight: lines.edge_set(&gpu),
            overlay: lines.segment_set(&gpu),
            overlay_hidden: 0.0,
            lines,
            effects,
            material,
            bindings,
            gpu,
            drawing: Drawing::default(),
            wire_edges: Vec::new(),
            camera,
            style: Style::default(),
            field: None,
            stale: Stale {
                picture: true,
                ..Stale::default()
            },
            is_still: false,
        })
    }

    /// Shows another mesh from where the camera stands, without field and marks.
    ///
    /// # Errors
    /// `WrongLength`, `OutOfRange`, `TooLarge`; the mesh shown before then stays.
    pub fn set_mesh(
        &mut self,
        positions: &[f32],
        triangles: &[u32],
        wire_edges: &[u32],
        boundary_edges: &[u32],
    ) -> Result<(), ViewerError> {
        let drawing = Drawing::new(positions, triangles, boundary_edges.is_empty())?;
        expect_range("wireEdges", wire_edges, drawing.n_vertices())?;
        expect_range("boundaryEdges", boundary_edges, drawing.n_vertices())?;
        self.gpu.expect_room_for(drawing.flags().len())?;
        self.drawing = drawing;
        self.surface.set_mesh(&self.gpu, &self.drawing);
        self.wire_edges = wire_edges.to_vec();
        self.boundary.set_edges(&self.gpu, boundary_edges);
        self.highlight.set_edges(&self.gpu, &[]);
        self.field = None;
        self.camera.set_bounds(self.drawing.bounds());
        self.stale = Stale {
            picture: true,
            steps: [true; SLOTS],
            flags: true,
        };
        Ok(())
    }

    /// Shows one step alone; the camera stays.
    ///
    /// # Errors
    /// `WrongLength`.
    pub fn set_positions(&mut self, positions: &[f32]) -> Result<(), ViewerError> {
        self.drawing.set_positions(positions)?;
        self.step_set();
        Ok(())
    }

    /// Adds the step that follows, to be shown at a time after the last: in what units, is
    /// the caller's choice. The steps before stay where they are; the oldest of four makes
    /// room. On the way to it each vertex moves along a cubic, or along a straight line.
    ///
    /// # Errors
    /// `WrongLength`, `WrongTime`; nothing is then added.
    pub fn add_step(
        &mut self,
        positions: &[f32],
        time: f32,
        is_straight: bool,
    ) -> Result<(), ViewerError> {
        self.drawing.add_step(positions, time, is_straight)?;
        self.step_set();
        Ok(())
    }

    /// Shows the surface as it is at a time between the steps that are held. The step set
    /// alone has time 0.
    pub fn set_time(&mut self, time: f32) {
        self.drawing.set_time(time);
        self.camera.set_bounds(self.drawing.bounds());
        self.stale.picture = true;
    }

    fn step_set(&mut self) {
        self.stale.steps[self.drawing.newest()] = true;
        self.camera.set_bounds(self.drawing.bounds());
        self.stale.picture = true;
    }

    /// Colours the surface by a value a vertex at the step set or added last, from `low` to
    /// `high`; `signed` takes the diverging colour map.
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
        self.stale.steps[self.drawing.newest()] = true;
        self.stale.flags = true;
        self.stale.picture = true;
        Ok(())
    }

    fn send_map(&mut self) {
        let map = ColourMap {
            signed: self.field.is_some_and(|field| field.signed),
            contrast: self.style.contrast,
        };
        self.material.set_map(&self.gpu, map);
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
        self.highlight.set_edges(&self.gpu, ends);
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
    fn pixel_size_at(&self, point: Vec3) -> f32 {
        let depth = self.camera.project(point).map_or(0.0, |(_, depth)| depth);
        depth * self.camera.pixel_size()
    }

    /// What lies under a pixel.
    pub fn pick(&self, at: Vec2) -> Option<Hit> {
        let (origin, direction) = self.camera.ray(at.x, at.y);
        pick(&self.drawing, origin, direction)
    }

    /// Turns to some triangles, so that they are seen from in front.
    pub fn face(&mut self, triangles: &[u32]) {
        let direction = self.drawing.vector_area(triangles);
        self.camera_mut().face(direction);
    }

    /// Gives a value to the vertices of a set, a byte each, that lie within `reach` pixels of
    /// what is seen at one; none where nothing is, or where the set is of another surface.
    pub fn painted(&self, set: &[u8], at: Vec2, reach: f32, value: u8) -> Option<Vec<u8>> {
        let point = self.pick(at)?.point;
        let radius = reach * self.pixel_size_at(point);
        let is_own = set.len() == self.drawing.n_vertices();
        is_own.then(|| brush::painted(&self.drawing, set, point, radius, value))
    }

    /// Spreads a value of such a set by one ring of neighbours.
    pub fn grown(&self, set: &[u8], value: u8) -> Option<Vec<u8>> {
        let is_own = set.len() == self.drawing.n_vertices();
        is_own.then(|| brush::grown(&self.drawing, set, value))
    }

    /// Middle and diagonal of the box about the surface.
    pub fn bounding_box(&self) -> (Vec3, f32) {
        brush::bounding_box(&self.drawing)
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
        self.camera.set_cut(style.cut);
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

    /// Takes the next picture for one that stays; says whether more is drawn on it.
    pub fn settle(&mut self) -> bool {
        let before = self.effects();
        self.is_still = true;
        let is_more = self.effects() != before;
        self.stale.picture |= is_more;
        is_more
    }

    /// Draws at the next call of [`draw`](Self::draw), even if nothing has changed, as in motion.
    pub fn invalidate(&mut self) {
        self.stale.picture = true;
        self.is_still = false;
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
        self.is_still = false;
        true
    }

    /// Takes note of the milliseconds from one frame of the display, in which a picture was
    /// drawn, to the next; says whether there is something to draw as less is drawn now.
    pub fn record_frame(&mut self, milliseconds: f32) -> bool {
        let before = self.effects();
        self.effects.record(milliseconds);
        let is_less = self.effects() != before;
        self.stale.picture |= is_less;
        is_less
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

    /// What is drawn beyond surface and lines.
    pub fn effects(&self) -> Effects {
        self.effects.chosen(self.style.effects, self.is_still)
    }

    /// Sends what is stale. Vertex normals only when they are looked at: they are the
    /// dearest part of a frame.
    fn upload(&mut self) {
        let effects = self.effects();
        let gpu = &self.gpu;
        let has_normals = !self.style.is_flat || self.style.wireframe;
        let normals = if has_normals {
            self.drawing.update_normals()
        } else {
            [false; SLOTS]
        };
        let points = std::mem::take(&mut self.stale.steps);
        self.bindings.set_steps(gpu, &self.drawing, points, normals);
        if std::mem::take(&mut self.stale.flags) {
            self.bindings.set_marks(gpu, &self.drawing);
        }
        if self.style.wireframe {
            self.surface
                .prepare_wire(gpu, &self.drawing, &self.wire_edges);
        }
        if self.effects.prepare(gpu, effects) {
            let (openness, footprint) = (
                self.effects.occlusion.openness(),
                self.effects.shadow.picture(),
            );
            self.material.set_effects(gpu, openness, footprint);
        }
        self.bindings.set_frame(gpu, &self.frame());
        let palette = self.style.theme.palette();
        let line =
            |srgb, opacity, width: f32| Line::new(srgb, opacity, width * self.style.line_width);
        self.boundary
            .set_line(gpu, &line(palette.boundary, 1.0, BOUNDARY_WIDTH));
        self.highlight
            .set_line(gpu, &line(palette.chosen, 1.0, CHOSEN_WIDTH));
        let segments = |opacity| line(palette.marked, opacity, OVERLAY_WIDTH);
        self.overlay
            .set_lines(gpu, &segments(1.0), &segments(self.overlay_hidden));
    }

    fn frame(&self) -> Frame {
        Frame::new(
            &self.camera,
            &self.drawing,
            &self.style,
            self.field,
            self.effects(),
            self.gpu.size(),
        )
    }

    fn render(&self, encoder: &mut wgpu::CommandEncoder, target: &wgpu::TextureView) {
        self.effects
            .draw(encoder, &self.bindings, &self.surface, self.effects());
        self.gpu.render(encoder, target, |pass| {
            pass.set_bind_group(0, &self.bindings.group, &[]);
            pass.set_bind_group(1, &self.material.group, &[]);
            if self.style.wireframe {
                self.surface.draw_wire(pass);
            } else {
                self.surface.draw(pass);
            }
            self.background.draw(pass);
            self.surface.draw_marked(pass);
            if self.style.boundary {
                self.lines.draw(pass, &self.boundary);
            }
            self.lines.draw(pass, &self.highlight);
            self.lines.draw_segments(pass, &self.overlay);
        });
    }
}
