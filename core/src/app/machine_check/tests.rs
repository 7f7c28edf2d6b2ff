#![allow(clippy::unwrap_used)]

use super::*;
use crate::control::needs::{GUD_VALUES, NEEDS, Need, Test, When};
use crate::words::Words;
use Severity::{Error, Note, Warning};
use fault::{spelled, written};
use proptest::prelude::*;

fn asked(text: &str) -> MachineCheckRequest {
    let file = ExportedFile { name: "INITIAL.INI".to_owned(), text: text.to_owned() };
    MachineCheckRequest { files: vec![file], without: Vec::new(), large: false, deflection: None }
}

fn check(text: &str) -> MachineCheckView {
    machine_check(asked(text)).unwrap()
}

/// Name, severity and alarm of each fault.
fn told(view: &MachineCheckView) -> Vec<(&str, Severity, &str)> {
    view.faults
        .iter()
        .map(|fault| {
            let alarm = fault.alarm.as_ref().map_or("", |alarm| alarm.key.strip_prefix("alarm-").unwrap_or(""));
            (fault.name.as_str(), fault.severity, alarm)
        })
        .collect()
}

// oracle: manual B:1149-1161 (m/s², no other unit is printed)
#[test]
fn the_unit_of_the_deceleration_is_told_on_a_control_in_inch() {
    let axis = "MD10050=0.002\nMD10070=2\nMD32200[X1]=1\nMD32300[X1]=1\n";
    let told = |text: String, deflection: Option<f64>| {
        let view = machine_check(MachineCheckRequest { deflection, ..asked(&text) }).unwrap();
        view.faults.iter().filter(|fault| fault.message.key == "machine-check-axis-metric").count()
    };
    assert_eq!(told(format!("{axis}MD10240=0"), Some(2.0)), 1);
    assert_eq!(told(format!("{axis}MD10240=0"), None), 0);
    assert_eq!(told(format!("{axis}MD10240=1"), Some(2.0)), 0);
}

// oracle: hand (the same values, as one repeated and as a list), manual A:15891 (61349: the depth is 0)
#[test]
fn repeated_values_are_checked_like_a_list() {
    let repeated = "DEF NCK INT _CVAL[4]=REP(1)\nDEF NCK REAL _TP[2,10]=REP(0)\nDEF NCK BOOL _CBIT[17]=REP(1)";
    let bits = vec!["1"; 17].join(",");
    let list = format!("DEF NCK INT _CVAL[4]=(1,1,1,1)\nDEF NCK REAL _TP[2,10]=(0)\nDEF NCK BOOL _CBIT[17]=({bits})");
    let [repeated, list] = [check(repeated), check(&list)];
    assert_eq!(told(&repeated), told(&list));
    let alarms: Vec<&str> = told(&repeated).into_iter().map(|(.., alarm)| alarm).collect();
    assert!(alarms.contains(&"61349") && alarms.contains(&"61416"), "{alarms:?}");
    assert_eq!(told(&check("DEF NCK INT _CVAL[2+2]=(1,1,1,1)")), [("_CVAL", Error, "")]);
}

// oracle: manual B:12971 and B:16183 (20 names, 30 names), B:16186 and A:14245 (70, 80), B:16187 and A:14251 (600,
// 800), B:16189 and A:14263 (14, 16; 27, 29 on an NCU 3)
#[test]
fn two_figures_of_the_manual_are_two_limits_with_both_places() {
    for (number, error, warning, enough) in
        [("MD18120", 19, 20, 30), ("MD18170", 69, 70, 80), ("MD18180", 599, 600, 800), ("MD28040", 13, 14, 16)]
    {
        let severity = |value: i32| check(&format!("{number}={value}")).faults.first().map(|fault| fault.severity);
        assert_eq!(severity(error), Some(Error), "{number}");
        assert_eq!(severity(warning), Some(Warning), "{number}");
        assert_eq!(severity(enough), None, "{number}");
        let view = check(&format!("{number}={error}"));
        let values: Vec<String> = view.faults[0].limits.iter().map(|limit| limit.value.clone()).collect();
        assert_eq!(values, [warning.to_string(), enough.to_string()]);
        assert!(view.faults[0].limits.iter().all(|limit| !limit.source.to_string().is_empty()));
        assert_eq!(view.faults[0].delivered.len(), 2);
    }
    let mut large = asked("MD28040=27");
    assert_eq!(told(&machine_check(large.clone()).unwrap()), []);
    large.large = true;
    assert_eq!(told(&machine_check(large).unwrap()), [("MD28040", Warning, "")]);
}

// oracle: manual B:12920-12927 (7 are needed, 9 there can be), B:1149-1161 (the path follows from them), hand
#[test]
fn what_no_control_has_is_told() {
    for (text, faults) in [
        ("MD18118=7\nMD32300[X1]=1", 0),
        ("MD18118=12", 1),
        ("MD18118=6", 1),
        ("N18130 $MN_MM_NUM_GUD_NAMES_NCK=30", 1),
        ("MD18120=99999999999999999999", 1),
        ("MD 18120 = 32,5", 1),
        ("MD32300[X1]=-1\nMD32200[X1]=0", 2),
        ("MD32300[X1]=0\nMD32200[X1]=-1\nMD10050=0\nMD10070=-1", 4),
    ] {
        assert_eq!(check(text).faults.len(), faults, "{text}: {:?}", check(text).faults);
    }
    let axis = "MD10050=0.004\nMD10070=3\nMD32200[X1]=1\nMD32300[X1]=";
    assert!(check(&format!("{axis}1")).axis.is_some());
    assert!(check(&format!("{axis}0")).axis.is_none());
    for wrong in [0.0, -2.0, f64::NAN] {
        let asked = MachineCheckRequest { deflection: Some(wrong), ..asked(axis) };
        assert_eq!(machine_check(asked).unwrap_err().message.key, "braking-value");
    }
}

