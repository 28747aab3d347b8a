//! The rows of a flow's options.

use super::{Kind, Named, Options, Range, ReadBy, Row};
use crate::energy::circle::Boundary;
use crate::flow::constraint::Kept;
use crate::flow::options::{FlowOptions, Goal, Integrator, MassChoice, Remeshing, Scheme};
use crate::flow::spec::{ALL, CIRCLE, CLOSED, FLIPS, FlowName, MMCV, MOVING, OPEN, P_WILLMORE};
use crate::remesh::Mode;
use crate::remesh::flips::reduction::Criterion;

impl Named for FlowName {}
impl Named for Scheme {}
impl Named for Integrator {}
impl Named for Goal {}
impl Named for MassChoice {}
impl Named for Boundary {}
impl Named for Kept {}
impl Named for Mode {}
impl Named for Remeshing {}
impl Named for Criterion {}

/// A row: field, name and flag; kind and unit; group and readers.
macro_rules! option_row {
    ($field:ident, $name:literal, $flag:literal, $kind:expr, $unit:literal, $group:ident, $by:expr) => {
        $crate::flow::option::Row {
            name: $name,
            flag: $flag,
            kind: $kind,
            absent: None,
            was: None,
            words: &[],
            unit: $unit,
            group: $crate::flow::option::Group::$group,
            read_by: $by,
            is_of_one_flow: false,
            get: |options: &Self| $crate::flow::option::Field::value(&options.$field),
            set: |options: &mut Self, value| {
                let read = $crate::flow::option::Field::of(value);
                read.map(|read| options.$field = read).is_some()
            },
        }
    };
}
pub(crate) use option_row as row;

/// A larger perturbation folds faces.
const MAX_PERTURBATION: f64 = 0.3;
/// |Y|^p and its derivatives stay within double precision.
const MAX_EXPONENT: f64 = 16.0;
/// Far beyond any step that a flow can take.
const MAX_TAU: f64 = 1e12;

