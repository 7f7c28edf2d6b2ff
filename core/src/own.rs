//! Findings of ours, shown as `PW012`. Each sentence is declared here, once: its number, how bad it is, what it says
//! and what helps. Checks raise it by its name, `probewright explain` tells every sentence of a number.
//!
//! Findings of a run have their table in `run::problem`.

use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::message::Message;

/// One sentence of ours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Own {
    /// Number of the finding. Sentences that share one say the same in other words.
    pub number: u16,
    /// How bad it is, unless the one who raises it says otherwise.
    pub severity: Severity,
    /// Key of what is wrong.
    pub cause: &'static str,
    /// Key of what helps; empty where the cause says it, or the one who raises it gives another.
    pub hint: &'static str,
}

impl Own {
    /// Number of the finding as a code.
    pub const fn code(&self) -> Code {
        Code::Own(self.number)
    }

    /// The finding as a note.
    pub fn as_note(self) -> Own {
        Own { severity: Severity::Note, ..self }
    }

    /// As a finding, without arguments and place.
    pub fn finding(&self) -> Diagnostic {
        let found = Diagnostic::new(self.severity, self.code(), Message::new(self.cause));
        if self.hint.is_empty() { found } else { found.hint(Message::new(self.hint)) }
    }
}

/// The sentences as constants, and a list of all.
macro_rules! sentences {
    ($($name:ident $number:literal $severity:ident $cause:literal $hint:literal;)*) => {
        $(
            #[doc = concat!("PW", $number, ": `", $cause, "`.")]
            pub(crate) const $name: Own = Own {
                number: $number,
                severity: Severity::$severity,
                cause: $cause,
                hint: $hint,
            };
        )*

        /// Every sentence, in the order of the numbers.
        #[cfg(feature = "cli")]
        pub const ALL: &[Own] = &[$($name),*];
    };
}

