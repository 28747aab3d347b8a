//! The seam to JavaScript: `#[wasm_bindgen]` around the application and the viewer.
//!
//! Conversions only. Every refusal is thrown as a `Fault`.

#[cfg(all(
    any(feature = "viewer", feature = "viewer-webgl"),
    target_arch = "wasm32"
))]
mod fault;
#[cfg(all(feature = "solver", target_arch = "wasm32"))]
pub mod library;
#[cfg(all(feature = "solver", target_arch = "wasm32"))]
pub mod option;
#[cfg(target_arch = "wasm32")]
mod panic;
#[cfg(all(feature = "solver", target_arch = "wasm32"))]
pub mod session;
#[cfg(all(feature = "solver", test))]
mod types;
#[cfg(all(
    any(feature = "viewer", feature = "viewer-webgl"),
    target_arch = "wasm32"
))]
pub mod viewer;