impl Options for FlowOptions {
    // A table reads best by lines.
    #[rustfmt::skip]
    const ROWS: &'static [Row<Self>] = &{
        use Kind::{Number, Switch, Vertices};
        let moving = ReadBy::flows(MOVING);
        let open = ReadBy::flows(OPEN);
        let circle = ReadBy::flows(CIRCLE);
        let smoothing = circle.goal(Goal::Smooth);
        let p_willmore = ReadBy::flows(P_WILLMORE);
        let closed = ReadBy::flows(CLOSED);
        let paper = closed.scheme(Scheme::Paper);
        let without_passes = closed.remesh(Remeshing::Off);
        let flips = ReadBy::flows(FLIPS);
        let any = Range::closed(-1e6, 1e6);
        let tau = Range::positive(MAX_TAU);
        [
            row!(flow, "flow", "flow", Kind::choice::<FlowName>(), "", Flow, ReadBy::flows(ALL)),
            row!(scheme, "scheme", "scheme", Kind::choice::<Scheme>(), "", Flow, moving),
            row!(boundary, "boundary", "boundary",
                Kind::choice::<Boundary>(), "", Surface, open).or("auto").of_one_flow(),
            row!(free, "free", "free", Vertices, "", Surface, open).or("auto"),
            row!(fixed, "fixed", "fixed", Vertices, "", Surface, open).or("auto"),
            row!(prefill, "prefill", "prefill", Switch, "", Surface, open),
            row!(p, "p", "p",
                Number(Range::closed(1.0, MAX_EXPONENT).or_zero()), "", Functional, p_willmore),
            row!(keep, "keep", "keep", Kind::set::<Kept>(), "", Functional, p_willmore),
            row!(reduced_volume, "reducedVolume", "reduced-volume",
                Number(Range::positive(1.0)), "", Functional, p_willmore).or("auto"),
            row!(spontaneous_curvature, "spontaneousCurvature", "spontaneous-curvature",
                Number(Range::closed(-1e3, 1e3)), "1/L", Functional, p_willmore),
            row!(tension, "tension", "tension", Number(any), "1/L²", Functional, p_willmore),
            row!(pressure, "pressure", "pressure", Number(any), "1/L³", Functional, p_willmore),
            row!(epsilon, "epsilon", "epsilon",
                Number(Range::closed(0.0, 1.0)), "rad", Functional, circle),
            row!(sharpen, "sharpen", "sharpen", Switch, "", Functional, circle.goal(Goal::Relax)),
            row!(criterion, "criterion", "criterion",
                Kind::choice::<Criterion>(), "", Functional, flips),
            row!(guard_folds, "guardFolds", "guard-folds", Switch, "", Functional, flips),
            row!(goal, "goal", "goal", Kind::choice::<Goal>(), "", Step, circle).of_one_flow(),
            row!(detail, "detail", "detail",
                Number(Range::closed(0.1, 1e3)), "mean edge lengths", Step, smoothing),
            row!(smooth_steps, "smoothSteps", "smooth-steps",
                Number(Range::count(1.0)), "steps", Step, smoothing),
            row!(tau, "tau", "tau", Number(tau), "", Step, moving).or("auto").of_one_flow(),
            row!(dt, "dt", "dt",
                Number(Range::positive(1e300)), "length^k", Step, moving).or("auto").of_one_flow(),
            row!(tau_growth, "tauGrowth", "tau-growth",
                Number(Range::positive(1e2)), "", Step, paper),
            row!(tau_max, "tauMax", "tau-max", Number(tau), "", Step, paper).or("auto"),
            row!(integrator, "integrator", "integrator",
                Kind::choice::<Integrator>(), "", Method, circle),
            row!(mass, "mass", "mass", Kind::choice::<MassChoice>(), "", Method, circle),
            row!(remesh, "remesh", "remesh",
                Kind::choice::<Remeshing>(), "", Method, p_willmore.scheme(Scheme::Auto)).was("off"),
            row!(regularise, "regularise", "regularise",
                Kind::choice::<Mode>(), "", Method, without_passes),
            row!(regularise_epsilon, "regulariseEpsilon", "regularise-epsilon",
                Number(Range::positive(1e3)), "", Method, without_passes),
            row!(perturbation, "perturbation", "perturbation",
                Number(Range::closed(0.0, MAX_PERTURBATION)), "mean edge lengths", Method, closed),
            row!(rungs, "rungs", "rungs",
                Number(Range::count(0.0)), "steps", Method, ReadBy::flows(MMCV)).or("auto"),
            row!(max_steps, "maxSteps", "steps",
                Number(Range::count(0.0)), "steps", Budget, moving).or("auto"),
            row!(max_seconds, "maxSeconds", "seconds",
                Number(Range::positive(1e9)), "s", Budget, moving.goal(Goal::Relax)).or("auto"),
        ]
    };
}

#[cfg(test)]
mod tests {
    use super::super::{OptionError, Value, Values, check, find, options_of, read, read_strictly};
    use super::*;
    use crate::message::Say;

    fn values(pairs: &[(&str, Value)]) -> Values {
        pairs
            .iter()
            .map(|(name, value)| ((*name).into(), value.clone()))
            .collect()
    }

    fn words(pairs: &[(&str, &str)]) -> Values {
        let text = |(name, text): &(&str, &str)| ((*name).into(), Value::Text((*text).into()));
        pairs.iter().map(text).collect()
    }

