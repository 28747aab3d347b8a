//! A face in relief, as the height of a surface seen from the front.
//!
//! Lengths are in half head heights: the chin is near y = -1 and the crown near y = 1.

/// Lower left and upper right corner of the picture.
pub(super) const FRAME: [(f64, f64); 2] = [(-1.2, -1.62), (1.2, 1.2)];

/// Parts end where `1 - (x/a)² - …` falls to this: the last of a sphere is too steep to be seen.
const GRAZING: f64 = 0.03;

/// Height of the bust at `(x, y)`, or nothing beside it.
pub(super) fn height(x: f64, y: f64) -> Option<f64> {
    let parts = [head(x, y), ear(x.abs(), y), neck(x, y), shoulders(x, y)];
    parts.into_iter().flatten().reduce(f64::max)
}

/// The head: an ellipsoid with features, hair above.
fn head(x: f64, y: f64) -> Option<f64> {
    // The jaw narrows below the cheeks.
    let half_width = 0.73 - 0.2 * smooth_step(0.1, -1.0, y) + 0.04 * smooth_step(0.1, 0.6, y);
    let (u, v) = (x / half_width, (y - 0.06) / 1.06);
    let inside = 1.0 - u * u * (0.75 + 0.25 * u * u) - v * v * (0.6 + 0.4 * v * v);
    (inside > GRAZING).then(|| 0.82 * inside.sqrt() + features(x.abs(), y) + hair(x, y))
}

/// What stands out of the ellipsoid, for the right half.
fn features(x: f64, y: f64) -> f64 {
    let forehead = bump(x, y, (0.0, 0.5), (0.4, 0.2)) * 0.03;
    let brow = bump(
        x,
        y + 0.35 * (x - 0.25).powi(2),
        (0.26, 0.33),
        (0.16, 0.055),
    ) * 0.075
        - bump(x, y, (0.0, 0.3), (0.07, 0.06)) * 0.02;
    let cheek = bump(x, y, (0.43, -0.02), (0.16, 0.13)) * 0.07
        - bump(x, y, (0.42, -0.38), (0.13, 0.2)) * 0.05;
    forehead + brow + cheek + eye(x, y) + nose(x, y) + mouth(x, y)
}

fn eye(x: f64, y: f64) -> f64 {
    let socket = -0.1 * bump(x, y, (0.27, 0.19), (0.15, 0.095));
    // The ball shows between two lids, each an arc through the corners of the eye.
    let (u, v) = ((x - 0.275) / 0.13, y - 0.165 - 0.03 * (x - 0.275));
    let open = (1.0 - u * u).max(0.0);
    let (upper, lower) = (0.052 * open, -0.034 * open);
    let between = smooth_step(upper, upper - 0.016, v) * smooth_step(lower, lower + 0.016, v);
    let gap = between * smooth_step(0.0, 0.3, open);
    let ball = 0.1 * bump(x, y, (0.275, 0.17), (0.1, 0.085));
    let lids = 0.025 * bump(0.0, v - upper, (0.0, 0.012), (1.0, 0.026)) * open.sqrt()
        + 0.016 * bump(0.0, v - lower, (0.0, -0.01), (1.0, 0.022)) * open.sqrt();
    let fold = -0.02 * bump(0.0, v - 1.25 * upper, (0.0, 0.035), (1.0, 0.012)) * open.sqrt();
    let iris = bump(x, y, (0.27, 0.172), (0.035, 0.035));
    let pupil = bump(x, y, (0.27, 0.172), (0.014, 0.014));
    socket + ball + lids + fold + gap * (-0.02 + 0.012 * iris - 0.028 * pupil)
}

fn nose(x: f64, y: f64) -> f64 {
    // Down the bridge the ridge rises and widens, and ends under the tip.
    let down = ((0.33 - y) / 0.43).clamp(0.0, 1.0);
    let width = 0.05 + 0.045 * down * down;
    let end = smooth_step(-0.18, -0.085, y) * smooth_step(0.42, 0.26, y);
    let bridge = (0.07 + 0.17 * down.powf(1.3)) * (-(x / width).powi(2)).exp() * end;
    let tip = 0.07 * bump(x, y, (0.0, -0.075), (0.062, 0.055));
    let wing = 0.095 * bump(x, y, (0.1, -0.105), (0.042, 0.042));
    let nostril = -0.05 * bump(x, y, (0.055, -0.155), (0.03, 0.018));
    bridge + tip + wing + nostril
}

