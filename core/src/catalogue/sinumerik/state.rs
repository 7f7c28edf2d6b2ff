//! What the workpiece cycles demand of the control before anything else (B:4141-4157, A:15840-15935).

use crate::catalogue::lathe;
use crate::catalogue::prelude::*;
use crate::control::{Frame, Value, gud, probe::Unfit};

/// Bit of MD28082 for the system frame of the cycles (A:15840, B:1977).
const CYCLE_FRAME: u32 = 5;

/// Arrays that must have as many fields as the control says (B:13345-13348); newer controls have them in setting data,
/// which are there.
const FIELDS: [&str; 4] = ["_TP", "_WP", "_KB", "_TPW"];

/// Whether the workpiece cycles of this sort of machine take a control in this state; else the number of the alarm. A
/// turning machine needs its probe in use and no rotation (B:8708, A:15848, A:15856, A:15873).
pub fn fit(control: &Control, machine: MachineSort) -> Result<(), u32> {
    let edge = with_edge(control)?;
    match machine {
        MachineSort::Turning if !edge.is_turning() => Err(61309),
        MachineSort::Turning if !lathe::TIPS.contains(&edge.tip) => Err(61315),
        MachineSort::Turning if control.rotated() => Err(61330),
        MachineSort::Turning => Ok(()),
        _ if control.unfit(edge).is_some_and(|unfit| unfit != Unfit::Digit) => Err(61309), // B:4147-4152, A:15848
        _ => Ok(()),
    }
}

/// The edge in use of a control in which any measuring cycle may run; else the number of the alarm.
pub fn with_edge(control: &Control) -> Result<&Edge, u32> {
    if !control.machine_bit("MD28082", CYCLE_FRAME) {
        return Err(61016);
    }
    if (0..3).any(|axis| control.number(&format!("MD20050[{axis}]")) == 0.0) {
        return Err(61336); // a geometry axis has no channel axis, A:15878, B:14084
    }
    if software(control) < 3.0 {
        return Err(61342); // A:15883, B:13682
    }
    if !control.has_setting_data() && FIELDS.iter().any(|array| !fits(control, array)) {
        return Err(61416); // A:15935
    }
    if control.chain().iter().any(Frame::scaled) {
        return Err(61310); // B:744, A:15849
    }
    control.active_edge().ok_or(61311) // A:15850
}

/// Version of the control software, `_SI[1]`: a text, of which the first digit counts; 0 where there is none.
pub fn software(control: &Control) -> f64 {
    match control.data.get("_SI[1]") {
        Some(Value::Text(text)) => text.trim().get(..1).and_then(|digit| digit.parse().ok()),
        Some(Value::Number(number)) => Some(*number),
        None => None,
    }
    .unwrap_or(0.0)
}

/// Whether there are as many data fields as the datum says that counts them.
fn fits(control: &Control, array: &str) -> bool {
    let size = gud::find(array).map_or(0.0, |gud| control.number(gud.counted)) as usize;
    (0..size).all(|field| control.data.contains_key(&format!("{array}[{field},0]")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::Plane;
    use crate::dialect::Dialect;
    use crate::geometry::Rpy;
    use crate::machine::Setup;

    /// A number, and what the control lacks for it.
    type Case = (u32, fn(&mut Control));

    #[test]
    fn a_ready_control_is_not_refused() {
        let control = || Setup::calibrated(Dialect::Sinumerik, Plane::G17).control;
        assert_eq!(fit(&control(), MachineSort::Milling), Ok(()));
        // oracle: manual A:15840, A:15878, A:15883, A:15935, B:744, A:15850, B:4147-4152
        let cases: [Case; 9] = [
            (61016, |control| control.set("MD28082", 1.0)),
            (61336, |control| control.set("MD20050[2]", 0.0)),
            (61342, |control| drop(control.data.remove("_SI[1]"))),
            (61342, |control| control.set("_SI[1]", 2.0)),
            (61416, |control| control.set("_CVAL[2]", 4.0)),
            (61310, |control| control.basic.system.scale = [1.0, 1.0, 2.0]),
            (61310, |control| control.active.scale = [0.5; 3]),
            (61311, |control| control.edge = 0),
            (61309, |control| {
                control.set_variable("$TC_DP1[9,1]", 500.0);
            }),
        ];
        for (number, change) in cases {
            let mut control = control();
            change(&mut control);
            assert_eq!(fit(&control, MachineSort::Milling), Err(number));
        }
    }

    // oracle: peer (remedies of 61313 and 61416 of newer controls: 12 workpiece and 6 tool probes, counted by
    // MD51600 to MD51603): however many fields it counts, none of them is missing
    #[test]
    fn a_newer_control_has_the_fields_that_it_counts() {
        for generation in [2.0, 3.0] {
            for (datum, fields) in [("MD51600", 12.0), ("MD51601", 9.0), ("MD51602", 6.0), ("MD51603", 1.0)] {
                let mut control = Setup::calibrated(Dialect::Sinumerik, Plane::G17).control;
                control.set(crate::control::GENERATION, generation);
                control.set(datum, fields);
                control.take_setting_data();
                assert_eq!(fit(&control, MachineSort::Milling), Ok(()), "{datum}={fields}");
            }
        }
    }

    #[test]
    fn a_turning_machine_needs_its_own_probe() {
        // oracle: manual B:8708, A:15848, A:15856, A:15873
        let cases: [Case; 4] = [
            (61309, |control| {
                control.set_variable("$TC_DP1[9,1]", 710.0);
            }),
            (61315, |control| {
                control.set_variable("$TC_DP2[9,1]", 3.0);
            }),
            (61330, |control| control.active.rotation = Rpy([0.0, 5.0, 0.0])),
            (61311, |control| control.edge = 0),
        ];
        let control = || Setup::turning(Plane::G18).control;
        assert_eq!(fit(&control(), MachineSort::Turning), Ok(()));
        for (number, change) in cases {
            let mut control = control();
            change(&mut control);
            assert_eq!(fit(&control, MachineSort::Turning), Err(number));
        }
    }
}
