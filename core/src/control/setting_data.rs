//! Setting data, and machine data from 51600, in which the second and third generation of the control have what the
//! first has in user data, and some that only they have. Published tables tell numbers and contents; where these are
//! those of a user datum, its words and its limits count here too.

use super::gud::{self, Element, Gud, element};
use super::{Control, GENERATION, Value, arrays};

/// A setting datum, or one of the machine data.
pub struct SettingDatum {
    /// Its number.
    pub number: u32,
    /// Its name without what says whose it is (deathaxe/sublime-s840d a3b0677, `doc/en/{csd,cmd}{nck,chan}.mdat`).
    name: &'static str,
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
/// Fields of probes that these generations have, whatever the first one counts: the user datum that counts them, the
/// machine datum that does so here, and the most that a call can name (remedies of alarms 61313 and 61416, diagnostics
/// manual 03/2013, 6FC5398-8BP40-3KA1).
const PROBES: [(&str, &str, f64); 3] =
    [("_CVAL[0]", "MD51602", 6.0), ("_CVAL[1]", "MD51600", 12.0), ("_CVAL[3]", "MD51603", 6.0)];
/// The speeds, of which each generation has its own: the second has these elements of `_SPEED` in these data, the third
/// as in the table (remedies of alarms 61338 and 61339, the same manual).
const SPEEDS: &str = "_SPEED";
const SPEEDS_OF_SECOND: [(u32, &str); 3] = [(55_630, "0"), (55_631, "1"), (55_632, "2")];
const SECOND: f64 = 2.0;
/// The shape of a tool probe, which newer controls have in more ways: 2 head, 3 cube (deathaxe/sublime-s840d a3b0677,
/// `doc/en/csdnck.mdat`, SD 54633; SD 54648 is the same in the workpiece system).
static SHAPE: Element = element("k,8", "").choices(&[0, 2, 3, 101, 201, 301]);
const SHAPES: [u32; 2] = [54_633, 54_648];
/// Where setting data begin; below are machine data.
const SETTINGS: u32 = 54_000;

/// A row of the table: number, name, user datum and element of it, user datum that counts the probes.
macro_rules! data {
    ($($number:literal $name:literal $array:literal $index:literal $counted:literal;)*) => {
        &[$(SettingDatum { number: $number, name: $name, older: [$array, $index], counted: $counted }),*]
    };
}

/// In the order of the numbers.
pub const SETTING_DATA: &[SettingDatum] = data! {
    51600 "MEA_CAL_WP_NUM" "_CVAL" "1" "";
    51601 "MEA_CAL_EDGE_NUM" "_CVAL" "2" "";
    51602 "MEA_CAL_TP_NUM" "_CVAL" "0" "";
    51603 "MEA_CAL_TPW_NUM" "_CVAL" "3" "";
    51618 "MEA_CM_ROT_AX_POS_TOL" "" "" "";
    51740 "MEA_FUNCTION_MASK" "" "" "";
    51742 "MEA_ACCESS_EXEC" "" "" "-";
    51750 "J_MEA_M_DIST" "" "" "";
    51751 "J_MEA_M_DIST_MANUELL" "" "" "";
    51752 "J_MEA_M_DIST_TOOL_LENGTH" "" "" "";
    51753 "J_MEA_M_DIST_TOOL_RADIUS" "" "" "";
    51755 "J_MEA_MEASURING_FEED" "" "" "";
    51757 "J_MEA_COLL_MONIT_FEED" "" "" "";
    51758 "J_MEA_COLL_MONIT_POS_FEED" "" "" "";
    51770 "J_MEA_CAL_RING_DIAM" "" "" "-";
    51772 "J_MEA_CAL_HEIGHT_FEEDAX" "" "" "-";
    51780 "J_MEA_T_PROBE_DIAM_RAD" "" "" "-";
    51781 "MEA_T_PROBE_THICKNESS" "" "" "-";
    51784 "J_MEA_T_PROBE_APPR_AX_DIR" "" "" "-";
    51786 "J_MEA_T_PROBE_MEASURE_DIST" "" "" "";
    52740 "MEA_FUNCTION_MASK" "" "" "";
    52750 "J_MEA_FIXPOINT" "" "" "";
    52751 "J_MEA_MAGN_GLAS_POS" "" "" "-";
    52780 "J_MEA_T_PROBE_APPR_MODE" "" "" "";
    54600 "MEA_WP_BALL_DIAM" "_WP" "k,0" "_CVAL[1]";
    54601 "MEA_WP_TRIG_MINUS_DIR_AX1" "_WP" "k,1" "_CVAL[1]";
    54602 "MEA_WP_TRIG_PLUS_DIR_AX1" "_WP" "k,2" "_CVAL[1]";
    54603 "MEA_WP_TRIG_MINUS_DIR_AX2" "_WP" "k,3" "_CVAL[1]";
    54604 "MEA_WP_TRIG_PLUS_DIR_AX2" "_WP" "k,4" "_CVAL[1]";
    54605 "MEA_WP_TRIG_MINUS_DIR_AX3" "_WP" "k,5" "_CVAL[1]";
    54606 "MEA_WP_TRIG_PLUS_DIR_AX3" "_WP" "k,6" "_CVAL[1]";
    54607 "MEA_WP_POS_DEV_AX1" "_WP" "k,7" "_CVAL[1]";
    54608 "MEA_WP_POS_DEV_AX2" "_WP" "k,8" "_CVAL[1]";
    54609 "MEA_WP_STATUS_RT" "_WP" "k,9" "_CVAL[1]";
    54610 "MEA_WP_STATUS_GEN" "_WP" "k,10" "_CVAL[1]";
    54611 "MEA_WP_FEED" "" "" "_CVAL[1]";
    54612 "MEA_INPUT_PIECE_PROBE_SUB" "" "" "_CVAL[1]";
    54615 "MEA_CAL_EDGE_BASE_AX1" "_KB" "k,2" "_CVAL[2]";
    54617 "MEA_CAL_EDGE_PLUS_DIR_AX1" "_KB" "k,3" "_CVAL[2]";
    54618 "MEA_CAL_EDGE_MINUS_DIR_AX1" "_KB" "k,4" "_CVAL[2]";
    54619 "MEA_CAL_EDGE_BASE_AX2" "_KB" "k,6" "_CVAL[2]";
    54620 "MEA_CAL_EDGE_UPPER_AX2" "_KB" "k,5" "_CVAL[2]";
    54621 "MEA_CAL_EDGE_PLUS_DIR_AX2" "_KB" "k,0" "_CVAL[2]";
    54622 "MEA_CAL_EDGE_MINUS_DIR_AX2" "_KB" "k,1" "_CVAL[2]";
    54625 "MEA_TP_TRIG_MINUS_DIR_AX1" "_TP" "k,0" "_CVAL[0]";
    54626 "MEA_TP_TRIG_PLUS_DIR_AX1" "_TP" "k,1" "_CVAL[0]";
    54627 "MEA_TP_TRIG_MINUS_DIR_AX2" "_TP" "k,2" "_CVAL[0]";
    54628 "MEA_TP_TRIG_PLUS_DIR_AX2" "_TP" "k,3" "_CVAL[0]";
    54629 "MEA_TP_TRIG_MINUS_DIR_AX3" "_TP" "k,4" "_CVAL[0]";
    54630 "MEA_TP_TRIG_PLUS_DIR_AX3" "_TP" "k,5" "_CVAL[0]";
    54631 "MEA_TP_EDGE_DISK_SIZE" "_TP" "k,6" "_CVAL[0]";
    54632 "MEA_TP_AX_DIR_AUTO_CAL" "_TP" "k,7" "_CVAL[0]";
    54633 "MEA_TP_TYPE" "_TP" "k,8" "_CVAL[0]";
    54634 "MEA_TP_CAL_MEASURE_DEPTH" "_TP" "k,9" "_CVAL[0]";
    54635 "MEA_TP_STATUS_GEN" "" "" "_CVAL[0]";
    54636 "MEA_TP_FEED" "" "" "_CVAL[0]";
    54640 "MEA_TPW_TRIG_MINUS_DIR_AX1" "_TPW" "k,0" "_CVAL[3]";
    54641 "MEA_TPW_TRIG_PLUS_DIR_AX1" "_TPW" "k,1" "_CVAL[3]";
    54642 "MEA_TPW_TRIG_MINUS_DIR_AX2" "_TPW" "k,2" "_CVAL[3]";
    54643 "MEA_TPW_TRIG_PLUS_DIR_AX2" "_TPW" "k,3" "_CVAL[3]";
    54644 "MEA_TPW_TRIG_MINUS_DIR_AX3" "_TPW" "k,4" "_CVAL[3]";
    54645 "MEA_TPW_TRIG_PLUS_DIR_AX3" "_TPW" "k,5" "_CVAL[3]";
    54646 "MEA_TPW_EDGE_DISK_SIZE" "_TPW" "k,6" "_CVAL[3]";
    54647 "MEA_TPW_AX_DIR_AUTO_CAL" "_TPW" "k,7" "_CVAL[3]";
    54648 "MEA_TPW_TYPE" "_TPW" "k,8" "_CVAL[3]";
    54649 "MEA_TPW_CAL_MEASURE_DEPTH" "_TPW" "k,9" "_CVAL[3]";
    54650 "MEA_TPW_STATUS_GEN" "" "" "_CVAL[3]";
    54651 "MEA_TPW_FEED" "" "" "_CVAL[3]";
    54652 "MEA_INPUT_TOOL_PROBE_SUB" "" "" "_CVAL[3]";
    54670 "MEA_CM_MAX_PERI_SPEED" "_CM" "0" "";
    54671 "MEA_CM_MAX_REVOLUTIONS" "_CM" "1" "";
    54672 "MEA_CM_MAX_FEEDRATE" "_CM" "4" "";
    54673 "MEA_CM_MIN_FEEDRATE" "_CM" "2" "";
    54674 "MEA_CM_SPIND_ROT_DIR" "_CM" "5" "";
    54675 "MEA_CM_FEEDFACTOR_1" "_CM" "6" "";
    54676 "MEA_CM_FEEDFACTOR_2" "_CM" "7" "";
    54677 "MEA_CM_MEASURING_ACCURACY" "_CM" "3" "";
    54689 "MEA_T_PROBE_MANUFACTURER" "" "" "";
    54691 "MEA_T_PROBE_OFFSET" "" "" "";
    54692 "MEA_T_CIRCULAR_ARC_DIST" "" "" "";
    54693 "MEA_T_MAX_STEPS" "" "" "";
    54695 "MEA_RESULT_OFFSET_TAB_RAD1" "" "" "-";
    54696 "MEA_RESULT_OFFSET_TAB_RAD2" "" "" "-";
    54697 "MEA_RESULT_OFFSET_TAB_RAD3" "" "" "-";
    54698 "MEA_RESULT_OFFSET_TAB_RAD4" "" "" "-";
    54699 "MEA_RESULT_OFFSET_TAB_RAD5" "" "" "-";
    54700 "MEA_RESULT_OFFSET_TAB_RAD6" "" "" "-";
    54705 "MEA_RESULT_OFFSET_TAB_LEN1" "" "" "-";
    54706 "MEA_RESULT_OFFSET_TAB_LEN2" "" "" "-";
    54707 "MEA_RESULT_OFFSET_TAB_LEN3" "" "" "-";
    54708 "MEA_RESULT_OFFSET_TAB_LEN4" "" "" "-";
    54709 "MEA_RESULT_OFFSET_TAB_LEN5" "" "" "-";
    54710 "MEA_RESULT_OFFSET_TAB_LEN6" "" "" "-";
    54740 "MEA_FUNCTION_MASK" "" "" "";
    54750 "MEA_ALARM_MASK" "" "" "";
    54760 "MEA_FUNCTION_MASK_PIECE" "" "" "";
    54762 "MEA_FUNCTION_MASK_TOOL" "" "" "";
    54764 "MEA_FUNCTION_MASK_TURN" "" "" "";
    54780 "J_MEA_FUNCTION_MASK_PIECE" "" "" "";
    54782 "J_MEA_FUNCTION_MASK_TOOL" "" "" "";
    55613 "MEA_RESULT_DISPLAY" "" "" "";
    55614 "MEA_RESULT_MRD" "" "" "";
    55618 "MEA_SIM_ENABLE" "" "" "";
    55619 "MEA_SIM_MEASURE_DIFF" "" "" "";
    55622 "MEA_EMPIRIC_VALUE_NUM" "_EVMVNUM" "0" "";
    55623 "MEA_EMPIRIC_VALUE" "_EV" "k" "_EVMVNUM[0]";
    55624 "MEA_AVERAGE_VALUE_NUM" "_EVMVNUM" "1" "";
    55625 "MEA_AVERAGE_VALUE" "_MV" "k" "_EVMVNUM[1]";
    55628 "MEA_TP_FEED_MEASURE" "" "" "";
    55630 "MEA_FEED_MEASURE" "" "" "";
    55631 "MEA_FEED_MEASURE_DEG" "" "" "";
    55632 "MEA_FEED_RAPID_IN_PERCENT" "_SPEED" "0" "";
    55634 "MEA_FEED_PLANE_VALUE" "_SPEED" "1" "";
    55636 "MEA_FEED_FEEDAX_VALUE" "_SPEED" "2" "";
    55637 "MEA_FEED_POS_DEG" "" "" "";
    55638 "MEA_FEED_FAST_MEASURE" "" "" "";
    55640 "MEA_FEED_CIRCLE" "" "" "";
    55642 "MEA_EDGE_SAVE_ANG" "" "" "";
    55644 "MEA_KIN_DM_TOL" "" "" "";
    55645 "MEA_KIN_MODE" "" "" "-";
    55646 "MEA_KIN_VALUE" "" "" "-";
    55647 "MEA_KIN_MIN_ANG_TRIANGLE" "" "" "";
    55648 "MEA_KIN_MIN_ANG_POS" "" "" "";
    55649 "MEA_KIN_BALL_VEC" "" "" "-";
    55700 "MEA_SIMULTAN_LIMIT" "" "" "";
    55730 "MEA_PROTOCOL_USER_EXT" "" "" "-";
    55740 "MEA_FUNCTION_MASK" "" "" "";
};

impl SettingDatum {
    /// The user datum and the index of its element as this generation has it.
    fn of_first(&self, generation: f64) -> [&'static str; 2] {
        let second = SPEEDS_OF_SECOND.iter().find(|(number, _)| *number == self.number);
        match second {
            Some((_, index)) if generation == SECOND => [SPEEDS, index],
            None if self.is_other(generation) => [""; 2],
            _ => self.older,
        }
    }

