//! Date and time of the control: the setup says when a run begins, its motions take their time.

use std::fmt;
use std::str::FromStr;

/// Seconds of a day.
const DAY: u64 = 86_400;
/// Days of 400 years, after which the calendar repeats.
const CYCLE: u64 = 146_097;
/// Longest that a run takes as far as the clock is concerned, s: a hundred years.
const LONGEST: f64 = 3.2e9;
/// Years that can be given.
const YEARS: std::ops::RangeInclusive<u64> = 1970..=2099;
const MONTHS: [u64; 12] = [31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
/// 1 January 2000, 00:00:00.
const DELIVERED: Clock = Clock(days(2000) * DAY);

/// A moment: seconds since the beginning of the year 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Clock(u64);

impl Default for Clock {
    fn default() -> Clock {
        DELIVERED
    }
}

impl Clock {
    /// So many seconds later.
    pub fn after(self, seconds: f64) -> Clock {
        Clock(self.0 + seconds.clamp(0.0, LONGEST) as u64)
    }

    /// `yy/mm/dd` (B:11483).
    pub fn date(self) -> String {
        let [year, month, day] = self.civil();
        format!("{:02}/{month:02}/{day:02}", year % 100)
    }

    /// `hh:mm:ss` (B:11483).
    pub fn time(self) -> String {
        let [hour, minute, second] = self.of_day();
        format!("{hour:02}:{minute:02}:{second:02}")
    }

    fn of_day(self) -> [u64; 3] {
        let within = self.0 % DAY;
        [within / 3600, within / 60 % 60, within % 60]
    }

    /// Year, month, day.
    fn civil(self) -> [u64; 3] {
        let whole = self.0 / DAY;
        let mut year = whole * 400 / CYCLE + 1; // the right one, or a neighbour of it
        while days(year) > whole {
            year -= 1;
        }
        while days(year + 1) <= whole {
            year += 1;
        }
        let mut rest = whole - days(year);
        let mut month = 1;
        while rest >= length(year, month) {
            rest -= length(year, month);
            month += 1;
        }
        [year, month, rest + 1]
    }
}

/// Days from the beginning of the year 1 to that of this year.
const fn days(year: u64) -> u64 {
    let before = year - 1;
    365 * before + before / 4 - before / 100 + before / 400
}

/// Days of a month, from 1.
fn length(year: u64, month: u64) -> u64 {
    let leap = year.is_multiple_of(4) && !year.is_multiple_of(100) || year.is_multiple_of(400);
    let usual = MONTHS.get(month as usize - 1).copied().unwrap_or(u64::MAX);
    usual + u64::from(leap && month == 2)
}

/// As in a setup file: `1998-11-15T10:05:30`.
impl fmt::Display for Clock {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [year, month, day] = self.civil();
        write!(f, "{year:04}-{month:02}-{day:02}T{}", self.time())
    }
}

/// No such moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoMoment;

impl FromStr for Clock {
    type Err = NoMoment;

    fn from_str(text: &str) -> Result<Clock, NoMoment> {
        let (date, time) = text.trim().split_once(['T', ' ']).ok_or(NoMoment)?;
        let [year, month, day] = numbers(date, '-')?;
        let [hour, minute, second] = numbers(time, ':')?;
        let there = YEARS.contains(&year)
            && (1..=12).contains(&month)
            && (1..=length(year, month)).contains(&day)
            && hour < 24
            && minute < 60
            && second < 60;
        let before: u64 = (1..month).map(|month| length(year, month)).sum();
        let whole = || days(year) + before + day - 1;
        if there { Ok(Clock(whole() * DAY + hour * 3600 + minute * 60 + second)) } else { Err(NoMoment) }
    }
}

/// Three numbers between separators; more than four digits are none.
fn numbers(text: &str, separator: char) -> Result<[u64; 3], NoMoment> {
    let number = |part: &str| {
        let digits = (1..=4).contains(&part.len()) && part.bytes().all(|byte| byte.is_ascii_digit());
        digits.then(|| part.parse().ok()).flatten()
    };
    let all: Option<Vec<u64>> = text.split(separator).map(number).collect();
    all.and_then(|all| all.try_into().ok()).ok_or(NoMoment)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    // oracle: manual B:11483 (formats), hand (the calendar)
    #[test]
    fn date_and_time_go_on() {
        let clock: Clock = "1998-09-15T10:05:30".parse().unwrap();
        assert_eq!((clock.date(), clock.time()), ("98/09/15".into(), "10:05:30".into()));
        for (from, seconds, to) in [
            ("1998-09-15T23:59:59", 1.0, "1998-09-16T00:00:00"),
            ("1999-12-31T23:59:59", 1.9, "2000-01-01T00:00:00"),
            ("2000-02-28T12:00:00", 86_400.0, "2000-02-29T12:00:00"),
            ("2001-02-28T12:00:00", 86_400.0, "2001-03-01T12:00:00"),
            ("2026-01-01T00:00:00", 365.0 * 86_400.0, "2027-01-01T00:00:00"),
            ("2026-01-01T00:00:00", f64::NAN, "2026-01-01T00:00:00"),
            ("2026-01-01T00:00:00", -5.0, "2026-01-01T00:00:00"),
        ] {
            let clock: Clock = from.parse().unwrap();
            assert_eq!(clock.after(seconds).to_string(), to);
        }
        assert_eq!(Clock::default().to_string(), "2000-01-01T00:00:00");
    }

    // oracle: hand
    #[test]
    fn what_is_no_moment_is_refused() {
        for wrong in [
            "",
            "1998-09-15",
            "98-09-15T10:00:00",
            "1998-13-01T00:00:00",
            "1998-00-01T00:00:00",
            "1999-02-29T00:00:00",
            "1998-09-15T24:00:00",
            "1998-09-15T10:60:00",
            "1998-09-15T10:00",
            "1998-09-15T10:00:+1",
            "99999999999999999999-01-01T00:00:00",
        ] {
            assert_eq!(wrong.parse::<Clock>(), Err(NoMoment), "{wrong}");
        }
    }
}