// oracle: manual B:12971-12974 (7 KB, 4 KB a channel, 0.5 KB a channel with JOG; the sum of the example is 16)
#[test]
fn memory_is_needed_by_the_control_and_by_each_channel() {
    let two = |value: &str| format!("CHANDATA(1)\n_CHBIT[4]=0\nCHANDATA(2)\n_CHBIT[4]=0\nMD18150={value}");
    assert_eq!(told(&check(&two("15.9"))), [("MD18150", Error, "")]);
    assert_eq!(told(&check(&two("16"))), [("MD18150", Warning, "")]);
    assert_eq!(told(&check(&two("28"))), []);
    let mut without = asked(&two("15"));
    without.without = vec![Use::Jog];
    assert_eq!(told(&machine_check(without).unwrap()), [("MD18150", Warning, "")]);
}

// oracle: manual B:12973, A:14205 (30 names more for JOG), B:14067-14151 (what only JOG needs)
#[test]
fn what_is_not_used_needs_nothing() {
    let text = "MD18130=60\nMD11602=0\nMD20110=0\nMD11420=1\n_TP[0,9]=0\nE_MESS_MT_DL[0]=0";
    let names = |without: &[Use]| {
        let view = machine_check(MachineCheckRequest { without: without.to_vec(), ..asked(text) }).unwrap();
        view.faults.iter().map(|fault| (fault.name.clone(), fault.severity)).collect::<Vec<_>>()
    };
    let all = names(&[]);
    assert_eq!(all.len(), 6, "{all:?}");
    let least = names(&[Use::Jog, Use::Log, Use::ToolProbe]);
    assert_eq!(least, [("MD18130".to_owned(), Warning)]);
}

// oracle: manual B:12976-12983, A:15840 (bit 5), B:14099-14110 (4045H), B:14112-14119 (bit 6), B:14121-14127 (with
// tool management only)
#[test]
fn masks_are_told_by_their_bits() {
    let view = check("N28082 $MC_MM_SYSTEM_FRAME_MASK='H1'");
    assert_eq!(told(&view), [("MD28082", Error, "61016")]);
    assert_eq!(view.faults[0].message.word("bits"), Some("5"));
    assert_eq!(view.changes, "N28082 $MC_MM_SYSTEM_FRAME_MASK='H21'\n");
    let none = check("CHANDATA(2)\nMD28082=0");
    assert_eq!(none.changes, "CHANDATA(2)\nN28082 $MC_MM_SYSTEM_FRAME_MASK='H21'\n");
    let reset = check("MD20110='H41'\nMD20112='H440'");
    assert_eq!(reset.faults[0].message.word("bits"), Some("2, 14"));
    assert_eq!(reset.faults[1].message.word("bits"), Some("6"));
    assert_eq!(reset.changes, "N20110 $MC_RESET_MODE_MASK='H4045'\nN20112 $MC_START_MODE_MASK='H400'\n");
    assert_eq!(told(&check("MD20310=0")), []);
    assert_eq!(told(&check("MD20310=1")), [("MD20310", Error, "")]);
    // bit 0 of MD28082 is set by a line to change
    assert_eq!(told(&check("MD24006=0\nMD28082=32")), [("MD24006", Error, ""), ("MD28082", Warning, "")]);
    assert_eq!(told(&check("MD24006=0")), []);
}

