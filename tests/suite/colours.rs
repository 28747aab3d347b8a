//! Colours that a file brings stay with the surface: through flows, repair and other edits, as far
//! as there are vertices that they belong to.

use crate::support::session::flowing;
use crate::support::{sample, shared_folder};
use umbilic::app::{FillOptions, RemeshOptions, RepairOptions, Session, SubdivideOptions};
use umbilic::flow::options::{FlowOptions, Remeshing};
use umbilic::flow::spec::FlowName;
use umbilic::io::{self, Format};
use umbilic::remesh::adaptive::Kind;
use umbilic::soup::PolygonSoup;

/// A colour that tells the place; in a session that does not move it, the same before and after.
fn painted(mut soup: PolygonSoup) -> PolygonSoup {
    let colour = |p: &glam::DVec3| [0.5 + 0.25 * p.x, 0.5 + 0.25 * p.y, 0.5 + 0.25 * p.z, 1.0];
    soup.colours = soup
        .positions
        .iter()
        .map(|p| colour(p).map(|c| c as f32))
        .collect();
    soup
}

fn opened(soup: &PolygonSoup) -> Session {
    let bytes = io::write(soup, Format::Ply, "").expect("a file");
    let mut session = Session::new();
    session.load(&bytes, "painted.ply").expect("a surface");
    session
}

fn saved(session: &Session) -> PolygonSoup {
    let bytes = session.export(Format::Ply).expect("a file");
    io::read(&bytes, "").expect("a mesh").soup
}

