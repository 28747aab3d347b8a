//! Lines, words and numbers of a text file, without copying it.

use std::borrow::Cow;

use glam::DVec3;

use super::assembly::NO_PART;
use super::{Expected, Format, Found, Oddity, Place, ReadError};
use crate::interrupt;

/// The text without its byte order mark, and whether it had to be brought from UTF-16.
///
/// Other bytes pass untouched: names and comments in any 8-bit encoding are never looked
/// at, so they need not be valid UTF-8.
pub(super) fn without_byte_order_mark(bytes: &[u8]) -> (Cow<'_, [u8]>, bool) {
    let unit: fn([u8; 2]) -> u16 = match bytes {
        [0xEF, 0xBB, 0xBF, rest @ ..] => return (Cow::Borrowed(rest), false),
        [0xFF, 0xFE, ..] => u16::from_le_bytes,
        [0xFE, 0xFF, ..] => u16::from_be_bytes,
        _ => return (Cow::Borrowed(bytes), false),
    };
    let units = bytes[2..]
        .chunks_exact(2)
        .map(|pair| unit([pair[0], pair[1]]));
    let text: String = char::decode_utf16(units)
        .map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER))
        .collect();
    (Cow::Owned(text.into_bytes()), true)
}

/// A text without the NUL bytes that a whole number of blocks is filled up with.
pub(super) fn without_padding(bytes: &[u8]) -> &[u8] {
    let end = bytes.iter().rposition(|&b| b != 0);
    &bytes[..end.map_or(0, |last| last + 1)]
}

/// Offset of the first NUL byte before the padding, which no text has.
pub(super) fn nul(bytes: &[u8]) -> Option<usize> {
    without_padding(bytes).iter().position(|&b| b == 0)
}

/// The first word that is not part of a `#` comment; empty when there is none.
pub(super) fn first_word(bytes: &[u8]) -> &[u8] {
    Lines::new(Format::Obj, bytes)
        .find_map(|mut words| words.next())
        .unwrap_or_default()
}

/// The lines of a text, with their numbers.
pub(super) struct Lines<'a> {
    format: Format,
    rest: &'a [u8],
    end: u8,
    number: usize,
    continued: bool,
}

impl<'a> Lines<'a> {
    /// Lines end with LF or CR LF; with CR in a text that has no LF at all.
    pub(super) fn new(format: Format, bytes: &'a [u8]) -> Self {
        let end = if bytes.contains(&b'\n') { b'\n' } else { b'\r' };
        Self {
            format,
            rest: bytes,
            end,
            number: 0,
            continued: false,
        }
    }

    /// The same, refusing bytes that cannot be text.
    pub(super) fn of_text(format: Format, bytes: &'a [u8]) -> Result<Self, ReadError> {
        match nul(bytes) {
            Some(offset) => Err(ReadError::NotText { format, offset }),
            None => Ok(Self::new(format, without_padding(bytes))),
        }
    }

    /// A `\` before a line's end joins it to the next, except in a comment.
    pub(super) fn with_continuation(self) -> Self {
        Self {
            continued: true,
            ..self
        }
    }

    /// Lines that end with `end`, numbered on from `number`.
    pub(super) fn starting_at(self, end: u8, number: usize) -> Self {
        Self {
            end,
            number,
            ..self
        }
    }

    /// What is not read yet.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }

    /// Number of the last line read, from 1.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// Lines that are left with something in them.
    pub(super) fn left(&mut self) -> Option<Oddity> {
        let mut count = 0;
        while self.find(|words| words.clone().next().is_some()).is_some() {
            count += 1;
        }
        (count > 0).then_some(Oddity::LinesLeft { count })
    }

    /// The next line that holds a word.
    ///
    /// # Errors
    /// [`ReadError::Syntax`] with `expected` at the end of the text.
    pub(super) fn next_filled(&mut self, expected: Expected) -> Result<Words<'a>, ReadError> {
        let format = self.format;
        match self.find(|words| words.clone().next().is_some()) {
            Some(words) => Ok(words),
            None => {
                let line = self.number.max(1);
                let (place, found) = (Place::Line { line }, Found::EndOfFile);
                Err(ReadError::syntax(format, place, found, expected))
            }
        }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Words<'a>;

    fn next(&mut self) -> Option<Words<'a>> {
        if self.rest.is_empty() {
            return None;
        }
        let text = self.rest;
        let number = self.number + 1;
        if number.is_multiple_of(1 << 16) {
            interrupt::pulse();
        }
        let comment = text[0] == b'#';
        let mut length = 0;
        loop {
            self.number += 1;
            match text[length..].iter().position(|&b| b == self.end) {
                None => {
                    length = text.len();
                    self.rest = &[];
                    break;
                }
                Some(end) => {
                    length += end;
                    self.rest = &text[length + 1..];
                    let goes_on = self.continued && !comment && {
                        // Blanks after it are seen by nobody.
                        text[..length].trim_ascii_end().ends_with(b"\\")
                    };
                    if !goes_on {
                        break;
                    }
                    length += 1;
                }
            }
        }
        Some(Words {
            format: self.format,
            line: number,
            rest: &text[..length],
            again: None,
        })
    }
}

