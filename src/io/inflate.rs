//! Bytes compressed by zlib: RFC 1950 around the Deflate of RFC 1951.

/// So many bytes from zlib's data; `None` where they are damaged, or would be more or fewer. Nothing
/// past `length` is ever kept.
pub(super) fn inflate(zlib: &[u8], length: usize) -> Option<Vec<u8>> {
    let (head, rest) = zlib.split_first_chunk::<2>()?;
    let is_zlib = head[0] & 15 == 8 && u16::from_be_bytes(*head) % 31 == 0 && head[1] & 32 == 0;
    if !is_zlib {
        return None;
    }
    let mut bits = Bits {
        bytes: rest,
        at: 0,
        held: 0,
        count: 0,
    };
    // The format makes at most 1032 bytes of one.
    let mut out = Vec::with_capacity(length.min(rest.len().saturating_mul(1032)));
    loop {
        let is_last = bits.take(1)? == 1;
        match bits.take(2)? {
            0 => stored(&mut bits, &mut out, length)?,
            1 => {
                let lengths = std::array::from_fn::<u8, 288, _>(|symbol| match symbol {
                    0..144 => 8,
                    144..256 => 9,
                    256..280 => 7,
                    _ => 8,
                });
                compressed(
                    &mut bits,
                    &mut out,
                    length,
                    &Code::new(&lengths),
                    &Code::new(&[5; 30]),
                )?;
            }
            2 => {
                let (literals, distances) = codes(&mut bits)?;
                compressed(&mut bits, &mut out, length, &literals, &distances)?;
            }
            _ => return None,
        }
        if is_last {
            break;
        }
    }
    let sum = bits.after().first_chunk::<4>()?;
    (out.len() == length && u32::from_be_bytes(*sum) == adler(&out)).then_some(out)
}

/// The sum that the data ends with.
fn adler(bytes: &[u8]) -> u32 {
    let (mut a, mut b) = (1_u32, 0_u32);
    // So many do not overflow.
    for chunk in bytes.chunks(5552) {
        for byte in chunk {
            a += u32::from(*byte);
            b += a;
        }
        a %= 65521;
        b %= 65521;
    }
    b << 16 | a
}

/// Bits, the lowest of a byte first.
struct Bits<'a> {
    bytes: &'a [u8],
    at: usize,
    held: u32,
    count: u32,
}

impl<'a> Bits<'a> {
    fn take(&mut self, count: u32) -> Option<u32> {
        while self.count < count {
            self.held |= u32::from(*self.bytes.get(self.at)?) << self.count;
            self.at += 1;
            self.count += 8;
        }
        let taken = self.held & ((1 << count) - 1);
        self.held >>= count;
        self.count -= count;
        Some(taken)
    }

    /// The bytes after the one that the last bit was of. No more than seven bits are ever held.
    fn after(&mut self) -> &'a [u8] {
        (self.held, self.count) = (0, 0);
        self.bytes.get(self.at..).unwrap_or_default()
    }
}

/// A prefix code: how many words there are of each length, and their symbols in order.
struct Code {
    counts: [u16; 16],
    symbols: Vec<u16>,
}

impl Code {
    /// From the length of each symbol's word, 0 where it has none.
    fn new(lengths: &[u8]) -> Self {
        let mut counts = [0; 16];
        let mut symbols: Vec<u16> = Vec::with_capacity(lengths.len());
        for length in 1..16_u8 {
            let of_length = (0..).zip(lengths).filter(|(_, l)| **l == length);
            symbols.extend(of_length.map(|(symbol, _)| symbol));
            counts[usize::from(length)] = lengths.iter().filter(|l| **l == length).count() as u16;
        }
        Self { counts, symbols }
    }

    /// The symbol of the next word.
    fn read(&self, bits: &mut Bits<'_>) -> Option<u16> {
        // Words of one length are numbers in a row, after those of the length before.
        let (mut word, mut first, mut before) = (0, 0, 0);
        for count in &self.counts[1..] {
            let count = u32::from(*count);
            word |= bits.take(1)?;
            if word < first + count {
                let at = before + word.checked_sub(first)?;
                return self.symbols.get(at as usize).copied();
            }
            before += count;
            first = (first + count) << 1;
            word <<= 1;
        }
        None
    }
}

