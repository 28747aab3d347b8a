//! Broken files, from opening to undo: what a repair would do is known before, what it did is
//! listed, and what comes of it is a surface.

use crate::support::shared_folder;
use serde_json::json;
use std::fmt::Write as _;
use umbilic::app::{
    Edit, Info, Loaded, Origin, RepairItem, RepairOptions, RunCommand, ScriptText, Session,
};
use umbilic::flow::option::Values;
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;
use umbilic::io::Format;
use umbilic::message::Value;
use umbilic::remesh::repair::Weld;

/// Positions and faces, vertices counted from 0.
#[derive(Clone, Default)]
struct Soup {
    x: Vec<[f64; 3]>,
    faces: Vec<Vec<usize>>,
}

impl Soup {
    fn obj(&self) -> Vec<u8> {
        let mut text = String::new();
        for [x, y, z] in &self.x {
            let _ = writeln!(text, "v {x:?} {y:?} {z:?}");
        }
        for face in &self.faces {
            let corners: Vec<String> = face.iter().map(|v| (v + 1).to_string()).collect();
            let _ = writeln!(text, "f {}", corners.join(" "));
        }
        text.into_bytes()
    }

    /// A sphere of rings, with poles.
    fn sphere(rings: usize, around: usize) -> Self {
        let mut soup = Self::default();
        soup.x.push([0.0, 0.0, 1.0]);
        for ring in 1..rings {
            let theta = std::f64::consts::PI * ring as f64 / rings as f64;
            for n in 0..around {
                let phi = std::f64::consts::TAU * n as f64 / around as f64;
                let (sin, z) = theta.sin_cos();
                soup.x.push([sin * phi.cos(), sin * phi.sin(), z]);
            }
        }
        soup.x.push([0.0, 0.0, -1.0]);
        let last = soup.x.len() - 1;
        let at = |ring: usize, n: usize| match ring {
            0 => 0,
            r if r == rings => last,
            r => 1 + (r - 1) * around + n % around,
        };
        for ring in 0..rings {
            for n in 0..around {
                let [a, b] = [at(ring, n), at(ring, n + 1)];
                let [c, d] = [at(ring + 1, n), at(ring + 1, n + 1)];
                if ring > 0 {
                    soup.faces.push(vec![a, c, b]);
                }
                if ring + 1 < rings {
                    soup.faces.push(vec![b, c, d]);
                }
            }
        }
        soup
    }

    /// An axis-aligned box of squares, `n` along each edge.
    fn cube(n: usize) -> Self {
        let mut soup = Self::default();
        let mut names = std::collections::HashMap::new();
        for axis in 0..3 {
            for side in [0, n] {
                for i in 0..n {
                    for j in 0..n {
                        let mut corner = |i: usize, j: usize| {
                            let mut at = [0; 3];
                            at[axis] = side;
                            at[(axis + 1) % 3] = i;
                            at[(axis + 2) % 3] = j;
                            *names.entry(at).or_insert_with(|| {
                                soup.x.push(at.map(|c| c as f64 / n as f64));
                                soup.x.len() - 1
                            })
                        };
                        let mut quad = [
                            corner(i, j),
                            corner(i + 1, j),
                            corner(i + 1, j + 1),
                            corner(i, j + 1),
                        ];
                        if side == 0 {
                            quad.reverse();
                        }
                        soup.faces.push(vec![quad[0], quad[1], quad[2]]);
                        soup.faces.push(vec![quad[0], quad[2], quad[3]]);
                    }
                }
            }
        }
        soup
    }
}

/// Numbers that look random, the same every time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, n: usize) -> usize {
        ((self.next() * n as f64) as usize).min(n - 1)
    }
}

/// Ten of a kind: other meshes, sizes and places.
fn variants(mut each: impl FnMut(&mut Soup, &mut Random), mut check: impl FnMut(&[u8], usize)) {
    for n in 0..10 {
        let mut random = Random(17 * n + 1);
        let mut soup = match n % 3 {
            0 => Soup::cube(2 + n as usize / 2),
            _ => Soup::sphere(6 + n as usize, 7 + n as usize),
        };
        each(&mut soup, &mut random);
        let scale = 10f64.powi([0, -6, 6, -3, 3, 1, -1, 5, -5, 0][n as usize]);
        let far = [0.0, 0.0, 1.0, 50.0, 0.1, 5e5, 3.0, 5.0, 0.0, 5e6][n as usize] * scale;
        for p in &mut soup.x {
            *p = p.map(|c| c * scale + far);
        }
        check(&soup.obj(), n as usize);
    }
}

fn open(bytes: &[u8]) -> (Session, Info) {
    let mut session = Session::new();
    let loaded = session.load(bytes, "a.obj").expect("a surface");
    (session, loaded.info)
}

