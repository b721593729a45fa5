/** What-if switches, tile views and boxes as laws of the state, with no browser. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { keyedScenes } from "./browser.mjs";
import { readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { createWhatIf, AS_TRACED, isSwitched, lampsOf, readSwitches, setLamp, stepBounces, switchesFrom, turnLamp, turnPart, turnShadows, writeSwitches, partsOf } = await load("state/what-if.ts", "state/switches.ts", "state/switching.ts", "state/switchable.ts");
const { costsOf, onScale, linesOf, treeOf, eventsOf, TILE_VIEWS, boxesOf } = await load("state/costs.ts", "state/tile-views.ts", "state/lines.ts", "state/events.ts", "trace/boxes.ts");

const mirrors = readTrace("05-many-bounces", 15);
const glass = readTrace("08-glass", 15);
const switched = ({ scene, trace }, ...turns) => {
  const switches = turns.reduce((now, turn) => turn(now, scene), AS_TRACED);
  return { switches, ...createWhatIf().of(trace, scene, switches) };
};

test("with nothing switched the trace itself is shown", () => {
  const now = switched(mirrors);
  assert.equal(now.trace, mirrors.trace);
  assert.equal(now.scene, mirrors.scene);
});

test("a switch turned on and off again leaves all as traced", () => {
  const { scene } = mirrors;
  for (const turn of [turnShadows, (now, of) => turnLamp(now, of, 0), (now, of) => turnPart(now, of, "specular"), (now, of) => stepBounces(now, of, now.bounces === null ? -1 : 1)])
    assert.equal(isSwitched(turn(turn(AS_TRACED, scene), scene)), false);
});

test("the bounce limit hides rays beyond it, and goes no higher than was traced", () => {
  const { scene } = mirrors;
  let switches = AS_TRACED;
  assert.equal(stepBounces(switches, scene, 1), switches);
  for (let k = 0; k < scene.depth; k++) switches = stepBounces(switches, scene, -1);
  assert.equal(switches.bounces, 0);
  assert.equal(stepBounces(switches, scene, -1), switches);
  const now = createWhatIf().of(mirrors.trace, scene, switches);
  for (let pixel = 0; pixel < 225; pixel++) assert.deepEqual(treeOf(now.trace, pixel), [pixel]);
  assert.ok(eventsOf(now.trace, now.scene, 7 * 15 + 9).some(({ what, atLimit, limit }) => what === "stops" && atLimit && limit === 0));
});

test("with a lamp off its shadow rays go and its event says so; with shadows off all of them go", () => {
  const pixel = 12 * 15 + 7;
  const lightsOf = ({ trace, scene }) => linesOf(trace, scene, pixel).filter(({ light }) => light >= 0).map(({ light }) => light);
  assert.ok(lightsOf(mirrors).includes(0));
  const off = switched(mirrors, (now, of) => turnLamp(now, of, 0));
  assert.ok(lightsOf(off).length > 0 && !lightsOf(off).includes(0));
  assert.ok(eventsOf(off.trace, off.scene, pixel).some(({ what, name }) => what === "off" && name === "light 1"));
  const bare = switched(mirrors, turnShadows);
  assert.deepEqual(lightsOf(bare), []);
  assert.ok(eventsOf(bare.trace, bare.scene, pixel).some(({ what }) => what === "unasked"));
});

test("without reflected and refracted light no ray is sent on", () => {
  const now = switched(glass, (s, of) => turnPart(s, of, "reflected"), (s, of) => turnPart(s, of, "refracted"));
  for (let pixel = 0; pixel < 225; pixel++) assert.equal(treeOf(now.trace, pixel).length, 1);
});

for (const [name, { scene, trace }] of Object.entries({ mirrors, glass }))
  test(`${name}: every ray's colour is its terms' sum, whatever is switched`, () => {
    for (const text of ["b1", "l1x0", "l2x1.5,-shadows", "-ambient,-specular", "-reflected", "-refracted,b3"]) {
      const now = createWhatIf().of(trace, scene, readSwitches(text, scene));
      for (let pixel = 0; pixel < trace.n * trace.n; pixel += 7) {
        const end = eventsOf(now.trace, now.scene, pixel).at(-1);
        for (let c = 0; c < 3; c++) {
          const sum = end.terms.reduce((total, { share, colour }) => total + share * colour[c], 0);
          // Sums in another order: some roundings of float64.
          assert.ok(Math.abs(sum - end.colour[c]) < 1e-12, `${text}, pixel ${pixel}`);
          // Tiles come exact, what rays give is rounded in files: a tile that no switch changes keeps its byte.
          const k = 3 * pixel + c;
          const isAsTraced = now.trace.colour[k] === trace.colour[k];
          assert.equal(end.bytes[c], isAsTraced ? trace.tiles[k] : Math.floor(255 * Math.min(1, Math.max(0, end.colour[c])) + 0.5));
        }
      }
    }
  });

test("dimming leaves the lines what they are: the same columns, not new ones", () => {
  const whatIf = createWhatIf();
  const dim = (factor) => whatIf.of(glass.trace, glass.scene, setLamp(AS_TRACED, glass.scene, 0, factor)).trace;
  const [a, b] = [dim(0.5), dim(0.6)];
  assert.equal(a.pixel, b.pixel);
  assert.equal(a.visibility, b.visibility);
  assert.notDeepEqual(a.tiles, b.tiles);
});

test("an address names switches shortly, and what a scene does not have is refused", () => {
  const { scene } = mirrors;
  const all = switched(mirrors, (s, of) => stepBounces(s, of, -1), (s, of) => setLamp(s, of, 1, 1.5), (s, of) => turnLamp(s, of, 0), turnShadows, (s, of) => turnPart(s, of, "diffuse")).switches;
  assert.equal(writeSwitches(all), "b9,l1x0,l2x1.5,-shadows,-diffuse");
  assert.deepEqual(readSwitches(writeSwitches(all), scene), all);
  for (const text of ["", "b11", "b-1", "l3x0", "l0x1", "l1x3", "l1x", "-light", "shadows", "b1,,b2", "constructor"]) assert.equal(readSwitches(text, scene), null, text);
});

test("a lesson names lamps by name, and a whole area light by its own", () => {
  const lights = [1, 2, 3].map((k) => ({ ...mirrors.scene.lights[0], name: k < 3 ? `panel ${k}/2` : "spot" }));
  const scene = { ...mirrors.scene, lights };
  assert.deepEqual(lampsOf(scene), [{ name: "panel", lights: [0, 1] }, { name: "spot", lights: [2] }]);
  assert.deepEqual(switchesFrom({ bounces: 1, lights: { panel: 0 }, shadows: false, without: ["specular"] }, scene), { bounces: 1, lamps: [0, 1], shadows: false, without: ["specular"] });
});

test("only parts that a scene has are offered", () => {
  assert.deepEqual(partsOf(mirrors.scene), ["ambient", "diffuse", "specular", "reflected"]);
  assert.ok(partsOf(glass.scene).includes("refracted"));
});

test("tiles show the picture, or numbers that are the tree's", () => {
  const { trace } = glass;
  assert.equal(costsOf(trace, glass.scene, "picture").colours, trace.tiles);
  const { values } = costsOf(trace, glass.scene, "rays");
  const { values: deep } = costsOf(trace, glass.scene, "depth");
  const { values: tests } = costsOf(trace, glass.scene, "tests");
  for (let pixel = 0; pixel < 225; pixel += 4) {
    const tree = treeOf(trace, pixel);
    assert.equal(values[pixel], linesOf(trace, glass.scene, pixel).length);
    assert.equal(deep[pixel], Math.max(...tree.map((ray) => trace.depth[ray])));
    assert.equal(tests[pixel], tree.reduce((sum, ray) => sum + trace.tests[ray], 0));
  }
  const far = costsOf(trace, glass.scene, "distance");
  assert.ok(far.values.every((value, pixel) => Number.isNaN(value) ? trace.object[pixel] < 0 : value === trace.t[pixel]));
  assert.equal(TILE_VIEWS.length, 7);
});

const litBy = ({ scene, trace }, ...turns) => {
  const dark = { ...scene, background: [0, 0, 0] };
  const { trace: now } = switched({ scene: dark, trace }, (of, to) => turnPart(of, to, "ambient"), ...turns);
  return Float64Array.from({ length: trace.n ** 2 }, (_, pixel) => now.colour[3 * pixel] + now.colour[3 * pixel + 1] + now.colour[3 * pixel + 2]);
};

for (const id of ["02-shadows", "03-two-lights", "05-many-bounces", "08-glass"])
  test(`${id}: the share in shadow is what turning shadows off would add to the lamps' part of each pixel, of the sum`, () => {
    const read = readTrace(id, 15);
    const { values } = costsOf(read.trace, read.scene, "shadow");
    const [shaded, unshaded] = [litBy(read), litBy(read, turnShadows)];
    assert.ok(values.some((value) => value > 0.05) && values.some((value) => value < 0.05), "some of each");
    for (let pixel = 0; pixel < 225; pixel++)
      if (Number.isNaN(values[pixel])) assert.equal(unshaded[pixel], 0);
      else assert.ok(Math.abs(values[pixel] - (1 - shaded[pixel] / unshaded[pixel])) < 1e-9, `pixel ${pixel}: ${values[pixel]}`); // sums in another order
  });

test("the share in shadow follows the switches: none without shadows, and a lamp that is off counts neither way", () => {
  const read = readTrace("03-two-lights", 15);
  const none = switched(read, turnShadows);
  assert.ok(costsOf(none.trace, none.scene, "shadow").values.every((value) => Number.isNaN(value) || value === 0));
  const one = switched(read, (of, scene) => turnLamp(of, scene, 0));
  const { values, least, most } = costsOf(one.trace, one.scene, "shadow");
  assert.deepEqual([least, most], [0, 1]); // of all: tiles of different scenes compare
  for (let pixel = 0; pixel < 225; pixel++) {
    const seen = one.trace.visibility[2 * pixel + 1]; // of the other lamp; nothing mirrors here
    if (one.trace.object[pixel] >= 0 && seen < 2) assert.ok(Number.isNaN(values[pixel]) || values[pixel] === 1 - seen);
  }
});

test("the scale of colours grows lighter from end to end, for every kind of colour vision", () => {
  const light = (share) => onScale(share).reduce((sum, v, c) => sum + v * [0.2126, 0.7152, 0.0722][c], 0);
  for (let k = 0; k < 100; k++) assert.ok(light((k + 1) / 100) > light(k / 100), `${k} %`);
});

test("a normal's tile is (n + 1) / 2, of a ray that leaves a dark one", () => {
  const { colours } = costsOf(glass.trace, glass.scene, "normal");
  for (let pixel = 0; pixel < 225; pixel++)
    if (glass.trace.object[pixel] >= 0) for (let c = 0; c < 3; c++) assert.equal(colours[3 * pixel + c], Math.round((255 * (glass.trace.normal[3 * pixel + c] + 1)) / 2));
    else assert.ok(colours[3 * pixel] < 30);
});

test("boxes come back from their runs; a box is tested where its parent is entered", () => {
  const box = (k) => [k, 0, 0, k + 1, 1, 1];
  const mesh = { object: 0, triangles: 1000, sphere: [0, 0, 0, 2], boxes: [box(0), box(1), box(2)], parents: [-1, 0, 0], levels: { 2: [[1, 2, 1], [1, 2, 1], [2, 1, 1], []] } };
  const data = { format: 1, scene: "x", primitives: 3, meshes: [mesh] };
  assert.deepEqual(boxesOf(data, 2, 0).boxes, []);
  assert.deepEqual(boxesOf(data, 2, 1).boxes.map(({ entered }) => entered), [true, false, false]);
  assert.deepEqual(boxesOf(data, 2, 2).boxes.map(({ entered }) => entered), [true, true, false]);
  assert.equal(boxesOf(data, 2, 3).spheres[0].entered, false);
  assert.equal(boxesOf(data, 2, 1).without, 1003);
});

test("what the lessons say of switches is so", () => {
  const byKey = new Map(keyedScenes().map(({ key, id }) => [key, id]));
  /** 8-bit colours of a step's pixel before and after its answer: of the first whose answer sets a switch. */
  const colours = (key) => {
    const { scene } = readTrace(byKey.get(key), 15);
    const step = scene.lesson.find(({ answer }) => answer?.view.switches);
    const n = step.view.resolution;
    const { trace } = readTrace(byKey.get(key), n);
    const of = (view) => [...createWhatIf().of(trace, scene, switchesFrom(view.switches, scene)).trace.tiles.slice(3 * (step.view.pixel[1] * n + step.view.pixel[0])).slice(0, 3)];
    return [of(step.view), of(step.answer.view)];
  };
  if (byKey.has("1")) {
    // Twice the light: what it gives doubles, and the ambient part stays.
    const [once, twice] = colours("1");
    assert.ok(once.every((of, c) => twice[c] >= of && twice[c] <= Math.min(255, 2 * of)) && Math.max(...twice) > 1.4 * Math.max(...once), `${once} ${twice}`);
  }
  if (byKey.has("2")) {
    const [dark, green] = colours("2");
    assert.deepEqual(dark, [26, 26, 26]);
    assert.ok(green[1] > 2 * green[0] && green[1] > 100, `${green}`);
  }
  if (byKey.has("3")) assert.deepEqual(...colours("3"), "not one digit changes");
  if (byKey.has("4")) {
    const [floor, none] = colours("4");
    assert.ok(Math.min(...floor) > 60, `${floor}`);
    assert.deepEqual(none, [0, 0, 0]);
  }
  if (byKey.has("5")) {
    const [wall, cut] = colours("5");
    assert.ok(Math.min(...wall) > 60, `${wall}`);
    assert.deepEqual(cut, [0, 0, 0]);
  }
  if (byKey.has("8")) {
    const [orange, left] = colours("8");
    assert.ok(orange[0] > 1.5 * orange[2], `${orange}`);
    assert.ok(Math.max(...left) < 20, `${left}`); // 5.9 % of a floor that is at most white: 15
  }
  if (byKey.has("0")) {
    const [grey, dark] = colours("0");
    assert.ok(Math.max(...dark) < 0.8 * Math.max(...grey), `${grey} ${dark}`);
  }
});
