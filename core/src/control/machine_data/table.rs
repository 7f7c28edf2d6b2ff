//! The table of machine data.

use super::{CHANNEL_AXES, MachineDatum, TOOL_LENGTH_TYPE};

/// A datum of which the manual prints name and place.
const fn named(number: &'static str, identifier: &'static str, source: &'static str) -> MachineDatum {
    MachineDatum {
        number,
        identifier,
        standard: ["", ""],
        cycles: "",
        jog: "",
        bounds: ["", ""],
        effective: "",
        unit: "",
        elements: 0,
        text: false,
        initial: &[],
        initial_names: &[],
        source,
    }
}

/// A datum that the manual prints with its standard values, what cycles and JOG want, and its bounds.
const fn printed(
    number: &'static str,
    identifier: &'static str,
    standard: [&'static str; 2],
    [cycles, jog]: [&'static str; 2],
    bounds: [&'static str; 2],
    source: &'static str,
) -> MachineDatum {
    let named = named(number, identifier, source);
    MachineDatum { standard, cycles, jog, bounds, effective: "POWER ON", ..named }
}

impl MachineDatum {
    const fn after_reset(self) -> MachineDatum {
        MachineDatum { effective: "RESET", ..self }
    }

    const fn unit(self, unit: &'static str) -> MachineDatum {
        MachineDatum { unit, ..self }
    }

    const fn elements(self, elements: usize) -> MachineDatum {
        MachineDatum { elements, ..self }
    }

    const fn initial(self, initial: &'static [f64]) -> MachineDatum {
        MachineDatum { initial, ..self }
    }

    const fn holds_names(self, initial_names: &'static [&'static str]) -> MachineDatum {
        MachineDatum { text: true, initial_names, ..self }
    }
}

/// All of them, in the order of the manual.
pub const MACHINE_DATA: &[MachineDatum] = &[
    printed("MD18118", "MM_NUM_GUD_MODULES", ["7"; 2], ["7"; 2], ["1", "9"], "B:12920-12926"),
    printed("MD18120", "MM_NUM_GUD_NAMES_NCK", ["10", "50"], ["30"; 2], ["0", "plus"], "B:12931-12937"),
    printed("MD18130", "MM_NUM_GUD_NAMES_CHAN", ["40", "150"], ["100", "130"], ["0", "plus"], "B:12940-12945"),
    printed("MD18150", "MM_GUD_VALUES_MEM", ["12/16", "32"], ["28/32"; 2], ["0", "plus"], "B:12948-12955").unit("KB"),
    printed("MD28082", "MM_SYSTEM_FRAME_MASK", ["21H"; 2], ["21H"; 2], ["0", "7FH"], "B:12976-12983").initial(&[33.0]),
    printed("MD28083", "MM_SYSTEM_DATAFRAME_MASK", ["21H"; 2], ["21H"; 2], ["0", "7FH"], "B:12987-12993"),
    printed("MD18170", "MM_NUM_MAX_FUNC_NAMES", ["40", "100"], ["80"; 2], ["0", "plus"], "B:12997-13003"),
    printed("MD18180", "MM_NUM_MAX_FUNC_PARAM", ["300", "1000"], ["800"; 2], ["0", "plus"], "B:13005-13011"),
    printed("MD28020", "MM_NUM_LUD_NAMES_TOTAL", ["200", "400"], ["200"; 2], ["0", "plus"], "B:13015-13021"),
    printed("MD28040", "MM_NUM_LUD_VALUES_MEM", ["12/25", "50"], ["16/29"; 2], ["0", "plus"], "B:13023-13030")
        .unit("KB"),
    printed("MD13200", "MEAS_PROBE_LOW_ACTIVE", ["FALSE"; 2], ["FALSE"; 2], ["FALSE", "TRUE"], "B:13036-13049")
        .elements(2),
    printed("MD10132", "MMC_CMD_TIMEOUT", ["1", "3"], ["3"; 2], ["1.0", "100.0"], "B:13054-13059").unit("s"),
    printed("MD11420", "LEN_PROTOCOL_FILE", ["1"; 2], ["5"; 2], ["1", "1000000"], "B:13064-13069").unit("KB"),
    printed("MD11602", "ASUP_START_MASK", ["0"; 2], ["", "1 or 3"], ["0", "3"], "B:14067-14073"),
    printed("MD11604", "ASUP_START_PRIO_LEVEL", ["0"; 2], ["", "1..64H"], ["0", "64H"], "B:14075-14082").unit("HEX"),
    printed(
        "MD20050",
        "AXCONF_GEOAX_ASSIGN_TAB",
        ["1,2,3"; 2],
        ["", "all 3 geometry axes present"],
        ["0", "15"],
        "B:14084-14093",
    )
    .elements(3)
    .initial(&[1.0, 2.0, 3.0]),
    printed("MD20110", "RESET_MODE_MASK", ["0", "1"], ["", ">=4045H"], ["0", "07FFFH"], "B:14099-14110")
        .after_reset()
        .unit("HEX"),
    printed("MD20112", "START_MODE_MASK", ["400H"; 2], ["", "400H"], ["0", "07FFFH"], "B:14112-14119")
        .after_reset()
        .unit("HEX"),
    printed("MD20310", "TOOL_MANAGEMENT_MASK", ["0"; 2], ["", ">=4001H"], ["0", "0FFFFH"], "B:14121-14127").unit("HEX"),
    printed("MD24006", "CHSFRAME_RESET_MASK", ["0"; 2], ["", ">=1"], ["0", "07FFFH"], "B:14133-14141")
        .after_reset()
        .unit("HEX"),
    printed("MD24007", "CHSFRAME_RESET_CLEAR_MASK", ["0"; 2], ["", "bit 0=0"], ["0", "07FFFH"], "B:14143-14151")
        .after_reset()
        .unit("HEX"),
    named("MD10050", "SYSCLOCK_CYCLE_TIME", "B:1149"),
    named("MD10070", "IPO_SYSCLOCK_TIME_RATIO", "B:1149"),
    named("MD32200", "POSCTRL_GAIN", "B:1157"),
    named("MD32300", "MAX_AX_ACCEL", "B:1159"),
    named("MD10240", "SCALING_SYSTEM_IS_METRIC", "B:13594"),
    named("MD10610", "MIRROR_REF_AX", "B:4154;B:8709"),
    named("MD13210", "MEAS_TYPE", "B:12732"),
    named("MD18080", "MM_TOOL_MANAGEMENT_MASK", "B:12558").initial(&[256.0]),
    named("MD18102", "MM_TYPE_OF_CUTTING_EDGE", "B:1924"),
    named("MD18105", "MM_MAX_CUTTING_EDGE_NO", "B:1924-1926").initial(&[9.0]),
    named("MD18112", "", "A:15928").initial(&[16.0]),
    named("MD18116", "MM_NUM_TOOL_ENV", "B:2086"),
    named("MD18600", "MM_FRAME_FINE_TRANS", "B:1990").initial(&[1.0]),
    named("MD28081", "MM_NUM_BASE_FRAMES", "B:1942"),
    named("MD18280", "MM_NUM_FILES_PER_DIR", "B:12967"),
    named("MD18320", "MM_NUM_FILES_IN_FILESYSTEM", "B:12967"),
    named("MD20080", "", "A:15872").elements(CHANNEL_AXES).holds_names(&["X", "Y", "Z", "C"]),
    named("MD30300", "", "A:15872").elements(CHANNEL_AXES).initial(&[0.0, 0.0, 0.0, 1.0]),
    named("MD20060", "", "A:15878").holds_names(&[]),
    named("MD9021", "LAYOUT_MODE", "B:15145"),
    named(TOOL_LENGTH_TYPE, "TOOL_LENGTH_TYPE", "B:828"),
];
