//! Segments of space over the surface, such as circles and directions.

use bytemuck::{Pod, Zeroable};

use super::colour::linear;
use super::error::ViewerError;

/// One instance of the line shader.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Segment {
    /// One end.
    pub start: [f32; 3],
    /// The other.
    pub end: [f32; 3],
    /// Linear light and opacity.
    pub colour: [f32; 4],
}

/// Segments by their ends, three coordinates each, and r, g, b, a in sRGB bytes a segment.
///
/// # Errors
/// `WrongLength` where the arrays do not fit each other.
pub fn segments(ends: &[f32], colours: &[u8]) -> Result<Vec<Segment>, ViewerError> {
    let count = colours.len() / 4;
    for (array, found, expected) in [
        ("overlay-colours", colours.len(), 4 * count),
        ("overlay", ends.len(), 6 * count),
    ] {
        if found != expected {
            return Err(ViewerError::WrongLength {
                array,
                expected,
                found,
            });
        }
    }
    // Neighbours mostly share a colour, and its light is the dearest part.
    let mut last = (0, linear(0));
    let mut light = |srgb: u32| {
        if last.0 != srgb {
            last = (srgb, linear(srgb));
        }
        last.1
    };
    let pairs = ends.chunks_exact(6).zip(colours.chunks_exact(4));
    Ok(pairs
        .filter(|(ends, _)| ends.iter().all(|c| c.is_finite()))
        .map(|(e, c)| {
            let [r, g, b, _] = light(u32::from_be_bytes([0, c[0], c[1], c[2]]));
            Segment {
                start: [e[0], e[1], e[2]],
                end: [e[3], e[4], e[5]],
                colour: [r, g, b, f32::from(c[3]) / 255.0],
            }
        })
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::Say;

    #[test]
    fn ends_and_colours_belong_together() {
        let ends = [0., 1., 2., 3., 4., 5., 0., 0., f32::NAN, 1., 1., 1.];
        let colours = [255, 0, 0, 255, 0, 0, 255, 51];
        let made = segments(&ends, &colours).expect("they fit");
        assert_eq!(made.len(), 1, "what is not finite is left out");
        assert_eq!((made[0].start, made[0].end), ([0., 1., 2.], [3., 4., 5.]));
        assert_eq!(made[0].colour, [1.0, 0.0, 0.0, 1.0]);
        assert_eq!(
            segments(&ends, &colours[..4]).expect_err("short").kind(),
            "WrongLength"
        );
        assert!(segments(&ends, &colours[..7]).is_err());
        assert!(segments(&[], &[]).expect("none").is_empty());
    }
}
