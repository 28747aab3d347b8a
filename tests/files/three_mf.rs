//! The model of a 3MF package.

use crate::mesh::{cube, is_refused_wherever_it_ends, oddities, plain, refusal};
use glam::DVec3;
use umbilic::io::{Extra, Oddity, ReadError};
use umbilic::soup::PolygonSoup;

/// The mesh of an object.
fn mesh(soup: &PolygonSoup, line_end: &str) -> String {
    let mut out = format!("<mesh>{line_end}<vertices>");
    for p in &soup.positions {
        out += &format!(
            "<vertex x=\"{:?}\" y='{:?}' z = \"{:?}\"/>{line_end}",
            p.x, p.y, p.z
        );
    }
    out += "</vertices><triangles>";
    for [a, b, c] in soup.triangles() {
        out += &format!("<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\" pid=\"1\" />{line_end}");
    }
    out + "</triangles></mesh>"
}

const HEAD: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" \
                    xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">";

pub(crate) fn file(soup: &PolygonSoup, prefix: &str, line_end: &str, item: &str) -> Vec<u8> {
    let mesh = mesh(soup, line_end);
    let text = format!(
        "{HEAD}<metadata name=\"Title\">a &amp; b</metadata><!-- <object> --><resources>\
         <object id=\"4\" type=\"model\">{mesh}</object></resources><build>{item}</build></model>"
    );
    let text = if prefix.is_empty() {
        text
    } else {
        let start = text.find("<model").unwrap();
        let (head, body) = text.split_at(start);
        let opened = body.replace('<', &format!("<{prefix}"));
        let closed = opened.replace(&format!("<{prefix}/"), &format!("</{prefix}"));
        head.to_owned() + &closed.replace(&format!("<{prefix}!"), "<!")
    };
    text.replace('\n', line_end).into_bytes()
}

pub(crate) const ITEM: &str = "<item objectid=\"4\"/>";

pub(crate) fn variants() -> Vec<Vec<u8>> {
    let soup = cube(0.0, 1.0);
    let mut all = Vec::new();
    for prefix in ["", "m:"] {
        for line_end in ["", "\n", "\r\n", "\r", "\t \n"] {
            for item in [
                ITEM,
                "<item objectid='4' transform='1 0 0 0 1 0 0 0 1 0 0 0'></item>",
            ] {
                all.push(file(&soup, prefix, line_end, item));
            }
        }
    }
    all
}

#[test]
fn every_variant_reads_as_the_mesh_it_was_written_of() {
    let soup = cube(0.0, 1.0).triangulated();
    for bytes in variants() {
        assert_eq!(plain(&bytes, "a.3mf"), soup);
    }
    for (origin, size) in [(1e3, 1.0), (5e6, 1.0), (0.0, 1e-6), (0.0, 1e6)] {
        let soup = cube(origin, size);
        let read = plain(&file(&soup, "", "\n", ITEM), "");
        assert_eq!(read.positions, soup.positions);
    }
}

/// Components of components, one mirrored, one in another file of the package.
fn assembly() -> String {
    let mesh = mesh(&cube(0.0, 1.0), "\n");
    format!(
        "<?model /3D/3dmodel.model?>{HEAD}<resources><colorgroup id=\"9\"/>\
         <object id=\"1\">{mesh}</object>\
         <object id=\"2\"><components><component objectid=\"1\"/>\
         <component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 -2 0 0\"/>\
         <component p:path=\"/3D/o/a.model\" objectid=\"1\" transform=\"2 0 0 0 3 0 0 0 4 0 0 9\"/>\
         </components></object></resources><build>\
         <item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 100 0 0\"/></build></model>\
         <?model /3D/o/a.model?>{HEAD}<resources><object id=\"1\">{mesh}</object></resources>\
         <build><item objectid=\"1\"/></build></model>"
    )
}

