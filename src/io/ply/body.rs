//! The body of a PLY file, text or binary, behind one interface.

use super::super::binary::{Cursor, Scalar};
use super::super::text::{Lines, Words};
use super::super::{Expected, Format, Oddity, Place, ReadError};
use super::header::{Element, Header};

/// Values of an element's records, in the header's order.
pub(super) trait Body {
    /// The encoding.
    fn format(&self) -> Format;

    /// How many records of an element to read, once it is sure that the bytes left could
    /// hold them. Records without properties take no room and are none.
    fn check_count(&self, element: &Element) -> Result<usize, ReadError>;

    /// Goes to the next record.
    fn begin(&mut self, expected: Expected) -> Result<(), ReadError>;

    /// Where the record, or the value to be read, begins.
    fn place(&self) -> Place;

    /// The next value; every type but `double` fits an `f64` exactly, and so does that.
    fn value(&mut self, scalar: Scalar, expected: Expected) -> Result<f64, ReadError>;

    /// Makes sure that a list of such length could follow.
    fn check_list(&self, scalar: Scalar, length: u64) -> Result<(), ReadError>;

    /// Steps over so many values.
    fn skip(&mut self, scalar: Scalar, count: u64) -> Result<(), ReadError>;

    /// What is left after the last record.
    fn left(&mut self) -> Option<Oddity>;
}

/// A body in text: a record a line.
pub(super) struct Text<'a> {
    lines: Lines<'a>,
    record: Words<'a>,
}

impl<'a> Text<'a> {
    pub(super) fn new(header: &Header, bytes: &'a [u8]) -> Result<Self, ReadError> {
        // Checked from the start, for the offset in the error.
        Lines::of_text(header.format, bytes)?;
        let lines = Lines::new(header.format, &bytes[header.body..])
            .starting_at(header.line_end, header.lines);
        Ok(Self {
            lines,
            record: Words::none(header.format),
        })
    }
}

impl Body for Text<'_> {
    fn format(&self) -> Format {
        Format::PlyAscii
    }

    fn check_count(&self, element: &Element) -> Result<usize, ReadError> {
        if element.properties.is_empty() {
            return Ok(0);
        }
        // A number and a blank for each property at least.
        let at_most = (self.lines.rest().len() as u64 + 1) / (2 * element.properties.len() as u64);
        checked(element, at_most)
    }

    fn begin(&mut self, expected: Expected) -> Result<(), ReadError> {
        self.record = self.lines.next_filled(expected)?;
        Ok(())
    }

    fn place(&self) -> Place {
        self.record.place()
    }

    fn value(&mut self, scalar: Scalar, expected: Expected) -> Result<f64, ReadError> {
        if scalar.is_integer() {
            self.record.integer(expected).map(|value| value as f64)
        } else {
            self.record.float(expected)
        }
    }

    fn check_list(&self, _: Scalar, _: u64) -> Result<(), ReadError> {
        // The line's end stops the list.
        Ok(())
    }

    fn skip(&mut self, _: Scalar, count: u64) -> Result<(), ReadError> {
        for _ in 0..count {
            self.record.word(Expected::Number)?;
        }
        Ok(())
    }

    fn left(&mut self) -> Option<Oddity> {
        self.lines.left()
    }
}

/// A body in binary, big or little endian.
pub(super) struct Binary<'a>(Cursor<'a>);

impl<'a> Binary<'a> {
    pub(super) fn new(header: &Header, bytes: &'a [u8]) -> Self {
        let big = header.format == Format::PlyBigEndian;
        Self(Cursor::new(bytes, header.body, big))
    }
}

impl Body for Binary<'_> {
    fn format(&self) -> Format {
        if self.0.big {
            Format::PlyBigEndian
        } else {
            Format::Ply
        }
    }

    fn check_count(&self, element: &Element) -> Result<usize, ReadError> {
        let size = element.least_size();
        if size == 0 {
            return Ok(0);
        }
        // Where all records are alike the file must hold them to the last byte; with
        // lists this is the least, and each list is checked on its own.
        self.0.check(element.count.saturating_mul(size as u64))?;
        checked(element, u64::MAX)
    }

    fn left(&mut self) -> Option<Oddity> {
        let left = self.0.left().trim_ascii_start();
        let count = left.len() as u64;
        (count > 0).then_some(Oddity::BytesLeft { count })
    }

    fn begin(&mut self, _: Expected) -> Result<(), ReadError> {
        Ok(())
    }

    fn place(&self) -> Place {
        self.0.place()
    }

    fn value(&mut self, scalar: Scalar, _: Expected) -> Result<f64, ReadError> {
        self.0.value(scalar)
    }

    fn check_list(&self, scalar: Scalar, length: u64) -> Result<(), ReadError> {
        self.0.check(length.saturating_mul(scalar.size() as u64))
    }

    fn skip(&mut self, scalar: Scalar, count: u64) -> Result<(), ReadError> {
        self.0.take(count.saturating_mul(scalar.size() as u64))?;
        Ok(())
    }
}

fn checked(element: &Element, at_most: u64) -> Result<usize, ReadError> {
    match usize::try_from(element.count) {
        Ok(count) if element.count <= at_most => Ok(count),
        _ => Err(ReadError::CountTooLarge {
            place: element.place,
            what: element.kind.plural(),
            count: element.count,
            at_most,
        }),
    }
}