    /// Whether this generation has the content in another datum: it is not known what this one is there.
    fn is_other(&self, generation: f64) -> bool {
        generation == SECOND && self.older[0] == SPEEDS && SPEEDS_OF_SECOND.iter().all(|(one, _)| *one != self.number)
    }

    /// The user datum with the same content on a control of this generation, and its element.
    pub fn older(&self, generation: f64) -> Option<(&'static Gud, &'static Element)> {
        let [array, index] = self.of_first(generation);
        let gud = gud::find(array)?;
        let element = gud.elements.iter().find(|element| element.index == index)?;
        Some((gud, if SHAPES.contains(&self.number) { &SHAPE } else { element }))
    }

    /// Its name in words: `SD54600`, `MD51740`.
    pub fn name(&self) -> String {
        let sort = if self.is_setting() { "SD" } else { "MD" };
        format!("{sort}{}", self.number)
    }

    /// Whether every channel has its own: from 52000 machine data, from 55000 setting data.
    pub fn of_channel(&self) -> bool {
        matches!(self.number, 52_000..SETTINGS | 55_000..)
    }

    /// Whether it is a setting datum; else it is a machine datum.
    pub fn is_setting(&self) -> bool {
        self.number >= SETTINGS
    }

    /// Its name in a program and in a file of the control: `$SNS_MEA_WP_BALL_DIAM`.
    pub fn identifier(&self) -> String {
        let sort = if self.is_setting() { "S" } else { "M" };
        let of = if self.of_channel() { "C" } else { "N" };
        format!("${sort}{of}S_{}", self.name)
    }

