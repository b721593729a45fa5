/** A small choice that outlasts a visit. Browsers may refuse to keep anything: then it is as at first. */
function recall(name: string): string | null {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
}

export const KEYS_KEPT = "raywalk single keys";

/** Keys of one character (letters, digits, signs): people who speak to the computer, or press keys by mistake, turn them off (help.ts). */
export const singleKeys = { on: recall(KEYS_KEPT) !== "off" };
