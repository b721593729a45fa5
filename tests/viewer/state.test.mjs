/** Laws of the state, with no browser: addresses, grids, projections, the picture plane. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./typescript.mjs";

const { startState, select, move, stepLevel, setLevel, pressRender, advance, tilesShown, applyView, goToStep, isAsking, turnStep, writeAddress, followAddress, readAddress } =
  await load("state/view-state.ts", "state/address.ts");
const { picturePlane, onPlane, observerOf, orbit, pan, zoom, createProjection, contrastWith, LINES, STAGE, rgb, lightColours, treeOf, linesOf } = await load(
  "state/frustum.ts", "state/observer.ts", "state/projection.ts", "state/lines.ts", "palette.ts", "light-page.ts",
);

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const scene = {
  format: 1, id: "05-mirrors", key: "5", title: "", teaches: "", picture: "picture.png", size: 1155,
  camera: { eye: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], fov: 45 },
  background: [0, 0, 0], shadows: true, depth: 8,
  levels: [5, 7, 11, 15, 21, 33, 55, 77, 105], start: { resolution: 15, pixel: [7, 9] },
  bounds: { center: [0, 0, 1.5], radius: 4 }, materials: [], meshes: {},
  objects: [{ name: "ball", type: "sphere", label: "sphere", material: 0, transform: identity }],
  lights: [{ name: "light 1", position: [-1, 2, 1], colour: [1, 1, 1], intensity: 1 }],
  lesson: [{ html: "", view: { pixel: [1, 2] } }],
};
const kept = { speed: 1, still: false, gl: true };
const start = startState(scene, kept);

/** A small repeatable generator (mulberry32), seed in the test's title. */
function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

test("any state comes back from its address (500 states, seed 7)", () => {
  const next = random(7);
  for (let k = 0; k < 500; k++) {
    const n = scene.levels[Math.floor(next() * scene.levels.length)];
    const state = {
      ...select({ ...start, n }, Math.floor(next() * n), Math.floor(next() * n)),
      rays: ["pixel", "row", "column", "all"].filter(() => next() < 0.5),
      tiles: next() < 0.5 ? "empty" : "filled",
      observer: next() < 0.3 ? "start" : next() < 0.5 ? "camera" : { eye: [1, 2, Math.round(next() * 100)], target: [0, 0.5, -1] },
      step: next() < 0.5 ? null : 0,
      event: next() < 0.5 ? null : Math.floor(next() * 30),
      speed: next() < 0.5 ? 1 : 4,
      colours: ["picture", "tests", "normal"][Math.floor(3 * next())],
      switches: {
        bounces: next() < 0.5 ? null : Math.floor(8 * next()),
        lamps: next() < 0.5 ? [] : [Math.floor(20 * next()) / 20],
        shadows: next() < 0.5,
        without: ["ambient", "diffuse", "specular", "reflected", "refracted"].filter(() => next() < 0.3),
      },
    };
    const { fields } = readAddress(`#${writeAddress(state, scene, false)}`, "");
    const { state: again, damaged } = followAddress(fields, scene, kept);
    assert.deepEqual(damaged, []);
    assert.deepEqual(again, state);
  }
});

test("the start's address is empty", () => assert.equal(writeAddress(start, scene, false), ""));

test("no address, however damaged, fails or leaves the grid (2000 texts, seed 3)", () => {
  const next = random(3);
  const bits = ["n=", "p=", "rays=", "tiles=", "cam=", "step=", "15", "7", ",", "-", "e9", "%", "&", "pixel", "NaN", "camera", "__proto__=", "=", "#"];
  for (let k = 0; k < 2000; k++) {
    const text = Array.from({ length: 1 + next() * 9 }, () => bits[Math.floor(next() * bits.length)]).join("");
    const { state } = followAddress(readAddress(`#${text}`, "").fields, scene, kept);
    assert.ok(scene.levels.includes(state.n) && state.pixel.every((p) => Number.isInteger(p) && p >= 0 && p < state.n), text);
  }
});

test("where grids share pixel centres a change of grid keeps the very ray", () => {
  for (const n of scene.levels)
    for (const m of scene.levels)
      for (let p = 0; p < n; p++) {
        const there = setLevel(select({ ...start, n }, p, p), m).pixel[0];
        // Centres (p + 0.5) / n and (q + 0.5) / m coincide when (2p + 1) m = (2q + 1) n.
        const shared = ((2 * p + 1) * m) / n;
        if (Number.isInteger(shared) && shared % 2 === 1) assert.equal(2 * there + 1, shared);
      }
});

