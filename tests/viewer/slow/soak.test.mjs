/** A kiosk that nobody touches: lesson after lesson, round after round, and what the page holds does not grow. Every
 *  round is measured at the same place: at the first scene's first stop, while nothing moves. */
import assert from "node:assert/strict";
import { appendFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, keyedScenes } from "../browser.mjs";
import { countGpu, grown, memoryOf, objectsIn } from "../memory.mjs";

// `make stress` asks for 2,000 cycles or half an hour, with tiles that fill and rays that grow. A cycle is a lesson.
const IS_LONG = !!process.env.RAYWALK_SOAK_CYCLES;
// The short one shows every second scene: more than stay on the graphics card.
const scenes = keyedScenes().filter((_, k) => IS_LONG || k % 2 === 0);
const CYCLES = Number(process.env.RAYWALK_SOAK_CYCLES ?? 2 * scenes.length);
const MINUTES = Number(process.env.RAYWALK_SOAK_MINUTES ?? 60);
/** A file that gets a line a round, and every tenth time what the objects take, while it runs. */
const SERIES = process.env.RAYWALK_SOAK_SERIES;
/** Bytes of the page's own objects: tables in them double when they are full. */
const OBJECT_SLACK = 100_000;
/** Bytes of strings: the engine holds the text it has unpacked last (176 kB) or has let go of it. */
const STRING_SLACK = 300_000;
/** Bytes with the engine's compiled code, which grows with ever rarer functions. */
const HEAP_SLACK = 4e6;
/** Bytes by which the last quarter of the rounds may be above the one before: code levels off, a leak does not. */
const STILL_RISING = 0.5e6;
/** Lines and dots of the last four scenes have buffers or not, by which of their stops were drawn. The rest is exact. */
const APART = { nodes: 10, Buffer: 80, VertexArray: 25 };
const COUNTED = ["nodes", "listeners", "documents", "Buffer", "VertexArray", "Texture", "Framebuffer", "Renderbuffer", "Program", "Shader"];
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { viewport: { width: 640, height: 480 } });
  await page.addInitScript(countGpu);
});
after(() => browser.close());

/** These scenes are shown. Every one is drawn, also where frames are slower than stops: the last few stay on the graphics card, always the
 *  same ones then. And the attract loop waits at the first scene's first stop until it is let go. */
const restBetweenRounds = () =>
  page.evaluate((ids) => {
    const { viewer } = window.raywalkKiosk;
    viewer.ids = ids;
    const { begin } = viewer;
    viewer.begin = async (id) => {
      const isShown = await begin(id);
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      if (id === ids[0]) await new Promise((go) => (window.letGo = go));
      window.letGo = null;
      return isShown;
    };
  }, scenes.map(({ id }) => id));

/** Until the first scene stands there again, drawn and at rest: how many lessons have been shown. */
const round = () =>
  page.evaluate(async () => {
    window.letGo?.();
    do await new Promise((done) => setTimeout(done, 10));
    while (!window.letGo);
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done, 300))); // spoken, written into the address
    return { cycles: window.raywalk.stats().kiosk.cycles, ...window.gpuHeld };
  });

const mean = (numbers) => numbers.reduce((sum, each) => sum + each, 0) / numbers.length;
/** Of the last quarter above the one before. */
function stillRising(heaps) {
  const quarter = Math.floor(heaps.length / 4);
  return quarter < 3 ? 0 : Math.round(mean(heaps.slice(-quarter)) - mean(heaps.slice(-2 * quarter, -quarter)));
}

test(`${CYCLES} lessons shown unattended: heap, nodes, listeners, buffers, textures and programs stay as they are`, async () => {
  const start = Date.now();
  const end = start + 60_000 * MINUTES;
  await open(page, ON_DISK, scenes[0].path, `kiosk=1&attract-pace=0.02${IS_LONG ? "" : "&still=1"}`);
  await page.waitForFunction(() => window.raywalk.stats().kiosk?.attract);
  await restBetweenRounds();
  const { measure, snapshot } = await memoryOf(page);
  const rounds = [];
  let [earlier, later] = [null, null];
  for (let cycles = 0; cycles < CYCLES && Date.now() < end; ) {
    const shown = await round();
    cycles = shown.cycles - (rounds[0]?.cycles ?? shown.cycles); // some were shown while parts came
    rounds.push({ ...shown, ...(await measure()) });
    if (rounds.length === 2) earlier = objectsIn(await snapshot());
    if (!SERIES) continue;
    const { objects, strings, code } = rounds.length % 10 ? {} : objectsIn(await snapshot());
    appendFileSync(SERIES, `${JSON.stringify({ seconds: Math.round((Date.now() - start) / 1000), ...rounds.at(-1), objects, strings, code })}\n`);
  }
  later = objectsIn(await snapshot());
  const [first, ...others] = rounds.slice(1); // in the first round everything is loaded and compiled
  const last = others.at(-1);
  const heaps = [first, ...others].map(({ heap }) => heap);
  const rising = stillRising(heaps);
  const both = (what) => [first[what], last[what]];
  const result = { cycles: last.cycles, seconds: Math.round((Date.now() - start) / 1000), objects: [earlier.objects, later.objects], strings: [earlier.strings, later.strings], code: [earlier.code, later.code], heaps, rising, counts: Object.fromEntries(COUNTED.map((what) => [what, both(what)])), faults: page.faults.length };
  console.log(`soak ${JSON.stringify(result)}`);
  assert.ok(later.objects <= earlier.objects + OBJECT_SLACK, `objects: ${earlier.objects}, after ${last.cycles} lessons ${later.objects}: ${grown(earlier, later)}`);
  assert.ok(later.strings <= earlier.strings + STRING_SLACK, `strings: ${earlier.strings}, after ${last.cycles} lessons ${later.strings}`);
  assert.ok(rising <= STILL_RISING, `heap still rising: ${rising} from quarter to quarter`);
  for (const each of others) {
    for (const what of COUNTED) assert.ok(each[what] <= first[what] + (APART[what] ?? 0), `${what}: ${first[what]}, after ${each.cycles} lessons ${each[what]}`);
    assert.ok(each.heap <= first.heap + HEAP_SLACK, `heap: ${first.heap}, after ${each.cycles} lessons ${each.heap}`);
  }
  assert.deepEqual(page.faults, []);
});
