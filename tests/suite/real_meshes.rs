//! Default settings on real meshes: no rise, no NaN, next to no triangle turned over.

use crate::support::*;
use umbilic::flow::Decision;
use umbilic::flow::options::FlowOptions;

fn fifty_steps(name: &str) {
    let Some(Surface { mesh, mut x, .. }) = real(name) else {
        return;
    };
    let n_faces = mesh.n_faces();
    let mut flow = drive(&mesh, &mut x, FlowOptions::default()).expect("a flow");
    let start = std::time::Instant::now();
    let (mut flips, mut last) = (0, String::new());
    for _ in 0..50 {
        let (report, verdict) = flow.step(&mut x).expect("a step");
        if let Some(r) = &report {
            assert!(
                r.objective <= r.objective_before,
                "{name}: rise at step {}",
                r.step
            );
            assert!(r.energy.is_finite() && x.iter().all(|p| p.is_finite()));
            flips += r.flipped_faces;
            last = format!(
                "step {} W {:.4} tau {:.3e} eps {} angle {:.2e} rejected {} flips {} disp {:.1} ms {:.0}/{:.0}/{:.0}",
                r.step,
                r.energy,
                r.tau,
                r.epsilon,
                r.min_angle_degrees,
                r.rejected,
                r.flipped_faces,
                r.max_displacement,
                r.assemble_milliseconds,
                r.factor_milliseconds,
                r.solve_milliseconds
            );
            if std::env::var("VERBOSE").is_ok() {
                println!("{last}");
            }
        }
        if let Decision::Stop(status, why) = verdict {
            println!("{name}: {status:?}: {why}");
            break;
        }
    }
    println!(
        "{name}: {n_faces} faces, {flips} turned, {last}; {:.1} s",
        start.elapsed().as_secs_f64()
    );
    assert!(
        flips as f64 <= 0.001 * n_faces as f64,
        "{name}: {flips} of {n_faces} faces turned over"
    );
}

macro_rules! meshes {
    ($($test:ident: $file:literal,)*) => {
        $(#[test] fn $test() { fifty_steps($file); })*
    };
}

meshes! {
    spot: "spot_low_resolution.obj",
    spot_quads: "spot_quadrangulated.obj",
    bob: "bob_small.ply",
    bunny: "bunny.obj",
    double_torus: "double_torus_10k.obj",
    skull: "skull_low_resolution.obj",
    borromean: "borromean.obj",
    trefoil: "trefoil_tube.obj",
    cat_head: "cat_head.obj",
    demosthenes: "demosthenes_low_res.obj",
    plane: "plane_holes.obj",
    hemisphere: "hemisphere.off",
    icosahedron: "icosahedron_binary.stl",
    koala: "koala.obj",
    sword: "sword_178k.ply",
}
