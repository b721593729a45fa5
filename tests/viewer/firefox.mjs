/** Firefox as a person has it: a new profile with the rules it comes with. Playwright drives patched builds only and
 *  WebDriver needs a program of its own, so this speaks Marionette, which every Firefox has: lines of JSON over TCP. */
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createConnection } from "node:net";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { PATIENCE } from "./browser.mjs";

const NAMES = ["firefox-esr", "firefox"];

/** What only keeps a new profile from asking and from calling home; nothing that pages are allowed or refused. */
const QUIET = {
  "app.normandy.enabled": false,
  "app.update.disabledForTesting": true,
  "browser.aboutwelcome.enabled": false,
  "browser.shell.checkDefaultBrowser": false,
  "browser.startup.homepage_override.mstone": "ignore",
  "browser.startup.page": 0,
  "marionette.port": 0, // any; it is written into the profile
  "datareporting.policy.dataSubmissionEnabled": false,
  "network.captive-portal-service.enabled": false,
  "network.connectivity-service.enabled": false,
  "remote.prefs.recommended": false, // else the protocol would relax the profile's rules
  "termsofuse.bypassNotification": true,
};

/** Path of the Firefox here, or null. */
export function firefoxHere() {
  const folders = (process.env.PATH ?? "").split(delimiter);
  const candidates = [process.env.FIREFOX, ...NAMES.flatMap((name) => folders.map((folder) => join(folder, name)))];
  return candidates.find((path) => path && existsSync(path)) ?? null;
}

/** A session: send(command, parameters) gives its value. */
async function connect(port) {
  const socket = createConnection(port, "127.0.0.1");
  const waiting = new Map();
  let last = 0;
  let rest = Buffer.alloc(0);
  const greeted = new Promise((done, fail) => (waiting.set("greeting", { done }), socket.once("error", fail)));
  socket.on("data", (data) => {
    rest = Buffer.concat([rest, data]);
    for (let colon; (colon = rest.indexOf(":")) > 0; ) {
      const end = colon + 1 + Number(rest.subarray(0, colon));
      if (rest.length < end) return;
      const message = JSON.parse(rest.subarray(colon + 1, end));
      rest = rest.subarray(end);
      const [, id, error, result] = Array.isArray(message) ? message : [1, "greeting", null, message];
      const { done, fail } = waiting.get(id);
      waiting.delete(id);
      error ? fail(new Error(`${error.error}: ${error.message}`)) : done(result);
    }
  });
  await greeted;
  return (command, parameters = {}) =>
    new Promise((done, fail) => {
      waiting.set(++last, { done, fail });
      const text = JSON.stringify([0, last, command, parameters]);
      socket.write(`${Buffer.byteLength(text)}:${text}`);
    });
}

/** All that the browser's console has, of pages whose address begins so: errors, warnings, policies, console.log. */
const SAID = `
  const home = arguments[0];
  const api = Cc["@mozilla.org/consoleAPI-storage;1"].getService(Ci.nsIConsoleAPIStorage).getEvents();
  const logged = api.filter((each) => String(each.filename).startsWith(home)).map((each) => each.level + ": " + each.arguments.join(" "));
  const errors = Services.console.getMessageArray().filter((each) => each instanceof Ci.nsIScriptError && (each.sourceName.startsWith(home) || each.errorMessage.includes(home)));
  return [...logged, ...errors.map((each) => each.category + ": " + each.errorMessage)];
`;

/** A running Firefox. visit(url) opens a page, evaluate(expression) asks it, said(home) is what its console has. */
export async function startFirefox(path) {
  const profile = mkdtempSync(join(tmpdir(), "raywalk-firefox-"));
  writeFileSync(join(profile, "user.js"), Object.entries(QUIET).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});\n`).join(""));
  const flags = ["--headless", "--no-remote", "--profile", profile, "--marionette", "--remote-allow-system-access"];
  const browser = spawn(path, flags, { stdio: "ignore", env: { ...process.env, MOZ_HEADLESS: "1" } });
  const ended = new Promise((done) => browser.once("exit", done));
  const portFile = join(profile, "MarionetteActivePort");
  for (const end = Date.now() + PATIENCE; !existsSync(portFile) || !readFileSync(portFile, "utf8"); await new Promise((done) => setTimeout(done, 50)))
    if (Date.now() > end || browser.exitCode !== null) throw new Error(`${path} did not start`);
  const send = await connect(Number(readFileSync(portFile, "utf8")));
  const { capabilities } = await send("WebDriver:NewSession", { capabilities: {} });
  await send("WebDriver:SetTimeouts", { script: PATIENCE, pageLoad: PATIENCE });
  const ask = async (script, ...args) => (await send("WebDriver:ExecuteScript", { script, args })).value;
  return {
    version: capabilities.browserVersion,
    visit: (url) => send("WebDriver:Navigate", { url }),
    resize: (width, height) => send("WebDriver:SetWindowRect", { width, height }),
    /** expression: of a value or a promise, in the page. */
    evaluate: (expression) => ask(`return (async () => JSON.parse(JSON.stringify((await (${expression})) ?? null)))()`),
    press: (...keys) => send("WebDriver:PerformActions", { actions: [{ type: "key", id: "keyboard", actions: keys.flatMap((value) => [{ type: "keyDown", value }, { type: "keyUp", value }]) }] }),
    screenshot: async () => Buffer.from((await send("WebDriver:TakeScreenshot", { full: false })).value, "base64"),
    async said(home) {
      await send("Marionette:SetContext", { value: "chrome" });
      const found = await ask(SAID, home);
      await send("Marionette:SetContext", { value: "content" });
      return found;
    },
    async close() {
      await send("Marionette:Quit", { flags: ["eForceQuit"] }).catch(() => browser.kill());
      await ended;
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}
