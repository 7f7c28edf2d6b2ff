// A language that nobody speaks, made from English: longer by some 40 %, with accents, between brackets. It stands
// beside the others as a folder of words would, in the pages that tests serve and nowhere else.
import { packages } from "./browser.mjs";

const { FluentResource } = packages("@fluent/bundle");

/** Its code, and its brackets. */
export const PSEUDO = "qps";
export const [OPEN, CLOSE] = ["⟦", "⟧"];

const ACCENTED = Object.fromEntries(
  ["aáá", "eéé", "iíí", "oóó", "uúú", "yý", "cç", "nñ", "sš", "zž", "AÁ", "EÉ", "IÍ", "OÓ", "UÚ", "CÇ", "NÑ", "SŠ"].map(
    ([letter, ...accented]) => [letter, accented.join("")],
  ),
);

const longer = text => text.replace(/[a-zA-Z]/g, letter => ACCENTED[letter] ?? letter);

/** What a placeable says, as Fluent writes it. */
function placeable(part) {
  switch (part.type) {
    case "str":
      return JSON.stringify(part.value);
    case "num":
      return String(part.value);
    case "var":
      return `$${part.name}`;
    case "mesg":
      return [part.name, part.attr].filter(Boolean).join(".");
    case "narg":
      return `${part.name}: ${placeable(part.value)}`;
    case "func":
      return `${part.name}(${part.args.map(placeable).join(", ")})`;
    case "select": {
      const variants = part.variants.map(({ key, value }, at) => {
        const name = key.type === "num" ? key.value : key.value;
        return `\n    ${at === part.star ? "*" : ""}[${name}] ${pattern(value)}`;
      });
      return `${placeable(part.selector)} ->${variants.join("")}\n    `;
    }
    default:
      throw new Error(`no way to write ${JSON.stringify(part)}`);
  }
}

const written = text => longer(text).replace(/\n/g, "\n    ");

function pattern(value) {
  const parts = typeof value === "string" ? [value] : value;
  return parts.map(part => (typeof part === "string" ? written(part) : `{ ${placeable(part)} }`)).join("");
}

/** A unit or the name of an axis is the same in every language. */
const isSymbol = value => typeof value === "string" && /^[^a-z]*[a-z]{0,2}[^a-z]*$/i.test(value);

const said = value => (isSymbol(value) ? value : `${OPEN}${pattern(value)}${CLOSE}`);

/** The messages of a Fluent text in it. */
export function pseudo(text) {
  const { body } = new FluentResource(text);
  const message = ({ id, value, attributes }) => {
    const own = Object.entries(attributes).map(([name, text]) => `\n    .${name} = ${said(text)}`);
    return `${id} =${value === null ? "" : ` ${said(value)}`}${own.join("")}`;
  };
  return body.map(message).join("\n");
}

/** Puts it beside the languages that there are, as the page's build has them. */
export function speaksPseudo() {
  let words;
  const text = async part => {
    const module = await words.load.call({ addWatchFile() {} }, `\0words:en/${part}`);
    return JSON.parse(module.replace("export default ", ""));
  };
  return {
    name: "pseudo",
    enforce: "pre",
    configResolved({ plugins }) {
      words = plugins.find(({ name }) => name === "words");
    },
    async load(id) {
      const [, part] = new RegExp(`^\0words:${PSEUDO}/(.+)$`).exec(id) ?? [];
      return part && `export default ${JSON.stringify(pseudo(await text(part)))}`;
    },
    transform(code, id) {
      if (id !== "\0words:all") return null;
      const fetched = part => `${part}.${PSEUDO} = () => import("words:${PSEUDO}/${part}").then(made => made.default);`;
      return [code, fetched("whole"), fetched("help")].join("\n");
    },
  };
}