fn repaired(bytes: &[u8], weld: Weld) -> (Session, Loaded) {
    let mut session = Session::new();
    let loaded = session
        .load_repaired(bytes, "a.obj", RepairOptions { weld })
        .expect("repaired");
    (session, loaded)
}

fn kinds(items: &[RepairItem]) -> Vec<(&'static str, usize)> {
    items.iter().map(|item| (item.kind, item.count)).collect()
}

fn is_sphere(info: &Info) -> bool {
    info.closed && info.components == 1 && info.genus == Some(0) && info.oriented
}

/// Repaired, written, and read back, it is whole: nothing is left to repair.
fn stays_whole(session: &Session, name: &str) {
    for format in [Format::Obj, Format::Ply] {
        let bytes = session.export(format).expect("a file");
        let (_, info) = open(&bytes);
        assert_eq!(kinds(&info.repairs), [], "{name}");
    }
}

/// The bytes are a broken sphere: told beforehand, whole after.
fn becomes_sphere(bytes: &[u8], kind: &str, name: usize) {
    let (mut session, before) = open(bytes);
    let told: Vec<_> = before.repairs.iter().filter(|item| !item.done).collect();
    assert!(
        told.iter().any(|item| item.kind == kind),
        "{name}: {told:?}"
    );
    let x = session.positions().expect("positions");
    let loaded = session.repair(RepairOptions::default()).expect("repaired");
    assert!(is_sphere(&loaded.info), "{name}: {:?}", loaded.info);
    assert_eq!(
        kinds(&loaded.repaired),
        told.iter().map(|i| (i.kind, i.count)).collect::<Vec<_>>(),
        "what was told is what was done"
    );
    for item in &loaded.repaired {
        assert!(
            item.vertices
                .0
                .iter()
                .all(|v| (*v as usize) < loaded.info.vertices)
        );
    }
    stays_whole(&session, kind);
    session.undo_edit().expect("undone");
    assert_eq!(session.positions().expect("positions"), x);
    let again = session.info().expect("a mesh");
    assert_eq!(
        (again.vertices, again.faces),
        (before.vertices, before.faces)
    );
    let (_, loaded) = repaired(bytes, Weld::Auto);
    assert!(is_sphere(&loaded.info), "{name}");
}

/// The bytes are no surface: refused with an offer that helps.
fn is_refused_and_repaired(bytes: &[u8], kind: &str, name: usize) -> (Session, Loaded) {
    let mut session = Session::new();
    let fault = session.load(bytes, "a.obj").expect_err("no surface");
    assert_eq!(fault.kind, "NonManifoldEdge", "{name}");
    assert!(
        fault.repairs.iter().any(|i| i.kind == kind),
        "{name}: {:?}",
        fault.repairs
    );
    // What was made for the offer is what a session that knows nothing of it makes.
    let options = RepairOptions::default();
    let offered = session.load_repaired(bytes, "a.obj", options);
    let (other, loaded) = repaired(bytes, Weld::Auto);
    assert!(offered.expect("repaired") == loaded, "{name}");
    assert!(session.provenance() == other.provenance(), "{name}");
    assert_eq!(kinds(&loaded.repaired), kinds(&fault.repairs), "{name}");
    stays_whole(&session, kind);
    (session, loaded)
}

/// An offer is of the file that was refused, and of no other, nor of another repair.
#[test]
fn an_offer_is_taken_for_no_other_file() {
    let finned = |rings| {
        let mut soup = Soup::sphere(rings, 9);
        soup.x.push([2.0, 2.0, 2.0]);
        soup.faces.push(vec![0, 1, soup.x.len() - 1]);
        soup.obj()
    };
    let mut session = Session::new();
    session.load(&finned(7), "a.obj").expect_err("no surface");
    let options = RepairOptions::default();
    let loaded = session.load_repaired(&finned(8), "a.obj", options);
    let own = repaired(&finned(8), Weld::Auto).1;
    assert!(loaded.expect("repaired") == own);
    session.load(&finned(7), "a.obj").expect_err("no surface");
    let weld = Weld::Within(0.3);
    let loaded = session.load_repaired(&finned(7), "a.obj", RepairOptions { weld });
    assert!(loaded.expect("repaired") == repaired(&finned(7), weld).1);
}

fn torn(soup: &mut Soup, face: usize) {
    for n in 0..soup.faces[face].len() {
        let v = soup.faces[face][n];
        soup.x.push(soup.x[v]);
        soup.faces[face][n] = soup.x.len() - 1;
    }
}

#[test]
fn a_heap_of_triangles_becomes_a_surface() {
    variants(
        |soup, _| (0..soup.faces.len()).for_each(|f| torn(soup, f)),
        |bytes, n| becomes_sphere(bytes, "Welded", n),
    );
}

