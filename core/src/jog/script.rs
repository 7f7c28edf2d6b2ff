//! A session written down: a line a thing that the user does. What stands behind `;` or `#` is a comment.
//!
//! ```text
//! mask set_edge          softkey of a function
//! zo = G54               a field of the mask, or of the activation screen
//! move X-20 Y10 Z-5      the axes, one after the other as they are written, in the WCS of the measurement
//! move machine Z300      in machine coordinates
//! jog X+0.5              by so much
//! start                  NC start; "start reset" presses RESET while it runs
//! reject P2              softkey of a black point; "plc P2 on" is the bit of the PLC
//! store P2               softkey that stores the touched point of a corner up to SW 6.2
//! calculate
//! activate               NC start on the activation screen
//! <<                     leaves mask or screen
//! reset
//! mode                   another mode
//! tool T9 D1             into the spindle
//! set _JM_I[4] = 1       a datum of the control
//! ```

use crate::control::AXES;
use crate::geometry::FARTHEST;
use crate::message::Message;

/// A thing that the user does.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Opens a mask.
    Mask(String),
    /// Enters a value into a field.
    Field(String, String),
    /// Moves axes X Y Z (by index) one after the other to positions or by ways, mm.
    Move(Vec<(usize, f64)>, Way),
    /// NC start; whether RESET is pressed while it runs.
    Start(bool),
    /// RESET.
    Reset,
    /// A softkey P1 to P4 that is black.
    Reject(usize),
    /// The softkey that stores a point (up to SW 6.2).
    Store(usize),
    /// A bit of the PLC.
    Plc(usize, bool),
    /// Calculate.
    Calculate,
    /// NC start on the activation screen.
    Activate,
    /// `<<`.
    Back,
    /// Another mode.
    Mode,
    /// Takes a tool into the spindle: T and D.
    Tool(i64, i64),
    /// Writes a datum of the control.
    Set(String, f64),
}

/// What the numbers of a motion are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Positions in the WCS of the measurement.
    To,
    /// Positions of the machine.
    Machine,
    /// Ways from here.
    By,
}

/// A line of a script.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Number, from 1.
    pub number: u32,
    /// As it is written, without comment.
    pub text: String,
    /// What it does.
    pub command: Command,
}

/// A line that cannot be read.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// Number, from 1.
    pub line: u32,
    /// What is wrong.
    pub message: Message,
    /// What helps.
    pub hint: Message,
}

/// Most lines of a script.
pub const MOST: usize = 100_000;

/// Words that begin a command.
const COMMANDS: [&str; 14] = [
    "mask", "move", "jog", "start", "reset", "reject", "store", "plc", "calculate", "activate", "<<", "mode", "tool",
    "set",
];

/// Reads a script.
///
/// # Errors
/// The first line that cannot be read.
pub fn read(text: &str) -> Result<Vec<Line>, Wrong> {
    let mut lines = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let text = bare(line);
        let number = u32::try_from(index + 1).unwrap_or(u32::MAX);
        if text.is_empty() {
            continue;
        }
        if lines.len() >= MOST {
            let message = Message::new("jog-script-long").number("limit", MOST as f64);
            return Err(Wrong { line: number, message, hint: Message::new("jog-script-long-hint") });
        }
        let wrong = |(message, hint)| Wrong { line: number, message, hint };
        lines.push(Line { number, text: text.to_owned(), command: command(text).map_err(wrong)? });
    }
    Ok(lines)
}

/// How many lines say something behind one.
pub fn behind(text: &str, line: u32) -> u32 {
    let says = |text: &&str| !bare(text).is_empty();
    u32::try_from(text.lines().skip(line as usize).filter(says).count()).unwrap_or(u32::MAX)
}

/// A line without its comment.
fn bare(line: &str) -> &str {
    line.split([';', '#']).next().unwrap_or_default().trim()
}

/// What is wrong, and what helps.
type Told = (Message, Message);

fn command(text: &str) -> Result<Command, Told> {
    let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let (word, rest) = (word.to_ascii_lowercase(), rest.trim());
    let alone = |command: Command| if rest.is_empty() { Ok(command) } else { Err(too_much(&word, rest)) };
    match word.as_str() {
        "set" => set(rest),
        _ if text.contains('=') => field(text),
        "mask" if !rest.is_empty() => Ok(Command::Mask(rest.to_owned())),
        "move" => match rest.split_once(char::is_whitespace) {
            Some((to, axes)) if to.eq_ignore_ascii_case("machine") => Ok(Command::Move(motions(axes)?, Way::Machine)),
            _ => Ok(Command::Move(motions(rest)?, Way::To)),
        },
        "jog" => Ok(Command::Move(motions(rest)?, Way::By)),
        "start" if rest.eq_ignore_ascii_case("reset") => Ok(Command::Start(true)),
        "start" => alone(Command::Start(false)),
        "reset" => alone(Command::Reset),
        "store" => Ok(Command::Store(point(rest)?)),
        "reject" => Ok(Command::Reject(point(rest)?)),
        "plc" => plc(rest),
        "calculate" => alone(Command::Calculate),
        "activate" => alone(Command::Activate),
        "<<" => alone(Command::Back),
        "mode" => alone(Command::Mode),
        "tool" => tool(rest),
        _ => Err(unknown(text)),
    }
}

fn unknown(text: &str) -> Told {
    let known = Message::new("jog-script-command-hint").text("known", COMMANDS.join(", "));
    (Message::new("jog-script-command").text("text", text), known)
}

fn too_much(word: &str, rest: &str) -> Told {
    let hint = Message::new("jog-script-alone-hint").text("word", word);
    (Message::new("jog-script-alone").text("word", word).text("text", rest), hint)
}