// oracle: manual, at each row of the table in `user.rs`; the alarms A:15840-15948
#[test]
fn user_data_are_held_against_each_other() {
    for (text, name, severity, alarm) in [
        ("_CVAL[0]=3\nDEF NCK REAL _TP[1,10]=(0,0,0,0,0,0,20,133,0,2)", "_CVAL[0]", Error, "61416"),
        ("_CVAL[1]=3\nDEF NCK REAL _WP[1,11]=(6)", "_CVAL[1]", Error, "61416"),
        ("DEF NCK INT _CVAL[4]=(3,3,0,3)\n;N111 DEF NCK REAL _TPW[3,10]", "_CVAL[3]", Error, "61416"),
        ("_CVAL[2]=3\nN13 ;DEF NCK REAL _KB[3,7]", "_CVAL[2]", Error, "61416"),
        ("DEF NCK REAL _MFS[6]=(0,20)\n_CBIT[12]=1", "_MFS[0]", Error, "61350"),
        ("E_MESS_MT_DL[4]=0", "E_MESS_MT_DL[4]", Error, "61230"),
        ("DEF CHAN REAL _SPEED[4]=(50,1000,1000)", "_SPEED[3]", Error, ""),
        ("DEF NCK INT _CVAL[4]=(3,3,1,3)\nDEF NCK REAL _KB[3,7]", "_CVAL[2]", Error, "61416"),
        ("_EVMVNUM[0]=20\nDEF CHAN REAL _EV[10]", "_EVMVNUM[0]", Error, ""),
        ("DEF NCK REAL _KB[3,10]", "_KB", Error, ""),
        ("MD10240=1\n_CBIT[3]=0", "_CBIT[3]", Error, ""),
        ("MD10240=0\n_CHBIT[24]=1", "_CHBIT[24]", Error, ""),
        ("_SPEED[1]=0", "_SPEED[1]", Error, "61338"),
        ("_SPEED[0]=-1", "_SPEED[0]", Error, "61339"),
        ("_CM[5]=0", "_CM[5]", Error, "61366"),
        ("_CBIT[12]=1\n_MFS[1]=0", "_MFS[1]", Error, "61350"),
        ("_SPEED[0]=120", "_SPEED[0]", Error, ""), // 61339 is for a negative one alone (A:15880)
        ("_SPEED[2]=-1", "_SPEED[2]", Error, "61338"),
        ("_CBIT[12]=1\n_MFS[0]=-5", "_MFS[0]", Error, "61350"),
        ("_MFS[0]=-5", "_MFS[0]", Error, ""),
        ("_TP[0,9]=-1", "_TP[0,9]", Error, "61349"),
        ("_TPW[2,9]=-1", "_TPW[2,9]", Error, "61349"),
        ("_TP[0,6]=-1", "_TP[0,6]", Error, ""),
        ("E_MESS_MT_DL[0]=-1", "E_MESS_MT_DL[0]", Error, "61230"),
        ("DEF CHAN REAL E_MESS_MT_DR[5]=SET(1,1,1,1,-1)", "E_MESS_MT_DR[4]", Error, "61230"),
        ("_CVAL[2]=2.5", "_CVAL[2]", Error, ""),
        ("_CVAL[2]=100", "_CVAL[2]", Error, ""),
        ("_TP[0,8]=102", "_TP[0,8]", Error, "61309"),
        ("_TPW[0,9]=0", "_TPW[0,9]", Error, "61349"),
        ("_TP[0,7]=143", "_TP[0,7]", Warning, ""),
        ("_TP[0,6]=0", "_TP[0,6]", Warning, ""),
        ("_CVAL[1]=1\nDEF NCK REAL _WP[1,11]=(0,0,0,0,0,0,0,0,0,0,0)", "_WP[0,0]", Warning, "61341"),
        ("_CHBIT[10]=1\n_CHBIT[11]=1\n_CHBIT[18]=1", "_CHBIT[18]", Warning, ""),
        ("_CBIT[0]=0\n_CBIT[1]=1", "_CBIT[1]", Note, ""),
        ("_CHBIT[16]=1\n_CHBIT[2]=0", "_CHBIT[16]", Note, ""),
        ("_CBIT[13]=1", "_CBIT[13]", Warning, ""),
        ("_SI[1]=\"2\"", "_SI[1]", Error, "61342"),
        ("_MT_COMP=1\n_TP_CF=0", "_MT_COMP", Warning, ""),
        ("_MT_COMP=2", "_MT_COMP", Warning, ""),
        ("_PROTFORM[1]=201", "_PROTFORM[1]", Error, "62310"),
        ("_PROTFORM[4]=5", "_PROTFORM[4]", Error, "61363"),
        ("DEF NCK STRING[100] _PROTVAL[13]=(\"\",\"\",\"\",\"\",\"\",\"\")", "_PROTVAL[0]", Error, "61370"),
        ("E_MESS_MT_DR[2]=0", "E_MESS_MT_DR[2]", Error, "61230"),
        ("_CHBIT[0]=1\nE_MESS_MS_IN=0", "_CHBIT[0]", Warning, ""),
        ("_CVAL[1]=1\n_JM_I[1]=2", "_JM_I[1]", Error, "61313"),
        ("_CVAL[1]=0\n_JM_I[1]=-1", "_JM_I[1]", Error, ""),
        ("_MC_SIMSIM=0", "_MC_SIMSIM", Note, ""),
        ("_CVAL[1]=3\nDEF CHAN REAL _MC_MTL[2]=(33.3,33.3)", "_MC_MTL", Note, ""),
    ] {
        assert_eq!(told(&check(text)), [(name, severity, alarm)], "{text}");
    }
    // what they need is there
    for text in ["_SPEED[1]=0\n_CHBIT[2]=0", "_CM[5]=0\n_CBIT[12]=1", "_CHBIT[10]=1\n_CHBIT[11]=0\n_CHBIT[18]=1"] {
        assert_eq!(told(&check(text)), [], "{text}");
    }
    // two causes are two faults; an array without a list has them all
    let both = check("_CHBIT[10]=0\n_CHBIT[11]=1\n_CHBIT[18]=1");
    assert_eq!(told(&both), [("_CHBIT[18]", Warning, ""); 2]);
    assert_ne!(both.faults[0].message, both.faults[1].message);
    let sizes = check("DEF CHAN REAL E_MESS_MT_DL[3]\nDEF CHAN REAL E_MESS_MT_DR[3]");
    assert_eq!(told(&sizes).iter().filter(|one| one.2 == "61230").count(), 6);
    // what a comment took away may be defined by the line of another file
    for text in [";DEF NCK REAL _KB[3,7]\n_CVAL[2]=3\nDEF NCK REAL _KB[3,7]", "_CVAL[2]=0\n;DEF NCK REAL _KB[3,7]"] {
        assert_eq!(told(&check(text)), [], "{text}");
    }
    let two = check("MD10240=1\nCHANDATA(1)\n_CHBIT[24]=1\nCHANDATA(2)\n_CHBIT[24]=0");
    assert_eq!(two.faults.iter().map(|fault| fault.channel).collect::<Vec<_>>(), [Some(2)]);
    assert_eq!(two.changes, "CHANDATA(2)\n_CHBIT[24]=1\n");
}

// oracle: hand (nothing says which value is right: what 0 is for, how many fields there are, what calibration writes)
#[test]
fn no_line_is_made_up_where_no_right_value_is_known() {
    for text in [
        "E_MESS_MT_DR[0]=-1",
        "E_MESS_MT_DL[0]=-1",
        "_CBIT[12]=1\n_MFS[0]=-5",
        "_MFS[4]=-5",
        "_TP[0,6]=-1",
        "_CVAL[2]=100",
        "_CVAL[2]=2.5",
        "_EVMVNUM[0]=-1",
        "_WP[0,0]=-1",
        "_CVAL[1]=0\n_JM_I[1]=1",
        "_CVAL[1]=0\n_JM_I[1]=-1",
        "DEF NCK REAL _WP[120,11]\n_CVAL[1]=3",
        "MD10240=2\n_CBIT[3]=1",
    ] {
        assert_eq!(check(text).changes, "", "{text}");
    }
    for (text, changes) in [("_TP[0,9]=-1", "_TP[0,9]=2\n"), ("_JM_I[1]=-1", "_JM_I[1]=1\n")] {
        assert_eq!(check(text).changes, changes, "{text}");
    }
}

