//! Loose triangles made a surface: what opens such a file, and what a repair adds.

use super::{BenchOptions, Measurement, Table, megabytes, milliseconds};
use crate::app::Session;
use crate::app::edit::options::RepairOptions;
use crate::io::{self, Format};
use crate::mesh::shape::{self, ShapeError};
use crate::soup::PolygonSoup;
use glam::DVec3;
use web_time::Instant;

pub(super) const TABLE: Table = Table {
    columns: &["triangles", "vertices", "open", "repair", "megabytes"],
    left: 1,
    digits: None,
    measurements,
};

/// Points around the tube of a torus with twice as many along: 4, 76 and 300 thousand triangles.
const TUBES: [usize; 3] = [32, 138, 274];
/// Corners are off by up to this share of the tube, about as much as single precision rounds.
const NOISE: f64 = 3e-7;

fn measurements(options: &BenchOptions) -> Vec<Measurement> {
    let sizes = TUBES.into_iter().filter(|n| options.takes(2 * n * n));
    sizes.map(measurement).collect()
}

/// A torus as loose triangles.
fn loose(tube: usize) -> Result<PolygonSoup, ShapeError> {
    let size = [("around", 2 * tube), ("tube", tube)];
    let size = size.map(|(name, n)| (name.to_owned(), n as f64));
    Ok(torn(&shape::make("sampled-torus", &size)?.soup))
}

fn measurement(tube: usize) -> Measurement {
    Box::new(move || {
        let loose = loose(tube)?;
        let bytes = io::write(&loose, Format::Stl, "")?;
        let mut session = Session::new();
        let begun = Instant::now();
        session.load(&bytes, "loose.stl")?;
        let open = milliseconds(begun);
        let begun = Instant::now();
        let loaded = session.repair(RepairOptions::default())?;
        Ok(vec![vec![
            ("triangles", loose.n_faces().into()),
            ("vertices", loaded.info.vertices.into()),
            ("open", open.into()),
            ("repair", milliseconds(begun).into()),
            ("megabytes", megabytes()),
        ]])
    })
}

/// Every triangle on corners of its own, each a little off.
fn torn(soup: &PolygonSoup) -> PolygonSoup {
    let mut torn = PolygonSoup::default();
    let mut state = 1_u64;
    let mut random = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        NOISE * ((state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
    };
    for triangle in soup.triangles() {
        let first = torn.positions.len() as u32;
        for v in triangle {
            let off = DVec3::new(random(), random(), random());
            torn.positions.push(soup.positions[v as usize] + off);
        }
        torn.push_face(&[first, first + 1, first + 2]);
    }
    torn
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_torus_of_the_table_can_be_made() {
        for tube in TUBES {
            assert!(loose(tube).is_ok(), "{tube}");
        }
    }
}
