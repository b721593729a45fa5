/** How long nobody has touched anything: a warning that counts down, then a reset. */
import type { KioskSettings } from "../state/kiosk-fields";

const INPUTS = ["pointerdown", "pointermove", "keydown", "wheel", "touchstart", "touchmove"] as const;
const TICK = 250; // ms

export interface IdleActs {
  warn: (secondsLeft: number) => void;
  goOn: () => void;
  reset: () => void;
}

export function createIdle({ idle, warn }: KioskSettings, acts: IdleActs) {
  let since = 0; // ms; 0: it does not run
  let warned = false;

  const now = () => performance.now();
  const left = () => (since ? Math.max(0, idle - (now() - since) / 1000) : null);

  function touched() {
    if (!since) return;
    since = now();
    if (warned) acts.goOn();
    warned = false;
  }

  function tick() {
    const seconds = left();
    if (seconds === null) return;
    if (seconds <= 0) {
      since = 0;
      acts.reset();
    } else if (seconds <= warn) {
      warned = true;
      acts.warn(Math.ceil(seconds));
    }
  }

  for (const input of INPUTS) window.addEventListener(input, touched, { capture: true, passive: true });
  setInterval(tick, Math.min(TICK, 100 * idle));
  return { start: () => void (since = now()), left };
}
