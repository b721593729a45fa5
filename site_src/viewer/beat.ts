/**
 * When to draw. Nothing runs unless there is something to show: a change asks for one frame, filling
 * tiles for one frame after another, the blinking selector for two a second, until it has been found.
 */
const BLINK_MS = 530;
const BLINKS = 8; // times that it changes: what blinks for longer than five seconds must have a switch (WCAG 2.2.2)
const LONGEST_STEP = 1; // seconds: slower frames are a machine that stood still, and time does not jump over that

export interface BeatActs {
  draw: () => void;
  runs: () => boolean; // does time move?
  step: (seconds: number) => void;
  blinks: () => boolean;
  /** ms since the last frame while time runs; 0: it does not. */
  paced: (ms: number) => void;
}

export function createBeat(acts: BeatActs) {
  let frame = 0;
  let last = 0;
  let dark = false;
  let blinkTimer = 0;
  let blinked = 0; // since something has changed

  function tick(now: number) {
    frame = 0;
    if (acts.runs()) {
      if (last) {
        acts.step(Math.min(LONGEST_STEP, (now - last) / 1000));
        acts.paced(now - last);
      }
      last = now;
    } else stop();
    acts.draw();
    if (acts.runs()) ask();
    else stop();
    blink();
  }
  function stop() {
    if (last) acts.paced(0);
    last = 0;
  }
  function ask() {
    if (acts.runs()) last ||= performance.now(); // the way to the first frame counts as well
    if (!frame) frame = requestAnimationFrame(tick);
  }
  function light() {
    clearTimeout(blinkTimer);
    blinkTimer = 0;
    dark = false;
  }
  function blink() {
    if (!acts.blinks()) light();
    else if (blinked < BLINKS)
      blinkTimer ||= window.setTimeout(() => {
        blinkTimer = 0;
        dark = !dark;
        blinked++;
        ask();
      }, BLINK_MS);
  }
  document.addEventListener("visibilitychange", () => (last = 0)); // an unseen page's time stands still
  return {
    /** Something has changed: shows it in the next frame, the selector lit. */
    draw() {
      light();
      blinked = 0;
      ask();
    },
    isDark: () => dark,
    /** Not empty while a frame is to be drawn: asked for, in time that passes, at the next blink. */
    moving: () => [frame, acts.runs(), blinkTimer].filter(Boolean),
  };
}
