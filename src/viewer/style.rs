//! How the surface is drawn, as the page chooses it.

use super::colour::Theme;
use super::quality::Wish;

/// How the surface is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// One normal a triangle instead of one a vertex.
    pub is_flat: bool,
    /// Draws the mesh's own edges.
    pub wireframe: bool,
    /// Draws the boundary loops.
    pub boundary: bool,
    /// Whether the inside of a closed surface is seen, which passes through itself: then its back
    /// is told from its front up to the silhouette.
    pub inside: bool,
    /// What share of its depth is cut away in front, so that one sees inside.
    pub cut: f32,
    /// Light or dark surroundings.
    pub theme: Theme,
    /// Colours a field by the maps of high contrast.
    pub contrast: bool,
    /// Width of an edge in device pixels. The boundary is drawn [`BOUNDARY_WIDTH`] times as
    /// wide, and so on.
    pub line_width: f32,
    /// Whether corners and floor are darkened.
    pub effects: Wish,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            is_flat: false,
            wireframe: false,
            boundary: true,
            inside: false,
            cut: 0.0,
            theme: Theme::Dark,
            contrast: false,
            line_width: 1.0,
            effects: Wish::Auto,
        }
    }
}

/// Width of the boundary in widths of an edge.
pub const BOUNDARY_WIDTH: f32 = 2.0;
/// The same of chosen edges.
pub const CHOSEN_WIDTH: f32 = 4.0;
/// The same of segments over the surface.
pub const OVERLAY_WIDTH: f32 = 2.0;
/// Opacity of the edges of the mesh.
pub const WIRE_OPACITY: f32 = 0.42;

/// Colours for the values of a field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldRange {
    /// Value at the low end of the colour map …
    pub low: f32,
    /// … and at its high end.
    pub high: f32,
    /// Whether the colour map is the one with zero in its middle.
    pub signed: bool,
}
