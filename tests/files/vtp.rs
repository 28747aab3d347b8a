//! VTK in XML.

use crate::mesh::{base64, cube, is_refused_wherever_it_ends, ordered, refusal};
use umbilic::io::{Extra, Oddity, ReadError};
use umbilic::soup::PolygonSoup;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Text,
    Inline,
    Raw,
    AppendedBase64,
}

/// How a file is written.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Style {
    pub(crate) place: Place,
    pub(crate) compressed: bool,
    pub(crate) big: bool,
    pub(crate) long: bool,
    pub(crate) double: bool,
    /// An unstructured grid, not polygonal data.
    pub(crate) grid: bool,
    /// What other programs write besides.
    pub(crate) extras: bool,
}

pub(crate) const PLAIN: Style = Style {
    place: Place::Text,
    compressed: false,
    big: false,
    long: false,
    double: true,
    grid: false,
    extras: false,
};

/// zlib that compresses nothing.
fn zlib(bytes: &[u8]) -> Vec<u8> {
    let mut out = vec![0x78, 0x01, 1];
    let length = bytes.len() as u16;
    out.extend(length.to_le_bytes());
    out.extend((!length).to_le_bytes());
    out.extend(bytes);
    let (mut a, mut b) = (1_u32, 0_u32);
    for byte in bytes {
        a = (a + u32::from(*byte)) % 65521;
        b = (b + a) % 65521;
    }
    out.extend((b << 16 | a).to_be_bytes());
    out
}

struct Writer {
    style: Style,
    xml: String,
    appended: Vec<u8>,
}

impl Writer {
    fn length(&self, n: usize) -> Vec<u8> {
        let Style { big, long, .. } = self.style;
        if long {
            ordered((n as u64).to_le_bytes(), big).to_vec()
        } else {
            ordered((n as u32).to_le_bytes(), big).to_vec()
        }
    }

    /// An array, given as text and as bytes.
    fn array(&mut self, name: &str, kind: &str, text: &str, bytes: &[u8]) {
        let style = self.style;
        let format = match style.place {
            Place::Text => "ascii",
            Place::Inline => "binary",
            _ => "appended",
        };
        let (head, body) = if style.compressed {
            // Blocks of 40 bytes, the last shorter.
            let blocks: Vec<Vec<u8>> = bytes.chunks(40).map(zlib).collect();
            let last = bytes.len() % 40;
            let sizes = blocks.iter().map(Vec::len);
            let head = [blocks.len(), 40, last].into_iter().chain(sizes);
            (
                head.flat_map(|n| self.length(n)).collect::<Vec<_>>(),
                blocks.concat(),
            )
        } else {
            (self.length(bytes.len()), bytes.to_vec())
        };
        let encoded = if style.compressed {
            base64(&head) + &base64(&body)
        } else {
            base64(&[head.clone(), body.clone()].concat())
        };
        let offset = self.appended.len();
        let content = match style.place {
            Place::Text => text.to_owned(),
            Place::Inline => format!("\n  {encoded}\n"),
            Place::Raw => {
                self.appended.extend(head.into_iter().chain(body));
                String::new()
            }
            Place::AppendedBase64 => {
                self.appended.extend(encoded.bytes());
                String::new()
            }
        };
        let offset = match style.place {
            Place::Raw | Place::AppendedBase64 => format!(" offset=\"{offset}\""),
            _ => String::new(),
        };
        let key = if style.extras {
            "<InformationKey name='L2' location='x'><Value index='0'>3</Value></InformationKey>"
        } else {
            ""
        };
        let columns = if name == "Points" { "3" } else { "1" };
        self.xml += &format!(
            "<DataArray type=\"{kind}\" Name='{name}' NumberOfComponents=\"{columns}\" \
             format=\"{format}\"{offset}>{key}{content}</DataArray>\n"
        );
    }

    fn integers(&mut self, name: &str, numbers: &[u32]) {
        let text: Vec<String> = numbers.iter().map(u32::to_string).collect();
        let bytes = numbers.iter().flat_map(|n| {
            let wide = u64::from(*n).to_le_bytes();
            ordered(wide, self.style.big)
        });
        let bytes: Vec<u8> = bytes.collect();
        self.array(name, "Int64", &text.join("\n"), &bytes);
    }
}

