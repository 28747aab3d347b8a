//! Colours between the screen and light: what files of other formats hold are values of sRGB,
//! those of glTF are proportional to the light. Opacity is the same in both.
//!
//! Source: IEC 61966-2-1.

use crate::soup::{Colour, PolygonSoup};

/// Parts of a colour that are written: a fourth where some lets light through.
pub(super) fn parts(soup: &PolygonSoup) -> usize {
    3 + usize::from(soup.colours.iter().any(|colour| colour[3] < 1.0))
}

/// Light of what a screen shows.
pub(super) fn to_linear(colour: Colour) -> Colour {
    each(colour, |c| {
        if c <= 0.04045 {
            c / 12.92
        } else {
            ((c + 0.055) / 1.055).powf(2.4)
        }
    })
}

/// What a screen shows of light.
pub(super) fn to_screen(light: Colour) -> Colour {
    each(light, |c| {
        if c <= 0.003_130_8 {
            12.92 * c
        } else {
            1.055 * c.powf(1.0 / 2.4) - 0.055
        }
    })
}

fn each([r, g, b, alpha]: Colour, f: impl Fn(f64) -> f64) -> Colour {
    let [r, g, b] = [r, g, b].map(|part| f(f64::from(part)) as f32);
    [r, g, b, alpha]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back_is_the_same() {
        for k in 0..=1000 {
            let part = k as f32 / 1000.0;
            let colour = [part, 1.0 - part, 0.0, part];
            let back = to_screen(to_linear(colour));
            for (a, b) in colour.iter().zip(back) {
                assert!((a - b).abs() < 2e-7, "{colour:?} {back:?}");
            }
        }
        // Half of the light looks brighter than a half.
        assert!((to_screen([0.5; 4])[0] - 0.735_357).abs() < 1e-6);
    }
}
