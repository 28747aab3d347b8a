//! Refinement studies: orders on surfaces whose energies are known.

use std::collections::BTreeMap;
use std::f64::consts::PI;
use umbilic::app::{Limits, RefinedBy, Session, Study, StudyOptions, StudyReport, Tendency, Trend};
use umbilic::message::{Message, Value};

fn study(name: &str, values: &[(&str, f64)], p: f64, vertices: usize) -> StudyReport {
    let parameters = values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    let limits = Limits {
        vertices,
        ..Limits::default()
    };
    let mut study = Study::of_shape(name, &parameters, p, limits).expect("a shape");
    loop {
        study.refine().expect("a mesh");
        let report = study.report();
        if report.finished {
            return report;
        }
    }
}

fn trend<'a>(report: &'a StudyReport, quantity: &str) -> &'a Trend {
    let found = report
        .trends
        .iter()
        .find(|trend| trend.quantity == quantity);
    found.unwrap_or_else(|| panic!("{quantity}"))
}

fn order(report: &StudyReport, quantity: &str) -> f64 {
    let orders = &trend(report, quantity).orders;
    orders.last().copied().flatten().expect("an order")
}

#[test]
fn on_the_sphere_everything_converges_with_order_two() {
    let report = study("icosphere", &[("level", 2.0)], 4.0, 11_000);
    assert_eq!(
        (report.refined_by, report.rows.len()),
        (RefinedBy::Sampled, 4)
    );
    for quantity in ["area", "cotangent", "fitted", "power"] {
        let found = trend(&report, quantity);
        assert_eq!(found.tendency, Tendency::Converges, "{quantity}");
        assert!(found.is_known && (found.smooth.expect("known") - 4.0 * PI).abs() < 1e-12);
        let order = order(&report, quantity);
        assert!((order - 2.0).abs() < 0.15, "{quantity}: {order}");
        assert!(found.errors.last().expect("rows") / (4.0 * PI) < 2e-3);
    }
    // Möbius: 0 on every convex mesh with its vertices on a sphere.
    assert_eq!(trend(&report, "circle").tendency, Tendency::Exact);
    let h: Vec<f64> = report.rows.iter().map(|row| row.h).collect();
    assert!(h.windows(2).all(|w| (w[0] / w[1] - 2.0).abs() < 0.1));
}

#[test]
fn the_circle_energy_converges_along_lines_of_curvature_only() {
    let values = [
        ("major", 1.0),
        ("minor", 0.4),
        ("around", 28.0),
        ("tube", 14.0),
    ];
    let aligned = study("torus", &values, 2.0, 30_000);
    let circle = trend(&aligned, "circle");
    // ∫H² = π² R²/(r √(R² − r²)), ∫K = 0.
    let smooth = PI * PI / (0.4 * (1.0f64 - 0.16).sqrt());
    assert!((circle.smooth.expect("known") - smooth).abs() < 1e-12);
    assert_eq!(circle.tendency, Tendency::Converges);
    assert!((order(&aligned, "circle") - 2.0).abs() < 0.2);
    assert!(circle.errors.last().expect("rows") / smooth < 2e-3);
    assert!((order(&aligned, "area") - 2.0).abs() < 0.1);

    // The same points, every cell cut along either diagonal, rings turned by half a step.
    let values = [("around", 28.0), ("tube", 14.0), ("jitter", 0.0)];
    let random = study("sampled-torus", &values, 2.0, 30_000);
    let circle = trend(&random, "circle");
    assert_eq!(circle.smooth, trend(&aligned, "circle").smooth);
    assert!(matches!(
        circle.tendency,
        Tendency::Elsewhere | Tendency::Diverges
    ));
    assert!(
        *circle.values.last().expect("rows") > 1.3 * smooth,
        "{circle:?}"
    );
    // The area and the fits mind neither.
    assert_eq!(trend(&random, "area").tendency, Tendency::Converges);
    assert!((order(&random, "area") - 2.0).abs() < 0.2);
    let fitted = trend(&random, "fitted");
    assert_eq!(fitted.tendency, Tendency::Converges, "{fitted:?}");
    assert!(fitted.errors.last().expect("rows") / smooth < 2e-2);
}

#[test]
fn lattices_tend_to_the_multiples_that_are_known() {
    // Bobenko & Schröder 2005, Section 2: 3/2 on the equilateral lattice.
    let values = [("columns", 26.0), ("rows", 30.0), ("shear", 0.5)];
    let report = study("lattice-torus", &values, 2.0, 60_000);
    let circle = trend(&report, "circle");
    assert_eq!(circle.tendency, Tendency::Elsewhere, "{circle:?}");
    let ratio = circle.values.last().expect("rows") / (2.0 * PI * PI);
    assert!((ratio - 1.5).abs() < 0.02, "{ratio}");
    // The obtuse one has no limit: its energy grows like 1/h².
    let values = [("columns", 16.0), ("rows", 16.0), ("shear", -0.25)];
    let report = study("lattice-torus", &values, 2.0, 20_000);
    assert_eq!(trend(&report, "circle").tendency, Tendency::Diverges);
}

