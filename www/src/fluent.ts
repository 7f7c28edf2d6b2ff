// The messages of a language. Each is read when it is first wanted: a first visit shows a fifth of them, and to read
// them all takes longer than to draw its form.
import { FluentBundle, FluentResource } from "@fluent/bundle";

type Pattern = Parameters<FluentBundle["formatPattern"]>[0];
type Given = NonNullable<Parameters<FluentBundle["formatPattern"]>[1]>;

export interface Messages {
  /** Further messages, in the syntax of Fluent. */
  add(text: string): void;
  /** What a message or its attribute says; none where there is no such message. */
  pattern(id: string, attribute?: string): Pattern | null | undefined;
  format(pattern: Pattern, given: Given, problems: Error[]): string;
}

const NEXT = /\n(?=[a-z])/; // what goes on with a message begins with a blank
const NAME = /^[a-z][\w-]*/;
const NAMED = /\{\s*([a-z][\w-]*)/g; // messages that a message contains

export function createMessages(language: string): Messages {
  const bundle = new FluentBundle(language, { useIsolating: false });
  const unread = new Map<string, string>();

  const read = (id: string): void => {
    const text = unread.get(id);
    if (text === undefined) return;
    unread.delete(id);
    for (const problem of bundle.addResource(new FluentResource(text))) console.error(`messages: ${problem.message}`);
    for (const [, other = ""] of text.matchAll(NAMED)) read(other);
  };
  return {
    add(text) {
      for (const one of text.split(NEXT)) {
        const id = NAME.exec(one)?.[0];
        if (id === undefined) continue;
        if (unread.has(id) || bundle.hasMessage(id)) console.error(`messages: ${id} twice`);
        else unread.set(id, one);
      }
    },
    pattern(id, attribute) {
      read(id);
      const message = bundle.getMessage(id);
      return attribute ? message?.attributes[attribute] : message?.value;
    },
    format: (pattern, given, problems) => bundle.formatPattern(pattern, given, problems),
  };
}
