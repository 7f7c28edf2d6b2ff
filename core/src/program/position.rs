//! Places in a program as people and editors count them.

/// Line starts of a source, and what of it is not ASCII.
pub struct Positions<'a> {
    source: &'a [u8],
    /// First byte of each line.
    lines: Vec<u32>,
    /// Whether a byte offset is a UTF-16 offset too.
    ascii: bool,
}

impl<'a> Positions<'a> {
    /// For this source. Lines end with LF, CR LF or a lone CR.
    pub fn new(source: &'a [u8]) -> Self {
        let mut lines = vec![0];
        for (index, byte) in source.iter().enumerate() {
            let ends = match byte {
                b'\n' => true,
                b'\r' => source.get(index + 1) != Some(&b'\n'),
                _ => false,
            };
            if ends {
                lines.push(index as u32 + 1);
            }
        }
        Self {
            source,
            lines,
            ascii: source.is_ascii(),
        }
    }

    /// Line and column of a byte, both from 1; the column in characters.
    pub fn line_column(&self, byte: u32) -> (u32, u32) {
        let line = self.lines.partition_point(|start| *start <= byte).max(1);
        let start = self.lines.get(line - 1).copied().unwrap_or(0);
        (line as u32, characters(self.between(start, byte)) + 1)
    }

    /// UTF-16 units before a byte, as a page counts.
    pub fn utf16(&self, byte: u32) -> u32 {
        if self.ascii {
            return byte.min(self.source.len() as u32);
        }
        let text = String::from_utf8_lossy(self.between(0, byte));
        text.encode_utf16().count() as u32
    }

    fn between(&self, start: u32, end: u32) -> &[u8] {
        let end = (end as usize).min(self.source.len());
        self.source.get(start as usize..end).unwrap_or(&[])
    }
}

fn characters(bytes: &[u8]) -> u32 {
    String::from_utf8_lossy(bytes).chars().count() as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand
    #[test]
    fn lines_columns_and_utf16_units() {
        let source = "N1 ;ü𝛂\r\nN2 X1\rN3\n".as_bytes();
        let positions = Positions::new(source);
        assert_eq!(positions.line_column(0), (1, 1));
        assert_eq!(positions.line_column(6), (1, 6)); // after ü, 2 bytes
        assert_eq!(positions.utf16(10), 7); // after 𝛂: 4 bytes, 2 units
        assert_eq!(positions.line_column(12), (2, 1));
        assert_eq!(positions.line_column(18), (3, 1));
        assert_eq!(positions.line_column(9999), (4, 1));
        assert_eq!(
            positions.utf16(9999),
            Positions::new(source).utf16(source.len() as u32)
        );
    }
}