// oracle: manual B:13807-13821 (four sizes and five speeds, each from small to large, of both tables)
#[test]
fn a_correction_table_has_sizes_and_speeds_in_ascending_order() {
    let table = |name: &str, speeds: [u32; 5]| {
        let sizes = (1..=4).map(|i| format!("{name}[0,{i}]={i}\n"));
        sizes.chain((1..).zip(speeds).map(|(i, speed)| format!("{name}[{i},0]={speed}\n"))).collect::<String>()
    };
    let told = |text: &str| {
        let view = check(&format!("_MT_COMP=2\n{text}"));
        view.faults.iter().filter_map(|fault| fault.message.word("tables").map(str::to_owned)).collect::<Vec<_>>()
    };
    let [right, falling] = [[1, 2, 3, 4, 5], [5, 4, 3, 2, 1]];
    let [in_plane, lengths] = ["_MT_EC_R", "_MT_EC_L"];
    assert_eq!(told(&(table(in_plane, right) + &table(lengths, right))), [""; 0]);
    assert_eq!(told(&(table(in_plane, falling) + &table(lengths, right))), ["_MT_EC_R"]);
    assert_eq!(told(&(table(in_plane, right) + "DEF CHAN REAL _MT_EC_L[6,5]")), ["_MT_EC_L"]);
    assert_eq!(told(&table(lengths, [0, 1, 2, 3, 4])), ["_MT_EC_R, _MT_EC_L"]);
    assert_eq!(told(&(table(in_plane, right) + &table(lengths, right) + "_MT_EC_R[0,3]=9")), ["_MT_EC_R"]);
}

// oracle: manual B:13726-13734, B:13539-13565, B:14084-14093 (sizes), hand
#[test]
fn elements_that_no_array_has_are_told_and_not_compared() {
    for (text, name, read) in [
        ("_CBIT[99]=1", "_CBIT[99]", 0),
        ("_SPEED[9]=5", "_SPEED[9]", 0),
        ("_TP[50,1]=3\n_CVAL[0]=3", "_TP[50,1]", 1),
        ("_TP[2,1]=3\n_CVAL[0]=3", "", 2),
        ("DEF NCK REAL _TP[2,10]=(0,0,0,0,0,0,8,133,0,2,0,0,0,0,0,0,8,133,0,2)\n_TP[2,1]=3", "_TP[2,1]", 20),
        ("DEF NCK BOOL _CBIT[17]\n_CBIT[17]=0", "_CBIT[17]", 0),
        ("_TP[5]=3", "_TP[5]", 0),
        ("_DIGIT[0]=3", "_DIGIT[0]", 0),
        (";DEF NCK REAL _KB[3,7]\n_KB[0,0]=1", "_KB[0,0]", 0),
        ("MD20050[7]=0", "MD20050[7]", 0),
        ("MD13200[2]=1", "MD13200[2]", 0),
        ("E_MESS_MT_DZ[5]=2", "", 1),
    ] {
        let view = check(text);
        let names: Vec<&str> = view.faults.iter().map(|fault| fault.name.as_str()).collect();
        assert_eq!((names.first().copied().unwrap_or(""), names.len() < 2, view.read), (name, true, read), "{text}");
        assert!(view.faults.iter().all(|fault| fault.severity == Error && fault.change.is_empty()), "{text}");
    }
}

// oracle: hand (a text is no number and a number no text, each is told once)
#[test]
fn texts_and_numbers_are_not_mixed() {
    for (text, name, key) in [
        ("_SPEED[1]=\"abc\"", "_SPEED[1]", "machine-check-text"),
        ("_CBIT[13]=\"1\"", "_CBIT[13]", "machine-check-text"),
        ("_TP[0,9]=\"0\"", "_TP[0,9]", "machine-check-text"),
        ("DEF CHAN REAL _SPEED[4]=(50,\"a\",1000,900)", "_SPEED", "machine-check-text"),
        ("N18118 $MN_MM_NUM_GUD_MODULES=\"seven\"", "MD18118", "machine-check-text"),
        ("N54600 $SNS_MEA_WP_BALL_DIAM[0]=\"6\"", "SD54600[0]", "machine-check-text"),
        ("_SI[1]=6", "_SI[1]", "machine-check-number"),
        ("MD20060[0]=1", "MD20060[0]", "machine-check-number"),
    ] {
        let view = check(text);
        let told: Vec<(&str, &str)> =
            view.faults.iter().map(|fault| (fault.name.as_str(), fault.message.key.as_ref())).collect();
        assert_eq!((told, view.read, view.changes.as_str()), (vec![(name, key)], 0, ""), "{text}");
    }
    assert_eq!(told(&check("_PROTSYM[0]=59\n_PROTSYM[1]=\"#\"\n_PROTNAME[0]=\"A\"")), []);
}

// oracle: manual B:12971-12974 (7 KB, 4 KB a channel, 0.5 KB a channel with JOG): a channel of which no datum is known
// needs them too
#[test]
fn each_channel_of_the_export_needs_memory() {
    let second = "N18150 $MN_MM_GUD_VALUES_MEM=15\nCHANDATA(1)\nN20050 $MC_AXCONF_GEOAX_ASSIGN_TAB[2]=3\nCHANDATA(2)\n";
    for (text, limit) in [("N20070 $MC_AXCONF_MACHAX_USED[0]=1", "16"), ("", "11.5")] {
        let view = check(&format!("{second}{text}"));
        assert_eq!(view.faults[0].limits[0].value, limit, "{text}");
        assert_eq!(view.faults[0].severity == Error, limit == "16", "{text}");
    }
}

