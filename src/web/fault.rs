//! The plain objects that cross to JavaScript.

use js_sys::{Object, Reflect};
use wasm_bindgen::JsValue;

/// A plain object with these properties.
pub(super) fn object(properties: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (key, value) in properties {
        // Fails only on frozen objects and proxies; this one was made just now.
        let _ = Reflect::set(&object, &(*key).into(), value);
    }
    object.into()
}

/// A `Fault` with empty `detail`, made without the solver's way of writing objects, which would
/// be half as large as the viewer's own code.
pub(super) fn fault(said: &impl crate::message::Say) -> JsValue {
    use crate::message::{Message, Value};

    fn value_of(value: &Value) -> JsValue {
        match value {
            Value::None => JsValue::NULL,
            Value::Number(number) => (*number).into(),
            Value::Text(text) => text.as_str().into(),
            Value::Message(said) => message(said),
            Value::List(values) => values
                .iter()
                .map(value_of)
                .collect::<js_sys::Array>()
                .into(),
        }
    }
    fn message(said: &Message) -> JsValue {
        let values = said.values.iter();
        let values: Vec<_> = values.map(|(name, said)| (*name, value_of(said))).collect();
        object(&[("id", (&*said.id).into()), ("values", object(&values))])
    }
    object(&[
        ("kind", said.kind().into()),
        ("message", message(&said.message())),
        ("hint", message(&said.hint())),
        ("detail", Object::new().into()),
    ])
}
