//! Bytes as characters that an address holds unescaped: base64 of RFC 4648, section 5, without
//! padding.

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// Characters that so many bytes take.
pub(super) const fn length(bytes: usize) -> usize {
    (4 * bytes).div_ceil(3)
}

pub(super) fn encode(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(length(bytes.len()));
    for chunk in bytes.chunks(3) {
        let byte = |n: usize| u32::from(chunk.get(n).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for n in 0..=chunk.len() {
            text.push(DIGITS[(bits >> (18 - 6 * n)) as usize & 63] as char);
        }
    }
    text
}

/// `None` where a character is none of these, or there is one too few. `+` and `/` are read
/// too, and padding.
pub(super) fn decode(text: &str) -> Option<Vec<u8>> {
    let text = text.trim_end_matches('=');
    if text.len() % 4 == 1 {
        return None;
    }
    let digit = |byte: u8| match byte {
        b'+' => Some(62),
        b'/' => Some(63),
        byte => DIGITS.iter().position(|&known| known == byte),
    };
    let mut bytes = Vec::with_capacity(3 * text.len() / 4);
    for chunk in text.as_bytes().chunks(4) {
        let mut bits = 0;
        for (n, &byte) in chunk.iter().enumerate() {
            bits |= (digit(byte)? as u32) << (18 - 6 * n);
        }
        bytes.extend_from_slice(&bits.to_be_bytes()[1..chunk.len()]);
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_come_back_from_their_text() {
        // Examples of RFC 4648, section 10, without padding.
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg"),
            ("fo", "Zm8"),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg"),
        ] {
            assert_eq!(encode(bytes.as_bytes()), text);
            assert_eq!(decode(text).as_deref(), Some(bytes.as_bytes()));
            assert_eq!(length(bytes.len()), text.len());
        }
        let all: Vec<u8> = (0..=255).collect();
        assert_eq!(decode(&encode(&all)), Some(all));
        assert_eq!(decode("_-8="), decode("/+8"));
        for text in ["A", "A*", "AAAAA", "é"] {
            assert_eq!(decode(text), None, "{text}");
        }
    }
}