test("going through all grids and back ends on the same pixel", () => {
  for (const [column, row] of [[0, 0], [14, 3], [7, 9]]) {
    let state = select(start, column, row);
    for (let k = 0; k < 9; k++) state = stepLevel(state, scene, 1);
    for (let k = 0; k < 9; k++) state = stepLevel(state, scene, -1);
    while (state.n < 15) state = stepLevel(state, scene, 1);
    assert.deepEqual(state.pixel, [column, row]);
  }
});

test("moving wraps round at all four edges", () => {
  assert.deepEqual(move(select(start, 0, 0), -1, -1).pixel, [14, 14]);
  assert.deepEqual(move(select(start, 14, 14), 1, 1).pixel, [0, 0]);
});

test("rendering fills by time, in three seconds at speed 1, and still fills at once", () => {
  let state = advance(pressRender(start), 1);
  assert.equal(tilesShown(state), Math.floor(225 / 3));
  state = advance(state, 2.01);
  assert.equal(state.tiles, "filled");
  assert.equal(pressRender({ ...start, still: true }).tiles, "filled");
});

test("what a lesson's view leaves out is as at the scene's start", () => {
  const far = { ...select(start, 1, 1), rays: ["all"], tiles: "filled", observer: "camera" };
  assert.deepEqual({ ...applyView(scene, far, {}), step: null }, start);
});

test("a lesson is walked stop by stop, an answer after its question, and stays at either end", () => {
  const asks = { ...scene, lesson: [{ html: "", view: {} }, { html: "", view: { rays: [] }, answer: { html: "", view: { rays: ["row"] } } }, { html: "", view: {} }] };
  let state = goToStep(asks, start, 0);
  const stops = [];
  for (let k = 0; k < 4; k++, state = turnStep(asks, state, 1)) stops.push([state.step, state.revealed, isAsking(state, asks), state.rays.join()]);
  assert.deepEqual(stops, [[0, false, false, "pixel"], [1, false, true, ""], [1, true, false, "row"], [2, false, false, "pixel"]]);
  assert.equal(turnStep(asks, state, 1), state);
  for (const stop of stops.slice(0, -1).reverse()) {
    state = turnStep(asks, state, -1);
    assert.deepEqual([state.step, state.revealed], stop.slice(0, 2));
  }
  assert.equal(turnStep(asks, state, -1), state);
});

test("a stage pixel over a tile's middle finds that tile, from every side (seed 11)", () => {
  const next = random(11);
  const plane = picturePlane(scene);
  for (let k = 0; k < 400; k++) {
    const observer = { eye: [next() * 20 - 10, next() * 10 - 5, next() * 20 - 10], target: [0, 0, 2], up: [0, 1, 0], fov: 40 };
    const view = createProjection(observer, 880, 540);
    const [column, row] = [Math.floor(next() * 15), Math.floor(next() * 15)];
    const seen = view.project(onPlane(plane, column + 0.5, row + 0.5, 15));
    if (seen.depth <= 0.01) continue;
    const [across, down] = view.onPicturePlane(plane, seen.x, seen.y);
    // float64; a plane seen edge-on loses digits, hence not 1e-12
    assert.ok(Math.abs(across * 15 - column - 0.5) < 1e-6 && Math.abs(down * 15 - row - 0.5) < 1e-6);
  }
});

test("the start view shows eye, tiles, objects and lights on any stage", () => {
  const plane = picturePlane(scene);
  for (const [width, height] of [[880, 540], [1380, 820], [390, 360], [300, 600]]) {
    const view = createProjection(observerOf("start", scene, plane, width / height), width, height);
    for (const point of [scene.camera.eye, scene.lights[0].position, onPlane(plane, 0, 0, 1), onPlane(plane, 1, 1, 1), [1, 0, 0], [-1, 0, 0]]) {
      const { x, y, depth } = view.project(point);
      assert.ok(depth > 0 && x > 0 && y > 0 && x < width && y < height, `${point} at ${width} x ${height}`);
    }
  }
});

