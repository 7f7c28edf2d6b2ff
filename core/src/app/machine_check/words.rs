//! The words of an exported line.

use crate::control::{Value, machine_data};

/// A piece of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Token<'a> {
    /// A name, a number of a datum, a command.
    Word(&'a str),
    /// A number.
    Number(f64),
    /// A text, without its quotation marks.
    Text(&'a str),
    /// Anything else.
    Sign(char),
    /// Nothing is left.
    End,
}

/// A line, read from the left to the right.
#[derive(Clone, Copy)]
pub struct Scan<'a> {
    rest: &'a str,
}

fn of_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '$')
}

impl<'a> Scan<'a> {
    /// At the beginning of a line.
    pub fn new(rest: &'a str) -> Scan<'a> {
        Scan { rest }
    }

    /// What is not read yet.
    pub fn rest(&self) -> &'a str {
        self.rest.trim()
    }

    fn take(&mut self, bytes: usize) -> &'a str {
        let (taken, rest) = self.rest.split_at_checked(bytes).unwrap_or((self.rest, ""));
        self.rest = rest;
        taken
    }

    /// The next piece; a comment, and a checksum behind a value (`'1a2b`), end the line.
    pub fn token(&mut self) -> Token<'a> {
        self.rest = self.rest.trim_start();
        let Some(first) = self.rest.chars().next() else { return Token::End };
        match first {
            ';' => {
                self.rest = "";
                Token::End
            }
            '"' => self.quoted('"').map_or(Token::End, Token::Text),
            '\'' => self.quoted('\'').and_then(coded).map_or(Token::End, Token::Number),
            '0'..='9' | '.' | '-' | '+' => self.number(),
            _ if of_word(first) => {
                let end = self.rest.find(|c| !of_word(c)).unwrap_or(self.rest.len());
                Token::Word(self.take(end))
            }
            _ => {
                self.take(first.len_utf8());
                Token::Sign(first)
            }
        }
    }

    /// What stands between two of these signs; without the second the rest of the line is gone.
    fn quoted(&mut self, sign: char) -> Option<&'a str> {
        self.take(1);
        let end = self.rest.find(sign);
        let inside = self.take(end.unwrap_or(self.rest.len()));
        self.take(1);
        end.map(|_| inside)
    }

    /// `7`, `-0.5`, `1.5EX-3`, `21H`. A number in front of a value is a word: that of a datum.
    fn number(&mut self) -> Token<'a> {
        let number = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '+');
        let end = self.rest.find(|c| !number(c)).unwrap_or(self.rest.len());
        let text = self.take(end.max(1));
        let datum = text.len() >= 4 && text.bytes().all(|digit| digit.is_ascii_digit());
        let mut ahead = *self;
        match plain(text) {
            Some(_) if datum && ahead.assigns() => Token::Word(text),
            Some(number) => Token::Number(number),
            None => Token::Sign('?'),
        }
    }

    /// An index, without its brackets: `0,1`, `X1`.
    pub fn index(&mut self) -> Option<String> {
        let rest = self.rest.trim_start().strip_prefix('[')?;
        let end = rest.find(']')?;
        self.rest = rest.split_at_checked(end + 1)?.1;
        Some(rest.get(..end)?.trim().to_ascii_uppercase())
    }

    /// Whether a value follows; goes behind the sign that says so.
    pub fn assigns(&mut self) -> bool {
        match self.rest.trim_start().strip_prefix(['=', ':']) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    /// Whether a value goes on behind a comma, `12,5`: that is no number of a control, and no next datum either.
    pub fn goes_on(&self) -> bool {
        let rest = self.rest.strip_prefix(',').filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
        rest.is_some_and(|rest| matches!(Scan::new(rest).token(), Token::Number(_)))
    }

    /// The next value, or as many as stand in brackets: one that is left out is none.
    pub fn values(&mut self) -> Option<Vec<Option<Value>>> {
        let begin = *self;
        match self.token() {
            Token::Word("SET" | "set") => self.values(),
            Token::Sign('(') => Some(self.list()),
            _ => {
                *self = begin;
                self.value().map(|value| vec![Some(value)])
            }
        }
    }

    /// A value.
    pub fn value(&mut self) -> Option<Value> {
        let begin = *self;
        let value = match self.token() {
            Token::Number(number) => Some(Value::Number(number)),
            Token::Text(text) => Some(Value::Text(text.to_owned())),
            Token::Word(word) if word.eq_ignore_ascii_case("TRUE") => Some(Value::Number(1.0)),
            Token::Word(word) if word.eq_ignore_ascii_case("FALSE") => Some(Value::Number(0.0)),
            _ => None,
        };
        if value.is_none() {
            *self = begin;
        }
        value
    }

    /// Values up to the closing bracket.
    fn list(&mut self) -> Vec<Option<Value>> {
        let (mut values, mut last) = (Vec::new(), None);
        loop {
            if let Some(value) = self.value() {
                last = Some(value);
                continue;
            }
            match self.token() {
                Token::Sign(',') => values.push(last.take()),
                Token::Sign(')') | Token::End => {
                    values.push(last);
                    return values;
                }
                _ => {}
            }
        }
    }
}

/// `H21` and `B101` between quotation marks.
fn coded(text: &str) -> Option<f64> {
    let digits = text.get(1..)?;
    let base = match text.as_bytes().first()? {
        b'H' | b'h' => 16,
        b'B' | b'b' => 2,
        _ => return None,
    };
    u32::from_str_radix(digits, base).ok().map(f64::from)
}

/// A number as a control writes it.
fn plain(text: &str) -> Option<f64> {
    let exponent = text.replace("EX", "E");
    machine_data::number(&exponent).filter(|number| number.is_finite())
}
