//! Numbers of binary files, with a check before each that it is there.

use super::{Place, ReadError};

/// The numeric types of binary files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Scalar {
    pub(super) fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }

    /// Bytes that one takes.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// The number that begins there, of as many bytes as the type takes; in less than that, 0.
    /// Whole numbers past 2⁵³ are rounded: no file has as many vertices.
    pub(super) fn read(self, bytes: &[u8], big: bool) -> f64 {
        let mut word = [0; 8];
        for (to, from) in word.iter_mut().zip(bytes.iter().take(self.size())) {
            *to = *from;
        }
        if big {
            word[..self.size()].reverse();
        }
        let bits = u64::from_le_bytes(word);
        match self {
            Self::I8 => f64::from(bits as i8),
            Self::U8 => f64::from(bits as u8),
            Self::I16 => f64::from(bits as i16),
            Self::U16 => f64::from(bits as u16),
            Self::I32 => f64::from(bits as i32),
            Self::U32 => f64::from(bits as u32),
            Self::I64 => bits as i64 as f64,
            Self::U64 => bits as f64,
            Self::F32 => f64::from(f32::from_bits(bits as u32)),
            Self::F64 => f64::from_bits(bits),
        }
    }
}

/// A place in a binary file, and what comes after it.
#[derive(Clone)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    /// The most significant byte comes first.
    pub(super) big: bool,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(bytes: &'a [u8], at: usize, big: bool) -> Self {
        Self { bytes, at, big }
    }

    pub(super) fn at(&self) -> usize {
        self.at
    }

    pub(super) fn place(&self) -> Place {
        Place::Byte { byte: self.at }
    }

    pub(super) fn left(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// Makes sure that so many bytes are left.
    pub(super) fn check(&self, needed: u64) -> Result<(), ReadError> {
        let available = self.left().len();
        if needed <= available as u64 {
            return Ok(());
        }
        Err(ReadError::Truncated {
            offset: self.at,
            needed,
            available,
        })
    }

    /// The next so many bytes.
    pub(super) fn take(&mut self, count: u64) -> Result<&'a [u8], ReadError> {
        self.check(count)?;
        // No more than is left, so it fits.
        Ok(self.step(count as usize))
    }

    /// The next so many bytes, or as many as there are.
    pub(super) fn step(&mut self, count: usize) -> &'a [u8] {
        let taken = &self.left()[..count.min(self.left().len())];
        self.at += taken.len();
        taken
    }

    pub(super) fn value(&mut self, scalar: Scalar) -> Result<f64, ReadError> {
        let big = self.big;
        Ok(scalar.read(self.take(scalar.size() as u64)?, big))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_both_byte_orders() {
        let cases: [(Scalar, &[u8], f64); 10] = [
            (Scalar::I8, &[0xFE], -2.0),
            (Scalar::U8, &[0xFE], 254.0),
            (Scalar::I16, &[0xFE, 0xFF], -2.0),
            (Scalar::U16, &[1, 2], 513.0),
            (Scalar::I32, &[0xFE, 0xFF, 0xFF, 0xFF], -2.0),
            (Scalar::U32, &[0, 0, 0, 0x80], 2_147_483_648.0),
            (Scalar::I64, &(-3_i64).to_le_bytes(), -3.0),
            (
                Scalar::U64,
                &(1_u64 << 40).to_le_bytes(),
                (1_u64 << 40) as f64,
            ),
            (Scalar::F32, &0.1_f32.to_le_bytes(), 0.1_f32 as f64),
            (Scalar::F64, &0.1_f64.to_le_bytes(), 0.1),
        ];
        for (scalar, bytes, expected) in cases {
            let mut turned = bytes.to_vec();
            turned.reverse();
            for (bytes, big) in [(bytes, false), (&turned[..], true)] {
                let mut cursor = Cursor::new(bytes, 0, big);
                assert_eq!(cursor.value(scalar), Ok(expected), "{scalar:?}");
                assert!(cursor.value(scalar).is_err(), "{scalar:?} past the end");
            }
        }
    }
}