// oracle: manual A:15878 (61336), B:14084-14093 (which geometry axes there are)
#[test]
fn a_geometry_axis_that_is_used_has_a_name() {
    let name = |index: u32, name: &str| format!("N20060 $MC_AXCONF_GEOAX_NAME_TAB[{index}]=\"{name}\"\n");
    assert_eq!(told(&check(&name(0, ""))), [("MD20060[0]", Error, "61336")]);
    assert_eq!(told(&check(&(name(0, "X") + &name(1, " ")))), [("MD20060[1]", Error, "61336")]);
    assert_eq!(told(&check(&name(0, "X"))), []);
    let lathe = format!("{}MD20050=(1,0,2)", name(1, ""));
    let view = machine_check(MachineCheckRequest { without: vec![Use::Jog], ..asked(&lathe) }).unwrap();
    assert_eq!(told(&view), []);
}

// oracle: self (a machine datum counts as compared only if some value of it is told)
#[test]
fn only_what_is_held_against_something_counts_as_compared() {
    let others =
        ["_CBIT[3]=1", "E_MESS_FM=300", "MD10050=1", "MD10070=1", "MD32300[X1]=1", "MD32200[X1]=1", "MD28082=33"];
    for datum in crate::control::machine_data::MACHINE_DATA {
        let axis = ["MD32200", "MD32300"].contains(&datum.number);
        let name = match (axis, datum.elements > 0 || datum.number == "MD20060") {
            (true, _) => format!("{}[X1]", datum.number),
            (_, true) => format!("{}[0]", datum.number),
            _ => datum.number.to_owned(),
        };
        let values: &[&str] = if datum.text { &["\"\""] } else { &["-1", "0", "1", "2", "1000000"] };
        let own = others.into_iter().filter(|line| !line.starts_with(&name)).collect::<Vec<_>>().join("\n");
        let check = |line: String| {
            let asked = asked(&format!("{own}\n{line}"));
            machine_check(MachineCheckRequest { deflection: Some(1e9), ..asked }).unwrap()
        };
        let without = check(String::new());
        let each: Vec<MachineCheckView> = values.iter().map(|value| check(format!("{name}={value}"))).collect();
        let told = each.iter().any(|view| view.faults.iter().any(|fault| !without.faults.contains(fault)));
        assert!(each.iter().all(|view| view.read == without.read + usize::from(told)), "{name}");
    }
    let others = check("MD18118=7\nN20080 $MC_A[0]=\"X\"\nN30300 $MA_IS_ROT_AX[AX4]=1\nSD54600[0]=6\nMD18102=0");
    assert_eq!((others.read, others.ending.word("others")), (1, None));
    let counted = Message::new("machine-check-ending").number("read", 1.0).number("others", 4.0);
    assert_eq!(others.ending, counted.number("errors", 0.0).number("warnings", 0.0).number("notes", 0.0));
}

// oracle: manual B:12948-12974 (what MD18150 has to be follows from the channels, so a limit is always there)
#[test]
fn what_is_missing_is_named_with_the_memory_for_values() {
    let missing = |without: &[Use]| {
        machine_check(MachineCheckRequest { without: without.to_vec(), ..asked("MD18118=7") }).unwrap().missing
    };
    let has = |names: Vec<String>, name: &str| names.iter().any(|one| one.starts_with(name));
    assert!(has(missing(&[]), "MD18150") && has(missing(&[Use::Jog]), "MD18150"));
    assert!(has(missing(&[]), "MD11602") && !has(missing(&[Use::Jog]), "MD11602"));
    assert!(!has(missing(&[]), "MD18118"));
}

// oracle: manual B:1149-1161 (of the axes that take part the lowest values; m/s² are those of a linear axis), A:15872
// (MD30300: rotary axis); hand: 0.02 + 0.0125 + 0.3 mm at 300 mm/min with 1 m/s² and 1 (m/min)/mm, 1.6 mm with the
// other
#[test]
fn a_rotary_axis_is_no_slowest_axis() {
    let linear = "N32300 $MA_MAX_AX_ACCEL[X1]=1\nN32200 $MA_POSCTRL_GAIN[0,X1]=1\n";
    let rotary = "N32300 $MA_MAX_AX_ACCEL[AX4]=0.1\nN32200 $MA_POSCTRL_GAIN[0,AX4]=0.2\n";
    let clock = "MD10050=0.004\nMD10070=1\nE_MESS_FM=300\n";
    let with = |text: String| machine_check(MachineCheckRequest { deflection: Some(1.0), ..asked(&text) }).unwrap();
    let sort = |rotary: u32| format!("N30300 $MA_IS_ROT_AX[AX4]={rotary}\n");
    let view = with(format!("{clock}{linear}{rotary}{}", sort(1)));
    assert_eq!((view.axis.map(|axis| (axis.acceleration, axis.gain)), told(&view)), (Some((1.0, 1.0)), vec![]));
    let told_of = |text: String| told(&with(text)).into_iter().map(|(name, ..)| name.to_owned()).collect::<Vec<_>>();
    assert_eq!(told_of(format!("{clock}{linear}{rotary}{}", sort(0))), ["E_MESS_FM"]);
    assert_eq!(told_of(format!("{clock}{linear}{rotary}")), ["E_MESS_FM"]);
    // of rotary axes alone nothing follows
    let alone = with(format!("{clock}{rotary}{}", sort(1)));
    assert_eq!((alone.axis, alone.faults[0].message.key.as_ref()), (None, "machine-check-no-axis"));
    assert!(alone.missing.contains(&"MD32300 MAX_AX_ACCEL".to_owned()), "{:?}", alone.missing);
}

