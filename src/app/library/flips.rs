//! Figures of Brink & Alboul [BA](crate::bibliography#ba), edge flips by area, Willmore and
//! localised Willmore energy.

use super::figure::{Figure, Finding};
use super::measured::Run;
use crate::app::{Arrangement, Compare, FieldName};
use crate::flow::flips::FlipReading;
use crate::flow::options::FlowOptions;
use crate::remesh::flips::reduction::Criterion;

const PLAIN: Figure = Figure {
    paper: "flips",
    arrangement: Arrangement {
        compare: Compare::Criteria,
        flips_per_step: None,
        ..Arrangement::PLAIN
    },
    ..Figure::PLAIN
};

/// Where the criteria end: by area, by the Willmore energy and by the localised one.
fn ends(run: &Run<'_>, holds: fn([&FlipReading; 3]) -> bool) -> Finding {
    let criteria = [Criterion::Area, Criterion::Willmore, Criterion::Localised];
    let [Some(area), Some(willmore), Some(localised)] = criteria.map(|one| run.flips(one)) else {
        return Finding::new(false, "measured-incomplete", &[]);
    };
    let values = [
        ("areaFlips", area.flips.into()),
        ("willmoreFlips", willmore.flips.into()),
        ("localisedFlips", localised.flips.into()),
        ("area", area.area.into()),
        ("willmoreArea", willmore.area.into()),
        ("localisedArea", localised.area.into()),
        ("areaCircle", area.circle.into()),
        ("willmoreCircle", willmore.circle.into()),
        ("localisedCircle", localised.circle.into()),
    ];
    Finding::new(
        holds([area, willmore, localised]),
        "measured-flips",
        &values,
    )
}

pub(super) static FIGURES: &[Figure] = &[
    Figure {
        id: "flips-6",
        number: "6",
        sample: "sampled-torus",
        judge: |run| {
            ends(run, |all| {
                let [area, ..] = all;
                all.iter().all(|other| {
                    other.flips == 203
                        && (other.area - area.area).abs() < 1e-9
                        && (other.circle - area.circle).abs() < 1e-9
                })
            })
        },
        ..PLAIN
    },
    Figure {
        id: "flips-6-curvature",
        number: "6",
        sample: "sampled-torus",
        arrangement: Arrangement {
            compare: Compare::Start,
            subdivide: 2,
            flips_per_step: None,
        },
        colour: Some(FieldName::GaussCurvature),
        judge: |run| {
            let names = ["start", "localised"];
            let [before, after] = names.map(|one| run.variation(one, FieldName::GaussCurvature));
            let values = [("first", before.into()), ("last", after.into())];
            Finding::new(after < 0.7 * before, "measured-variation", &values)
        },
        ..PLAIN
    },
    Figure {
        id: "flips-7",
        number: "7",
        sample: "creased-face",
        falls_short: true,
        judge: |run| {
            ends(run, |[area, willmore, localised]| {
                area.circle < willmore.circle && localised.circle < willmore.circle
            })
        },
        ..PLAIN
    },
    Figure {
        id: "flips-8",
        number: "8",
        sample: "eared-head",
        judge: |run| {
            ends(run, |[area, willmore, localised]| {
                area.area <= localised.area + 1e-12
                    && localised.area < willmore.area
                    && area.circle < willmore.circle
                    && localised.circle < willmore.circle
            })
        },
        ..PLAIN
    },
    Figure {
        id: "flips-8-volume",
        number: "8",
        sample: "eared-head",
        options: |o| FlowOptions {
            criterion: Criterion::Area,
            ..o
        },
        arrangement: Arrangement {
            flips_per_step: None,
            ..Arrangement::PLAIN
        },
        judge: |run| {
            let volumes = run.first.volume.zip(run.last.volume);
            let lost = volumes.map_or(f64::NAN, |(first, last)| 1.0 - last / first);
            let ok = (0.002..=0.02).contains(&lost);
            Finding::new(ok, "measured-lost", &[("lost", (100.0 * lost).into())])
        },
        ..PLAIN
    },
];
