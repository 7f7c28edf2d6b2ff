//! The one form of all pages: first line, contents, text, the pages before and after.

use super::markdown::Made;
use super::outline::{ENTRY, Section};
use super::sources::{Language, Source, Sources};
use super::{escaped, relative};
use anyhow::{Context, Result};
use std::fmt::Write;

/// What a page may do: scripts, styles, pictures and type of its own folder, and nothing else.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; font-src 'self'; \
                      base-uri 'none'; form-action 'none'";
/// The deepest headings in the contents.
const DEPTH: usize = 3;

/// A page of the handbook.
pub fn page(sources: &Sources, language: &Language, source: &Source, made: &Made) -> Result<String> {
    let view = View { sources, language, file: source.file(language), page: Some(source) };
    let title = format!("{} · {}", source.title, language.words.text("book-title")?);
    let main = format!("<article>\n{}</article>\n{}", made.body, view.around()?);
    view.whole(&title, &made.sections, &main)
}

/// The first page of a language: every page with what its first sentences say.
pub fn start(sources: &Sources, language: &Language, pages: &[(&Source, Made)]) -> Result<String> {
    let view = View { sources, language, file: format!("{}/index.html", language.code), page: None };
    let title = language.words.text("book-title")?;
    let mut main = format!("<h1>{}</h1>\n<p class=\"lead\">{}</p>\n", escaped(&title), view.text("book-about")?);
    for group in &language.groups {
        let _ = write!(main, "<section><h2>{}</h2>\n<ul class=\"cards\">\n", escaped(&group.title));
        for source in &group.pages {
            let made = pages.iter().find(|(one, _)| one.name == source.name).map(|(_, made)| made);
            let about = made.and_then(|made| made.sections.first()?.texts.first()).map_or("", String::as_str);
            let link = relative(&view.file, &source.file(language));
            let title = titled(&source.title);
            let _ = writeln!(main, "<li><a href=\"{link}\">{title}</a><p>{}</p></li>", escaped(about));
        }
        main.push_str("</ul></section>\n");
    }
    view.whole(&title, &[], &main)
}

/// The first page of all: which languages there are.
pub fn languages(sources: &Sources) -> Result<String> {
    let first = sources.languages.first().context("no language")?;
    let mut list = String::new();
    for language in &sources.languages {
        let code = &language.code;
        let title = escaped(&language.words.text("book-title")?);
        let name = escaped(&language.words.text("book-spoken")?);
        let link = format!("<a href=\"{code}/index.html\" lang=\"{code}\" hreflang=\"{code}\">");
        let _ = writeln!(list, "<li>{link}<strong>{name}</strong> {title}</a></li>");
    }
    let title = first.words.text("book-title")?;
    let head = head(&title, "");
    Ok(format!(
        "<!doctype html>\n<html lang=\"{}\">\n{head}<body class=\"choice\">\n<main>\n<h1>{}</h1>\n\
         <ul class=\"cards\">\n{list}</ul>\n</main>\n</body>\n</html>\n",
        first.code,
        escaped(&title)
    ))
}

/// What stands before the page; `up`: the way to the folder of the handbook.
fn head(title: &str, up: &str) -> String {
    format!(
        "<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <link rel=\"icon\" href=\"{up}icon.svg\" type=\"image/svg+xml\">\n\
         <link rel=\"stylesheet\" href=\"{up}book.css\">\n\
         <script src=\"{up}book.js\" defer></script>\n\
         <title>{}</title>\n</head>\n",
        escaped(title)
    )
}

/// The name of a cycle in the type of names, what it is for behind it.
fn titled(title: &str) -> String {
    match title.split_once(": ") {
        Some((name, rest)) if !name.contains(|c: char| c.is_lowercase()) => {
            format!("<code>{}</code> {}", escaped(name), escaped(rest))
        }
        _ => escaped(title),
    }
}

/// A page in its surroundings.
struct View<'a> {
    sources: &'a Sources,
    language: &'a Language,
    file: String,
    /// None: the first page.
    page: Option<&'a Source>,
}

