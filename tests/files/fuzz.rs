//! Damaged files: whatever comes in, an answer comes out, and what is accepted is sound. A short run
//! of fixed seed is a test as any; a long one is this, with seconds for each format:
//!
//! ```text
//! FUZZ_SECONDS=60 cargo test --release --test files fuzz -- --nocapture
//! ```
//!
//! `FUZZ_SEED` begins elsewhere. Under `ulimit -v` what asks for too much memory aborts; the file
//! that stops a run is left in the system's folder for temporary files.

use crate::colours::{coloured, triangle_in_light};
use crate::mesh::{cube, octahedron};
use crate::{gltf, msh, packed, plain, solid, three_mf, vtk, vtp};
use std::time::{Duration, Instant};
use umbilic::io::packed::{File, mesh_among};
use umbilic::io::{self, Format};

/// Files that are damaged without a command of their own.
const SHORT: u64 = 400;

/// Numbers as if at random: xorshift64*.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() >> 11) as usize % n.max(1)
    }
}

/// Sound files of a format.
fn seeds(format: Format) -> Vec<Vec<u8>> {
    let soup = cube(0.0, 1.0);
    let in_light = (format == Format::Glb).then(|| {
        [5121, 5123, 5126].map(|kind| triangle_in_light(kind, [&[0.1, 0.2, 0.3, 0.4]; 3]))
    });
    match format {
        Format::Vtk => vtk::variants()
            .into_iter()
            .map(|(_, style)| vtk::file(&soup, style))
            .chain(solid::files(format))
            .collect(),
        Format::Vtp => vtp::variants()
            .into_iter()
            .map(|style| vtp::file(&soup, style))
            .collect(),
        Format::Msh => msh::variants()
            .into_iter()
            .map(|style| msh::file(&soup, style))
            .chain(solid::files(format))
            .collect(),
        Format::ThreeMf => three_mf::variants(),
        Format::Glb | Format::Gltf => gltf::variants()
            .into_iter()
            .filter(|style| style.binary == (format == Format::Glb))
            .map(|style| gltf::file(&octahedron(), style, "", ""))
            .chain(in_light.into_iter().flatten())
            .chain((format == Format::Glb).then(|| gltf::sparse([1, 4])))
            .collect(),
        _ => [soup, coloured(true, true), coloured(false, false)]
            .iter()
            .map(|soup| io::write(soup, format, "a comment").unwrap())
            .chain(plain::variants(format))
            .collect(),
    }
}

/// Numbers that readers must not trust.
const NUMBERS: [&str; 14] = [
    "0",
    "-1",
    "1",
    "255",
    "256",
    "65536",
    "4294967295",
    "4294967296",
    "1e400",
    "nan",
    "",
    "9223372036854775808",
    "99999999999999999999",
    "0.5",
];

/// Damages a file in one of the ways that files are damaged by accident or on purpose.
fn damage(bytes: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    if bytes.is_empty() {
        return;
    }
    let at = random.below(bytes.len());
    match random.below(9) {
        0 => bytes[at] ^= 1 << random.below(8),
        1 => bytes[at] = random.next() as u8,
        2 => bytes.truncate(at),
        // A piece is lost, or is there twice.
        3 => {
            let end = at + random.below(40).min(bytes.len() - at);
            bytes.drain(at..end);
        }
        4 => {
            let end = at + random.below(40).min(bytes.len() - at);
            let piece = bytes[at..end].to_vec();
            let to = random.below(bytes.len());
            bytes.splice(to..to, piece);
        }
        // A piece of another file.
        5 => {
            let from = random.below(other.len());
            let piece = &other[from..(from + random.below(60)).min(other.len())];
            let end = (at + piece.len()).min(bytes.len());
            bytes.splice(at..end, piece.iter().copied());
        }
        // A number in binary.
        6 => {
            let number = [0, u64::MAX, 1 << 31, 1 << 32, 0xFFFF, 1 << 40][random.below(6)];
            let size = [1, 2, 4, 8][random.below(4)];
            for (to, from) in bytes[at..].iter_mut().zip(&number.to_le_bytes()[..size]) {
                *to = *from;
            }
        }
        // A number in text.
        7 => {
            let is_digit = |b: &u8| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+');
            let Some(start) = bytes[at..].iter().position(is_digit).map(|n| at + n) else {
                return;
            };
            let end = bytes[start..].iter().position(|b| !is_digit(b));
            let end = end.map_or(bytes.len(), |n| start + n);
            let number = NUMBERS[random.below(NUMBERS.len())];
            bytes.splice(start..end, number.bytes());
        }
        _ => {
            let b = b" \n\r\t,<>/\"'{}[]$_=\0"[random.below(18)];
            bytes.insert(at, b);
        }
    }
}

