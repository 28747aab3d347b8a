//! What theorems say no smooth surface goes below.

use crate::mesh::HalfedgeMesh;
use std::f64::consts::PI;

/// Least values on the smooth closed surfaces of a mesh's topology, added over components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LowerBounds {
    /// Of ∫H² dA: 4π (Willmore [W65](crate::bibliography#w65)), and 2π² with any handle (Marques
    /// & Neves [MN14](crate::bibliography#mn14)).
    pub willmore: f64,
    /// Of the circle-angle energy as printed, twice ∫(H² − K) dA: 0 for spheres,
    /// 4π² + 8π(g − 1) for genus g ≥ 1, by Gauss and Bonnet.
    pub circle: f64,
}

/// The bounds of a closed, oriented mesh; `None` of any other.
pub fn lower_bounds(mesh: &HalfedgeMesh) -> Option<LowerBounds> {
    if !mesh.is_closed() || !mesh.is_oriented() {
        return None;
    }
    let (component, count) = mesh.components();
    let mut characteristic = vec![0i64; count];
    for v in mesh.vertices() {
        characteristic[component[v.index()] as usize] += 1;
    }
    for e in mesh.edges() {
        characteristic[component[mesh.ends(e)[0].index()] as usize] -= 1;
    }
    for f in mesh.faces() {
        let corner = mesh.face_vertices(f).next();
        characteristic[corner.map_or(0, |v| component[v.index()] as usize)] += 1;
    }
    let mut bounds = LowerBounds {
        willmore: 0.0,
        circle: 0.0,
    };
    for chi in characteristic {
        let willmore = if chi == 2 { 4.0 * PI } else { 2.0 * PI * PI };
        bounds.willmore += willmore;
        // ∫K dA = 2πχ.
        bounds.circle += 2.0 * (willmore - 2.0 * PI * chi as f64);
    }
    Some(bounds)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{build, shape};

    #[test]
    fn handles_raise_the_bounds() {
        let of = |name: &str| {
            let sample = shape::make(name, &[]).expect("a shape");
            lower_bounds(&build(&sample.soup).expect("a surface").mesh)
        };
        for (name, willmore, circle) in [
            ("icosphere", 12.566_370_6, 0.0),
            ("torus", 19.739_208_8, 39.478_417_6),
            ("double-torus", 19.739_208_8, 64.611_158_8),
        ] {
            let found = of(name).expect("bounds");
            assert!((found.willmore - willmore).abs() < 1e-6, "{name}");
            assert!((found.circle - circle).abs() < 1e-6, "{name}");
        }
        // Genus 3, and components together: a sphere and a torus.
        let of_soup = |soup| lower_bounds(&build(&soup).expect("a surface").mesh);
        let three = of_soup(shape::blocks::handles(3, 0).expect("triangles")).expect("bounds");
        assert!(
            (three.circle - 89.743_900_0).abs() < 1e-6,
            "{}",
            three.circle
        );
        let mut both = shape::make("torus", &[]).expect("a shape").soup;
        let ball = shape::make("icosphere", &[("level".into(), 1.0)]).expect("a shape");
        let first = both.positions.len() as u32;
        both.positions
            .extend(ball.soup.positions.iter().map(|p| *p + 9.0));
        for face in ball.soup.faces() {
            let corners: Vec<u32> = face.iter().map(|v| v + first).collect();
            both.push_face(&corners);
        }
        let both = of_soup(both).expect("bounds");
        assert!(
            (both.willmore - 32.305_579_4).abs() < 1e-6,
            "{}",
            both.willmore
        );
        assert!((both.circle - 39.478_417_6).abs() < 1e-6, "{}", both.circle);
        assert_eq!(of("klein-bottle"), None);
        assert_eq!(of("pipe"), None);
    }
}