impl View<'_> {
    fn text(&self, key: &str) -> Result<String> {
        Ok(escaped(&self.language.words.text(key)?))
    }

    fn whole(&self, title: &str, sections: &[Section], main: &str) -> Result<String> {
        let up = "../".repeat(self.file.matches('/').count());
        Ok(format!(
            "<!doctype html>\n<html lang=\"{code}\">\n{head}<body>\n\
             <a class=\"skip\" href=\"#content\">{skip}</a>\n{bar}{found}\
             <div class=\"frame\">\n{contents}<main id=\"content\" tabindex=\"-1\">\n{main}</main>\n</div>\n\
             </body>\n</html>\n",
            code = self.language.code,
            head = head(title, &up),
            skip = self.text("book-skip")?,
            bar = self.bar()?,
            found = self.found(&up)?,
            contents = self.contents(sections)?,
        ))
    }

    /// The first line: contents of a narrow screen, name, search, languages.
    fn bar(&self) -> Result<String> {
        let home = relative(&self.file, &format!("{}/index.html", self.language.code));
        Ok(format!(
            "<header>\n<button type=\"button\" class=\"contents-open\" popovertarget=\"contents\">{contents}</button>\n\
             <a class=\"brand\" href=\"{home}\"><span class=\"brand-mark\" aria-hidden=\"true\"></span>{title}</a>\n\
             <div class=\"search\" role=\"search\" hidden><input id=\"query\" type=\"search\" autocomplete=\"off\" \
             spellcheck=\"false\" aria-label=\"{search}\" placeholder=\"{search}\" aria-controls=\"found\" \
             aria-keyshortcuts=\"/\"><kbd aria-hidden=\"true\">/</kbd></div>\n{languages}</header>\n",
            contents = self.text("book-contents")?,
            title = self.text("book-title")?,
            search = self.text("book-search")?,
            languages = self.languages()?,
        ))
    }

    /// The same page in each language; where that has none, the first page.
    fn languages(&self) -> Result<String> {
        let mut list = String::new();
        for other in &self.sources.languages {
            let same = self.page.and_then(|page| other.page(&page.name)).map(|page| page.file(other));
            let link = relative(&self.file, &same.unwrap_or_else(|| format!("{}/index.html", other.code)));
            let current = if other.code == self.language.code { " aria-current=\"true\"" } else { "" };
            let name = escaped(&other.words.text("book-spoken")?);
            let code = &other.code;
            let _ = write!(list, "<a href=\"{link}\" lang=\"{code}\" hreflang=\"{code}\"{current}>{name}</a>");
        }
        Ok(format!("<nav class=\"languages\" aria-label=\"{}\">{list}</nav>\n", self.text("language")?))
    }

    /// What the search fills; `up`: the way to the folder of the handbook.
    fn found(&self, up: &str) -> Result<String> {
        let code = &self.language.code;
        Ok(format!(
            "<section id=\"found\" aria-label=\"{title}\" data-index=\"{up}search-{code}.js\" \
             data-pages=\"{up}{code}/\" data-count=\"{count}\" data-none=\"{none}\" data-absent=\"{absent}\" hidden>\
             <p role=\"status\"></p><ol></ol></section>\n",
            title = self.text("book-results")?,
            count = self.text("book-found")?,
            none = self.text("book-none")?,
            absent = self.text("book-absent")?,
        ))
    }

    /// All pages by group, and the headings of the one that is shown.
    fn contents(&self, sections: &[Section]) -> Result<String> {
        let title = self.text("book-contents")?;
        let mut html = format!("<nav id=\"contents\" popover aria-label=\"{title}\">\n");
        for group in &self.language.groups {
            let _ = write!(html, "<h2>{}</h2>\n<ul>\n", escaped(&group.title));
            for page in &group.pages {
                let link = relative(&self.file, &page.file(self.language));
                let here = self.page.is_some_and(|one| one.name == page.name);
                let current = if here { " aria-current=\"page\"" } else { "" };
                let _ = write!(html, "<li><a href=\"{link}\"{current}>{}</a>", titled(&page.title));
                if here {
                    html.push_str(&headings(sections));
                }
                html.push_str("</li>\n");
            }
            html.push_str("</ul>\n");
        }
        Ok(html + "</nav>\n")
    }

    /// The pages before and after.
    fn around(&self) -> Result<String> {
        let all: Vec<&Source> = self.language.pages().collect();
        let at = all.iter().position(|one| self.page.is_some_and(|page| page.name == one.name)).unwrap_or(0);
        let link = |page: Option<&&Source>, sort: &str, words: String| {
            page.map_or_else(String::new, |page| {
                let link = relative(&self.file, &page.file(self.language));
                let title = titled(&page.title);
                format!("<a rel=\"{sort}\" class=\"{sort}\" href=\"{link}\"><small>{words}</small> {title}</a>")
            })
        };
        let before = link(at.checked_sub(1).and_then(|at| all.get(at)), "prev", self.text("book-previous")?);
        let after = link(all.get(at + 1), "next", self.text("book-next")?);
        Ok(format!("<nav class=\"around\" aria-label=\"{}\">{before}{after}</nav>\n", self.text("book-turn")?))
    }
}

/// Headings below the title as lists within lists.
fn headings(sections: &[Section]) -> String {
    let within = |section: &&Section| section.level != ENTRY && (2..=DEPTH).contains(&section.level);
    let mut html = String::new();
    let mut level = 1;
    for section in sections.iter().filter(within) {
        match section.level {
            deeper if deeper > level => (level..deeper).for_each(|_| html.push_str("\n<ul>\n<li>")),
            same => {
                html.push_str("</li>\n");
                (same..level).for_each(|_| html.push_str("</ul></li>\n"));
                html.push_str("<li>");
            }
        }
        level = section.level;
        let _ = write!(html, "<a href=\"#{}\">{}</a>", section.id, escaped(&entitled(section)));
    }
    (1..level).for_each(|_| html.push_str("</li>\n</ul>"));
    html
}

/// A heading that is a mere number, with the first sentence below it.
fn entitled(section: &Section) -> String {
    let number = section.title.bytes().all(|one| one.is_ascii_digit());
    let sentence = section.texts.first().and_then(|text| text.split_inclusive(['.', '。']).next());
    match sentence.filter(|_| number) {
        Some(sentence) => format!("{} {}", section.title, sentence.trim_end_matches(['.', '。'])),
        None => section.title.clone(),
    }
}
