//! The GPU half of the viewer, in the browser only.
//!
//! [`Viewer`] puts the parts together: `device` (device, canvas, loss, resize), `bindings`
//! (what every shader sees), `material` (what surface and background see), passes with one
//! shader each beside them, `effects` (those passes that can be done without), `readback` for
//! golden pictures, `polling` for WebGL. `frame.wgsl` is put in front of every shader.

mod background_pass;
mod bindings;
mod device;
mod effects;
mod filter;
mod line_pass;
mod material;
mod occlusion_pass;
mod pipeline;
#[cfg(feature = "viewer-webgl")]
mod polling;
mod readback;
mod scene;
mod shadow_pass;
mod signal;
mod surface_pass;
mod texture;

pub use readback::Picture;
pub use scene::Viewer;
pub use signal::Signal;