sentences! {
    MISSING 1 Error "check-missing" "";
    OFFSET_MISSING 1 Error "check-offset-missing" "check-offset-missing-hint";
    NOT_A_NUMBER 2 Error "check-not-a-number" "check-not-a-number-hint";
    EXPRESSION 3 Note "check-expression" "";
    NO_VALUE 3 Note "check-no-value" "check-no-value-hint";
    NOT_WHOLE 4 Error "check-not-whole" "check-not-whole-hint";
    RANGE 5 Error "check-range" "check-range-both-hint";
    TOO_LARGE 5 Error "check-too-large" "check-too-large-hint";
    TEXT_LONG 6 Error "check-text-long" "check-text-long-hint";
    TEXT_CHARACTERS 6 Error "check-text-characters" "check-text-characters-hint";
    UNUSUAL 7 Warning "check-unusual" "check-unusual-hint";
    DELIVERED 8 Warning "check-delivered" "";
    CORA_OFF 20 Warning "check-cora-off" "check-cora-off-hint";
    EMPIRICAL_MEMORY 21 Error "check-empirical-memory" "check-memory-hint";
    MEAN_MEMORY 21 Error "check-mean-memory" "check-memory-hint";
    TOLERANCE_ORDER 22 Error "check-tolerance-order" "check-tolerance-order-hint";
    BAND_DIFFERENCE 23 Warning "check-band-difference" "check-bands-hint";
    ZERO_MEAN 24 Warning "check-zero-mean" "check-bands-hint";
    DIFFERENCE_SAFE 25 Warning "check-difference-safe" "check-bands-hint";
    INFEED 27 Warning "check-infeed" "check-infeed-hint";
    MEAN_OFF 28 Note "check-mean-off" "check-mean-off-hint";
    BALL 30 Error "check-ball" "check-ball-hint";
    ZONE_SHORTENS 31 Warning "check-zone-shortens" "check-zone-shortens-hint";
    CALIBRATION_BAND 40 Error "check-calibration-band" "check-calibration-band-hint";
    SKEW_LOST 41 Note "check-skew-lost" "check-skew-lost-hint";
    APPLICATE_PLUS 42 Warning "check-applicate-plus" "check-applicate-plus-hint";
    GROOVE_EMPTY 43 Warning "check-groove-empty" "check-groove-empty-hint";
    GROOVE_EDGES 44 Error "check-groove-edges" "check-groove-edges-hint";
    SHANK 45 Warning "check-shank" "check-shank-hint";
    TWO_SETPOINT 46 Warning "check-two-setpoint" "check-two-setpoint-hint";
    TWO_BALL 47 Error "check-two-ball" "check-two-ball-hint";
    TWO_NO_ZONE 48 Note "check-two-no-zone" "check-two-no-zone-hint";
    TWO_HALF_ZONE 49 Warning "check-two-half-zone" "check-two-half-zone-hint";
    POINTS_UNUSED 50 Warning "check-points-unused" "check-points-unused-hint";
    BALL_UNKNOWN 51 Warning "check-ball-unknown" "check-ball-unknown-hint";
    ANGLES_SUM 52 Error "check-angles-sum" "check-angles-sum-hint";
    ANGLES_WIDE 53 Warning "check-angles-wide" "check-angles-wide-hint";
    PATH_CENTRE 54 Warning "check-path-centre" "check-path-centre-hint";
    LIFT 55 Warning "check-lift" "check-lift-hint";
    LIFT_BALL 56 Warning "check-lift-ball" "check-lift-ball-hint";
    TOOL_MEMORY 59 Error "check-empirical-memory" "check-memory-hint";
    TOOL_LIMITS 60 Warning "check-tool-limits" "check-tool-limits-hint";
    TOOL_PROBE_EMPTY 61 Warning "check-tool-probe-empty" "check-tool-probe-empty-hint";
    TOOL_PROBE_SIDES 62 Warning "check-tool-probe-sides" "check-tool-probe-sides-hint";
    TOOL_PROBE_DEPTH 63 Warning "check-tool-probe-depth" "check-tool-probe-depth-hint";
    OFFSET_LARGE 64 Warning "check-offset-large" "check-offset-large-hint";
    OFFSET_ABSCISSA 65 Note "check-offset-abscissa" "check-offset-abscissa-hint";
    MFS_THIRD 66 Warning "check-mfs-third" "check-mfs-third-hint";
    CM_ZERO 67 Error "check-cm-zero" "check-cm-zero-hint";
    CM_FACTOR 68 Warning "check-cm-factor" "check-cm-factor-hint";
    CM_ORDER 69 Warning "check-cm-order" "check-cm-order-hint";
    COMPENSATION_MAKE 70 Warning "check-compensation-make" "check-compensation-make-hint";
    COMPENSATION_TABLE 71 Warning "check-compensation-table" "check-compensation-table-hint";
    TOOL_REFERENCE 72 Note "check-tool-reference" "check-tool-reference-hint";
    TURNING_DIGITS 73 Warning "check-turning-digits" "check-turning-digits-hint";
    TIP_DIRECTION 74 Warning "check-tip-direction" "check-tip-direction-hint";
    LENGTH_ASSIGNMENT 75 Error "check-length-assignment" "check-length-assignment-hint";
    RADIUS_LENGTH 76 Warning "check-radius-length" "check-radius-length-hint";
    ANGLE_STEEP 80 Error "check-angle-steep" "check-angle-steep-hint";
    ANGLE_REACH 81 Warning "check-angle-reach" "check-angle-reach-hint";
    ANGLE_REACH_WORST 82 Note "check-angle-reach-worst" "check-angle-reach-hint";
    ANGLE_PARAXIAL 83 Warning "check-angle-paraxial" "check-angle-paraxial-hint";
    LATHE_LENGTH 85 Warning "check-lathe-length" "check-lathe-length-hint";
    CORNER_RECTANGLE 90 Warning "check-corner-rectangle" "check-corner-rectangle-hint";
    CORNER_LIFT 91 Error "check-corner-lift" "check-corner-lift-hint";
    CORNER_TURNED 92 Note "check-corner-turned" "check-corner-turned-hint";
    SPHERE_SMALL 93 Warning "check-sphere-small" "check-sphere-small-hint";
    SPHERES_OVERLAP 94 Error "check-spheres-overlap" "check-spheres-overlap-hint";
    SPHERES_CLOSE 95 Warning "check-spheres-close" "check-spheres-close-hint";
    SYNTAX_UNKNOWN 100 Error "syntax-unknown" "syntax-unknown-hint";
    SYNTAX_VALUE 100 Error "syntax-value" "syntax-value-hint";
    SYNTAX_OPERAND 100 Error "syntax-operand" "";
    SYNTAX_OPERATOR 100 Error "syntax-operator" "syntax-operator-hint";
    SYNTAX_EQUALS 100 Error "syntax-equals" "";
    SYNTAX_BRACKET 100 Error "syntax-bracket" "";
    SYNTAX_INDEX 100 Error "syntax-index" "";
    SYNTAX_TEXT 100 Error "syntax-text" "";
    SYNTAX_CHARACTER 100 Error "syntax-character" "syntax-character-hint";
    SYNTAX_NUMBER 100 Error "syntax-number" "syntax-number-hint";
    SYNTAX_COMMA 100 Error "syntax-comma" "";
    SYNTAX_DEPTH 100 Error "syntax-depth" "syntax-depth-hint";
    SYNTAX_COMMENT 100 Error "syntax-comment" "";
    SYNTAX_TOO_LARGE 100 Error "syntax-too-large" "syntax-too-large-hint";
    SYNTAX_DEFINE 100 Error "syntax-define" "";
    SYNTAX_MACRO_CIRCLE 100 Error "syntax-macro-circle" "syntax-macro-circle-hint";
    SYNTAX_MACRO_LONG 100 Error "syntax-macro-long" "syntax-macro-long-hint";
    SYNTAX_EXPONENT 100 Error "syntax-exponent" "";
    SYNTAX_NO_EXPONENT 100 Error "syntax-no-exponent" "syntax-no-exponent-hint";
    BLOCK_TWICE 101 Error "block-twice" "block-twice-hint";
    BLOCK_AXIS_NAME 102 Error "block-axis-name" "block-axis-name-hint";
    G101_NO_TARGET 110 Warning "g101-no-target" "g101-no-target-hint";
    NCT_LIMITS 112 Warning "nct-limits" "nct-limits-hint";
    NCT_SAME_REGISTER 113 Warning "nct-same-register" "nct-same-register-hint";
    P9920_NO_DIAMETER 116 Error "p9920-no-diameter" "p9920-no-diameter-hint";
    P9920_TURNING_LENGTH 117 Warning "p9920-turning-length" "p9920-turning-length-hint";
    P9920_NO_CLEARANCE 118 Warning "p9920-no-clearance" "p9920-no-clearance-hint";
    WRITE_NO_LIST 120 Error "write-no-list" "write-no-list-hint";
    WRITE_NO_LIST_VARIANT 120 Error "write-no-list-variant" "write-no-list-hint";
    WRITE_ZERO 121 Note "write-zero" "";
    WRITE_BESIDE 121 Note "write-beside" "";
    WRITE_LOST 122 Warning "write-lost" "write-lost-hint";
    CONVERT_LOST 122 Warning "convert-lost" "convert-lost-hint";
    CONVERT_OTHERS 123 Warning "convert-others" "convert-others-hint";
    CONVERT_SAME 124 Note "convert-same" "";
    ADVICE_COMPENSATION 130 Error "advice-compensation" "advice-compensation-hint";
    ADVICE_COMPENSATION_PASS 130 Error "advice-compensation-pass" "advice-compensation-hint";
    ADVICE_PLANE 131 Warning "advice-plane" "advice-plane-hint";
    ADVICE_DIAMETER 132 Warning "advice-diameter" "advice-diameter-hint";
    ADVICE_EDGE_OPEN 133 Note "advice-edge-open" "advice-edge-hint";
    ADVICE_SPINDLE 134 Warning "advice-spindle" "advice-spindle-hint";
    ADVICE_CALIBRATION 135 Note "advice-calibration" "advice-calibration-hint";
    ADVICE_INHERITED 136 Warning "advice-inherited" "advice-inherited-hint";
    ADVICE_INHERITED_MEANING 136 Warning "advice-inherited-meaning" "advice-inherited-hint";
    ADVICE_FRAME 137 Warning "advice-frame" "advice-frame-hint";
    ADVICE_FRAME_OTHER 137 Warning "advice-frame-other" "advice-frame-other-hint";
    ADVICE_FRAME_BASIC 137 Warning "advice-frame-basic" "advice-frame-hint";
    ADVICE_LEVEL 138 Error "advice-level" "advice-level-hint";
    ADVICE_READ_BACK 140 Warning "advice-read-back" "advice-read-back-hint";
    ADVICE_MASK 141 Warning "advice-mask" "advice-mask-hint";
    ADVICE_TOOL_PROGRAMMING 142 Warning "advice-tool-programming" "advice-tool-programming-hint";
    TARGET_NOT_OFFERED 143 Warning "check-target-not-offered" "check-target-not-offered-hint";
    CALIBRATION_MIRROR 144 Error "check-calibration-mirror" "check-calibration-mirror-hint";
    ADVICE_OPEN 145 Note "advice-open" "advice-open-hint";
    ADVICE_COMPENSATION_OPEN 146 Note "advice-compensation-open" "advice-compensation-hint";
    ADVICE_TOOL_NONE 147 Note "advice-tool-none" "advice-tool-none-hint";
    ADVICE_RADIUS 148 Note "advice-radius" "advice-radius-hint";
    COMPENSATION_INSIDE 149 Note "check-compensation-inside" "check-compensation-inside-hint";
    ADVICE_OVERWRITTEN 150 Warning "advice-overwritten" "advice-overwritten-hint";
    ARRIVES 151 Note "arrives" "arrives-hint";
    ARRIVES_LINES 151 Note "arrives-lines" "arrives-hint";
    ARRIVES_SHARED 151 Note "arrives" "arrives-shared-hint";
    ARRIVES_MANY 151 Note "arrives" "arrives-many-hint";
    ARRIVES_DIFFERING 151 Note "arrives-differing" "arrives-differing-hint";
    WRITE_VARIANT_OPEN 153 Error "write-variant-open" "write-no-list-hint";
    CONVERT_VARIANT_OPEN 153 Error "write-variant-open" "convert-argument-hint";
    CONVERT_NO_VARIANT 153 Error "convert-no-variant" "convert-no-variant-hint";
    MIRROR_DATUM 154 Warning "check-mirror-datum" "check-mirror-datum-hint";
    ROTARY_ACROSS 155 Warning "check-rotary-across" "check-rotary-across-hint";
    NCT_ORIENTED 156 Warning "nct-oriented" "nct-oriented-hint";
    NCT_STYLUS_OFF 157 Warning "nct-stylus-off" "nct-stylus-off-hint";
    NCT_STYLUS_ON 158 Warning "nct-stylus-on" "nct-stylus-on-hint";
    NCT_STYLUS_LEFT 158 Note "nct-stylus-left" "nct-stylus-on-hint";
    NCT_LEVEL 159 Error "nct-level" "nct-level-hint";
    ERASES 160 Warning "check-erases" "check-erases-hint";
    CONVERTS 161 Warning "check-converts" "check-converts-hint";
    NCT_ELSEWHERE 162 Warning "nct-elsewhere" "nct-elsewhere-hint";
    NCT_TWICE 163 Error "nct-twice" "nct-twice-hint";
    BRAKING 164 Warning "check-braking" "check-braking-hint";
    ADVICE_MILLED_DIAMETER 165 Note "advice-milled-diameter" "advice-milled-diameter-hint";
    ADVICE_LENGTH 166 Warning "advice-length" "advice-length-hint";
    ADVICE_LOG_AGAIN 167 Warning "advice-log-again" "advice-log-again-hint";
    SPREAD_CIRCLE 170 Warning "check-spread-circle" "check-spread-circle-hint";
    SPREAD_CENTRE 170 Warning "check-spread-centre" "check-spread-circle-hint";
    SPREAD_CORNER 171 Warning "check-spread-corner" "check-spread-corner-hint";
    SPREAD_ANGLE 172 Warning "check-spread-angle" "check-spread-angle-hint";
    SPREAD_TRIANGLE 173 Warning "check-spread-triangle" "check-spread-triangle-hint";
    TOOL_RADIUS 175 Warning "check-tool-radius-negative" "check-tool-radius-negative-hint";
    TEXT_BEHIND_END 180 Note "syntax-behind-end" "syntax-behind-end-hint";
    PROGRAM_NAMES 181 Note "program-names" "program-names-hint";
    NCT_FOREIGN 182 Note "nct-foreign" "nct-foreign-hint";
    LONE_RETURN 183 Warning "syntax-lone-return" "syntax-lone-return-hint";
    TEXT_WANTED 185 Error "list-text-wanted" "list-text-wanted-hint";
    NUMBER_WANTED 185 Error "list-number-wanted" "list-number-wanted-hint";
    TEXT_UNQUOTED 185 Warning "list-text-unquoted" "list-text-unquoted-hint";
    ARGUMENTS_MANY 186 Error "list-arguments-many" "list-arguments-many-hint";
    SELECTION 187 Error "list-selection" "list-selection-hint";
    NEWER_OPEN 188 Note "newer-open" "";
    NEWER_SEEN 188 Note "newer-seen" "";
    NEWER_BEYOND 188 Note "newer-beyond" "";
    CONVERT_NEWER 188 Error "convert-newer" "convert-newer-hint";
    WRITE_NEWER 188 Error "write-newer" "write-no-list-hint";
    NEWER_TARGET 189 Warning "newer-target" "newer-target-hint";
    NEWER_TARGET_PERHAPS 189 Note "newer-target-perhaps" "newer-target-perhaps-hint";
    WRITE_NEWER_TOOL 189 Error "write-newer-tool" "write-no-list-hint";
    WRITE_NEWER_ZERO 189 Error "write-newer-zero" "write-no-list-hint";
    WRITE_EXPRESSION_LOST 190 Error "write-expression-lost" "write-no-list-hint";
    CONVERT_ARGUMENT 190 Error "convert-argument" "convert-argument-hint";
    CONVERT_MACRO 190 Error "convert-macro" "convert-macro-hint";
    WRITE_EXPRESSION 191 Note "write-expression" "";
    CONVERT_EXPRESSION 192 Error "convert-expression" "convert-expression-hint";
    REVISE_TAKEN 193 Note "revise-taken" "";
    REVISE_SHARED 193 Note "revise-shared" "";
    NEWER_LOST 194 Error "newer-lost" "newer-lost-hint";
    NEWER_LOST_BETWEEN 194 Error "newer-lost-between" "newer-lost-hint";
    NEWER_MANY 194 Error "newer-many" "newer-many-hint";
    NEWER_MANY_BETWEEN 194 Error "newer-many-between" "newer-many-hint";
    NEWER_INCH 195 Warning "newer-inch" "newer-inch-hint";
    WRITE_DIRECTION 196 Warning "write-direction" "write-direction-hint";
    WRITE_INFEED 196 Warning "write-infeed" "write-infeed-hint";
    WRITE_ROTARY 196 Warning "write-rotary" "write-rotary-hint";
    CONVERT_INFEED 196 Warning "convert-infeed" "convert-infeed-hint";
    CONVERT_ROTARY 196 Warning "convert-rotary" "convert-rotary-hint";
    WRITE_COARSE 196 Warning "write-coarse" "write-coarse-hint";
    GENERATION_LIST 197 Warning "generation-list" "generation-list-hint";
    GENERATION_ASSIGNED 197 Warning "generation-assigned" "generation-assigned-hint";
    GENERATION_SETTING_DATA 197 Warning "generation-setting-data" "generation-setting-data-hint";
    GENERATION_USER_DATA 197 Warning "generation-user-data" "generation-user-data-hint";
    RUNS_BEFORE 198 Note "user-program-runs-before" "";
    RUNS_BEFORE_WHOLE 198 Note "user-program-runs-before-whole" "";
    RUNS_BEHIND 198 Note "user-program-runs-behind" "";
    RUNS_BEHIND_WHOLE 198 Note "user-program-runs-behind-whole" "";
    FOREIGN_PROGRAM 199 Note "foreign-program" "";
    FOREIGN_CALL 199 Note "foreign-call" "";
    FOREIGN_UNKNOWN 199 Note "foreign-unknown" "";
    FOREIGN_TWICE 200 Error "foreign-twice" "foreign-twice-hint";
    FOREIGN_MISSING 201 Warning "foreign-missing" "foreign-missing-hint";
    FOREIGN_SURPLUS 201 Note "foreign-surplus" "";
    FOREIGN_RANGE 202 Error "foreign-range" "foreign-range-hint";
    FOREIGN_NO_SUCH 202 Error "foreign-no-such" "foreign-no-such-hint";
    FOREIGN_VALUE 202 Error "foreign-value" "foreign-value-hint";
    FOREIGN_LIMITS 202 Warning "foreign-limits" "foreign-limits-hint";
    NEWER_UNSIMULATED 203 Note "newer-unsimulated" "";
    NEWER_OMITTED 203 Note "newer-omitted" "";
    NEWER_INFEED 203 Note "newer-infeed" "newer-infeed-hint";
    OLDER_CALL 210 Warning "older-call" "older-call-hint";
    OLDER_ID 211 Warning "older-open-id" "older-open-hint";
    OLDER_SZA 211 Warning "older-open-sza" "older-open-hint";
    OLDER_MD 211 Warning "older-open-md" "older-open-hint";
    OLDER_RA 211 Warning "older-open-ra" "older-open-hint";
    OLDER_RF 211 Warning "older-open-rf" "older-open-hint";
    OLDER_FIRST 211 Warning "older-open-first" "older-setpoint-hint";
    OLDER_SECOND 211 Warning "older-open-second" "older-setpoint-hint";
    OLDER_UNUSED 212 Note "older-unused" "";
    OLDER_OTHER 212 Note "older-other" "";
    OLDER_RESULT 213 Warning "older-result" "older-result-hint";
    OLDER_UNCLEAR 214 Warning "older-unclear" "older-unclear-hint";
    OLDER_WAY 214 Warning "older-way" "older-way-hint";
    OLDER_SUBROUTINE 215 Note "older-subroutine" "";
    OLDER_FACTOR 216 Note "older-factor" "";
    OLDER_MISSING 217 Note "older-missing" "older-missing-hint";
    CONVERT_ADDED 217 Warning "convert-added" "convert-added-hint";
    OLDER_CLASH 218 Warning "older-clash" "older-clash-hint";
    OLDER_CLASH_LATER 218 Warning "older-clash-later" "older-clash-later-hint";
    CONVERT_SKIPPED 219 Error "convert-skipped" "convert-skipped-hint";
    CONVERT_SKIP_BLOCK 219 Error "convert-skip-block" "convert-skip-block-hint";
    CONVERT_STAYS 220 Note "convert-stays" "";
    CONVERT_READ 221 Warning "convert-read" "convert-read-hint";
    CONVERT_VARIABLE 221 Warning "convert-variable" "convert-read-hint";
    CONVERT_OVERWRITES 221 Error "convert-overwrites" "convert-overwrites-hint";
    NCT_LEVELS 222 Note "nct-levels" "nct-levels-hint";
    NCT_MACRO_LEVELS 223 Error "nct-macro-levels" "nct-levels-deep-hint";
    NCT_SUBPROGRAM_LEVELS 223 Error "nct-subprogram-levels" "nct-levels-deep-hint";
    CONVERT_CALLED 224 Error "convert-called" "convert-called-hint";
    WRITE_PLANE 225 Warning "write-plane" "write-plane-hint";
    WRITE_UNPUBLISHED 226 Error "write-unpublished" "write-no-list-hint";
    WRITE_UNPUBLISHED_VARIANT 226 Error "write-unpublished-variant" "write-no-list-hint";
    NEWER_ALONE 227 Note "newer-alone" "";
    NEWER_LOST_PERHAPS 228 Note "newer-lost-perhaps" "newer-perhaps-hint";
    NEWER_MANY_PERHAPS 228 Note "newer-many-perhaps" "newer-perhaps-hint";
    NEWER_FINE 229 Note "newer-fine" "newer-fine-hint";
    NEWER_AWAY 230 Error "newer-away" "newer-away-hint";
    WRITE_ASSIGNED 231 Note "write-assigned" "write-assigned-hint";
    CONVERT_UNUSED 232 Note "convert-unused" "";
    FOREIGN_LOG 233 Note "foreign-is-log" "foreign-is-log-hint";
    NEWER_PLACES 234 Note "newer-places" "";
    OLDER_UNREAD 235 Warning "older-unread" "older-unread-hint";
    OLDER_BOTH 236 Note "older-both" "";
    NEWER_CENTRE_MISSING 237 Warning "newer-centre-missing" "newer-centre-missing-hint";
    NEWER_CENTRE_UNUSED 237 Warning "newer-centre-unused" "newer-centre-unused-hint";
    NEWER_NO_LIST 238 Warning "newer-no-list" "newer-no-list-hint";
    OLDER_NEW 239 Note "older-new" "";
    OLDER_IDLE 240 Note "older-idle" "";
    DEFINED_HERE 241 Note "defined-here" "defined-here-hint";
    DEFINITION_MANY 242 Warning "definition-many" "definition-many-hint";
    SEARCH_ENDED 243 Note "search-ended" "search-ended-hint";
    BLOCK_LETTER_NAME 244 Warning "block-letter-name" "block-axis-name-hint";
    NCT_PLACE_OPEN 246 Warning "nct-place-open" "nct-place-open-hint";
    REVISE_AROUND 252 Note "revise-around" "";
    REVISE_AROUND_LEFT 253 Warning "revise-around-left" "revise-around-left-hint";
    AROUND_STRAY 253 Warning "around-stray" "around-stray-hint";
}

