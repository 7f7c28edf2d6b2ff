// What is written in the help picture of every variant, in drawings of any size and with anything typed: captions never
// lie upon each other, none sticks out, and what stands far from its figure has a line to it.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { random } from "./random.mjs";
import { modules, program } from "./sources.mjs";

let sources, captions, drawing, core;
before(async () => {
  sources = await modules();
  [captions, { drawing }] = await Promise.all(
    ["captions", "drawing"].map(name => sources.load(`/src/views/${name}.ts`)),
  );
  core = await program();
});
after(() => sources.close());

const SEED = Number(process.env.PROBEWRIGHT_SEED ?? 1);
const ROUNDED = 0.02; // pixels: places are written with two decimals
const TYPED = ["50", "-12.375", "R2", "2*R3+50.25", "R12+SIN(R4)*(R5-0.5)+_CORRECTION[3]", "测量长度", ""];

/** Form and help picture of every variant. */
function* pictures() {
  for (const { control, cycle, variants, purpose } of JSON.parse(core.catalogue()).cycles)
    for (const variant of variants) {
      const plane = purpose?.plane ?? "G17";
      const { example } = variant.planes?.[plane] ?? variant;
      const answer = core.form_seen(JSON.stringify({ control, cycle, values: example, setup: { own: { plane } } }));
      const { picture, fields } = JSON.parse(answer.view());
      answer.free();
      yield { name: `${cycle} ${variant.mvar}`, picture, fields, example };
    }
}

/** The captions of a drawing, as they stand. */
const written = drawn =>
  drawn.flatMap(({ children }) =>
    children
      .filter(({ tag }) => tag === "text")
      .map(({ text, attributes: { x, y, "text-anchor": anchor } }) => ({
        text,
        box: captions.room({ text, anchor }, [Number(x), Number(y)]),
      })),
  );
const wanted = ({ shapes }) => shapes.filter(({ text }) => text).length;

function held(name, all, size) {
  for (const [i, { text, box }] of all.entries()) {
    const told = `${name}, ${size.width} x ${size.height}: ${text}`;
    assert.ok(captions.within(box, size), `${told} sticks out`);
    for (const other of all.slice(0, i)) {
      const across = Math.min(box.right, other.box.right) - Math.max(box.left, other.box.left);
      const down = Math.min(box.bottom, other.box.bottom) - Math.max(box.top, other.box.top);
      assert.ok(across <= ROUNDED || down <= ROUNDED, `${told} lies upon ${other.text}`);
    }
  }
}

// oracle: hand (no two rectangles have anything in common, and none sticks out)
test("captions never lie upon each other, whatever is typed and however small the drawing", () => {
  const draw = random(SEED);
  let count = 0;
  for (const { name, picture, fields } of pictures())
    for (let n = 0; n < 6; n++) {
      const size = { width: Math.round(120 + 600 * draw()), height: Math.round(100 + 400 * draw()) };
      const values = Object.fromEntries(fields.map(field => [field.name, TYPED[Math.floor(draw() * TYPED.length)]]));
      const all = written(drawing(picture.shapes, values, size));
      held(name, all, size);
      count += all.length;
    }
  assert.ok(count > 5000, `${count} captions`);
});

// oracle: hand (a figure that is named in the picture is named in the drawing)
test("in a form of common size every figure has its caption", () => {
  for (const { name, picture, example } of pictures())
    for (const size of [
      { width: 420, height: 176 },
      { width: 360, height: 158 },
      { width: 220, height: 300 },
    ]) {
      const all = written(drawing(picture.shapes, example, size));
      assert.equal(all.length, wanted(picture), `${name}, ${size.width} x ${size.height}`);
    }
});
