//! JavaScript class `Viewer`: see the methods for what `www/viewer.js` may call.

use glam::{Vec2, Vec3};
use js_sys::{Float32Array, Function, Promise, Reflect, Uint8Array, Uint32Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{future_to_promise, spawn_local};
use web_sys::HtmlCanvasElement;

use super::fault::{fault, object};
use crate::mesh::shape::sphere;
use crate::viewer::colour::{ColourMap, Theme, colour_bar};
use crate::viewer::error::ViewerError;
use crate::viewer::gpu;
use crate::viewer::quality::{Effects, Wish};

#[wasm_bindgen]
extern "C" {
    /// `{ samples?: 1 | 4 }`
    pub type ViewerOptions;
    #[wasm_bindgen(method, getter)]
    fn samples(this: &ViewerOptions) -> Option<u32>;

    /// `{ shading?, wireframe?, boundary?, inside?, cut?, theme?, contrast?, lineWidth?, effects? }`
    pub type StyleOptions;
    #[wasm_bindgen(method, getter)]
    fn shading(this: &StyleOptions) -> Option<String>;
    #[wasm_bindgen(method, getter)]
    fn wireframe(this: &StyleOptions) -> Option<bool>;
    #[wasm_bindgen(method, getter)]
    fn boundary(this: &StyleOptions) -> Option<bool>;
    #[wasm_bindgen(method, getter)]
    fn inside(this: &StyleOptions) -> Option<bool>;
    #[wasm_bindgen(method, getter)]
    fn cut(this: &StyleOptions) -> Option<f32>;
    #[wasm_bindgen(method, getter)]
    fn theme(this: &StyleOptions) -> Option<String>;
    #[wasm_bindgen(method, getter)]
    fn contrast(this: &StyleOptions) -> Option<bool>;
    #[wasm_bindgen(method, getter, js_name = lineWidth)]
    fn line_width(this: &StyleOptions) -> Option<f32>;
    #[wasm_bindgen(method, getter)]
    fn effects(this: &StyleOptions) -> Option<String>;
}

impl From<ViewerError> for JsValue {
    fn from(error: ViewerError) -> Self {
        fault(&error)
    }
}

/// The page's first sample, for a picture before the solver is there: `{ positions, triangles }`
/// as in the solver's `Loaded`. All shapes here would add a third to what the first picture
/// waits for.
///
/// # Errors
/// None.
#[wasm_bindgen(js_name = firstSurface)]
pub fn first_surface() -> Result<JsValue, JsValue> {
    let (amplitude, frequency, seed) = sphere::BUMPS;
    let soup = sphere::bumpy_sphere(sphere::FIRST_LEVEL, amplitude, frequency, seed)
        .map_err(|error| fault(&error))?;
    let positions: Vec<f32> = soup
        .positions
        .iter()
        .flat_map(|p| p.as_vec3().to_array())
        .collect();
    Ok(object(&[
        ("positions", Float32Array::from(positions.as_slice()).into()),
        (
            "triangles",
            Uint32Array::from(soup.corners.as_slice()).into(),
        ),
    ]))
}

/// One surface on one canvas. Every method that takes an array copies it; those that
/// refuse one throw a `Fault` and change nothing.
#[wasm_bindgen]
pub struct Viewer(gpu::Viewer);

#[wasm_bindgen]
impl Viewer {
    /// Opens a graphics device for a canvas. Four samples a pixel unless told one.
    ///
    /// # Errors
    /// Rejects with `NoWebGpu`, `NoAdapter`, `NoDevice` or `NoCanvas`.
    pub async fn create(
        canvas: HtmlCanvasElement,
        options: Option<ViewerOptions>,
    ) -> Result<Viewer, JsValue> {
        let property = |object: JsValue, key: &str| Reflect::get(&object, &key.into());
        let navigator = property(js_sys::global().into(), "navigator")?;
        if cfg!(not(feature = "viewer-webgl")) && property(navigator, "gpu")?.is_falsy() {
            return Err(ViewerError::NoWebGpu.into());
        }
        let single = options.and_then(|options| options.samples()) == Some(1);
        Ok(Self(
            gpu::Viewer::open(canvas, if single { 1 } else { 4 }).await?,
        ))
    }

    /// Shows another mesh from where the camera stands, without field and marks.
    #[wasm_bindgen(js_name = setMesh)]
    pub fn set_mesh(
        &mut self,
        positions: &[f32],
        triangles: &[u32],
        wire_edges: &[u32],
        boundary_edges: &[u32],
    ) -> Result<(), JsValue> {
        Ok(self
            .0
            .set_mesh(positions, triangles, wire_edges, boundary_edges)?)
    }

    /// Shows one step alone, at time 0; the camera stays.
    #[wasm_bindgen(js_name = setPositions)]
    pub fn set_positions(&mut self, positions: &[f32]) -> Result<(), JsValue> {
        Ok(self.0.set_positions(positions)?)
    }

    /// Adds the step that follows, to be shown at a time after the last. What is shown is of
    /// the time set; up to four steps are held, of which the oldest makes room. On the way to
    /// the step vertices move along cubics, or along straight lines.
    #[wasm_bindgen(js_name = addStep)]
    pub fn add_step(
        &mut self,
        positions: &[f32],
        time: f32,
        is_straight: bool,
    ) -> Result<(), JsValue> {
        Ok(self.0.add_step(positions, time, is_straight)?)
    }

    /// Shows the surface at a time between the steps that are held; at that of a step, exactly
    /// that step.
    #[wasm_bindgen(js_name = setTime)]
    pub fn set_time(&mut self, time: f32) {
        self.0.set_time(time);
    }

    /// Colours by a value a vertex at the step set or added last.
    #[wasm_bindgen(js_name = setField)]
    pub fn set_field(
        &mut self,
        values: &[f32],
        low: f32,
        high: f32,
        signed: bool,
    ) -> Result<(), JsValue> {
        Ok(self.0.set_field(values, low, high, signed)?)
    }

    /// Back to the plain colour.
    #[wasm_bindgen(js_name = clearField)]
    pub fn clear_field(&mut self) {
        self.0.clear_field();
    }

    /// Highlights these triangles and no others.
    #[wasm_bindgen(js_name = setMarkedTriangles)]
    pub fn set_marked_triangles(&mut self, marked: &[u32]) -> Result<(), JsValue> {
        Ok(self.0.set_marked_triangles(marked)?)
    }

    /// Draws these edges over all others, two vertices each, and no others so.
    #[wasm_bindgen(js_name = setHighlight)]
    pub fn set_highlight(&mut self, ends: &[u32]) -> Result<(), JsValue> {
        Ok(self.0.set_highlight(ends)?)
    }

    /// Draws these segments over the surface: two ends of three coordinates, and r, g, b, a
    /// bytes each. `hidden` is their opacity where the surface hides them.
    #[wasm_bindgen(js_name = setOverlay)]
    pub fn set_overlay(
        &mut self,
        ends: &[f32],
        colours: &[u8],
        hidden: f32,
    ) -> Result<(), JsValue> {
        Ok(self.0.set_overlay(ends, colours, hidden)?)
    }

    /// The pixel a point is seen at, and its distance from the plane of the eye; none from
    /// behind.
    pub fn project(&self, x: f32, y: f32, z: f32) -> Option<Vec<f32>> {
        let (at, depth) = self.0.camera().project(Vec3::new(x, y, z))?;
        Some(vec![at.x, at.y, depth])
    }

    /// The point seen at a pixel at such a distance.
    pub fn unproject(&self, x: f32, y: f32, depth: f32) -> Vec<f32> {
        self.0.camera().unproject(x, y, depth).to_array().to_vec()
    }

    /// The point of the surface under a pixel: three coordinates and the vertex next to it, or
    /// none.
    pub fn pick(&self, x: f32, y: f32) -> Option<Vec<f32>> {
        let hit = self.0.pick(Vec2::new(x, y))?;
        let [x, y, z] = hit.point.to_array();
        Some(vec![x, y, z, hit.vertex as f32])
    }

    /// Gives a value to the vertices of a set, a byte each, that lie within `reach` pixels of what
    /// is seen at one; none where nothing is.
    pub fn painted(&self, set: &[u8], x: f32, y: f32, reach: f32, value: u8) -> Option<Vec<u8>> {
        self.0.painted(set, Vec2::new(x, y), reach, value)
    }

    /// Spreads a value of such a set by one ring of neighbours.
    pub fn grown(&self, set: &[u8], value: u8) -> Option<Vec<u8>> {
        self.0.grown(set, value)
    }

    /// The box about the surface: three coordinates of its middle, and its diagonal.
    #[wasm_bindgen(js_name = boundingBox)]
    pub fn bounding_box(&self) -> Vec<f32> {
        let (middle, diagonal) = self.0.bounding_box();
        vec![middle.x, middle.y, middle.z, diagonal]
    }

    /// Which of these edges, two vertices each, is seen within `reach` of a pixel: its number.
    #[wasm_bindgen(js_name = nearestEdge)]
    pub fn nearest_edge(
        &self,
        ends: &[u32],
        x: f32,
        y: f32,
        reach: f32,
    ) -> Result<Option<usize>, JsValue> {
        Ok(self.0.nearest_edge(ends, Vec2::new(x, y), reach)?)
    }

    /// Tints held vertices: a byte each, 1 where held; empty for none.
    #[wasm_bindgen(js_name = setMarkedVertices)]
    pub fn set_marked_vertices(&mut self, held: &[u8]) -> Result<(), JsValue> {
        Ok(self.0.set_marked_vertices(held)?)
    }

    /// Changes what is given of the style; names that are unknown change nothing.
    #[wasm_bindgen(js_name = setStyle)]
    pub fn set_style(&mut self, options: &StyleOptions) {
        let mut style = self.0.style();
        match options.shading().as_deref() {
            Some("flat") => style.is_flat = true,
            Some("smooth") => style.is_flat = false,
            _ => {}
        }
        match options.theme().as_deref() {
            Some("light") => style.theme = Theme::Light,
            Some("dark") => style.theme = Theme::Dark,
            _ => {}
        }
        match options.effects().as_deref() {
            Some("auto") => style.effects = Wish::Auto,
            Some("always") => style.effects = Wish::Always,
            Some("never") => style.effects = Wish::Never,
            _ => {}
        }
        style.wireframe = options.wireframe().unwrap_or(style.wireframe);
        style.boundary = options.boundary().unwrap_or(style.boundary);
        style.inside = options.inside().unwrap_or(style.inside);
        style.cut = options.cut().unwrap_or(style.cut);
        style.contrast = options.contrast().unwrap_or(style.contrast);
        style.line_width = options.line_width().unwrap_or(style.line_width);
        self.0.set_style(style);
    }

    /// Resizes the picture, in device pixels. Clears the canvas: draw in the same turn.
    pub fn resize(&mut self, width: u32, height: u32) {
        self.0.resize(width, height);
    }

    /// Turns the surface as if dragged by so many pixels.
    pub fn orbit(&mut self, dx: f32, dy: f32) {
        self.0.camera_mut().orbit(dx, dy);
    }

    /// Turns the picture anticlockwise, in radians, and what counts as upright with it.
    pub fn roll(&mut self, angle: f32) {
        self.0.camera_mut().roll(angle);
    }

    /// Moves the surface by so many pixels.
    pub fn pan(&mut self, dx: f32, dy: f32) {
        self.0.camera_mut().pan(dx, dy);
    }

    /// Comes closer by a factor, towards a pixel.
    pub fn zoom(&mut self, factor: f32, x: f32, y: f32) {
        self.0.camera_mut().zoom(factor, x, y);
    }

    /// Centres the surface and fills the picture with it, from the present direction.
    pub fn fit(&mut self) {
        self.0.camera_mut().fit();
    }

    /// Turns to some triangles, so that they are seen from in front.
    pub fn face(&mut self, triangles: &[u32]) {
        self.0.face(triangles);
    }

    /// Fits from the standard direction, with z or y up.
    pub fn home(&mut self, is_z_up: bool) {
        self.0.camera_mut().home(is_z_up);
    }

    /// The camera as numbers, independent of the size of the picture.
    pub fn camera(&self) -> Vec<f32> {
        self.0.camera().to_array().to_vec()
    }

    /// Takes over numbers of `camera`; false, and no change, when they make no sense.
    #[wasm_bindgen(js_name = setCamera)]
    pub fn set_camera(&mut self, numbers: &[f32]) -> bool {
        self.0.camera_mut().set_from_slice(numbers)
    }

    /// Draws at the next call of `draw` even if nothing has changed, as in motion: WebGL forgets a
    /// picture once it is on the screen.
    pub fn invalidate(&mut self) {
        self.0.invalidate();
    }

    /// Takes the next picture for one that stays; says whether there is something to draw, as more
    /// is drawn on it beyond surface and lines.
    pub fn settle(&mut self) -> bool {
        self.0.settle()
    }

    /// Draws if anything has changed; says whether it did.
    pub fn draw(&mut self) -> bool {
        self.0.draw()
    }

    /// Takes note of the milliseconds from a frame of the display, in which a picture was
    /// drawn, to the next; says whether there is something to draw, as less is drawn beyond
    /// surface and lines from now on.
    #[wasm_bindgen(js_name = recordFrame)]
    pub fn record_frame(&mut self, milliseconds: f32) -> bool {
        self.0.record_frame(milliseconds)
    }

    /// Whether the graphics device went away; then this viewer is dead.
    #[wasm_bindgen(js_name = isLost)]
    pub fn is_lost(&self) -> bool {
        self.0.lost().get().is_some()
    }

    /// Calls back once, with the reason, when the graphics device goes away, also by
    /// `free`. One callback only: a later one replaces it.
    #[wasm_bindgen(js_name = onLost)]
    pub fn on_lost(&self, callback: Function) {
        let lost = self.0.lost().clone();
        spawn_local(async move {
            let reason = lost.wait().await;
            // What the callback throws is its own affair.
            let _ = callback.call1(&JsValue::UNDEFINED, &reason.into());
        });
    }

    /// Draws the present picture once more and reads it back: `{ width, height, data }`,
    /// r, g, b, a bytes from the top left. Works also where the canvas shows nothing.
    #[wasm_bindgen(js_name = readPixels)]
    pub fn read_pixels(&mut self) -> Promise {
        // Not an async method: that would borrow the viewer until the picture is here.
        let picture = self.0.read_picture();
        future_to_promise(async move {
            let picture = picture.await?;
            Ok(object(&[
                ("width", picture.width.into()),
                ("height", picture.height.into()),
                ("data", Uint8Array::from(picture.data.as_slice()).into()),
            ]))
        })
    }

    /// What the graphics adapter calls itself; browsers often leave it empty.
    pub fn adapter(&self) -> String {
        self.0.adapter().to_owned()
    }

    /// What is drawn beyond surface and lines: `none`, `shadow`, or `occlusion` as well.
    pub fn effects(&self) -> String {
        let name = match self.0.effects() {
            Effects::None => "none",
            Effects::Shadow => "shadow",
            Effects::Occlusion => "occlusion",
        };
        name.to_owned()
    }

    /// `n` colours of a colour map from low to high, r, g, b bytes each; of high contrast
    /// where the style has it.
    #[wasm_bindgen(js_name = colourBar)]
    pub fn colour_bar(&self, signed: bool, n: usize) -> Vec<u8> {
        let contrast = self.0.style().contrast;
        colour_bar(ColourMap { signed, contrast }, n)
    }
}