#[test]
fn a_seam_is_welded() {
    // Faces of one side have vertices of their own.
    variants(
        |soup, random| {
            let level = 0.2 + 0.6 * random.next();
            let copies: Vec<usize> = (0..soup.x.len()).collect();
            let (n, x) = (soup.x.len(), soup.x.clone());
            soup.x.extend(copies.iter().map(|v| x[*v]));
            for face in &mut soup.faces {
                let middle: f64 = face.iter().map(|v| x[*v][0]).sum::<f64>() / 3.0;
                if middle < level {
                    face.iter_mut().for_each(|v| *v += n);
                }
            }
        },
        |bytes, n| becomes_sphere(bytes, "Welded", n),
    );
}

#[test]
fn a_vertex_on_an_edge_is_inserted() {
    variants(
        |soup, random| {
            let f = random.below(soup.faces.len());
            let [a, b, c] = [0, 1, 2].map(|i| soup.faces[f][i]);
            let middle: [f64; 3] = std::array::from_fn(|i| 0.5 * (soup.x[a][i] + soup.x[b][i]));
            soup.x.push(middle);
            let m = soup.x.len() - 1;
            soup.faces[f] = vec![a, m, c];
            soup.faces.push(vec![m, b, c]);
        },
        |bytes, n| becomes_sphere(bytes, "Inserted", n),
    );
}

#[test]
fn a_triangle_of_collinear_corners_is_dropped() {
    variants(
        |soup, random| {
            let f = random.below(soup.faces.len());
            let [a, b, c] = [0, 1, 2].map(|i| soup.faces[f][i]);
            let middle: [f64; 3] = std::array::from_fn(|i| 0.5 * (soup.x[a][i] + soup.x[b][i]));
            soup.x.push(middle);
            let m = soup.x.len() - 1;
            soup.faces[f] = vec![a, m, c];
            soup.faces.push(vec![m, b, c]);
            soup.faces.push(vec![a, b, m]);
        },
        |bytes, n| {
            // Far off the middle is beside the edge by rounding, and the triangle has an area.
            if n < 5 || n == 8 {
                becomes_sphere(bytes, "FlatFaces", n);
            }
        },
    );
}

#[test]
fn an_edge_without_length_is_collapsed() {
    // A vertex becomes two at the same place, joined by an edge with two faces.
    variants(
        |soup, random| {
            let v = soup.faces[random.below(soup.faces.len())][0];
            let star: Vec<usize> = (0..soup.faces.len())
                .filter(|f| soup.faces[*f].contains(&v))
                .collect();
            // Around it in order, each face given by the edge across from it.
            let across = |f: usize| {
                let face = &soup.faces[f];
                let n = face.iter().position(|c| *c == v).expect("a corner");
                (face[(n + 1) % 3], face[(n + 2) % 3])
            };
            let mut ring = vec![across(star[0])];
            while ring.len() < star.len() {
                let end = ring[ring.len() - 1].1;
                let next = star.iter().map(|f| across(*f)).find(|(a, _)| *a == end);
                ring.push(next.expect("a closed star"));
            }
            soup.x.push(soup.x[v]);
            let w = soup.x.len() - 1;
            let half = ring.len() / 2;
            let far: Vec<(usize, usize)> = ring[..half].to_vec();
            for face in &mut soup.faces {
                if let Some(n) = face.iter().position(|c| *c == v)
                    && far.contains(&(face[(n + 1) % 3], face[(n + 2) % 3]))
                {
                    face[n] = w;
                }
            }
            let (p, q) = (ring[0].0, ring[half].0);
            soup.faces.push(vec![v, w, p]);
            soup.faces.push(vec![w, v, q]);
        },
        |bytes, n| becomes_sphere(bytes, "CollapsedEdges", n),
    );
}

#[test]
fn a_fin_is_dropped() {
    variants(
        |soup, random| {
            let f = random.below(soup.faces.len());
            let [a, b] = [0, 1].map(|i| soup.faces[f][i]);
            soup.x.push([3.0, 2.5, 2.0 + random.next()]);
            soup.faces.push(vec![a, b, soup.x.len() - 1]);
        },
        |bytes, n| {
            let (_, loaded) = is_refused_and_repaired(bytes, "Fins", n);
            assert!(is_sphere(&loaded.info), "{n}");
        },
    );
}

#[test]
fn an_inner_wall_goes() {
    variants(
        |soup, _| {
            // A lid across a ring of edges: of the cube its waist, of a sphere the ring about a pole.
            let ring: Vec<usize> = match soup.x[0] {
                [0.0, 0.0, 1.0] => {
                    let pole: Vec<&Vec<usize>> =
                        soup.faces.iter().filter(|face| face.contains(&0)).collect();
                    (1..=pole.len()).collect()
                }
                _ => {
                    let f = &soup.faces[0];
                    let g = &soup.faces[1];
                    vec![f[0], f[1], f[2], g[2]]
                }
            };
            soup.x.push(if ring.len() == 4 {
                [0.5, 0.4, 0.3]
            } else {
                [0.0, 0.0, 0.1]
            });
            let tip = soup.x.len() - 1;
            for n in 0..ring.len() {
                soup.faces
                    .push(vec![ring[n], ring[(n + 1) % ring.len()], tip]);
            }
        },
        |bytes, n| {
            let (_, loaded) = is_refused_and_repaired(bytes, "Walls", n);
            let Info {
                components,
                genus,
                closed,
                ..
            } = loaded.info;
            assert_eq!((components, genus, closed), (1, Some(0), true), "{n}");
        },
    );
}

