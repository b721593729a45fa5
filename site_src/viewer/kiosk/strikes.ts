/** How often the page has recovered from a fault lately: kept for the tab, or in the address where nothing may be kept. */
const KEY = "raywalk.strikes";
const WITH_GL = 3; // recoveries before the stage is drawn flat
const AT_ONCE = 6; // recoveries before they wait
const FORGOTTEN_AFTER = 600_000; // ms without another

export function createStrikes(fromAddress: number) {
  let count = fromAddress;
  let isRefused = false;

  function keep() {
    try {
      sessionStorage.setItem(KEY, String(count));
    } catch {
      isRefused = true;
    }
  }
  try {
    count = Math.max(count, Number(sessionStorage.getItem(KEY)) || 0);
  } catch {
    isRefused = true;
  }
  setTimeout(() => {
    count = 0;
    keep();
  }, FORGOTTEN_AFTER);

  return {
    key: KEY,
    count: () => count,
    add() {
      count++;
      keep();
    },
    /** WebGL has had its chances. */
    isFlat: () => count > WITH_GL,
    /** Nothing helps: the next one takes its time. */
    isHopeless: () => count > AT_ONCE,
    inAddress: () => isRefused && count > 0,
  };
}

export type Strikes = ReturnType<typeof createStrikes>;
