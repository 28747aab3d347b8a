//! Colour maps and the palettes of the two themes, in sRGB.

use colorous::INFERNO;

/// Texels of a colour map on the GPU.
pub const MAP_LENGTH: usize = 256;

/// Share of the sequential map of high contrast left out at its low end, which is black: nothing
/// could be told by its shading there.
const BLACK_END: f64 = 0.1;

/// The signed map at equal distances, `0xrrggbb`: blue below zero, nearly white at zero, ochre
/// above. Its upper half alone is the map of what has no sign.
const BLUE_OCHRE: [u32; 5] = [0x1f5f9e, 0x7fb2d6, 0xf0ece4, 0xe8b06a, 0xa8560f];

/// The signed map of high contrast at equal distances, `0xrrggbb`. In CIELAB its L* are 10, 30,
/// 52, 76, 98 and back: equal on both sides of zero, so that size is seen as lightness and sign
/// as hue, blue or orange, which every kind of colour blindness tells apart.
const BLUE_ORANGE: [u32; 9] = [
    0x0c1842, 0x004592, 0x2280cb, 0x8ec1e9, 0xf9f9f9, 0xf7ac5f, 0xc75e0d, 0x7a3003, 0x2f1405,
];

/// Which colour map.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ColourMap {
    /// Diverging from zero in the middle, not from low to high.
    pub signed: bool,
    /// For the last row of a lecture hall: nearly all of the range from black to white.
    pub contrast: bool,
}

impl ColourMap {
    /// The colour at `t` from 0, the low end, to 1, as r, g, b.
    fn at(self, t: f64) -> [u8; 3] {
        match (self.signed, self.contrast) {
            (false, false) => between(&BLUE_OCHRE[2..], t),
            (false, true) => INFERNO
                .eval_continuous(BLACK_END + (1.0 - BLACK_END) * t)
                .as_array(),
            (true, false) => between(&BLUE_OCHRE, t),
            (true, true) => between(&BLUE_ORANGE, t),
        }
    }
}

/// Linear between neighbours of a list of colours `0xrrggbb`.
fn between(stops: &[u32], t: f64) -> [u8; 3] {
    let place = t.clamp(0.0, 1.0) * (stops.len() - 1) as f64;
    let low = (place as usize).min(stops.len() - 2);
    let share = place - low as f64;
    [16, 8, 0].map(|shift| {
        let channel = |n: usize| f64::from(stops[n] >> shift & 0xff);
        (channel(low) + share * (channel(low + 1) - channel(low))).round() as u8
    })
}

/// `n` colours of a map from low to high, as r, g, b bytes.
///
/// Signed: blue below zero, nearly white at zero, ochre above; otherwise from nearly white to
/// ochre. With contrast from blue over white to orange with nearly black ends, and inferno,
/// perceptually uniform from nearly black to pale yellow.
pub fn colour_bar(map: ColourMap, n: usize) -> Vec<u8> {
    let colour = |i: usize| {
        // One colour alone is the middle of the map.
        let t = if n > 1 {
            i as f64 / (n - 1) as f64
        } else {
            0.5
        };
        map.at(t)
    };
    (0..n).flat_map(colour).collect()
}

/// A colour map as RGBA texels, [`MAP_LENGTH`] of them.
pub fn map_texels(map: ColourMap) -> Vec<u8> {
    let opaque = |rgb: &[u8]| [rgb[0], rgb[1], rgb[2], 255];
    colour_bar(map, MAP_LENGTH)
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

/// Colours of a theme, `0xrrggbb` in sRGB, and strengths of its lights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// Background behind the surface …
    pub centre: u32,
    /// … and at the rim of the picture.
    pub rim: u32,
    /// Side of the surface that winds anticlockwise.
    pub front: u32,
    /// Other side of an orientable surface.
    pub back: u32,
    /// Marked triangles.
    pub marked: u32,
    /// Edges of the mesh.
    pub wire: u32,
    /// Boundary loops.
    pub boundary: u32,
    /// Chosen edges.
    pub chosen: u32,
    /// Strength of the light from sky and ground.
    pub hemisphere: f32,
    /// Strength of the light that outlines the surface.
    pub outline: f32,
    /// Opacity of the shadow on the floor.
    pub shadow: f32,
}

