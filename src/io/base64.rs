//! Bytes written as text: base64 of RFC 4648, section 4, as XML and JSON files hold it.

/// The first `most` bytes of a text, or all. Every group of four characters stands for itself, so
/// that several encoded pieces may follow each other, each with its padding; blanks are skipped.
///
/// `None` where a character is none of the alphabet, or a group is cut short.
pub(super) fn decode(text: &[u8], most: usize) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(most.min(text.len() / 4 * 3));
    let mut characters = text.iter().filter(|byte| !byte.is_ascii_whitespace());
    while bytes.len() < most {
        let Some(first) = characters.next() else {
            break;
        };
        let mut bits = digit(*first)?;
        let mut length = 0;
        for _ in 0..3 {
            let next = *characters.next()?;
            bits <<= 6;
            if next != b'=' {
                bits |= digit(next)?;
                length += 1;
            }
        }
        bytes.extend_from_slice(&bits.to_be_bytes()[1..=length]);
    }
    bytes.truncate(most);
    Some(bytes)
}

fn digit(byte: u8) -> Option<u32> {
    let value = match byte {
        b'A'..=b'Z' => byte - b'A',
        b'a'..=b'z' => byte - b'a' + 26,
        b'0'..=b'9' => byte - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        _ => return None,
    };
    Some(value.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn examples_of_the_standard_and_pieces_in_a_row() {
        for (text, bytes) in [
            ("", ""),
            ("Zg==", "f"),
            ("Zm8=", "fo"),
            ("Zm9v", "foo"),
            ("Zm9v\n YmE=", "fooba"),
            ("Zg==Zm8=", "ffo"),
        ] {
            assert_eq!(decode(text.as_bytes(), 99).unwrap(), bytes.as_bytes());
        }
        assert_eq!(decode(b"Zm9v", 2).unwrap(), b"fo");
        for text in ["Zg", "Z", "Zm9*", "Zm9vY"] {
            assert_eq!(decode(text.as_bytes(), 99), None, "{text}");
        }
    }
}
