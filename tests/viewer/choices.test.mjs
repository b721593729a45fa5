/** A question's choices: chosen by pointer, key, finger or a pixel of the picture; then each says why. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { follow, launch, newPage, ON_DISK, open, press, reload, scenesOfSite, settled, state } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { readScene } from "./scene-files.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const QUICK = "still=1&gl=none";
const scenes = scenesOfSite().map((each) => ({ ...each, lesson: readScene(each.id).lesson }));
const questions = scenes.flatMap(({ id, path, lesson }) => lesson.flatMap(({ choices }, step) => (choices ? [{ id, path, step, choices }] : [])));
const withTexts = questions.find(({ choices }) => choices.every(({ html }) => html));
const withPixels = questions.find(({ choices }) => choices.every(({ pixel }) => pixel));
const rightOf = ({ choices }) => choices.findIndex(({ right }) => right);
const wrongOf = ({ choices }) => choices.findIndex(({ right }) => !right);

let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
});
after(() => browser.close());

/** The question in a page that has not been asked it. */
async function ask(of, question, more = "") {
  if (of.url().startsWith(ON_DISK)) await of.evaluate(() => sessionStorage.clear()); // what it knows is read once
  await open(of, ON_DISK, question.path, `${QUICK}&step=${question.step + 1}${more}`);
}
const radios = (of = page) => of.getByRole("radio");
const checked = (of = page) => radios(of).evaluateAll((all) => all.map((each) => each.getAttribute("aria-checked") === "true").indexOf(true));
const shownReasons = (of = page) => of.locator(".reason").evaluateAll((all) => all.map((each) => ({ right: each.classList.contains("is-right"), yours: each.classList.contains("is-yours"), says: each.querySelector(".because").innerText })));

test("every scene of the course asks at least two questions with three or four choices, one of them right", () => {
  for (const { id, lesson } of scenes.filter(({ key }) => key)) {
    const own = lesson.filter(({ choices }) => choices);
    assert.ok(own.length >= 2, id);
    for (const { choices, answer } of own) {
      assert.ok(answer && choices.length >= 3 && choices.length <= 4, id);
      assert.equal(choices.filter(({ right }) => right).length, 1);
      for (const { because } of choices) assert.ok(because.length > 15 && because.length < 200, because);
    }
  }
});

test("until something is chosen the only way on is Reveal, which says that nothing was; no reason is in the page", async () => {
  await ask(page, withTexts);
  assert.equal(await radios().count(), withTexts.choices.length);
  assert.equal(await checked(), -1);
  assert.equal(await page.getByRole("button", { name: "Next step" }).isVisible(), false);
  assert.equal(await page.locator(".reason").count(), 0);
  await page.getByRole("button", { name: "Reveal without choosing" }).click();
  await settled(page);
  assert.equal((await state(page)).revealed, true);
  const reasons = await shownReasons();
  assert.deepEqual(reasons.map(({ right }) => right), withTexts.choices.map(({ right }) => !!right));
  assert.ok(reasons.every(({ yours, says }) => !yours && says));
});

test("what was chosen stands beside the truth, is known when one comes back, and never goes into the address", async () => {
  await ask(page, withTexts);
  const mine = wrongOf(withTexts);
  await radios().nth(mine).click();
  await page.getByRole("button", { name: "Reveal the answer" }).click();
  await settled(page);
  assert.equal((await shownReasons()).findIndex(({ yours }) => yours), mine);
  await page.waitForFunction((step) => location.hash === `#step=${step}&answer=1&still=1&gl=none`, withTexts.step + 1);
  await reload(page);
  await page.locator(".reason.is-yours").waitFor();
  await follow(page, `${QUICK}&step=${withTexts.step + 1}`);
  assert.equal(await checked(), mine);
});

test("Page down reveals as before, whatever is chosen, and Page up asks again", async () => {
  await ask(page, withTexts);
  await press(page, "PageDown");
  assert.equal((await state(page)).revealed, true);
  await press(page, "PageUp");
  assert.equal(await radios().count(), withTexts.choices.length);
});

test("when all of a lesson's questions are answered its score can be copied; a choice after the answer was seen is no first try", async () => {
  const asked = questions.filter(({ id }) => id === withTexts.id);
  const copyOf = (of) => of.getByRole("button", { name: "Copy this score as text" });
  const reveal = async () => {
    await page.getByRole("button", { name: "Reveal the answer" }).click();
    await settled(page);
  };
  await ask(page, asked[0]);
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { configurable: true, value: { writeText: async (text) => void (window.copied = text) } }));
  for (const [k, question] of asked.entries()) {
    await follow(page, `${QUICK}&step=${question.step + 1}`);
    await radios().nth(k ? rightOf(question) : wrongOf(question)).click();
    await reveal();
    assert.equal(await copyOf(page).count(), k + 1 === asked.length ? 1 : 0, `after question ${k + 1} of ${asked.length}`);
  }
  await follow(page, `${QUICK}&step=${asked[0].step + 1}`);
  await radios().nth(rightOf(asked[0])).click(); // now that the answer is known
  await reveal();
  await copyOf(page).click();
  await page.locator(".done-sentence").getByText("The score is copied as text.").waitFor();
  const { title } = readScene(withTexts.id);
  assert.equal(await page.evaluate(() => window.copied), `“${title}”: ${asked.length - 1} of ${asked.length} questions right at the first try`);
});