#[test]
fn bodies_that_share_an_edge_become_two() {
    variants(
        |soup, random| {
            let f = random.below(soup.faces.len());
            let [a, b] = [0, 1].map(|i| soup.faces[f][i]);
            let n = soup.x.len();
            let (p, q) = (soup.x[a], soup.x[b]);
            // Turned about the middle of the edge.
            let turned = |x: &[f64; 3]| std::array::from_fn(|i| p[i] + q[i] - x[i]);
            let copies: Vec<[f64; 3]> = soup.x.iter().map(turned).collect();
            soup.x.extend(copies);
            let name = |v: usize| match v {
                v if v == a => b,
                v if v == b => a,
                v => v + n,
            };
            let mut copies: Vec<Vec<usize>> = soup
                .faces
                .iter()
                .map(|face| face.iter().rev().map(|v| name(*v)).collect())
                .collect();
            // A turn by a point turns a surface inside out.
            copies.truncate(soup.faces.len());
            soup.faces.extend(copies);
        },
        |bytes, n| {
            let (_, loaded) = is_refused_and_repaired(bytes, "CutEdges", n);
            assert!(
                loaded.info.closed && loaded.info.components == 2,
                "{n}: {:?}",
                loaded.info
            );
        },
    );
}

#[test]
fn what_opening_does_is_listed_too() {
    // Twice the same face, a corner repeated, a vertex of no face, faces that disagree.
    let mut soup = Soup::sphere(7, 9);
    let twice = soup.faces[3].clone();
    soup.faces.push(twice);
    soup.faces.push(vec![4, 4, 5]);
    soup.faces[10].reverse();
    soup.x.push([9.0, 9.0, 9.0]);
    let (_, info) = open(&soup.obj());
    let expected = [
        ("DegenerateFaces", 1),
        ("DuplicateFaces", 1),
        ("TurnedFaces", 1),
        ("UnusedVertices", 1),
    ];
    assert_eq!(kinds(&info.repairs), expected);
    assert!(info.repairs.iter().all(|item| item.done));
    let (session, loaded) = repaired(&soup.obj(), Weld::Auto);
    assert_eq!(kinds(&loaded.repaired), expected);
    assert!(is_sphere(&loaded.info) && !session.can_undo_edit());
    // Bodies that meet in a vertex.
    let mut two = Soup::sphere(7, 9);
    let n = two.x.len();
    let copies: Vec<[f64; 3]> = two.x.iter().map(|[x, y, z]| [*x, *y, z + 2.0]).collect();
    two.x.extend(copies);
    let faces = two.faces.clone();
    for face in faces {
        let name = |v: &usize| if *v == n - 1 { 0 } else { v + n };
        two.faces.push(face.iter().map(name).collect());
    }
    let (_, loaded) = repaired(&two.obj(), Weld::Auto);
    let found = kinds(&loaded.repaired);
    assert!(found.contains(&("SplitVertices", 1)), "{found:?}");
    assert_eq!(loaded.info.components, 2);
}

#[test]
fn a_gap_is_closed_only_when_asked_for() {
    let mut soup = Soup::sphere(9, 12);
    let (n, x) = (soup.x.len(), soup.x.clone());
    soup.x.extend(x.iter().map(|[x, y, z]| [*x, *y, z + 1e-3]));
    for face in &mut soup.faces {
        if face.iter().map(|v| x[*v][2]).sum::<f64>() > 0.0 {
            face.iter_mut().for_each(|v| *v += n);
        }
    }
    let bytes = soup.obj();
    let (_, info) = open(&bytes);
    assert!(info.repairs.iter().all(|item| item.done) && !info.closed);
    let (_, loaded) = repaired(&bytes, Weld::Auto);
    assert!(!loaded.info.closed);
    let (_, loaded) = repaired(&bytes, Weld::Within(2e-3));
    assert!(is_sphere(&loaded.info), "{:?}", loaded.info);
    let (_, loaded) = repaired(&bytes, Weld::Off);
    assert!(!loaded.info.closed);
}

