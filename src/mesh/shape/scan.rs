//! A range scan: what a light-stripe scanner sees of a bust, figure 12 of Bobenko & Schröder
//! [BS05](crate::bibliography#bs05).

use glam::DVec3;

use super::face::{FRAME, height};
use super::{Conflict, grid};
use crate::mesh::noise::SplitMix64;
use crate::soup::PolygonSoup;

deferred! {
    /// A picture of `resolution` rows of cells, each cell seen whole cut into two triangles.
    ///
    /// As in real scans the triangles are stretched where the depth jumps, `loops - 1`
    /// small holes were not seen (mostly on steep ground; the remaining loop is the
    /// outline), and each depth is off by a normal error of standard deviation
    /// `noise` times the mean edge length. Depth is along z, towards the scanner.
    ///
    /// The default resolution gives 38 000 vertices.
    ///
    /// # Errors
    /// If the resolution is too low for that many holes.
    pub fn scan(
        resolution: usize,
        noise: f64,
        loops: usize,
        seed: u64,
    ) -> Result<PolygonSoup, Conflict> {
        let mut random = SplitMix64::new(seed);
        let mut picture = Picture::new(resolution);
        picture.punch(loops - 1, &mut random)?;
        let mut soup = picture.surface();
        let deviation = noise * mean_edge_length(&soup);
        for p in &mut soup.positions {
            p.z += deviation * random.gaussian();
        }
        Ok(soup)
    }
}

/// Depths at the corners of a grid of square cells, and the cells that were seen.
struct Picture {
    columns: usize,
    rows: usize,
    spacing: f64,
    /// Depth at corner `i * (rows + 1) + j`, if the bust is there.
    depths: Vec<Option<f64>>,
    /// Whether cell `i * rows + j` was seen. At every resolution allowed, the bust's outline
    /// is smooth enough that no two cells meet in a corner only.
    seen: Vec<bool>,
}

impl Picture {
    fn new(rows: usize) -> Self {
        let [(left, bottom), (right, top)] = FRAME;
        let spacing = (top - bottom) / rows as f64;
        // An even number of cells about x = 0 keeps the bust symmetric.
        let columns = 2 * ((right - left) / (2.0 * spacing)).round() as usize;
        let middle = columns as f64 / 2.0;
        let depths = (0..(columns + 1) * (rows + 1)).map(|k| {
            let (i, j) = ((k / (rows + 1)) as f64, (k % (rows + 1)) as f64);
            height((i - middle) * spacing, bottom + j * spacing)
        });
        let depths: Vec<_> = depths.collect();
        let corner = |i: usize, j: usize| depths[i * (rows + 1) + j].is_some();
        let seen = (0..columns * rows).map(|k| {
            let (i, j) = (k / rows, k % rows);
            corner(i, j) && corner(i + 1, j) && corner(i, j + 1) && corner(i + 1, j + 1)
        });
        Self {
            seen: seen.collect(),
            columns,
            rows,
            spacing,
            depths,
        }
    }

    fn is_seen(&self, i: usize, j: usize) -> bool {
        self.seen[i * self.rows + j]
    }

    /// Opens `count` rectangular holes, apart from each other and from the outline.
    fn punch(&mut self, count: usize, random: &mut SplitMix64) -> Result<(), Conflict> {
        let largest = (self.rows / 90).max(1);
        let mut missing = count;
        for _ in 0..400 * (count + 1) {
            if missing == 0 {
                return Ok(());
            }
            let (width, height) = (1 + random.below(largest), 1 + random.below(largest));
            let i = 1 + random.below(self.columns - width - 1);
            let j = 1 + random.below(self.rows - height - 1);
            let wanted = random.uniform() < self.steepness(i, j);
            let whole =
                (i - 1..=i + width).all(|i| (j - 1..=j + height).all(|j| self.is_seen(i, j)));
            if wanted && whole {
                for i in i..i + width {
                    self.seen[i * self.rows + j..i * self.rows + j + height].fill(false);
                }
                missing -= 1;
            }
        }
        let resolution = self.rows;
        Err(Conflict::NoRoom { resolution, count })
    }

    /// The slope of a cell, between a floor that leaves some holes to level ground and 1.
    fn steepness(&self, i: usize, j: usize) -> f64 {
        let depth = |i: usize, j: usize| self.depths[i * (self.rows + 1) + j];
        match (depth(i, j), depth(i + 1, j), depth(i, j + 1)) {
            (Some(z), Some(zx), Some(zy)) => {
                ((zx - z).hypot(zy - z) / self.spacing / 4.0).clamp(0.03, 1.0)
            }
            _ => 0.0,
        }
    }

    /// The triangles of the cells seen, over the corners that they use.
    fn surface(&self) -> PolygonSoup {
        let stride = self.rows + 1;
        let mut faces = grid::triangles(self.columns, self.rows, |i, j| i * stride + j);
        let mut cell = self.seen.iter().flat_map(|&seen| [seen, seen]);
        faces.retain(|_| cell.next() == Some(true));
        let middle = self.columns as f64 / 2.0;
        let mut index = vec![u32::MAX; self.depths.len()];
        let mut positions = Vec::new();
        for corner in faces.as_flattened_mut() {
            let k = *corner as usize;
            if index[k] == u32::MAX {
                index[k] = positions.len() as u32;
                let x = ((k / stride) as f64 - middle) * self.spacing;
                let y = FRAME[0].1 + (k % stride) as f64 * self.spacing;
                positions.push(DVec3::new(x, y, self.depths[k].unwrap_or_default()));
            }
            *corner = index[k];
        }
        PolygonSoup::from_faces(positions, &faces)
    }
}

/// Mean over faces of their sides: inner edges count twice.
fn mean_edge_length(soup: &PolygonSoup) -> f64 {
    let x = |v: u32| soup.positions[v as usize];
    let perimeter: f64 = soup
        .faces()
        .map(|f| {
            (0..3)
                .map(|c| x(f[c]).distance(x(f[(c + 1) % 3])))
                .sum::<f64>()
        })
        .sum();
    perimeter / soup.corners.len() as f64
}
