//! Organic surfaces of genus 0 with thin parts: skins about bones, cut from a grid of
//! tetrahedra as a scanner's software would, with triangles of all shapes.

use glam::DVec3;
use std::collections::HashMap;
use umbilic::soup::PolygonSoup;

/// A straight bone with a radius at each end.
#[derive(Clone, Copy, Debug)]
pub struct Bone {
    pub from: DVec3,
    pub to: DVec3,
    pub radii: [f64; 2],
}

/// From numbers: end, end, radii.
pub fn bone(from: [f64; 3], to: [f64; 3], radii: [f64; 2]) -> Bone {
    let [from, to] = [from, to].map(DVec3::from_array);
    Bone { from, to, radii }
}

/// Bones whose skins melt into each other over this length.
#[derive(Clone, Debug)]
pub struct Body {
    pub bones: Vec<Bone>,
    pub melt: f64,
}

/// Shares of the way to the mean of the neighbours.
const BACK_AND_FORTH: [f64; 2] = [0.5, -0.53];

/// A node of the grid.
type Node = [usize; 3];

impl Body {
    /// Below 0 inside: the smooth least, −m log Σ exp(−d/m), of the distances d from the skins.
    fn distance(&self, p: DVec3) -> f64 {
        let one = |b: &Bone| {
            let axis = b.to - b.from;
            let t = ((p - b.from).dot(axis) / axis.length_squared()).clamp(0.0, 1.0);
            p.distance(b.from + t * axis) - (b.radii[0] + t * (b.radii[1] - b.radii[0]))
        };
        let all: Vec<f64> = self.bones.iter().map(one).collect();
        let least = all.iter().copied().fold(f64::INFINITY, f64::min);
        let sum: f64 = all.iter().map(|d| ((least - d) / self.melt).exp()).sum();
        least - self.melt * sum.ln()
    }

    /// The skin on a grid of that spacing, each cube in six tetrahedra about its diagonal, its
    /// vertices smoothed along it so many times.
    pub fn skin(&self, spacing: f64, rounds: usize) -> PolygonSoup {
        let reach = |b: &Bone| b.radii[0].max(b.radii[1]) + 2.0 * self.melt + 2.0 * spacing;
        let corners = self.bones.iter().flat_map(|b| {
            let reach = reach(b);
            [b.from - reach, b.to - reach, b.from + reach, b.to + reach]
        });
        let all: Vec<DVec3> = corners.collect();
        let low = all.iter().copied().reduce(DVec3::min).expect("bones");
        let high = all.iter().copied().reduce(DVec3::max).expect("bones");
        let [nx, ny, nz] = ((high - low) / spacing)
            .to_array()
            .map(|cells| cells.ceil() as usize);
        // Off the planes of symmetry, which would put grid points on the skin.
        let at = |k: Node| {
            let k = DVec3::from_array(k.map(|i| i as f64));
            low + spacing * (k + DVec3::new(0.137, 0.271, 0.193))
        };
        let mut heights = HashMap::new();
        let mut height = |k: Node| *heights.entry(k).or_insert_with(|| self.distance(at(k)));
        let mut soup = PolygonSoup::default();
        let mut known = HashMap::new();
        let cubes = (0..nx * ny * nz).map(|n| [n % nx, n / nx % ny, n / (nx * ny)]);
        for cube in cubes {
            for order in [
                [0, 1, 2],
                [1, 2, 0],
                [2, 0, 1],
                [0, 2, 1],
                [2, 1, 0],
                [1, 0, 2],
            ] {
                let mut k = cube;
                let steps = order.map(|axis| {
                    k[axis] += 1;
                    k
                });
                let tetrahedron = [cube, steps[0], steps[1], steps[2]];
                let (inner, outer): (Vec<Node>, Vec<Node>) =
                    tetrahedron.into_iter().partition(|k| height(*k) < 0.0);
                let mut cut = |i: usize, o: usize| {
                    let (a, b) = (inner[i], outer[o]);
                    *known.entry((a, b)).or_insert_with(|| {
                        let share = height(a) / (height(a) - height(b));
                        soup.positions.push(at(a).lerp(at(b), share));
                        soup.positions.len() as u32 - 1
                    })
                };
                let faces = match inner.len() {
                    1 => vec![[cut(0, 0), cut(0, 1), cut(0, 2)]],
                    3 => vec![[cut(0, 0), cut(1, 0), cut(2, 0)]],
                    2 => {
                        let [a, b, c, d] = [cut(0, 0), cut(0, 1), cut(1, 1), cut(1, 0)];
                        vec![[a, b, c], [a, c, d]]
                    }
                    _ => continue,
                };
                let out = outer.iter().map(|k| at(*k)).sum::<DVec3>() / outer.len() as f64
                    - inner.iter().map(|k| at(*k)).sum::<DVec3>() / inner.len() as f64;
                for [a, b, c] in faces {
                    let [p, q, r] = [a, b, c].map(|v| soup.positions[v as usize]);
                    let is_outwards = (q - p).cross(r - p).dot(out) > 0.0;
                    soup.push_face(&if is_outwards { [a, b, c] } else { [a, c, b] });
                }
            }
        }
        smooth(&mut soup, rounds);
        soup
    }
}