#[test]
fn a_repair_is_part_of_a_recipe_and_selections_go_with_their_vertices() {
    let mut soup = Soup::sphere(7, 9);
    soup.x.push([2.0, 2.0, 2.0]);
    soup.faces.push(vec![0, 1, soup.x.len() - 1]);
    let (bytes, name) = (soup.obj(), "fin.obj");
    let (mut session, _) = repaired(&bytes, Weld::Auto);
    let options = FlowOptions {
        flow: FlowName::MeanCurvature,
        ..FlowOptions::default()
    };
    session.configure(options).expect("configured");
    session.run(2).expect("steps");
    let edits = session.provenance().expect("known").edits;
    assert!(matches!(edits[..], [ref first] if matches!(first.edit, Edit::Repair(_))));
    let origin = Origin::File {
        name: "fin".into(),
        file: Some(name.into()),
        sha256: Some(digest(&bytes)),
        bytes: Some(bytes.len()),
    };
    let text = session.write_recipe(Some(&origin)).expect("a recipe");
    let script = ScriptText::Recipe(text.clone());
    let mut again = Session::new();
    again
        .prepare(&script, Some((bytes.clone(), name.into())))
        .expect("prepared");
    while !again.advance().expect("made").is_done {}
    let card = again.read_recipe(&text).expect("a card");
    again.configure(card.flow).expect("configured");
    again.follow(&script).expect("followed");
    while !again.advance().expect("steps").is_done {}
    assert!(again.compare_recipe(&text).expect("compared").same);

    // A vertex on an edge of the first face; the corners of the last are free.
    let mut soup = Soup::sphere(7, 9);
    let [a, b, c] = [0, 1, 2].map(|i| soup.faces[0][i]);
    let middle: [f64; 3] = std::array::from_fn(|i| 0.5 * (soup.x[a][i] + soup.x[b][i]));
    soup.x.push(middle);
    let m = soup.x.len() - 1;
    soup.faces[0] = vec![a, m, c];
    soup.faces.push(vec![m, b, c]);
    torn(&mut soup, 20);
    let (mut session, _) = open(&soup.obj());
    let triangles = session.loaded().expect("a mesh").triangles.0;
    let free = triangles[triangles.len() - 6..triangles.len() - 3].to_vec();
    let options = FlowOptions {
        flow: FlowName::MeanCurvature,
        free: Some(free.clone()),
        ..FlowOptions::default()
    };
    session.configure(options).expect("configured");
    let before = session.positions().expect("positions");
    let loaded = session.repair(RepairOptions::default()).expect("repaired");
    let chosen = free;
    let free = loaded.free.expect("a selection").0;
    let at = |x: &[f32], v: u32| x[3 * v as usize..3 * v as usize + 3].to_vec();
    let were: Vec<Vec<f32>> = chosen.iter().map(|v| at(&before, *v)).collect();
    assert_eq!(free.len(), 3, "{free:?}");
    assert!(
        free.iter()
            .all(|v| were.contains(&at(&loaded.positions.0, *v)))
    );
}