// oracle: manual B:12976-12983 (bits 0 and 5): whichever line is followed, the datum is right
#[test]
fn a_datum_has_one_line_with_all_its_bits() {
    let view = check("MD28082=0");
    let lines: Vec<&str> = view.faults.iter().map(|fault| fault.change.as_str()).collect();
    assert_eq!(lines, ["N28082 $MC_MM_SYSTEM_FRAME_MASK='H21'"; 2]);
    assert_eq!(view.changes, "N28082 $MC_MM_SYSTEM_FRAME_MASK='H21'\n");
    // what is no mask has no bits
    for text in ["MD20112=-1", "MD28082=33.5", "MD20112=0.5"] {
        assert!(check(text).faults.iter().any(|fault| fault.severity == Error), "{text}");
    }
}

// oracle: hand (a program compares, its block numbers are those of no machine datum)
#[test]
fn a_program_gives_only_what_it_assigns() {
    let program = "N10 IF _CHBIT[2]==0 GOTOF A\nN20 IF (_CBIT[0]==TRUE) AND _SPEED[1]>=1000\nN20050 R1=0\n\
                   N30 WHILE 18118 == 7\nN40 _CHBIT[16]=1\nN50 A: E_MESS_RETT=CTRANS(X,1):CROT(Z,5)\nM2\n";
    let view = check(program);
    assert_eq!((told(&view), view.read), (vec![], 1));
}

// oracle: manual B:14084-14093 (1, 2, 3; two geometry axes are no axis twice)
#[test]
fn a_missing_geometry_axis_gets_its_own_number() {
    for (text, changes) in [
        (
            "MD20050=(0,0,0)",
            "N20050 $MC_AXCONF_GEOAX_ASSIGN_TAB[0]=1\nN20050 $MC_AXCONF_GEOAX_ASSIGN_TAB[1]=2\n\
             N20050 $MC_AXCONF_GEOAX_ASSIGN_TAB[2]=3\n",
        ),
        ("MD20050=(1,0,0)", "N20050 $MC_AXCONF_GEOAX_ASSIGN_TAB[1]=2\nN20050 $MC_AXCONF_GEOAX_ASSIGN_TAB[2]=3\n"),
        ("MD20050=(1,0,2)", ""),
        ("MD20050=(1,3,0)", ""),
    ] {
        let view = check(text);
        assert!(view.faults.iter().all(|fault| fault.severity == Error) && !view.faults.is_empty(), "{text}");
        assert_eq!(view.changes, changes, "{text}");
    }
}

// oracle: manual B:13023, B:12971 (the two figures), hand (the control knows the name that it exported)
#[test]
fn a_line_to_change_has_the_name_of_the_export() {
    let change = |text: &str| check(text).changes;
    assert_eq!(change("N28040 $MC_MM_LUD_VALUES_MEM=12"), "N28040 $MC_MM_LUD_VALUES_MEM=16\n");
    assert_eq!(change("$MN_MM_NUM_GUD_NAMES_NCK=12"), "$MN_MM_NUM_GUD_NAMES_NCK=30\n");
    assert_eq!(change("MD28040=12"), "N28040 $MC_MM_NUM_LUD_VALUES_MEM=16\n");
    assert_eq!(change("N18130 $MN_MM_NUM_GUD_NAMES_NCK=15"), "$MN_MM_NUM_GUD_NAMES_NCK=30\n");
}

// oracle: manual B:12971-12972 and B:12931-12946 (20 and 60 are enough, 30 and 100 recommended)
#[test]
fn what_is_only_recommended_prevents_nothing() {
    let effect = |text: &str, without: &[Use]| {
        let view = machine_check(MachineCheckRequest { without: without.to_vec(), ..asked(text) }).unwrap();
        view.faults[0].effect.as_ref().map(|effect| effect.key.to_string())
    };
    for (text, key) in [
        ("MD18120=29", "machine-need-reserve"),
        ("MD18120=19", "machine-need-gud"),
        ("MD18150=12", "machine-need-reserve"),
        ("MD18130=60", "machine-need-reserve"),
        ("MD11420=1", "machine-need-log-file"),
        ("MD28082=32", "machine-need-basic-frame"),
    ] {
        assert_eq!(effect(text, &[Use::Jog]).as_deref(), Some(key), "{text}");
    }
}

// oracle: hand (what no channel is said of is seen by each, and a line behind CHANDATA is that channel's)
#[test]
fn each_channel_gets_its_own_lines() {
    let files = [("A.TEA", "CHANDATA(1)\nMD28020=200\nCHANDATA(2)\nMD28020=200"), ("B.DEF", "_SPEED[1]=0\n_CBIT[3]=0")];
    let files = files.map(|(name, text)| ExportedFile { name: name.to_owned(), text: text.to_owned() }).to_vec();
    let view = machine_check(MachineCheckRequest { files, ..asked("") }).unwrap();
    assert_eq!(view.changes, "CHANDATA(1)\n_SPEED[1]=1000\nCHANDATA(2)\n_SPEED[1]=1000\n");
    let inch = check("MD10240=0\n_SPEED[1]=0\n_TP[0,9]=0").changes;
    assert_eq!(inch, "_TP[0,9]=0.0787\n_SPEED[1]=39.3701\n");
}

// oracle: hand
#[test]
fn a_text_without_data_is_refused_and_lines_that_say_two_things_are_told() {
    for text in ["", "N10 G0 X10\nM30", "hello", "\u{0}\u{fffd}"] {
        assert_eq!(machine_check(asked(text)).unwrap_err().message.key, "machine-check-nothing", "{text}");
    }
    let view = check("MD18118=7\nMD18118=9\nMD18120=many");
    assert_eq!(told(&view), [("MD18120", Error, ""), ("MD18118", Warning, "")]);
    assert_eq!(view.faults[0].place.as_ref().map(|place| place.line), Some(3));
    assert!(view.missing.contains(&"MD28082 MM_SYSTEM_FRAME_MASK".to_owned()));
    assert!(!view.missing.iter().any(|name| name.starts_with("MD18118")));
}

