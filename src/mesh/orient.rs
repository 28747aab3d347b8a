//! Consistent orientation of a soup, and outward where it is closed.

use super::error::Repair;
use super::outward::turn_outward;
use super::sides::{Side, face_adjacency};
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
    let (mut part, mut n_parts) = (vec![0; n], 0);
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
            part[f as usize] = n_parts;
        }
        n_parts += 1;
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
    if turns_outward && twisted_components == 0 {
        turn_outward(soup, sides, &part, n_parts as usize, repairs);
    }
}