fn digest(bytes: &[u8]) -> String {
    use sha2::{Digest, Sha256};
    let digest = Sha256::digest(bytes);
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[test]
fn the_message_counts_as_the_file_does() {
    let mut soup = Soup::sphere(7, 9);
    soup.x.push([2.0, 2.0, 2.0]);
    soup.faces.push(vec![0, 1, soup.x.len() - 1]);
    let fault = Session::new()
        .load(&soup.obj(), "a.obj")
        .expect_err("refused");
    let number = |name| fault.message.number(name);
    assert_eq!(
        (number("a"), number("b"), number("first")),
        (Some(1.0), Some(2.0), Some(1.0))
    );
    assert_eq!(fault.detail["vertices"], [0.0, 1.0]);
}

/// Name, vertices, edges, faces, and what is found before.
#[test]
fn files_that_people_brought_become_surfaces() {
    let Some(folder) = shared_folder("cases/files") else {
        return;
    };
    let rows = [
        ("obj_uvseam_pole.obj", 114, 336, 224, "Welded"),
        ("stl_unwelded_noise.stl", 162, 480, 320, "Welded"),
        ("fin.obj", 162, 480, 320, "Fins"),
        ("zero_area.obj", 163, 483, 322, "FlatFaces"),
        ("slit.obj", 642, 1920, 1280, "Welded"),
    ];
    for (name, vertices, edges, faces, kind) in rows {
        let bytes = std::fs::read(folder.join(name)).expect("a file");
        let mut session = Session::new();
        let loaded = session
            .load_repaired(&bytes, name, RepairOptions::default())
            .expect("repaired");
        let info = &loaded.info;
        let counts = (info.vertices, info.edges, info.faces);
        assert_eq!(
            counts,
            (vertices, edges, faces),
            "{name}: {:?}",
            loaded.repaired
        );
        assert!(is_sphere(info), "{name}");
        assert!(
            loaded.repaired.iter().any(|i| i.kind == kind),
            "{name}: {:?}",
            loaded.repaired
        );
        stays_whole(&session, name);
    }
    let bytes = std::fs::read(folder.join("tjunction.obj")).expect("a file");
    let (_, loaded) = repaired(&bytes, Weld::Auto);
    let Info {
        closed,
        area,
        volume,
        ..
    } = loaded.info;
    assert!(closed && (area - 6.0).abs() < 1e-12, "{area}");
    assert!((volume.expect("closed") - 1.0).abs() < 1e-12);
    assert_eq!(kinds(&loaded.repaired), [("Inserted", 1)]);
    // Whole ones are as they were.
    for name in [
        "bumpy_utm.obj",
        "db.obj",
        "bowtie_hole.obj",
        "flat_hole.obj",
    ] {
        let bytes = std::fs::read(folder.join(name)).expect("a file");
        let mut session = Session::new();
        let before = session.load(&bytes, name).expect("a surface");
        let after = session.repair(RepairOptions::default()).expect("whole");
        assert!(after == before && !session.can_undo_edit(), "{name}");
    }
}

#[test]
fn undoing_the_repair_of_a_file_that_is_no_surface_brings_back_what_was_there() {
    let mut soup = Soup::sphere(6, 8);
    let last = soup.x.len();
    soup.x.push([3.0; 3]);
    soup.faces
        .push(vec![soup.faces[20][0], soup.faces[20][1], last]);
    let mut session = Session::new();
    session.sample("torus", &[]).expect("a torus");
    let options = FlowOptions {
        flow: FlowName::Circle,
        ..FlowOptions::default()
    };
    session.configure(options).expect("configured");
    session.run(2).expect("steps");
    let before = (
        session.frame().expect("a frame").exact,
        session.state().expect("a state"),
        session.provenance().expect("known"),
    );
    session
        .load(&soup.obj(), "fin.obj")
        .expect_err("no surface");
    let options = RepairOptions::default();
    let repaired = session.load_repaired(&soup.obj(), "fin.obj", options);
    assert!(is_sphere(&repaired.expect("repaired").info));
    assert!(session.can_undo_edit());
    let loaded = session.undo_edit().expect("undone");
    assert_eq!(loaded.name, "torus");
    let after = (
        session.frame().expect("a frame").exact,
        session.state().expect("a state"),
        session.provenance().expect("known"),
    );
    assert!(before == after && !session.can_undo_edit());
    session.run(1).expect("a step");
    // Where nothing was shown there is nothing to go back to.
    let mut session = Session::new();
    session
        .load_repaired(&soup.obj(), "fin.obj", options)
        .expect("repaired");
    assert!(!session.can_undo_edit());
}

/// A sphere as a grid of latitudes and longitudes, the poles rows of their own: of squares or triangles,
/// its two ends joined or not, in double or single precision.
fn grid(rings: usize, around: usize, triangles: bool, joined: bool, single: bool) -> Soup {
    let mut soup = Soup::default();
    let columns = around + usize::from(!joined);
    for ring in 0..=rings {
        let (sin, z) = (std::f64::consts::PI * ring as f64 / rings as f64).sin_cos();
        for n in 0..columns {
            let (y, x) = (std::f64::consts::TAU * n as f64 / around as f64).sin_cos();
            let p = [sin * x, sin * y, z];
            soup.x.push(if single {
                p.map(|c| f64::from(c as f32))
            } else {
                p
            });
        }
    }
    for ring in 0..rings {
        for n in 0..around {
            let at = |ring: usize, n: usize| ring * columns + n % columns;
            let [a, b] = [at(ring, n), at(ring, n + 1)];
            let [c, d] = [at(ring + 1, n), at(ring + 1, n + 1)];
            if triangles {
                soup.faces.extend([vec![a, c, d], vec![a, d, b]]);
            } else {
                soup.faces.push(vec![a, c, d, b]);
            }
        }
    }
    soup
}

#[test]
fn a_grid_whose_poles_are_rows_becomes_a_sphere() {
    for case in 0..16 {
        let [triangles, joined, single, fine] = [1, 2, 4, 8].map(|bit| case & bit != 0);
        let (rings, around) = if fine { (9, 70) } else { (8, 12) };
        let soup = grid(rings, around, triangles, joined, single);
        let (_, loaded) = repaired(&soup.obj(), Weld::Auto);
        let info = &loaded.info;
        assert!(is_sphere(info), "{case}: {info:?}");
        assert_eq!(info.vertices, (rings - 1) * around + 2, "{case}");
        assert_eq!(info.repairs, [], "{case}");
    }
}

/// Two cubes of squares or triangles that share a side, each with a wall of its own there, on the same
/// vertices.
#[test]
fn bodies_that_share_a_wall_are_taken_apart() {
    for n in [1, 3] {
        let mut soup = Soup::cube(n);
        let names: Vec<usize> = (soup.x.clone().iter())
            .map(|&[x, y, z]| {
                let moved = [x + 1.0, y, z];
                soup.x.iter().position(|p| *p == moved).unwrap_or_else(|| {
                    soup.x.push(moved);
                    soup.x.len() - 1
                })
            })
            .collect();
        let other = soup.faces.clone().into_iter();
        // The mirror image of the first, so that diagonals of the wall agree.
        let wall = |soup: &Soup, face: &[usize], x: f64| face.iter().all(|&v| soup.x[v][0] == x);
        let near: Vec<Vec<usize>> = soup
            .faces
            .iter()
            .filter(|f| wall(&soup, f, 1.0))
            .cloned()
            .collect();
        let far = other.filter(|face| !wall(&soup, face, 0.0));
        let far: Vec<Vec<usize>> = far
            .map(|face| face.iter().map(|&v| names[v]).collect())
            .collect();
        soup.faces.extend(far);
        soup.faces.extend(
            near.into_iter()
                .map(|face| face.into_iter().rev().collect()),
        );
        let fault = Session::new()
            .load(&soup.obj(), "walls.obj")
            .expect_err("no surface");
        assert_eq!(fault.kind, "NonManifoldEdge");
        let (_, loaded) = repaired(&soup.obj(), Weld::Auto);
        let info = &loaded.info;
        assert!(info.closed && info.components == 2, "{info:?}");
        assert_eq!(info.faces, soup.faces.len());
        assert!(
            (info.area - 12.0).abs() < 1e-12 && (info.volume.expect("closed") - 2.0).abs() < 1e-12
        );
    }
    // A sheet with a back of its own is one sheet.
    let mut sheet = Soup::cube(2);
    let is_side = |face: &Vec<usize>| face.iter().all(|&v| sheet.x[v][0] == 1.0);
    let side: Vec<Vec<usize>> = sheet.faces.iter().filter(|f| is_side(f)).cloned().collect();
    let back = side.iter().map(|face| face.iter().rev().copied().collect());
    sheet.faces = side.iter().cloned().chain(back).collect();
    let loaded = Session::new()
        .load(&sheet.obj(), "sheet.obj")
        .expect("a sheet");
    assert_eq!(loaded.info.faces, side.len());
}

/// A hexagonal prism in three wedges about its axis, each with walls of its own on the same vertices.
#[test]
fn bodies_that_meet_in_an_edge_are_taken_apart() {
    let mut soup = Soup {
        x: vec![[0.0; 3], [0.0, 0.0, 1.0]],
        faces: Vec::new(),
    };
    for i in 0..6 {
        let (y, x) = (std::f64::consts::FRAC_PI_3 * f64::from(i)).sin_cos();
        soup.x.extend([[x, y, 0.0], [x, y, 1.0]]);
    }
    let low = |i: usize| 2 + 2 * (i % 6);
    let high = |i: usize| low(i) + 1;
    for first in [0, 2, 4] {
        for i in [first, first + 1] {
            soup.faces.push(vec![0, low(i + 1), low(i)]);
            soup.faces.push(vec![1, high(i), high(i + 1)]);
            soup.faces
                .push(vec![low(i), low(i + 1), high(i + 1), high(i)]);
        }
        soup.faces.push(vec![0, low(first), high(first), 1]);
        soup.faces.push(vec![0, 1, high(first + 2), low(first + 2)]);
    }
    let (_, loaded) = repaired(&soup.obj(), Weld::Auto);
    let Info {
        components,
        closed,
        faces,
        volume,
        ..
    } = loaded.info;
    assert_eq!((components, closed, faces), (3, true, 24));
    assert!((volume.expect("closed") - 1.5 * 3f64.sqrt()).abs() < 1e-12);
}

/// A vertex of no face, a face with a corner twice, and a triangle of three corners on a line: all
/// before or among the rest, so that the surface's own numbers are not the file's.
/// A corner is off the line of the two others by `off`, as far as the digits of a file leave it.
fn with_flat_triangle(off: f64) -> Vec<u8> {
    let mut soup = Soup::sphere(6, 8);
    let [a, b, c] = [soup.faces[20][0], soup.faces[20][1], soup.faces[20][2]];
    let middle = soup.x.len();
    soup.x
        .push([0, 1, 2].map(|k| 0.5 * (soup.x[a][k] + soup.x[b][k]) + off * soup.x[c][k]));
    // The neighbour across the edge keeps it; this side is divided.
    soup.faces[20] = vec![a, middle, c];
    soup.faces.push(vec![middle, b, c]);
    soup.faces.insert(7, vec![b, middle, a]);
    soup.faces.insert(0, vec![0, 0, 1]);
    soup.x.insert(0, [3.0; 3]);
    for v in soup.faces.iter_mut().flatten() {
        *v += 1;
    }
    soup.obj()
}

#[test]
fn a_triangle_without_area_is_named_as_the_file_numbers_it_and_stops_flows_truthfully() {
    for off in [0.0, 1e-12, 1e-9] {
        a_triangle_without_area_is_named(&with_flat_triangle(off));
    }
}

fn a_triangle_without_area_is_named(bytes: &[u8]) {
    let text = String::from_utf8(bytes.to_vec()).expect("text");
    let faces: Vec<&str> = text.lines().filter(|line| line.starts_with('f')).collect();
    let mut session = Session::new();
    let loaded = session.load(bytes, "flat.obj").expect("a surface");
    let numbers = &loaded.numbers;
    assert_eq!(numbers.first, 1);
    let of_file = |list: &Option<umbilic::arrays::TypedArray<u32>>, n: f64| {
        list.as_ref().expect("numbers")[n as usize] + numbers.first
    };
    let mut warnings = loaded.info.warnings.iter();
    let flat = warnings.find(|w| &*w.id == "notice-flat-triangles");
    let flat = flat.expect("a notice");
    let face = of_file(&numbers.faces, flat.number("face").expect("a face"));
    let Some(Value::List(corners)) = flat.value("vertices") else {
        panic!("{flat:?}");
    };
    let corners = corners.iter().map(|corner| match corner {
        Value::Number(v) => of_file(&numbers.vertices, *v),
        other => panic!("{other:?}"),
    });
    let mut corners: Vec<u32> = corners.collect();
    corners.sort_unstable();
    let mut written: Vec<u32> = faces[face as usize - 1]
        .split(' ')
        .skip(1)
        .map(|v| v.parse().expect("a number"))
        .collect();
    written.sort_unstable();
    assert_eq!(corners, written);
    assert_eq!(face, 9);

    let options = FlowOptions {
        flow: FlowName::PWillmore,
        max_steps: Some(3),
        ..FlowOptions::default()
    };
    session.configure(options).expect("a flow");
    while session.step().expect("no failure").is_some() {}
    let state = session.state().expect("a state");
    if state.step == 0 {
        let why = state.message.clone().expect("a reason");
        assert_eq!(&*why.id, "reason-flat-face");
        assert_eq!(why.number("count"), Some(1.0));
        let why = session.why().expect("a mesh").expect("a diagnosis");
        assert_eq!(why.remedies[0].id, umbilic::app::RemedyId::Repair);
    } else {
        panic!("it has moved");
    }
    session.repair(RepairOptions::default()).expect("repaired");
    assert_eq!(session.loaded().expect("a mesh").numbers.vertices, None);
}

/// On a sphere, where most flows are at rest, a face without area is named and not called rest.
#[test]
fn no_flow_is_at_rest_on_a_face_without_area() {
    for name in [
        "p-willmore",
        "mean-curvature",
        "volume-preserving",
        "surface-diffusion",
        "willmore",
        "mmcv",
    ] {
        for at in [3, 40] {
            let mut soup = Soup::sphere(9, 12);
            let [a, b, c] = soup.faces[at][..] else {
                panic!("no triangle");
            };
            let off = if at == 3 { 0.0 } else { 1e-9 };
            let middle = |k: usize| (soup.x[a][k] + soup.x[b][k]) / 2.0 + off * soup.x[c][k];
            let middle = std::array::from_fn(middle);
            soup.x.push(middle);
            let m = soup.x.len() - 1;
            soup.faces[at] = vec![a, m, c];
            soup.faces.push(vec![m, b, c]);
            soup.faces.push(vec![a, b, m]);
            let (mut session, _) = open(&soup.obj());
            let options = json!({ "flow": name, "maxSteps": 2 });
            let options = serde_json::from_value(options).expect("options");
            session
                .perform(RunCommand::Configure { options })
                .expect("a flow");
            while session.step().expect("no failure").is_some() {}
            let state = session.state().expect("a state");
            let why = state.message.expect("a reason");
            assert!(
                state.step > 0 || &*why.id == "reason-flat-face",
                "{name} {at}: {why:?}"
            );
        }
    }
}

#[test]
fn a_flow_that_finds_loose_triangles_only_offers_to_weld_them() {
    let (cube, _) =
        open(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    let whole = cube.export(Format::Obj).expect("written");
    let text = String::from_utf8(whole).expect("text");
    let rows = |word: &str| -> Vec<String> {
        let lines = text.lines().filter_map(|line| line.strip_prefix(word));
        lines.map(str::to_owned).collect()
    };
    let (points, faces) = (rows("v "), rows("f "));
    let mut loose = String::new();
    for face in &faces {
        for v in face.split_whitespace() {
            let v: usize = v.parse().expect("a number");
            writeln!(loose, "v {}", points[v - 1]).expect("text");
        }
        loose += "f -3 -2 -1\n";
    }
    let (mut s, info) = open(loose.as_bytes());
    assert_eq!(info.components, 4);
    let options = Values::default();
    let fault = s.perform(RunCommand::Configure { options });
    let fault = fault.map(|_| ()).expect_err("all held");
    assert_eq!(fault.kind, "NothingFree");
    assert_eq!(fault.repairs.first().map(|item| item.kind), Some("Welded"));
}