// oracle: manual B:1184-1196 (a, t and Kv of the example), hand (1000 mm/min needs 1.4056 mm, 900 needs 1.2525)
#[test]
fn feeds_beyond_the_deflection_are_told_and_mended() {
    let axis = "MD10050=0.004\nMD10070=4\nMD32300[X1]=1\nMD32300[Z1]=2\nMD32200[0,X1]=1\nMD32200[0,Z1]=1.5\n";
    let feeds = "_SPEED[1]=1000\n_SPEED[3]=900\n_CHBIT[17]=1\nE_MESS_F=2000\nE_MESS_FM=300\n";
    let with = |text: &str, deflection| {
        machine_check(MachineCheckRequest { deflection: Some(deflection), ..asked(text) }).unwrap()
    };
    let text = format!("{axis}{feeds}");
    let slowest = with(&text, 1.0).axis.unwrap();
    assert_eq!((slowest.delay, slowest.acceleration, slowest.gain), (0.016, 1.0, 1.0));
    let names = |deflection| with(&text, deflection).faults.into_iter().map(|fault| fault.name).collect::<Vec<_>>();
    assert_eq!(names(3.1), [""; 0]);
    assert_eq!(names(2.0), ["E_MESS_F"]);
    assert_eq!(names(1.3), ["_SPEED[1]", "E_MESS_F"]);
    assert_eq!(names(1.0), ["_SPEED[1]", "_SPEED[3]", "E_MESS_F"]);
    let changes = with(&text, 1.0).changes;
    assert_eq!(changes, "_SPEED[1]=730\n_SPEED[3]=730\nE_MESS_F=730\n");
    assert_eq!(told(&with(&format!("{axis}{feeds}{changes}"), 1.0)).iter().filter(|one| one.1 == Error).count(), 0);
    assert_eq!(with(&format!("{axis}{changes}"), 1.0).changes, "");
    // 39.37 inch/min are 1000 mm/min
    let inch = with(&format!("{axis}MD10240=0\n_SPEED[1]=39.37"), 1.0);
    assert_eq!(inch.changes, "_SPEED[1]=28.7\n");
    // without collision monitoring a touch on the way is not noticed
    assert_eq!(told(&with(&format!("{axis}_SPEED[1]=1000\n_CHBIT[2]=0"), 1.0)), []);
    let unknown = with("_SPEED[1]=1000", 1.0);
    assert!(unknown.axis.is_none());
    assert_eq!(unknown.faults[0].message.key, "machine-check-no-axis"); // nothing was checked
    assert_eq!(with(axis, 1.0).faults, []);
    assert!(unknown.missing.contains(&"MD32300 MAX_AX_ACCEL".to_owned()));
}

/// A value that misses every limit of a condition.
fn missing(need: &Need) -> f64 {
    match need.test {
        Test::AtLeast | Test::UpTo | Test::Set => 0.0,
        Test::AtMost | Test::Equal => need.limits[0].value + 1.0,
        Test::Clear => need.limits[0].value,
    }
}

fn line(name: &str, value: f64) -> String {
    format!("{}={}\n", spelled(name), written(name, value))
}

// oracle: self (each row alone; its limits and places are those of the table, which the manual gives)
#[test]
fn each_row_is_missed_and_mended_alone() {
    let words = Words::english();
    for need in NEEDS {
        let condition = match need.when {
            When::Always => String::new(),
            When::Bit(number, bit) => line(number, f64::from(1_u32 << bit)),
        };
        let text = match need.when {
            When::Bit(number, _) if number == need.number => condition,
            _ => condition + &line(need.number, missing(need)),
        };
        let view = check(&text);
        let key = format!("machine-need-{}", need.effect);
        let fault = view.faults.iter().find(|fault| fault.effect.as_ref().is_some_and(|effect| effect.key == key));
        assert!(fault.is_some(), "{} {}", need.number, need.effect);
        let fault = fault.unwrap();
        assert_eq!(crate::control::arrays::stem(&fault.name), need.number);
        assert_eq!(fault.change.is_empty(), !need.changed, "{}", need.number);
        assert_eq!(fault.alarm.is_some(), need.alarm > 0);
        assert!(fault.limits.iter().all(|limit| !limit.source.to_string().is_empty()), "{}", need.number);
        let mended = check(&format!("{text}{}", view.changes));
        let left = |one: &&MachineFault| !one.change.is_empty();
        assert_eq!(mended.faults.iter().find(left), None, "{text}{}", view.changes);
        for message in [Some(&fault.message), fault.effect.as_ref(), fault.alarm.as_ref()].into_iter().flatten() {
            assert!(words.find(message).is_some(), "{}", message.key);
        }
    }
    let need = NEEDS.iter().find(|need| need.number == GUD_VALUES);
    assert!(need.is_some_and(|need| need.limits.len() == 1));
}

/// What somebody types, and what a list or an axis of the export says.
const VALUES: [&str; 13] = ["-5", "-1", "0", "0.5", "1", "2", "3", "4", "12", "133", "300", "5000", "\"1\""];
const COUNTS: [&str; 4] = ["_CVAL[0]", "_CVAL[1]", "_JM_I[1]", "_JM_I[2]"];
const LISTS: [&str; 5] = [
    "DEF NCK REAL _TP[2,10]",
    "DEF NCK REAL _WP[120,11]",
    "DEF CHAN REAL _SPEED[4]=(50)",
    "DEF CHAN REAL E_MESS_MT_DL[2]=SET(-1)",
    "MD10050=0.004\nMD10070=3\nMD32200[X1]=1\nMD32300[X1]=1",
];

