//! The parts of a glTF file: its JSON, its buffers, and the numbers that accessors find in them.

use std::borrow::Cow;

use super::super::base64;
use super::super::binary::{Cursor, Scalar};
use super::super::json::Json;
use super::super::text::shortened;
use super::super::{Expected, Format, Found, Place, ReadError};

/// A file, taken apart.
pub(super) struct Asset<'a> {
    pub(super) format: Format,
    pub(super) json: Json<'a>,
    /// Where the JSON ends in the file.
    end: usize,
    /// Bytes by number; none of those that are in files of their own.
    buffers: Vec<Option<Cow<'a, [u8]>>>,
    views: Vec<Json<'a>>,
    accessors: Vec<Json<'a>>,
}

/// Rows of numbers in a buffer.
pub(super) struct Numbers<'a> {
    /// Numbers in a row.
    pub(super) width: usize,
    /// How many rows.
    pub(super) count: usize,
    scalar: Scalar,
    /// Whole numbers stand for fractions of the largest.
    is_normalised: bool,
    stride: usize,
    bytes: Cow<'a, [u8]>,
    pub(super) place: Place,
}

/// Rows of bytes in a buffer.
struct Rows<'a> {
    stride: usize,
    bytes: &'a [u8],
}

impl Numbers<'_> {
    /// One number; of a row and a column that there are.
    pub(super) fn value(&self, row: usize, column: usize) -> f64 {
        let at = row * self.stride + column * self.scalar.size();
        let value = self.scalar.read(&self.bytes[at..], false);
        if !self.is_normalised {
            return value;
        }
        let largest = match self.scalar {
            Scalar::I8 => f64::from(i8::MAX),
            Scalar::U8 => f64::from(u8::MAX),
            Scalar::I16 => f64::from(i16::MAX),
            Scalar::U16 => f64::from(u16::MAX),
            _ => 1.0,
        };
        (value / largest).max(-1.0)
    }
}

const NO_BYTES: &[u8] = b"";
/// Beginnings of extensions that change nothing of where a surface is, or are told of where it is read.
const ASIDE: [&[u8]; 9] = [
    b"KHR_mesh_quantization",
    b"KHR_materials_",
    b"KHR_texture_",
    b"KHR_lights_",
    b"KHR_xmp",
    b"EXT_texture_",
    b"MSFT_texture_",
    b"KHR_draco_",
    b"EXT_meshopt_",
];
/// Bytes that an accessor without data may stand for.
const MOST_ZEROS: usize = 1 << 26;

impl<'a> Asset<'a> {
    /// Of a GLB file: a head of twelve bytes, then pieces, each after its length and its kind.
    pub(super) fn of_binary(bytes: &'a [u8]) -> Result<Self, ReadError> {
        let mut cursor = Cursor::new(bytes, 4, false);
        if cursor.value(Scalar::U32)? != 2.0 {
            let what = "gltf-version";
            return Err(ReadError::Unsupported { what });
        }
        cursor.take(4)?;
        let (mut json, mut binary) = (None, None);
        while json.is_none() || (binary.is_none() && cursor.left().len() >= 8) {
            let length = cursor.value(Scalar::U32)? as u64;
            let kind = cursor.take(4)?;
            let piece = cursor.take(length)?;
            match kind {
                b"JSON" => json = json.or(Some((piece, cursor.at()))),
                b"BIN\0" => binary = binary.or(Some(piece)),
                _ => {}
            }
        }
        let (json, end) = json.unwrap_or((NO_BYTES, 0));
        Self::new(Format::Glb, json, end, binary)
    }

    pub(super) fn of_json(bytes: &'a [u8]) -> Result<Self, ReadError> {
        Self::new(Format::Gltf, bytes, bytes.len(), None)
    }

