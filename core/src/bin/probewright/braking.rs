//! `probewright braking`: the braking path of a feed, and the largest feed of a deflection.

use crate::file;
use crate::file::Problem;
use probewright_core::app::{self, BrakingRequest};
use probewright_core::json;
use probewright_core::message::Message;
use probewright_core::words::Words;
use std::io::Write;
use std::process::ExitCode;

/// The axis, and what is asked of it.
#[derive(clap::Args)]
pub struct Arguments {
    #[arg(long, value_name = "SECONDS")]
    delay: f64,
    #[arg(long, value_name = "DECELERATION")]
    acceleration: f64,
    #[arg(long, value_name = "GAIN")]
    gain: f64,
    #[arg(long, value_name = "FEED")]
    feed: Option<f64>,
    #[arg(long, value_name = "MM")]
    deflection: Option<f64>,
    #[arg(long)]
    json: bool,
}

/// A path is told in parts of a mm.
const PATH: f64 = 1e4;
/// A feed is told in parts of a mm/min, rounded down.
const FEED: f64 = 1e1;

/// Tells path and feed, whichever was asked for.
pub fn braking(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let Arguments { delay, acceleration, gain, feed, deflection, json } = *asked;
    if feed.is_none() && deflection.is_none() {
        return Err(file::wrong(Message::new("terminal-braking-nothing")));
    }
    let view = app::braking(BrakingRequest { delay, acceleration, gain, feed, deflection });
    let view = view.map_err(|refused| file::wrong(refused.message))?;
    if json {
        file::print_json(json::document(&view), words, out)?;
        return Ok(ExitCode::SUCCESS);
    }
    if let Some(path) = view.path {
        let round = |value: f64| (value * PATH).round() / PATH;
        let message = Message::new("braking-path").number("sum", round(path.sum)).number("delay", round(path.delay));
        let message = message.number("braking", round(path.braking)).number("following", round(path.following));
        writeln!(out, "{}", words.text(&message))?;
    }
    if let Some(feed) = view.feed {
        let message = Message::new("braking-feed").number("feed", (feed * FEED).floor() / FEED);
        writeln!(out, "{}", words.text(&message))?;
    }
    Ok(ExitCode::SUCCESS)
}
