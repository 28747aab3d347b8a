//! The mesh among files that are opened together, out of archives that are made here; damaged
//! archives, and archives of what would be too large, are refused.

use flate2::Compression;
use flate2::write::{DeflateEncoder, GzEncoder};
use rawzip::{CompressionMethod, ZipArchiveWriter};
use std::io::Write;
use umbilic::io::packed::{File, Found, UnpackError, mesh_among};

const MESH: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

fn gzip(plain: impl AsRef<[u8]>) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(plain.as_ref()).unwrap();
    encoder.finish().unwrap()
}

fn zip_by(method: CompressionMethod, files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut archive = ZipArchiveWriter::new(Vec::new());
    for (name, plain) in files {
        let entry = archive.new_file(name).compression_method(method);
        let (mut entry, config) = entry.start().unwrap();
        let descriptor = if method == CompressionMethod::DEFLATE {
            let mut writer = config.wrap(DeflateEncoder::new(&mut entry, Compression::best()));
            writer.write_all(plain).unwrap();
            let (encoder, descriptor) = writer.finish().unwrap();
            encoder.finish().unwrap();
            descriptor
        } else {
            let mut writer = config.wrap(&mut entry);
            writer.write_all(plain).unwrap();
            writer.finish().unwrap().1
        };
        entry.finish(descriptor).unwrap();
    }
    archive.finish().unwrap()
}

fn zip(files: &[(&str, &[u8])]) -> Vec<u8> {
    zip_by(CompressionMethod::DEFLATE, files)
}

/// Sound files of each kind, for the fuzzer.
pub(crate) fn variants() -> Vec<Vec<u8>> {
    let mesh = MESH.as_bytes();
    let one: &[(&str, &[u8])] = &[("a.obj", mesh)];
    let scene = br#"{"buffers":[{"uri":"a.bin"}]}"#;
    vec![
        gzip(mesh),
        [gzip(mesh), gzip(mesh)].concat(),
        zip(one),
        zip_by(CompressionMethod::STORE, one),
        zip(&[("a.obj.gz", &gzip(mesh)), ("b.ply", mesh)]),
        zip(&[("a.gltf", scene), ("a.bin", mesh)]),
        zip(&[("3D/a.model", mesh), ("3D/3dmodel.model", b"<m/>")]),
        gzip(zip(one)),
    ]
}

fn among(files: &[(&str, &[u8])]) -> Result<Found, UnpackError> {
    let file = |(name, bytes): &(&str, &[u8])| File {
        name: (*name).to_owned(),
        bytes: bytes.to_vec().into(),
    };
    mesh_among(&files.iter().map(file).collect::<Vec<_>>())
}

fn text(found: Result<Found, UnpackError>) -> String {
    String::from_utf8(found.unwrap().bytes).unwrap()
}

#[test]
fn a_mesh_is_found_in_gzip_in_zip_in_both_and_among_several_files() {
    let mesh = MESH.as_bytes();
    let one = &[("a.obj", mesh)];
    let long = "x".repeat(999);
    let cases: &[&[(&str, &[u8])]] = &[
        one,
        &[("a.obj.gz", &gzip(mesh))],
        &[("A.OBJ.GZ", &gzip(mesh))],
        &[("a.obj.gz", &[gzip(&mesh[..9]), gzip(&mesh[9..])].concat())],
        &[("b.zip", &zip(one))],
        &[("b.zip", &zip_by(CompressionMethod::STORE, one))],
        &[(
            "b.zip",
            &zip(&[
                ("deep/er/a.obj", mesh),
                ("deep/a.mtl", b"x"),
                ("deep/a.png", b"y"),
            ]),
        )],
        &[("b.zip", &zip(&[("deep\\a.obj", mesh), ("read.txt", b"x")]))],
        &[(
            "b.zip",
            &zip(&[("a.OBJ.gz", &gzip(mesh)), ("read.txt", b"x")]),
        )],
        &[("b.zip.gz", &gzip(zip(one)))],
        &[(
            "b.zip",
            &zip(&[
                ("__MACOSX/._a.obj", long.as_bytes()),
                ("a.obj", mesh),
                (".c.obj", b"y"),
            ]),
        )],
        &[("a.mtl", b"x"), ("a.obj", mesh), ("a.png", b"y")],
        &[("a.mtl", b"x"), ("a.zip", &zip(one))],
    ];
    for files in cases {
        let found = among(files).unwrap();
        assert_eq!(found.bytes, mesh, "{:?}", files[0].0);
        assert_eq!(found.name.to_ascii_lowercase(), "a.obj");
        assert!(found.others.is_empty());
    }
    // What has no ending that says so is left to whoever reads it.
    assert_eq!(among(&[("some.txt", mesh)]).unwrap().name, "some.txt");
    let inside = zip(&[("some.txt", mesh)]);
    assert_eq!(text(among(&[("b.zip", &inside)])), MESH);
    let several = zip(&[("x/a.obj", mesh), ("b.ply", b"ply"), ("c.off", b"OFF")]);
    let found = among(&[("b.zip", &several)]).unwrap();
    assert_eq!(found.name, "a.obj");
    assert_eq!(found.others, ["b.ply", "c.off"]);
    // Of those of one size the first.
    let found = among(&[("a.off", b"OFF"), ("b.ply", b"ply")]).unwrap();
    assert_eq!(
        (found.name.as_str(), found.others.as_slice()),
        ("a.off", &["b.ply".to_owned()][..])
    );
}