/// `zo = G54`; a field that was emptied says by itself what is missing.
fn field(text: &str) -> Result<Command, Told> {
    let (name, value) = text.split_once('=').unwrap_or((text, ""));
    let (name, value) = (name.trim(), value.trim());
    if name.is_empty() || name.contains(char::is_whitespace) {
        return Err(unknown(text));
    }
    Ok(Command::Field(name.to_owned(), value.to_owned()))
}

/// `_JM_I[4] = 1`.
fn set(text: &str) -> Result<Command, Told> {
    let pair = text.split_once('=').map(|(name, value)| (name.trim(), value.trim()));
    let value = pair.and_then(|(name, value)| Some((name, number(value)?)));
    let (name, value) = value
        .filter(|(name, _)| !name.is_empty())
        .ok_or_else(|| (Message::new("jog-script-set").text("text", text), Message::new("jog-script-set-hint")))?;
    Ok(Command::Set(name.to_owned(), value))
}

fn number(text: &str) -> Option<f64> {
    text.replace(',', ".").parse().ok().filter(|number: &f64| number.is_finite() && number.abs() <= FARTHEST)
}

/// `X-20 Y10`: at least one axis.
fn motions(text: &str) -> Result<Vec<(usize, f64)>, Told> {
    let wrong = |text: &str| (Message::new("jog-script-move").text("text", text), Message::new("jog-script-move-hint"));
    let one = |word: &str| {
        let axis = AXES.iter().position(|axis| word.get(..1).is_some_and(|letter| letter.eq_ignore_ascii_case(axis)));
        axis.and_then(|axis| Some((axis, number(word.get(1..)?)?))).ok_or_else(|| wrong(word))
    };
    let moves: Vec<(usize, f64)> = text.split_whitespace().map(one).collect::<Result<_, _>>()?;
    if moves.is_empty() { Err(wrong(text)) } else { Ok(moves) }
}

/// `P2`.
fn point(text: &str) -> Result<usize, Told> {
    let digits = text.strip_prefix(['P', 'p']).unwrap_or_default();
    let number = digits.parse().ok().filter(|number| (1..=4).contains(number));
    number.ok_or_else(|| (Message::new("jog-script-point").text("text", text), Message::new("jog-script-point-hint")))
}

/// `P2 on`.
fn plc(text: &str) -> Result<Command, Told> {
    let (name, state) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let set = match state.trim().to_ascii_lowercase().as_str() {
        "on" => true,
        "off" => false,
        _ => return Err((Message::new("jog-script-plc").text("text", text), Message::new("jog-script-plc-hint"))),
    };
    Ok(Command::Plc(point(name)?, set))
}

/// `T9 D1`; without D the first edge.
fn tool(text: &str) -> Result<Command, Told> {
    let wrong = || (Message::new("jog-script-tool").text("text", text), Message::new("jog-script-tool-hint"));
    let (mut tool, mut edge) = (None, 1);
    for word in text.split_whitespace() {
        let number = word.get(1..).and_then(|digits| digits.parse::<u32>().ok()).map(i64::from).ok_or_else(wrong)?;
        match word.get(..1) {
            Some("T" | "t") => tool = Some(number),
            Some("D" | "d") => edge = number,
            _ => return Err(wrong()),
        }
    }
    Ok(Command::Tool(tool.ok_or_else(wrong)?, edge))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn one(text: &str) -> Command {
        read(text).unwrap().remove(0).command
    }

    // oracle: hand
    #[test]
    fn each_command_is_read() {
        for (text, command) in [
            ("mask set_edge ; the left face", Command::Mask("set_edge".into())),
            ("zo = G54", Command::Field("zo".into(), "G54".into())),
            ("MOVE z50 X-20,5", Command::Move(vec![(2, 50.0), (0, -20.5)], Way::To)),
            ("move machine Z300", Command::Move(vec![(2, 300.0)], Way::Machine)),
            ("MOVE Machine  z5 X1", Command::Move(vec![(2, 5.0), (0, 1.0)], Way::Machine)),
            ("jog X+0.5", Command::Move(vec![(0, 0.5)], Way::By)),
            ("start", Command::Start(false)),
            ("start reset", Command::Start(true)),
            ("reset", Command::Reset),
            ("reject P2", Command::Reject(2)),
            ("store P2", Command::Store(2)),
            ("plc P3 off", Command::Plc(3, false)),
            ("Calculate", Command::Calculate),
            ("activate", Command::Activate),
            ("x0 =", Command::Field("x0".into(), String::new())),
            ("activate = no", Command::Field("activate".into(), "no".into())),
            ("<<", Command::Back),
            ("mode", Command::Mode),
            ("tool T9", Command::Tool(9, 1)),
            ("tool T20 D2", Command::Tool(20, 2)),
            ("set _JM_I[4]=1", Command::Set("_JM_I[4]".into(), 1.0)),
        ] {
            assert_eq!(one(text), command, "{text}");
        }
    }

    // oracle: hand
    #[test]
    fn what_cannot_be_read_has_its_line() {
        let lines =
            ["go", "mask", "move", "move X", "move Q1", "jog", "reject P5", "plc P1", "tool", "tool 9", "set A"];
        for text in lines.into_iter().chain([
            "start now", "= 5", "a b = 5", "move X1e9", "set =1", "tool T-1", "xé", "move machineX5", "move machine",
            "reject 2", "store PP2",
        ]) {
            let wrong = read(&format!("; a comment\n\n{text}\n")).unwrap_err();
            assert_eq!(wrong.line, 3, "{text}");
        }
        assert_eq!(read("\n;\n# nothing\n"), Ok(Vec::new()));
        assert_eq!(behind("start\ngo\n; a comment\n\nstart\nwhat\n", 2), 2);
    }
}
