//! The text of shaders as it is shipped: without comments and indentation, which nobody reads in a
//! browser.

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
