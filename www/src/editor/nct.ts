// Highlighting of NCT part programs: words of a letter and a number, comments in brackets, macro variables.

import { StreamLanguage, type StreamParser } from "@codemirror/language";

const CONTROL = /^(IF|THEN|ELSE|WHILE|DO\d*|END\d*|GOTO)(?![A-Z])/i;

const parser: StreamParser<{ comment: boolean }> = {
  name: "nct",
  startState: () => ({ comment: false }),
  token(stream, state) {
    if (state.comment || stream.match("(")) {
      state.comment = !stream.match(/^[^)]*\)/);
      if (state.comment) {
        stream.skipToEnd();
        state.comment = false;
      }
      return "comment";
    }
    if (stream.eatSpace()) return null;
    if (stream.sol() && stream.match(/^%/)) return "meta";
    if (stream.match(/^[ON]\d+/i)) return "labelName";
    if (stream.match(CONTROL)) return "controlKeyword";
    if (stream.match(/^(EQ|NE|GT|LT|GE|LE|AND|OR|XOR|MOD)(?![A-Z])/i)) return "operatorKeyword";
    if (stream.match(/^(SIN|COS|TAN|ATAN|ASIN|ACOS|SQRT|ABS|ROUND|FIX|FUP|LN|EXP)(?=\[)/i))
      return "variableName.function";
    if (stream.match(/^#\d*/)) return "variableName";
    if (stream.match(/^[GM]\d+(\.\d+)?/i)) return "keyword";
    if (stream.match(/^[A-Z]/i)) return "propertyName";
    if (stream.match(/^(\d+\.?\d*|\.\d+)/)) return "number";
    if (stream.match(/^[-+*/=]/)) return "operator";
    if (stream.match(/^[[\],]/)) return "punctuation";
    stream.next();
    return null;
  },
};

export const nct = StreamLanguage.define(parser);