test("by keyboard: one stop for Tab, arrows go round and choose, Enter reveals, and the focus goes on", async () => {
  await ask(page, withTexts);
  const count = withTexts.choices.length;
  assert.equal(await radios().evaluateAll((all) => all.filter(({ tabIndex }) => tabIndex === 0).length), 1);
  await radios().first().focus();
  const { pixel } = await state(page);
  await press(page, "ArrowUp");
  assert.equal(await checked(), count - 1);
  await press(page, "ArrowDown", "ArrowRight");
  assert.equal(await checked(), 1);
  assert.deepEqual((await state(page)).pixel, pixel, "the selected pixel stays");
  await press(page, "Enter");
  assert.equal((await state(page)).revealed, true);
  assert.ok(await page.evaluate(() => document.activeElement.classList.contains("next")));
});

test("a pixel that is a choice is chosen by pressing it in the picture, where it has its letter", async () => {
  await ask(page, withPixels);
  const { choices, id } = withPixels;
  const k = rightOf(withPixels);
  assert.deepEqual(await page.locator(".choice-marks .letter").allInnerTexts(), choices.map((_, k) => "ABCDE"[k]));
  const box = await page.locator(".marks").boundingBox();
  const { n } = await state(page);
  await page.mouse.click(box.x + ((choices[k].pixel[0] + 0.5) / n) * box.width, box.y + ((choices[k].pixel[1] + 0.5) / n) * box.height);
  await settled(page);
  assert.equal(await checked(), k, id);
  await radios().nth((k + 1) % choices.length).click();
  await settled(page);
  assert.deepEqual((await state(page)).pixel, choices[(k + 1) % choices.length].pixel, "and a choice selects its pixel");
});

test("in a lecture they stand below the question, as large as it, and the clicker reveals", async () => {
  const hall = await newPage(browser, { viewport: { width: 1920, height: 1080 } });
  await ask(hall, withTexts, "&projector=1");
  const sizes = await hall.locator(".option .choice-words").evaluateAll((all) => all.map((each) => parseFloat(getComputedStyle(each).fontSize)));
  assert.ok(sizes.every((size) => size >= 36), sizes.join());
  assert.equal(await hall.locator(".reveal").getAttribute("aria-label"), "Reveal the answer", "a hall chooses by hands");
  await press(hall, "PageDown");
  const why = await hall.locator(".because").evaluateAll((all) => all.map((each) => parseFloat(getComputedStyle(each).fontSize)));
  assert.ok(why.length && why.every((size) => size >= 26), why.join());
  await hall.close();
});

const WHERE = [["on a desk", { width: 1280, height: 800 }, ""], ["on a phone", { width: 390, height: 844 }, ""], ["in a lecture", { width: 1280, height: 800 }, "&projector=1"], ["in a frame", { width: 700, height: 460 }, "&embed=1"]];
for (const [where, size, more] of WHERE)
  test(`${where} nothing of any question's choices is cut, nor of their reasons, and axe finds no fault`, async () => {
    const sized = await newPage(browser, { viewport: size });
    for (const question of cases([withTexts, withPixels], [more === "&projector=1" ? withPixels : withTexts]))
      for (const answer of ["", "&answer=1"]) {
        await (answer ? follow(sized, `${QUICK}&step=${question.step + 1}${more}${answer}`) : ask(sized, question, more));
        const cut = await sized.locator(".prediction :is(.option, .reason, .because)").evaluateAll((all) => all.filter((each) => each.scrollWidth > each.clientWidth + 1 || each.getBoundingClientRect().width < 60).length);
        assert.equal(cut, 0);
        const targets = await sized.locator(".option").evaluateAll((all) => all.map((each) => each.getBoundingClientRect().height));
        assert.ok(targets.every((high) => high >= 44), targets.join());
        await sized.evaluate(axe);
        const { violations } = await sized.evaluate(() => window.axe.run(document.querySelector(".viewer"), { preload: false }));
        assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]), []);
      }
    assert.deepEqual(sized.faults, []);
    await sized.close();
  });

test("in a kiosk choices are as large as thumbs", async () => {
  const kiosk = await newPage(browser);
  await ask(kiosk, withTexts, "&kiosk=1&visitor=1");
  const heights = await radios(kiosk).evaluateAll((all) => all.map((each) => each.getBoundingClientRect().height));
  assert.ok(heights.length && heights.every((high) => high >= 64), heights.join());
  await kiosk.close();
});

test("a question of another scene has its own choices, and a step without any has none", async () => {
  await ask(page, withTexts);
  await press(page, "PageUp", "PageUp", "PageUp");
  const { scene, step, revealed } = await state(page);
  const has = scenes.find(({ id }) => id === scene).lesson[step].choices && !revealed;
  assert.equal(await page.locator(".prediction").isVisible(), !!has);
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
