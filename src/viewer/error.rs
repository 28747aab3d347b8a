//! What can be wrong with a graphics device or with arrays handed to the viewer.

use crate::message::messages;

/// What this build draws with.
#[cfg(all(
    any(feature = "viewer", feature = "viewer-webgl"),
    target_arch = "wasm32"
))]
pub(super) const API: &str = if cfg!(feature = "viewer-webgl") {
    "WebGL2"
} else {
    "WebGPU"
};

messages! {
    /// A refusal of the viewer.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub enum ViewerError as "viewer" {
        /// `navigator.gpu` does not exist.
        NoWebGpu,
        /// WebGPU or WebGL2 exists but offers no graphics adapter.
        NoAdapter {
            /// Which of the two.
            api: &'static str,
        },
        /// The adapter gives no device.
        NoDevice {
            /// What the browser says of it.
            reason: String,
        },
        /// The canvas cannot be drawn on.
        NoCanvas {
            /// WebGPU or WebGL2.
            api: &'static str,
            /// What the browser says of it.
            reason: String,
        },
        /// The device went away.
        GpuLost {
            /// What the browser says of it.
            reason: String,
        },
        /// An array does not fit the mesh.
        WrongLength {
            /// Name of the array.
            array: &'static str,
            /// Entries wanted.
            expected: usize,
            /// Entries given.
            found: usize,
        },
        /// The time of a step is not after that of the step before.
        WrongTime,
        /// An index beyond the last vertex or triangle.
        OutOfRange {
            /// Name of the array.
            array: &'static str,
            /// The index.
            index: u32,
            /// Number of elements there are.
            count: usize,
        },
        /// More vertices than the device's largest texture holds.
        TooLarge {
            /// Vertices of the mesh, seam copies included.
            vertices: usize,
            /// Most that can be drawn.
            limit: usize,
        },
    }
}
