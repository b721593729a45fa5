/** Where a stop has other colours, or a plane elsewhere, the stage is drawn as the stop is: tiles would show what it does not. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { follow, launch, newPage, open, pass, pictureOf, stats, until } from "./browser.mjs";

const SCENE = `version = 1
title = "Paint"
teaches = "That colours vary."
camera = { eye = [0, 0, 5], target = [0, 0, 0] }
render = { size = 45, resolutions = [15], depth = 0 }
lights = [{ name = "lamp", position = [0, 3, 4], colour = [1, 1, 1] }]
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 1
material = { like = "white", diffuse = [1, 0, 0] }
[[objects]]
name = "floor"
type = "plane"
point = [0, -1.5, 0]
normal = [0, 1, 0]
material = "white"
[[sweeps]]
name = "paint"
varies = "objects.ball.material.diffuse"
values = [[1, 0, 0], [0, 0, 1]]
[[sweeps]]
name = "light"
varies = "lights.lamp.colour"
values = [[1, 1, 1], [0, 0, 0]]
[[sweeps]]
name = "height"
varies = "objects.floor.point.1"
values = [-1.5, -6]
`;
let browser, page, folder, site;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), "raywalk-paint-"));
  mkdirSync(join(folder, "scenes", "01-paint"), { recursive: true });
  writeFileSync(join(folder, "scenes", "01-paint", "scene.toml"), SCENE);
  const work = join(folder, "work");
  execFileSync(".venv/bin/python", ["-m", "tests.with_viewer", work]); // to bundle it anew takes seconds
  const places = ["--scenes", join(folder, "scenes"), "--out", join(folder, "dist"), "--work", work];
  execFileSync(".venv/bin/raywalk", ["site", ...places, "--without", "check,mistakes"]);
  site = `${pathToFileURL(join(folder, "dist"))}/`;
  browser = await launch();
  page = await newPage(browser, { held: true, viewport: { width: 480, height: 360 } });
});
after(async () => {
  assert.deepEqual(page.faults, []);
  await browser.close();
  rmSync(folder, { recursive: true });
});

/** Means of red and blue of what is drawn, in the middle of the stage, and of red at its foot. */
async function drawn() {
  const { width, height, data } = await pictureOf(page, page.locator(".stage-view"));
  const mean = (channel, [left, right], [top, bottom]) => {
    let [sum, count] = [0, 0];
    for (let y = Math.round(top * height); y < bottom * height; y++)
      for (let x = Math.round(left * width); x < right * width; x++) [sum, count] = [sum + data[4 * (y * width + x) + channel], count + 1];
    return sum / count;
  };
  const middle = [[0.47, 0.53], [0.42, 0.52]];
  return { red: mean(0, ...middle), blue: mean(2, ...middle), foot: mean(0, [0.4, 0.6], [0.86, 0.96]) };
}
/** begin: the page is opened; else a link is followed. */
async function at(stop, gl, begin = false) {
  const hash = `${gl}cam=camera&rays=none&tiles=empty&sweep=${stop}`;
  await (begin ? open(page, site, "scenes/01-paint/index.html", hash) : follow(page, hash));
  await until(page, (s, t, [stop]) => s.sweep === stop && t.tiles.length > 0, [stop]);
  await pass(page, 500); // it has glided there
  return drawn();
}

for (const gl of ["gl=none&", ""])
  test(`a ball is drawn in the colour that it has at a stop, and again in its own: ${gl ? "flat" : "with WebGL"}`, async () => {
    const own = await at("paint:1", gl, true);
    const painted = await at("paint:2", gl);
    assert.ok(own.red > own.blue + 60, JSON.stringify(own));
    assert.ok(painted.blue > painted.red + 60, JSON.stringify(painted));
    assert.deepEqual(await at("paint:1", gl), own);
  });

test("a lamp's colour and a plane's place are those of the stop", async () => {
  const own = await at("light:1", "");
  const dark = await at("light:2", "");
  assert.ok(dark.red < 0.7 * own.red, `${dark.red}, not ${own.red}`);
  const low = await at("height:2", "");
  assert.ok(Math.abs(low.foot - own.foot) > 5, `${low.foot}, ${own.foot}`);
  const { gpu } = await stats(page);
  assert.ok(gpu.sets <= 4);
});