/// The words of a line, up to a comment.
#[derive(Clone)]
pub(super) struct Words<'a> {
    format: Format,
    line: usize,
    rest: &'a [u8],
    again: Option<&'a [u8]>,
}

impl<'a> Words<'a> {
    /// The words before the first line.
    pub(super) fn none(format: Format) -> Self {
        Self {
            format,
            line: 0,
            rest: &[],
            again: None,
        }
    }

    /// Makes the end of the word just read, so much of it, the next one again.
    pub(super) fn give_back(&mut self, end: &'a [u8]) {
        self.again = Some(end);
    }

    /// Where the line begins.
    pub(super) fn place(&self) -> Place {
        Place::Line { line: self.line }
    }

    /// The error that `found` (none: the line's end) stands where `expected` should.
    pub(super) fn error(&self, found: Option<&[u8]>, expected: Expected) -> ReadError {
        let found = found.map_or(Found::EndOfLine, |word| Found::Word {
            word: shortened(word),
        });
        ReadError::syntax(self.format, self.place(), found, expected)
    }

    /// The next word, which must be there.
    pub(super) fn word(&mut self, expected: Expected) -> Result<&'a [u8], ReadError> {
        self.next().ok_or_else(|| self.error(None, expected))
    }

    /// The next word as a number.
    pub(super) fn float(&mut self, expected: Expected) -> Result<f64, ReadError> {
        let word = self.word(expected)?;
        parse_float(word).ok_or_else(|| self.error(Some(word), expected))
    }

    /// How many words are left, and the first of them as numbers; [`NO_PART`] what is none.
    pub(super) fn numbers<const N: usize>(&mut self) -> (usize, [f64; N]) {
        let (mut count, mut numbers) = (0, [NO_PART; N]);
        for word in self {
            if let Some(number) = numbers.get_mut(count) {
                *number = parse_float(word).unwrap_or(NO_PART);
            }
            count += 1;
        }
        (count, numbers)
    }

    /// The next word as an integer.
    pub(super) fn integer(&mut self, expected: Expected) -> Result<i64, ReadError> {
        let word = self.word(expected)?;
        parse_integer(word).ok_or_else(|| self.error(Some(word), expected))
    }

    /// The next word as a number of things.
    pub(super) fn how_many(&mut self, expected: Expected) -> Result<u64, ReadError> {
        let word = self.word(expected)?;
        let count = parse_integer(word).and_then(|count| u64::try_from(count).ok());
        count.ok_or_else(|| self.error(Some(word), expected))
    }

    /// The next three words as a position.
    pub(super) fn point(&mut self) -> Result<DVec3, ReadError> {
        Ok(DVec3::new(
            self.float(Expected::Coordinate { axis: "x" })?,
            self.float(Expected::Coordinate { axis: "y" })?,
            self.float(Expected::Coordinate { axis: "z" })?,
        ))
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        if let Some(word) = self.again.take() {
            return Some(word);
        }
        loop {
            let start = self.rest.iter().position(|b| !is_blank(*b))?;
            let text = &self.rest[start..];
            if text[0] == b'#' {
                self.rest = &[];
                return None;
            }
            let length = text.iter().position(|b| is_blank(*b)).unwrap_or(text.len());
            self.rest = &text[length..];
            // The mark of a line that goes on; it may touch the last word.
            let word = text[..length]
                .strip_suffix(b"\\")
                .unwrap_or(&text[..length]);
            if !word.is_empty() {
                return Some(word);
            }
        }
    }
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | b'\n' | 0x0B | 0x0C)
}

/// A decimal number, correctly rounded; not finite for `nan`, `inf`, overflow, and the
/// spellings of C libraries such as `-nan(ind)` and `1.#QNAN`. Fortran writes `1.0D+00`.
pub(super) fn parse_float(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    text.parse().ok().or_else(|| {
        let digits = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
        if digits.starts_with("nan(") || digits.starts_with("1.#") {
            return Some(f64::NAN);
        }
        let is_double = digits.starts_with(|c: char| c.is_ascii_digit() || c == '.');
        is_double.then(|| text.replacen(['d', 'D'], "e", 1).parse().ok())?
    })
}