impl Theme {
    /// The theme's colours.
    pub fn palette(self) -> Palette {
        match self {
            Self::Light => Palette {
                centre: 0xf4f6f8,
                rim: 0xd9dfe6,
                front: CELADON,
                back: TERRACOTTA,
                marked: 0xe4572e,
                wire: 0x14191f,
                boundary: 0x14191f,
                chosen: 0x07504b,
                hemisphere: 0.66,
                outline: 0.20,
                shadow: 0.42,
            },
            Self::Dark => Palette {
                centre: 0x1d232a,
                rim: 0x0d1013,
                front: CELADON,
                back: TERRACOTTA,
                marked: 0xff6b3d,
                wire: 0x0d1013,
                boundary: 0xedf1f4,
                chosen: 0x6fcfbf,
                hemisphere: 0.52,
                outline: 0.34,
                shadow: 0.75,
            },
        }
    }
}

/// A hue that no colour map uses.
const CELADON: u32 = 0x86b5a9;
/// Linear light (0.50, 0.235, 0.15).
const TERRACOTTA: u32 = 0xbc856c;

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

    const PLAIN: ColourMap = ColourMap {
        signed: false,
        contrast: false,
    };
    const SIGNED: ColourMap = ColourMap {
        signed: true,
        ..PLAIN
    };
    const CONTRAST: ColourMap = ColourMap {
        contrast: true,
        ..PLAIN
    };
    const SIGNED_CONTRAST: ColourMap = ColourMap {
        signed: true,
        contrast: true,
    };

    /// Linear light of trichromats and, by the matrices of Machado, Oliveira & Fernandes
    /// [MOF09](crate::bibliography#mof09) (severity 1), what protanopes, deuteranopes and
    /// tritanopes see of it.
    const SIGHT: [[[f64; 3]; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
    ];

    /// CIELAB (CIE 15, white D65) of a map's colours, low to high, as `sight` sees them.
    fn lab(map: ColourMap, n: usize, sight: &[[f64; 3]; 3]) -> Vec<[f64; 3]> {
        let mix = |rows: &[[f64; 3]; 3], c: [f64; 3]| {
            rows.map(|row| (0..3).map(|k| row[k] * c[k]).sum::<f64>())
        };
        let one = |rgb: &[u8]| {
            let [r, g, b, _] = linear(u32::from_be_bytes([0, rgb[0], rgb[1], rgb[2]]));
            let seen = mix(sight, [r, g, b].map(f64::from)).map(|c| c.clamp(0.0, 1.0));
            // Linear sRGB to XYZ over the white point (IEC 61966-2-1).
            let xyz = mix(
                &[
                    [0.412456, 0.357576, 0.180437],
                    [0.212673, 0.715152, 0.072175],
                    [0.019334, 0.119192, 0.950304],
                ],
                seen,
            );
            let white = [0.95047, 1.0, 1.08883];
            let f = |t: f64| {
                if t > (6.0f64 / 29.0).powi(3) {
                    t.cbrt()
                } else {
                    t * (29.0f64 / 6.0).powi(2) / 3.0 + 4.0 / 29.0
                }
            };
            let [x, y, z] = [0, 1, 2].map(|k| f(xyz[k] / white[k]));
            [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
        };
        colour_bar(map, n).chunks_exact(3).map(one).collect()
    }

    /// CIE 1976 ΔE*; about 2.3 is just noticed side by side.
    fn difference(p: [f64; 3], q: [f64; 3]) -> f64 {
        (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt()
    }

    #[test]
    fn lightness_of_sequential_maps_goes_one_way_all_the_way() {
        // The plain one has lost its blue half, and so half of the range of a whole map.
        for (map, sense, range) in [(PLAIN, -1.0, 45.0), (CONTRAST, 1.0, 90.0)] {
            for sight in &SIGHT {
                let bar = lab(map, 64, sight);
                assert!(
                    bar.windows(2)
                        .all(|pair| sense * (pair[1][0] - pair[0][0]) > 0.0),
                    "{map:?}: L* turns back under {sight:?}"
                );
            }
            let bar = lab(map, 64, &SIGHT[0]);
            let found = sense * (bar[63][0] - bar[0][0]);
            assert!(found > range, "{map:?}: {found:.1} of {range}");
        }
    }

    #[test]
    fn plain_maps_tell_the_sign_and_the_size_to_everyone() {
        for sight in &SIGHT {
            for (map, least) in [(SIGNED, 7.0), (PLAIN, 3.0)] {
                let bar = lab(map, 16, sight);
                for (i, pair) in bar.windows(2).enumerate() {
                    let apart = difference(pair[0], pair[1]);
                    assert!(
                        apart > least,
                        "{map:?}: {i} differs by {apart:.1} under {sight:?}"
                    );
                }
            }
            let bar = lab(SIGNED, 9, sight);
            for i in 0..4 {
                let apart = difference(bar[i], bar[8 - i]);
                assert!(apart > 25.0, "±{}: {apart:.1} under {sight:?}", 4 - i);
            }
        }
    }

    #[test]
    fn what_has_no_sign_has_the_upper_half_of_the_signed_map() {
        assert_eq!(colour_bar(PLAIN, 65), colour_bar(SIGNED, 129)[3 * 64..]);
    }

    #[test]
    fn diverging_map_of_contrast_is_as_light_on_either_side_of_zero() {
        let bar = lab(SIGNED_CONTRAST, 65, &SIGHT[0]);
        for i in 0..32 {
            assert!(bar[i + 1][0] > bar[i][0], "L* falls at {i}");
            let off = bar[i][0] - bar[64 - i][0];
            assert!(off.abs() < 3.0, "L* differs by {off:.1} at ±{}", 32 - i);
        }
        assert!(bar[32][0] - bar[0][0] > 85.0);
    }

    #[test]
    fn maps_of_contrast_are_told_apart_by_the_colour_blind() {
        for sight in &SIGHT {
            for map in [CONTRAST, SIGNED_CONTRAST] {
                // Sixteen classes, each twice what is just noticed from the next, or more.
                let bar = lab(map, 16, sight);
                for (i, pair) in bar.windows(2).enumerate() {
                    let apart = difference(pair[0], pair[1]);
                    assert!(
                        apart > if map.signed { 7.0 } else { 5.0 },
                        "{map:?}: {i} and {} differ by {apart:.1} under {sight:?}",
                        i + 1
                    );
                }
            }
            // Equally far from zero, the sign is seen by the hue: nearly black at the ends.
            let bar = lab(SIGNED_CONTRAST, 9, sight);
            for (i, least) in [25.0, 40.0, 40.0, 30.0].into_iter().enumerate() {
                let apart = difference(bar[i], bar[8 - i]);
                assert!(apart > least, "±{}: {apart:.1} under {sight:?}", 4 - i);
            }
        }
    }

    #[test]
    fn the_stops_of_the_signed_map_are_met() {
        let bar = colour_bar(SIGNED, 5);
        for (rgb, stop) in bar.chunks_exact(3).zip(BLUE_OCHRE) {
            assert_eq!(rgb, &stop.to_be_bytes()[1..]);
        }
    }

    #[test]
    fn backs_have_the_light_of_the_design() {
        for theme in [Theme::Light, Theme::Dark] {
            let back = linear(theme.palette().back);
            for (found, designed) in back.into_iter().zip([0.50, 0.235, 0.15]) {
                assert!((found - designed).abs() < 4e-3, "{back:?}");
            }
        }
    }

    #[test]
    fn any_number_of_colours_can_be_had() {
        for map in [PLAIN, SIGNED, CONTRAST, SIGNED_CONTRAST] {
            for n in [0, 1, 2, 7, 256] {
                assert_eq!(colour_bar(map, n).len(), 3 * n);
            }
        }
        assert_eq!(map_texels(PLAIN).len(), 4 * MAP_LENGTH);
        assert_eq!(colour_bar(SIGNED_CONTRAST, 3)[3..6], [0xf9; 3]);
    }

    #[test]
    fn linear_light_of_known_colours() {
        assert_eq!(linear(0xffffff), [1.0; 4]);
        assert_eq!(linear(0x000000), [0.0, 0.0, 0.0, 1.0]);
        // The mid grey of sRGB, 0xbc, is half as bright as white.
        assert!((linear(0x00bc00)[1] - 0.5).abs() < 5e-3);
    }
}
