//! A page of Markdown as HTML: what `docs/` uses, and nothing that could be a script. Words that name a cycle or an
//! alarm lead to its page.

use super::outline::{ENTRY, Outline, Section};
use super::sources::{Language, Source, Sources};
use super::{escaped, relative};
use anyhow::{Context, Result, bail};
use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag, TagEnd, TextMergeStream};
use std::path::{Component, Path};

/// A page, made.
pub struct Made {
    /// From its title on.
    pub body: String,
    pub sections: Vec<Section>,
}

/// Makes a page of its text; twice where a place of the page refers to another, which may come later.
pub fn html(sources: &Sources, language: &Language, source: &Source) -> Result<Made> {
    let made = written(Writer::new(sources, language, source))?;
    if !source.markdown.contains(REFERENCE) {
        return Ok(made);
    }
    let titles = made.sections.into_iter().map(|section| (section.title, section.id)).collect();
    written(Writer { titles, ..Writer::new(sources, language, source) })
}

fn written(mut writer: Writer<'_>) -> Result<Made> {
    for event in TextMergeStream::new(Parser::new_ext(&writer.source.markdown, Options::ENABLE_TABLES)) {
        writer.event(event)?;
    }
    Ok(Made { body: writer.html, sections: writer.outline.sections })
}

/// Before titles of the same page, with commas between them: `→ Setpoint, Measuring path`.
const REFERENCE: &str = "→ ";

const STRONG: &str = "<strong>";

/// Writes HTML, and beside it the plain text for the search.
struct Writer<'a> {
    sources: &'a Sources,
    language: &'a Language,
    source: &'a Source,
    html: String,
    /// What was written before the paragraph, heading, cell or picture that is being written.
    before: Vec<String>,
    text: String,
    /// How much of the text its paragraph begins with in bold.
    bold: usize,
    outline: Outline,
    /// Texts of the cells of the row that is being written.
    cells: Vec<String>,
    /// The row has a section of its own.
    named: bool,
    /// Inside the head of a table.
    head: bool,
    /// Within how many headings, links and pieces of code: no word becomes a link there.
    within: usize,
    /// Where the picture is that is being written.
    picture: String,
    /// Titles on this page, and their ids.
    titles: Vec<(String, String)>,
}