/// A decimal integer; one too large for 64 bits becomes the largest of its sign, which
/// every range check refuses.
pub(super) fn parse_integer(word: &[u8]) -> Option<i64> {
    let (negative, digits) = match word {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    if digits.is_empty() {
        return None;
    }
    let mut value = 0_i64;
    for digit in digits {
        let digit = digit.wrapping_sub(b'0');
        if digit > 9 {
            return None;
        }
        value = value.saturating_mul(10).saturating_add(i64::from(digit));
    }
    Some(if negative { -value } else { value })
}

/// A word for a message: at most 40 characters.
pub(super) fn shortened(word: &[u8]) -> String {
    const LONGEST: usize = 40;
    // No character is longer than four bytes.
    let text = String::from_utf8_lossy(&word[..word.len().min(4 * LONGEST)]);
    let visible = |c: char| {
        if c.is_control() {
            char::REPLACEMENT_CHARACTER
        } else {
            c
        }
    };
    let mut shown: String = text.chars().take(LONGEST).map(visible).collect();
    if shown.len() < word.len() {
        shown.push('…');
    }
    shown
}

/// A comment's lines, each made safe to stand on one line of a text file.
pub(super) fn comment_lines(comment: &str) -> impl Iterator<Item = String> {
    comment.lines().map(|line| {
        line.chars()
            .map(|c| if c.is_control() { ' ' } else { c })
            .collect::<String>()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<(usize, Vec<String>)> {
        Lines::new(Format::Obj, text.as_bytes())
            .with_continuation()
            .map(|line| {
                let number = line.line;
                (
                    number,
                    line.map(|w| String::from_utf8_lossy(w).into_owned())
                        .collect(),
                )
            })
            .collect()
    }

    #[test]
    fn line_ends_of_three_kinds() {
        for text in ["a b\n\nc", "a b\r\n\r\nc\r\n", "a b\r\rc"] {
            let lines = words(text);
            let shown: Vec<_> = lines.iter().map(|(n, w)| (*n, w.join("+"))).collect();
            assert_eq!(
                shown,
                [(1, "a+b".into()), (2, String::new()), (3, "c".into())]
            );
        }
        // A stray CR in a text of LF lines is a blank.
        assert_eq!(words("a\rb\nc").len(), 2);
    }

    #[test]
    fn continuation_and_comments() {
        let lines = words("f 1 \\\n2\\\r\n 3\n# C:\\\nv 0 # x\n\\");
        let shown: Vec<_> = lines.iter().map(|(n, w)| (*n, w.join(" "))).collect();
        assert_eq!(
            shown,
            [
                (1, "f 1 2 3".into()),
                (4, String::new()),
                (5, "v 0".into()),
                (6, String::new())
            ]
        );
    }

    #[test]
    fn numbers() {
        assert_eq!(parse_float(b"+1.5e-3"), Some(1.5e-3));
        assert_eq!(parse_float(b"1e400"), Some(f64::INFINITY));
        assert_eq!(parse_float(b"-1.5D-3"), Some(-1.5e-3));
        assert_eq!(parse_float(b".5d+2"), Some(50.0));
        for word in ["nan", "-NaN", "nan(", "-nan(ind)", "1.#QNAN", "-1.#IND"] {
            assert!(
                parse_float(word.as_bytes()).is_some_and(f64::is_nan),
                "{word}"
            );
        }
        for word in [
            "", "1,5", "0x10", "1.5f", "--1", "nano", "\u{661}", "d", "1d", "1d2d3",
        ] {
            assert_eq!(parse_float(word.as_bytes()), None, "{word}");
        }
        assert_eq!(parse_integer(b"-12"), Some(-12));
        assert_eq!(parse_integer(b"99999999999999999999"), Some(i64::MAX));
        assert_eq!(parse_integer(b"-99999999999999999999"), Some(-i64::MAX));
        for word in ["", "-", "+-1", "1.0", "1/2"] {
            assert_eq!(parse_integer(word.as_bytes()), None, "{word}");
        }
    }

    #[test]
    fn utf_16_of_both_orders() {
        let text = "v Ω 𝒳";
        let units: Vec<u16> = text.encode_utf16().collect();
        let little: Vec<u8> = [0xFF, 0xFE]
            .into_iter()
            .chain(units.iter().flat_map(|u| u.to_le_bytes()))
            .collect();
        let big: Vec<u8> = [0xFE, 0xFF]
            .into_iter()
            .chain(units.iter().flat_map(|u| u.to_be_bytes()))
            .collect();
        for bytes in [little, big] {
            assert_eq!(
                without_byte_order_mark(&bytes),
                (Cow::Borrowed(text.as_bytes()), true)
            );
        }
        assert_eq!(
            without_byte_order_mark(b"\xEF\xBB\xBFv"),
            (Cow::Borrowed(b"v".as_slice()), false)
        );
    }

    #[test]
    fn words_are_shortened() {
        assert_eq!(shortened(b"1,5"), "1,5");
        assert_eq!(shortened(b"\0\xFF"), "\u{FFFD}\u{FFFD}");
        assert_eq!(shortened(&[b'x'; 10_000]).chars().count(), 41);
    }
}
