//! The extension for Visual Studio Code: a `.vsix` is a zip with a manifest; it holds the page for its forms.

use crate::tools::{npm, root, run};
use anyhow::{Context, Result};
use serde_json::Value;
use std::fs::{self, File};
use std::io::{Seek, Write};
use std::path::{Path, PathBuf};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// Kinds of files in it, by their endings.
const KINDS: &[(&str, &str)] = &[
    ("cjs", "application/javascript"),
    ("css", "text/css"),
    ("html", "text/html"),
    ("js", "application/javascript"),
    ("json", "application/json"),
    ("md", "text/markdown"),
    ("mjs", "application/javascript"),
    ("png", "image/png"),
    ("svg", "image/svg+xml"),
    ("ts", "text/plain"),
    ("txt", "text/plain"),
    ("vsixmanifest", "text/xml"),
    ("wasm", "application/wasm"),
    ("webmanifest", "application/manifest+json"),
    ("woff2", "font/woff2"),
];
/// In the folder of the extension, and not in the package.
const LEFT_OUT: &[&str] = &["package-lock.json", ".package-lock.json", ".bin"];
/// Of the page: the extension serves it anew with each start, so nothing is to keep it; a form has no way to the
/// handbook.
const OF_THE_PAGE: &[&str] = &["sw.js", "book"];

/// Packs `pkg/probewright-VERSION.vsix`, out of `editors/vscode/` and `dist/`.
pub fn pack() -> Result<()> {
    let root = root();
    let folder = root.join("editors/vscode");
    packages()?;
    let about: Value = serde_json::from_slice(&fs::read(folder.join("package.json"))?)?;
    let words: Value = serde_json::from_slice(&fs::read(folder.join("package.nls.json"))?)?;
    let version = about["version"].as_str().context("a version")?;
    let path = root.join(format!("pkg/probewright-{version}.vsix"));
    let mut package = ZipWriter::new(File::create(&path).with_context(|| path.display().to_string())?);
    put(&mut package, "extension.vsixmanifest", manifest(&about, &words).as_bytes())?;
    put(&mut package, "[Content_Types].xml", kinds().as_bytes())?;
    add(&mut package, &folder, "extension", LEFT_OUT)?;
    add(&mut package, &root.join("dist"), "extension/page", OF_THE_PAGE)?;
    put(&mut package, "extension/icon.png", &fs::read(root.join("dist/icon-192.png"))?)?;
    for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
        put(&mut package, &format!("extension/{licence}.txt"), &fs::read(root.join(licence))?)?;
    }
    package.finish()?;
    Ok(())
}

/// Gets the npm packages of the extension.
pub fn packages() -> Result<()> {
    run(npm().args(["ci", "--omit=dev", "--no-audit", "--no-fund"]).current_dir(root().join("editors/vscode")))
}

/// Every file below a folder, in order.
fn add(package: &mut ZipWriter<impl Write + Seek>, folder: &Path, name: &str, left_out: &[&str]) -> Result<()> {
    let entries = fs::read_dir(folder).with_context(|| folder.display().to_string())?;
    let mut paths = entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<PathBuf>>>()?;
    paths.sort();
    for path in paths {
        let file = path.file_name().and_then(|name| name.to_str()).context("a name")?;
        let within = format!("{name}/{file}");
        match () {
            () if left_out.contains(&file) => {}
            () if path.is_dir() => add(package, &path, &within, left_out)?,
            () => put(package, &within, &fs::read(&path)?)?,
        }
    }
    Ok(())
}

fn put(package: &mut ZipWriter<impl Write + Seek>, name: &str, bytes: &[u8]) -> Result<()> {
    package.start_file(name, SimpleFileOptions::default()).with_context(|| name.to_owned())?;
    Ok(package.write_all(bytes)?)
}

/// What the editor reads before it unpacks the rest.
fn manifest(about: &Value, words: &Value) -> String {
    let text = |name: &str| escaped(about[name].as_str().unwrap_or_default());
    let categories: Vec<&str> =
        about["categories"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let asset = |kind: &str, path: &str| {
        format!(r#"<Asset Type="Microsoft.VisualStudio.{kind}" Path="extension/{path}" Addressable="true"/>"#)
    };
    [
        r#"<?xml version="1.0" encoding="utf-8"?>"#.to_owned(),
        r#"<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011">"#
            .to_owned(),
        "<Metadata>".to_owned(),
        format!(
            r#"<Identity Language="en-US" Id="{}" Version="{}" Publisher="{}"/>"#,
            text("name"),
            text("version"),
            text("publisher")
        ),
        format!("<DisplayName>{}</DisplayName>", text("displayName")),
        format!("<Description>{}</Description>", escaped(words["description"].as_str().unwrap_or_default())),
        format!("<Categories>{}</Categories>", escaped(&categories.join(","))),
        format!(
            r#"<Properties><Property Id="Microsoft.VisualStudio.Code.Engine" Value="{}"/></Properties>"#,
            escaped(about["engines"]["vscode"].as_str().unwrap_or_default())
        ),
        "<Icon>extension/icon.png</Icon></Metadata>".to_owned(),
        r#"<Installation><InstallationTarget Id="Microsoft.VisualStudio.Code"/></Installation>"#.to_owned(),
        "<Dependencies/><Assets>".to_owned(),
        asset("Code.Manifest", "package.json"),
        asset("Services.Content.Details", "README.md"),
        asset("Services.Icons.Default", "icon.png"),
        "</Assets></PackageManifest>\n".to_owned(),
    ]
    .join("\n")
}

fn kinds() -> String {
    let kind = |(ending, kind): &(&str, &str)| format!(r#"<Default Extension=".{ending}" ContentType="{kind}"/>"#);
    let all: Vec<String> = KINDS.iter().map(kind).collect();
    format!(
        "{}\n<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">{}</Types>\n",
        r#"<?xml version="1.0" encoding="utf-8"?>"#,
        all.concat()
    )
}

/// Text in XML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