/// Reads a file; what is accepted is written and read again.
fn check(bytes: &[u8], name: &str) -> bool {
    let Ok(read) = io::read(bytes, name) else {
        return false;
    };
    assert!(read.soup.positions.iter().all(|p| p.is_finite()));
    assert!(read.soup.faces().all(|face| face.len() >= 3));
    let written = io::write(&read.soup, Format::Ply, "").unwrap();
    let again = io::read(&written, "").unwrap();
    assert_eq!(again.soup, read.soup);
    true
}

/// Unpacks a file: no more comes out than may.
fn unpack(bytes: &[u8], name: &str) -> bool {
    let file = File {
        name: name.to_owned(),
        bytes: bytes.into(),
    };
    let Ok(found) = mesh_among(&[file]) else {
        return false;
    };
    // Gzip within ZIP is unpacked twice.
    assert!(found.bytes.len() <= (1 << 24).max(200 * 200 * bytes.len()));
    true
}

/// What files of a name are given to, and sound ones.
type Target = (String, fn(&[u8], &str) -> bool, Vec<Vec<u8>>);

fn targets() -> Vec<Target> {
    let formats = Format::all().map(|format| {
        let name = format!("a.{}", format.extensions()[0]);
        (name, check as fn(&[u8], &str) -> bool, seeds(format))
    });
    let zip = ("a.zip".to_owned(), unpack as _, packed::variants());
    formats.chain([zip]).collect()
}

#[test]
fn fuzz() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let seconds: Option<u64> = number("FUZZ_SECONDS");
    let mut random = Random(number("FUZZ_SEED").unwrap_or(0x9E37_79B9_7F4A_7C15));
    let mut total = 0;
    let begun = Instant::now();
    for (name, check, seeds) in targets() {
        for seed in &seeds {
            assert!(check(seed, &name), "{name}");
        }
        let (mut runs, mut accepted) = (0_u64, 0_u64);
        let start = Instant::now();
        let limit = Duration::from_secs(seconds.unwrap_or(0));
        while runs < SHORT || (seconds.is_some() && start.elapsed() < limit) {
            let mut bytes = seeds[random.below(seeds.len())].clone();
            let other = &seeds[random.below(seeds.len())];
            for _ in 0..=random.below(4) {
                damage(&mut bytes, other, &mut random);
            }
            let answer = std::panic::catch_unwind(|| check(&bytes, &name));
            let Ok(is_read) = answer else {
                let file = std::env::temp_dir().join(format!("umbilic-fuzz-{name}"));
                std::fs::write(&file, &bytes).unwrap();
                panic!("{name}: run {runs}, see {}", file.display());
            };
            runs += 1;
            accepted += u64::from(is_read);
        }
        let rate = runs as f64 / start.elapsed().as_secs_f64();
        println!("{name}: {runs} runs, {accepted} accepted, {rate:.0} a second");
        total += runs;
    }
    let rate = total as f64 / begun.elapsed().as_secs_f64();
    println!("in all {total} runs, {rate:.0} a second");
}
