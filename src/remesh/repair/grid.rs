//! Points found by where they are.

use super::bounds;
use super::hash::Table;
use glam::DVec3;

/// A cube is no smaller than this share of the whole: their numbers stay exact.
const FINEST: f64 = 1e-9;

/// Points in cubes of one size.
pub(super) struct Grid {
    low: DVec3,
    size: f64,
    cells: Table<[i64; 3], Vec<u32>>,
}

impl Grid {
    /// For questions within `reach` among these points.
    pub(super) fn new(reach: f64, x: &[DVec3]) -> Self {
        let (low, high) = bounds(x);
        let finest = FINEST * low.distance(high);
        Self {
            low,
            size: reach.max(finest).max(f64::MIN_POSITIVE),
            cells: Table::default(),
        }
    }

    /// The side of a cube.
    pub(super) fn size(&self) -> f64 {
        self.size
    }

    fn cell(&self, p: DVec3) -> [i64; 3] {
        ((p - self.low) / self.size)
            .to_array()
            .map(|c| c.floor() as i64)
    }

    pub(super) fn insert(&mut self, p: DVec3, name: u32) {
        self.cells.entry(self.cell(p)).or_default().push(name);
    }

    /// Whatever is in the cubes that a box touches.
    pub(super) fn near(&self, low: DVec3, high: DVec3) -> impl Iterator<Item = u32> + '_ {
        let (low, high) = (self.cell(low), self.cell(high));
        let range = move |axis: usize| low[axis]..=high[axis];
        range(0)
            .flat_map(move |i| range(1).map(move |j| (i, j)))
            .flat_map(move |(i, j)| range(2).map(move |k| [i, j, k]))
            .filter_map(|cell| self.cells.get(&cell))
            .flatten()
            .copied()
    }

    /// The point nearest to a place, no farther than `near`.
    pub(super) fn nearest(&self, p: DVec3, near: f64, x: &[DVec3]) -> Option<u32> {
        let reach = DVec3::splat(near);
        self.near(p - reach, p + reach)
            .map(|v| (x[v as usize].distance(p), v))
            .filter(|(distance, _)| *distance <= near)
            .min_by(|s, t| s.0.total_cmp(&t.0).then(s.1.cmp(&t.1)))
            .map(|(_, v)| v)
    }
}
