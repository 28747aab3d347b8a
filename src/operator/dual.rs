//! Numbers and vectors with their derivative along one direction: exact Jacobians by
//! forward differentiation.

use glam::DVec3;
use std::ops::{Add, Mul, Neg, Sub};

/// A number and its derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual {
    /// Value.
    pub re: f64,
    /// Derivative.
    pub du: f64,
}

/// A vector and its derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DualVec {
    /// Value.
    pub re: DVec3,
    /// Derivative.
    pub du: DVec3,
}

impl Dual {
    /// A constant.
    pub fn constant(re: f64) -> Self {
        Self { re, du: 0.0 }
    }

    fn chain(self, re: f64, slope: f64) -> Self {
        Self {
            re,
            du: slope * self.du,
        }
    }

    /// √x.
    pub fn sqrt(self) -> Self {
        let root = self.re.sqrt();
        self.chain(root, 0.5 / root)
    }

    /// 1/x.
    pub fn recip(self) -> Self {
        let inverse = self.re.recip();
        self.chain(inverse, -inverse * inverse)
    }

    /// x^e; at x = 0 without a derivative.
    pub fn powf(self, e: f64) -> Self {
        if e == 0.0 || self.re == 0.0 {
            return Self::constant(self.re.powf(e));
        }
        self.chain(self.re.powf(e), e * self.re.powf(e - 1.0))
    }
}

impl DualVec {
    /// A constant.
    pub fn constant(re: DVec3) -> Self {
        let du = DVec3::ZERO;
        Self { re, du }
    }

    /// ⟨self, other⟩.
    pub fn dot(self, other: Self) -> Dual {
        Dual {
            re: self.re.dot(other.re),
            du: self.du.dot(other.re) + self.re.dot(other.du),
        }
    }

    /// self × other.
    pub fn cross(self, other: Self) -> Self {
        Self {
            re: self.re.cross(other.re),
            du: self.du.cross(other.re) + self.re.cross(other.du),
        }
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            re: self.re + other.re,
            du: self.du + other.du,
        }
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            re: self.re * other.re,
            du: self.du * other.re + self.re * other.du,
        }
    }
}

impl Mul<f64> for Dual {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self {
            re: factor * self.re,
            du: factor * self.du,
        }
    }
}

impl Add for DualVec {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            re: self.re + other.re,
            du: self.du + other.du,
        }
    }
}

impl Sub for DualVec {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for DualVec {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            re: -self.re,
            du: -self.du,
        }
    }
}

impl Mul<f64> for DualVec {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self {
            re: factor * self.re,
            du: factor * self.du,
        }
    }
}

impl Mul<Dual> for DualVec {
    type Output = Self;
    fn mul(self, factor: Dual) -> Self {
        Self {
            re: factor.re * self.re,
            du: factor.du * self.re + factor.re * self.du,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_agree_with_differences() {
        let (p, d) = (DVec3::new(0.3, -1.2, 0.8), DVec3::new(0.5, 0.2, -0.9));
        let (q, e) = (DVec3::new(1.1, 0.4, -0.6), DVec3::new(-0.3, 0.7, 0.1));
        let f = |s: f64, is_dual: f64| {
            let a = DualVec {
                re: p + s * d,
                du: is_dual * d,
            };
            let b = DualVec {
                re: q + s * e,
                du: is_dual * e,
            };
            let n = a.cross(b);
            let size = n.dot(n).sqrt();
            let unit = n * size.recip();
            (a - b * 2.0).dot(unit * size.powf(1.7))
                + (-a).dot(b) * size * 3.0
                + Dual::constant(5.0)
        };
        let h = 1e-5;
        let expected = (f(h, 0.0).re - f(-h, 0.0).re) / (2.0 * h);
        assert!((f(0.0, 1.0).du / expected - 1.0).abs() < 1e-9);
        assert_eq!(f(0.0, 0.0).du, 0.0);
        assert_eq!(Dual { re: 2.0, du: 1.0 }.powf(0.0), Dual::constant(1.0));
    }
}
