//! Writes the JavaScript and TypeScript around a wasm file:
//! `bindgen INPUT.wasm OUT_DIR OUT_NAME [--strip-names]`.
//!
//! Kept in this package so that the tool's version is pinned, in one place, to
//! the version of the `wasm-bindgen` crate: any difference is a build error.

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<()> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let strip_names = arguments.last().is_some_and(|last| last == "--strip-names");
    if strip_names {
        arguments.pop();
    }
    let [input, out_dir, out_name] = arguments.as_slice() else {
        bail!("usage: bindgen INPUT.wasm OUT_DIR OUT_NAME [--strip-names]");
    };

    let input = PathBuf::from(input);
    let mut bindgen = Bindgen::new();
    bindgen
        .input_path(&input)
        .out_name(out_name)
        .web(true)?
        .typescript(true)
        // `init()` then finds the wasm file beside the script, and so does vite.
        .omit_default_module_path(false)
        // The solver's second file is linked to the first one's table of functions.
        .keep_lld_exports(true)
        // Names make panics readable; they are also a third of the file.
        .remove_name_section(strip_names)
        .remove_producers_section(strip_names);
    bindgen
        .generate(out_dir)
        .with_context(|| format!("bindgen of {} into {out_dir}", input.display()))
}
