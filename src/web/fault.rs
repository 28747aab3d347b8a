//! The only shape of error that crosses to JavaScript: `Fault`.

use js_sys::{Object, Reflect};
use wasm_bindgen::JsValue;

/// A `Fault` with empty `detail`.
pub(super) fn fault(kind: &str, message: &str, hint: &str) -> JsValue {
    object(&[
        ("kind", kind.into()),
        ("message", message.into()),
        ("hint", hint.into()),
        ("detail", Object::new().into()),
    ])
}

/// A plain object with these properties.
pub(super) fn object(properties: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (key, value) in properties {
        // Fails only on frozen objects and proxies; this one was made just now.
        let _ = Reflect::set(&object, &(*key).into(), value);
    }
    object.into()
}
