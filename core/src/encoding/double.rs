//! Characters of more than one byte, counted as far as their bytes tell: those that such a text is made of, those that
//! it seldom has, and bytes that stand for none. Ranges as in the WHATWG encoding standard.

/// How often what was seen.
#[derive(Clone, Copy, Default)]
pub struct Counts {
    pub usual: usize,
    pub rare: usize,
    pub wrong: usize,
    /// Bytes of a character that is not complete.
    open: usize,
}

impl Counts {
    /// Whether a character is not complete.
    pub fn is_open(self) -> bool {
        self.open > 0
    }

    /// A character that the end cuts is none.
    pub fn done(mut self) -> Counts {
        self.wrong += usize::from(self.open > 0);
        self
    }

    /// Whether it is such a text. One wrong byte counts as much as four rare characters.
    pub fn likely(self) -> bool {
        self.usual > 0 && self.usual >= self.rare + 4 * self.wrong
    }
}

/// UTF-8; every whole character is a usual one.
#[derive(Default)]
pub struct Utf8(pub Counts, Option<(u8, u8)>);

impl Utf8 {
    pub fn take(&mut self, byte: u8) {
        let Utf8(counts, range) = self;
        if counts.open > 0 {
            let (low, high) = range.take().unwrap_or((0x80, 0xBF));
            if (low..=high).contains(&byte) {
                counts.open -= 1;
                counts.usual += usize::from(counts.open == 0);
                return;
            }
            counts.open = 0;
            counts.wrong += 1;
        }
        let (more, within) = match byte {
            0..0x80 => return,
            0xC2..=0xDF => (1, (0x80, 0xBF)),
            0xE0 => (2, (0xA0, 0xBF)),
            0xED => (2, (0x80, 0x9F)),
            0xE1..=0xEF => (2, (0x80, 0xBF)),
            0xF0 => (3, (0x90, 0xBF)),
            0xF4 => (3, (0x80, 0x8F)),
            0xF1..=0xF3 => (3, (0x80, 0xBF)),
            _ => {
                counts.wrong += 1;
                return;
            }
        };
        counts.open = more;
        *range = Some(within);
    }
}

/// GB 18030. Usual are punctuation and the first level of GB 2312, which covers 99.7 % of what is written.
#[derive(Default)]
pub struct Gb18030 {
    pub pairs: Counts,
    /// Characters of four bytes, which GBK does not have.
    pub four: usize,
    lead: u8,
}

impl Gb18030 {
    pub fn take(&mut self, byte: u8) {
        let counts = &mut self.pairs;
        let fits = match (counts.open, byte) {
            (0, _) => return self.begin(byte),
            (1, 0x40..=0x7E | 0x80..=0xFE) => {
                let usual = matches!(self.lead, 0xA1..=0xA3 | 0xB0..=0xD7) && byte >= 0xA1;
                counts.usual += usize::from(usual);
                counts.rare += usize::from(!usual);
                counts.open = 0;
                return;
            }
            (1 | 3, 0x30..=0x39) | (2, 0x81..=0xFE) => true,
            _ => false,
        };
        if !fits {
            counts.wrong += 1;
            self.begin(byte);
        } else if counts.open == 3 {
            counts.rare += 1;
            self.four += 1;
            counts.open = 0;
        } else {
            counts.open += 1;
        }
    }

    fn begin(&mut self, byte: u8) {
        let counts = &mut self.pairs;
        counts.open = usize::from(matches!(byte, 0x81..=0xFE));
        counts.wrong += usize::from(matches!(byte, 0x80 | 0xFF));
        self.lead = byte;
    }
}

/// Shift JIS. Usual are kana (half-width: not alone), full-width letters and the first level of kanji.
#[derive(Default)]
pub struct ShiftJis {
    pub pairs: Counts,
    lead: u8,
    /// Half-width kana in a row.
    narrow: usize,
}

impl ShiftJis {
    /// Whether the next byte may belong to what has begun: a character, or a row of kana.
    pub fn is_open(&self) -> bool {
        self.pairs.is_open() || self.narrow > 0
    }

    pub fn take(&mut self, byte: u8) {
        let counts = &mut self.pairs;
        if counts.open > 0 {
            counts.open = 0;
            if matches!(byte, 0x40..=0x7E | 0x80..=0xFC) {
                // with an ASCII letter behind it a lead is as well a sign of western text
                let usual = match self.lead {
                    0x82 | 0x83 => true,
                    0x81 | 0x88..=0x98 => byte >= 0x80,
                    _ => false,
                };
                counts.usual += usize::from(usual);
                counts.rare += usize::from(!usual);
                return;
            }
            counts.wrong += 1;
        }
        if matches!(byte, 0xA1..=0xDF) {
            self.narrow += 1;
            match self.narrow {
                1 => counts.rare += 1,
                2 => {
                    counts.rare -= 1;
                    counts.usual += 2;
                }
                _ => counts.usual += 1,
            }
            return;
        }
        self.narrow = 0;
        self.lead = byte;
        counts.open = usize::from(matches!(byte, 0x81..=0x9F | 0xE0..=0xFC));
        counts.wrong += usize::from(matches!(byte, 0x80 | 0xA0 | 0xFD..));
    }
}