#[test]
fn the_models_of_a_3mf_package_are_put_after_each_other_the_first_in_front() {
    let one = zip(&[("[Content_Types].xml", b"x"), ("3D/3dmodel.model", b"<m/>")]);
    let found = among(&[("a.3mf", &one)]);
    assert_eq!(found.as_ref().unwrap().name, "a.3mf");
    assert_eq!(text(found), "<m/>");
    let two = zip(&[
        ("3D/Objects/o_1.model", b"<o/>"),
        ("3D/3dmodel.model", b"<m/>"),
    ]);
    assert_eq!(
        text(among(&[("a.3mf", &two)])),
        "<?model /3D/3dmodel.model?>\n<m/>\n<?model /3D/Objects/o_1.model?>\n<o/>\n"
    );
    // Wherever the package says that its model is.
    let relations = br#"<Relationships><Relationship Target="/a.png" Type="x/thumbnail"/>
        <Relationship Id='r' Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'
        Target='/Models/Main.model'/></Relationships>"#;
    let elsewhere = zip(&[
        ("parts/o.model", b"<o/>"),
        ("models/main.model", b"<m/>"),
        ("_rels/.rels", relations),
    ]);
    let found = among(&[("b.zip", &elsewhere)]);
    assert_eq!(found.as_ref().unwrap().name, "b.3mf");
    assert_eq!(
        text(found),
        "<?model /models/main.model?>\n<m/>\n<?model /parts/o.model?>\n<o/>\n"
    );
}

#[test]
fn a_gltf_file_gets_the_buffers_beside_it() {
    let scene = br#"{"buffers":[{"uri":"the%20mesh.bin"},{"uri":"data:x"},{}]}"#;
    let bytes: Vec<u8> = (0..1001_u32).map(|k| (k % 251) as u8).collect();
    let inside = zip(&[
        ("x/a.gltf", scene),
        ("x/the mesh.bin", &bytes),
        ("the mesh.bin", b"no"),
    ]);
    let cases: [&[(&str, &[u8])]; 2] = [
        &[("a.gltf", scene), ("the mesh.bin", &bytes)],
        &[("a.zip", &inside)],
    ];
    for files in cases {
        let found = among(files).unwrap();
        assert_eq!(found.name, "a.gltf");
        let scene: serde_json::Value = serde_json::from_slice(&found.bytes).unwrap();
        let uri = scene["buffers"][0]["uri"].as_str().unwrap();
        let data = uri
            .strip_prefix("data:application/octet-stream;base64,")
            .unwrap();
        assert_eq!(data.len(), 1001_usize.div_ceil(3) * 4);
        assert!(data.starts_with("AAECAwQF"), "{}", &data[..8]);
        assert_eq!(scene["buffers"][1]["uri"], "data:x");
    }
    assert_eq!(text(among(&[("a.gltf", b"{")])), "{");
}

/// An archive of one file, whose entry in the list is changed at a place by these bytes.
fn changed(at: usize, by: &[u8], content: &[u8]) -> Result<Found, UnpackError> {
    let mut bytes = zip(&[("a.obj", content)]);
    let list = bytes
        .windows(4)
        .rposition(|four| four == b"PK\x01\x02")
        .unwrap();
    bytes[list + at..list + at + by.len()].copy_from_slice(by);
    among(&[("b.zip", &bytes)])
}

#[test]
fn damaged_archives_are_refused_wherever_the_damage_is() {
    let mesh = MESH.repeat(20);
    let packed = gzip(&mesh);
    assert_eq!(among(&[("a.gz", &packed[..20])]), Err(UnpackError::Damaged));
    let whole = zip(&[("a.obj", mesh.as_bytes())]);
    for end in 4..whole.len() {
        let outcome = among(&[("b.zip", &whole[..end])]);
        assert_eq!(outcome, Err(UnpackError::Damaged), "cut after {end}");
    }
    let mut refused = 0;
    for at in 4..whole.len() {
        let mut bytes = whole.clone();
        bytes[at] ^= 0x10;
        match among(&[("b.zip", &bytes)]) {
            // A name, a date or a comment may be another; what is in the file may not.
            Ok(found) => assert_eq!(found.bytes, mesh.as_bytes(), "byte {at}"),
            Err(_) => refused += 1,
        }
    }
    assert!(refused > whole.len() / 4, "{refused} of {}", whole.len());
    let mesh = MESH.as_bytes();
    assert_eq!(changed(8, &[1, 0], mesh), Err(UnpackError::Encrypted));
    let method = UnpackError::Unsupported { method: 14 };
    assert_eq!(changed(10, &[14, 0], mesh), Err(method));
    assert_eq!(changed(16, &[7, 0, 0, 0], mesh), Err(UnpackError::Damaged));
    assert_eq!(
        changed(42, &[0, 0, 0, 0x40], mesh),
        Err(UnpackError::Damaged)
    );
    let names = |names: &[&str]| UnpackError::NoMesh {
        names: names.iter().map(|name| (*name).to_owned()).collect(),
    };
    let texts = zip(&[("a.txt", b"x"), ("b.txt", b"y")]);
    assert_eq!(among(&[("b.zip", &texts)]), Err(names(&["a.txt", "b.txt"])));
    assert_eq!(among(&[("b.zip", &zip(&[]))]), Err(names(&[])));
}

#[test]
fn what_would_be_too_large_is_refused_before_it_is_there() {
    let is_too_large = |outcome| matches!(outcome, Err(UnpackError::TooLarge { .. }));
    // 40 MB of blanks in 40 kB.
    let bomb = vec![b' '; 40_000_000];
    assert!(is_too_large(among(&[("a.obj.gz", &gzip(&bomb))])));
    assert!(is_too_large(among(&[("b.zip", &zip(&[("a.obj", &bomb)]))])));
    // The same that says it were small: no more than that is unpacked.
    assert!(is_too_large(changed(24, &[0xe8, 3, 0, 0], &bomb)));
    assert!(is_too_large(changed(24, &[7, 0, 0, 0], MESH.as_bytes())));
}