    /// The datum that has this name's content in this generation: of the speeds the second has other numbers, and what
    /// their numbers are in the third is none of its.
    fn in_generation(&self, generation: f64) -> Option<&'static SettingDatum> {
        let by_number = |number: u32| SETTING_DATA.iter().find(|one| one.number == number);
        if generation != SECOND {
            return by_number(self.number);
        }
        let [array, index] = self.older;
        match SPEEDS_OF_SECOND.iter().find(|(_, of)| array == SPEEDS && *of == index) {
            Some((number, _)) => by_number(*number),
            None => by_number(self.number).filter(|datum| datum.is_named(generation)),
        }
    }

    /// Whether its name is published for this generation: of the speeds of the second, numbers alone are.
    pub fn is_named(&self, generation: f64) -> bool {
        generation != SECOND || SPEEDS_OF_SECOND.iter().all(|(one, _)| *one != self.number)
    }

    /// That user datum of the newest generation in words: `_WP[k,0]`; empty: there is none.
    pub fn older_name(&self) -> String {
        let [array, index] = self.older;
        if array.is_empty() { String::new() } else { format!("{array}[{index}]") }
    }

    /// Key of its words on a control of this generation: those of the user datum.
    pub fn key(&self, generation: f64) -> String {
        let own = || format!("datum-{}", self.name().to_ascii_lowercase());
        self.older(generation).map_or_else(own, |(gud, element)| gud.key(element))
    }

