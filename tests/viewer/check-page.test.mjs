/** The page check/ from a disk, as a student uses it: a file of each kind, right and wrong pictures, by keyboard, in both languages. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { PNG } from "pngjs";
import { DIST, isWhole, launch, newPage, ON_DISK, open, PATIENCE, press, reload, showsScene, until } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { dataOf, pngOf, rightPicture, wrongPicture } from "./check-data.mjs";
import { GOOD, HEIGHT, HOSTILE, WIDTH } from "./picture-files.mjs";
import { load, wordsOf } from "./typescript.mjs";

const { aboutOf, atlasOf, pictureOrSentence, stripsOf } = await load("../check/main.ts");
const { readYours } = await load("panels/yours.ts");
const [EN, DE] = ["en", "de"].map((language) => wordsOf(language).check);
const mistakes = JSON.parse(readFileSync(`${DIST}/check/index.html`, "utf8").match(/data-mistakes="([^"]*)"/)[1].replaceAll("&#34;", '"').replaceAll("&#39;", "'").replaceAll("&amp;", "&"));

let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
});
after(() => browser.close());

async function visit(hash = "", home = "") {
  await page.goto("about:blank");
  page.home = ON_DISK;
  await page.goto(`${ON_DISK}${home}check/index.html${hash}`);
  await page.locator("#sizes:not(:empty)").waitFor({ state: "attached" });
}

/** Drops a file, and waits for what is said of it: { says, found }. */
async function drop(bytes, name = "picture") {
  await page.evaluate(([base64, name]) => {
    document.getElementById("says").textContent = "";
    document.getElementById("found").hidden = true;
    const given = new DataTransfer();
    given.items.add(new File([Uint8Array.from(atob(base64), (each) => each.charCodeAt(0))], name));
    document.getElementById("drop").dispatchEvent(new DragEvent("drop", { dataTransfer: given, bubbles: true, cancelable: true }));
  }, [Buffer.from(bytes).toString("base64"), name]);
  const done = await page.waitForFunction((working) => {
    const [says, found] = ["says", "found"].map((id) => document.getElementById(id));
    return (!found.hidden || (says.textContent && !working.includes(says.textContent))) && { says: says.textContent, found: found.hidden ? "" : found.innerText };
  }, [EN.working, DE.working], { timeout: PATIENCE });
  return done.jsonValue();
}

const wrongFile = async (scene, name) => pngOf(await wrongPicture(scene, name));

test("a file of each kind is read and compared", async () => {
  await visit();
  // In every run what is bytes packed, bytes as they are, and text; of all kinds check-formats.test.mjs asks the readers.
  const few = ["PNG", "P6", "n lines"].map((family) => GOOD.find(([kind]) => kind.startsWith(family)));
  for (const [kind, bytes] of cases(GOOD, few)) {
    const { says, found } = await drop(bytes, `${kind}.xyz`);
    assert.equal(says, "", kind);
    assert.ok(found.includes(`${kind}.xyz, ${WIDTH} × ${HEIGHT} pixels`), `${kind}: ${found}`);
    assert.ok(found.includes(`Compared is the middle square, ${HEIGHT} × ${HEIGHT} pixels`), kind);
  }
});

test("of each hostile file it is said what is wrong, and nothing is shown", async () => {
  await visit();
  for (const [kind, bytes, word] of HOSTILE) {
    if (!word) continue; // read, as the one above
    const { says, found } = await drop(bytes, kind);
    assert.deepEqual([says, found], [pictureOrSentence(bytes).sentence, ""], kind);
  }
});

