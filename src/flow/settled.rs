//! The options that a flow runs with, of those that were given.

use super::option::Options;
use super::options::FlowOptions;
use super::spec::{self, FlowName};
use crate::energy::circle::Boundary;

impl FlowOptions {
    /// What happens at the boundary: as chosen, or as usual of the flow.
    pub fn boundary(&self) -> Boundary {
        let usual = || spec::of(self.flow).boundary.unwrap_or_default();
        self.boundary.unwrap_or_else(usual)
    }

    /// The options that the flow's system runs with: what the flow does not read is as usual, or
    /// as its row sets it.
    #[must_use]
    pub fn settled(&self) -> Self {
        let usual = Self::default();
        let mut options = self.clone();
        let set = (spec::of(self.flow).sets)();
        let rows = Self::ROWS.iter();
        for row in rows.filter(|row| !row.read_by.flows.contains(&self.flow)) {
            let own = set.iter().find(|(name, _)| *name == row.name);
            let value = own.map_or_else(|| (row.get)(&usual), |(_, value)| value.clone());
            (row.set)(&mut options, &value);
        }
        options
    }

    /// The same under another flow: what means nothing to it goes back to its default.
    #[must_use]
    pub fn with_flow(&self, flow: FlowName) -> Self {
        let usual = Self::default();
        let mut options = Self {
            flow,
            ..self.clone()
        };
        let rows = Self::ROWS.iter();
        for row in rows.filter(|row| row.is_of_one_flow) {
            (row.set)(&mut options, &(row.get)(&usual));
        }
        options
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flow::constraint::Kept;
    use crate::flow::option::find;
    use FlowName::{Mmcv, VolumePreserving};

    #[test]
    fn a_flow_runs_with_what_it_reads_and_what_its_row_sets() {
        let asked = FlowOptions {
            flow: VolumePreserving,
            p: 4.0,
            keep: vec![Kept::Area],
            tension: 3.0,
            reduced_volume: Some(0.6),
            regularise: crate::remesh::Mode::Off,
            tau: Some(0.5),
            ..FlowOptions::default()
        };
        let expected = FlowOptions {
            p: 0.0,
            keep: vec![Kept::Volume],
            tension: 0.0,
            reduced_volume: None,
            ..asked.clone()
        };
        assert_eq!(asked.settled(), expected);
        for row in spec::FLOWS {
            for (name, value) in (row.sets)() {
                let option = find::<FlowOptions>(name).expect("an option");
                let taken = (option.set)(&mut FlowOptions::default(), &value);
                assert!(taken, "{:?} sets {name}", row.id);
                let is_read = option.read_by.flows.contains(&row.id);
                assert!(!is_read, "{:?} sets {name}, which it reads", row.id);
            }
        }
    }

    #[test]
    fn another_flow_takes_back_what_means_nothing_to_it() {
        let before = FlowOptions {
            tau: Some(0.5),
            dt: Some(2.0),
            boundary: Some(Boundary::Free),
            goal: crate::flow::options::Goal::Smooth,
            epsilon: 0.3,
            free: Some(vec![1]),
            ..FlowOptions::default()
        };
        let expected = FlowOptions {
            flow: Mmcv,
            epsilon: 0.3,
            free: Some(vec![1]),
            ..FlowOptions::default()
        };
        assert_eq!(before.with_flow(Mmcv), expected);
    }
}