    /// Places of its values on this machine: of each probe that it counts, or the single one; none of one that is only
    /// told, or that this generation has in another datum.
    pub fn places(&self, control: &Control) -> Vec<Option<usize>> {
        if self.counted == TOLD || self.is_other(control.number(GENERATION)) {
            return Vec::new();
        }
        if self.counted.is_empty() {
            return vec![None];
        }
        (0..(control.fields(self.counted) as usize).min(MOST)).map(Some).collect()
    }

    /// A value as the setup names it: `SD54600[0]`.
    pub fn spelled(&self, place: Option<usize>) -> String {
        place.map_or_else(|| self.name(), |probe| format!("{}[{probe}]", self.name()))
    }

    /// The place of the user datum with the same content on a control of this generation: `[0, 1]` of `_WP[0,1]`.
    pub fn older_place(&self, place: Option<usize>, generation: f64) -> Vec<usize> {
        let [_, index] = self.of_first(generation);
        index.split(',').filter_map(|part| if part == "k" { place } else { part.parse().ok() }).collect()
    }
}

/// The datum with this number (`54600`), name in words (`SD54600`) or identifier.
pub fn find(asked: &str) -> Option<&'static SettingDatum> {
    let asked = &*asked.replace(' ', "");
    let digits = |sort: &str| asked.get(..2).filter(|begin| begin.eq_ignore_ascii_case(sort)).and(asked.get(2..));
    let numbered = digits("SD").or_else(|| digits("MD"));
    if let Ok(number) = numbered.unwrap_or(asked).parse::<u32>() {
        let of_sort = |datum: &&SettingDatum| numbered.is_none() || datum.name().eq_ignore_ascii_case(asked);
        return SETTING_DATA.iter().find(|datum| datum.number == number).filter(of_sort);
    }
    SETTING_DATA.iter().find(|datum| datum.identifier().eq_ignore_ascii_case(asked))
}

