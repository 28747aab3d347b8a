//! Files in a ZIP archive.

use super::inflate::{most_of, too_large, whole};
use super::{Content, Part, UnpackError};
use flate2::Crc;
use flate2::bufread::DeflateDecoder;
use rawzip::{
    CompressionMethod, ZipArchive, ZipArchiveEntryWayfinder, ZipSliceArchive, ZipVerification,
};
use std::io::Read;
use std::rc::Rc;

/// A file whose place is known.
pub(super) struct Entry<'a> {
    archive: Rc<ZipSliceArchive<&'a [u8]>>,
    at: ZipArchiveEntryWayfinder,
    method: CompressionMethod,
    is_encrypted: bool,
}

pub(super) fn is_zip(bytes: &[u8]) -> bool {
    [b"PK\x03\x04", b"PK\x05\x06"]
        .iter()
        .any(|magic| bytes.starts_with(*magic))
}

/// The files of an archive, without its folders.
pub(super) fn parts(bytes: &[u8]) -> Result<Vec<Part<'_>>, UnpackError> {
    let archive = ZipArchive::from_slice(bytes).map_err(|_| UnpackError::Damaged)?;
    let archive = Rc::new(archive);
    let mut parts = Vec::new();
    for record in archive.entries() {
        let record = record.map_err(|_| UnpackError::Damaged)?;
        let name = String::from_utf8_lossy(record.file_path().as_ref()).replace('\\', "/");
        if name.ends_with('/') {
            continue;
        }
        parts.push(Part {
            name,
            size: record.uncompressed_size_hint(),
            content: Content::Packed(Entry {
                archive: archive.clone(),
                at: record.wayfinder(),
                method: record.compression_method(),
                is_encrypted: record.flags().is_encrypted(),
            }),
        });
    }
    Ok(parts)
}

impl Entry<'_> {
    pub(super) fn read(&self) -> Result<Vec<u8>, UnpackError> {
        if self.is_encrypted {
            return Err(UnpackError::Encrypted);
        }
        let entry = self.archive.get_entry(self.at);
        let entry = entry.map_err(|_| UnpackError::Damaged)?;
        let (packed, size) = (entry.data(), self.at.uncompressed_size_hint());
        if size > most_of(packed) {
            return Err(too_large(most_of(packed)));
        }
        let plain: Box<dyn Read + '_> = match self.method {
            CompressionMethod::STORE => Box::new(packed),
            CompressionMethod::DEFLATE => Box::new(DeflateDecoder::new(packed)),
            other => {
                let method = u32::from(other.as_u16());
                return Err(UnpackError::Unsupported { method });
            }
        };
        let bytes = whole(plain, size)?;
        // By the sum that gzip needs too: the crate's own would bring a second table of 16 kB.
        let mut sum = Crc::new();
        sum.update(&bytes);
        let found = ZipVerification {
            crc: sum.sum(),
            uncompressed_size: bytes.len() as u64,
        };
        let checked = entry.claim_verifier().valid(found);
        checked.map(|()| bytes).map_err(|_| UnpackError::Damaged)
    }
}
