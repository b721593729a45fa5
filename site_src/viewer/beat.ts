/**
 * When to draw. Nothing runs unless there is something to show: a change asks for one frame, filling
 * tiles for one frame after another, the blinking selector for two a second.
 */
const BLINK_MS = 530;
const LONGEST_STEP = 0.1; // seconds: after a pause (another tab) time does not jump

export interface BeatActs {
  draw: () => void;
  runs: () => boolean; // does time move?
  step: (seconds: number) => void;
  blinks: () => boolean;
}

export function createBeat(acts: BeatActs) {
  let frame = 0;
  let last = 0;
  let dark = false;
  let blinkTimer = 0;

  function tick(now: number) {
    frame = 0;
    if (acts.runs()) {
      if (last) acts.step(Math.min(LONGEST_STEP, (now - last) / 1000));
      last = now;
    } else last = 0;
    acts.draw();
    if (acts.runs()) ask();
    else last = 0;
    blink();
  }
  function ask() {
    if (!frame) frame = requestAnimationFrame(tick);
  }
  function blink() {
    if (!acts.blinks()) {
      clearTimeout(blinkTimer);
      blinkTimer = 0;
      dark = false;
    } else
      blinkTimer ||= window.setTimeout(() => {
        blinkTimer = 0;
        dark = !dark;
        ask();
      }, BLINK_MS);
  }
  return {
    /** Something has changed: shows it in the next frame, the selector lit. */
    draw() {
      dark = false;
      clearTimeout(blinkTimer);
      blinkTimer = 0;
      ask();
    },
    isDark: () => dark,
  };
}
