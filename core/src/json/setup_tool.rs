//! Tool probes and tools as they really are in the setup file, read and written.

use super::setup::ToolFile;
use super::setup_solid::{SolidFile, solid};
use super::{Error, object, setup_write};
use crate::refused::Path;
use crate::workpiece::tool::{Cut, Cutter, Nose, Tool};
use crate::workpiece::tool_probe::ToolProbe;
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// A tool probe as it really is: a cube (`block`) or a disc (`turned` without bore).
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub(super) struct ToolProbeFile {
    /// Its cap.
    solid: SolidFile,
    /// Travel after contact until the signal.
    #[serde(default)]
    pre_travel: f64,
    /// Delay of the signal, s.
    #[serde(default)]
    delay: f64,
    /// Standard deviation of the switching point, and the seed of its pseudo-random sequence.
    #[serde(default = "always")]
    repeatability: (f64, u64),
}

fn always() -> (f64, u64) {
    (0.0, 1)
}

/// A tool as it really is.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields)]
pub(super) struct RealFile {
    /// L1 L2 L3: to the lowest edge of a cutter in its axis; to the point P of a turning tool.
    length: [f64; 3],
    /// What cuts.
    cut: CutFile,
}

/// What cuts.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(rename_all = "camelCase")]
enum CutFile {
    /// A milling cutter or drill.
    Cutter(CutterFile),
    /// The nose of a turning tool.
    Nose(NoseFile),
}

/// A milling cutter or drill.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
struct CutterFile {
    /// Radius to the cutting edge.
    radius: f64,
    /// Radius between end and side.
    #[serde(default)]
    corner: f64,
    /// How far the lowest place of an edge lies inside of the widest, and the widest above the lowest.
    #[serde(default)]
    chamfer: [f64; 2],
    /// Number of teeth; 0: smooth all round.
    #[serde(default)]
    teeth: u32,
    /// Where the first tooth stands with the spindle at 0, degree.
    #[serde(default)]
    angle: f64,
    /// How far the cutter runs out: aside, and along its axis.
    #[serde(default)]
    runout: [f64; 2],
    /// In which direction, with the spindle at 0, degree.
    #[serde(default)]
    runout_angle: f64,
    /// Axis of the plane along which it stands: 0 abscissa, 1 ordinate, 2 applicate.
    #[serde(default = "applicate")]
    axis: usize,
    /// Width of a groove mill, whose length goes to its upper edge; 0: another cutter.
    #[serde(default)]
    disc: f64,
}

fn applicate() -> usize {
    2
}

/// The nose of a turning tool.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema, serde::Serialize))]
#[serde(deny_unknown_fields)]
struct NoseFile {
    /// Radius.
    radius: f64,
    /// From its centre S to the point P in abscissa and ordinate, in nose radii: -1, 0 or 1.
    side: [f64; 2],
}

/// A tool probe that stands at this place of the file.
pub(super) fn tool_probe(path: &Path, file: ToolProbeFile) -> Result<ToolProbe, Error> {
    Ok(ToolProbe {
        solid: solid(&path.member("solid"), file.solid)?,
        pre_travel: file.pre_travel,
        delay: file.delay,
        repeatability: file.repeatability,
    })
}

/// What the tools of a file really are, by T and D number.
pub(super) fn real_tools(files: &mut BTreeMap<i64, ToolFile>) -> BTreeMap<(i64, i64), Tool> {
    let mut tools = BTreeMap::new();
    for (tool, file) in files {
        for (edge, data) in &mut file.edges {
            if let Some(real) = data.real.take() {
                tools.insert((*tool, *edge), read(&real));
            }
        }
    }
    tools
}

fn read(file: &RealFile) -> Tool {
    let cut = match &file.cut {
        CutFile::Nose(nose) => Cut::Nose(Nose { radius: nose.radius, side: nose.side }),
        CutFile::Cutter(cutter) => Cut::Cutter(Cutter {
            radius: cutter.radius,
            corner: cutter.corner,
            chamfer: cutter.chamfer,
            teeth: cutter.teeth,
            angle: cutter.angle,
            runout: cutter.runout,
            runout_angle: cutter.runout_angle,
            axis: cutter.axis,
            disc: cutter.disc,
        }),
    };
    Tool { length: file.length, cut }
}

