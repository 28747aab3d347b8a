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

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Bytes as text, padded.
pub(super) fn encode(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let byte = |k: usize| u32::from(group.get(k).copied().unwrap_or_default());
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for k in 0..4 {
            let digit = DIGITS[(bits >> (18 - 6 * k) & 63) as usize];
            text.push(if k > group.len() {
                '='
            } else {
                char::from(digit)
            });
        }
    }
    text
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
    fn what_is_written_reads_back() {
        for (text, bytes) in [("", ""), ("Zg==", "f"), ("Zm8=", "fo"), ("Zm9v", "foo")] {
            assert_eq!(encode(bytes.as_bytes()), text);
        }
        let all: Vec<u8> = (0..=255).collect();
        assert_eq!(decode(encode(&all).as_bytes(), 999).unwrap(), all);
    }

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
