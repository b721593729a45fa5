/** Small choices that outlast a visit: which tab, what is folded. Browsers may refuse to keep anything. */
export function recall(name: string): string | null {
  try {
    return localStorage.getItem(`raywalk ${name}`);
  } catch {
    return null;
  }
}

const KEYS = "single keys";
let areKeysOn = recall(KEYS) !== "off";

/** Keys of one character (letters, digits, signs): who speaks to the computer, or presses by mistake, turns them off. */
export const singleKeys = {
  on: (): boolean => areKeysOn,
  turn(on: boolean) {
    areKeysOn = on;
    remember(KEYS, on ? "on" : "off");
  },
};

export function remember(name: string, value: string) {
  try {
    localStorage.setItem(`raywalk ${name}`, value);
  } catch {
    // then it is chosen anew next time
  }
}