proptest! {
    // oracle: self (the lines to change, read behind the export, leave nothing to change)
    #[test]
    fn applied_changes_leave_nothing_to_change(
        values in prop::collection::vec((0..NEEDS.len(), 0_u32..1200, 0_u32..4, 0_u32..3, any::<bool>()), 1..40),
        switches in prop::collection::vec((0_usize..13, 0_u8..3, 0_u32..4), 0..20),
        lists in prop::collection::vec(any::<bool>(), 5),
        metric in 0_u8..2,
    ) {
        const USER: [&str; 13] = [
            "_CBIT[3]", "_CHBIT[24]", "_CBIT[13]", "_SPEED[1]", "_CM[5]", "_TP[0,9]", "_CVAL[0]", "_JM_I[2]",
            "_CVAL[3]", "_EVMVNUM[0]", "_JM_I[1]", "_JM_I[4]", "_SPEED[0]",
        ];
        // of some of them the export has the array, a comment, a list that is too short, or nothing
        const LISTS: [&str; 5] = [
            "DEF NCK REAL _TP[2,10]", ";N111 DEF NCK REAL _TPW[3,10]", "DEF CHAN REAL _EV[10]",
            "DEF CHAN REAL _SPEED[4]=(50)", "DEF NCK REAL _WP[2,11]",
        ];
        let mut text = format!("MD10240={metric}\n");
        for (list, _) in LISTS.iter().zip(lists).filter(|(_, there)| *there) {
            text += &format!("{list}\n");
        }
        for (at, value, channel, index, exported) in values {
            let need = &NEEDS[at];
            let index = if need.by_place { format!("[{index}]") } else { String::new() };
            let name = format!("{}{index}", need.number);
            let number = &need.number[2..];
            let name = if exported { format!("N{number} $MX_OF_THE_EXPORT{index}") } else { spelled(&name) };
            let value = if need.by_place { value % 4 } else { value };
            text += &format!("CHANDATA({channel})\n{name}={}\n", written(need.number, f64::from(value)));
        }
        for (at, value, channel) in switches {
            text += &format!("CHANDATA({channel})\n{}={value}\n", USER[at]);
        }
        let before = check(&text);
        let file = |name: &str, text: &str| ExportedFile { name: name.to_owned(), text: text.to_owned() };
        let files = vec![file("A.TEA", &text), file("CHANGES.TEA", &before.changes)];
        let after = machine_check(MachineCheckRequest { files, ..asked("") }).unwrap();
        let left: Vec<&MachineFault> = after.faults.iter().filter(|fault| !fault.change.is_empty()).collect();
        prop_assert!(left.is_empty(), "{text}\n{}\n{left:?}", before.changes);
    }

    // oracle: self (a line to change causes no error, neither at its datum nor at another one, and leaves nothing to
    // change)
    #[test]
    fn no_line_to_change_causes_an_error(
        values in prop::collection::vec((any::<prop::sample::Index>(), 0_usize..VALUES.len(), 0_u32..4), 1..40),
        counts in prop::collection::vec((0_usize..COUNTS.len(), 0_usize..VALUES.len()), 0..4),
        lists in prop::collection::vec(any::<bool>(), LISTS.len()),
        metric in 0_u8..4,
        deflection in prop::option::of(0.01_f64..3.0),
    ) {
        let elements: Vec<String> = crate::control::gud::all().filter(|gud| gud.of_machine()).flat_map(|gud| {
            gud.elements.iter().flat_map(|element| gud.places(element, 2)).map(|at| gud.spelled(&at))
        }).collect();
        let mut text = if metric < 3 { format!("MD10240={metric}\n") } else { String::new() };
        for (list, _) in LISTS.iter().zip(lists).filter(|(_, there)| *there) {
            text += &format!("{list}\n");
        }
        let chosen = values.into_iter().map(|(at, value, channel)| (at.get(&elements).clone(), VALUES[value], channel));
        let counts = counts.into_iter().map(|(at, value)| (COUNTS[at].to_owned(), VALUES[value], 0));
        for (name, value, channel) in chosen.chain(counts) {
            text += &format!("CHANDATA({channel})\n{name}={value}\n");
        }
        let file = |name: &str, text: &str| ExportedFile { name: name.to_owned(), text: text.to_owned() };
        let with = |files| machine_check(MachineCheckRequest { files, deflection, ..asked("") }).unwrap();
        let before = with(vec![file("A.TEA", &text)]);
        let after = with(vec![file("A.TEA", &text), file("CHANGES.TEA", &before.changes)]);
        let left = after.faults.iter().find(|fault| !fault.change.is_empty());
        prop_assert!(left.is_none(), "{text}\n{}\n{left:?}", before.changes);
        let known = |fault: &MachineFault| {
            let same = |one: &MachineFault| one.name == fault.name && one.message.key == fault.message.key;
            before.faults.iter().any(same)
        };
        let new = after.faults.iter().find(|fault| fault.severity == Error && !known(fault));
        prop_assert!(new.is_none(), "{text}\n{}\n{new:?}", before.changes);
    }

    // oracle: self
    #[test]
    fn any_export_is_checked(text in any::<String>(), lines in prop::collection::vec(
        "(N[0-9]{0,5} )?(\\$M[NCA]_)?(MD28082|_CVAL|_TP|DEF NCK REAL _WP|E_MESS_MT_DL)(\\[[0-9,-]{0,4}\\])?=.{0,9}",
        0..9,
    )) {
        let _ = machine_check(asked(&text));
        let _ = machine_check(asked(&lines.join("\n")));
    }
}