    fn new(
        format: Format,
        text: &'a [u8],
        end: usize,
        binary: Option<&'a [u8]>,
    ) -> Result<Self, ReadError> {
        let json = Json::new(text).map_err(|at| {
            let place = Place::Byte {
                byte: end - text.len() + at,
            };
            let word = text[at.min(text.len())..]
                .split(u8::is_ascii_whitespace)
                .next();
            let found = match word {
                None | Some([]) => Found::EndOfFile,
                Some(word) => Found::Word {
                    word: shortened(word),
                },
            };
            ReadError::syntax(format, place, found, Expected::JsonValue)
        })?;
        let mut asset = Self {
            format,
            json,
            end,
            buffers: Vec::new(),
            views: Vec::new(),
            accessors: Vec::new(),
        };
        if json.get("asset").is_none() {
            return Err(asset.wrong(None, "asset"));
        }
        for buffer in asset.list("buffers") {
            let bytes = match buffer.get("uri").and_then(Json::string) {
                None => binary.map(Cow::Borrowed),
                Some(uri) if uri.starts_with(b"data:") => {
                    let comma = uri.iter().position(|&b| b == b',').unwrap_or(0);
                    let is_base64 = uri[..comma].ends_with(b"base64");
                    let plain = is_base64
                        .then(|| base64::decode(&uri[comma + 1..], usize::MAX))
                        .flatten();
                    let wrong = || asset.expected(buffer.get("uri"), Expected::Base64);
                    let plain = plain.ok_or_else(wrong)?;
                    Some(Cow::Owned(plain))
                }
                Some(_) => None,
            };
            asset.buffers.push(bytes);
        }
        for name in asset.list("extensionsRequired") {
            let name = name.string().unwrap_or_default();
            if !ASIDE.iter().any(|aside| name.starts_with(aside)) {
                let name = shortened(&name);
                return Err(ReadError::RequiredExtension { name });
            }
        }
        asset.views = asset.list("bufferViews");
        asset.accessors = asset.list("accessors");
        Ok(asset)
    }