fn stored(bits: &mut Bits<'_>, out: &mut Vec<u8>, most: usize) -> Option<()> {
    let after = bits.after();
    let (head, rest) = after.split_first_chunk::<4>()?;
    let length = u16::from_le_bytes([head[0], head[1]]);
    if length != !u16::from_le_bytes([head[2], head[3]]) {
        return None;
    }
    let length = usize::from(length);
    let bytes = rest.get(..length)?;
    if out.len() + length > most {
        return None;
    }
    out.extend_from_slice(bytes);
    bits.at += 4 + length;
    Some(())
}

/// The two codes of a block that brings its own.
fn codes(bits: &mut Bits<'_>) -> Option<(Code, Code)> {
    const ORDER: [usize; 19] = [
        16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15,
    ];
    let literals = bits.take(5)? as usize + 257;
    let distances = bits.take(5)? as usize + 1;
    let mut lengths = [0; 19];
    for place in &ORDER[..bits.take(4)? as usize + 4] {
        lengths[*place] = bits.take(3)? as u8;
    }
    let code = Code::new(&lengths);
    let mut lengths = Vec::with_capacity(literals + distances);
    while lengths.len() < literals + distances {
        let (length, times) = match code.read(bits)? {
            16 => (*lengths.last()?, 3 + bits.take(2)?),
            17 => (0, 3 + bits.take(3)?),
            18 => (0, 11 + bits.take(7)?),
            length => (length as u8, 1),
        };
        lengths.extend(std::iter::repeat_n(length, times as usize));
    }
    let (literals, rest) = lengths.split_at(literals);
    (rest.len() == distances).then(|| (Code::new(literals), Code::new(rest)))
}