    #[test]
    fn every_field_has_one_row_that_reads_and_writes_it() {
        let default = FlowOptions::default();
        let fields = serde_json::to_value(&default).expect("JSON");
        let fields = fields.as_object().expect("an object");
        let names: Vec<&str> = FlowOptions::ROWS.iter().map(|row| row.name).collect();
        let mut sorted = names.clone();
        sorted.sort_unstable();
        let mut expected: Vec<&str> = fields.keys().map(String::as_str).collect();
        expected.sort_unstable();
        assert_eq!(sorted, expected);
        let flags: std::collections::BTreeSet<_> =
            FlowOptions::ROWS.iter().map(|row| row.flag).collect();
        assert_eq!(flags.len(), names.len(), "two options have one flag");
        for row in FlowOptions::ROWS {
            let value = (row.get)(&default);
            assert_eq!(
                serde_json::to_value(&value)
                    .expect("JSON")
                    .to_string()
                    .replace(".0", ""),
                fields[row.name].to_string().replace(".0", ""),
                "the default of {}",
                row.name
            );
            assert_eq!(row.check(&value), Ok(()), "the default of {}", row.name);
            // A field that can be absent, and only that, has a word for it.
            let mut other = default.clone();
            assert_eq!(
                (row.set)(&mut other, &Value::Absent),
                row.absent.is_some(),
                "{}",
                row.name
            );
        }
    }

    /// For each row a value that is not its default, as text.
    #[test]
    fn a_text_changes_its_own_field_and_no_other() {
        for row in FlowOptions::ROWS {
            let text = match row.kind {
                Kind::Number(range) if range.whole => "7".into(),
                Kind::Number(_) => match row.name {
                    "p" => "3.5".into(),
                    _ => "0.25".into(),
                },
                Kind::Choice(ids) => {
                    let usual = (row.get)(&FlowOptions::default());
                    let other = ids().iter().find(|id| usual != Value::Text((**id).into()));
                    (*other.expect("a choice has two names")).to_string()
                }
                Kind::Set(ids) => ids().join(","),
                Kind::Switch => match (row.get)(&FlowOptions::default()) {
                    Value::Switch(true) => "false".into(),
                    _ => "true".into(),
                },
                Kind::Numbers(_) | Kind::Vertices => "3,1,4".into(),
            };
            let given = read::<FlowOptions>(&words(&[(row.name, &text)])).expect(row.name);
            let options: FlowOptions = options_of(&given).expect(row.name);
            let (now, before) = (
                serde_json::to_value(&options).expect("JSON"),
                serde_json::to_value(FlowOptions::default()).expect("JSON"),
            );
            for field in FlowOptions::ROWS {
                let is_same = now[field.name] == before[field.name];
                assert_eq!(
                    is_same,
                    field.name != row.name,
                    "{} {}",
                    row.name,
                    field.name
                );
            }
        }
    }

    #[test]
    fn ranges_end_where_they_say() {
        let edge = |name: &str, x: f64| {
            find::<FlowOptions>(name)
                .expect(name)
                .check(&Value::Number(x))
        };
        for (name, good, bad) in [
            ("epsilon", vec![0.0, 1.0], vec![-1e-9, 1.0 + 1e-9]),
            ("p", vec![0.0, 1.0, 16.0], vec![0.5, -1.0, 16.001]),
            ("perturbation", vec![0.0, 0.3], vec![0.31, -0.1]),
            ("reducedVolume", vec![1.0, 1e-3], vec![0.0, 1.01]),
            ("detail", vec![0.1, 1000.0], vec![0.0, 1001.0]),
            ("dt", vec![1e-300, 1e300], vec![0.0, -1.0]),
            ("smoothSteps", vec![1.0, 10.0], vec![0.0, 1.5]),
            ("rungs", vec![0.0], vec![-1.0, 0.5]),
        ] {
            for x in good {
                assert_eq!(edge(name, x), Ok(()), "{name} {x}");
            }
            for x in bad
                .into_iter()
                .chain([f64::NAN, f64::INFINITY, f64::NEG_INFINITY])
            {
                let error = edge(name, x).expect_err(name);
                assert_eq!(error.kind(), "BadOption", "{name} {x}");
                assert!(error.to_string().contains(name), "{error}");
            }
        }
    }

