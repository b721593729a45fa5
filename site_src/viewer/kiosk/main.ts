/** A kiosk's table of contents: it shows itself until somebody touches it, and starts again when they have gone. */
import { list, say } from "../words";
import { kioskDamages, readKiosk } from "../state/kiosk-fields";
import { button, element } from "../element";
import { createAttract } from "./attract";
import { createIdle } from "./idle";
import { lockPage } from "./locks";
import { createBegin, createWarning } from "./overlay";
import { createPlaces } from "./places";
import { createStrikes } from "./strikes";
import { createWatchdog } from "./watchdog";
import { keepAwake } from "./wake-lock";
import type { KioskViewer } from "./hook";

function start() {
  const hook = window.raywalkKiosk!;
  const damaged = kioskDamages(new Map(new URLSearchParams(location.hash.slice(1))));
  const settings = readKiosk(new Map(new URLSearchParams(hook.part)));
  const strikes = createStrikes(settings.strikes);
  const places = createPlaces(hook, settings, strikes);
  const hasViewer = "scene" in document.body.dataset;
  let attract: ReturnType<typeof createAttract> | null = null;

  const begin = createBegin(() => void visit());
  const warning = createWarning();
  const idle = createIdle(settings, { warn: warning.show, goOn: warning.hide, reset: places.reset });
  const wake = keepAwake();
  lockPage(places);
  document.querySelector(".top, .brand-row")?.append(button(say("kiosk.again"), say("kiosk.againHelp"), places.reset, { className: "kiosk-again" }));

  /** Somebody is here: what is being shown begins for them. */
  async function visit() {
    const scene = attract?.scene() ?? null;
    attract?.stop();
    places.visited(true);
    begin.hide();
    idle.start();
    if (scene && hook.viewer) await hook.viewer.begin(scene);
  }

  /** Nobody is here. */
  function showItself(viewer: KioskViewer) {
    begin.show();
    attract = createAttract(viewer, settings.pace, { stuck: watchdog.fault, renew: places.reset });
    void attract.run();
  }

  const watchdog = createWatchdog(hook, strikes, { hasViewer, recover: places.recover, isVisited: () => settings.visitor });
  const arrived = async (viewer: KioskViewer) => {
    await viewer.ready();
    if (damaged.length) viewer.notify(say("trouble.address", { keys: list(damaged.slice(0, 6).map((key) => key.slice(0, 16))) }));
    if (!settings.visitor) showItself(viewer);
  };
  if (settings.visitor || !hasViewer) idle.start();
  else begin.show();
  hook.arrived = (viewer) => void arrived(viewer);
  if (hook.viewer) hook.arrived(hook.viewer);
  hook.status = () => ({
    attract: attract?.runs() ?? false,
    ...(attract?.counts() ?? { stops: 0, cycles: 0 }),
    strikes: strikes.count(),
    awake: wake.isHeld(),
    left: idle.left(),
  });
}

const whenRead = () => {
  document.body.append(element("div", "kiosk-marks")); // a place for what lies over the page
  start();
};
if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", whenRead);
else whenRead();
