//! Colour maps and the palettes of the two themes, in sRGB.

use colorous::{RED_BLUE, VIRIDIS};

/// Texels of a colour map on the GPU.
pub const MAP_LENGTH: usize = 256;

/// Share of the diverging map left out at each end.
const DARK_END: f64 = 0.12;

/// `n` colours of a map from low to high, as r, g, b bytes.
///
/// Sequential: viridis, perceptually uniform and readable by the colour-blind.
/// Signed: blue below zero, white at zero, red above (`RdBu` of ColorBrewer, reversed),
/// without its ends, which are too dark to carry shading.
pub fn colour_bar(signed: bool, n: usize) -> Vec<u8> {
    let colour = |i: usize| {
        // One colour alone is the middle of the map.
        let t = if n > 1 {
            i as f64 / (n - 1) as f64
        } else {
            0.5
        };
        let colour = if signed {
            RED_BLUE.eval_continuous(1.0 - DARK_END - (1.0 - 2.0 * DARK_END) * t)
        } else {
            VIRIDIS.eval_continuous(t)
        };
        colour.as_array()
    };
    (0..n).flat_map(colour).collect()
}

/// A colour map as RGBA texels, [`MAP_LENGTH`] of them.
pub fn map_texels(signed: bool) -> Vec<u8> {
    let opaque = |rgb: &[u8]| [rgb[0], rgb[1], rgb[2], 255];
    colour_bar(signed, MAP_LENGTH)
        .chunks_exact(3)
        .flat_map(opaque)
        .collect()
}

/// Light or dark surroundings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// White room: for print and bright lecture halls.
    Light,
    /// Dark room: for projectors and screens.
    #[default]
    Dark,
}

/// Colours of a theme, `0xrrggbb` in sRGB.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette {
    /// Background behind the surface …
    pub glow: u32,
    /// … and in the corners.
    pub corner: u32,
    /// Side of the surface that winds anticlockwise.
    pub front: u32,
    /// Other side of an orientable surface.
    pub back: u32,
    /// Held vertices.
    pub fixed: u32,
    /// Marked triangles.
    pub marked: u32,
    /// Edges of the mesh.
    pub wire: u32,
    /// Boundary loops.
    pub boundary: u32,
}

impl Theme {
    /// The theme's colours.
    pub fn palette(self) -> Palette {
        match self {
            Self::Light => Palette {
                glow: 0xfbfaf7,
                corner: 0xd9d5cc,
                front: 0xe0cdb2,
                back: 0x7f93ad,
                fixed: 0x4f9e8f,
                marked: 0xe4572e,
                wire: 0x2a2420,
                boundary: 0xc23616,
            },
            Self::Dark => Palette {
                glow: 0x2f343d,
                corner: 0x0d0e11,
                front: 0xe0cdb2,
                back: 0x8fa8cf,
                fixed: 0x4f9e8f,
                marked: 0xff6b3d,
                wire: 0x14110f,
                boundary: 0xffb347,
            },
        }
    }
}

/// Linear light of an sRGB colour `0xrrggbb`, opaque (IEC 61966-2-1).
pub fn linear(srgb: u32) -> [f32; 4] {
    let channel = |shift: u32| {
        let encoded = (srgb >> shift & 0xff) as f32 / 255.0;
        if encoded <= 0.04045 {
            encoded / 12.92
        } else {
            ((encoded + 0.055) / 1.055).powf(2.4)
        }
    };
    [channel(16), channel(8), channel(0), 1.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sequential_map_grows_lighter_all_the_way() {
        let luminance = |rgb: &[u8]| {
            let packed = u32::from_be_bytes([0, rgb[0], rgb[1], rgb[2]]);
            let [r, g, b, _] = linear(packed);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        let bar = colour_bar(false, 64);
        let steps: Vec<f32> = bar.chunks_exact(3).map(luminance).collect();
        assert!(steps.is_sorted());
        assert!(steps[0] < 0.03 && steps[63] > 0.7);
    }

    #[test]
    fn diverging_map_is_blue_white_red() {
        let bar = colour_bar(true, 3);
        assert!(bar[2] > bar[0] + 30, "low end {:?} is not blue", &bar[..3]);
        assert!(
            bar[3..6].iter().all(|&channel| channel > 230),
            "middle {:?}",
            &bar[3..6]
        );
        assert!(bar[6] > bar[8] + 30, "high end {:?} is not red", &bar[6..]);
    }

    #[test]
    fn any_number_of_colours_can_be_had() {
        for n in [0, 1, 2, 7, 256] {
            assert_eq!(colour_bar(true, n).len(), 3 * n);
            assert_eq!(colour_bar(false, n).len(), 3 * n);
        }
        assert_eq!(map_texels(false).len(), 4 * MAP_LENGTH);
    }

    #[test]
    fn linear_light_of_known_colours() {
        assert_eq!(linear(0xffffff), [1.0; 4]);
        assert_eq!(linear(0x000000), [0.0, 0.0, 0.0, 1.0]);
        // The mid grey of sRGB, 0xbc, is half as bright as white.
        assert!((linear(0x00bc00)[1] - 0.5).abs() < 5e-3);
    }
}
