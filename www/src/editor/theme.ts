// The editor's look out of the page's design tokens.

import { HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import { EditorView } from "@codemirror/view";
import { tags } from "@lezer/highlight";

const v = (token: string): string => `var(--${token})`;

const look = EditorView.theme({
  "&": { height: "100%", color: v("ink"), backgroundColor: v("surface"), fontSize: v("text-code") },
  "&.cm-focused": { outline: `2px solid ${v("focus")}`, outlineOffset: "-2px" },
  ".cm-scroller": { fontFamily: v("mono"), lineHeight: "1.5" },
  ".cm-content": { caretColor: v("ink"), paddingBlock: "6px" },
  ".cm-cursor": { borderLeftColor: v("ink"), borderLeftWidth: "2px" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": {
    backgroundColor: v("selection"),
  },
  ".cm-gutters": {
    backgroundColor: v("ground"),
    color: v("ink-quiet"),
    borderRight: `1px solid ${v("rule")}`,
    fontVariantNumeric: "tabular-nums",
  },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: v("active-line") },
  ".cm-call": { boxShadow: `inset 3px 0 0 ${v("rule-strong")}` },
  ".cm-call-open": { boxShadow: `inset 3px 0 0 ${v("accent")}`, backgroundColor: v("accent-soft") },
  ".cm-lit": {
    borderRadius: "3px",
    backgroundColor: v("measure-soft"),
    boxShadow: `0 0 0 1px ${v("touch")}`,
  },
  ".cm-step": { backgroundColor: v("step-line") },
  ".cm-held": {
    color: v("warning"),
    border: `1px solid ${v("rule-strong")}`,
    borderRadius: "2px",
    fontSize: "0.8em",
    paddingInline: "1px",
  },
  ".cm-hint": {
    marginLeft: "2ch",
    color: v("ink-code"),
    fontFamily: v("sans"),
    fontSize: v("text-small"),
    userSelect: "none",
    pointerEvents: "none",
  },
  ".cm-tooltip": { backgroundColor: v("surface-raised"), color: v("ink"), border: `1px solid ${v("rule-strong")}` },
  ".cm-tooltip-hover": { maxHeight: "220px", overflowY: "auto" },
  ".cm-told": {
    maxWidth: "min(60ch, 90vw)",
    padding: "6px 8px",
    fontFamily: v("sans"),
    fontSize: v("text-small"),
    overflowWrap: "anywhere",
  },
  ".cm-told p": { margin: "0" },
  ".cm-diagnostic": { fontFamily: v("sans"), fontSize: v("text-small") },
  "@media (forced-colors: active)": {
    ".cm-call-open": { borderLeft: "3px solid Highlight" },
    ".cm-lit": { outline: "2px solid Highlight" },
    ".cm-step": { outline: "2px solid Highlight", outlineOffset: "-2px" },
  },
  ".cm-panels": { backgroundColor: v("ground"), color: v("ink") },
  ".cm-textfield, .cm-button": {
    backgroundColor: v("surface"),
    backgroundImage: "none",
    color: v("ink"),
    border: `1px solid ${v("rule-strong")}`,
  },
});

const colours = HighlightStyle.define([
  { tag: tags.comment, color: v("code-comment"), fontStyle: "italic" },
  { tag: [tags.keyword, tags.controlKeyword, tags.operatorKeyword, tags.typeName], color: v("code-keyword") },
  { tag: [tags.function(tags.variableName)], color: v("code-call"), fontWeight: "600" },
  { tag: [tags.variableName, tags.special(tags.variableName)], color: v("code-variable") },
  { tag: [tags.number, tags.string], color: v("code-number") },
  { tag: [tags.labelName, tags.meta], color: v("ink-quiet") },
]);

export const theme = [look, syntaxHighlighting(colours)];