    /// The items of a list at the top.
    pub(super) fn list(&self, name: &str) -> Vec<Json<'a>> {
        self.json
            .get(name)
            .into_iter()
            .flat_map(Json::items)
            .collect()
    }

    /// Where a value stands.
    pub(super) fn place(&self, value: Json<'a>) -> Place {
        Place::Byte {
            byte: self.end.saturating_sub(value.left()),
        }
    }

    /// The error that a value is missing, or is not what `name` should be.
    pub(super) fn wrong(&self, value: Option<Json<'a>>, name: &'static str) -> ReadError {
        self.expected(value, Expected::JsonMember { name })
    }

    /// The same of anything else that should stand there.
    pub(super) fn expected(&self, value: Option<Json<'a>>, expected: Expected) -> ReadError {
        let place = self.place(value.unwrap_or(self.json));
        let found = value.map_or(Found::Nothing, |value| Found::Word {
            word: shortened(value.written()),
        });
        ReadError::syntax(self.format, place, found, expected)
    }

    /// A list of so many finite numbers.
    pub(super) fn numbers<const N: usize>(
        &self,
        list: Json<'a>,
        name: &'static str,
    ) -> Result<[f64; N], ReadError> {
        let numbers = list.items().map_while(Json::number);
        let numbers: Vec<f64> = numbers.filter(|x| x.is_finite()).take(N + 1).collect();
        numbers.try_into().map_err(|_| self.wrong(Some(list), name))
    }

    /// What an accessor, by its number, finds for a primitive.
    pub(super) fn accessor(
        &self,
        number: Json<'a>,
        primitive: Json<'a>,
    ) -> Result<Numbers<'_>, ReadError> {
        let accessor = number.index().and_then(|index| self.accessors.get(index));
        let accessor = *accessor.ok_or_else(|| self.wrong(Some(number), "accessors"))?;
        let wrong = |name| self.wrong(Some(accessor), name);
        let scalar = self.scalar(accessor)?;
        let width = match accessor.get("type").and_then(Json::string).as_deref() {
            Some(b"SCALAR") => 1,
            Some(b"VEC3") => 3,
            Some(b"VEC4") => 4,
            _ => return Err(wrong("type")),
        };
        let count = |of: Json<'a>| {
            let count = of.get("count").and_then(Json::index);
            count.ok_or_else(|| self.wrong(Some(of), "count"))
        };
        let size = width * scalar.size();
        let length = count(accessor)?.saturating_mul(size);
        let is_all_sparse = accessor.get("sparse").is_some()
            && accessor.get("bufferView").is_none()
            && length <= MOST_ZEROS;
        let (stride, bytes) = if is_all_sparse {
            (size, Cow::Owned(vec![0; length]))
        } else {
            let rows = self.rows(accessor, primitive, count(accessor)?, size)?;
            (rows.stride, Cow::Borrowed(rows.bytes))
        };
        let mut numbers = Numbers {
            width,
            count: count(accessor)?,
            scalar,
            is_normalised: accessor.get("normalized").is_some_and(Json::is_true),
            stride,
            bytes,
            place: self.place(accessor),
        };
        // Rows in the place of some of these.
        if let Some(sparse) = accessor.get("sparse") {
            let part = |name| sparse.get(name).ok_or_else(|| wrong(name));
            let (at, values) = (part("indices")?, part("values")?);
            let which = self.scalar(at)?;
            let n = count(sparse)?;
            let listed = self.rows(at, primitive, n, which.size())?;
            let others = self.rows(values, primitive, n, size)?;
            let bytes = numbers.bytes.to_mut();
            for k in 0..n {
                let row = which.read(&listed.bytes[k * listed.stride..], false) as usize;
                let to = row.saturating_mul(numbers.stride);
                let place = bytes.get_mut(to..to.saturating_add(size));
                let place = place.ok_or_else(|| self.wrong(Some(at), "indices"))?;
                place.copy_from_slice(&others.bytes[k * others.stride..][..size]);
            }
        }
        Ok(numbers)
    }

    fn scalar(&self, of: Json<'a>) -> Result<Scalar, ReadError> {
        Ok(match of.get("componentType").and_then(Json::index) {
            Some(5120) => Scalar::I8,
            Some(5121) => Scalar::U8,
            Some(5122) => Scalar::I16,
            Some(5123) => Scalar::U16,
            Some(5125) => Scalar::U32,
            Some(5126) => Scalar::F32,
            _ => return Err(self.wrong(Some(of), "componentType")),
        })
    }

    /// So many rows of so many bytes each, of the buffer view that something names.
    fn rows(
        &self,
        of: Json<'a>,
        primitive: Json<'a>,
        count: usize,
        size: usize,
    ) -> Result<Rows<'_>, ReadError> {
        let refused = |what| Err(ReadError::Unsupported { what });
        let wrong = |name| self.wrong(Some(of), name);
        let Some(view) = of.get("bufferView") else {
            let extensions = primitive.get("extensions");
            let draco = extensions.and_then(|all| all.get("KHR_draco_mesh_compression"));
            return draco.map_or_else(|| Err(wrong("bufferView")), |_| refused("gltf-draco"));
        };
        let view = view.index().and_then(|index| self.views.get(index));
        let view = *view.ok_or_else(|| wrong("bufferView"))?;
        let extensions = view.get("extensions").into_iter().flat_map(Json::members);
        for (name, _) in extensions {
            if name.ends_with(b"_meshopt_compression") {
                return refused("gltf-meshopt");
            }
        }
        let buffer = view.get("buffer").and_then(Json::index);
        let buffer = buffer.and_then(|index| self.buffers.get(index));
        let Some(buffer) = buffer.ok_or_else(|| self.wrong(Some(view), "buffer"))? else {
            return refused("gltf-external");
        };
        let stride = match view.get("byteStride").and_then(Json::index) {
            None | Some(0) => size,
            Some(stride) if stride >= size => stride,
            Some(_) => return Err(self.wrong(Some(view), "byteStride")),
        };
        let offset = |of: Json<'a>| of.get("byteOffset").and_then(Json::index).unwrap_or(0);
        let start = offset(view).saturating_add(offset(of));
        let length = match count {
            0 => 0,
            _ => (count - 1).saturating_mul(stride).saturating_add(size),
        };
        let within = view.get("byteLength").and_then(Json::index);
        let within = within.unwrap_or(usize::MAX).saturating_add(offset(view));
        let buffer = &buffer[..within.min(buffer.len())];
        let end = start.saturating_add(length);
        let bytes = buffer.get(start..end).ok_or(ReadError::Truncated {
            offset: start,
            needed: length as u64,
            available: buffer.len().saturating_sub(start),
        })?;
        Ok(Rows { stride, bytes })
    }
}