test("a picture of another scene than was chosen is told as that, and is compared with it at a press", async () => {
  await visit("#scene=04-one-bounce");
  const { found } = await drop(readFileSync(`${DIST}/scenes/05-many-bounces/picture.png`));
  assert.match(found, /Your picture looks like “Many bounces”/);
  await page.getByRole("button", { name: "Compare with “Many bounces”" }).click();
  await page.getByRole("heading", { name: EN.verdict.right }).waitFor();
  assert.ok(await page.locator("[value='05-many-bounces']").isChecked());
  assert.match(page.url(), /#scene=05-many-bounces&report=1$/);
  assert.equal(await page.locator(".check-other").count(), 0);
  assert.deepEqual(page.faults, []);
});

test("beside what a picture looks like stands this scene with that mistake, and the wipe begins where most is wrong", async () => {
  await visit("#scene=03-two-lights");
  const { found } = await drop(await wrongFile("03-two-lights", "normal-not-unit"));
  assert.match(found, /most like this mistake: /);
  const shown = page.locator(".check-answers canvas").first();
  assert.equal(await shown.getAttribute("aria-label"), EN.looks.shown);
  assert.ok(await shown.evaluate((canvas) => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.some((value, i) => i % 4 < 3 && value > 0)), "it is drawn");
  assert.ok(Number(await page.locator(".check-wipe").inputValue()) > 60, "the ellipsoid is in the right half");
  for (const side of ["yours", "right"]) assert.equal(await page.locator(`.check-side.is-${side}`).innerText(), EN.view[side]);
  await page.getByRole("button", { name: EN.view.heat }).click();
  assert.equal(await page.locator(".check-side").first().isVisible(), false);
});

test("the right picture is called right, at the scene's own size and at one of its parts", async () => {
  await visit("#scene=03-two-lights");
  const whole = pngOf(await rightPicture("03-two-lights", 1155));
  for (const bytes of [whole, pngOf(await rightPicture("03-two-lights", 512))]) {
    const { found } = await drop(bytes, "mine.png");
    assert.ok(found.startsWith(EN.verdict.right), found.slice(0, 200));
    assert.ok(!found.includes(EN.looks.head) && !found.includes(EN.walk.head));
  }
});

const NAMED = [["02-shadows", "shadows-forgotten"], ["03-two-lights", "light-reversed"], ["05-many-bounces", "upside-down"], ["08-glass", "not-bent-at-exit"], ["01-shading", "cosine-absolute"]];
for (const [scene, name] of cases(NAMED, NAMED.slice(2, 4))) {
  test(`in ${scene} the picture of ${name} is named`, async () => {
    await visit(`#scene=${scene}`);
    assert.equal(await page.locator("[name=scene]:checked").inputValue(), scene);
    await drop(await wrongFile(scene, name));
    const first = await page.locator(".check-answers > li").first().innerText();
    assert.ok(first.includes(mistakes[name].title), first);
    assert.match(first, /\d\s?% agreement/);
    const fits = await page.locator(".check-fits").allInnerTexts();
    assert.deepEqual(fits, name === "upside-down" ? [EN.fits.upsideDown] : [], "a dark picture is no quarter of a bright one");
  });
}

test("what is copied is what the command says, line by line", async () => {
  await visit("#scene=02-shadows");
  const [file, bytes] = [join(mkdtempSync(join(tmpdir(), "raywalk-check-")), "mine.png"), await wrongFile("02-shadows", "shadows-forgotten")];
  writeFileSync(file, bytes);
  await drop(bytes, "mine.png");
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text) => void (window.copied = text) }, configurable: true }));
  await page.getByRole("button", { name: EN.report.copy }).click();
  await page.getByRole("button", { name: EN.report.copied }).waitFor();
  const objects = JSON.parse(await page.locator("[value='02-shadows']").getAttribute("data-objects"));
  const title = await page.locator("[value='02-shadows']").getAttribute("data-title");
  const names = { scene: title, objects, mistakes };
  const request = { do: "check", picture: file, data: `${DIST}/check/02-shadows`, language: "en", names };
  const { answer } = JSON.parse(execFileSync("node", [fileURLToPath(new URL("../../site_src/check.mjs", import.meta.url))], { input: JSON.stringify(request), encoding: "utf8" }));
  const [, ...copied] = (await page.evaluate(() => window.copied)).trimEnd().split("\n");
  assert.deepEqual(copied, answer.written);
  rmSync(dirname(file), { recursive: true });
});

