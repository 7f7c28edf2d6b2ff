//! `probewright machine`: what a control exported, held against what measuring needs.

use crate::check::severity;
use crate::file;
use crate::file::Problem;
use clap::ValueEnum;
use probewright_core::app::{ExportedFile, MachineCheckRequest, MachineCheckView, MachineFault, machine_check};
use probewright_core::control::needs::Use;
use probewright_core::diagnostic::Severity;
use probewright_core::json;
use probewright_core::message::Message;
use probewright_core::words::Words;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// What is checked.
#[derive(clap::Args)]
pub struct Arguments {
    #[arg(required = true)]
    files: Vec<PathBuf>,
    #[arg(long, value_name = "USES", value_delimiter = ',')]
    without: Vec<Unused>,
    #[arg(long)]
    ncu3: bool,
    #[arg(long, value_name = "MM")]
    deflection: Option<f64>,
    #[arg(long, value_name = "FILE")]
    changes: Option<PathBuf>,
    #[arg(long)]
    json: bool,
}

/// What a machine may do without.
#[derive(Clone, Copy, ValueEnum)]
enum Unused {
    Jog,
    Log,
    ToolProbe,
}

/// Checks a machine by its files together; 1 when there is an error.
pub fn machine(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let without = asked.without.iter().map(|unused| match unused {
        Unused::Jog => Use::Jog,
        Unused::Log => Use::Log,
        Unused::ToolProbe => Use::ToolProbe,
    });
    let without = without.collect();
    let mut files = Vec::new();
    for path in &asked.files {
        files.push(ExportedFile { name: path.display().to_string(), text: file::exported(path)? });
    }
    let view = machine_check(MachineCheckRequest { files, without, large: asked.ncu3, deflection: asked.deflection });
    let view = view.map_err(|refused| file::wrong_files(&asked.files, refused.message))?;
    if let Some(path) = &asked.changes {
        file::write(path, [view.changes.clone()].into_iter())?;
    }
    if asked.json {
        file::print_json(json::document(&view), words, out)?;
    } else {
        print(&view, words, out)?;
    }
    let error = view.faults.iter().any(|fault| fault.severity == Severity::Error);
    Ok(if error { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

fn print(view: &MachineCheckView, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    for fault in &view.faults {
        writeln!(out, "{}", line(fault, words))?;
        let limits = fault.limits.iter().map(|limit| {
            let message = Message::new("terminal-machine-limit").text("value", &limit.value);
            words.text(&message.text("severity", severity(limit.severity)).source(limit.source))
        });
        let source = Message::new("terminal-machine-source").source(fault.source);
        let default = Message::new("terminal-machine-default").text("value", fault.delivered.join(" / "));
        let change = Message::new("terminal-machine-change").text("line", &fault.change);
        let told = [
            (fault.limits.is_empty(), source),
            (!fault.delivered.is_empty(), default),
            (!fault.change.is_empty(), change),
        ];
        let told = told.iter().filter(|(is, _)| *is).map(|(_, message)| words.text(message));
        for text in limits.chain(told) {
            writeln!(out, "    {text}")?;
        }
    }
    if !view.missing.is_empty() {
        let missing = Message::new("terminal-machine-missing").number("count", view.missing.len() as f64);
        writeln!(out, "{} {}", words.text(&missing), view.missing.join(", "))?;
    }
    writeln!(out, "{}", words.text(&view.ending))
}

/// `INITIAL.INI:4: error[61016]: MD28082 MM_SYSTEM_FRAME_MASK (channel 2): …`
pub fn line(fault: &MachineFault, words: &Words) -> String {
    let place = fault.place.as_ref().map_or(String::new(), |place| format!("{}:{}: ", place.file, place.line));
    let alarm = fault.alarm.as_ref().and_then(|alarm| alarm.key.strip_prefix("alarm-"));
    let alarm = alarm.map_or(String::new(), |number| format!("[{number}]"));
    let channel = fault.channel.map_or(String::new(), |channel| {
        format!(" ({})", words.text(&Message::new("terminal-machine-channel").number("channel", f64::from(channel))))
    });
    let name = format!("{} {}", fault.name, fault.identifier);
    let texts = [Some(&fault.message), fault.effect.as_ref(), fault.alarm.as_ref()];
    let texts: Vec<String> = texts.into_iter().flatten().map(|message| words.text(message)).collect();
    format!("{place}{}{alarm}: {}{channel}: {}", severity(fault.severity), name.trim_end(), texts.join(" "))
}
