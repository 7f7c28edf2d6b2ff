//! A small static file server for `dist/`, on this machine only.

use crate::steps::Steps;
use crate::wasm::Make;
use crate::{dist, tools};
use anyhow::{Context, Result, bail};
use std::io::{BufRead, BufReader, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{fs, thread};

/// Options of `cargo xtask serve`.
#[derive(clap::Args)]
pub struct Options {
    /// Port on 127.0.0.1; the next free one is taken when it is in use
    #[arg(long, default_value_t = 4173)]
    port: u16,
    /// Serve what `dist/` holds, without building it
    #[arg(long)]
    no_build: bool,
}

/// `cargo xtask serve`.
pub fn serve(options: &Options) -> Result<()> {
    if !options.no_build {
        dist::build(&mut Steps::of(dist::STEPS), Make::Quick)?;
    }
    let folder = tools::root().join("dist");
    if !folder.join("index.html").is_file() {
        bail!("dist/ is empty: run `cargo xtask serve` without --no-build");
    }
    let listener = TcpListener::bind(("127.0.0.1", options.port)).or_else(|_| TcpListener::bind(("127.0.0.1", 0)))?;
    println!("http://{}/  (end with Ctrl+C)", listener.local_addr()?);
    accept(&listener, &folder);
    Ok(())
}

/// Serves `dist/` on a free port until the program ends.
pub fn in_background() -> Result<SocketAddr> {
    let listener = TcpListener::bind(("127.0.0.1", 0)).context("127.0.0.1")?;
    let address = listener.local_addr()?;
    let folder = tools::root().join("dist");
    thread::spawn(move || accept(&listener, &folder));
    Ok(address)
}

fn accept(listener: &TcpListener, folder: &Path) {
    for stream in listener.incoming().flatten() {
        let folder = folder.to_path_buf();
        // A browser that goes away in the middle of an answer is no error of the server.
        thread::spawn(move || answer(&stream, &folder).ok());
    }
}

/// Answers one request and closes the connection.
fn answer(stream: &TcpStream, folder: &Path) -> Result<()> {
    stream.set_read_timeout(Some(Duration::from_secs(10)))?;
    let mut lines = BufReader::new(stream).lines();
    let request = lines.next().context("no request")??;
    for line in lines {
        if line?.is_empty() {
            break;
        }
    }
    let mut words = request.split(' ');
    let (method, address) = (words.next().unwrap_or(""), words.next().unwrap_or("/"));
    if method != "GET" && method != "HEAD" {
        return reply(stream, "405 Method Not Allowed", "text/plain", b"", true);
    }
    let found = file(folder, address).and_then(|path| Some((fs::read(&path).ok()?, kind(&path))));
    match found {
        Some((body, kind)) => reply(stream, "200 OK", kind, &body, method == "GET"),
        None => reply(stream, "404 Not Found", "text/plain", b"not found\n", method == "GET"),
    }
}

fn reply(mut stream: &TcpStream, status: &str, kind: &str, body: &[u8], whole: bool) -> Result<()> {
    let length = body.len();
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\n\
         Cache-Control: no-cache\r\nX-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n"
    )?;
    if whole {
        stream.write_all(body)?;
    }
    Ok(stream.flush()?)
}

/// The file that an address names; nothing outside the folder can be named.
fn file(folder: &Path, address: &str) -> Option<PathBuf> {
    let path = address.split(['?', '#']).next()?.strip_prefix('/')?;
    let outside = |part: &str| part == ".." || part.contains(['\\', ':', '%', '\0']);
    if path.starts_with('/') || path.split('/').any(outside) {
        return None;
    }
    let named = folder.join(path);
    Some(if path.is_empty() || path.ends_with('/') { named.join("index.html") } else { named })
}

/// Content type by the file's extension.
fn kind(path: &Path) -> &'static str {
    match path.extension().and_then(|e| e.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("js" | "mjs") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("json" | "map") => "application/json",
        Some("webmanifest") => "application/manifest+json",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("ico") => "image/x-icon",
        Some("woff2") => "font/woff2",
        Some("ftl" | "txt" | "mpf" | "spf") => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand
    #[test]
    fn only_files_inside_the_folder_can_be_named() {
        let folder = Path::new("dist");
        assert_eq!(file(folder, "/"), Some(PathBuf::from("dist/index.html")));
        assert_eq!(file(folder, "/a/b.js?v=1"), Some(PathBuf::from("dist/a/b.js")));
        assert_eq!(file(folder, "/../Cargo.toml"), None);
        assert_eq!(file(folder, "/a/../../Cargo.toml"), None);
        assert_eq!(file(folder, "/%2e%2e/Cargo.toml"), None);
        assert_eq!(file(folder, "//etc/passwd"), None);
        assert_eq!(file(folder, "http://elsewhere/"), None);
    }
}
