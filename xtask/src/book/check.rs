//! Every link of the handbook leads somewhere: to a file that there is, and to a place on it.

use super::Files;
use anyhow::{Result, bail};
use std::collections::{BTreeMap, BTreeSet};

/// Fails with the links that lead nowhere; gives the files to which one leads.
pub fn links(files: &Files) -> Result<BTreeSet<String>> {
    let pages: BTreeMap<&str, &str> = files
        .iter()
        .filter(|(name, _)| name.ends_with(".html"))
        .filter_map(|(name, bytes)| Some((name.as_str(), std::str::from_utf8(bytes).ok()?)))
        .collect();
    let places: BTreeMap<&str, BTreeSet<&str>> =
        pages.iter().map(|(name, html)| (*name, values(html, " id=\"").collect())).collect();
    let mut lost = Vec::new();
    let mut linked = BTreeSet::new();
    for (page, html) in &pages {
        for link in values(html, " href=\"").chain(values(html, " src=\"")).filter(|link| !link.contains("://")) {
            let (path, place) = link.split_once('#').unwrap_or((link, ""));
            let target = if path.is_empty() { (*page).to_owned() } else { reached(page, path) };
            let there = files.contains_key(&target);
            let known = places.get(target.as_str()).is_none_or(|places| place.is_empty() || places.contains(place));
            if !there || !known {
                lost.push(format!("{page}: {link}"));
            }
            linked.insert(target);
        }
    }
    if !lost.is_empty() {
        bail!("links of the handbook that lead nowhere:\n{}", lost.join("\n"));
    }
    Ok(linked)
}

/// The values of an attribute.
fn values<'a>(html: &'a str, begin: &'a str) -> impl Iterator<Item = &'a str> {
    html.split(begin).skip(1).filter_map(|rest| rest.split('"').next())
}

/// The file to which a relative address leads from a page.
fn reached(page: &str, path: &str) -> String {
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in path.split('/') {
        match part {
            ".." => {
                parts.pop();
            }
            name => parts.push(name),
        }
    }
    parts.join("/")
}
