//! JSON that is looked into where it stands: no tree is built, so it takes no memory.

use std::borrow::Cow;

use super::text::parse_float;

/// A value: the text from its first character on, of a document that was checked.
#[derive(Clone, Copy, Debug)]
pub(super) struct Json<'a>(&'a [u8]);

impl<'a> Json<'a> {
    /// The one value of a document; the byte at which it is none otherwise.
    pub(super) fn new(text: &'a [u8]) -> Result<Self, usize> {
        let start = text.trim_ascii_start();
        let lead = text.len() - start.len();
        let end = check(start).map_err(|at| lead + at)?;
        if start[end..].trim_ascii().is_empty() {
            Ok(Self(start))
        } else {
            Err(lead + end)
        }
    }

    /// The items of an array; none of anything else.
    pub(super) fn items(self) -> impl Iterator<Item = Self> {
        let mut rest = self.0.strip_prefix(b"[");
        std::iter::from_fn(move || {
            let item = after_blanks(rest?);
            if item.first() == Some(&b']') {
                return None;
            }
            let after = after_blanks(&item[length(item)..]);
            rest = Some(after.strip_prefix(b",").unwrap_or(after));
            Some(Self(item))
        })
    }

    /// A member of an object.
    pub(super) fn get(self, name: &str) -> Option<Self> {
        self.members()
            .find_map(|(key, value)| (key == name.as_bytes()).then_some(value))
    }

    /// Names, as they are written, with their values.
    pub(super) fn members(self) -> impl Iterator<Item = (&'a [u8], Self)> {
        let mut rest = self.0.strip_prefix(b"{");
        std::iter::from_fn(move || {
            let key = after_blanks(rest?);
            if key.first() == Some(&b'}') {
                return None;
            }
            let name = &key[1..length(key) - 1];
            let colon = after_blanks(&key[length(key)..]);
            let value = after_blanks(&colon[1..]);
            let after = after_blanks(&value[length(value)..]);
            rest = Some(after.strip_prefix(b",").unwrap_or(after));
            Some((name, Self(value)))
        })
    }

    pub(super) fn number(self) -> Option<f64> {
        match self.0.first()? {
            b'-' | b'0'..=b'9' => parse_float(&self.0[..length(self.0)]),
            _ => None,
        }
    }

    /// A whole number that is not negative, such as an index.
    pub(super) fn index(self) -> Option<usize> {
        let number = self.number()?;
        (number >= 0.0 && number.fract() == 0.0).then_some(number as usize)
    }

    pub(super) fn is_true(self) -> bool {
        self.0.starts_with(b"true")
    }

    /// A string's characters.
    pub(super) fn string(self) -> Option<Cow<'a, [u8]>> {
        let inside = &self.0.strip_prefix(b"\"")?[..length(self.0) - 2];
        if !inside.contains(&b'\\') {
            return Some(Cow::Borrowed(inside));
        }
        let mut plain = Vec::with_capacity(inside.len());
        let mut rest = inside;
        while let Some((&byte, after)) = rest.split_first() {
            rest = after;
            if byte != b'\\' {
                plain.push(byte);
                continue;
            }
            let (&escape, after) = rest.split_first()?;
            rest = after;
            match escape {
                b'b' => plain.push(8),
                b'f' => plain.push(12),
                b'n' => plain.push(b'\n'),
                b'r' => plain.push(b'\r'),
                b't' => plain.push(b'\t'),
                b'u' => {
                    let (digits, after) = rest.split_at_checked(4)?;
                    rest = after;
                    let code = u32::from_str_radix(std::str::from_utf8(digits).ok()?, 16);
                    // Half of a pair is not asked for: names of files are only compared.
                    let c = char::from_u32(code.ok()?).unwrap_or(char::REPLACEMENT_CHARACTER);
                    plain.extend(c.encode_utf8(&mut [0; 4]).bytes());
                }
                other => plain.push(other),
            }
        }
        Some(Cow::Owned(plain))
    }

    /// The value as it stands there.
    pub(super) fn written(self) -> &'a [u8] {
        &self.0[..length(self.0)]
    }

    /// How many bytes of the document come from here on.
    pub(super) fn left(self) -> usize {
        self.0.len()
    }
}

fn after_blanks(text: &[u8]) -> &[u8] {
    text.trim_ascii_start()
}

/// How long the string is that the text begins with; `Err` with where it breaks off.
fn string_length(text: &[u8]) -> Result<usize, usize> {
    let mut at = 1;
    loop {
        match text.get(at) {
            Some(b'"') => return Ok(at + 1),
            Some(b'\\') => at += 2,
            Some(_) => at += 1,
            None => return Err(text.len()),
        }
    }
}

