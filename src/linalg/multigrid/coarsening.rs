//! Which rows stay on the next coarser level, and who is whose neighbour there.

use super::rows::Rows;
use crate::linalg::Pattern;
use crate::linalg::ordering::Graph;

/// Marks a row that does not stay.
pub(super) const NONE: u32 = u32::MAX;

/// A greedy maximal independent set in the order of the rows: no two of its rows are
/// neighbours, and every other row is the neighbour of one. About every fourth row of a
/// triangle mesh.
pub(super) fn independent_set(graph: &Graph) -> Vec<u32> {
    let mut is_covered = vec![false; graph.n()];
    let mut set = Vec::new();
    for i in 0..graph.n() as u32 {
        if !is_covered[i as usize] {
            set.push(i);
            for &j in graph.neighbours(i) {
                is_covered[j as usize] = true;
            }
        }
    }
    set
}

/// The number of each row on the coarser level, [`NONE`] where it does not stay.
pub(super) fn numbers(set: &[u32], n: usize) -> Vec<u32> {
    let mut numbers = vec![NONE; n];
    for (c, &i) in set.iter().enumerate() {
        numbers[i as usize] = c as u32;
    }
    numbers
}

/// Neighbours on the coarser level: each row belongs to the one that counts most for it, and
/// two are neighbours where rows of theirs are.
pub(super) fn coarse_graph(graph: &Graph, prolongation: &Rows) -> Graph {
    let owner: Vec<u32> = (0..graph.n())
        .map(|i| {
            let row = prolongation.entries(prolongation.row(i));
            let most = row.max_by(|a, b| a.1.total_cmp(&b.1));
            most.map_or(NONE, |(c, _)| c as u32)
        })
        .collect();
    let owner = &owner;
    let pairs = (0..graph.n() as u32).flat_map(|i| {
        let later = graph.neighbours(i).iter().filter(move |&&j| j > i);
        later.map(move |&j| [owner[i as usize], owner[j as usize]])
    });
    let pattern = Pattern::from_cliques(prolongation.n_columns, pairs);
    Graph::new(&pattern)
}