impl Control {
    /// Whether its data are setting data, not user data.
    pub fn has_setting_data(&self) -> bool {
        self.number(GENERATION) > 1.0
    }

    /// How many fields there are of what this user datum counts: of probes, newer controls have data of their own.
    pub fn fields(&self, counter: &str) -> f64 {
        let own = PROBES.iter().find(|(user, ..)| *user == counter).filter(|_| self.has_setting_data());
        match own {
            Some((_, datum, most)) if !self.data.contains_key(datum) => *most,
            Some((.., most)) => self.number(counter).min(*most),
            None => self.number(counter),
        }
    }

    /// On a machine of the second or third generation the values of its setting data go where the first has them, as
    /// all that measures reads them there.
    pub fn take_setting_data(&mut self) {
        if !self.has_setting_data() {
            return;
        }
        for datum in SETTING_DATA {
            for place in datum.places(self) {
                if let Some((older, value)) = self.older_name(datum, place).zip(self.data.get(&datum.spelled(place))) {
                    let value = value.clone();
                    self.data.insert(older, value);
                }
            }
        }
    }

    /// The user datum in which a value of a setting datum is on this machine: `_WP[0,1]`.
    fn older_name(&self, datum: &SettingDatum, place: Option<usize>) -> Option<String> {
        let generation = self.number(GENERATION);
        datum.older(generation).map(|(gud, _)| gud.spelled(&datum.older_place(place, generation)))
    }

