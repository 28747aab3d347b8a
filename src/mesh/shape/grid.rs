//! Triangles of a rectangular grid, however its sides are glued.

/// Cuts each of `columns` x `rows` cells along the diagonal `(i, j)` to `(i + 1, j + 1)`.
///
/// `vertex(i, j)` names the grid's corners, `i <= columns`, `j <= rows`; giving
/// one vertex two names glues sides together. Faces turn from `i` to `j`.
pub(super) fn triangles(
    columns: usize,
    rows: usize,
    vertex: impl Fn(usize, usize) -> usize,
) -> Vec<[u32; 3]> {
    let mut faces = Vec::with_capacity(2 * columns * rows);
    for i in 0..columns {
        for j in 0..rows {
            let a = vertex(i, j) as u32;
            let b = vertex(i + 1, j) as u32;
            let c = vertex(i + 1, j + 1) as u32;
            let d = vertex(i, j + 1) as u32;
            faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    faces
}
