//! Sorting by one piece of compiled code. Each call of the standard library's sorts is compiled
//! anew for its type and its order, 4 to 9 kB of wasm each; in a download that people wait for,
//! lists that are short or rarely sorted share this one. Where sorting takes time, the standard
//! library's is called.

use std::cmp::Ordering;

/// Sorts by an order; what is equal in it stays in order.
pub fn sort_by<T>(items: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    let places = places(items.len(), &|i, j| compare(&items[i], &items[j]));
    permute(items, places);
}

/// Sorts by a key; what has equal keys stays in order.
pub fn sort_by_key<T, K: Ord>(items: &mut [T], key: impl Fn(&T) -> K) {
    sort_by(items, |a, b| key(a).cmp(&key(b)));
}

/// Sorts from the least to the largest.
pub fn sort<T: Ord>(items: &mut [T]) {
    sort_by(items, T::cmp);
}

/// Sorts what comes with a number below `n` by that number, in time proportional to both counts;
/// what has equal numbers stays in order. Gives where each number begins, and the end, with it.
pub fn bucketed<T: Copy + Default>(
    n: usize,
    items: impl Iterator<Item = (u32, T)> + Clone,
) -> (Vec<u32>, Vec<T>) {
    let mut start = vec![0_u32; n + 1];
    for (bucket, _) in items.clone() {
        start[bucket as usize + 1] += 1;
    }
    for i in 1..start.len() {
        start[i] += start[i - 1];
    }
    let mut sorted = vec![T::default(); start[n] as usize];
    let mut free = start.clone();
    for (bucket, item) in items {
        let at = &mut free[bucket as usize];
        sorted[*at as usize] = item;
        *at += 1;
    }
    (start, sorted)
}

/// For each place of the sorted list, where its item stands now.
fn places(n: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut places: Vec<usize> = (0..n).collect();
    places.sort_unstable_by(|&i, &j| compare(i, j).then(i.cmp(&j)));
    places
}

/// Moves the item at `places[k]` to place k, for all k, along the cycles of the permutation.
fn permute<T>(items: &mut [T], mut places: Vec<usize>) {
    for start in 0..items.len() {
        let mut k = start;
        loop {
            let from = std::mem::replace(&mut places[k], k);
            if from == start {
                break;
            }
            items.swap(k, from);
            k = from;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers with repetitions, in no order.
    fn shuffled(n: u32) -> Vec<(u32, u32)> {
        (0..n)
            .map(|i| (i.wrapping_mul(2_654_435_761) >> 20) % 37)
            .zip(0..)
            .collect()
    }

    #[test]
    fn sorts_as_the_standard_library_and_keeps_equals_in_order() {
        for n in [0, 1, 2, 3, 19, 20, 21, 500] {
            let mut ours = shuffled(n);
            let mut theirs = ours.clone();
            sort_by_key(&mut ours, |item| item.0);
            theirs.sort_by_key(|item| item.0);
            assert_eq!(ours, theirs);
            let mut back = ours;
            sort_by(&mut back, |a, b| b.1.cmp(&a.1));
            assert!(back.is_sorted_by_key(|item| std::cmp::Reverse(item.1)));
            sort(&mut back);
            assert_eq!(back, theirs);
        }
    }

    #[test]
    fn buckets_are_what_a_stable_sort_by_their_numbers_gives() {
        for n in [0, 1, 500] {
            let ours = shuffled(n);
            let (start, sorted) = bucketed(40, ours.iter().map(|item| (item.0, *item)));
            let mut theirs = ours;
            theirs.sort_by_key(|item| item.0);
            assert_eq!(sorted, theirs);
            assert_eq!(start.len(), 41);
            for (bucket, range) in (0..).zip(start.windows(2)) {
                let items = &sorted[range[0] as usize..range[1] as usize];
                assert!(items.iter().all(|item| item.0 == bucket));
            }
        }
    }

    #[test]
    fn items_that_cannot_be_copied_are_moved() {
        let mut words: Vec<String> = ["surface", "of", "least", "bending"]
            .map(String::from)
            .into();
        sort_by_key(&mut words, String::len);
        assert_eq!(words, ["of", "least", "surface", "bending"]);
    }
}
