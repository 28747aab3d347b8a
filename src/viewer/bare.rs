//! The text of shaders as it is shipped: without comments and indentation, which nobody reads in a
//! browser.

/// A shader of `gpu` by its name, made bare when the crate is compiled.
#[macro_export]
#[doc(hidden)]
macro_rules! bare_shader {
    ($name:literal) => {{
        const TEXT: &[u8] = include_bytes!(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/src/viewer/gpu/",
            $name,
            ".wgsl"
        ));
        const SIZE: usize = $crate::viewer::bare::bare::<0>(TEXT).1;
        const BARE: [u8; SIZE] = $crate::viewer::bare::bare(TEXT).0;
        str::from_utf8(&BARE).expect("comments alone may leave ASCII")
    }};
}

/// The first `N` bytes of a text without comments, empty lines and spaces at the start of a line,
/// and how many it has.
#[must_use]
pub const fn bare<const N: usize>(text: &[u8]) -> ([u8; N], usize) {
    let mut kept = [0; N];
    let mut count = 0;
    let mut at = 0;
    let mut is_start = true;
    while at < text.len() {
        let byte = text[at];
        let is_comment = byte == b'/' && text[at + 1] == b'/';
        while is_comment && text[at] != b'\n' {
            at += 1;
        }
        if is_comment {
            continue;
        }
        at += 1;
        if is_start && matches!(byte, b' ' | b'\n') {
            continue;
        }
        is_start = byte == b'\n';
        if count < N {
            kept[count] = byte;
        }
        count += 1;
    }
    (kept, count)
}

#[cfg(test)]
mod tests {
    use super::bare;

    #[test]
    fn comments_indentation_and_empty_lines_go() {
        let text = b"// What.\n\nfn f() {\n    return a / b; // why\n\n}\n";
        let (kept, count) = bare::<64>(text);
        assert_eq!(&kept[..count], b"fn f() {\nreturn a / b; \n}\n");
    }
}
