//! What can be wrong with a graphics device or with arrays handed to the viewer.

use thiserror::Error;

/// What this build draws with.
const API: &str = if cfg!(feature = "viewer-webgl") {
    "WebGL2"
} else {
    "WebGPU"
};

/// A refusal of the viewer.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ViewerError {
    /// `navigator.gpu` does not exist.
    #[error("this browser has no WebGPU, or the page is not served securely")]
    NoWebGpu,
    /// WebGPU or WebGL2 exists but offers no graphics adapter.
    #[error("{API} offers no graphics adapter")]
    NoAdapter,
    /// The adapter gives no device.
    #[error("the graphics adapter gives no device: {0}")]
    NoDevice(String),
    /// The canvas cannot be drawn on.
    #[error("the canvas gives no {API} context: {0}")]
    NoCanvas(String),
    /// The device went away while a picture was being read.
    #[error("the graphics device was lost: {0}")]
    GpuLost(String),
    /// An array does not fit the mesh.
    #[error("{array} has {found} entries; the mesh wants {expected}")]
    WrongLength {
        /// Name of the array.
        array: &'static str,
        /// Entries wanted.
        expected: usize,
        /// Entries given.
        found: usize,
    },
    /// An index beyond the last vertex or triangle.
    #[error("{array} names element {index} of {count}")]
    OutOfRange {
        /// Name of the array.
        array: &'static str,
        /// The index.
        index: u32,
        /// Number of elements there are.
        count: usize,
    },
    /// More vertices than the device's largest texture holds.
    #[error("{vertices} vertices are more than the {limit} this graphics device can draw")]
    TooLarge {
        /// Vertices of the mesh, seam copies included.
        vertices: usize,
        /// Most that can be drawn.
        limit: usize,
    },
}

impl ViewerError {
    /// The variant's name; what callers switch on.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::NoWebGpu => "NoWebGpu",
            Self::NoAdapter => "NoAdapter",
            Self::NoDevice(_) => "NoDevice",
            Self::NoCanvas(_) => "NoCanvas",
            Self::GpuLost(_) => "GpuLost",
            Self::WrongLength { .. } => "WrongLength",
            Self::OutOfRange { .. } => "OutOfRange",
            Self::TooLarge { .. } => "TooLarge",
        }
    }

    /// What the user can do about it.
    pub fn hint(&self) -> String {
        match self {
            Self::NoWebGpu => {
                "Use a current Chrome, Edge, Firefox or Safari, over https or on localhost."
            }
            Self::NoAdapter | Self::NoDevice(_) => {
                "Switch on hardware acceleration in the browser's settings, or update the \
                 graphics driver."
            }
            Self::NoCanvas(_) | Self::GpuLost(_) => "Reload the page.",
            Self::WrongLength { .. } | Self::OutOfRange { .. } => {
                "This is a fault of the program; please report it."
            }
            Self::TooLarge { .. } => "Simplify the mesh first.",
        }
        .to_owned()
    }
}