/// How far colours are from what the places say.
fn error(soup: &PolygonSoup) -> f32 {
    assert!(soup.has_colours());
    let expected = painted(soup.clone());
    let pairs = soup.colours.iter().flatten();
    let pairs = pairs.zip(expected.colours.iter().flatten());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

fn losses(session: &Session, format: Format) -> Vec<String> {
    let losses = session.losses(format).expect("a mesh");
    losses.iter().map(|loss| loss.id.to_string()).collect()
}

#[test]
fn colours_stay_with_their_vertices_through_a_flow() {
    let mut soup = painted(sample("icosphere", &[("level", 2.0)]));
    // Not one of the surface: the rest is numbered anew.
    soup.positions.insert(5, glam::DVec3::ONE);
    soup.colours.insert(5, [0.0; 4]);
    soup.corners
        .iter_mut()
        .for_each(|v| *v += u32::from(*v >= 5));
    let mut session = opened(&soup);
    assert!(error(&saved(&session)) < 1e-6);
    session
        .configure(flowing(FlowName::MeanCurvature))
        .expect("a flow");
    let before = saved(&session).colours;
    session.step().expect("a step");
    let after = saved(&session);
    assert_eq!(after.colours, before);
    assert!(error(&after) > 1e-4, "it has moved");
    assert_eq!(losses(&session, Format::Obj), [""; 0]);
    assert_eq!(losses(&session, Format::Stl), ["loss-colours"]);
}

#[test]
fn colours_stay_with_their_vertices_through_a_repair() {
    let whole = painted(sample("icosphere", &[("level", 2.0)]));
    // Every triangle with corners of its own.
    let mut torn = PolygonSoup::default();
    for face in whole.faces() {
        let first = torn.positions.len() as u32;
        for &v in face {
            torn.positions.push(whole.positions[v as usize]);
            torn.colours.push(whole.colours[v as usize]);
        }
        torn.push_face(&[first, first + 1, first + 2]);
    }
    let mut session = opened(&torn);
    let loaded = session.repair(RepairOptions::default()).expect("repaired");
    assert!(loaded.info.closed);
    assert!(error(&saved(&session)) < 1e-6);
    // One that is no surface before: a third face at an edge.
    let mut fin = whole.clone();
    fin.positions.push(glam::DVec3::splat(2.0));
    fin.colours.push([1.0; 4]);
    let [a, b] = [fin.corners[0], fin.corners[1]];
    fin.push_face(&[a, b, fin.positions.len() as u32 - 1]);
    let bytes = io::write(&fin, Format::Ply, "").expect("a file");
    let mut session = Session::new();
    let loaded = session.load_repaired(&bytes, "fin.ply", RepairOptions::default());
    assert!(!loaded.expect("repaired").repaired.is_empty());
    assert!(error(&saved(&session)) < 1e-6);
}

#[test]
fn new_vertices_are_coloured_as_what_is_around_them() {
    let soup = painted(sample("icosphere", &[("level", 2.0)]));
    let mut session = opened(&soup);
    let options = SubdivideOptions::default();
    session.subdivide(options).expect("finer");
    let finer = saved(&session);
    assert!(finer.positions.len() > 3 * soup.positions.len());
    assert!(error(&finer) < 1e-6);

    // Every third of the sphere has a hole of one ring of triangles.
    let mut holed = soup.clone();
    holed.corners.clear();
    holed.face_starts = vec![0];
    for face in soup.faces().filter(|face| !face.contains(&0)) {
        holed.push_face(face);
    }
    let mut session = opened(&holed);
    let outcome = session.fill(&FillOptions::default(), &mut |_, _| {
        std::ops::ControlFlow::Continue(())
    });
    let filled = outcome.expect("filled");
    let surface = saved(&session);
    assert!(filled.new_vertices > 0);
    let hole = error(&surface);
    assert!(hole < 0.1, "{hole}");

    let options = RemeshOptions {
        kind: Kind::Isotropic,
        vertices: Some(200),
        ..RemeshOptions::default()
    };
    session.remesh(&options).expect("remeshed");
    let other = saved(&session);
    assert_ne!(other.positions.len(), surface.positions.len());
    // On triangles with edges of 0.32: h²/8 of the bend, besides what the hole is off.
    let remeshed = error(&other);
    assert!(remeshed < 0.25 * 0.013 + hole, "{remeshed}");
    session.undo_edit().expect("undone");
    assert_eq!(saved(&session).colours, surface.colours);
}

#[test]
fn colours_go_along_where_a_run_is_remeshed() {
    let shape = [("around", 28.0), ("tube", 14.0), ("jitter", 0.25)];
    let soup = painted(sample("sampled-torus", &shape));
    let mut session = opened(&soup);
    session
        .configure(FlowOptions {
            // So short a step that the surface stays where it is.
            tau: Some(1e-7),
            remesh: Remeshing::Adaptive,
            ..flowing(FlowName::PWillmore)
        })
        .expect("a flow");
    let mut has_passed = false;
    for _ in 0..12 {
        let report = session.step().expect("a step").expect("none is at rest");
        has_passed |= report.pass.is_some();
    }
    assert!(has_passed);
    let after = saved(&session);
    assert_ne!(after.corners, soup.corners);
    // Triangles with edges of up to 0.3 around a tube of 0.35: h²/8r of the slope.
    let off = error(&after);
    assert!(off < 0.25 * 0.033, "{off}");
    // With another flow on the same mesh too.
    session
        .continue_with(flowing(FlowName::MeanCurvature))
        .expect("a flow");
    assert!(saved(&session).colours == after.colours);
    assert_eq!(losses(&session, Format::Ply), [""; 0]);
    session.reset().expect("the start");
    assert!(error(&saved(&session)) < 1e-6);
}

#[test]
fn a_cube_of_one_colour_comes_back_so_from_every_format_that_holds_it() {
    let Some(folder) = shared_folder("cases/files") else {
        return;
    };
    let bytes = std::fs::read(folder.join("obj_color.obj")).expect("a file");
    let mut session = Session::new();
    let loaded = session.load(&bytes, "obj_color.obj").expect("a surface");
    let said = loaded.info.warnings.iter().map(|w| w.id.to_string());
    assert!(!said.collect::<Vec<_>>().contains(&"oddity-left-out".into()));
    for format in [Format::Ply, Format::Obj, Format::Off, Format::Glb] {
        let file = session.export(format).expect("a file");
        let soup = io::read(&file, "").expect("a mesh").soup;
        assert_eq!(soup.colours.len(), 8, "{format:?}");
        for (part, expected) in soup
            .colours
            .iter()
            .flat_map(|c| c.iter().zip([0.5, 0.25, 1.0, 1.0]))
        {
            assert!((part - expected).abs() < 1e-6, "{format:?}");
        }
    }
}
