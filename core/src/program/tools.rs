//! The tool in use at the calls of a program, and what the program itself says of it (`$TC_DP1[7,1]=120`).

use super::flow::{Mode, State, Tool};
use crate::control::{Control, Edge, Transverse, machine_data::setting, probe::Unfit};
use crate::diagnostic::Code;

/// The tool has no length or no radius.
const SIZE: Code = Code::Alarm(61351);
/// The cutting edge position is none that the cycle takes.
const TIP: Code = Code::Alarm(61315);

/// A tool with what it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ToolInUse {
    /// T number.
    pub number: i64,
    /// `$TC_DP1`.
    pub kind: i64,
    /// Cutting edge position, `$TC_DP2`; 0: none, or not known.
    pub tip: i64,
    /// Why the milling cycles do not take it here.
    pub unfit: Option<Unfit>,
    /// Whether it has lengths, but on this turning machine none along the applicate.
    pub unassigned: bool,
}

/// What is known of the tools while a program is read.
pub struct Tools {
    /// The control on which the program starts.
    pub start: Control,
}

impl Tools {
    /// A datum that the program writes; none: its value is not known.
    pub fn learn(&self, control: &mut Control, name: &str, number: Option<f64>) {
        if name.starts_with("$TC_") {
            control.set_variable(name, number.unwrap_or(0.0));
        } else if let (Some(datum), Some(number)) = (setting(name), number) {
            control.set(datum, number);
        }
    }

    /// Activates what a call finds, and says what the tool is: none is in use where the text does not tell.
    pub fn use_at(&self, control: &mut Control, state: &State) -> Option<ToolInUse> {
        (control.tool, control.edge) = (self.start.tool, self.start.edge);
        match state.plane.is() {
            Some(plane) => control.plane = *plane,
            None if state.plane.unset() => control.plane = self.start.plane,
            None => {}
        }
        control.choose_units(state.units.is().copied().unwrap_or(self.start.unit_function() as u16));
        // where the text does not tell, diameters, as in a form
        control.transverse = state.transverse.is().copied().unwrap_or(Transverse::Diameter);
        // checks ask only whether it turns, not how fast; where the text does not tell, it may
        control.spindle_speed = match state.turning {
            Mode::Unset => self.start.spindle_speed,
            Mode::Is(false) => 0.0,
            Mode::Is(true) | Mode::Open => 1.0,
        };
        if !state.tool.unset() {
            let number = match state.tool.is() {
                Some(Tool::Number(number)) => Some(*number),
                Some(Tool::Name(name)) => {
                    let mut tools = control.tools.iter();
                    tools.find(|(_, tool)| tool.name.eq_ignore_ascii_case(name)).map(|(number, _)| *number)
                }
                None => None,
            };
            control.tool = number.unwrap_or(0);
            control.edge = number.map_or(0, |_| match state.edge.is() {
                Some(edge) => *edge,
                None if state.edge.unset() => 1,
                None => 0,
            });
        }
        let edge = control.active_edge().filter(|edge| edge.kind != 0)?;
        Some(ToolInUse {
            number: control.tool,
            kind: edge.kind,
            tip: edge.tip,
            // a position that the program does not enter the machine may know
            unfit: control.unfit(edge).filter(|unfit| *unfit != Unfit::Tip || edge.tip != 0 || self.had(control)),
            unassigned: control.turns() && lengthless(control, edge),
        })
    }

    /// Whether a finding is worth telling: what a program does not say of a tool that it enters the machine may know.
    pub fn told(&self, control: &Control, code: Code) -> bool {
        let no_tip = || control.active_edge().is_none_or(|edge| edge.tip == 0);
        let left_open = code == SIZE || code == TIP && no_tip();
        !left_open || self.had(control)
    }

    /// Whether the control had the edge in use before the program.
    fn had(&self, control: &Control) -> bool {
        self.start.edge_of(control.tool, control.edge).is_some()
    }
}

/// Whether a tool has lengths, but none along the applicate.
fn lengthless(control: &Control, edge: &Edge) -> bool {
    let along = control.length_along_applicate(edge);
    let long = |index: usize| edge.total_length(index) != 0.0;
    !long(along) && (0..3).any(long)
}
