//! Energies of smooth surfaces, in closed form or by quadrature.

use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::{PI, SQRT_2, TAU};

/// Integrals over a smooth surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Exact {
    pub(super) area: f64,
    /// ∫H² dA.
    pub(super) willmore: f64,
    /// ∫K dA.
    pub(super) gauss: f64,
    /// ∫|H|^p dA.
    pub(super) power: f64,
}

/// Points of a quadrature in each direction: far beyond what a mesh resolves.
const POINTS: usize = 512;

impl Exact {
    /// Of a sample shape with these parameters, where it is known.
    pub(super) fn of(name: &str, values: &BTreeMap<String, f64>, p: f64) -> Option<Self> {
        let value = |name| values.get(name).copied();
        Some(match name {
            "icosphere" | "uv-sphere" => Self::sphere(4.0 * PI),
            "hemisphere" => Self::sphere(2.0 * PI),
            "torus" => Self::torus(value("major")?, value("minor")?, p),
            "sampled-torus" => Self::torus(1.0, 0.4, p),
            "clifford-torus" | "lattice-torus" => Self::torus(SQRT_2, 1.0, p),
            "ellipsoid" => {
                let axes = DVec3::new(value("a")?, value("b")?, value("c")?);
                Self::ellipsoid(axes, p)
            }
            "cylinder" => {
                let area = TAU * value("length")?;
                Self {
                    area,
                    willmore: area / 4.0,
                    gauss: 0.0,
                    power: area * 0.5f64.powf(p),
                }
            }
            "disk" => Self {
                area: PI,
                willmore: 0.0,
                gauss: 0.0,
                power: if p == 0.0 { PI } else { 0.0 },
            },
            _ => return None,
        })
    }

    /// A part of the unit sphere.
    fn sphere(area: f64) -> Self {
        Self {
            area,
            willmore: area,
            gauss: area,
            power: area,
        }
    }

    /// The torus with axis radius R and tube radius r: H = (R + 2r cos v)/(2r (R + r cos v)),
    /// dA = r (R + r cos v) du dv, ∫H² dA = π² R²/(r √(R² − r²)).
    fn torus(major: f64, minor: f64, p: f64) -> Self {
        let power = |n: usize| {
            let c = (TAU * n as f64 / POINTS as f64).cos();
            let w = major + minor * c;
            minor
                * w
                * ((major + 2.0 * minor * c) / (2.0 * minor * w))
                    .abs()
                    .powf(p)
        };
        let sum: f64 = (0..POINTS).map(power).sum();
        Self {
            area: 4.0 * PI * PI * major * minor,
            willmore: PI * PI * major * major / (minor * (major * major - minor * minor).sqrt()),
            gauss: 0.0,
            power: TAU * TAU * sum / POINTS as f64,
        }
    }

    /// With g² = Σ x_i²/a_i⁴ and P = Π a_i²: K = 1/(P g⁴), H = (Σ a_i² − |x|²)/(2 P g³),
    /// dA = √P g dω over the unit sphere. By the trapezium rule in longitude and Simpson's in
    /// the sine of latitude.
    fn ellipsoid(axes: DVec3, p: f64) -> Self {
        let squares = axes * axes;
        let product = squares.x * squares.y * squares.z;
        let mut out = Self {
            area: 0.0,
            willmore: 0.0,
            gauss: 0.0,
            power: 0.0,
        };
        for i in 0..=POINTS {
            let t = 2.0 * i as f64 / POINTS as f64 - 1.0;
            let simpson = match i {
                0 | POINTS => 1.0,
                i if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            let weight = simpson * (2.0 / POINTS as f64) / 3.0 * TAU / POINTS as f64;
            let s = (1.0 - t * t).max(0.0).sqrt();
            for j in 0..POINTS {
                let (sin, cos) = (TAU * j as f64 / POINTS as f64).sin_cos();
                let x = DVec3::new(s * cos, s * sin, t) * axes;
                let g = (x / squares).length();
                let area = weight * product.sqrt() * g;
                let h = (squares.element_sum() - x.length_squared()) / (2.0 * product * g.powi(3));
                out.area += area;
                out.willmore += area * h * h;
                out.gauss += area / (product * g.powi(4));
                out.power += area * h.abs().powf(p);
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-10 * b.abs().max(1.0)
    }

    #[test]
    fn quadratures_agree_with_closed_forms() {
        let clifford = Exact::torus(SQRT_2, 1.0, 2.0);
        assert!(close(clifford.power, clifford.willmore));
        assert!(close(clifford.willmore, 2.0 * PI * PI));
        assert!(close(
            Exact::torus(3.0, 0.7, 0.0).power,
            4.0 * PI * PI * 2.1
        ));
        let sphere = Exact::ellipsoid(DVec3::splat(2.0), 1.0);
        assert!(close(sphere.area, 16.0 * PI) && close(sphere.willmore, 4.0 * PI));
        assert!(close(sphere.power, 8.0 * PI));
        // Gauss & Bonnet; area of the oblate spheroid with a = 1, c = 1/2.
        let oblate = Exact::ellipsoid(DVec3::new(1.0, 1.0, 0.5), 2.0);
        let e = 0.75f64.sqrt();
        assert!(close(oblate.gauss, 4.0 * PI));
        assert!(close(oblate.area, TAU * (1.0 + 0.25 / e * e.atanh())));
        assert!(close(oblate.power, oblate.willmore) && oblate.willmore > 4.0 * PI);
        assert!(close(
            Exact::ellipsoid(DVec3::new(1.5, 1.0, 0.7), 2.0).gauss,
            4.0 * PI
        ));
    }
}