    /// The name that a program of this machine has for a user datum of the first generation whose value is in a setting
    /// datum: `$SNS_MEA_WP_BALL_DIAM[0]`; none: this machine has the user datum.
    pub fn setting_of(&self, older: &str) -> Option<String> {
        let of = |datum: &SettingDatum, place: &Option<usize>| self.older_name(datum, *place).as_deref() == Some(older);
        SETTING_DATA.iter().filter(|_| self.has_setting_data()).find_map(|datum| {
            let place = datum.places(self).into_iter().find(|place| of(datum, place))?;
            Some(datum.identifier() + &place.map_or(String::new(), |at| format!("[{at}]")))
        })
    }

    /// A setting datum by its identifier in a program, `$SNS_MEA_WP_BALL_DIAM[0]`: as the setup names it, and the user
    /// datum in which its value is on this machine. The outer option: whether it is one; the inner one: whether this
    /// machine has it with this index. A machine whose generation is not told has those of the newest.
    pub fn setting(&self, key: &str) -> Option<Option<(String, Option<String>)>> {
        if !is_of_program(key) {
            return None;
        }
        let (stem, index) = arrays::split(key)?;
        let named = SETTING_DATA.iter().find(|one| one.identifier() == stem)?;
        let generation = self.number(GENERATION);
        let place = index.first().copied();
        let there = named.in_generation(generation).filter(|datum| {
            index.len() < 2 && generation != 1.0 && (datum.counted == TOLD || datum.places(self).contains(&place))
        });
        Some(there.map(|datum| (datum.spelled(place), self.older_name(datum, place))))
    }

    /// The value that a setting datum has because the first generation has it in a user datum: `SD54600[0]`.
    pub fn setting_value(&self, name: &str) -> Option<&Value> {
        let (stem, index) = arrays::split(name).filter(|_| self.has_setting_data() && is_numbered(name))?;
        self.data.get(&self.older_name(find(stem)?, index.first().copied())?)
    }

    /// The first datum given to this machine that it does not have, and those of its number that it has.
    pub fn without_place(&self) -> Option<(String, Vec<String>)> {
        let given = self.data.iter().filter(|(name, _)| self.has_setting_data() && is_numbered(name));
        let mut absent = given.filter_map(|(name, _)| Some((name.clone(), self.instead_of(name)?)));
        let first = absent.next()?;
        Some(absent.fold(first, |first, one| if one.0 < first.0 { one } else { first }))
    }