/// Evens out triangles: rounds of a step towards the mean of the neighbours and a longer one back
/// (Taubin 1995), which keeps the volume.
fn smooth(soup: &mut PolygonSoup, rounds: usize) {
    let faces: Vec<Vec<u32>> = soup.faces().map(<[u32]>::to_vec).collect();
    for share in (0..2 * rounds).map(|k| BACK_AND_FORTH[k % 2]) {
        let mut sums = vec![(DVec3::ZERO, 0.0); soup.positions.len()];
        for face in &faces {
            for (k, &v) in face.iter().enumerate() {
                sums[v as usize].0 += soup.positions[face[(k + 1) % 3] as usize];
                sums[v as usize].1 += 1.0;
            }
        }
        for (p, (sum, count)) in soup.positions.iter_mut().zip(sums) {
            *p = p.lerp(sum / count, share);
        }
    }
}

/// A fat body on two feet with a beak, two thin wings and a tail.
pub fn penguin() -> Body {
    let wing = |side: f64| {
        [
            bone(
                [side * 0.75, 0.0, 0.75],
                [side * 1.25, -0.1, 0.1],
                [0.16, 0.13],
            ),
            bone(
                [side * 1.25, -0.1, 0.1],
                [side * 1.35, -0.2, -0.55],
                [0.13, 0.08],
            ),
        ]
    };
    let foot = |side: f64| {
        bone(
            [side * 0.4, 0.1, -1.3],
            [side * 0.5, 0.75, -1.45],
            [0.2, 0.13],
        )
    };
    let mut bones = vec![
        bone([0.0, 0.0, -0.6], [0.0, 0.0, 0.5], [0.8, 0.62]),
        bone([0.0, 0.0, 0.5], [0.0, 0.1, 1.45], [0.62, 0.42]),
        bone([0.0, 0.4, 1.5], [0.0, 1.05, 1.4], [0.16, 0.07]),
        bone([0.0, -0.6, -1.0], [0.0, -1.15, -1.3], [0.22, 0.08]),
    ];
    bones.extend([-1.0, 1.0].into_iter().flat_map(wing));
    bones.extend([-1.0, 1.0].map(foot));
    Body { bones, melt: 0.05 }
}

/// A palm with a wrist and five fingers, its knuckles at z = 1.
pub fn hand() -> Body {
    let finger = |x: f64, lean: f64, length: f64| {
        bone([x, 0.0, 0.7], [x + lean, 0.1, 1.0 + length], [0.17, 0.12])
    };
    let mut bones: Vec<Bone> = [-0.45, -0.15, 0.15, 0.45]
        .map(|x| bone([0.7 * x, 0.0, -0.5], [x, 0.0, 0.75], [0.22, 0.2]))
        .into();
    bones.extend([
        finger(-0.58, -0.25, 0.75),
        finger(-0.2, -0.08, 1.05),
        finger(0.2, 0.08, 1.1),
        finger(0.58, 0.25, 0.8),
        bone([0.4, 0.0, -0.35], [1.05, 0.25, 0.35], [0.22, 0.14]),
        bone([0.0, 0.0, -0.5], [0.0, 0.0, -1.3], [0.3, 0.28]),
    ]);
    Body { bones, melt: 0.05 }
}
