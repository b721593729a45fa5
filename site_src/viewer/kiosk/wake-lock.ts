/** Asks that the screen stays on; browsers let go of it whenever the page is hidden. */
export function keepAwake() {
  let held: WakeLockSentinel | null = null;

  async function ask() {
    if (document.visibilityState !== "visible" || (held && !held.released)) return;
    try {
      held = (await navigator.wakeLock?.request("screen")) ?? null;
    } catch {
      held = null; // refused, for instance on a low battery; asked again when the page shows again
    }
  }
  document.addEventListener("visibilitychange", ask);
  void ask();
  return { isHeld: () => !!held && !held.released };
}