impl<'a> Writer<'a> {
    fn new(sources: &'a Sources, language: &'a Language, source: &'a Source) -> Writer<'a> {
        Writer {
            sources,
            language,
            source,
            html: String::new(),
            before: Vec::new(),
            text: String::new(),
            bold: 0,
            outline: Outline::default(),
            cells: Vec::new(),
            named: false,
            head: false,
            within: 0,
            picture: String::new(),
            titles: Vec::new(),
        }
    }

    fn event(&mut self, event: Event<'_>) -> Result<()> {
        match event {
            Event::Start(tag) => return self.start(tag),
            Event::End(tag) => self.end(tag),
            Event::Text(text) => self.text(&text),
            Event::Code(code) => {
                self.text.push_str(&code);
                self.put(&format!("<code>{}</code>", escaped(&code)));
            }
            Event::InlineHtml(tag) if &*tag == "<br>" => {
                self.text.push(' ');
                self.put("<br>");
            }
            // as text: what a page shows is never a mark-up of its own
            Event::InlineHtml(text) | Event::Html(text) => self.text(&text),
            Event::SoftBreak => self.text("\n"),
            Event::HardBreak => self.put("<br>\n"),
            Event::Rule => self.put("<hr>\n"),
            other => bail!("the handbook has no form for {other:?}"),
        }
        Ok(())
    }

    fn start(&mut self, tag: Tag<'_>) -> Result<()> {
        match tag {
            Tag::Paragraph => self.open(),
            Tag::Heading { .. } => {
                self.within += 1;
                self.open();
            }
            Tag::List(first) => {
                self.flush(); // what stands before it in its item
                self.put(if first.is_some() { "<ol>\n" } else { "<ul>\n" });
            }
            Tag::Item => self.put("<li>"),
            Tag::Strong => self.put(STRONG),
            Tag::Emphasis => self.put("<em>"),
            Tag::BlockQuote(_) => self.put("<blockquote>\n"),
            Tag::HtmlBlock => self.put("<p>"),
            Tag::CodeBlock(_) => {
                self.within += 1;
                self.put("<pre tabindex=\"0\"><code>");
            }
            Tag::Link { dest_url, .. } => {
                self.within += 1;
                let target = self.target(&dest_url)?;
                self.put(&format!("<a href=\"{}\">", escaped(&target)));
            }
            Tag::Image { dest_url, .. } => {
                self.picture = self.target(&dest_url)?;
                self.flush();
                self.open();
            }
            Tag::Table(_) => {
                let heading = self.outline.heading().to_owned();
                self.put(&format!(
                    "<div class=\"table\" role=\"group\" aria-labelledby=\"{heading}\" tabindex=\"0\"><table>\n"
                ));
            }
            Tag::TableHead => {
                self.head = true;
                self.put("<thead><tr>");
            }
            Tag::TableRow => self.put("<tr>"),
            Tag::TableCell => self.open(),
            other => bail!("the handbook has no form for {other:?}"),
        }
        Ok(())
    }

    fn end(&mut self, tag: TagEnd) {
        match tag {
            TagEnd::Paragraph => self.paragraph(),
            TagEnd::HtmlBlock => self.close_text("</p>\n"),
            TagEnd::Heading(level) => self.heading(level),
            TagEnd::List(ordered) => self.put(if ordered { "</ol>\n" } else { "</ul>\n" }),
            TagEnd::Item => self.close_text("</li>\n"),
            TagEnd::Strong => {
                self.put("</strong>");
                if self.html.starts_with(STRONG) && self.html.matches(STRONG).count() == 1 {
                    self.bold = self.text.len();
                }
            }
            TagEnd::Emphasis => self.put("</em>"),
            TagEnd::BlockQuote(_) => self.put("</blockquote>\n"),
            TagEnd::CodeBlock => {
                self.within -= 1;
                self.close_text("</code></pre>\n");
            }
            TagEnd::Link => {
                self.within -= 1;
                self.put("</a>");
            }
            TagEnd::Image => {
                self.close();
                let words = std::mem::take(&mut self.text);
                let source = std::mem::take(&mut self.picture);
                self.put(&format!("<img src=\"{}\" alt=\"{}\">", escaped(&source), escaped(&words)));
            }
            TagEnd::Table => self.put("</tbody></table></div>\n"),
            TagEnd::TableHead => {
                self.head = false;
                self.cells.clear();
                self.put("</tr></thead><tbody>\n");
            }
            TagEnd::TableRow => self.row(),
            TagEnd::TableCell => self.cell(),
            _ => {} // its beginning was refused
        }
    }

    fn put(&mut self, html: &str) {
        self.html.push_str(html);
    }

    /// What follows is looked at as a whole before it is written.
    fn open(&mut self) {
        self.before.push(std::mem::take(&mut self.html));
    }

    fn close(&mut self) -> String {
        let before = self.before.pop().unwrap_or_default();
        std::mem::replace(&mut self.html, before)
    }

    /// One that explains the term in bold with which it begins can be looked up by that.
    fn paragraph(&mut self) {
        let (inner, text) = (self.close(), std::mem::take(&mut self.text));
        let (term, rest) = text.split_at(std::mem::take(&mut self.bold));
        let rest = rest.trim_start_matches([':', '：', ' ', '\n']);
        let is_term = !term.is_empty() && !term.ends_with(['.', '。', ':', '：']) && !rest.is_empty();
        if is_term {
            let id = self.outline.begin(ENTRY, term);
            self.outline.add(rest, true);
            self.put(&format!("<p><strong id=\"{id}\">{}</p>\n", &inner[STRONG.len()..]));
        } else {
            self.outline.add(&text, false);
            self.put(&format!("<p>{inner}</p>\n"));
        }
    }

    /// An entry of a list or a piece of code ends.
    fn close_text(&mut self, html: &str) {
        self.put(html);
        self.flush();
    }

    /// The search finds what was written since.
    fn flush(&mut self) {
        let text = std::mem::take(&mut self.text);
        self.outline.add(&text, false);
    }

    fn heading(&mut self, level: HeadingLevel) {
        self.within -= 1;
        let (inner, title) = (self.close(), std::mem::take(&mut self.text));
        let level = level as usize;
        let id = self.outline.begin(level, &title);
        let link = format!("<a class=\"anchor\" href=\"#{id}\" tabindex=\"-1\" aria-hidden=\"true\">#</a>");
        self.put(&format!("<h{level} id=\"{id}\">{inner}{link}</h{level}>\n"));
    }

    /// The first cell of a row is its heading; a name in code can be looked up by itself.
    fn cell(&mut self) {
        let (inner, text) = (self.close(), std::mem::take(&mut self.text));
        let first = self.cells.is_empty();
        let html = match () {
            () if self.head => format!("<th scope=\"col\">{inner}</th>"),
            () if first && is_code(&inner) => {
                self.named = true;
                let id = self.outline.begin(ENTRY, &text);
                format!("<th scope=\"row\" id=\"{id}\">{inner}</th>")
            }
            () if first && !inner.is_empty() => format!("<th scope=\"row\">{inner}</th>"),
            () => format!("<td>{inner}</td>"),
        };
        self.cells.push(text);
        self.put(&html);
    }

    fn row(&mut self) {
        self.put("</tr>\n");
        let cells = std::mem::take(&mut self.cells);
        let named = std::mem::take(&mut self.named);
        let told = cells.iter().skip(usize::from(named)).filter(|cell| !cell.is_empty());
        self.outline.add(&told.map(String::as_str).collect::<Vec<_>>().join(" · "), named);
    }

    /// Text, with links from the titles and names in it.
    fn text(&mut self, text: &str) {
        self.text.push_str(text);
        if self.within > 0 {
            return self.put(&escaped(text));
        }
        match text.split_once(REFERENCE).filter(|_| !self.titles.is_empty()) {
            Some((before, rest)) => {
                self.words(before);
                self.put(REFERENCE);
                let rest = self.references(rest);
                self.words(rest);
            }
            None => self.words(text),
        }
    }

    /// Links to the titles with which a text begins; gives what follows them.
    fn references<'t>(&mut self, text: &'t str) -> &'t str {
        let mut rest = text;
        loop {
            let begins = |title: &str| {
                rest.strip_prefix(title).is_some_and(|behind| !behind.starts_with(|c: char| c.is_alphanumeric()))
            };
            let found = self.titles.iter().filter(|(title, _)| begins(title)).max_by_key(|(title, _)| title.len());
            let Some((title, id)) = found else { return rest };
            let (link, length) = (format!("<a href=\"#{id}\">{}</a>", escaped(title)), title.len());
            self.put(&link);
            rest = &rest[length..];
            match rest.strip_prefix(", ") {
                Some(next) => {
                    self.put(", ");
                    rest = next;
                }
                None => return rest,
            }
        }
    }

    /// Text with links from names of cycles and alarms.
    fn words(&mut self, text: &str) {
        for piece in text.split_inclusive(|c: char| !c.is_ascii_alphanumeric()) {
            let word = piece.trim_end_matches(|c: char| !c.is_ascii_alphanumeric());
            let joined = is_joined(text, piece);
            let named = self.language.named(word).filter(|one| one.page != self.source.name && !joined);
            let page = named.and_then(|one| Some((self.language.page(&one.page)?, one.place.as_ref())));
            match page {
                Some((page, place)) => {
                    let file = relative(&self.source.file(self.language), &page.file(self.language));
                    let place = place.map(|place| format!("#{place}")).unwrap_or_default();
                    self.put(&format!("<a href=\"{file}{place}\">{word}</a>"));
                }
                None => self.put(word),
            }
            self.put(&escaped(&piece[word.len()..]));
        }
    }

    /// What a link of the page leads to, in the handbook.
    fn target(&self, link: &str) -> Result<String> {
        if link.contains("://") || link.starts_with('#') {
            return Ok(link.to_owned());
        }
        let (path, place) = link.split_once('#').map_or((link, String::new()), |(path, id)| (path, format!("#{id}")));
        let from = self.source.file(self.language);
        let folder = self.language.folder();
        let written = format!("{folder}{}", self.source.name);
        let path = resolved(Path::new(&written).parent().unwrap_or(Path::new("")), path)
            .with_context(|| format!("{link} leads out of docs/"))?;
        let name = path.strip_prefix(&folder).and_then(|path| path.strip_suffix(".md"));
        let page = name.and_then(|name| self.language.page(name));
        let to = match page {
            Some(page) => page.file(self.language),
            None if self.sources.beside.contains_key(&path) => path,
            None => bail!("{link} leads to nothing"),
        };
        Ok(relative(&from, &to) + &place)
    }
}

/// Whether a piece of a text goes on with a name that began before it: `_CYCLE977`, `$MN_61301`.
fn is_joined(text: &str, piece: &str) -> bool {
    let at = piece.as_ptr() as usize - text.as_ptr() as usize;
    text[..at].ends_with(['_', '$', '.', '-', '/', '\\'])
}

/// A name of something, in code and nothing else.
fn is_code(html: &str) -> bool {
    let inner = html.strip_prefix("<code>").and_then(|rest| rest.strip_suffix("</code>"));
    inner.is_some_and(|inner| !inner.contains('<') && !inner.is_empty())
}

/// A path named from a folder, as one from the top.
fn resolved(folder: &Path, path: &str) -> Option<String> {
    let mut parts = Vec::new();
    for part in folder.join(path).components() {
        match part {
            Component::Normal(name) => parts.push(name.to_str()?.to_owned()),
            Component::ParentDir => {
                parts.pop()?;
            }
            Component::CurDir => {}
            _ => return None,
        }
    }
    Some(parts.join("/"))
}