    #[test]
    fn a_text_and_a_value_are_refused_with_the_same_words() {
        let number = Value::Number;
        for (name, text, value) in [
            ("epsilon", "7", number(7.0)),
            ("epsilon", "NaN", number(f64::NAN)),
            ("p", "1e999", number(f64::INFINITY)),
            ("tau", "soon", Value::Text("soon".into())),
            ("integrator", "rk4", Value::Text("rk4".into())),
            ("sharpen", "maybe", Value::Text("maybe".into())),
            (
                "keep",
                "area,shape",
                Value::List(vec![
                    Value::Text("area".into()),
                    Value::Text("shape".into()),
                ]),
            ),
            ("goal", "", Value::Text(String::new())),
        ] {
            let of_text = read::<FlowOptions>(&words(&[(name, text)])).expect_err(name);
            let of_value = options_of::<FlowOptions>(&values(&[(name, value)])).expect_err(name);
            assert_eq!(of_text, of_value, "{name}");
            assert_eq!(of_text.kind(), "BadOption", "{name}");
        }
        let mut options = FlowOptions {
            epsilon: 7.0,
            ..FlowOptions::default()
        };
        let of_text = read::<FlowOptions>(&words(&[("epsilon", "7")])).expect_err("7");
        assert_eq!(check(&options), Err(of_text));
        options.epsilon = 0.5;
        assert_eq!(check(&options), Ok(()));
    }

    #[test]
    fn a_misspelt_option_is_told_the_one_that_was_meant() {
        let meant = |name: &str| {
            let error = read::<FlowOptions>(&words(&[(name, "1")])).expect_err(name);
            let OptionError::UnknownOption { near, flag, .. } = error else {
                panic!("{error}");
            };
            (near, flag)
        };
        let both = |name: &str, flag: &str| (name.to_owned(), flag.to_owned());
        assert_eq!(meant("stepz"), both("maxSteps", "steps"));
        assert_eq!(meant("maxSecond"), both("maxSeconds", "seconds"));
        assert_eq!(meant("unheard"), both("none", "none"));
    }

    #[test]
    fn an_option_that_would_change_nothing_is_refused_where_that_is_asked_for() {
        let refused = |pairs: &[(&str, &str)]| match read_strictly(&words(pairs)) {
            Ok(_) => None,
            Err(OptionError::UnreadOption {
                flows,
                scheme,
                goal,
                ..
            }) => Some((flows, scheme, goal)),
            Err(error) => panic!("{error}"),
        };
        assert_eq!(refused(&[("epsilon", "0.2"), ("tau", "1")]), None);
        let other = refused(&[("flow", "mmcv"), ("epsilon", "0.2")]);
        assert_eq!(other, Some((vec!["circle"], "any", "any")));
        let goal = refused(&[("detail", "3")]);
        assert_eq!(goal, Some((vec!["circle"], "any", "smooth")));
        let scheme = refused(&[("flow", "p-willmore"), ("tauMax", "3")]);
        let closed: Vec<_> = CLOSED.iter().map(|flow| flow.id()).collect();
        assert_eq!(scheme, Some((closed, "paper", "any")));
        let set = refused(&[("flow", "volume-preserving"), ("p", "2")]);
        assert_eq!(set, Some((vec!["p-willmore"], "any", "any")));
        // Passes of remeshing stand in the place of regularisation.
        for own in [("regularise", "linear"), ("regulariseEpsilon", "0.1")] {
            let passes = |more: &[_]| {
                let pairs = [&[("flow", "p-willmore"), own], more].concat();
                read_strictly(&words(&pairs))
            };
            let error = passes(&[]).expect_err("they are on");
            assert!(
                matches!(error, OptionError::LoneOption { name, other: "remesh", value: "off" }
                    if name == own.0)
            );
            assert!(passes(&[("remesh", "isotropic")]).is_err());
            assert!(passes(&[("remesh", "off")]).is_ok());
            assert!(passes(&[("scheme", "paper")]).is_ok());
            // Terms with a length for their unit let no mesh change.
            assert!(passes(&[("tension", "1")]).is_ok());
            assert_eq!(refused(&[("flow", "volume-preserving"), own]), None);
        }
        assert!(matches!(
            read_strictly(&words(&[("dt", "1"), ("tau", "1")])),
            Err(OptionError::ConflictingOptions {
                first: "dt",
                second: "tau"
            })
        ));
    }
}