test("through the ray-tracing camera the tiles are a square in the stage's middle", () => {
  const plane = picturePlane(scene);
  const view = createProjection(observerOf("camera", scene, plane, 1.6), 880, 540);
  const [a, b] = [view.project(onPlane(plane, 0, 0, 1)), view.project(onPlane(plane, 1, 1, 1))];
  assert.ok(Math.abs(b.x - a.x - (b.y - a.y)) < 1e-9 && Math.abs(a.x + b.x - 880) < 1e-9 && a.y > 0);
});

test("the picture plane stays on the eye's side of a wall that is close", () => {
  const wall = { name: "wall", type: "plane", label: "plane", material: 0, transform: [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 4.5, 1] };
  const plane = picturePlane({ ...scene, objects: [...scene.objects, wall] });
  assert.ok(plane.origin[2] > 4.5);
});

test("turning keeps the distance, moving the direction, and zooming stays in its limits", () => {
  const from = observerOf("start", scene, picturePlane(scene), 1.6);
  const reach = (o) => Math.hypot(...o.eye.map((v, k) => v - o.target[k]));
  assert.ok(Math.abs(reach(orbit(from, 30, 200)) - reach(from)) < 1e-9);
  const moved = pan(from, 0.3, -0.2);
  for (const k of [0, 1, 2]) assert.ok(Math.abs(moved.eye[k] - moved.target[k] - (from.eye[k] - from.target[k])) < 1e-9);
  assert.ok(reach(zoom(from, 1e9, 4)) <= 48 + 1e-9 && reach(zoom(from, 1e-9, 4)) >= 0.08 - 1e-9);
});

test("the selector's colour contrasts: black on white, light on dark, yellow in between", () => {
  assert.equal(contrastWith([255, 255, 255]), "#000000");
  assert.equal(contrastWith([10, 10, 10]), "#FFFFFF");
  assert.equal(contrastWith([128, 128, 128]), "#FFF04A");
  assert.equal(contrastWith(null), "#FFFFFF");
});

test("every kind of ray stands out from both pages and from its casing: at least 3 to 1; a blocked ray is the thickest", () => {
  const linear = (v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4); // WCAG 2.2, relative luminance
  const luminance = (hex) => rgb(hex).map(linear).reduce((sum, v, k) => sum + v * [0.2126, 0.7152, 0.0722][k], 0);
  const contrast = (a, b) => [luminance(a), luminance(b)].sort((p, q) => q - p).reduce((p, q) => (p + 0.05) / (q + 0.05));
  // Top and bottom of the stage, as in styles/00-base.css and 88-projector.css.
  for (const [light, grounds] of [[false, ["#1a212b", "#0f141a"]], [true, ["#ffffff"]]]) {
    lightColours(light);
    for (const [kind, { colour, wide }] of Object.entries(LINES)) {
      for (const ground of [...grounds, STAGE.casing]) assert.ok(contrast(colour, ground) >= 2.99, `${kind} on ${ground}: ${contrast(colour, ground)}`); // 3, to two decimals
      assert.ok(kind === "blocked" || wide < LINES.blocked.wide);
    }
  }
  lightColours(false);
});

test("a pixel's tree is walked depth first, and its shadow rays end at the light or the blocker", () => {
  // one pixel: a camera ray, its reflected ray (which has one of its own) and its refracted ray; one light
  const trace = {
    n: 1, lights: 1, count: 4, kind: [0, 1, 2, 1], parent: [-1, 0, 0, 1], pixel: [0, 0, 0, 0], object: [0, 0, -1, 0],
    point: [0, 0, 1, 0, 1, 0, 2, 2, 2, 3, 3, 3], visibility: [1, 0, 3, 2], blockedAt: [1, 0.5, 1, 1], weight: [1, 0.5, 0.5, 0.5], localWeight: [0, 0.5, 1, 1],
  };
  assert.deepEqual(treeOf(trace, 0), [0, 1, 3, 2]);
  const lines = linesOf(trace, scene, 0);
  assert.deepEqual(lines.map((line) => line.kind), ["camera", "reached", "reflected", "blocked", "refracted", "reflected"]);
  assert.deepEqual(lines[1].to, scene.lights[0].position);
  assert.deepEqual(lines[3].to, [-0.5, 1.5, 0.5]);
  assert.equal(lines[4].leaves, true);
  assert.deepEqual(lines.map((line) => line.share), [1, 0, 0.5, 0.25, 0.5, 0.25]); // of shadow rays: of the hit's own colour
});
