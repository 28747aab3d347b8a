//! The GPU half of the viewer, in the browser only.
//!
//! [`Viewer`] puts the parts together: `device` (device, canvas, loss, resize), `bindings`
//! (what every shader sees), three passes with one shader each beside them, `readback` for
//! golden pictures, `polling` for WebGL. `frame.wgsl` is put in front of every shader.

mod background_pass;
mod bindings;
mod device;
mod line_pass;
mod pipeline;
#[cfg(feature = "viewer-webgl")]
mod polling;
mod readback;
mod scene;
mod signal;
mod surface_pass;

pub use readback::Picture;
pub use scene::{Style, Viewer};
pub use signal::Signal;
