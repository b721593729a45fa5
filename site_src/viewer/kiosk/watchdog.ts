/**
 * Recovers from an uncaught error, a drawing context that was lost, a viewer that does not come: by loading the page anew,
 * three times with WebGL, then without it, and never more than once a minute when nothing helps.
 */
import type { KioskHook } from "./hook";
import type { Strikes } from "./strikes";

const SOON = 300; // ms
const LATER = 60_000; // ms
const VIEWER_COMES = 20_000; // ms

export interface WatchdogActs {
  hasViewer: boolean;
  recover: () => void;
  isVisited: () => boolean;
}

export function createWatchdog(hook: KioskHook, strikes: Strikes, { hasViewer, recover, isVisited }: WatchdogActs) {
  let isRecovering = false;

  function fault() {
    if (isRecovering) return;
    isRecovering = true;
    strikes.add();
    setTimeout(recover, strikes.isHopeless() ? LATER : SOON);
  }

  window.addEventListener("error", (event) => event.error && fault());
  window.addEventListener("unhandledrejection", fault);
  // Somebody who is there goes on with the flat drawing; the start gets the drawing back.
  window.addEventListener(
    "webglcontextlost",
    () => {
      if (isVisited()) strikes.add();
      else fault();
    },
    { capture: true },
  );
  if (hasViewer) setTimeout(() => hook.viewer || fault(), VIEWER_COMES);
  if (hook.faults.length) fault();
  return { fault };
}
