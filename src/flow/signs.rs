//! What is read as a sign that a surface or its mesh goes wrong: the thresholds of warnings, of
//! endings and of the diagnosis of a run, so that all three say the same. Those of what a whole mesh
//! is worth stand with its readings, in [`Soundness`](crate::remesh::adaptive::Soundness).

/// Growth of the area that is a sign of a bubble.
pub const BUBBLE: f64 = 4.0;
/// Bend, see [`Sharpest`](crate::geometry::bend::Sharpest), from which a mesh no longer resolves
/// its surface, and from which, with no step accepted, the surface has become singular.
pub const UNDER_RESOLVED: f64 = 3.0;
/// The same of a neck: of a ring of four edges where the other is one of two.
pub const NARROW: f64 = 1.5;
/// A bend is new if it is so many times the sharpest at the start: a surface that is drawn with
/// it has no more to say about it.
pub const SHARPENED: f64 = 1.5;
/// A smallest angle below this, in degrees, that was much larger at the start is a mesh that
/// degenerates.
pub const SLIVER: f64 = 8.0;
/// So much smaller than at the start is much.
pub const WORN: f64 = 0.5;