/// How long the number or word is that the text begins with.
fn word_length(text: &[u8]) -> usize {
    let is_end = |b: &u8| matches!(b, b',' | b']' | b'}' | b':') || b.is_ascii_whitespace();
    text.iter().position(is_end).unwrap_or(text.len())
}

/// How long the value is that a checked text begins with.
fn length(text: &[u8]) -> usize {
    let mut depth = 0_usize;
    let mut at = 0;
    while let Some(byte) = text.get(at) {
        at += match byte {
            b'"' => string_length(&text[at..]).unwrap_or(text.len()),
            b'[' | b'{' => {
                depth += 1;
                1
            }
            b']' | b'}' => {
                depth = depth.saturating_sub(1);
                1
            }
            byte if byte.is_ascii_whitespace() || matches!(byte, b',' | b':') => {
                at += 1;
                continue;
            }
            _ => word_length(&text[at..]),
        };
        if depth == 0 {
            break;
        }
    }
    at.min(text.len())
}

/// Makes sure that a text begins with a value, and says where that ends; `Err` with where it is
/// none. The kinds of the brackets that are open take a byte each.
fn check(text: &[u8]) -> Result<usize, usize> {
    let mut open: Vec<u8> = Vec::new();
    let mut at = 0;
    loop {
        at = blanks(text, at);
        let here = &text[at..];
        match *here.first().ok_or(at)? {
            bracket @ (b'[' | b'{') => {
                let close = if bracket == b'[' { b']' } else { b'}' };
                at = blanks(text, at + 1);
                if text.get(at) != Some(&close) {
                    open.push(close);
                    if close == b'}' {
                        at = key(text, at)?;
                    }
                    continue;
                }
                at += 1;
            }
            b'"' => at += string_length(here).map_err(|end| at + end)?,
            _ => {
                let word = &here[..word_length(here)];
                let is_value = match word {
                    b"true" | b"false" | b"null" => true,
                    [b'-' | b'0'..=b'9', ..] => parse_float(word).is_some(),
                    _ => false,
                };
                if !is_value {
                    return Err(at);
                }
                at += word.len();
            }
        }
        // What is closed here.
        loop {
            let Some(&close) = open.last() else {
                return Ok(at);
            };
            at = blanks(text, at);
            match text.get(at) {
                Some(b',') => {
                    at = blanks(text, at + 1);
                    if close == b'}' {
                        at = key(text, at)?;
                    }
                    break;
                }
                Some(byte) if *byte == close => {
                    open.pop();
                    at += 1;
                }
                _ => return Err(at),
            }
        }
    }
}

/// The place after blanks.
fn blanks(text: &[u8], at: usize) -> usize {
    text.len() - after_blanks(&text[at..]).len()
}

/// The place after a name and a colon.
fn key(text: &[u8], at: usize) -> Result<usize, usize> {
    if text.get(at) != Some(&b'"') {
        return Err(at);
    }
    let end = at + string_length(&text[at..]).map_err(|end| at + end)?;
    let colon = blanks(text, end);
    if text.get(colon) == Some(&b':') {
        Ok(colon + 1)
    } else {
        Err(colon)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_found_where_they_stand() {
        let text = br#" { "a" : [1, -2.5e1 ,"x,]}",[ ],{}], "b\"":{"c":true} ,"d":"e\/\u002Bf"} "#;
        let json = Json::new(text).unwrap();
        let items: Vec<_> = json.get("a").unwrap().items().collect();
        assert_eq!(items.len(), 5);
        assert_eq!(items[0].index(), Some(1));
        assert_eq!((items[1].number(), items[1].index()), (Some(-25.0), None));
        assert_eq!(items[2].string().unwrap().as_ref(), b"x,]}");
        assert_eq!((items[2].number(), items[0].string()), (None, None));
        assert_eq!(items[3].items().count(), 0);
        assert_eq!(items[4].members().count(), 0);
        assert_eq!(json.members().count(), 3);
        assert!(json.get(r#"b\""#).unwrap().get("c").unwrap().is_true());
        assert_eq!(json.get("d").unwrap().string().unwrap().as_ref(), b"e/+f");
        assert!(json.get("e").is_none());
    }

    #[test]
    fn what_is_none_is_refused_where_it_breaks() {
        for (text, at) in [
            ("", 0),
            ("{", 1),
            ("[1,]", 3),
            ("[1 2]", 3),
            ("{\"a\"}", 4),
            ("{\"a\":1,}", 7),
            ("{a:1}", 1),
            ("[\"a", 3),
            ("[1}", 2),
            ("1 2", 1),
            (" nope", 1),
            ("[\"a\\\"]", 6),
        ] {
            assert_eq!(Json::new(text.as_bytes()).map(|_| ()), Err(at), "{text}");
        }
        let deep = "[".repeat(100_000) + &"]".repeat(100_000);
        assert!(Json::new(deep.as_bytes()).is_ok());
    }
}
