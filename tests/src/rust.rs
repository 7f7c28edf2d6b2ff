//! The sources of a crate as the compiler reads them without its tests: what they name by a path, and their texts.

use proc_macro2::{Delimiter, Ident, Literal, TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::io::{Error, Result};
use std::path::{Path, PathBuf};

/// What stands in the files of a crate, from its root along every `mod`, without what is there for tests only.
#[derive(Default)]
pub struct Sources {
    /// How many files were read.
    pub files: usize,
    /// Paths: `crate::…`, `super::…`, `self::…`, in `use` and elsewhere, in macros too.
    pub paths: Vec<Found>,
    /// Texts in quotes, as written; documentation is none.
    pub texts: Vec<Found>,
    /// Modules of the root.
    pub rooms: BTreeSet<String>,
    /// What the root declares beside modules.
    pub root_items: BTreeSet<String>,
}

/// A path or a text, and where it stands.
pub struct Found {
    /// File.
    pub file: PathBuf,
    /// Line, from 1.
    pub line: usize,
    /// Module, from the root.
    pub module: Vec<String>,
    /// The path from the root, segment by segment; a text in one piece.
    pub what: Vec<String>,
}

/// A file and a module in it.
#[derive(Clone, Default)]
struct Place {
    file: PathBuf,
    /// Where the files of its submodules are.
    folder: PathBuf,
    module: Vec<String>,
}

impl Sources {
    /// Reads a crate from its root file.
    ///
    /// # Errors
    /// A file that is not there or is no Rust.
    pub fn read(root: &Path) -> Result<Sources> {
        let folder = root.parent().map_or_else(PathBuf::new, Path::to_path_buf);
        let mut sources = Sources::default();
        sources.file(&Place { file: root.to_path_buf(), folder, module: Vec::new() })?;
        Ok(sources)
    }

    /// Reads a text as if it stood in a module.
    ///
    /// # Errors
    /// It is no Rust, or names a module in a file of its own.
    pub fn of(text: &str, module: &[&str]) -> Result<Sources> {
        let module = module.iter().map(|one| (*one).to_owned()).collect();
        let mut sources = Sources::default();
        sources.text(text, &Place { module, ..Place::default() })?;
        Ok(sources)
    }

    fn file(&mut self, place: &Place) -> Result<()> {
        self.files += 1;
        self.text(&std::fs::read_to_string(&place.file)?, place)
    }

    fn text(&mut self, text: &str, place: &Place) -> Result<()> {
        let tokens: TokenStream =
            text.parse().map_err(|error| Error::other(format!("{}: {error}", place.file.display())))?;
        self.stream(tokens, place)
    }

    fn stream(&mut self, stream: TokenStream, place: &Place) -> Result<()> {
        let tokens: Vec<TokenTree> = stream.into_iter().collect();
        let mut rest = &tokens[..];
        while let Some(next) = self.step(rest, place)? {
            rest = next;
        }
        Ok(())
    }

    /// What is left behind the next piece.
    fn step<'a>(&mut self, tokens: &'a [TokenTree], place: &Place) -> Result<Option<&'a [TokenTree]>> {
        let (Some(first), rest) = (tokens.first(), tokens.get(1..).unwrap_or_default()) else {
            return Ok(None);
        };
        match (first, rest) {
            (TokenTree::Punct(hash), [TokenTree::Group(group), rest @ ..]) if hash.as_char() == '#' => {
                return Ok(Some(behind_attribute(group.stream(), rest)));
            }
            (TokenTree::Punct(hash), [bang, TokenTree::Group(_), rest @ ..])
                if hash.as_char() == '#' && is(bang, '!') =>
            {
                return Ok(Some(rest)); // `#![…]`, and documentation of the module
            }
            (TokenTree::Ident(word), [TokenTree::Ident(name), body, rest @ ..]) if word == "mod" => {
                self.submodule(name, body, place)?;
                return Ok(Some(rest));
            }
            (TokenTree::Ident(word), [TokenTree::Ident(name), ..]) if place.module.is_empty() && declares(word) => {
                self.root_items.insert(name.to_string());
            }
            (TokenTree::Ident(word), _) if begins_path(word) && goes_on(rest) => {
                return Ok(Some(self.path(tokens, Vec::new(), place)));
            }
            (TokenTree::Group(group), _) => self.stream(group.stream(), place)?,
            (TokenTree::Literal(literal), _) => self.literal(literal, place),
            _ => {}
        }
        Ok(Some(rest))
    }

    /// `mod name;` in a file of its own, or `mod name { … }`.
    fn submodule(&mut self, name: &Ident, body: &TokenTree, place: &Place) -> Result<()> {
        let name = name.to_string();
        if place.module.is_empty() {
            self.rooms.insert(name.clone());
        }
        let module = [&place.module[..], std::slice::from_ref(&name)].concat();
        let mut inner = Place { file: place.file.clone(), folder: place.folder.join(name), module };
        if let TokenTree::Group(group) = body {
            return self.stream(group.stream(), &inner);
        }
        let beside = inner.folder.with_extension("rs");
        inner.file = if beside.is_file() { beside } else { inner.folder.join("mod.rs") };
        self.file(&inner)
    }

    /// Notes the path at the begin of these tokens, each one of a `{…}` at its end; what is left behind it.
    fn path<'a>(&mut self, tokens: &'a [TokenTree], before: Vec<String>, place: &Place) -> &'a [TokenTree] {
        let line = tokens.first().map_or(0, |token| token.span().start().line);
        let (mut path, mut rest) = (before, tokens);
        loop {
            match rest {
                [TokenTree::Ident(word), behind @ ..] => {
                    path.push(word.to_string());
                    rest = behind;
                }
                [TokenTree::Group(group), behind @ ..] if group.delimiter() == Delimiter::Brace => {
                    let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                    for one in inside.split(|token| is(token, ',')).filter(|one| !one.is_empty()) {
                        self.path(one, path.clone(), place);
                    }
                    return behind;
                }
                _ => break,
            }
            if !goes_on(rest) {
                break;
            }
            rest = &rest[2..];
        }
        self.paths.push(place.found(line, from_root(&path, &place.module)));
        rest
    }

    fn literal(&mut self, literal: &Literal, place: &Place) {
        let text = literal.to_string();
        if let Some(inside) = text.find('"').and_then(|begin| text.get(begin + 1..text.rfind('"')?)) {
            self.texts.push(place.found(literal.span().start().line, vec![inside.to_owned()]));
        }
    }
}

