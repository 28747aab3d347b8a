//! Consistent orientation of a soup, and outward where it is closed.

use super::error::Repair;
use super::sides::{Side, face_adjacency, interior_edges};
use crate::soup::PolygonSoup;

/// Turns faces so that neighbours agree, keeping the majority of each component.
/// Closed surfaces are turned outward where that is asked for.
pub(super) fn orient(
    soup: &mut PolygonSoup,
    sides: &[Side],
    turns_outward: bool,
    repairs: &mut Vec<Repair>,
) {
    let n = soup.n_faces();
    let (start, list) = face_adjacency(soup, sides);
    let mut turned: Vec<Option<bool>> = vec![None; n];
    let (mut n_turned, mut twisted_components) = (0usize, 0usize);
    let mut component = Vec::new();
    for seed in 0..n {
        if turned[seed].is_some() {
            continue;
        }
        component.clear();
        component.push(seed as u32);
        turned[seed] = Some(false);
        let (mut at, mut consistent) = (0, true);
        while at < component.len() {
            let f = component[at] as usize;
            at += 1;
            for &(g, same) in &list[start[f] as usize..start[f + 1] as usize] {
                let wanted = turned[f].map(|t| t ^ same);
                match turned[g as usize] {
                    None => {
                        turned[g as usize] = wanted;
                        component.push(g);
                    }
                    found => consistent &= found == wanted,
                }
            }
        }
        twisted_components += usize::from(!consistent);
        let count = component
            .iter()
            .filter(|&&f| turned[f as usize] == Some(true))
            .count();
        let invert = count * 2 > component.len();
        n_turned += if invert {
            component.len() - count
        } else {
            count
        };
        for &f in &component {
            turned[f as usize] = turned[f as usize].map(|t| t ^ invert);
        }
    }
    for (f, turned) in turned.iter().enumerate() {
        if *turned == Some(true) {
            let range = soup.face_starts[f] as usize..soup.face_starts[f + 1] as usize;
            soup.corners[range].reverse();
        }
    }
    if twisted_components > 0 {
        repairs.push(Repair::OneSided {
            count: twisted_components,
        });
    } else if n_turned > 0 {
        repairs.push(Repair::TurnedFaces { count: n_turned });
    }
    if turns_outward && twisted_components == 0 && closed_volume(soup, sides) < 0.0 {
        for f in 0..n {
            let range = soup.face_starts[f] as usize..soup.face_starts[f + 1] as usize;
            soup.corners[range].reverse();
        }
        repairs.push(Repair::InsideOut);
    }
}

/// Signed volume of a closed soup by fans of tetrahedra; 0 if it is open.
fn closed_volume(soup: &PolygonSoup, sides: &[Side]) -> f64 {
    if 2 * interior_edges(sides).count() != sides.len() {
        return 0.0;
    }
    let x = |v: u32| soup.positions[v as usize] - soup.positions[0];
    soup.faces()
        .flat_map(|f| {
            f[1..]
                .windows(2)
                .map(move |w| x(f[0]).dot(x(w[0]).cross(x(w[1]))))
        })
        .sum::<f64>()
        / 6.0
}