pub(crate) fn file(soup: &PolygonSoup, style: Style) -> Vec<u8> {
    let mut w = Writer {
        style,
        xml: String::new(),
        appended: Vec::new(),
    };
    let kind = if style.grid {
        "UnstructuredGrid"
    } else {
        "PolyData"
    };
    let order = if style.big {
        "BigEndian"
    } else {
        "LittleEndian"
    };
    let header = if style.long { "UInt64" } else { "UInt32" };
    let compressor = if style.compressed {
        " compressor=\"vtkZLibDataCompressor\""
    } else {
        ""
    };
    w.xml += &format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" \
         byte_order=\"{order}\" header_type=\"{header}\"{compressor}>\n<{kind}>\n"
    );
    // Two pieces, the second of which counts its vertices from 0 again.
    for _ in 0..2 {
        w.xml += &format!("<Piece NumberOfPoints=\"{}\">\n", soup.positions.len());
        if style.extras {
            w.xml += "<PointData Scalars='s'>\n";
            w.integers("s", &[1; 8]);
            w.xml += "</PointData><CellData></CellData>\n";
        }
        w.xml += "<Points>\n";
        let numbers: Vec<f64> = soup.positions.iter().flat_map(|p| p.to_array()).collect();
        let text: Vec<String> = numbers.iter().map(|x| format!("{x:?}")).collect();
        let bytes: Vec<u8> = if style.double {
            let bytes = numbers.iter().map(|x| ordered(x.to_le_bytes(), style.big));
            bytes.flatten().collect()
        } else {
            let single = numbers.iter().map(|x| (*x as f32).to_le_bytes());
            single.flat_map(|x| ordered(x, style.big)).collect()
        };
        let kind = if style.double { "Float64" } else { "Float32" };
        w.array("Points", kind, &text.join(" "), &bytes);
        let group = if style.grid { "Cells" } else { "Polys" };
        w.xml += &format!("</Points>\n<{group}>\n");
        w.integers("connectivity", &soup.corners);
        w.integers("offsets", &soup.face_starts[1..]);
        if style.grid {
            let kind = |face: &[u32]| [5, 9, 7][(face.len() - 3).min(2)];
            let kinds: Vec<u32> = soup.faces().map(kind).collect();
            w.integers("types", &kinds);
        }
        w.xml += &format!("</{group}>\n</Piece>\n");
    }
    w.xml += &format!("</{kind}>\n");
    let mut out = w.xml.into_bytes();
    if matches!(style.place, Place::Raw | Place::AppendedBase64) {
        let encoding = if style.place == Place::Raw {
            "raw"
        } else {
            "base64"
        };
        out.extend(format!("<AppendedData encoding=\"{encoding}\">\n _").bytes());
        out.extend(w.appended);
        out.extend(b"\n</AppendedData>\n");
    }
    out.extend(b"</VTKFile>\n");
    out
}

/// Two copies of a soup.
fn twice(soup: &PolygonSoup) -> PolygonSoup {
    let mut both = soup.clone();
    both.positions.extend(&soup.positions);
    let count = soup.positions.len() as u32;
    for face in soup.faces() {
        let face: Vec<u32> = face.iter().map(|v| v + count).collect();
        both.push_face(&face);
    }
    both
}

pub(crate) fn variants() -> Vec<Style> {
    let mut all = Vec::new();
    for place in [
        Place::Text,
        Place::Inline,
        Place::Raw,
        Place::AppendedBase64,
    ] {
        for bits in 0..64_u32 {
            let on = |k: u32| bits >> k & 1 == 1;
            all.push(Style {
                place,
                compressed: on(0),
                big: on(1),
                long: on(2),
                double: on(3),
                grid: on(4),
                extras: on(5),
            });
        }
    }
    all
}

#[test]
fn every_variant_reads_as_the_mesh_it_was_written_of() {
    let soup = cube(0.0, 1.0);
    for style in variants() {
        let name = if style.grid { "a.vtu" } else { "a.vtp" };
        let read = umbilic::io::read(&file(&soup, style), name);
        let read = read.unwrap_or_else(|error| panic!("{style:?}: {error}"));
        assert_eq!(read.soup, twice(&soup), "{style:?}");
        let left_out = Oddity::LeftOut {
            what: vec![Extra::Data],
        };
        let expected = if style.extras { vec![left_out] } else { vec![] };
        assert_eq!(read.warnings, expected, "{style:?}");
    }
}

#[test]
fn damage_is_named_and_other_kinds_are_refused() {
    let soup = cube(0.0, 1.0);
    let text = String::from_utf8(file(&soup, PLAIN)).unwrap();
    let refused = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        refusal(text.replacen(from, to, 1).as_bytes())
    };
    let what = |what| ReadError::Unsupported { what };
    assert_eq!(
        refused("type=\"PolyData\"", "type='ImageData'"),
        what("vtk-data-set")
    );
    assert_eq!(
        refused("byte_order", "compressor='vtkLZ4DataCompressor' byte_order"),
        what("vtk-compressor")
    );
    for (from, to) in [
        ("0\n2\n3", "0\n2\n8"),
        ("0\n2\n3", "0\n2\n-1"),
        ("0\n2\n3", "0\n2\nx"),
        ("4\n8\n12", "4\n3\n12"),
        ("4\n8\n12", "4\n8\n99"),
        ("1.0 ", "1.0 1.0 "),
        ("Float64", "Complex"),
        ("format=\"ascii\"", "format='other'"),
    ] {
        let detail = refused(from, to).detail();
        assert_eq!(detail.first().map(|(name, _)| *name), Some("line"), "{to}");
    }
    for place in [Place::Inline, Place::Raw, Place::AppendedBase64] {
        for compressed in [false, true] {
            let bytes = file(
                &soup,
                Style {
                    place,
                    compressed,
                    ..PLAIN
                },
            );
            let end = match place {
                Place::Inline => bytes.len() / 2,
                _ => bytes.len() - "\n</AppendedData>\n</VTKFile>\n".len(),
            };
            // Of the first piece alone a file could be whole.
            is_refused_wherever_it_ends(&bytes, 1, end.min(bytes.len() / 3));
        }
    }
}

#[test]
fn a_small_file_cannot_ask_for_much_memory() {
    let style = Style {
        place: Place::Inline,
        compressed: true,
        ..PLAIN
    };
    let text = String::from_utf8(file(&cube(0.0, 1.0), style)).unwrap();
    // One block, of a gigabyte as it is said.
    let head: Vec<u8> = [1_u32, 1 << 30, 0, 20]
        .into_iter()
        .flat_map(u32::to_le_bytes)
        .collect();
    let start = text.find("\n  ").unwrap();
    let end = start + 3 + text[start + 3..].find('\n').unwrap();
    let bomb = text[..start].to_owned() + &base64(&head) + &base64(&[0x78; 20]) + &text[end..];
    let error = refusal(bomb.as_bytes());
    assert!(
        matches!(error, ReadError::CountTooLarge { what: "bytes", .. }),
        "{error}"
    );
}