#[test]
fn components_are_put_in_place() {
    let bytes = assembly().into_bytes();
    let read = umbilic::io::read(&bytes, "").unwrap();
    let soup = &read.soup;
    assert_eq!((soup.positions.len(), soup.n_faces()), (24, 36));
    // The corner (1, 1, 1) of each, then turned about z: (x, y) to (100 − y, x).
    let corner = |part: usize| soup.positions[8 * part + 7];
    assert_eq!(corner(0), DVec3::new(99.0, 1.0, 1.0));
    assert_eq!(corner(1), DVec3::new(99.0, -3.0, 1.0));
    assert_eq!(corner(2), DVec3::new(97.0, 2.0, 13.0));
    for (part, expected) in [1.0, 1.0, 24.0].into_iter().enumerate() {
        let volume: f64 = (12 * part..12 * part + 12)
            .map(|f| [0, 1, 2].map(|k| soup.positions[soup.face(f)[k] as usize] - corner(part)))
            .map(|[a, b, c]| a.dot(b.cross(c)) / 6.0)
            .sum();
        assert!((volume - expected).abs() < 1e-9, "{part}: {volume}");
    }
    let what = vec![Extra::Colours];
    assert_eq!(oddities(&bytes), [Oddity::LeftOut { what }]);
}

#[test]
fn damage_is_named_where_it_is() {
    let text = assembly();
    for (from, to) in [
        ("v1=\"0\"", "v1=\"8\""),
        ("v1=\"0\"", "v1=\"-1\""),
        ("v1=\"0\"", "v1=\"x\""),
        ("v1=\"0\"", ""),
        ("x=\"0.0\"", "x=\"0,5\""),
        ("x=\"0.0\"", "x=\"nan\""),
        ("item objectid=\"2\"", "item objectid=\"7\""),
        ("component objectid=\"1\"", "component objectid=\"2\""),
        ("p:path=\"/3D/o/a.model\"", "p:path=\"/3D/o/b.model\""),
        ("100 0 0", "100 0"),
        ("100 0 0", "100 0 0 0"),
        ("100 0 0", "100 0 inf"),
    ] {
        assert!(text.contains(from), "{from}");
        let detail = refusal(text.replacen(from, to, 1).as_bytes()).detail();
        assert_eq!(detail.first().map(|(name, _)| *name), Some("line"), "{to}");
    }
    // Its end is missing, not a model.
    let (cut, _) = text.split_once("<build>").expect("a list");
    let detail = refusal(cut.as_bytes()).detail();
    assert_eq!(detail.first().map(|(name, _)| *name), Some("line"));
    let bytes = file(&cube(0.0, 1.0), "", "\n", ITEM);
    is_refused_wherever_it_ends(&bytes, 1, bytes.len() - "</build></model>".len());
}

#[test]
fn a_small_file_cannot_ask_for_much_memory() {
    // Each object is twice the one before.
    let mut objects = format!("<object id=\"0\">{}</object>", mesh(&cube(0.0, 1.0), "\n"));
    for k in 1..31 {
        let half = format!("<component objectid=\"{}\"/>", k - 1);
        objects += &format!("<object id=\"{k}\"><components>{half}{half}</components></object>");
    }
    let text = format!("{HEAD}{objects}<build><item objectid=\"30\"/></build></model>");
    let error = refusal(text.as_bytes());
    assert!(
        matches!(error, ReadError::CountTooLarge { what: "bytes", .. }),
        "{error}"
    );
    let empty = text.replace("<vertex", "<no").replace("<triangle", "<no");
    let error = refusal(empty.as_bytes());
    assert!(
        matches!(error, ReadError::CountTooLarge { what: "bytes", .. }),
        "{error}"
    );
}

#[test]
fn what_no_list_builds_is_read_where_it_is() {
    let soup = cube(0.0, 1.0);
    let read = umbilic::io::read(&file(&soup, "", "\n", ""), "").expect("a mesh");
    assert_eq!(read.soup, plain(&file(&soup, "", "\n", ITEM), ""));
    assert_eq!(read.warnings, [Oddity::NothingToBuild]);
    // What is a part of another is not read twice.
    let whole = "<object id=\"5\"><components><component objectid=\"4\"/></components></object>";
    let text = String::from_utf8(file(&soup, "", "\n", "")).expect("text");
    let text = text.replace("</resources>", &format!("{whole}</resources>"));
    let again = umbilic::io::read(text.as_bytes(), "").expect("a mesh");
    assert_eq!(again, read);
}
