// Highlighting of SINUMERIK part programs: enough to read them, no judgement (that is the core's).

import { StreamLanguage, type StreamParser } from "@codemirror/language";

const CONTROL = new Set(
  [
    "IF ELSE ENDIF FOR TO ENDFOR WHILE ENDWHILE REPEAT UNTIL LOOP ENDLOOP",
    "GOTO GOTOF GOTOB CASE OF DEFAULT PROC RET EXTERN",
  ].flatMap(line => line.split(" ")),
);
const TYPES = new Set("DEF REAL INT BOOL CHAR STRING AXIS FRAME".split(" "));
const OPERATORS = new Set("AND OR NOT XOR B_AND B_OR B_NOT B_XOR DIV MOD".split(" "));

function word(text: string): string {
  const upper = text.toUpperCase();
  if (CONTROL.has(upper)) return "controlKeyword";
  if (TYPES.has(upper)) return "typeName";
  if (OPERATORS.has(upper)) return "operatorKeyword";
  if (/^[GM]\d+$/.test(upper)) return "keyword";
  if (/^R\d+$/.test(upper) || /^_/.test(upper)) return "variableName";
  if (/^(CYCLE|L|HOLES|POCKET|SLOT)\d+$/.test(upper)) return "variableName.function";
  if (/^[A-Z]{1,2}\d*$/.test(upper)) return "propertyName";
  return "name";
}

const parser: StreamParser<{ start: boolean }> = {
  name: "sinumerik",
  startState: () => ({ start: true }),
  token(stream, state) {
    if (stream.sol()) state.start = true;
    if (stream.eatSpace()) return null;
    const start = state.start;
    state.start = false;
    if (stream.match(/^;.*/)) return "comment";
    if (start && (stream.match(/^\/\d?/) || stream.match(/^N\d+/i))) {
      state.start = true;
      return "labelName";
    }
    if (start && stream.match(/^[A-Z_]\w+:/i)) return "labelName";
    if (start && stream.match(/^%.*/)) return "meta";
    if (stream.match(/^"[^"]*"?/)) return "string";
    if (stream.match(/^\$[A-Z_]\w*/i)) return "variableName.special";
    if (stream.match(/^(\d+\.?\d*|\.\d+)(EX[-+]?\d+)?/i)) return "number";
    if (stream.match(/^_\w+/)) return "variableName";
    const letters = stream.match(/^[A-Z][A-Z_]*(?=[-+.\d])\d*(?![\w])/i) ?? stream.match(/^[A-Z]\w*/i);
    if (letters && typeof letters !== "boolean") return word(letters[0]);
    if (stream.match(/^(<>|<=|>=|==|<<|[-+*/=<>])/)) return "operator";
    if (stream.match(/^[[\](),]/)) return "punctuation";
    stream.next();
    return null;
  },
  languageData: { commentTokens: { line: ";" } },
};

export const sinumerik = StreamLanguage.define(parser);
