//! The table of machine data.

use super::{CHANNEL_AXES, MachineDatum, TOOL_LENGTH_TYPE};

const PLAIN: MachineDatum = MachineDatum {
    number: "",
    identifier: "",
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
    source: "",
};

/// All of them, in the order of the manual.
pub const MACHINE_DATA: &[MachineDatum] = &[
    MachineDatum {
        number: "MD18118",
        identifier: "MM_NUM_GUD_MODULES",
        standard: ["7", "7"],
        cycles: "7",
        jog: "7",
        bounds: ["1", "9"],
        effective: "POWER ON",
        source: "B:12920-12926",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18120",
        identifier: "MM_NUM_GUD_NAMES_NCK",
        standard: ["10", "50"],
        cycles: "30",
        jog: "30",
        bounds: ["0", "plus"],
        effective: "POWER ON",
        source: "B:12931-12937",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18130",
        identifier: "MM_NUM_GUD_NAMES_CHAN",
        standard: ["40", "150"],
        cycles: "100",
        jog: "130",
        bounds: ["0", "plus"],
        effective: "POWER ON",
        source: "B:12940-12945",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18150",
        identifier: "MM_GUD_VALUES_MEM",
        standard: ["12/16", "32"],
        cycles: "28/32",
        jog: "28/32",
        bounds: ["0", "plus"],
        effective: "POWER ON",
        unit: "KB",
        source: "B:12948-12955",
        ..PLAIN
    },
    MachineDatum {
        number: "MD28082",
        identifier: "MM_SYSTEM_FRAME_MASK",
        standard: ["21H", "21H"],
        cycles: "21H",
        jog: "21H",
        bounds: ["0", "7FH"],
        effective: "POWER ON",
        initial: &[33.0],
        source: "B:12976-12983",
        ..PLAIN
    },
    MachineDatum {
        number: "MD28083",
        identifier: "MM_SYSTEM_DATAFRAME_MASK",
        standard: ["21H", "21H"],
        cycles: "21H",
        jog: "21H",
        bounds: ["0", "7FH"],
        effective: "POWER ON",
        source: "B:12987-12993",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18170",
        identifier: "MM_NUM_MAX_FUNC_NAMES",
        standard: ["40", "100"],
        cycles: "80",
        jog: "80",
        bounds: ["0", "plus"],
        effective: "POWER ON",
        source: "B:12997-13003",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18180",
        identifier: "MM_NUM_MAX_FUNC_PARAM",
        standard: ["300", "1000"],
        cycles: "800",
        jog: "800",
        bounds: ["0", "plus"],
        effective: "POWER ON",
        source: "B:13005-13011",
        ..PLAIN
    },
    MachineDatum {
        number: "MD28020",
        identifier: "MM_NUM_LUD_NAMES_TOTAL",
        standard: ["200", "400"],
        cycles: "200",
        jog: "200",
        bounds: ["0", "plus"],
        effective: "POWER ON",
        source: "B:13015-13021",
        ..PLAIN
    },
    MachineDatum {
        number: "MD28040",
        identifier: "MM_NUM_LUD_VALUES_MEM",
        standard: ["12/25", "50"],
        cycles: "16/29",
        jog: "16/29",
        bounds: ["0", "plus"],
        effective: "POWER ON",
        unit: "KB",
        source: "B:13023-13030",
        ..PLAIN
    },
    MachineDatum {
        number: "MD13200",
        identifier: "MEAS_PROBE_LOW_ACTIVE",
        standard: ["FALSE", "FALSE"],
        cycles: "FALSE",
        jog: "FALSE",
        bounds: ["FALSE", "TRUE"],
        effective: "POWER ON",
        elements: 2,
        source: "B:13036-13049",
        ..PLAIN
    },
    MachineDatum {
        number: "MD10132",
        identifier: "MMC_CMD_TIMEOUT",
        standard: ["1", "3"],
        cycles: "3",
        jog: "3",
        bounds: ["1.0", "100.0"],
        effective: "POWER ON",
        unit: "s",
        source: "B:13054-13059",
        ..PLAIN
    },
    MachineDatum {
        number: "MD11420",
        identifier: "LEN_PROTOCOL_FILE",
        standard: ["1", "1"],
        cycles: "5",
        jog: "5",
        bounds: ["1", "1000000"],
        effective: "POWER ON",
        unit: "KB",
        source: "B:13064-13069",
        ..PLAIN
    },
    MachineDatum {
        number: "MD11602",
        identifier: "ASUP_START_MASK",
        standard: ["0", "0"],
        jog: "1 or 3",
        bounds: ["0", "3"],
        effective: "POWER ON",
        source: "B:14067-14073",
        ..PLAIN
    },
    MachineDatum {
        number: "MD11604",
        identifier: "ASUP_START_PRIO_LEVEL",
        standard: ["0", "0"],
        jog: "1..64H",
        bounds: ["0", "64H"],
        effective: "POWER ON",
        unit: "HEX",
        source: "B:14075-14082",
        ..PLAIN
    },
    MachineDatum {
        number: "MD20050",
        identifier: "AXCONF_GEOAX_ASSIGN_TAB",
        standard: ["1,2,3", "1,2,3"],
        jog: "all 3 geometry axes present",
        bounds: ["0", "15"],
        effective: "POWER ON",
        elements: 3,
        initial: &[1.0, 2.0, 3.0],
        source: "B:14084-14093",
        ..PLAIN
    },
    MachineDatum {
        number: "MD20110",
        identifier: "RESET_MODE_MASK",
        standard: ["0", "1"],
        jog: ">=4045H",
        bounds: ["0", "07FFFH"],
        effective: "RESET",
        unit: "HEX",
        source: "B:14099-14110",
        ..PLAIN
    },
    MachineDatum {
        number: "MD20112",
        identifier: "START_MODE_MASK",
        standard: ["400H", "400H"],
        jog: "400H",
        bounds: ["0", "07FFFH"],
        effective: "RESET",
        unit: "HEX",
        source: "B:14112-14119",
        ..PLAIN
    },
    MachineDatum {
        number: "MD20310",
        identifier: "TOOL_MANAGEMENT_MASK",
        standard: ["0", "0"],
        jog: ">=4001H",
        bounds: ["0", "0FFFFH"],
        effective: "POWER ON",
        unit: "HEX",
        source: "B:14121-14127",
        ..PLAIN
    },
    MachineDatum {
        number: "MD24006",
        identifier: "CHSFRAME_RESET_MASK",
        standard: ["0", "0"],
        jog: ">=1",
        bounds: ["0", "07FFFH"],
        effective: "RESET",
        unit: "HEX",
        source: "B:14133-14141",
        ..PLAIN
    },
    MachineDatum {
        number: "MD24007",
        identifier: "CHSFRAME_RESET_CLEAR_MASK",
        standard: ["0", "0"],
        jog: "bit 0=0",
        bounds: ["0", "07FFFH"],
        effective: "RESET",
        unit: "HEX",
        source: "B:14143-14151",
        ..PLAIN
    },
    MachineDatum {
        number: "MD10050",
        identifier: "SYSCLOCK_CYCLE_TIME",
        source: "B:1149",
        ..PLAIN
    },
    MachineDatum {
        number: "MD10070",
        identifier: "IPO_SYSCLOCK_TIME_RATIO",
        source: "B:1149",
        ..PLAIN
    },
    MachineDatum {
        number: "MD32200",
        identifier: "POSCTRL_GAIN",
        source: "B:1157",
        ..PLAIN
    },
    MachineDatum {
        number: "MD32300",
        identifier: "MAX_AX_ACCEL",
        source: "B:1159",
        ..PLAIN
    },
    MachineDatum {
        number: "MD10240",
        identifier: "SCALING_SYSTEM_IS_METRIC",
        source: "B:13594",
        ..PLAIN
    },
    MachineDatum {
        number: "MD10610",
        identifier: "MIRROR_REF_AX",
        source: "B:4154;B:8709",
        ..PLAIN
    },
    MachineDatum {
        number: "MD13210",
        identifier: "MEAS_TYPE",
        source: "B:12732",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18080",
        identifier: "MM_TOOL_MANAGEMENT_MASK",
        initial: &[256.0],
        source: "B:12558",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18102",
        identifier: "MM_TYPE_OF_CUTTING_EDGE",
        source: "B:1924",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18105",
        identifier: "MM_MAX_CUTTING_EDGE_NO",
        initial: &[9.0],
        source: "B:1924-1926",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18112",
        initial: &[16.0],
        source: "A:15928",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18116",
        identifier: "MM_NUM_TOOL_ENV",
        source: "B:2086",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18600",
        identifier: "MM_FRAME_FINE_TRANS",
        initial: &[1.0],
        source: "B:1990",
        ..PLAIN
    },
    MachineDatum {
        number: "MD28081",
        identifier: "MM_NUM_BASE_FRAMES",
        source: "B:1942",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18280",
        identifier: "MM_NUM_FILES_PER_DIR",
        source: "B:12967",
        ..PLAIN
    },
    MachineDatum {
        number: "MD18320",
        identifier: "MM_NUM_FILES_IN_FILESYSTEM",
        source: "B:12967",
        ..PLAIN
    },
    MachineDatum {
        number: "MD20080",
        elements: CHANNEL_AXES,
        text: true,
        initial_names: &["X", "Y", "Z", "C"],
        source: "A:15872",
        ..PLAIN
    },
    MachineDatum {
        number: "MD30300",
        elements: CHANNEL_AXES,
        initial: &[0.0, 0.0, 0.0, 1.0],
        source: "A:15872",
        ..PLAIN
    },
    MachineDatum {
        number: "MD20060",
        text: true,
        source: "A:15878",
        ..PLAIN
    },
    MachineDatum {
        number: "MD9021",
        identifier: "LAYOUT_MODE",
        source: "B:15145",
        ..PLAIN
    },
    MachineDatum {
        number: TOOL_LENGTH_TYPE,
        identifier: "TOOL_LENGTH_TYPE",
        source: "B:828",
        ..PLAIN
    },
];
