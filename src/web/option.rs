//! Reading and checking options, without a session.

use super::session::{from_js, load_deferred, to_js};
use crate::app;
use crate::flow::option::{self, Values};
use wasm_bindgen::prelude::*;

/// The options of a command of the command line by name, as text, with their types.
///
/// # Errors
/// The first option that there is not, that has a value it cannot have, or that would change
/// nothing.
#[wasm_bindgen(js_name = readFlags)]
pub fn read_flags(command: &str, words: JsValue) -> Result<JsValue, JsValue> {
    load_deferred()?;
    read(command, words)
}

deferred! {
    fn read(command: &str, words: JsValue) -> Result<JsValue, JsValue> {
        let words: Values = from_js(words)?;
        Ok(to_js(&app::read_flags(command, &words)?))
    }
}

/// Which of some names was probably meant, if any.
#[wasm_bindgen]
#[must_use]
pub fn nearest(typed: &str, names: Vec<String>) -> Option<String> {
    option::nearest(typed, names.iter().map(String::as_str)).map(Into::into)
}

/// The refusal of a flag that a command with these flags does not have.
#[wasm_bindgen(js_name = unknownFlag)]
#[must_use]
pub fn unknown_flag(typed: &str, flags: Vec<String>) -> JsValue {
    refused(typed, &flags)
}

deferred! {
    fn refused(typed: &str, flags: &[String]) -> JsValue {
        to_js(&app::unknown_flag(typed, flags))
    }
}