/** The same on n x n pixels, none of which need have its centre where the atlas has one. */
function drawnOut(png, n) {
  const from = PNG.sync.read(png);
  const made = new PNG({ width: n, height: n });
  const along = (at) => Math.floor(((at + 0.5) * from.width) / n);
  for (let i = 0; i < n * n; i++) made.data.set(from.data.subarray(...[0, 4].map((end) => 4 * (along(Math.floor(i / n)) * from.width + along(i % n)) + end)), 4 * i);
  return PNG.sync.write(made);
}

test("a mistake's page shows the scene that was checked, and both its link and the browser's Back lead to the report as it was left", async () => {
  await visit("#scene=03-two-lights");
  await drop(await wrongFile("03-two-lights", "phong-for-blinn"), "mine.png");
  const verdict = await page.locator("#found").innerText();
  const link = page.locator(".check-answers h3 a").first();
  await link.scrollIntoViewIfNeeded();
  const scrolled = await page.evaluate(() => scrollY);
  assert.ok(scrolled > 0);
  await Promise.all([page.waitForURL("**/mistakes/phong-for-blinn/**"), link.click()]);
  const wrong = page.locator(".pair canvas").last();
  assert.match(await wrong.getAttribute("aria-label"), /^“Two lights” with the mistake: /);
  const shown = await wrong.evaluate((canvas) => {
    const bytes = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.filter((_, i) => i % 4 < 3);
    return btoa(Array.from(bytes, (each) => String.fromCharCode(each)).join("")); // an array of numbers takes seconds to come
  });
  const { mistakes: all } = atlasOf(aboutOf(dataOf("03-two-lights", "about")), await stripsOf(dataOf("03-two-lights", "atlas")));
  assert.deepEqual(new Uint8Array(Buffer.from(shown, "base64")), all.find(({ name }) => name === "phong-for-blinn").pictures[0], "its own picture of the mistake");
  assert.match(await page.locator(".of-scene").innerText(), /“Two lights”, the scene that you checked/);
  assert.match(await page.locator(".beside a").last().getAttribute("href"), /#scene=03-two-lights$/, "and so do its neighbours");
  for (const back of [() => page.goBack(), () => page.goForward().then(() => page.locator(".to-report a").click())]) {
    await back();
    await page.locator("#found:not([hidden])").waitFor();
    assert.equal(await page.locator("#found").innerText(), verdict);
    await page.waitForFunction((wanted) => Math.abs(scrollY - wanted) < 2, scrolled);
  }
  await page.getByRole("button", { name: EN.again }).click();
  await page.reload();
  await page.locator("#sizes:not(:empty)").waitFor({ state: "attached" });
  assert.ok(!(await page.locator("#found").isVisible()), "who wants another picture is done with this one");
  assert.deepEqual(page.faults, []);
});

test("where a mistake does not show in the scene that was checked, its page says so and shows its own", async () => {
  await page.goto(`${ON_DISK}mistakes/no-fresnel/index.html#scene=02-shadows`);
  assert.match(await page.locator(".of-scene").innerText(), /^In “Shadows”, the scene that you checked, this mistake does not show\. Both pictures show “Glass”/);
  assert.equal(await page.locator(".pair img").count(), 2);
  await page.goto(`${ON_DISK}mistakes/no-fresnel/index.html#scene=`);
  await page.reload();
  assert.equal(await page.locator(".to-report, .of-scene").count(), 0, "without a scene the page is as it came");
});

test("a pixel that is far off leads to its rays, and is there what it was in the report", async () => {
  await visit("#scene=02-shadows");
  await drop(drawnOut(await wrongFile("02-shadows", "shadows-forgotten"), 512));
  assert.ok((await page.locator(".check-walk").innerText()).includes("None of your 512 × 512 pixels"));
  const link = page.locator(".check-tiles a").first();
  const [, x, y, n] = (await link.innerText()).match(/Tile (\d+), (\d+) of (\d+)/);
  const [, yours] = (await link.innerText()).match(/yours \(([\d, ]+)\)/);
  const [, right] = (await link.innerText()).match(/right \(([\d, ]+)\)/);
  await link.evaluate((link) => (link.href += "&gl=none")); // nothing here is about the stage
  await Promise.all([page.waitForURL("**/scenes/02-shadows/**"), link.click()]);
  await isWhole(page);
  await until(page, (s, t, wanted) => JSON.stringify([s.scene, s.pixel, s.n]) === wanted, JSON.stringify(["02-shadows", [Number(x), Number(y)], Number(n)]));
  const told = page.locator(".card-head .yours");
  assert.ok((await told.innerText()).startsWith(wordsOf("en").card.yours.replace("{yours}", yours)), "what the student's program gave");
  assert.match(await told.locator("a").getAttribute("href"), /check\/index\.html#scene=02-shadows&report=1$/, "and the way back");
  assert.equal(await page.locator(".pixel-colour").innerText(), right, "beside the right colour");
  await reload(page);
  assert.ok(await told.isVisible(), "the page loaded anew still knows it");
  await press(page, "ArrowRight");
  assert.ok(!(await told.isVisible()), "another pixel has none");
  await press(page, "ArrowLeft");
  assert.ok(await told.isVisible());
});

test("another scene forgets what the student's program gave", async () => {
  await open(page, ON_DISK, "scenes/02-shadows/index.html?yours=15,7,7,1,2,3", "n=15&p=7,7&gl=none&still=1");
  assert.match(await page.locator(".card-head .yours").innerText(), /1, 2, 3/);
  await press(page, "3");
  await showsScene(page, "03-two-lights");
  await until(page, () => !location.search);
  await press(page, "2");
  await showsScene(page, "02-shadows");
  assert.ok(!(await page.locator(".card-head .yours").isVisible()));
});

test("what is not a pixel and three bytes is passed over", () => {
  assert.deepEqual(readYours("?yours=15,7,8,255,0,9"), { n: 15, pixel: [7, 8], bytes: [255, 0, 9] });
  for (const bad of ["", "yours=", "yours=15,7,8,256,0,9", "yours=15,15,8,1,2,3", "yours=15,7,8,1,2", "yours=15,7,8,1,2,3,4", "yours=a,b,c,d,e,f", "yours=15,-1,8,1,2,3", "yours=15,7,8,1e2,2,3", "yours=<b>"]) assert.equal(readYours(`?${bad}`), null, bad);
});

test("the wipe moves by keys and by hand, other views are a press away, and a pixel tells both colours", async () => {
  await visit("#scene=02-shadows");
  await drop(await wrongFile("02-shadows", "shadows-forgotten"));
  const clip = () => page.locator(".check-picture canvas").last().evaluate((canvas) => canvas.style.clipPath);
  const half = await clip();
  await page.locator(".check-wipe").focus();
  await page.keyboard.press("ArrowRight");
  assert.notEqual(await clip(), half);
  const picture = page.locator(".check-picture");
  await picture.hover({ position: { x: 40, y: 40 } });
  assert.ok(await page.evaluate(() => document.querySelector(".check-under").getBoundingClientRect().bottom <= document.querySelector(".check-picture").getBoundingClientRect().top), "both colours stand above the picture");
  assert.match(await page.locator(".check-under").innerText(), /^Column \d+, row \d+: yours \(\d+, \d+, \d+\), right \(\d+, \d+, \d+\)$/);
  await page.mouse.down();
  assert.match(await clip(), /^inset\(0(px)? \d/);
  await page.mouse.up();
  await page.getByRole("button", { name: EN.view.heat }).click();
  assert.equal(await page.locator(".check-under").innerText(), EN.view.heatSays);
  assert.ok(!(await page.locator(".check-wipe").isVisible()));
});

test("by keyboard alone: a scene, a file, what is found, another picture", async () => {
  await visit();
  await page.locator("[name=scene]").first().focus();
  await page.keyboard.press("ArrowRight");
  const second = await page.locator("[name=scene]").nth(1).inputValue();
  assert.equal(await page.locator("[name=scene]:checked").inputValue(), second);
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.id), "file");
  await page.locator("#file").setInputFiles({ name: "mine.ppm", mimeType: "", buffer: Buffer.from(GOOD.find(([kind]) => kind.startsWith("P6"))[1]) });
  await page.locator("#found:not([hidden])").waitFor();
  assert.equal(await page.evaluate(() => document.activeElement.id), "found", "the focus goes to what was found");
  await page.getByRole("button", { name: EN.again }).press("Enter");
  assert.equal(await page.evaluate(() => document.activeElement.id), "file");
  assert.ok(!(await page.locator("#found").isVisible()));
});

test("another scene checks the same picture again", async () => {
  await visit("#scene=01-shading");
  const { found } = await drop(pngOf(await rightPicture("02-shadows", 256)));
  assert.ok(!found.startsWith(EN.verdict.right), "another scene's picture");
  await page.locator("[value='02-shadows']").check();
  await page.waitForFunction((right) => document.getElementById("found").innerText.startsWith(right), EN.verdict.right);
});

test("in German all of it is German", async () => {
  await visit("#scene=02-shadows", "de/");
  const { found } = await drop(await wrongFile("02-shadows", "shadows-forgotten"));
  for (const head of [DE.how.head, DE.where.head, DE.looks.head, DE.walk.head]) assert.ok(found.includes(head));
  assert.ok(!/\b(pixels|yours|within|agreement)\b/.test(found), found);
  const { says } = await drop(new Uint8Array(0));
  assert.equal(says, DE.fault.noBytes);
});

test("what a scene has no mistakes for is said, and its pictures are compared all the same", async () => {
  await visit("#scene=07-bunny-near");
  const right = pngOf(await rightPicture("07-bunny-near", 512));
  assert.ok((await drop(right)).found.startsWith(EN.verdict.right));
  const wrong = PNG.sync.read(right);
  for (let i = 0; i < wrong.data.length; i += 4) [wrong.data[i], wrong.data[i + 2]] = [wrong.data[i + 2], wrong.data[i]];
  const { found } = await drop(PNG.sync.write(wrong));
  assert.ok(found.includes(EN.looks.left.meshes) && found.includes(EN.fits.bgr), found);
});

test("a picture higher than wide is refused in a sentence", async () => {
  await visit();
  const png = new PNG({ width: 20, height: 30 });
  assert.match((await drop(PNG.sync.write(png))).says, /20 by 30 pixels\. The scene is square/);
});

test("the page knows its name in a scene's menu, and no request left the site", async () => {
  const { href } = await page.goto(`${ON_DISK}scenes/02-shadows/index.html`).then(() => page.locator(".to-check").evaluate(({ href }) => ({ href })));
  assert.match(href, /\/check\/index\.html#scene=02-shadows$/);
  assert.deepEqual(page.faults, []);
});

test("a scene's data come while the page rests; where bytes are saved, when a file is looked for", async () => {
  const saving = await newPage(browser);
  await saving.addInitScript(() => Object.defineProperty(Navigator.prototype, "connection", { get: () => ({ saveData: true }) }));
  for (const each of [page, saving]) {
    const asked = [];
    const listen = (request) => asked.push(request.url().split("/").at(-1));
    each.on("request", listen);
    const atlas = () => each.waitForRequest(/02-shadows\/atlas\.js/, { timeout: PATIENCE });
    const come = each === page && atlas();
    await each.goto("about:blank");
    await each.goto(`${ON_DISK}check/index.html#scene=02-shadows`);
    await each.locator("#sizes:not(:empty)").waitFor({ state: "attached" });
    if (each === saving) {
      await each.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(() => requestAnimationFrame(done)))));
      assert.deepEqual(asked.filter((name) => /^(atlas|places)/.test(name)), []);
      await Promise.all([atlas(), each.waitForEvent("filechooser"), each.locator(".check-choose").click()]);
    }
    await come;
    each.off("request", listen);
    assert.deepEqual(each.faults, []);
  }
  await saving.close();
});

test("a kiosk has no link to it: nobody brings a picture there", async () => {
  for (const path of ["index.html", "scenes/02-shadows/index.html"]) {
    await page.goto("about:blank");
    await page.goto(`${ON_DISK}${path}#kiosk=1&visitor=1&still=1&gl=none`);
    await page.locator("html.kiosk .to-check").waitFor({ state: "attached" });
    assert.ok(!(await page.locator(".to-check").isVisible()), path);
  }
});
