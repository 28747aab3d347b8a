//! Takes the linker's output apart into what is loaded first and what is deferred, see
//! `src/deferred.rs`: `splitter INPUT.wasm FIRST.wasm DEFERRED.wasm`.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use wasm_split_cli_support::{Options, transform};

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [input, first, deferred] = arguments.as_slice() else {
        bail!("usage: splitter INPUT.wasm FIRST.wasm DEFERRED.wasm");
    };
    let bytes = fs::read(input).with_context(|| format!("reading {input}"))?;
    let folder = Path::new(first).with_extension("parts");
    let mut options = Options::new(&bytes);
    options.output_dir = &folder;
    options.main_out_path = Path::new(first);
    // As seen from where the wasm files end up; what is written of that name here, which fetches
    // without waiting, is of no use.
    options.link_name = "../../deferred.js";
    let parts = transform(options).map_err(|error| anyhow!("splitting {input}: {error:?}"))?;
    let [part] = parts.split_modules.as_slice() else {
        bail!(
            "{} deferred parts instead of one",
            parts.split_modules.len()
        );
    };
    fs::copy(part, deferred).with_context(|| format!("writing {deferred}"))?;
    Ok(())
}
