//! Data that nothing in the simulation reads. The form says so beside each, so that no setting is without effect in
//! silence; a test holds the list against the code (`core/tests/idle.rs`).

/// User data: they concern pictures and screens of the real control, inputs of JOG, or what the manual names and does
/// not describe (B:13547-13548, B:13240-13244, B:14170-14200), or where it does not say by how much: the last touch of
/// a rotating tool is slower (B:14043-14045).
const USER: [&str; 13] = [
    "_CBIT[7]", "_CHBIT[22]", "_MC_MTL", "E_MESS_F_FAK2", "E_MESS_IS_METRIC", "E_MESS_IS_METRIC_SPEZ_VAR",
    "E_MESS_MS_IN", "E_MESS_MS_MONO", "E_MESS_MS_SOUTH", "E_MESS_MT_CF", "E_MESS_MT_COMP", "E_MESS_MT_IN",
    "E_MESS_MT_TYP",
];

/// Machine data: memories, inputs, times and the start of JOG.
const MACHINE: [&str; 24] = [
    "MD9021", "MD10132", "MD11602", "MD11604", "MD13200", "MD13210", "MD18116", "MD18118", "MD18120", "MD18130",
    "MD18150", "MD18170", "MD18180", "MD18280", "MD18320", "MD20060", "MD20110", "MD20112", "MD20310", "MD24006",
    "MD24007", "MD28020", "MD28040", "MD28083",
];

/// Whether nothing in the simulation reads a datum, by its name with or without index.
pub fn idle(name: &str) -> bool {
    let stem = super::arrays::stem(name);
    USER.iter().chain(&MACHINE).any(|one| *one == name || *one == stem)
}
