//! A sound file of every format, damaged: the first byte picks the format, the rest are
//! places and bytes to put there.
#![no_main]

use libfuzzer_sys::fuzz_target;
use umbilic::io::{self, Format};

const SQUARE: &[u8] = b"v 0 0 0\nv 1 0 0\nv 1 .5 0.25\nv 0 1e-3 -0\nf 1 2 3 4\nf 3 2 1\n";

fuzz_target!(|edits: &[u8]| {
    let Some((pick, edits)) = edits.split_first() else {
        return;
    };
    let soup = io::read(SQUARE, "").expect("sound").soup;
    let format = Format::ALL[usize::from(*pick) % Format::ALL.len()];
    let mut bytes = io::write(&soup, format, "").expect("writable");
    for edit in edits.chunks_exact(3) {
        let at = usize::from(u16::from_le_bytes([edit[0], edit[1]])) % bytes.len();
        bytes[at] = edit[2];
    }
    if let Ok(read) = io::read(&bytes, "") {
        io::write(&read.soup, Format::Obj, "").expect("writable");
    }
});
