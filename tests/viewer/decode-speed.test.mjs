/** A level of 105 x 105 decodes in less time than a person notices, every scene's. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, test } from "node:test";
import { gunzipSync } from "node:zlib";
import { DIST, keyedScenes } from "./browser.mjs";
import { loadDecoder } from "./trace/bundle.mjs";
import { best, decodingTimes, middle } from "./trace/times.mjs";

const FINEST = 105;
const FEW = 8; // rounds until the engine has compiled the loops
const MANY = 60; // rounds on a busy machine: what else runs only adds to a time, so the best one counts

// An absolute time decides nothing. The unit is the floor of the dearest level: parsing its text, one look
// at each character, writing as much memory as its trace holds; 2.2 ms on the two-core machine where a
// level has to be there in 25 ms (`node tests/viewer/trace/decode-time.mjs`). Measured there, busy: tiles
// and rays 6.6 units for the two dearest scenes, 1.3 to 2.6 for the others; with all lights 12 and 3 to 5. (The
// colours that rays bring are added up when the first is asked for: one unit more for those two.)
// The decoder before this one, with a list of numbers for each step, took 26.
const START = 11;
const WHOLE = 20;

const textOf = (id) => gunzipSync(readFileSync(`${DIST}/scenes/${id}/${FINEST}.json.gz`)).toString();
const scenes = keyedScenes().map(({ id }) => ({ id, text: textOf(id) }));
const dearest = scenes.reduce((a, b) => (b.text.length > a.text.length ? b : a));
let decoder, unit;

before(async () => {
  decoder = await loadDecoder();
  unit = best((await decodingTimes(decoder, dearest.text, 2 * FEW)).times.floor);
});

for (const { id, text } of scenes) {
  test(`${id} at ${FINEST} x ${FINEST} has tiles and rays within ${START} floors of the dearest level, its lights within ${WHOLE}`, async (t) => {
    const isFast = ({ start, whole }) => start.length >= FEW && best(start) <= START * unit && best(whole) <= WHOLE * unit;
    const { count, times } = await decodingTimes(decoder, text, MANY, isFast);
    const written = (each) => `${best(each).toFixed(1)} ms (middle ${middle(each).toFixed(1)})`;
    t.diagnostic(`${id}: ${count} rays, unit ${unit.toFixed(2)} ms, start ${written(times.start)}, whole ${written(times.whole)}, longest slice of lights ${written(times.slice)}`);
    assert.ok(count >= FINEST * FINEST);
    assert.ok(best(times.start) <= START * unit, `tiles and rays after ${best(times.start) / unit} floors`);
    assert.ok(best(times.whole) <= WHOLE * unit, `the whole trace after ${best(times.whole) / unit} floors`);
  });
}
