use super::*;
use crate::mesh::noise::SplitMix64;
use crate::mesh::{build, shape};
use reduction::willmore_reduction;

/// A jittered torus and an open surface, with flips that gain on both.
fn surfaces() -> impl Iterator<Item = (HalfedgeMesh, Rc<Vec<DVec3>>)> {
    ["sampled-torus", "monkey-saddle"].into_iter().map(|name| {
        let sample = shape::make(name, &[]).expect("a shape");
        let built = build(&sample.soup).expect("a surface");
        let (mesh, mut x) = (built.mesh, built.positions);
        let amount = 0.25 * measure::mean_edge_length(&mesh, &x);
        let mut random = SplitMix64::new(5);
        let mut shift = || amount * (2.0 * random.uniform() - 1.0);
        for p in &mut x {
            *p += DVec3::new(shift(), shift(), shift());
        }
        (mesh, Rc::new(x))
    })
}

/// Reductions and totals are those of the formulas, to the last bit, whatever is kept from flip to
/// flip and whatever is passed over.
#[test]
fn what_is_kept_has_the_bits_of_what_is_computed_anew() {
    for (mesh, x) in surfaces() {
        for criterion in Criterion::ALL {
            let mut optimiser = FlipOptimiser::new(mesh.clone(), Rc::clone(&x), criterion, false);
            let mut area = measure::area(&mesh, &x);
            let mut angles = total_angles(&mesh, &x);
            let mut before = mesh.clone();
            let mut random = SplitMix64::new(9);
            let mut count = 0;
            while let Some(flip) = optimiser.step() {
                let quad = Quad::of(&before, &x, flip.edge);
                let by_area = quad.area_reduction();
                let by_angles = willmore_reduction(&before, &x, flip.edge);
                let expected = match criterion {
                    Criterion::Area => by_area,
                    Criterion::Willmore => by_angles,
                    Criterion::Localised => quad.localised_reduction(),
                };
                assert_eq!(flip.reduction, expected, "{criterion:?}");
                area -= by_area;
                angles -= 0.5 * by_angles;
                assert_eq!(flip.area, area, "{criterion:?}");
                assert_eq!(flip.willmore, optimiser.energy(angles), "{criterion:?}");
                before = optimiser.mesh().clone();
                // Some way back and on again: what is kept follows.
                let back = random.below(4);
                for _ in 0..back {
                    optimiser.back();
                }
                for _ in 0..back.min(count + 1) {
                    optimiser.step();
                }
                count += 1;
                assert_eq!(optimiser.flips(), count);
                assert_eq!(optimiser.made().last(), Some(&flip));
            }
            assert!(count > 30, "{count} flips");
            // None is left that gains and can be made.
            for e in before
                .edges()
                .filter(|&e| before.flippable(e) == Flippable::Yes)
            {
                let left = match criterion {
                    Criterion::Area => Quad::of(&before, &x, e).area_reduction(),
                    Criterion::Willmore => willmore_reduction(&before, &x, e),
                    Criterion::Localised => Quad::of(&before, &x, e).localised_reduction(),
                };
                assert!(left < 1e-10, "{criterion:?}: {left}");
            }
        }
    }
}

#[test]
fn what_surely_loses_gains_nothing_and_most_that_loses_surely_does() {
    let mut random = SplitMix64::new(17);
    let (mut losing, mut sure) = (0, 0);
    for round in 0..100_000 {
        // From nearly flat to tetrahedra, of any size.
        let thickness = [1e-6, 1e-3, 0.1, 1.0][round % 4];
        let size = [1e-4, 1.0, 1e4][round % 3];
        let mut point = || {
            let [x, y, z] = [(); 3].map(|()| random.gaussian());
            size * DVec3::new(x, y, thickness * z)
        };
        let quad = Quad {
            i: point(),
            j: point(),
            k: point(),
            l: point(),
        };
        let loses = quad.localised_reduction() < 0.0;
        losing += usize::from(loses);
        if quad.surely_loses() {
            assert!(loses, "{quad:?}");
            sure += 1;
        }
    }
    println!("{sure} of {losing}");
    assert!(2 * sure > losing && losing > 20_000, "{sure} of {losing}");
}
