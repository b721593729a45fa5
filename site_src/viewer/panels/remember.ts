/** Small choices that outlast a visit. Browsers may refuse to keep anything. */
function recall(name: string): string | null {
  try {
    return localStorage.getItem(`raywalk ${name}`);
  } catch {
    return null;
  }
}

const KEYS = "single keys";
let areKeysOn = recall(KEYS) !== "off";

/** Keys of one character (letters, digits, signs): people who speak to the computer, or press keys by mistake, turn them off. */
export const singleKeys = {
  on: (): boolean => areKeysOn,
  turn(on: boolean) {
    areKeysOn = on;
    remember(KEYS, on ? "on" : "off");
  },
};

let tellRefused = () => {};
/** act: storage is full or refused, so what was chosen holds until the page is closed. */
export const whenRefused = (act: () => void) => void (tellRefused = act);

function remember(name: string, value: string) {
  try {
    localStorage.setItem(`raywalk ${name}`, value);
  } catch {
    tellRefused();
  }
}
