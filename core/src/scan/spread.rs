//! An order for drawing: of many things the first few already show all of them, more or less closely.

/// Odd, half of its bits set: a product with it mixes them well.
const MIXING: usize = 0x9d5b_c3a7;

/// The turn of each of so many things: every number below `count` once. However many of the first turns are taken, they
/// lie evenly among all: of pieces of equal length each has one before any has a second one. Where in its piece is left
/// to chance, so that nothing that repeats among the things (lines scanned side by side) shows as a pattern.
pub fn turns(count: usize) -> Vec<usize> {
    let bits = count.next_power_of_two().trailing_zeros();
    let all = 1_usize << bits;
    // Each bit of a place follows from the turn and the bits above it: pieces stay, but not their order in larger ones.
    let place = |turn: usize| {
        let mixed = turn.wrapping_mul(MIXING);
        let mixed = mixed ^ mixed.wrapping_mul(MIXING << 1);
        let low = mixed & (all - 1);
        low.reverse_bits().checked_shr(usize::BITS - bits).unwrap_or(0)
    };
    let mut turns = vec![0; count];
    let places = (0..all).map(place).filter(|place| *place < count);
    for (turn, place) in places.enumerate() {
        turns[place] = turn;
    }
    turns
}

#[cfg(test)]
mod tests {
    use super::turns;
    use proptest::prelude::*;

    proptest! {
        // oracle: hand: what lies evenly leaves no gap of more than a few times the mean distance
        #[test]
        fn the_first_ones_lie_evenly_among_all(count in 0_usize..3000, share in 1_usize..64) {
            let turns = turns(count);
            let mut all = turns.clone();
            all.sort_unstable();
            prop_assert_eq!(&all, &(0..count).collect::<Vec<_>>());

            let taken = count / share;
            let mut first: Vec<usize> = (0..count).filter(|place| turns[*place] < taken).collect();
            first.insert(0, 0);
            first.push(count);
            let widest = first.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap_or(0);
            prop_assert!(taken == 0 || widest <= 6 * share, "{taken} of {count}: {widest}");
        }
    }

    // oracle: hand: of lines with as many points as there are pieces, a plain order would draw a single column
    #[test]
    fn lines_of_equal_length_show_no_columns() {
        let first = turns(1024 * 1024).into_iter().enumerate().filter(|(_, turn)| *turn < 1024);
        let mut columns: Vec<usize> = first.map(|(place, _)| place % 1024).collect();
        columns.sort_unstable();
        columns.dedup();
        assert!(columns.len() > 400, "{}", columns.len());
    }
}