#[test]
fn polyhedra_have_no_willmore_energy() {
    let report = study("icosahedron", &[("level", 2.0)], 2.0, 11_000);
    assert_eq!(report.refined_by, RefinedBy::Polyhedron);
    for (k, row) in report.rows.iter().enumerate() {
        // W = 4π (2^k − 1) after k linear subdivisions.
        let expected = 2.0 * PI * (2f64.powi(k as i32 + 2) - 1.0);
        assert!((row.circle - expected).abs() < 1e-6 * expected);
    }
    for quantity in ["circle", "cotangent"] {
        assert_eq!(
            trend(&report, quantity).tendency,
            Tendency::Diverges,
            "{quantity}"
        );
    }
    assert_eq!(trend(&report, "area").tendency, Tendency::Exact);
}

#[test]
fn large_samples_begin_coarser_and_stay_within_the_limits() {
    let report = study("icosphere", &[("level", 6.0)], 2.0, 11_000);
    assert_eq!(report.rows[0].vertices, 642);
    assert!(report.rows.len() == 3 && report.rows[2].vertices <= 11_000);
}

#[test]
fn other_surfaces_are_studied_by_the_limit_of_loops_scheme() {
    let mut session = Session::new();
    let level = [("level".to_owned(), 2.0)];
    session.sample("bumpy-sphere", &level).expect("a sample");
    session.run(2).expect("steps");
    let (before, state) = (
        session.positions().expect("x"),
        session.state().expect("state"),
    );
    let mut report = session
        .study(Some(&StudyOptions::default()))
        .expect("a study");
    while !report.finished {
        report = session.study(None).expect("a study");
    }
    assert_eq!((report.refined_by, report.rows.len()), (RefinedBy::Loop, 4));
    let area = trend(&report, "area");
    assert_eq!((area.tendency, area.smooth), (Tendency::Converges, None));
    assert!((order(&report, "area") - 2.0).abs() < 0.2, "{area:?}");
    // Vertices on the limit surface span less than it; those of control meshes lie outside.
    assert!(area.values.windows(2).all(|w| w[1] > w[0]), "{area:?}");
    let fitted = trend(&report, "fitted");
    assert_eq!(fitted.tendency, Tendency::Converges, "{fitted:?}");
    // ∫K = 4π, and what the circle energy is compared with comes from the finest mesh.
    let finest = report.rows[3];
    assert!(
        (finest.gauss / (4.0 * PI) - 1.0).abs() < 0.02,
        "{}",
        finest.gauss
    );
    let circle = trend(&report, "circle");
    assert!(!circle.is_known && circle.smooth == Some(finest.fitted - finest.gauss));
    // The surface on screen is left alone.
    assert_eq!(session.positions().expect("x"), before);
    assert_eq!(session.state().expect("state"), state);
}

/// What is said of a study is what its trends are, with what only some surfaces are told.
#[test]
fn findings_say_what_the_trends_are() {
    let said = |report: &StudyReport| -> Vec<String> {
        let one = |message: &Message| match message.value("tendency") {
            Some(Value::Text(tendency)) => format!("{} {tendency}", message.id),
            _ => message.id.to_string(),
        };
        report.findings.iter().map(one).collect()
    };
    let lines = study("icosahedron", &[("level", 2.0)], 2.0, 11_000);
    let found = said(&lines);
    assert_eq!(found.len(), lines.trends.len() + 3);
    for (sentence, trend) in found.iter().zip(&lines.trends) {
        let expected = match trend.tendency {
            Tendency::Exact => "trend exact",
            Tendency::Converges if trend.is_known => "trend converges",
            Tendency::Converges if trend.smooth.is_some() => "trend nears",
            Tendency::Converges => "trend settles",
            Tendency::Diverges => "trend diverges",
            Tendency::Unknown => "trend unknown",
            Tendency::Elsewhere => "trend elsewhere",
        };
        assert!(sentence.starts_with(expected), "{sentence}: {trend:?}");
    }
    let rest = &found[lines.trends.len()..];
    assert_eq!(
        rest,
        ["study-polyhedron", "study-lattice", "study-minimisers"]
    );

    // The limit of a lattice over the smooth energy, known and not zero.
    let values = [("columns", 26.0), ("rows", 30.0), ("shear", 0.5)];
    let lattice = study("lattice-torus", &values, 2.0, 60_000);
    let circle = lattice.trends.iter().position(|t| t.quantity == "circle");
    let message = &lattice.findings[circle.expect("measured")];
    assert_eq!(said(&lattice)[circle.expect("measured")], "trend elsewhere");
    assert!((message.number("ratio").expect("a ratio") - 1.5).abs() < 0.02);
    assert!(said(&lattice).iter().all(|id| id != "study-polyhedron"));

    let mut unfinished = Study::of_shape("icosphere", &BTreeMap::new(), 2.0, Limits::default());
    let unfinished = unfinished.as_mut().expect("a shape");
    unfinished.refine().expect("a mesh");
    assert!(!unfinished.report().finished && unfinished.report().findings.is_empty());
}

#[test]
fn a_study_that_has_not_begun_cannot_go_on() {
    let mut session = Session::new();
    assert_eq!(session.study(None).expect_err("nothing").kind, "NoStudy");
    let unknown = StudyOptions {
        shape: Some("no-such-shape".into()),
        parameters: BTreeMap::new(),
        p: None,
    };
    let fault = session.study(Some(&unknown)).expect_err("no shape");
    assert_eq!(fault.kind, "UnknownShape");
    let none = session.study(Some(&StudyOptions::default()));
    assert_eq!(none.expect_err("no mesh").kind, "NoMesh");
}
