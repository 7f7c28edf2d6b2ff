//! What a parameter of a call is about: the sections of a form.

use super::Param;
use serde::Serialize;

/// A section of a form; sections are shown in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Topic {
    /// What is measured, and where it lies by the drawing.
    Task,
    /// What is corrected.
    Correction,
    /// How the probe gets there: paths, feeds, protection zones.
    Approach,
    /// Limits that the measured value is held against.
    Tolerances,
    /// Repeated touches, mean and empirical values.
    Statistics,
    /// The probe that measures.
    Probe,
    /// What only the argument list of a newer control has.
    List,
}

/// Stems of the message keys of all parameters that are not about the task.
const TOPICS: &[(Topic, &[&str])] = &[
    (
        Topic::Correction,
        &[
            "knum", "tnum", "tname", "tenv", "dlnum", "g104-t", "g106-t", "nct-s", "nct-s-corner", "nct-t-size",
            "nct-t-surface", "nct-m", "p9920-t",
        ],
    ),
    (
        Topic::Approach,
        &[
            "fa", "fa-tool", "vms", "rf", "id", "id-radius", "sza", "szo", "mfs-feed-1", "mfs-feed-2", "mfs-feed-3",
            "mfs-speed-1", "mfs-speed-2", "mfs-speed-3", "nct-r", "nct-q", "g101-f", "p9920-e", "p9920-f", "p9920-k",
            "p9920-m", "p9920-s", "p9969-f", "p9969-q",
        ],
    ),
    (
        Topic::Tolerances,
        &[
            "tsa", "tsa-tool", "tdif", "tdif-tool", "tul", "tll", "tzl", "tzl-tool", "tmv", "tnvl", "119-limit",
            "nct-h", "nct-u", "nct-v", "nct-w",
        ],
    ),
    (Topic::Statistics, &["nmsp", "k", "evnum", "evnum-tool"]),
    (Topic::Probe, &["prnum", "prnum-tool", "cora", "cora-second-edge"]),
];

impl Param {
    /// The section of the form in which it is asked for.
    pub fn topic(&self) -> Topic {
        TOPICS.iter().find(|(_, stems)| stems.contains(&self.key)).map_or(Topic::Task, |(topic, _)| *topic)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::CYCLES;
    use std::collections::BTreeSet;

    // oracle: self
    #[test]
    fn each_stem_is_that_of_a_parameter_and_stands_once() {
        let known: BTreeSet<&str> = CYCLES.iter().flat_map(|cycle| cycle.params).map(|param| param.key).collect();
        let named: Vec<&str> = TOPICS.iter().flat_map(|(_, stems)| stems.iter().copied()).collect();
        for stem in &named {
            assert!(known.contains(stem), "no parameter is {stem}");
        }
        assert_eq!(named.iter().collect::<BTreeSet<_>>().len(), named.len());
    }

    /// What a new parameter is about is decided here, not forgotten: these alone are about the task.
    // oracle: hand (what the parameter's label says)
    #[test]
    fn what_is_about_the_task_is_said_so() {
        const TASK: &[&str] = &[
            "mvar", "setv", "sphere", "ma", "md", "sta1", "inca", "cpa", "cpo", "ra", "calnum", "p2-", "p3-", "p4-",
            "g10", "g110", "nct-corner", "p9920-d", "p9920-h", "p9920-z", "p9969-end", "p9969-r", "p9969-s", "log-",
            "113-", "116-", "118-", "119-measured", "119-set",
        ];
        for param in CYCLES.iter().flat_map(|cycle| cycle.params).filter(|param| param.topic() == Topic::Task) {
            assert!(TASK.iter().any(|stem| param.key.starts_with(stem)), "{} is about nothing", param.key);
        }
    }
}
