/** A monkey at the page: random keys, taps, drags, wheels, resizes and links, the same ones for the same seed. Most
 *  are made inside the page, as fast as it takes them; what only a browser can do (its own keys, its mouse, another
 *  window size) comes from outside between two bursts. */
import assert from "node:assert/strict";
import { randomFrom } from "./random.mjs";
import { readScene } from "./scene-files.mjs";

export const BURST = 50;

/** Before the page's scripts: what would leave the page or ask the person is only counted. */
export function tame() {
  window.kept = { saved: 0, screen: 0 };
  const { click } = HTMLAnchorElement.prototype;
  HTMLAnchorElement.prototype.click = function () {
    this.hasAttribute("download") ? window.kept.saved++ : click.call(this);
  };
  Element.prototype.requestFullscreen = async () => void window.kept.screen++;
  Object.defineProperty(navigator, "clipboard", { configurable: true, value: { writeText: async () => {} } });
  window.print = () => {};
  // Pictures and figures are saved in other tests; made hundreds of times, they would take most of the time here.
  HTMLCanvasElement.prototype.toDataURL = () => "data:,";
  HTMLCanvasElement.prototype.toBlob = (done) => done(new Blob(["a picture"]));
  // A pointer that a script made up cannot be captured; the page must not notice.
  Element.prototype.setPointerCapture = () => {};
  addEventListener("click", (event) => {
    const link = event.target instanceof Element && event.target.closest("a[href]");
    if (link && !link.dataset.scene && !link.rel) event.preventDefault(); // leads away
  });
}

/** In the page: a burst of inputs. Returns what was done, the last of it first to be seen when it fails. */
function burst({ numbers, scenes }) {
  let at = 0;
  const random = () => numbers[at++ % numbers.length];
  const one = (of) => of[Math.floor(random() * of.length)];
  const KEYS = [..."ahvrtxp,.fj?[]scl0123456789+-= ", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "PageUp", "PageDown", "Escape", "Enter", "Tab", "Home", "End", "é", "Shift", "F13"];
  const LINK = {
    n: ["5", "15", "105", "-1", "1e99", "x"], p: ["0,0", "3,4", "999,999", "-1,NaN", ","], rays: ["none", "all", "row,column", "diagonal"],
    tiles: ["filled", "empty", "half"], cam: ["camera", "start", "1,2,3,0,0,0", "1e308,0,1,0,0,0", "0,0,0,0,0,0"], look: ["plain", "traced", "x"], slice: ["row", "column", "none", "x"],
    if: ["b0", "b1,-shadows", "l1x0", "l99x9", "none", "%%"], colours: ["tests", "depth", "rays", "x"], step: ["1", "4", "99", "0"], answer: ["1", "x"],
    e: ["1", "5", "9999"], speed: ["8", "0.25", "NaN"], projector: ["1", "x"], scene: [...scenes, "nowhere"], "%E0%A4%A": ["%"],
  };
  const acts = {
    key() {
      const key = one(KEYS);
      const to = random() < 0.8 ? document.activeElement ?? document.body : document.body;
      to.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, shiftKey: random() < 0.1, repeat: random() < 0.1 }));
      return `key ${key}`;
    },
    press() {
      const buttons = [...(document.querySelector("dialog[open]") ?? document).querySelectorAll("button, nav.scenes a, summary, [role=tab], li.ray")].filter((each) => each.checkVisibility());
      const pressed = one(buttons);
      if (!pressed) return "press nothing";
      random() < 0.3 && pressed.focus();
      pressed.click();
      return `press ${pressed.getAttribute("aria-label") ?? pressed.textContent.slice(0, 30)}`;
    },
    slide() {
      const sliders = [...document.querySelectorAll("input[type=range], select")].filter((each) => each.checkVisibility());
      const slider = one(sliders);
      if (!slider) return "slide nothing";
      slider.value = slider instanceof HTMLSelectElement ? one([...slider.options]).value : String(Number(slider.min || 0) + random() * (Number(slider.max || 100) - Number(slider.min || 0)));
      for (const kind of ["input", "change"]) slider.dispatchEvent(new Event(kind, { bubbles: true }));
      return `slide ${slider.getAttribute("aria-label")} to ${slider.value}`;
    },
    drag() {
      const on = document.querySelector(one([".stage-view", ".marks", ".slice", ".card", "body"])) ?? document.body; // a part may not be there yet
      const box = on.getBoundingClientRect();
      const fingers = random() < 0.2 ? 2 : 1;
      const place = () => ({ clientX: box.x + (1.2 * random() - 0.1) * box.width, clientY: box.y + (1.2 * random() - 0.1) * box.height });
      const send = (kind, pointerId, more) => on.dispatchEvent(new PointerEvent(kind, { bubbles: true, cancelable: true, pointerId, pointerType: "touch", button: one([0, 0, 0, 1, 2]), buttons: kind === "pointerup" ? 0 : 1, shiftKey: random() < 0.1, ...place(), ...more }));
      for (let finger = 0; finger < fingers; finger++) send("pointerdown", 70 + finger);
      for (let k = 0; k < 3; k++) send("pointermove", 70 + (k % fingers));
      for (let finger = 0; finger < fingers; finger++) send(random() < 0.9 ? "pointerup" : "pointercancel", 70 + finger);
      return `drag ${fingers} on ${on.className || on.tagName}`;
    },
    hover() {
      const on = document.querySelector(one([".stage-view", ".marks", ".card"]));
      const box = on.getBoundingClientRect();
      for (const kind of ["pointermove", "pointerleave"]) on.dispatchEvent(new PointerEvent(kind, { bubbles: true, pointerType: "mouse", clientX: box.x + random() * box.width, clientY: box.y + random() * box.height }));
      return "hover";
    },
    wheel() {
      document.querySelector(".stage-view").dispatchEvent(new WheelEvent("wheel", { bubbles: true, cancelable: true, deltaY: one([-120, 120, 3, 1e6, -1e6, 0]), deltaMode: one([0, 1]), ctrlKey: random() < 0.2 }));
      return "wheel";
    },
    link() {
      const hash = Array.from({ length: 1 + Math.floor(3 * random()) }, () => one(Object.keys(LINK))).map((key) => `${key}=${one(LINK[key])}`).join("&");
      location.hash = hash;
      return `link #${hash}`;
    },
    back() {
      // Not by history.back(): before its first link that would leave the page.
      const went = random() < 0.5 ? navigation.canGoBack && navigation.back() : navigation.canGoForward && navigation.forward();
      if (went) for (const way of [went.committed, went.finished]) way.catch(() => {}); // overtaken by the next link
      return "back or forward";
    },
  };
  const OFTEN = { key: 45, press: 22, slide: 6, drag: 10, hover: 6, wheel: 5, link: 5, back: 1 };
  const urn = Object.entries(OFTEN).flatMap(([name, times]) => Array(times).fill(name));
  const done = [];
  for (let k = 0; k < 50; k++) done.push(acts[one(urn)]());
  return done.reverse();
}

