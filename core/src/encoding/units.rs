//! Text in units of two bytes: a part program is mostly ASCII, of which one byte in two is NUL.

/// What is in the units, read with the low byte first (0) and with the high byte first (1).
#[derive(Default)]
pub struct Units {
    first: Option<u8>,
    all: usize,
    printable: [usize; 2],
    controls: [usize; 2],
}

impl Units {
    pub fn take(&mut self, byte: u8) {
        let Some(first) = self.first.take() else {
            self.first = Some(byte);
            return;
        };
        self.all += 1;
        for (order, unit) in [[byte, first], [first, byte]].into_iter().enumerate() {
            match unit {
                [0, b'\t'..=b'\r' | b' '..=b'~'] => self.printable[order] += 1,
                [0, 0..b' ' | 0x7F] => self.controls[order] += 1,
                _ => {}
            }
        }
    }

    /// Takes bytes of which none is NUL: their units are characters of neither order.
    pub fn take_text(&mut self, bytes: &[u8]) {
        let [begin, rest @ ..] = bytes else { return };
        if self.first.is_some() {
            self.take(*begin);
            return self.take_text(rest);
        }
        self.all += bytes.len() / 2;
        self.first = bytes.last().filter(|_| bytes.len() % 2 == 1).copied();
    }

    /// Whether it is text in this order, where a mark says so.
    pub fn marked(&self, order: usize) -> bool {
        self.controls[order] * 5 <= self.all
    }

    /// The order in which it is text, where only the units themselves can tell.
    pub fn unmarked(&self) -> Option<usize> {
        let order = usize::from(self.printable[1] > self.printable[0]);
        let text = self.printable[order] * 4 >= self.all;
        (text && self.controls[order] * 20 <= self.printable[order]).then_some(order)
    }
}