impl Place {
    fn found(&self, line: usize, what: Vec<String>) -> Found {
        Found { file: self.file.clone(), line, module: self.module.clone(), what }
    }
}

/// A path without `crate`, `self` and `super`.
fn from_root(path: &[String], module: &[String]) -> Vec<String> {
    let mut whole = module.to_vec();
    for segment in path {
        match segment.as_str() {
            "crate" => whole.clear(),
            "self" => {}
            "super" => drop(whole.pop()),
            _ => whole.push(segment.clone()),
        }
    }
    whole
}

fn is(token: &TokenTree, wanted: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == wanted)
}

/// Whether a path goes on: `::` and no `<` behind it.
fn goes_on(tokens: &[TokenTree]) -> bool {
    match tokens {
        [first, second, third, ..] => is(first, ':') && is(second, ':') && !is(third, '<'),
        _ => false,
    }
}

fn begins_path(word: &Ident) -> bool {
    ["crate", "self", "super"].iter().any(|begin| word == begin)
}

fn declares(word: &Ident) -> bool {
    ["const", "enum", "fn", "static", "struct", "trait", "type"].iter().any(|one| word == one)
}

/// Behind an attribute; behind its item where that is for tests.
fn behind_attribute(attribute: TokenStream, rest: &[TokenTree]) -> &[TokenTree] {
    let ends = |token: &TokenTree| match token {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        _ => is(token, ';'),
    };
    if !for_tests(&attribute.into_iter().collect::<Vec<_>>()) {
        return rest;
    }
    let end = rest.iter().position(ends).map_or(rest.len(), |at| at + 1);
    &rest[end..]
}

/// `test`, `cfg(test)`, `cfg(all(test, …))`.
fn for_tests(attribute: &[TokenTree]) -> bool {
    match attribute {
        [TokenTree::Ident(word)] => word == "test",
        [TokenTree::Ident(word), rest @ ..] => word == "cfg" && asks_for_tests(rest),
        _ => false,
    }
}

fn asks_for_tests(tokens: &[TokenTree]) -> bool {
    tokens.iter().enumerate().any(|(at, token)| match token {
        TokenTree::Ident(word) => word == "test",
        TokenTree::Group(group) => {
            let negated = at > 0 && matches!(&tokens[at - 1], TokenTree::Ident(word) if word == "not");
            !negated && asks_for_tests(&group.stream().into_iter().collect::<Vec<_>>())
        }
        _ => false,
    })
}