const oneOf = (value, allowed, what) => assert.ok(allowed.includes(value), `${what}: ${JSON.stringify(value)}`);

/** Is this a state that a person could have come to? */
export function checkState(now, events) {
  const scene = readSceneOnce(now.scene);
  oneOf(now.n, scene.levels, "n");
  assert.ok(now.pixel.length === 2 && now.pixel.every((k) => Number.isInteger(k) && k >= 0 && k < now.n), `pixel ${now.pixel} of ${now.n}`);
  assert.ok(now.place.every((share) => share >= 0 && share <= 1), `place ${now.place}`);
  for (const choice of now.rays) oneOf(choice, ["pixel", "row", "column", "all"], "rays");
  oneOf(now.tiles, ["empty", "filling", "filled"], "tiles");
  assert.ok(now.drawn >= 0 && now.drawn <= now.n * now.n, `drawn ${now.drawn}`);
  oneOf(now.speed, [0.25, 0.5, 1, 2, 4, 8], "speed");
  if (typeof now.observer === "string") oneOf(now.observer, ["start", "camera"], "observer");
  else assert.ok([...now.observer.eye, ...now.observer.target].every(Number.isFinite), `observer ${JSON.stringify(now.observer)}`);
  oneOf(now.look, ["plain", "approximate", "traced"], "look");
  oneOf(now.slice, ["none", "row", "column"], "slice");
  if (now.step === null) assert.equal(now.revealed, false);
  else assert.ok(scene.lesson[now.step] && (!now.revealed || scene.lesson[now.step].answer), `step ${now.step}, revealed ${now.revealed}`);
  if (now.event !== null) assert.ok(Number.isInteger(now.event) && now.event >= 0 && (!events || now.event < events), `event ${now.event} of ${events}`);
  assert.ok(now.share >= 0 && now.share <= 1, `share ${now.share}`);
  const { bounces, lamps, without } = now.switches;
  assert.ok(bounces === null || (bounces >= 0 && bounces < scene.depth), `bounces ${bounces}`);
  assert.ok(lamps.every((factor) => factor >= 0 && factor <= 2), `lamps ${lamps}`);
  for (const part of without) oneOf(part, ["ambient", "diffuse", "specular", "reflected", "refracted"], "without");
}
const scenesRead = new Map();
const readSceneOnce = (id) => scenesRead.get(id) ?? scenesRead.set(id, readScene(id)).get(id);

const SIZES = [[1280, 800], [390, 844], [844, 390], [320, 256], [1920, 1080], [1024, 600]];

/** inputs: how many. Throws with the seed and the last inputs when a state is none or the page has complained. */
export async function monkey(page, { seed, inputs, scenes }) {
  const random = randomFrom(seed);
  let last = [];
  try {
    for (let done = 0; done < inputs; done += BURST) {
      const numbers = Array.from({ length: 997 }, random);
      last = await page.evaluate(burst, { numbers, scenes });
      if (random() < 0.1) {
        const [width, height] = SIZES[Math.floor(random() * SIZES.length)];
        await page.setViewportSize({ width, height });
      }
      if (random() < 0.2) for (const key of ["Tab", "Enter", "ArrowDown", "Escape"]) await page.keyboard.press(key);
      if (random() < 0.2) await page.mouse.click(20 + random() * 280, 20 + random() * 200, { button: random() < 0.8 ? "left" : "right" });
      const { now, events, isHere } = await page.evaluate(async (rests) => {
        if (rests) await window.raywalk.ready; // else it goes on while scenes are on their way
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
        const stats = window.raywalk.stats();
        const now = window.raywalk.state();
        return { now, events: stats.events.length, isHere: stats.tiles.length === 3 * now.n * now.n };
      }, random() < 0.3);
      checkState(now, isHere ? events : 0);
      assert.deepEqual(page.faults, []);
    }
  } catch (error) {
    throw new Error(`seed ${seed}: ${error.message}\nlast inputs, newest first:\n${last.slice(0, 60).join("\n")}`, { cause: error });
  }
}

/** What brings the start back: sheets closed, and the scene's own address. */
export async function reset(page, address) {
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.evaluate(() => document.querySelectorAll("dialog[open]").forEach((sheet) => sheet.close()));
  await page.evaluate((address) => {
    history.pushState(null, "", address);
    dispatchEvent(new PopStateEvent("popstate"));
    return window.raywalk.ready;
  }, address);
}
