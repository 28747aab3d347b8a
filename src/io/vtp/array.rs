//! One array of a VTK file in XML: where its numbers stand, and what they are.

use super::super::base64;
use super::super::binary::{Cursor, Scalar};
use super::super::budget::Budget;
use super::super::packed::inflate::zlib;
use super::super::text::{parse_float, shortened};
use super::super::xml::{Event, Tag, Xml};
use super::super::{Expected, Format, Found, Place, ReadError};
use super::whole;
use std::borrow::Cow;

/// What is the same for all arrays of a file.
pub(super) struct File<'a> {
    /// The elements.
    pub(super) head: &'a [u8],
    /// What comes after them, and whether it is base64.
    appended: &'a [u8],
    is_base64: bool,
    pub(super) big: bool,
    /// Lengths have 64 bits.
    pub(super) long_headers: bool,
    pub(super) is_compressed: bool,
}

impl<'a> File<'a> {
    /// A file whose appended data, which may be binary, is kept from those who read elements.
    pub(super) fn of(bytes: &'a [u8]) -> Self {
        const APPENDED: &[u8] = b"<AppendedData";
        let found = bytes.windows(APPENDED.len()).position(|at| at == APPENDED);
        let (head, rest) = bytes.split_at(found.unwrap_or(bytes.len()));
        let tag = rest.iter().position(|&b| b == b'>').unwrap_or(rest.len());
        let (tag, rest) = rest.split_at(tag);
        let is_base64 = tag.windows(6).any(|at| at == b"base64");
        // An underscore marks where offsets count from.
        let mark = rest.iter().position(|&b| b == b'_').map(|at| at + 1);
        Self {
            head,
            appended: &rest[mark.unwrap_or(rest.len())..],
            is_base64,
            big: false,
            long_headers: false,
            is_compressed: false,
        }
    }

    fn length(&self) -> Scalar {
        if self.long_headers {
            Scalar::U64
        } else {
            Scalar::U32
        }
    }
}

/// Where the bytes of an array are.
enum Source<'a> {
    Text(&'a [u8]),
    Base64(&'a [u8]),
    Raw(&'a [u8]),
}

/// An array.
pub(super) struct Arrays<'a, 'f> {
    scalar: Scalar,
    source: Source<'a>,
    file: &'f File<'a>,
    pub(super) place: Place,
}

/// The error that a number stands where something else should.
pub(super) fn wrong(place: Place, found: f64, expected: Expected) -> ReadError {
    let word = found.to_string();
    ReadError::syntax(Format::Vtp, place, Found::Word { word }, expected)
}

/// The text of the element just begun, aside from that of elements within.
fn own_text<'a>(xml: &mut Xml<'a>) -> Result<&'a [u8], ReadError> {
    let mut depth = 0_usize;
    loop {
        match xml.next()? {
            Some(Event::Text(text)) if depth == 0 => return Ok(text),
            Some(Event::Start(_)) => depth += 1,
            Some(Event::End(_)) if depth > 0 => depth -= 1,
            Some(Event::Text(_) | Event::Instruction(_)) => {}
            Some(Event::End(_)) | None => return Ok(b""),
        }
    }
}

impl<'a, 'f> Arrays<'a, 'f> {
    /// Of an element just begun.
    pub(super) fn read(
        tag: &Tag<'a>,
        xml: &mut Xml<'a>,
        file: &'f File<'a>,
    ) -> Result<Self, ReadError> {
        let place = tag.place;
        let name = tag.need("type")?;
        let scalar = match name {
            b"Int8" => Scalar::I8,
            b"UInt8" => Scalar::U8,
            b"Int16" => Scalar::I16,
            b"UInt16" => Scalar::U16,
            b"Int32" => Scalar::I32,
            b"UInt32" => Scalar::U32,
            b"Int64" => Scalar::I64,
            b"UInt64" => Scalar::U64,
            b"Float32" => Scalar::F32,
            b"Float64" => Scalar::F64,
            _ => return Err(tag.error(Some(name), "type")),
        };
        let encoding = tag.get("format").unwrap_or(b"ascii");
        let source = if encoding == b"appended" {
            let offset = whole(tag, "offset")?;
            let needed = offset as u64;
            let bytes = file.appended.get(offset..).ok_or(ReadError::Truncated {
                offset: file.head.len(),
                needed,
                available: file.appended.len(),
            })?;
            if file.is_base64 {
                Source::Base64(bytes)
            } else {
                Source::Raw(bytes)
            }
        } else {
            let text = own_text(xml)?;
            match encoding {
                b"ascii" => Source::Text(text),
                b"binary" => Source::Base64(text),
                _ => return Err(tag.error(Some(encoding), "format")),
            }
        };
        Ok(Self {
            scalar,
            source,
            file,
            place,
        })
    }

