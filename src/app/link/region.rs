//! A set of vertices as a few characters of an address: run lengths where the vertices lie
//! together, else a bit for each, whichever is shorter.

use super::base64;
use super::words::LONGEST;

/// No vertex beyond.
const MOST: u64 = 1 << 24;

/// A set of vertices that takes no more room than its text.
pub(in crate::app) struct Region {
    /// First vertex and the one after the last, ascending.
    runs: Vec<(u32, u32)>,
}

impl Region {
    /// Number of vertices.
    pub(in crate::app) fn count(&self) -> usize {
        self.runs.iter().map(|(a, b)| (b - a) as usize).sum()
    }

    /// Ascending.
    pub(in crate::app) fn vertices(&self) -> impl Iterator<Item = u32> + '_ {
        self.runs.iter().flat_map(|&(a, b)| a..b)
    }

    fn push(&mut self, first: u32, end: u32) {
        match self.runs.last_mut() {
            Some(last) if last.1 == first => last.1 = end,
            _ => self.runs.push((first, end)),
        }
    }
}

/// Lengths of the runs of absent and present vertices in turn, absent first; seven bits a byte,
/// low ones first.
fn run_lengths(region: &Region) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut put = |mut rest: u32| {
        while rest > 127 {
            bytes.push((rest & 127) as u8 | 128);
            rest >>= 7;
        }
        bytes.push(rest as u8);
    };
    let mut end = 0;
    for &(first, next) in &region.runs {
        put(first - end);
        put(next - first);
        end = next;
    }
    bytes
}

fn from_run_lengths(bytes: &[u8]) -> Option<Region> {
    let mut region = Region { runs: Vec::new() };
    let (mut at, mut is_in) = (0, false);
    let (mut length, mut shift) = (0_u64, 0);
    for &byte in bytes {
        if shift > 28 {
            return None;
        }
        length |= u64::from(byte & 127) << shift;
        shift += 7;
        if at + length > MOST {
            return None;
        }
        if byte > 127 {
            continue;
        }
        if is_in && length > 0 {
            region.push(at as u32, (at + length) as u32);
        }
        at += length;
        is_in = !is_in;
        (length, shift) = (0, 0);
    }
    // Cut off in the middle of a number, or of a pair of runs.
    (shift == 0 && !is_in).then_some(region)
}

fn bits(region: &Region) -> Vec<u8> {
    let end = region.runs.last().map_or(0, |run| run.1);
    let mut bytes = vec![0; end.div_ceil(8) as usize];
    for v in region.vertices() {
        bytes[v as usize >> 3] |= 1 << (v & 7);
    }
    bytes
}

fn from_bits(bytes: &[u8]) -> Region {
    let mut region = Region { runs: Vec::new() };
    for (n, byte) in (0..).zip(bytes) {
        for bit in (0..8).filter(|bit| byte & 1 << bit != 0) {
            region.push(8 * n + bit, 8 * n + bit + 1);
        }
    }
    region
}

/// As text; `None` where that would be longer than a link may be.
pub(super) fn encode(vertices: &[u32]) -> Option<String> {
    let mut sorted = vertices.to_vec();
    sorted.sort_unstable();
    sorted.dedup();
    let mut region = Region { runs: Vec::new() };
    sorted.iter().for_each(|&v| region.push(v, v + 1));
    let end = region.runs.last().map_or(0, |run| run.1);
    if u64::from(end) > MOST {
        return None;
    }
    let runs = run_lengths(&region);
    let in_bits = end.div_ceil(8) as usize;
    if 1 + base64::length(runs.len().min(in_bits)) > LONGEST {
        return None;
    }
    Some(if runs.len() <= in_bits {
        format!("r{}", base64::encode(&runs))
    } else {
        format!("b{}", base64::encode(&bits(&region)))
    })
}

/// `None` where the text is no region.
pub(in crate::app) fn parse(text: &str) -> Option<Region> {
    if text.len() > LONGEST {
        return None;
    }
    match text.split_at_checked(1)? {
        ("r", digits) => from_run_lengths(&base64::decode(digits)?),
        ("b", digits) => Some(from_bits(&base64::decode(digits)?)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn decoded(text: &str) -> Option<Vec<u32>> {
        parse(text).map(|region| region.vertices().collect())
    }

    proptest! {
        #[test]
        fn regions_come_back_whole_however_they_lie(
            mut vertices in prop::collection::vec(0_u32..5000, 0..400),
        ) {
            let text = encode(&vertices).expect("short");
            vertices.sort_unstable();
            vertices.dedup();
            prop_assert_eq!(parse(&text).expect("a region").count(), vertices.len());
            prop_assert_eq!(decoded(&text), Some(vertices));
        }
    }

    #[test]
    fn a_run_is_short_wherever_it_lies() {
        let far: Vec<u32> = (9_000_000..9_001_000).collect();
        let text = encode(&far).expect("short");
        assert!(text.len() < 12, "{text}");
        assert_eq!(decoded(&text), Some(far));
    }

    #[test]
    fn a_region_that_no_link_can_hold_is_none() {
        let scattered: Vec<u32> = (0..60_000).map(|v| 2 * v).collect();
        assert_eq!(encode(&scattered), None);
        let fits = encode(&scattered[..17_000]).expect("short");
        assert!(fits.len() <= LONGEST);
        assert_eq!(encode(&[1 << 25]), None, "it could not be read again");
    }

    #[test]
    fn nonsense_is_no_region() {
        for text in [
            "",
            "x",
            "é",
            "q12",
            "r%%",
            "r____________",
            "rgA",
            "r*",
            "rB",
            // A run of 2²⁵ vertices, in five bytes.
            "rAICAgBA",
        ] {
            assert_eq!(decoded(text), None, "{text}");
        }
        assert_eq!(decoded(&format!("b{}", "A".repeat(7000))), None);
    }
}
