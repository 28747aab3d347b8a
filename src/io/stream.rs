//! Words and numbers of files whose lines of text are followed by numbers in text or in binary.

use glam::DVec3;

use super::binary::{Cursor, Scalar};
use super::text::{parse_float, parse_integer, shortened};
use super::{Expected, Format, Found, Place, ReadError};

/// A file that is read from the front.
pub(super) struct Stream<'a> {
    format: Format,
    cursor: Cursor<'a>,
    line: usize,
    line_end: u8,
    /// Whether numbers are in binary.
    pub(super) is_binary: bool,
}

impl<'a> Stream<'a> {
    /// Lines end with LF or CR LF; with CR in a file that has no LF at all.
    pub(super) fn new(format: Format, bytes: &'a [u8]) -> Self {
        let line_end = if bytes.contains(&b'\n') { b'\n' } else { b'\r' };
        Self {
            format,
            cursor: Cursor::new(bytes, 0, false),
            line: 1,
            line_end,
            is_binary: false,
        }
    }

    /// Which byte of a number comes first.
    pub(super) fn set_big_endian(&mut self, big: bool) {
        self.cursor.big = big;
    }

    pub(super) fn left(&self) -> &'a [u8] {
        self.cursor.left()
    }

    /// Of text the line, else the byte.
    pub(super) fn place(&self) -> Place {
        if self.is_binary {
            self.cursor.place()
        } else {
            Place::Line { line: self.line }
        }
    }

    fn step(&mut self, count: usize) -> &'a [u8] {
        let taken = self.cursor.step(count);
        if !self.is_binary {
            self.line += taken.iter().filter(|&&byte| byte == self.line_end).count();
        }
        taken
    }

    /// The rest of the line, without its end.
    pub(super) fn line(&mut self) -> &'a [u8] {
        let end = self.left().iter().position(|&byte| byte == self.line_end);
        let taken = self.step(end.map_or(self.left().len(), |end| end + 1));
        taken.trim_ascii()
    }

    /// The next word, if there is one.
    pub(super) fn try_word(&mut self) -> Option<&'a [u8]> {
        let blanks = self
            .left()
            .iter()
            .position(|byte| !byte.is_ascii_whitespace());
        self.step(blanks.unwrap_or(self.left().len()));
        let end = self.left().iter().position(u8::is_ascii_whitespace);
        let word = self.step(end.unwrap_or(self.left().len()));
        (!word.is_empty()).then_some(word)
    }

    /// The next word, which must be there.
    pub(super) fn word(&mut self, expected: Expected) -> Result<&'a [u8], ReadError> {
        let word = self.try_word();
        word.ok_or_else(|| self.error(None, expected))
    }

    /// Steps to just after `text`, or to the end.
    pub(super) fn skip_past(&mut self, text: &[u8]) {
        let found = self.left().windows(text.len()).position(|at| at == text);
        self.step(found.map_or(self.left().len(), |at| at + text.len()));
    }

    /// The error that `found` (none: the file's end) stands where `expected` should.
    pub(super) fn error(&self, found: Option<&[u8]>, expected: Expected) -> ReadError {
        let found = found.map_or(Found::EndOfFile, |word| Found::Word {
            word: shortened(word),
        });
        ReadError::syntax(self.format, self.place(), found, expected)
    }

    /// The next number, in text or in binary.
    pub(super) fn value(&mut self, scalar: Scalar, expected: Expected) -> Result<f64, ReadError> {
        if self.is_binary {
            return self.cursor.value(scalar);
        }
        let word = self.word(expected)?;
        let value = if scalar.is_integer() {
            parse_integer(word).map(|value| value as f64)
        } else {
            parse_float(word)
        };
        value.ok_or_else(|| self.error(Some(word), expected))
    }

    /// The next number, of how many things follow.
    pub(super) fn count(&mut self, scalar: Scalar, expected: Expected) -> Result<u64, ReadError> {
        let count = self.value(scalar, expected)?;
        if count >= 0.0 && count.fract() == 0.0 {
            return Ok(count as u64);
        }
        Err(self.error(Some(count.to_string().as_bytes()), expected))
    }

    /// The same, always as a word.
    pub(super) fn count_word(&mut self, expected: Expected) -> Result<u64, ReadError> {
        let word = self.word(expected)?;
        let count = parse_integer(word).and_then(|count| u64::try_from(count).ok());
        count.ok_or_else(|| self.error(Some(word), expected))
    }

    /// A count of things, once it is sure that the bytes left could hold so many, each of
    /// `numbers` numbers at least, of `size` bytes in all where they are in binary.
    pub(super) fn checked(
        &self,
        what: &'static str,
        count: u64,
        numbers: usize,
        size: usize,
    ) -> Result<usize, ReadError> {
        // In text, a digit and a blank each.
        let each = if self.is_binary { size } else { 2 * numbers }.max(1) as u64;
        let at_most = (self.left().len() as u64 + 1) / each;
        match usize::try_from(count) {
            Ok(fits) if count <= at_most => Ok(fits),
            _ => Err(ReadError::CountTooLarge {
                place: self.place(),
                what,
                count,
                at_most,
            }),
        }
    }

    /// The next three numbers as a position.
    pub(super) fn point(&mut self, scalar: Scalar) -> Result<DVec3, ReadError> {
        let mut point = DVec3::ZERO;
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            point[axis] = self.value(scalar, Expected::Coordinate { axis: name })?;
        }
        Ok(point)
    }

    /// Steps over so many numbers.
    pub(super) fn skip(&mut self, scalar: Scalar, count: u64) -> Result<(), ReadError> {
        if self.is_binary {
            let size = count.saturating_mul(scalar.size() as u64);
            return self.cursor.take(size).map(drop);
        }
        for _ in 0..count {
            self.word(Expected::Number)?;
        }
        Ok(())
    }
}