#[cfg(all(test, feature = "cli"))]
mod tests {
    use super::*;

    // oracle: self (a number is looked up in the table from above)
    #[test]
    fn sentences_stand_in_the_order_of_their_numbers() {
        assert!(ALL.is_sorted_by_key(|one| one.number));
    }

    /// Errors without a hint in the table.
    const NO_HINT: [&str; 10] = [
        "check-missing", // its hint is the reason why the variant needs the value
        // the sentence names what to write
        "syntax-operand", "syntax-equals", "syntax-bracket", "syntax-index", "syntax-text",
        "syntax-comma", // where it is part of a number, that number is the hint
        "syntax-comment", "syntax-define",
        "syntax-exponent", // where it is part of a number, that number is the hint
    ];

    // oracle: hand (the rules for words: a finding says what is wrong, its hint what to do)
    #[test]
    fn an_error_says_what_to_do() {
        let errors = ALL.iter().filter(|one| one.severity == Severity::Error && one.hint.is_empty());
        let found: Vec<&str> = errors.map(|one| one.cause).collect();
        assert_eq!(found, NO_HINT);
    }

    // oracle: self (those of a run begin behind)
    #[test]
    fn no_number_is_one_of_a_run() {
        let first = crate::problem::FIRST;
        assert!(ALL.iter().all(|one| one.number < first));
    }
}