/// Tool probes as the setup file has them.
pub(super) fn tool_probes(list: &[ToolProbe]) -> Value {
    let probe = |probe: &ToolProbe| {
        let (deviation, seed) = probe.repeatability;
        object([
            ("solid", setup_write::solid(&probe.solid)),
            ("preTravel", probe.pre_travel.into()),
            ("delay", probe.delay.into()),
            ("repeatability", Value::Array(vec![deviation.into(), seed.into()])),
        ])
    };
    list.iter().map(probe).collect()
}

/// A real tool as the setup file has it.
pub(super) fn real(tool: &Tool) -> Value {
    let cut = match &tool.cut {
        Cut::Cutter(cutter) => ("cutter", self::cutter(cutter)),
        Cut::Nose(nose) => ("nose", object([("radius", nose.radius.into()), ("side", nose.side.into())])),
    };
    object([("length", tool.length.into()), ("cut", object([cut]))])
}

fn cutter(cutter: &Cutter) -> Value {
    object([
        ("radius", cutter.radius.into()),
        ("corner", cutter.corner.into()),
        ("chamfer", cutter.chamfer.into()),
        ("teeth", cutter.teeth.into()),
        ("angle", cutter.angle.into()),
        ("runout", cutter.runout.into()),
        ("runoutAngle", cutter.runout_angle.into()),
        ("axis", cutter.axis.into()),
        ("disc", cutter.disc.into()),
    ])
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use crate::json::{setup_from_json, setup_to_json};
    use serde_json::{Value, json};

    fn setup() -> Value {
        json!({
            "control": "sinumerik",
            "probe": { "radius": 3.0, "length": 50.0 },
            "tools": { "3": { "edges": {
                "1": {
                    "type": 120, "length": [70.0, 0.0, 0.0], "radius": 18.0,
                    "real": { "length": [70.85, 0.0, 0.0], "cut": { "cutter": {
                        "radius": 18.6, "corner": 1.0, "chamfer": [0.5, 2.4], "teeth": 3, "angle": 15.0,
                        "runout": [0.02, 0.01], "runoutAngle": 30.0, "axis": 1, "disc": 5.0
                    } } }
                },
                "2": {
                    "type": 500, "tip": 3, "length": [70.0, 40.0, 0.0], "radius": 0.8,
                    "real": { "length": [70.1, 40.2, 0.0], "cut": { "nose": { "radius": 0.79, "side": [-1.0, -1.0] } } }
                }
            } } },
            "toolProbes": [
                { "solid": { "shape": "block", "size": [20.0, 20.0, 15.0], "at": [39.0, 31.0, 80.0] },
                    "preTravel": 0.01 },
                { "solid": { "shape": "turned", "size": [20.0, 15.0, 0.0, 0.0], "at": [139.0, 31.0, 80.0] },
                  "delay": 0.001, "repeatability": [0.001, 7] }
            ]
        })
    }

    #[test]
    fn tools_and_tool_probes_read_back_as_written() {
        // oracle: self: reading what was written gives the same setup
        let read = setup_from_json(&setup().to_string()).unwrap();
        assert_eq!((read.tool_probes.len(), read.real_tools.len()), (2, 2));
        let again = setup_from_json(&setup_to_json(&read).to_string()).unwrap();
        assert_eq!(again, read);
    }

    #[test]
    fn what_cannot_be_is_refused() {
        // oracle: hand
        for (place, wrong) in [
            ("/toolProbes/0/solid/shape", json!("sphere")),
            ("/toolProbes/1/solid/size", json!([20.0, 15.0, 8.0, 5.0])),
            ("/tools/3/edges/1/real/cut/cutter/radius", json!(-1.0)),
            ("/tools/3/edges/1/real/cut/cutter/corner", json!(30.0)),
            ("/tools/3/edges/1/real/cut/cutter/teeth", json!(1000)),
            ("/tools/3/edges/1/real/cut/cutter/axis", json!(3)),
            ("/tools/3/edges/2/real/cut/nose/side", json!([0.5, 0.0])),
        ] {
            let mut setup = setup();
            *setup.pointer_mut(place).unwrap() = wrong;
            assert!(setup_from_json(&setup.to_string()).is_err(), "{place}");
        }
    }
}
