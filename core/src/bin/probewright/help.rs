//! Help pages and wrong arguments in each language: clap lays them out, what they say are messages.

use crate::{Arguments, file, words};
use clap::error::{ContextKind, ErrorKind};
use clap::{Arg, Command, CommandFactory, FromArgMatches};
use probewright_core::message::Message;
use probewright_core::words::Words;
use std::process::ExitCode;

/// What the command line says.
pub fn arguments() -> Result<Arguments, clap::Error> {
    negative(Arguments::command()).try_get_matches().and_then(|matches| Arguments::from_arg_matches(&matches))
}

/// With `-1` as a value of any argument that has one, not as an option: what it says of the number is told.
fn negative(command: Command) -> Command {
    let takes = |arg: Arg| match arg.get_action().takes_values() {
        true => arg.allow_negative_numbers(true),
        false => arg,
    };
    command.mut_args(takes).mut_subcommands(negative)
}

/// Shows the help that the arguments ask for, or what is wrong with them: status 2.
pub fn answer() -> ExitCode {
    let words = words(language().as_deref()).unwrap_or_else(|_| Words::english());
    let Err(error) = command(&words).try_get_matches() else { return ExitCode::FAILURE };
    match wrong(&error, &words) {
        Some(text) => file::complain(&text),
        None => drop(error.print()),
    }
    if error.use_stderr() { ExitCode::from(2) } else { ExitCode::SUCCESS }
}

/// The language that the arguments ask for, whatever else is wrong with them.
fn language() -> Option<String> {
    let all: Vec<String> = std::env::args_os().map(|one| one.to_string_lossy().into_owned()).collect();
    let apart = all.iter().position(|one| one == "--lang").and_then(|at| all.get(at + 1));
    apart.map(String::as_str).or_else(|| all.iter().find_map(|one| one.strip_prefix("--lang="))).map(str::to_owned)
}

/// The command line with its help in a language.
fn command(words: &Words) -> Command {
    let mut command = negative(Arguments::command());
    command.build(); // with the flags and the command for help, which clap adds
    page(command, words)
}

fn page(command: Command, words: &Words) -> Command {
    let name = command.get_name().to_owned();
    let mut command = command
        .about(words.key(format!("terminal-{name}-about")))
        .subcommand_help_heading(words.key("terminal-commands"))
        .subcommand_value_name(words.key("terminal-value-command"))
        .mut_args(|arg| described(arg, &name, words))
        .mut_subcommands(|one| page(one, words));
    let usage = command.render_usage().to_string();
    let usage = usage.trim_start_matches("Usage: ").replace("[OPTIONS]", &words.key("terminal-any-options"));
    let template = format!("{{about}}\n\n{}: {{usage}}\n\n{{all-args}}", words.key("terminal-usage"));
    command.override_usage(usage).help_template(template)
}

/// An argument with its help: that for this command, else that for all.
fn described(arg: Arg, command: &str, words: &Words) -> Arg {
    let id = arg.get_id().as_str().replace('_', "-");
    let own = words.find(&Message::new(format!("terminal-{command}-{id}-text")));
    let help = own.unwrap_or_else(|| words.key(format!("terminal-{id}-text")));
    let heading = if arg.is_positional() { "terminal-arguments" } else { "terminal-options" };
    let value = arg.get_value_names().and_then(<[_]>::first).map(|name| name.to_lowercase());
    let arg = arg.help(help).help_heading(words.key(heading));
    match value {
        Some(name) if arg.get_action().takes_values() => arg.value_name(words.key(format!("terminal-value-{name}"))),
        _ => arg,
    }
}

/// What is wrong with the arguments; none: clap itself shows help, or something that no message tells.
fn wrong(error: &clap::Error, words: &Words) -> Option<String> {
    let part = |kinds: &[ContextKind]| kinds.iter().find_map(|kind| error.get(*kind)).map(ToString::to_string);
    let value = part(&[ContextKind::InvalidValue]).filter(|value| !value.is_empty());
    let key = match error.kind() {
        ErrorKind::UnknownArgument => "terminal-wrong-argument",
        ErrorKind::InvalidSubcommand => "terminal-wrong-command",
        ErrorKind::MissingSubcommand => "terminal-wrong-none",
        ErrorKind::InvalidValue if value.is_none() => "terminal-wrong-empty",
        ErrorKind::InvalidValue => "terminal-wrong-value",
        ErrorKind::ValueValidation => "terminal-wrong-number",
        ErrorKind::MissingRequiredArgument => "terminal-wrong-missing",
        ErrorKind::ArgumentConflict if part(&[ContextKind::InvalidArg]) == part(&[ContextKind::PriorArg]) => {
            "terminal-wrong-twice"
        }
        ErrorKind::ArgumentConflict => "terminal-wrong-conflict",
        _ => return None,
    };
    let message = Message::new(key)
        .text("name", part(&[ContextKind::InvalidArg, ContextKind::InvalidSubcommand]).unwrap_or_default())
        .text("value", value.unwrap_or_default())
        .text("known", part(&[ContextKind::ValidValue]).unwrap_or_default())
        .text("other", part(&[ContextKind::PriorArg]).unwrap_or_default());
    let similar = [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg, ContextKind::SuggestedValue];
    let similar = part(&similar).map(|known| words.text(&Message::new("terminal-wrong-similar").text("known", known)));
    let usage = part(&[ContextKind::Usage]);
    let usage = usage.map(|text| text.replacen("Usage", &words.key("terminal-usage"), 1));
    let first = format!("{}: {}", words.key("terminal-error"), words.text(&message));
    let lines = [Some(first), similar, usage, Some(words.key("terminal-wrong-more"))];
    Some(lines.into_iter().flatten().collect::<Vec<_>>().join("\n"))
}
