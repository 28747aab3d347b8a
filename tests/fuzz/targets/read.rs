//! Any bytes under any name: an answer, and what is accepted can be written and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use umbilic::io::{self, Format};

fuzz_target!(|bytes: &[u8]| {
    for name in ["a.obj", "a.off", "a.ply", "a.stl"] {
        match io::read(bytes, name) {
            Ok(read) => {
                let written = io::write(&read.soup, Format::Ply, name).expect("writable");
                let again = io::read(&written, "").expect("readable");
                assert_eq!(again.soup, read.soup);
            }
            Err(error) => {
                let _ = (error.to_string(), error.hint(), error.detail());
            }
        }
    }
});
