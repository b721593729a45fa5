/** The scene chooser: chapters of the course, in them its scenes, at any number of them. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, openChooser, scenesOfSite, settled, until } from "./browser.mjs";

const scenes = scenesOfSite();
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
  await open(page, ON_DISK, scenes[0].path, "gl=none");
});
after(() => browser.close());

test("scenes stand in chapters, in the order in which one turns from one to the next", async () => {
  const chapters = await page.evaluate(() =>
    [...document.querySelectorAll("nav.scenes .chapter")].map((chapter) => [chapter.querySelector("h2").textContent, [...chapter.querySelectorAll("a")].map((link) => link.dataset.scene)]),
  );
  assert.deepEqual(chapters.map(([name]) => name), ["Rays", "Light", "Mirrors", "Many triangles", "Glass", "Sampling", "Pictures"]);
  assert.deepEqual(chapters.flatMap(([, ids]) => ids), scenes.map(({ id }) => id));
  await openChooser(page);
  await page.locator("nav.scenes a[rel=next]").click();
  await until(page, ({ scene }, _, next) => scene === next, scenes[1].id);
});

test("the ten scenes keep their keys and their order", () => {
  assert.equal(scenes.map(({ key }) => key).join(""), "1234567890");
});

for (const [width, height] of [[1280, 800], [1366, 768]])
  test(`thirty scenes are seen at once at ${width} x ${height}`, async () => {
    await page.setViewportSize({ width, height });
    await openChooser(page);
    const [seen, whole] = await page.evaluate(() => {
      const chooser = document.querySelector("nav.scenes");
      const links = () => chooser.querySelectorAll(".chapter a");
      while (links().length < 30) links()[links().length - 3].after(links()[links().length - 3].cloneNode(true));
      return [chooser.clientHeight, chooser.scrollHeight];
    });
    assert.ok(whole <= seen + 1, `${whole} of ${seen} pixels`);
    await page.keyboard.press("Escape");
  });

test("on a phone they are scrolled through, and none is cut off", async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  await openChooser(page);
  const wide = await page.evaluate(() => [...document.querySelectorAll("nav.scenes .chapter a")].every((link) => link.getBoundingClientRect().right <= innerWidth && link.scrollWidth <= link.clientWidth + 1));
  assert.ok(wide);
  assert.deepEqual(page.faults, []);
});

for (const [width, height] of [[390, 844], [360, 640]])
  for (const home of ["", "de/"])
    test(`above the scene its title is seen whole, however long, at ${width} x ${height} (${home || "en/"})`, async () => {
      await page.setViewportSize({ width, height });
      await open(page, ON_DISK, home + scenes[0].path, "gl=none");
      const cut = await page.evaluate(() => {
        const title = document.querySelector("#title");
        const row = document.querySelector(".top").getBoundingClientRect().height;
        return [...document.querySelectorAll("nav.scenes [data-scene]")].flatMap((link) => {
          title.textContent = `${link.dataset.key && `${link.dataset.key} · `}${link.title}`;
          const isWhole = title.scrollWidth <= title.clientWidth && title.scrollHeight <= title.clientHeight + 1;
          return isWhole && document.querySelector(".top").getBoundingClientRect().height === row ? [] : [title.textContent];
        });
      });
      assert.deepEqual(cut, []);
    });

test("the first page leads to each chapter", async () => {
  const home = await newPage(browser);
  await home.goto(`${ON_DISK}index.html`);
  const links = home.locator(".chapter-links a");
  const names = await links.allInnerTexts();
  assert.deepEqual(names, await home.locator(".chapter-name").allInnerTexts());
  await links.last().click();
  await settled(home); // it is scrolled there with the next frame, to a whole pixel of the screen, which is two of the page
  const [heading, seen] = await home.locator(".chapter-name").last().evaluate((each) => [each.getBoundingClientRect(), innerHeight]);
  assert.ok(heading.top >= -1 && heading.bottom <= seen, `${heading.top} to ${heading.bottom} of ${seen}`);
  assert.deepEqual(home.faults, []);
  await home.close();
});
