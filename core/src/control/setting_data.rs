//! Setting data in which the second and third generation of the control have what the first has in user data, and some
//! that only they have. Published tables tell numbers and contents; where these are those of a user datum, its words and
//! its limits count here too.

use super::gud::{self, Element, Gud};
use super::{Control, GENERATION};

/// A setting datum.
pub struct SettingDatum {
    /// Its number.
    pub number: u32,
    /// The user datum with the same content, and which element of it; empty: there is none.
    older: [&'static str; 2],
    /// User datum with the number of probes, where each has a value of its own; empty: a single value.
    counted: &'static str,
}

/// Most probes of a kind.
const PROBES: usize = 12;

/// A row of the table: number, user datum and element of it, user datum that counts the probes.
macro_rules! data {
    ($($number:literal $array:literal $index:literal $counted:literal;)*) => {
        &[$(SettingDatum { number: $number, older: [$array, $index], counted: $counted }),*]
    };
}

/// In the order of the numbers.
pub const SETTING_DATA: &[SettingDatum] = data! {
    54600 "_WP" "k,0" "_CVAL[1]";
    54601 "_WP" "k,1" "_CVAL[1]";
    54602 "_WP" "k,2" "_CVAL[1]";
    54603 "_WP" "k,3" "_CVAL[1]";
    54604 "_WP" "k,4" "_CVAL[1]";
    54605 "_WP" "k,5" "_CVAL[1]";
    54606 "_WP" "k,6" "_CVAL[1]";
    54607 "_WP" "k,7" "_CVAL[1]";
    54608 "_WP" "k,8" "_CVAL[1]";
    54609 "_WP" "k,9" "_CVAL[1]";
    54610 "_WP" "k,10" "_CVAL[1]";
    54611 "" "" "_CVAL[1]";
    54612 "" "" "_CVAL[1]";
    54625 "_TP" "k,0" "_CVAL[0]";
    54626 "_TP" "k,1" "_CVAL[0]";
    54627 "_TP" "k,2" "_CVAL[0]";
    54628 "_TP" "k,3" "_CVAL[0]";
    54629 "_TP" "k,4" "_CVAL[0]";
    54630 "_TP" "k,5" "_CVAL[0]";
    54631 "_TP" "k,6" "_CVAL[0]";
    54632 "_TP" "k,7" "_CVAL[0]";
    54633 "_TP" "k,8" "_CVAL[0]";
    54634 "_TP" "k,9" "_CVAL[0]";
    54635 "" "" "_CVAL[0]";
    54636 "" "" "_CVAL[0]";
    54640 "_TPW" "k,0" "_CVAL[3]";
    54641 "_TPW" "k,1" "_CVAL[3]";
    54642 "_TPW" "k,2" "_CVAL[3]";
    54643 "_TPW" "k,3" "_CVAL[3]";
    54644 "_TPW" "k,4" "_CVAL[3]";
    54645 "_TPW" "k,5" "_CVAL[3]";
    54646 "_TPW" "k,6" "_CVAL[3]";
    54647 "_TPW" "k,7" "_CVAL[3]";
    54648 "_TPW" "k,8" "_CVAL[3]";
    54649 "_TPW" "k,9" "_CVAL[3]";
    54670 "_CM" "0" "";
    54671 "_CM" "1" "";
    54672 "_CM" "4" "";
    54673 "_CM" "2" "";
    54674 "_CM" "5" "";
    54675 "_CM" "6" "";
    54676 "_CM" "7" "";
    54677 "_CM" "3" "";
    54740 "" "" "";
    54760 "" "" "";
    55613 "" "" "";
    55618 "" "" "";
    55619 "" "" "";
    55632 "_SPEED" "0" "";
    55634 "_SPEED" "1" "";
    55636 "_SPEED" "2" "";
    55640 "" "" "";
    55642 "" "" "";
    55740 "" "" "";
};

impl SettingDatum {
    /// The user datum with the same content, and its element.
    pub fn older(&self) -> Option<(&'static Gud, &'static Element)> {
        let [array, index] = self.older;
        let gud = gud::find(array)?;
        Some((gud, gud.elements.iter().find(|element| element.index == index)?))
    }

    /// Its name in words: `SD54600`.
    pub fn name(&self) -> String {
        format!("SD{}", self.number)
    }

    /// That user datum in words: `_WP[k,0]`; empty: there is none.
    pub fn older_name(&self) -> String {
        let [array, index] = self.older;
        if array.is_empty() { String::new() } else { format!("{array}[{index}]") }
    }

    /// Key of its words: those of the user datum.
    pub fn key(&self) -> String {
        self.older().map_or_else(|| format!("datum-sd{}", self.number), |(gud, element)| gud.key(element))
    }

    /// Places of its values on this machine: of each probe that it counts, or the single one.
    pub fn places(&self, control: &Control) -> Vec<Option<usize>> {
        if self.counted.is_empty() {
            return vec![None];
        }
        (0..(control.number(self.counted) as usize).min(PROBES)).map(Some).collect()
    }

    /// A value as the setup names it: `SD54600[0]`.
    pub fn spelled(&self, place: Option<usize>) -> String {
        place.map_or_else(|| self.name(), |probe| format!("SD{}[{probe}]", self.number))
    }

    /// The place of the user datum with the same content: `[0, 1]` of `_WP[0,1]`.
    pub fn older_place(&self, place: Option<usize>) -> Vec<usize> {
        let [_, index] = self.older;
        index.split(',').filter_map(|part| if part == "k" { place } else { part.parse().ok() }).collect()
    }
}

impl Control {
    /// On a machine of the second or third generation the values of its setting data go where the first has them, as
    /// all that measures reads them there.
    pub fn take_setting_data(&mut self) {
        if self.number(GENERATION) <= 1.0 {
            return;
        }
        for datum in SETTING_DATA {
            let Some((gud, _)) = datum.older() else { continue };
            for place in datum.places(self) {
                if let Some(value) = self.data.get(&datum.spelled(place)).cloned() {
                    self.data.insert(gud.spelled(&datum.older_place(place)), value);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::delivery;
    use crate::dialect::Dialect;

    // oracle: self (the numbers are looked up by a reader; a user datum that is named exists)
    #[test]
    fn each_number_stands_once_and_names_a_user_datum_that_exists() {
        assert!(SETTING_DATA.is_sorted_by(|one, other| one.number < other.number));
        for datum in SETTING_DATA {
            assert_eq!(datum.older().is_none(), datum.older_name().is_empty(), "{}", datum.number);
        }
    }

    // oracle: peer (published tables: the ball diameter in SD54600, the speed in the plane in SD55634); the first
    // generation has them in user data
    #[test]
    fn a_newer_machine_measures_with_its_setting_data() {
        for (generation, wanted) in
            [(0.0, [6.0, 1000.0]), (1.0, [6.0, 1000.0]), (2.0, [4.0, 700.0]), (3.0, [4.0, 700.0])]
        {
            let mut control = delivery(Dialect::Sinumerik);
            control.set(GENERATION, generation);
            control.set("SD54600[1]", 4.0);
            control.set("SD55634", 700.0);
            control.take_setting_data();
            assert_eq!(["_WP[1,0]", "_SPEED[1]"].map(|name| control.number(name)), wanted, "{generation}");
        }
    }
}
