//! The words of an exported line.

use crate::control::definitions::{ELEMENTS, First};
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
        ahead.index();
        match plain(text) {
            Some(_) if datum && ahead.assigns() => Token::Word(text),
            Some(number) => Token::Number(number),
            None => Token::Sign('?'),
        }
    }

    /// An index, without its brackets and blanks: `0,1`, `X1`, `R[1]`.
    pub fn index(&mut self) -> Option<String> {
        let rest = self.rest.trim_start().strip_prefix('[')?;
        let mut open = 1_usize;
        let end = rest.char_indices().find_map(|(at, sign)| {
            match sign {
                '[' => open += 1,
                ']' => open -= 1,
                _ => {}
            }
            (open == 0).then_some(at)
        })?;
        self.rest = rest.split_at_checked(end + 1)?.1;
        Some(rest.get(..end)?.split_whitespace().collect::<String>().to_ascii_uppercase())
    }

    /// Whether a value follows; goes behind the sign that says so. `==` compares.
    pub fn assigns(&mut self) -> bool {
        let rest = self.rest.trim_start();
        let behind = rest.strip_prefix(":=").or_else(|| rest.strip_prefix(['=', ':']));
        let Some(behind) = behind.filter(|_| !rest.starts_with("==")) else { return false };
        self.rest = behind;
        true
    }

    /// Whether a value goes on: behind a comma, `12,5`, which is no number of a control and no next datum either; or
    /// as a calculation, `4*2`.
    pub fn goes_on(&self) -> bool {
        if self.rest.trim_start().starts_with(['*', '/']) {
            return true;
        }
        let rest = self.rest.strip_prefix(',').filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
        rest.is_some_and(|rest| matches!(Scan::new(rest).token(), Token::Number(_)))
    }

    /// The next value, as many as stand in brackets, of which one that is left out is none, or one for many elements:
    /// `7`, `(1,2)`, `SET(1,,2)`, `REP(1)`, `REP(1,5)`. None: it is nothing of these.
    pub fn values(&mut self) -> Option<First> {
        let begin = *self;
        let first = self.token();
        let is = |name: &str| matches!(first, Token::Word(word) if word.eq_ignore_ascii_case(name));
        if first == Token::Sign('(') || is("SET") && self.token() == Token::Sign('(') {
            self.list().map(First::Each)
        } else if is("REP") && self.token() == Token::Sign('(') {
            self.repeated()
        } else {
            *self = begin;
            self.value().map(|value| First::Each(vec![Some(value)]))
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

    /// Values up to the closing bracket; none: something else stands among them, or no bracket closes them.
    fn list(&mut self) -> Option<Vec<Option<Value>>> {
        let mut values = Vec::new();
        loop {
            values.push(self.value());
            match self.token() {
                Token::Sign(',') => {}
                Token::Sign(')') => return Some(values),
                _ => return None,
            }
        }
    }

    /// Value and count up to the closing bracket of `REP(`.
    fn repeated(&mut self) -> Option<First> {
        let value = self.value()?;
        match self.token() {
            Token::Sign(')') => return Some(First::Same(value, ELEMENTS)),
            Token::Sign(',') => {}
            _ => return None,
        }
        let Value::Number(count) = self.value()? else { return None };
        (count >= 1.0 && self.token() == Token::Sign(')')).then_some(First::Same(value, count as usize))
    }

    /// Goes behind a value that cannot be read.
    pub fn skip(&mut self) {
        let first = self.token();
        if matches!(first, Token::Word(_)) {
            self.index();
        }
        let mut ahead = *self;
        if first == Token::Sign('(') {
            self.close();
        } else if matches!(first, Token::Word(_)) && ahead.token() == Token::Sign('(') {
            ahead.close();
            *self = ahead;
        }
    }

    /// Goes behind the bracket that closes an open one.
    fn close(&mut self) {
        let mut open = 1_usize;
        while open > 0 {
            match self.token() {
                Token::Sign('(') => open += 1,
                Token::Sign(')') => open -= 1,
                Token::End => return,
                _ => {}
            }
        }
    }

    /// Goes behind the next comma, or to the end.
    pub fn skip_to_comma(&mut self) {
        while !matches!(self.token(), Token::Sign(',') | Token::End) {}
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