fn compressed(
    bits: &mut Bits<'_>,
    out: &mut Vec<u8>,
    most: usize,
    literals: &Code,
    distances: &Code,
) -> Option<()> {
    loop {
        let symbol = u32::from(literals.read(bits)?);
        let length = match symbol {
            0..256 => {
                if out.len() == most {
                    return None;
                }
                out.push(symbol as u8);
                continue;
            }
            256 => return Some(()),
            // From 8 on a further bit every four symbols.
            257..265 => symbol - 254,
            265..285 => {
                let extra = (symbol - 261) / 4;
                3 + (((symbol - 265) % 4 + 4) << extra) + bits.take(extra)?
            }
            285 => 258,
            _ => return None,
        };
        let distance = match u32::from(distances.read(bits)?) {
            symbol @ 0..4 => symbol + 1,
            symbol @ 4..30 => {
                let extra = symbol / 2 - 1;
                1 + ((2 + symbol % 2) << extra) + bits.take(extra)?
            }
            _ => return None,
        };
        let start = out.len().checked_sub(distance as usize)?;
        if out.len() + length as usize > most {
            return None;
        }
        for at in start..start + length as usize {
            out.push(out[at]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Made by zlib, levels 0, 1 (a fixed code) and 9 (codes of its own).
    fn examples() -> Vec<(Vec<u8>, Vec<u8>)> {
        let bytes = |hex: &str| -> Vec<u8> {
            let pairs = hex.as_bytes().chunks(2);
            pairs
                .map(|pair| u8::from_str_radix(std::str::from_utf8(pair).unwrap(), 16).unwrap())
                .collect()
        };
        vec![
            (
                bytes("7801010700f8ff756d62696c69630bcf02e6"),
                b"umbilic".to_vec(),
            ),
            (
                bytes("78014b4cc40e929201851d09de"),
                b"aaaaaaaaaaaaaaaaaaaaaaaabc".to_vec(),
            ),
            (
                bytes(
                    "78daed9369969b3000838dc31a0ffb9200c10498800906c6618df1fdcfd5763a87e88f1e404f4f9f2400a0ac9b\
                     7e52768bec602aec6246f7d5214a7e247bfccee0e383254a9f6853e92b4b8b0324f3e5ab7fb6ed938ed30e0d2f\
                     ad9964e301068d083a056f21734797853b56bb5090f034e60e9c9acc4727beb081765d3f4e1b50ad4b41773daa\
                     5794311d2f4eab16008b1c7e1a7d783c9c771dcaaf2a320e46eeb16f215d53351dd94152b42f80ae8f59bdb4c2\
                     27d2959944ad4ea552a321e49fd656b98266369c088e2c1d1edb32cfcbc625cd0cb38601337d72eb3ea362f39e\
                     5a296181a54aa7febb34d7ca053d76e5b52b63ef433b81831f022a673bc20d13e8daace77490e3d128f8e5e58d\
                     ee57b0a4b071b6d27a37176d2537573b265a97f89624c92dafc8b0807370a71ca5540a088806a302b73dde5351\
                     685dc01f0e6f2275ae6313ae7d9d27a1e7d8b6e385495ef72b34e37a56a3863b0f1e745a21d2dfc21ba88c2102\
                     2490688a38bd0767b00ca4cabf0d7159d3e9d0dc1b59b54bf3b6cacd6960ba045feee8bd2ebc30c6581ed2f3da\
                     5c91600d8eecb302c5ef88e0a47d7871d9adb28b7be056ab59be7daa57df684aede96d059aef167fa626604d16\
                     9a9ac4ff323da06e45984cd0cea870abcdfae4e1806aa53c552a31d95522be682feafcb822f06a8b24b07f4ab4\
                     fcf84ed86144d54b0eebb7f338c2def884b9c0a0505b67c13acbd05a47fa4e8b8ba5826d1afbaea3035bf809f9\
                     593341271f4f211161a7e2fd676e1b56ba4034011cb02db13af50cb84f23fdb3d3fe6be1320a70bb287e396949\
                     af24ece301b377bc2747ae1067bda3b9b005c58ebc7465e29bba0c01f87f8c7ff118bf009ce08c70",
                ),
                (0..1200_u32).map(|k| (k * k * 7 / 13 % 61) as u8).collect(),
            ),
            (
                bytes(
                    "78daedd4491100300c00a1f4f0afb91676fa0611cc502db24d76c82e99b1ddee76b7bbdded6ec7ed6e77bbdbdd\
                     ee76dcee76b7bbdded6ec7ed6e77bbdbddee76dcee76b7bbdded6ec7ed6e77bbdbddee76dcee76b7bbdded6ec7\
                     d86e77bbdbddee76b7e376b7bbdded6e773b6e77bbdbddee76b7e376b7bbdded6e773b6e77bbdbddee76b7e376\
                     b7bbdded6e773b6e77bbdbddee76b7636cb7bbdded6e77bbdb71bbdbddee76b7bb1db7bbdded6e77bbdb71bbdb\
                     ddee76b7bb1db7bbdded6e77bbdb71bbdbddee76b7bb1db7bbdded6e77bbdbff3d80db3570",
                ),
                (0..40000_u32).map(|k| (k / 300 % 5) as u8).collect(),
            ),
        ]
    }

    #[test]
    fn what_zlib_made_comes_back() {
        for (zlib, plain) in examples() {
            assert_eq!(inflate(&zlib, plain.len()), Some(plain.clone()));
            assert_eq!(inflate(&zlib, plain.len() + 1), None, "too few");
            assert_eq!(inflate(&zlib, plain.len() - 1), None, "too many");
            assert_eq!(inflate(&zlib[..zlib.len() - 1], plain.len()), None);
            for at in 0..zlib.len() {
                let mut damaged = zlib.clone();
                damaged[at] ^= 4;
                // Bits after the last word are nobody's: what they are changes nothing.
                let found = inflate(&damaged, plain.len());
                assert!(found.is_none_or(|found| found == plain), "{at}");
            }
        }
    }
}
