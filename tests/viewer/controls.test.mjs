/** Every control of VIEWER.md up to R: by key, by pointer and by its button; what depends on where the page comes from, from a server too. */
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { follow, launch, newPage, ON_DISK, open, openChooser, openDrawer, pass, pictureOf, press, reach, reload, richScene, scenesOfSite, settled, showsScene, state, stats, tileOnPage, until, DIST } from "./browser.mjs";
import { serve } from "./server.mjs";

const scenes = scenesOfSite();
const rich = richScene();
let browser, server;
before(async () => {
  browser = await launch();
  server = await serve(DIST, "/course/rays/");
});
after(async () => {
  await browser.close();
  server.close();
});

for (const where of ["a disk", "a server, in a folder"]) {
  describe(`opened from ${where}`, () => {
    const base = () => (where === "a disk" ? ON_DISK : server.url);
    /** Drawn flat: what is asked here is what a control does, not what the stage looks like. */
    const FLAT = "gl=none";
    let page;
    before(async () => {
      page = await newPage(browser);
      await open(page, base(), rich.path, `still=1&${FLAT}`);
    });
    after(() => page.close());
    /** Where the stage itself is asked about: drawn as most see it. */
    const onStage = async (hash) => {
      const stage = await newPage(browser, { sharp: true, viewport: { width: 820, height: 560 } }); // what is drawn costs by its pixels
      await open(stage, base(), rich.path, hash);
      return stage;
    };
    /** The hand's work is the same wherever the page comes from. */
    const onDisk = where === "a disk" ? test : () => {};
    const fresh = (hash = "still=1") => follow(page, `${hash}&${FLAT}`);
    const button = (name) => page.getByRole("button", { name });

    onDisk("the arrows move the selected pixel and wrap round at the edges", async () => {
      await fresh("still=1&n=5&p=0,0");
      await press(page, "ArrowLeft");
      assert.deepEqual((await state(page)).pixel, [4, 0]);
      await press(page, "ArrowUp");
      assert.deepEqual((await state(page)).pixel, [4, 4]);
      await press(page, "ArrowRight", "ArrowDown");
      assert.deepEqual((await state(page)).pixel, [0, 0]);
      await fresh("still=1&n=5&p=0,0&tab=rays"); // beside its numbers the pixel has arrows
      for (const name of ["Pixel to the right", "Pixel below", "Pixel to the left", "Pixel above"]) await button(name).click();
      assert.deepEqual((await state(page)).pixel, [0, 0]);
    });

    onDisk("A, H and V turn the rays of the frame, the row and the column on and off", async () => {
      await fresh("still=1&n=5&p=1,2");
      const alone = (await stats(page)).thin;
      assert.equal(alone, 0);
      await press(page, "h");
      assert.deepEqual((await state(page)).rays, ["pixel", "row"]);
      const row = (await stats(page)).thin;
      assert.ok(row >= 5);
      await press(page, "v");
      assert.ok((await stats(page)).thin > row);
      await press(page, "a");
      const all = (await stats(page)).thin;
      assert.ok(all >= 25);
      await press(page, "a", "h", "v");
      assert.deepEqual((await state(page)).rays, ["pixel"]);
      for (const [name, choice] of [["selected row", "row"], ["selected column", "column"], ["All rays", "all"], ["selected pixel", "pixel"]]) {
        const had = (await state(page)).rays.includes(choice);
        await button(name).click();
        assert.equal((await state(page)).rays.includes(choice), !had, choice);
      }
    });

    onDisk("the lines drawn are the trace's: a camera ray a tile, and no line for a pixel that shows none", async () => {
      await fresh("still=1&n=5&rays=none");
      assert.equal((await stats(page)).chosen, 0);
      assert.deepEqual((await stats(page)).kinds, []);
      assert.equal(await page.locator(".legend li:visible").count(), 0);
      await press(page, "a");
      assert.ok((await stats(page)).kinds.includes("camera"));
      assert.equal(await page.locator(".legend li:visible").count(), (await stats(page)).kinds.length);
    });

    onDisk("plus and minus change the grid and keep the ray wherever the grids share it", async () => {
      await fresh("still=1&n=5&p=2,2");
      await press(page, "+", "+", "+");
      await until(page, (s, t) => s.n === 15 && t.tiles.length === 3 * 15 * 15);
      assert.deepEqual((await state(page)).pixel, [7, 7]);
      await press(page, "-", "-", "-");
      await until(page, (s, t) => s.n === 5 && t.tiles.length === 75);
      assert.deepEqual((await state(page)).pixel, [2, 2]);
      await press(page, "-");
      assert.equal((await state(page)).n, 5);
      await button("Finer grid").click();
      await until(page, (s) => s.n === 7);
      await button("Coarser grid").click();
      await until(page, (s) => s.n === 5);
    });

    onDisk("Space fills the tiles in scan order, skips to the end, and empties them", async () => {
      const page = await newPage(browser, { held: true });
      await open(page, base(), rich.path, "n=15&gl=none");
      assert.equal((await stats(page)).tilesShown, 0);
      await press(page, " ");
      let shown = 0;
      for (let k = 0; k < 3; k++) {
        await pass(page, 200); // of the three seconds that all 225 take
        const now = await stats(page);
        const most = 75 * (0.2 * (k + 1) + 0.05); // press has waited for two frames, too
        assert.ok(now.tilesShown > shown && now.tilesShown <= most, `${now.tilesShown} tiles after ${0.2 * (k + 1)} s`);
        assert.ok(now.chosen >= 1, "a ray shoots while its tile fills");
        shown = now.tilesShown;
      }
      assert.equal((await state(page)).tiles, "filling");
      await press(page, " ");
      assert.equal((await stats(page)).tilesShown, 225);
      await press(page, " ");
      assert.equal((await stats(page)).tilesShown, 0);
      await page.getByRole("button", { name: "Fill the tiles" }).click();
      assert.equal((await state(page)).tiles, "filling");
      assert.deepEqual(page.faults, []);
      await page.close();
    });

    onDisk("the speed button makes rendering faster, and a fast one ends by itself", async () => {
      await fresh("n=5");
      await press(page, "."); // the player's speed shows once an event is current
      for (const speed of [2, 4, 8]) {
        await button("Speed of rendering").click();
        assert.equal((await state(page)).speed, speed);
      }
      await press(page, " ");
      await until(page, (s) => s.tiles === "filled");
    });

    onDisk("a tile shows exactly the trace's colour, and that is the picture's", async () => {
      const page = await onStage("still=1&n=5&tiles=filled&cam=camera&rays=none");
      const image = await pictureOf(page);
      const { tiles } = await stats(page);
      for (let k = 0; k < 25; k++) {
        const { x, y } = await tileOnPage(page, k % 5, Math.floor(k / 5));
        const at = 4 * (Math.round(y) * image.width + Math.round(x));
        assert.deepEqual([...image.data.subarray(at, at + 3)], tiles.slice(3 * k, 3 * k + 3), `tile ${k}`);
      }
      assert.deepEqual(page.faults, []);
      await page.close();
    });

    onDisk("R looks through the ray-tracing camera; dragging, Shift and the wheel turn, move and zoom", async () => {
      await fresh();
      await openDrawer(page); // it takes its room from the stage, which the start view fits
      const start = await stats(page);
      await press(page, "r");
      assert.equal((await state(page)).observer, "camera");
      await button("Observer back to the start view").click();
      assert.equal((await state(page)).observer, "start");
      const box = await page.locator(".stage-view").boundingBox();
      const drag = async (dx, dy) => {
        await page.mouse.move(box.x + 200, box.y + 30);
        await page.mouse.down();
        await page.mouse.move(box.x + 200 + dx, box.y + 30 + dy, { steps: 3 });
        await page.mouse.up();
        await settled(page);
      };
      await drag(80, 0);
      const turned = await stats(page);
      assert.notDeepEqual(turned.eye, start.eye);
      assert.ok(Math.abs(reach(turned) - reach(start)) < 1e-9, "turning keeps the distance");
      assert.deepEqual(turned.target, start.target);
      await page.keyboard.down("Shift");
      await drag(60, 20);
      await page.keyboard.up("Shift");
      const moved = await stats(page);
      assert.notDeepEqual(moved.target, turned.target);
      await page.mouse.wheel(0, -200);
      await until(page, (s, { eye, target }, reach) => Math.hypot(...eye.map((v, k) => v - target[k])) < reach * 0.9, reach(moved));
      for (const [name, check] of [
        ["Turn the view left", (a, b) => a.eye.join() !== b.eye.join()],
        ["Turn the view up", (a, b) => a.eye[1] > b.eye[1]],
        ["Zoom in", (a, b) => reach(a) < reach(b)],
        ["Zoom out", (a, b) => reach(a) > reach(b)],
      ]) {
        const was = await stats(page);
        await button(name).click();
        await settled(page);
        assert.ok(check(await stats(page), was), name);
      }
      await button("Turn: ").click();
      const was = await stats(page);
      await button("Move the view right").click();
      await settled(page);
      assert.notDeepEqual((await stats(page)).target, was.target);
      await button("ray-tracing camera").click();
      assert.equal((await state(page)).observer, "camera");
    });

    onDisk("the pointer selects on the tiles and on the picture, and dragging scrubs", async () => {
      await fresh("still=1&n=5&cam=camera");
      const [a, b] = [await tileOnPage(page, 1, 1), await tileOnPage(page, 3, 2)];
      await page.mouse.move(a.x, a.y);
      await page.mouse.down();
      assert.deepEqual((await state(page)).pixel, [1, 1]);
      await page.mouse.move(b.x, b.y);
      assert.deepEqual((await state(page)).pixel, [3, 2]);
      await page.mouse.up();
      assert.equal((await state(page)).observer, "camera", "scrubbing does not turn the view");
      const picture = await page.locator(".marks").boundingBox();
      const tile = picture.width / 5;
      await page.mouse.move(picture.x + 0.5 * tile, picture.y + 4.5 * tile);
      await page.mouse.down();
      assert.deepEqual((await state(page)).pixel, [0, 4]);
      await page.mouse.move(picture.x + 2.5 * tile, picture.y + 3.5 * tile);
      await page.mouse.up();
      assert.deepEqual((await state(page)).pixel, [2, 3]);
    });

    test("scene keys and Page up/down change the scene without loading a page, and Back goes back", async () => {
      await open(page, base(), rich.path, `still=1&${FLAT}`);
      await page.evaluate(() => (window.sameDocument = true));
      const keyed = scenes.filter((scene) => scene.key && scene.id !== rich.id).slice(0, 2);
      for (const scene of keyed) {
        await press(page, scene.key);
        await showsScene(page, scene.id);
        assert.equal(await page.locator("nav.scenes a[aria-current]").getAttribute("data-scene"), scene.id);
        if (where === "a disk") assert.match(page.url(), new RegExp(`scene=${scene.id}`));
        else assert.ok(page.url().includes(scene.path.replace(/index\.html$/, "")));
      }
      await page.goBack();
      await showsScene(page, keyed[0].id);
      const at = scenes.findIndex((scene) => scene.id === keyed[0].id);
      const before = scenes.at(at - 1).id;
      await press(page, "PageUp"); // PageDown would begin the lesson
      await showsScene(page, before);
      for (const [name, id] of [["Next scene", keyed[0].id], ["Previous scene", before], ["Next scene", keyed[0].id]]) {
        await openChooser(page);
        await page.getByRole("link", { name }).click();
        await showsScene(page, id);
        assert.equal(await page.locator("nav.scenes").isVisible(), false, "chosen, it closes");
      }
      await openChooser(page);
      await page.locator(`nav.scenes a[data-scene="${scenes[(at + 1) % scenes.length].id}"]`).click();
      await showsScene(page, scenes[(at + 1) % scenes.length].id);
      assert.equal(await page.evaluate(() => window.sameDocument), true);
    });

    test("that page, loaded anew, is the scene it was left at", async () => {
      const { scene } = await state(page);
      await reload(page);
      assert.equal((await stats(page)).shown.scene, scene);
      await open(page, base(), rich.path, `still=1&${FLAT}`);
    });

    onDisk("keys leave Ctrl, Alt and text fields alone", async () => {
      await fresh("still=1&n=5&p=2,2");
      await press(page, "Control+a", "Alt+h");
      assert.deepEqual((await state(page)).rays, ["pixel"]);
      await page.evaluate(() => {
        const field = document.body.appendChild(document.createElement("input"));
        field.id = "field";
        field.focus();
      });
      await press(page, "a", "ArrowLeft", "2");
      await page.evaluate(() => document.querySelector("#field").remove());
      assert.deepEqual((await state(page)).rays, ["pixel"]);
      assert.deepEqual((await state(page)).pixel, [2, 2]);
    });

    onDisk("pointing at a card's line lights its ray, and pointing at the ray lights the line", async () => {
      await fresh("still=1&tab=rays");
      await page.locator("li.ray[tabindex]").first().hover();
      assert.deepEqual((await stats(page)).lit, { ray: (await page.locator("li.ray").first().evaluate((e) => Number(e.dataset.ray))), light: -1 });
      await page.locator("li.ray[tabindex]").last().focus();
      assert.notEqual((await stats(page)).lit, null);
      await page.mouse.move(2, 2);
      const box = await page.locator(".stage-view").boundingBox();
      const mid = await page.evaluate(() => window.raywalk.stats().onLine(0));
      await page.mouse.move(box.x + mid.x, box.y + mid.y);
      await settled(page);
      assert.equal(await page.locator("li.ray.lit").count(), 1);
    });

    test("all of this said nothing in the console and asked nothing of other places", () => assert.deepEqual(page.faults, []));
  });
}