    /// Those of the number of this datum that the machine has, where it is not one of them; none: it is, or it is no
    /// datum of the table.
    pub fn instead_of(&self, name: &str) -> Option<Vec<String>> {
        let datum = find(arrays::stem(name)).filter(|datum| is_numbered(name) && datum.counted != TOLD)?;
        let there: Vec<String> = datum.places(self).into_iter().map(|place| datum.spelled(place)).collect();
        (!there.iter().any(|one| one == name)).then_some(there)
    }
}

/// Whether a name is that of a datum with a number.
fn is_numbered(name: &str) -> bool {
    name.starts_with("SD") || name.starts_with("MD")
}

/// Whether newer controls have an element of a user datum in a setting or machine datum.
pub fn replaces(gud: &Gud, element: &Element, generation: f64) -> bool {
    let is = |(other, of): (&'static Gud, &'static Element)| other.name == gud.name && of.index == element.index;
    generation >= SECOND && SETTING_DATA.iter().filter_map(|datum| datum.older(generation)).any(is)
}

/// Whether a name in a program can be that of such a datum: `$SNS_…`, `$SCS_…`, `$MNS_…`, `$MCS_…`.
pub fn is_of_program(name: &str) -> bool {
    ["$SNS_", "$SCS_", "$MNS_", "$MCS_"].iter().any(|begin| name.starts_with(begin))
}

