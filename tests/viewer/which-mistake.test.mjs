/** Which mistake is this? Asked from a disk by keyboard and finger, and read without a script. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK } from "./browser.mjs";
import { wordsOf } from "./typescript.mjs";

const said = Object.fromEntries(["en", "de"].map((language) => [language, wordsOf(language).pages.mistakes.which]));
const HERE = "mistakes/which/index.html";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

async function visit(path = HERE, options = {}) {
  const page = await newPage(browser, options);
  page.home = ON_DISK;
  await page.goto(`${ON_DISK}${path}`);
  return page;
}

/** Of a question: where the right choice stands among its options, and where a wrong one. */
const placesIn = (question) => question.locator(".options > li").evaluateAll((options) => {
  const right = options.findIndex((option) => "right" in option.dataset);
  return { right, wrong: right ? 0 : 1 };
});

test("a choice by keyboard opens the answer and says whether it was right; the first one counts", async () => {
  const page = await visit();
  const [first, second] = [0, 1].map((k) => page.locator(".question").nth(k));
  for (const [question, kind] of [[first, "right"], [second, "wrong"]]) {
    const places = await placesIn(question);
    assert.equal(await question.locator("details").getAttribute("open"), null);
    await question.locator("button.option").nth(places[kind]).focus();
    await page.keyboard.press("Enter");
    assert.notEqual(await question.locator("details").getAttribute("open"), null);
    const letter = "ABCD"[places.right];
    assert.equal(await question.locator(".verdict").textContent(), kind === "right" ? said.en.right : said.en.wrong.replace("{letter}", letter));
    assert.equal(await question.locator(".is-answer .letter").textContent(), letter);
    await question.locator("button.option").nth(places[kind === "right" ? "wrong" : "right"]).press("Enter");
    assert.equal(await question.locator('[aria-pressed="true"]').textContent(), await question.locator(".is-yours").textContent());
  }
  assert.equal(await page.locator(".round").first().locator(".score").textContent(), said.en.score.replace("{right}", 1).replace("{count}", 2));
  await page.context().close();
});

test("who has read the answer first is told, and not counted", async () => {
  const page = await visit();
  const question = page.locator(".question").first();
  await question.locator("summary").click();
  await question.locator("button.option").nth((await placesIn(question)).right).click();
  assert.equal(await question.locator(".verdict").textContent(), said.en.right);
  assert.equal(await page.locator(".score").first().textContent(), "");
  await page.context().close();
});

test("a finger chooses on a phone, in German; both pictures stand side by side and nothing is cut off", async () => {
  const page = await visit(`de/${HERE}`, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const question = page.locator(".question").first();
  await question.locator("button.option").nth((await placesIn(question)).right).tap();
  assert.equal(await question.locator(".verdict").textContent(), said.de.right);
  const [right, wrong] = await question.locator("img").evaluateAll((all) => all.map((each) => each.getBoundingClientRect().toJSON()));
  assert.ok(wrong.top === right.top && right.right < wrong.left && wrong.right <= 390, JSON.stringify([wrong, right]));
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await page.context().close();
});

test("all answers open at once, for who prints them, and the answer's link leads to its mistake", async () => {
  const page = await visit();
  await page.getByRole("button", { name: said.en.open }).click();
  const answers = page.locator(".question details");
  assert.equal(await page.locator(".question details[open]").count(), await answers.count());
  const title = await answers.first().locator("strong").textContent();
  await answers.first().getByRole("link", { name: said.en.rays }).click();
  assert.equal(await page.locator("h1").textContent(), title);
  await page.context().close();
});

test("without a script there are questions, and answers that open", async () => {
  const page = await visit(HERE, { javaScriptEnabled: false });
  const question = page.locator(".question").first();
  assert.equal(await question.locator("li button").count(), 0);
  assert.equal(await question.locator(".options > li").count(), 4);
  assert.ok(!(await question.locator(".is-answer").isVisible()));
  await question.locator("summary").click();
  assert.ok(await question.locator(".is-answer").isVisible());
  await page.context().close();
});

test("on a phone no number of a mistake's page is broken within its digits, and nothing is cut off", async () => {
  const page = await visit("mistakes/index.html", { viewport: { width: 390, height: 844 }, isMobile: true });
  for (const name of ["not-bent-at-exit", "pixel-corner", "normal-not-unit"]) {
    for (const home of ["", "de/"]) {
      await page.goto(`${ON_DISK}${home}mistakes/${name}/index.html`);
      const broken = await page.evaluate(() => {
        const found = [];
        const texts = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
        for (let text; (text = texts.nextNode()); ) {
          for (const { 0: number, index } of text.data.matchAll(/\u2212?\d[\d.,]*/g)) {
            const range = document.createRange();
            range.setStart(text, index);
            range.setEnd(text, index + number.length);
            if (range.getClientRects().length > 1) found.push(number);
          }
        }
        return found;
      });
      assert.deepEqual(broken, [], `${home}${name}`);
      const [wide, table] = await page.evaluate(() => [document.documentElement, document.querySelector(".test").parentElement].map((each) => each.scrollWidth - each.clientWidth));
      assert.deepEqual([wide, table], [0, 0], `${home}${name}`);
    }
  }
  await page.context().close();
});
