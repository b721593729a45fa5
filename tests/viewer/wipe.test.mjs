/** In the traced look a bar wipes the picture away, and what the graphics card makes of the scene stands beside what rays make. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, follow, pictureOf, press, richScene, settled, state } from "./browser.mjs";

const rich = richScene();
const LOOK = "still=1&n=15&p=5,8&rays=none&cam=camera";
const BAR = 44; // CSS pixels
let browser, page;
before(async () => {
  browser = await launch([], { smooth: true });
  page = await newPage(browser, { sharp: true, viewport: { width: 1000, height: 640 } }); // what is drawn costs by its pixels
});
after(() => browser.close());

const bar = () => page.getByRole("slider", { name: /Wipe/ });
const wiped = () => state(page).then(({ wipe }) => wipe);
const pictureBox = () => page.locator(".traced-whole").boundingBox();
/** Mean difference of two pictures of the stage over some columns and the picture's rows, of 255. */
function difference(a, b, [left, right], [top, bottom]) {
  let sum = 0;
  for (let y = Math.ceil(top); y < bottom; y++)
    for (let x = Math.ceil(left); x < right; x++) for (let c = 0; c < 3; c++) sum += Math.abs(a.data[4 * (y * a.width + x) + c] - b.data[4 * (y * a.width + x) + c]);
  return sum / (3 * Math.floor(right - left) * Math.floor(bottom - top));
}
async function drag(from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, to[1]);
  await page.mouse.move(...to);
  await page.mouse.up();
  await settled(page);
}

for (const how of ["", "&gl=none"])
  test(`left of the bar is the approximate look, right of it the traced picture (${how || "WebGL"})`, async () => {
    await open(page, ON_DISK, rich.path, `${LOOK}&look=traced${how}`);
    await bar().waitFor();
    const picture = await pictureBox();
    assert.equal(await wiped(), 0);
    const stage = page.locator(".stage-view");
    const view = await stage.boundingBox();
    const hide = (on) => page.evaluate((on) => [...document.querySelectorAll(".wipe, .wipe-names")].forEach((each) => (each.style.visibility = on ? "hidden" : "")), on);
    await hide(true);
    const traced = await pictureOf(page, stage);
    await hide(false);
    await drag([picture.x, picture.y + picture.height / 3], [picture.x + picture.width / 2, picture.y + picture.height / 3]);
    assert.ok(Math.abs((await wiped()) - 0.5) < 0.02, `${await wiped()}`);
    assert.equal((await state(page)).observer, "camera", "the stage does not turn");
    assert.deepEqual((await state(page)).pixel, [5, 8], "and no tile is picked");
    await hide(true);
    const half = await pictureOf(page, stage);
    await hide(false);
    const approximate = await pictureOf(page, stage).then(() => follow(page, `${LOOK}&look=traced&wipe=1${how}`)).then(() => hide(true)).then(() => pictureOf(page, stage));
    await hide(false);
    const rows = [picture.y - view.y + 2, picture.y - view.y + picture.height - 2];
    const middle = picture.x - view.x + picture.width / 2;
    const [left, right] = [[picture.x - view.x + 2, middle - BAR], [middle + BAR, picture.x - view.x + picture.width - 2]];
    assert.ok(difference(half, approximate, left, rows) < 0.5);
    assert.ok(difference(half, traced, right, rows) < 0.5);
    assert.ok(difference(half, traced, left, rows) > 2, "the two are not the same");
  });

test("by keys it goes by hundredths, tenths and to either end, while arrows elsewhere select pixels", async () => {
  await open(page, ON_DISK, rich.path, `${LOOK}&look=traced&gl=none`);
  await bar().focus();
  await press(page, "ArrowRight", "ArrowRight", "ArrowRight");
  assert.equal(await wiped(), 0.03);
  await press(page, "PageUp");
  assert.equal(await wiped(), 0.13);
  assert.match(await bar().getAttribute("aria-valuetext"), /13.% wiped away/);
  await press(page, "End");
  assert.equal(await wiped(), 1);
  await press(page, "Home");
  assert.equal(await wiped(), 0);
  assert.deepEqual((await state(page)).pixel, [5, 8]);
});

test("it is part of the address, and only of the traced look's", async () => {
  await open(page, ON_DISK, rich.path, `${LOOK}&look=traced&wipe=0.4&gl=none`);
  assert.equal(await wiped(), 0.4);
  assert.equal(await page.locator(".wipe-names").innerText().then((text) => text.split(/\s+/).join()), "Approximate,Traced");
  await press(page, "ArrowRight");
  await page.waitForFunction(() => location.hash.includes("wipe=0.4"));
  await press(page, "t");
  assert.equal(await wiped(), 0);
  assert.equal(await bar().count(), 0);
  await page.waitForFunction(() => !location.hash.includes("wipe"));
  await open(page, ON_DISK, rich.path, `${LOOK}&look=approximate&wipe=0.4&gl=none`);
  assert.equal(await wiped(), 0);
  assert.match(await page.locator("#notice").innerText(), /wipe/);
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