/// Whether newer controls have this array of the block of the machine builder in setting or machine data.
pub fn replaces_array(name: &str) -> bool {
    gud::find(name).is_some_and(|gud| gud.block == gud::Block::Gud6)
        && SETTING_DATA.iter().any(|datum| datum.older[0] == name)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::{OF_LISTS, delivery};
    use crate::dialect::Dialect;

    // oracle: peer (the published tables: SD 54600 has what _WP[k,0] has; the delivered machine counts its probes)
    #[test]
    fn a_user_datum_is_called_as_the_machine_has_it() {
        let mut control = delivery(Dialect::Sinumerik);
        assert_eq!(control.setting_of("_WP[0,0]"), None);
        control.set(GENERATION, OF_LISTS);
        assert_eq!(control.setting_of("_WP[0,0]").as_deref(), Some("$SNS_MEA_WP_BALL_DIAM[0]"));
        assert_eq!(control.setting_of("_OVR[0]"), None);
        for datum in SETTING_DATA {
            for place in datum.places(&control) {
                let Some(older) = control.older_name(datum, place) else { continue };
                let key = control.setting_of(&older).unwrap();
                assert_eq!(control.setting(&key).flatten().and_then(|(_, older)| older), Some(older), "{key}");
            }
        }
    }

    // oracle: self (the numbers are looked up by a reader; a user datum that is named exists)
    #[test]
    fn each_number_stands_once_and_names_a_user_datum_that_exists() {
        assert!(SETTING_DATA.is_sorted_by(|one, other| one.number < other.number));
        for datum in SETTING_DATA {
            assert_eq!(datum.older(OF_LISTS).is_none(), datum.older_name().is_empty(), "{}", datum.number);
        }
    }

    // oracle: peer (deathaxe/sublime-s840d a3b0677, SD 54633: 0, 101, 201, 301 as before, 2 head, 3 cube)
    #[test]
    fn the_shape_of_a_tool_probe_has_more_values_on_newer_controls() {
        for number in SHAPES {
            let (gud, element) = find(&number.to_string()).and_then(|datum| datum.older(OF_LISTS)).unwrap();
            for value in [0.0, 2.0, 3.0, 101.0, 201.0, 301.0] {
                assert!(element.takes(value), "{number} {value}");
            }
            assert!(!element.takes(1.0));
            let first = gud.elements.iter().find(|one| one.index == element.index).unwrap();
            assert!(!first.takes(2.0) && gud.key(first) == gud.key(element));
        }
    }

    // oracle: peer (the texts of the published tables name these themselves)
    #[test]
    fn each_datum_is_found_by_number_and_identifier() {
        for (name, identifier) in [
            ("MD51740", "$MNS_MEA_FUNCTION_MASK"),
            ("MD52740", "$MCS_MEA_FUNCTION_MASK"),
            ("SD54740", "$SNS_MEA_FUNCTION_MASK"),
            ("SD55740", "$SCS_MEA_FUNCTION_MASK"),
            ("SD54612", "$SNS_MEA_INPUT_PIECE_PROBE_SUB"),
            ("SD55636", "$SCS_MEA_FEED_FEEDAX_VALUE"),
        ] {
            let datum = find(name).map(SettingDatum::identifier);
            assert_eq!(datum.as_deref(), Some(identifier));
            assert_eq!(find(identifier).map(SettingDatum::name).as_deref(), Some(name));
        }
        for datum in SETTING_DATA {
            let found = find(&datum.identifier()).map(|found| found.number);
            assert_eq!(found, Some(datum.number), "{}", datum.name);
        }
    }

    // oracle: peer (published tables: the ball diameter in SD54600; remedies of 61338 and 61339: the second generation
    // has its speeds in SD55630 to SD55632, the third in SD55632, SD55634, SD55636); the first has them in user data
    #[test]
    fn a_newer_machine_measures_with_its_setting_data() {
        let speeds = |control: &Control| [0, 1, 2].map(|index| control.number(&format!("_SPEED[{index}]")));
        let delivered = speeds(&delivery(Dialect::Sinumerik));
        let second = ["SD55630", "SD55631", "SD55632"];
        let third = ["SD55632", "SD55634", "SD55636"];
        for (generation, names, ball) in [(0.0, third, 6.0), (1.0, third, 6.0), (2.0, second, 4.0), (3.0, third, 4.0)] {
            let mut control = delivery(Dialect::Sinumerik);
            control.set(GENERATION, generation);
            control.set("SD54600[1]", 4.0);
            for (name, value) in names.into_iter().zip([40.0, 700.0, 300.0]) {
                control.set(name, value);
            }
            control.take_setting_data();
            let wanted = if generation < 2.0 { delivered } else { [40.0, 700.0, 300.0] };
            assert_eq!((control.number("_WP[1,0]"), speeds(&control)), (ball, wanted), "{generation}");
            assert_eq!(control.without_place(), None);
            // a program names the content
            let plane = control.setting("$SCS_MEA_FEED_PLANE_VALUE").flatten();
            let wanted = (generation != 1.0).then(|| (names[1].to_owned(), Some("_SPEED[1]".to_owned())));
            assert_eq!(plane, wanted, "{generation}");
        }
    }

    // oracle: peer (remedies of 61313 and 61416: 12 workpiece and 6 tool probes)
    #[test]
    fn a_newer_machine_has_its_own_number_of_probes() {
        for (generation, counted, wanted) in [
            (1.0, None, [3.0, 3.0, 3.0]),
            (2.0, None, [12.0, 6.0, 6.0]),
            (3.0, None, [12.0, 6.0, 6.0]),
            (3.0, Some(2.0), [2.0, 2.0, 2.0]),
            (3.0, Some(30.0), [12.0, 6.0, 6.0]),
        ] {
            let mut control = delivery(Dialect::Sinumerik);
            control.set(GENERATION, generation);
            for name in ["MD51600", "MD51602", "MD51603"] {
                counted.into_iter().for_each(|count| control.set(name, count));
            }
            control.take_setting_data();
            let fields = ["_CVAL[1]", "_CVAL[0]", "_CVAL[3]"].map(|counter| control.fields(counter));
            assert_eq!(fields, wanted, "{generation} {counted:?}");
            let last = format!("SD54600[{}]", wanted[0] - 1.0);
            control.set(&last, 6.0);
            assert_eq!(control.without_place(), None, "{last}");
            let beyond = format!("SD54600[{}]", wanted[0]);
            control.set(&beyond, 6.0);
            let told = control.without_place().map(|(name, there)| (name, there.last().cloned()));
            assert_eq!(told, (generation > 1.0).then_some((beyond, Some(last))), "{generation}");
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