fn mouth(x: f64, y: f64) -> f64 {
    let line = -0.4 + 0.012 * bump(x, 0.0, (0.07, 0.0), (0.05, 1.0)) - 0.1 * x * x;
    let width = (1.0 - (x / 0.24).powi(2)).max(0.0);
    let v = y - line;
    let upper = 0.06 * width.sqrt() * bump(0.0, v, (0.0, 0.042), (1.0, 0.04));
    let lower = 0.085 * width * bump(0.0, v, (0.0, -0.062), (1.0, 0.05));
    let crease = -0.04 * width.sqrt() * bump(0.0, v, (0.0, 0.0), (1.0, 0.013));
    let muzzle = 0.06 * bump(x, y, (0.0, -0.38), (0.24, 0.17));
    let corner = -0.035 * bump(x, y, (0.245, -0.405), (0.035, 0.03));
    let philtrum = -0.02 * bump(x, y, (0.0, -0.26), (0.022, 0.06));
    let groove = -0.05 * bump(x, y, (0.0, -0.565), (0.16, 0.045));
    let chin = 0.13 * bump(x, y, (0.0, -0.74), (0.17, 0.12));
    upper + lower + crease + muzzle + corner + philtrum + groove + chin
}

/// Waves of hair from a parting, thicker than the forehead by a step.
fn hair(x: f64, y: f64) -> f64 {
    let side = x.abs();
    let line = 0.7 - 0.9 * (side - 0.1).max(0.0).powi(2) - 1.6 * (side - 0.5).max(0.0).powi(2);
    let edge = y - line + 0.018 * (30.0 * side).sin();
    let inside = smooth_step(-0.01, 0.045, edge);
    // Strands fan out from a point above the parting and wave as they fall.
    let (down, angle) = (side.hypot(1.25 - y), side.atan2(1.25 - y));
    let strands = (26.0 * angle + 2.2 * (13.0 * down + 2.0 * angle).sin()).sin();
    let waves = (13.0 * down + 2.0 * angle + 0.6 * (9.0 * angle).sin()).sin();
    let parting = -0.03 * bump(x, 0.0, (0.0, 0.0), (0.03, 1.0));
    inside * (0.075 + 0.016 * strands + 0.014 * waves + parting)
}

/// An ear, for the right half: a shell with a raised rim, set back from the face.
fn ear(x: f64, y: f64) -> Option<f64> {
    let (u, v) = ((x - 0.77 - 0.1 * (y - 0.05)) / 0.115, (y - 0.06) / 0.25);
    let r2 = u * u + v * v;
    (r2 < 1.0)
        .then(|| 0.12 + 0.08 * (1.0 - r2).sqrt() - 0.09 * bump(u, v, (0.05, 0.08), (0.45, 0.5)))
}

fn neck(x: f64, y: f64) -> Option<f64> {
    let half_width = 0.44 + 0.6 * smooth_step(-0.85, -1.6, y).powi(2);
    let inside = 1.0 - (x / half_width).powi(2);
    let sinew = 0.06 * bump(x.abs() - 0.32 * (y + 1.45), 0.0, (0.06, 0.0), (0.05, 1.0));
    let throat = 0.03 * bump(x, y, (0.0, -1.05), (0.06, 0.07));
    (inside > GRAZING && y < -0.3)
        .then(|| 0.42 * inside.sqrt() - 0.08 + sinew + throat - 0.12 * (y + 1.0))
}

fn shoulders(x: f64, y: f64) -> Option<f64> {
    let top = -1.08 - 0.2 * x.abs().powf(1.5) - 0.3 * smooth_step(0.85, 1.5, x.abs());
    let inside = (top - y) / 0.5;
    (inside > GRAZING).then(|| {
        // A tunic: its hem runs down to the breast, folds fall from it.
        let hem = y + 1.42 - 0.3 * x.abs();
        let cloth = smooth_step(0.0, -0.03, hem) * 0.05;
        let folds = 0.02 * (9.0 * x.abs() + 22.0 * hem).sin() * smooth_step(-0.02, -0.12, hem);
        let collar = 0.04
            * bump(
                x.abs() - 0.3,
                y + 1.22 - 0.08 * x.abs(),
                (0.0, 0.0),
                (0.22, 0.035),
            );
        0.36 * inside.min(1.0).sqrt() + 0.1 * (1.0 - x * x) + cloth + folds + collar
    })
}

/// A Gaussian of height one.
fn bump(x: f64, y: f64, centre: (f64, f64), spread: (f64, f64)) -> f64 {
    (-((x - centre.0) / spread.0).powi(2) - ((y - centre.1) / spread.1).powi(2)).exp()
}

/// Rises from 0 at `from` to 1 at `to` with a continuous derivative; `from` may be the larger.
fn smooth_step(from: f64, to: f64, x: f64) -> f64 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