    pub(super) fn wrong(&self, found: usize, expected: Expected) -> ReadError {
        wrong(self.place, found as f64, expected)
    }

    /// All numbers.
    pub(super) fn values(&self, budget: &mut Budget) -> Result<Vec<f64>, ReadError> {
        if let Source::Text(text) = self.source {
            budget.take(4 * text.len() as u64, self.place)?;
            let words = text.split(u8::is_ascii_whitespace);
            let number = |word: &[u8]| {
                parse_float(word).ok_or_else(|| {
                    let word = shortened(word);
                    let found = Found::Word { word };
                    ReadError::syntax(Format::Vtp, self.place, found, Expected::Number)
                })
            };
            return words.filter(|word| !word.is_empty()).map(number).collect();
        }
        let bytes = self.bytes(budget)?;
        let numbers = bytes.chunks_exact(self.scalar.size());
        budget.take(8 * numbers.len() as u64, self.place)?;
        let big = self.file.big;
        Ok(numbers.map(|bytes| self.scalar.read(bytes, big)).collect())
    }

    fn damaged(&self, expected: Expected) -> ReadError {
        ReadError::syntax(Format::Vtp, self.place, Found::EndOfFile, expected)
    }

    /// The first so many bytes of what stands there.
    fn front(&self, count: u64) -> Result<Cow<'a, [u8]>, ReadError> {
        let short = |available| ReadError::Truncated {
            offset: self.file.head.len(),
            needed: count,
            available,
        };
        let most = usize::try_from(count).map_err(|_| short(0))?;
        let front = match self.source {
            Source::Base64(text) => {
                let front = base64::decode(text, most);
                Cow::Owned(front.ok_or_else(|| self.damaged(Expected::Base64))?)
            }
            Source::Raw(bytes) | Source::Text(bytes) => {
                Cow::Borrowed(&bytes[..most.min(bytes.len())])
            }
        };
        if front.len() < most {
            return Err(short(front.len()));
        }
        Ok(front)
    }

    /// The array's own bytes, after their length; where they are compressed, after how many blocks
    /// there are, how long one is, how long the last is (0: as the others), and how long each is
    /// compressed.
    fn bytes(&self, budget: &mut Budget) -> Result<Cow<'a, [u8]>, ReadError> {
        let length = self.file.length();
        let size = length.size() as u64;
        let lengths = |count: u64| -> Result<Vec<u64>, ReadError> {
            let head = self.front(count.saturating_mul(size))?;
            let mut cursor = Cursor::new(&head, 0, self.file.big);
            (0..count)
                .map(|_| Ok(cursor.value(length)? as u64))
                .collect()
        };
        let first = match &self.source {
            // Nothing at all, where there are no cells of the kind.
            Source::Base64(text) if text.trim_ascii().is_empty() => return Ok(Cow::Borrowed(&[])),
            _ => lengths(1)?[0],
        };
        if !self.file.is_compressed {
            let whole = self.front(size.saturating_add(first))?;
            return Ok(match whole {
                Cow::Borrowed(bytes) => Cow::Borrowed(&bytes[size as usize..]),
                Cow::Owned(mut bytes) => {
                    bytes.drain(..size as usize);
                    Cow::Owned(bytes)
                }
            });
        }
        if first == 0 {
            return Ok(Cow::Borrowed(&[]));
        }
        let head = lengths(first.saturating_add(3))?;
        let (block, last) = (head[1], head[2]);
        let start = (3 + first) * size;
        let end = head[3..]
            .iter()
            .fold(start, |sum, n| sum.saturating_add(*n));
        let whole = self.front(end)?;
        let mut rest = &whole[start as usize..];
        let mut bytes = Vec::new();
        for (at, compressed) in head[3..].iter().enumerate() {
            let is_last = at + 1 == head.len() - 3;
            let length = if is_last && last > 0 { last } else { block };
            budget.take(length, self.place)?;
            // All are there: they were counted.
            let (piece, after) = rest.split_at(*compressed as usize);
            rest = after;
            let plain = usize::try_from(length)
                .ok()
                .and_then(|length| zlib(piece, length));
            bytes.extend(plain.ok_or_else(|| self.damaged(Expected::Compressed))?);
        }
        Ok(Cow::Owned(bytes))
    }
}
