//! `cargo xtask serve | test | dist | book | bench | fuzz | corpus`: gets what is missing, builds, serves, tests.

mod bench;
mod book;
mod browser;
mod corpus;
mod counts;
mod dist;
mod editor;
mod fuzz;
mod package;
mod page;
mod peers;
mod serve;
mod steps;
mod test;
mod tools;
mod wasm;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

#[derive(Parser)]
#[command(name = "cargo xtask", about = "Builds, serves and tests Probewright")]
struct Cli {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Build the page and serve it on 127.0.0.1
    Serve(serve::Options),
    /// Run every check and test; the last line counts them
    Test(test::Options),
    /// Build the folder dist/ that any static file server can serve
    Dist,
    /// Build only the handbook that belongs to dist/
    Book(book::Options),
    /// Measure speed and size, native and in the browser
    Bench(bench::Options),
    /// Look for a program that breaks the reader or the interpreter
    Fuzz(fuzz::Options),
    /// Read, check and run the programs of a folder, and print what came of them
    Corpus(corpus::Options),
    /// Run one wasm test program in headless Chromium (cargo calls this)
    #[command(hide = true)]
    TestRunner {
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
    /// Second half of `test-runner`, with its surroundings set
    #[command(hide = true)]
    RunWasmTests {
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
}

fn main() -> ExitCode {
    let outcome = match Cli::parse().task {
        Task::Serve(options) => serve::serve(&options).map(|()| true),
        Task::Test(options) => test::test(&options),
        Task::Dist => dist::dist().map(|()| true),
        Task::Book(options) => book::book(&options).map(|()| true),
        Task::Bench(options) => bench::bench(&options).map(|()| true),
        Task::Fuzz(options) => fuzz::fuzz(&options).map(|()| true),
        Task::Corpus(options) => corpus::corpus(&options).map(|()| true),
        Task::TestRunner { arguments } => browser::run_wasm_tests(&arguments),
        Task::RunWasmTests { arguments } => browser::wasm_tests(arguments).map(|()| true),
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
