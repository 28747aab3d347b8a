//! Asking a WebGL device what it has done. A WebGPU device calls back by itself.

use js_sys::Promise;
use wasm_bindgen_futures::JsFuture;

/// Polls until something is the case, or the device cannot be asked any more.
pub(super) async fn poll_until(device: &wgpu::Device, is_done: impl Fn() -> bool) {
    while device.poll(wgpu::PollType::Poll).is_ok() && !is_done() {
        next_turn().await;
    }
}

/// Fences of WebGL pass only between turns of the event loop.
async fn next_turn() {
    let turn = Promise::new(&mut |resolve, _| {
        if let Some(window) = web_sys::window() {
            // Refused only with too many arguments.
            let _ = window.set_timeout_with_callback(&resolve);
        }
    });
    // Never rejects.
    let _ = JsFuture::from(turn).await;
}
