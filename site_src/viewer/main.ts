/** The viewer's table of contents: one session, what can be done with it, what shows it, what moves it. */
import { createActions } from "./actions";
import { createAddressBar } from "./address-bar";
import { createBeat } from "./beat";
import { exposeSession } from "./for-tests";
import { listenToKeys } from "./keys";
import { giveKeysBack, listenToLinks } from "./links";
import { createLoader, loading } from "./load";
import { createNavigation } from "./navigation";
import { createNotice } from "./panels/notice";
import { createParts } from "./parts";
import { createSession } from "./session";
import { createModes } from "./modes";
import { createOnDemand } from "./on-demand";
import { readAddress } from "./state/address";
import { createSupplies } from "./supplies";
import { passTime } from "./time";
import { listenToErrors } from "./trouble";
import { say } from "./words";

const BLINK_UP_TO = 5000; // lines: more would be drawn anew twice a second for one blinking tile

/** own: this script. */
function start(own: HTMLScriptElement) {
  const { body } = document;
  const find = (selector: string) => document.querySelector<HTMLElement>(selector)!;
  const root = body.dataset.root ?? "";
  const links = [...document.querySelectorAll<HTMLAnchorElement>("nav.scenes a[data-scene]")];
  const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
  const withGl = readAddress(location.hash, location.search).gl;

  const notice = createNotice(find("#notice"));
  listenToErrors(own.src, notice);
  const onDemand = createOnDemand(own, notice);
  const recombining = onDemand.one("switch-acts", ({ createWhatIf }) => ({ shown: createWhatIf().of, finest: createWhatIf().of }));
  const costing = onDemand.one("tile-legend", ({ costsOf }) => costsOf);
  const changed = () => session.changed();
  const session = createSession(() => recombining.nowOr(changed), () => costing.nowOr(changed));
  const loader = createLoader(root, onDemand.come);
  const supplies = createSupplies(session, loader, onDemand, notice, () => beat.draw());
  const place = { home: body.dataset.scene ?? "", onDisk: location.protocol === "file:", links, withGl };
  const bar = createAddressBar(session, place);
  const navigation = createNavigation(session, place, { loader, bar, notice, loadTrace: supplies.trace });
  const switching = onDemand.one("switch-acts", ({ createSwitchActs }) => createSwitchActs(session));
  const acts = createActions(session, { draw: () => beat.draw(), turnScene: navigation.turn, sceneOfKey: navigation.ofKey, switching: switching.use });
  const parts = createParts(session, acts, onDemand, {
    home: find("#viewer"),
    page: { root, article: find("#page"), title: find("#title"), links },
    withGl,
    pictureFailed: (again) => notice.say(say("trouble.pictureMissing"), { about: "picture", again }),
    kept: loader.kept,
    simpler: (why) => (why ? notice.say(why, { about: "stage" }) : notice.hide("stage")),
  });
  const modes = createModes(session, acts, { address: bar.now, views: parts.views, recolour: parts.recolour, notify: notice.say, onDemand });
  const busy = onDemand.one("busy", ({ createBusy }) => createBusy(parts.views.stage));
  const beat = createBeat({
    draw() {
      modes.show();
      parts.render(beat.isDark());
    },
    runs: () => session.state?.tiles === "filling" || session.state?.playing === true,
    step: (seconds) => passTime(session, seconds),
    paced: (ms) => busy.when(ms > 125, () => {})?.frame(ms),
    blinks: () => !!session.state && !session.state.still && !reducedMotion.matches && parts.linesDrawn() < BLINK_UP_TO,
  });

  session.listen({
    changed() {
      beat.draw();
      bar.writeSoon();
      supplies.more();
    },
    otherLevel: () => void supplies.trace(),
  });
  listenToKeys({ ...acts, ...modes });
  giveKeysBack(body);
  listenToLinks(document.querySelectorAll<HTMLAnchorElement>("nav.scenes a"), { open: navigation.open, turn: navigation.turn });
  reducedMotion.addEventListener("change", () => beat.draw());

  navigation.followPage();
  const whole = navigation.ready().then(onDemand.bringAll).then(session.changed);
  window.raywalkKiosk?.attach({ session, acts, begin: navigation.begin, ready: navigation.ready, ids: navigation.ids, notify: notice.say });
  exposeSession(session, {
    ready: navigation.ready,
    whole,
    loading,
    moving: beat.moving,
    stats: () => ({ ...parts.stats(), notice: notice.text(), kiosk: window.raywalkKiosk?.status() ?? null }),
    loseContext: parts.loseContext,
  });
}

// Without its words the page stays as it was written; page/broken.js says so.
if ("raywalkWords" in globalThis) start(document.currentScript as HTMLScriptElement);
