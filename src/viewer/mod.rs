//! The viewer: one surface on one canvas, drawn with WebGPU or WebGL2.
//!
//! It knows no flow: positions, triangles, edges and a value a vertex come in, a picture
//! goes out. What is mathematics or bookkeeping is plain Rust, compiled and tested
//! everywhere; what touches the GPU exists only in the browser.
//!
//! | part | holds |
//! | --- | --- |
//! | [`camera`] | turntable, fit, zoom to the cursor, clip planes |
//! | [`drawing`] | arrays of the surface as drawn; [`seams`], [`normals`] and [`edges`] serve it |
//! | [`motion`] | the surface between two steps of a flow |
//! | [`segments`] | lines of space drawn over it |
//! | [`pick`], [`brush`] | what lies under a pixel; sets of vertices that are painted |
//! | [`colour`] | colour maps, palettes of the themes |
//! | [`style`], [`quality`] | what the page asks for, and what the device has time for |
//! | [`frame`] | uniform blocks, mirrored in WGSL |
//! | [`bare`] | the text of shaders as it is shipped |
//! | `gpu` | device, passes and shaders; redraws only when something changed |

pub mod bare;
pub mod brush;
pub mod camera;
pub mod colour;
pub mod drawing;
pub mod edges;
pub mod error;
pub mod frame;
#[cfg(all(
    any(feature = "viewer", feature = "viewer-webgl"),
    target_arch = "wasm32"
))]
pub mod gpu;
pub mod motion;
pub mod normals;
pub mod pick;
pub mod quality;
pub mod seams;
pub mod segments;
pub mod style;
