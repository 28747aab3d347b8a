//! Compressed bytes, of which no more is kept than there may be.

use super::UnpackError;
use flate2::bufread::{MultiGzDecoder, ZlibDecoder};
use std::io::Read;

/// At most so many bytes are unpacked,
const MOST: u64 = 1 << 30;
/// or, of what is small already, so many times its size: no mesh is compressed further.
const RATIO: u64 = 200;
const SMALL: u64 = 1 << 24;

/// What may come out of so many bytes.
pub(super) fn most_of(packed: &[u8]) -> u64 {
    (RATIO * packed.len() as u64).clamp(SMALL, MOST)
}

pub(super) fn too_large(most: u64) -> UnpackError {
    let megabytes = (most + (1 << 19)) >> 20;
    UnpackError::TooLarge { megabytes }
}

/// Everything that a decoder gives, which checks at its end that it was right.
pub(super) fn whole(decoder: impl Read, most: u64) -> Result<Vec<u8>, UnpackError> {
    let mut bytes = Vec::new();
    let read = decoder.take(most.saturating_add(1)).read_to_end(&mut bytes);
    // What is damaged may well be too long.
    if bytes.len() as u64 > most {
        return Err(too_large(most));
    }
    read.map(|_| bytes).map_err(|_| UnpackError::Damaged)
}

pub(super) fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x1f, 0x8b])
}

/// Out of gzip, of one member or, as `cat` and `bgzip` put them, of several.
pub(super) fn gunzip(bytes: &[u8]) -> Result<Vec<u8>, UnpackError> {
    whole(MultiGzDecoder::new(bytes), most_of(bytes))
}

/// So many bytes from zlib's data (RFC 1950); `None` where they are damaged, or would be more or
/// fewer.
pub(in crate::io) fn zlib(bytes: &[u8], length: usize) -> Option<Vec<u8>> {
    let found = whole(ZlibDecoder::new(bytes), length as u64).ok()?;
    (found.len() == length).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::Compression;
    use flate2::write::ZlibEncoder;
    use std::io::Write;

    #[test]
    fn zlib_gives_as_many_bytes_as_wanted_or_none() {
        let plain: Vec<u8> = (0..5000_u32).map(|k| ((k * k) >> 7) as u8).collect();
        let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(&plain).unwrap();
        let mut packed = encoder.finish().unwrap();
        assert_eq!(zlib(&packed, plain.len()), Some(plain.clone()));
        assert_eq!(zlib(&packed, plain.len() + 1), None, "too few");
        assert_eq!(zlib(&packed, plain.len() - 1), None, "too many");
        let end = packed.len() - 1;
        assert_eq!(zlib(&packed[..end], plain.len()), None, "cut short");
        packed[end] ^= 1;
        assert_eq!(zlib(&packed, plain.len()), None, "another sum");
    }
}
