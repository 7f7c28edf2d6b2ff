//! Setting data, and machine data from 51600, in which the second and third generation of the control have what the
//! first has in user data, and some that only they have. Published tables tell numbers and contents; where these are
//! those of a user datum, its words and its limits count here too.

use super::gud::{self, Element, Gud};
use super::{Control, GENERATION};

/// A setting datum, or one of the machine data.
pub struct SettingDatum {
    /// Its number.
    pub number: u32,
    /// The user datum with the same content, and which element of it; empty: there is none.
    older: [&'static str; 2],
    /// User datum with the number of probes, where each has a value of its own; empty: a single value; `TOLD`: values
    /// that nothing here has a use for, whose number is not the same on every machine.
    counted: &'static str,
}

/// Most values of one datum: of the memories for empirical and mean values; probes are fewer.
const MOST: usize = 20;
/// In the place of what counts the values: they are told and not entered.
const TOLD: &str = "-";
/// Where setting data begin; below are machine data.
const SETTINGS: u32 = 54_000;

/// A row of the table: number, user datum and element of it, user datum that counts the probes.
macro_rules! data {
    ($($number:literal $array:literal $index:literal $counted:literal;)*) => {
        &[$(SettingDatum { number: $number, older: [$array, $index], counted: $counted }),*]
    };
}

/// In the order of the numbers.
pub const SETTING_DATA: &[SettingDatum] = data! {
    51600 "_CVAL" "1" "";
    51601 "_CVAL" "2" "";
    51602 "_CVAL" "0" "";
    51603 "_CVAL" "3" "";
    51618 "" "" "";
    51740 "" "" "";
    51742 "" "" "-";
    51750 "" "" "";
    51751 "" "" "";
    51752 "" "" "";
    51753 "" "" "";
    51755 "" "" "";
    51757 "" "" "";
    51758 "" "" "";
    51770 "" "" "-";
    51772 "" "" "-";
    51780 "" "" "-";
    51781 "" "" "-";
    51784 "" "" "-";
    51786 "" "" "";
    52740 "" "" "";
    52750 "" "" "";
    52751 "" "" "-";
    52780 "" "" "";
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
    54615 "_KB" "k,2" "_CVAL[2]";
    54617 "_KB" "k,3" "_CVAL[2]";
    54618 "_KB" "k,4" "_CVAL[2]";
    54619 "_KB" "k,6" "_CVAL[2]";
    54620 "_KB" "k,5" "_CVAL[2]";
    54621 "_KB" "k,0" "_CVAL[2]";
    54622 "_KB" "k,1" "_CVAL[2]";
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
    54650 "" "" "_CVAL[3]";
    54651 "" "" "_CVAL[3]";
    54652 "" "" "_CVAL[3]";
    54670 "_CM" "0" "";
    54671 "_CM" "1" "";
    54672 "_CM" "4" "";
    54673 "_CM" "2" "";
    54674 "_CM" "5" "";
    54675 "_CM" "6" "";
    54676 "_CM" "7" "";
    54677 "_CM" "3" "";
    54689 "" "" "";
    54691 "" "" "";
    54692 "" "" "";
    54693 "" "" "";
    54695 "" "" "-";
    54696 "" "" "-";
    54697 "" "" "-";
    54698 "" "" "-";
    54699 "" "" "-";
    54700 "" "" "-";
    54705 "" "" "-";
    54706 "" "" "-";
    54707 "" "" "-";
    54708 "" "" "-";
    54709 "" "" "-";
    54710 "" "" "-";
    54740 "" "" "";
    54750 "" "" "";
    54760 "" "" "";
    54762 "" "" "";
    54764 "" "" "";
    54780 "" "" "";
    54782 "" "" "";
    55613 "" "" "";
    55614 "" "" "";
    55618 "" "" "";
    55619 "" "" "";
    55622 "_EVMVNUM" "0" "";
    55623 "_EV" "k" "_EVMVNUM[0]";
    55624 "_EVMVNUM" "1" "";
    55625 "_MV" "k" "_EVMVNUM[1]";
    55628 "" "" "";
    55630 "" "" "";
    55631 "" "" "";
    55632 "_SPEED" "0" "";
    55634 "_SPEED" "1" "";
    55636 "_SPEED" "2" "";
    55637 "" "" "";
    55638 "" "" "";
    55640 "" "" "";
    55642 "" "" "";
    55644 "" "" "";
    55645 "" "" "-";
    55646 "" "" "-";
    55647 "" "" "";
    55648 "" "" "";
    55649 "" "" "-";
    55700 "" "" "";
    55730 "" "" "-";
    55740 "" "" "";
};

impl SettingDatum {
    /// The user datum with the same content, and its element.
    pub fn older(&self) -> Option<(&'static Gud, &'static Element)> {
        let [array, index] = self.older;
        let gud = gud::find(array)?;
        Some((gud, gud.elements.iter().find(|element| element.index == index)?))
    }

    /// Its name in words: `SD54600`, `MD51740`.
    pub fn name(&self) -> String {
        let sort = if self.number < SETTINGS { "MD" } else { "SD" };
        format!("{sort}{}", self.number)
    }

    /// That user datum in words: `_WP[k,0]`; empty: there is none.
    pub fn older_name(&self) -> String {
        let [array, index] = self.older;
        if array.is_empty() { String::new() } else { format!("{array}[{index}]") }
    }

    /// Key of its words: those of the user datum.
    pub fn key(&self) -> String {
        self.older()
            .map_or_else(|| format!("datum-{}", self.name().to_ascii_lowercase()), |(gud, element)| gud.key(element))
    }

    /// Places of its values on this machine: of each probe that it counts, or the single one; none of one that is only
    /// told.
    pub fn places(&self, control: &Control) -> Vec<Option<usize>> {
        if self.counted == TOLD {
            return Vec::new();
        }
        if self.counted.is_empty() {
            return vec![None];
        }
        (0..(control.number(self.counted) as usize).min(MOST)).map(Some).collect()
    }

    /// A value as the setup names it: `SD54600[0]`.
    pub fn spelled(&self, place: Option<usize>) -> String {
        place.map_or_else(|| self.name(), |probe| format!("{}[{probe}]", self.name()))
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

    // oracle: peer (published tables: MD51600 counts the fields of the workpiece probes, SD54621 is the plus edge of
    // the groove in the ordinate, SD55625 the mean values)
    #[test]
    fn counts_come_before_what_they_count() {
        let mut control = delivery(Dialect::Sinumerik);
        let probes = control.number("_CVAL[1]") as usize;
        control.set(GENERATION, 3.0);
        for (name, value) in [("MD51600", 5.0), ("SD54621[0]", 12.5), ("SD55625[3]", 0.01)] {
            control.set(name, value);
        }
        let last = format!("SD54600[{}]", 4);
        control.set(&last, 3.5);
        control.take_setting_data();
        assert!(probes < 5, "{probes}");
        for (name, value) in [("_CVAL[1]", 5.0), ("_WP[4,0]", 3.5), ("_KB[0,0]", 12.5), ("_MV[3]", 0.01)] {
            assert_eq!(control.number(name), value, "{name}");
        }
        let told = SETTING_DATA.iter().find(|datum| datum.number == 51_742).map(|datum| datum.places(&control));
        assert_eq!(told, Some(Vec::new()));
    }
}
