//! Smallest set of vertices that touches every edge of a bipartite graph.

/// Edges between a left and a right set of vertices, by left vertex.
#[derive(Default)]
pub(super) struct Bipartite {
    /// Where the edges of each left vertex begin in `targets`; one more than there are.
    pub(super) starts: Vec<u32>,
    /// Right end of each edge.
    pub(super) targets: Vec<u32>,
    /// Number of right vertices.
    pub(super) n_right: usize,
}

const NONE: u32 = u32::MAX;

/// Minimum vertex cover: whether each left and each right vertex belongs to it.
///
/// König's theorem: if Z is what alternating paths reach from the left vertices that a
/// maximum matching leaves single, the cover is (left ∖ Z) ∪ (right ∩ Z), of the size of
/// the matching. The matching grows by augmenting paths found breadth first. A search
/// that fails reaches vertices no later path can use (its tree is closed under
/// alternating paths), so they stay marked, and after the last search the marked
/// vertices are Z. O(edges · right vertices) at worst, near linear on mesh cuts.
pub(super) fn minimum_vertex_cover(graph: &Bipartite) -> (Vec<bool>, Vec<bool>) {
    let n_left = graph.starts.len().saturating_sub(1);
    let targets = |u: u32| {
        &graph.targets[graph.starts[u as usize] as usize..graph.starts[u as usize + 1] as usize]
    };
    let mut mate_of_left = vec![NONE; n_left];
    let mut mate_of_right = vec![NONE; graph.n_right];

    // Most vertices find their mate at once.
    for u in 0..n_left as u32 {
        if let Some(&v) = targets(u)
            .iter()
            .find(|&&v| mate_of_right[v as usize] == NONE)
        {
            (mate_of_left[u as usize], mate_of_right[v as usize]) = (v, u);
        }
    }

    let mut left_reached = vec![false; n_left];
    let mut parent_of_right = vec![NONE; graph.n_right];
    let mut queue = Vec::new();
    for root in 0..n_left as u32 {
        if mate_of_left[root as usize] != NONE {
            continue;
        }
        queue.clear();
        queue.push(root);
        let mut head = 0;
        let mut end = None;
        'search: while head < queue.len() {
            let u = queue[head];
            head += 1;
            for &v in targets(u) {
                if parent_of_right[v as usize] != NONE {
                    continue;
                }
                parent_of_right[v as usize] = u;
                if mate_of_right[v as usize] == NONE {
                    end = Some(v);
                    break 'search;
                }
                queue.push(mate_of_right[v as usize]);
            }
        }
        let Some(mut v) = end else {
            queue.iter().for_each(|&u| left_reached[u as usize] = true);
            continue;
        };
        // Flips the path.
        loop {
            let u = parent_of_right[v as usize];
            let previous = std::mem::replace(&mut mate_of_left[u as usize], v);
            mate_of_right[v as usize] = u;
            if u == root {
                break;
            }
            v = previous;
        }
        // Unmarks the tree: the parents this search gave are in the queue.
        for &u in &queue[..head] {
            for &v in targets(u) {
                if parent_of_right[v as usize] == u {
                    parent_of_right[v as usize] = NONE;
                }
            }
        }
    }
    let left_cover = left_reached.iter().map(|reached| !reached).collect();
    let right_cover = parent_of_right
        .iter()
        .map(|&parent| parent != NONE)
        .collect();
    (left_cover, right_cover)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Size of a minimum vertex cover by trying every set of left vertices: the right
    /// vertices it needs are the neighbours of the rest.
    fn smallest_cover(n_left: usize, edges: &[(u32, u32)]) -> usize {
        (0_u32..1 << n_left)
            .map(|set| {
                let needed = edges
                    .iter()
                    .filter(|&&(u, _)| set >> u & 1 == 0)
                    .fold(0_u32, |needed, &(_, v)| needed | 1 << v);
                (set.count_ones() + needed.count_ones()) as usize
            })
            .min()
            .unwrap()
    }

    fn bipartite(n_left: usize, n_right: usize, edges: &[(u32, u32)]) -> Bipartite {
        let mut graph = Bipartite {
            starts: vec![0],
            targets: Vec::new(),
            n_right,
        };
        for u in 0..n_left as u32 {
            graph
                .targets
                .extend(edges.iter().filter(|e| e.0 == u).map(|e| e.1));
            graph.starts.push(graph.targets.len() as u32);
        }
        graph
    }

    proptest! {
        #[test]
        fn covers_every_edge_with_as_few_as_possible(
            edges in proptest::collection::vec((0_u32..8, 0_u32..9), 0..30)
        ) {
            let (left, right) = minimum_vertex_cover(&bipartite(8, 9, &edges));
            for &(u, v) in &edges {
                prop_assert!(left[u as usize] || right[v as usize]);
            }
            let size = left.iter().chain(&right).filter(|&&in_cover| in_cover).count();
            prop_assert_eq!(size, smallest_cover(8, &edges));
        }
    }

    #[test]
    fn an_empty_graph_needs_no_cover() {
        let (left, right) = minimum_vertex_cover(&Bipartite::default());
        assert!(left.is_empty() && right.is_empty());
    }
}
