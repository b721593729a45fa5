/** What was chosen of each question, as long as the browser's tab is open; nothing of it leaves the device. */
const NAME = "raywalk predictions"; // a kiosk forgets what begins so

type Kept = Record<string, number>; // by scene and step, from 0

function recall(): Kept {
  try {
    const kept: unknown = JSON.parse(sessionStorage.getItem(NAME) ?? "{}");
    return kept && typeof kept === "object" ? (kept as Kept) : {};
  } catch {
    return {};
  }
}

const NONE = -1; // revealed without a choice

export function createPredictions() {
  const kept = recall();
  const key = (scene: string, step: number) => `${scene} ${step}`;
  const first = (scene: string, step: number) => `${key(scene, step)} first`;
  function keep(name: string, choice: number) {
    kept[name] = choice;
    try {
      sessionStorage.setItem(NAME, JSON.stringify(kept));
    } catch {
      // refused: then it is known until the page is left
    }
  }
  return {
    /** undefined: none was made. of: how many choices there are; a new build may have fewer. */
    made(scene: string, step: number, of: number): number | undefined {
      const choice = kept[key(scene, step)];
      return Number.isInteger(choice) && choice >= 0 && choice < of ? choice : undefined;
    },
    make: (scene: string, step: number, choice: number) => keep(key(scene, step), choice),
    /** The answer is shown: what was chosen by now is the first try; another choice, after it, is none. */
    settle(scene: string, step: number) {
      if (kept[first(scene, step)] === undefined) keep(first(scene, step), kept[key(scene, step)] ?? NONE);
    },
    /** The first try, or none though the answer was shown; undefined: it was not. */
    tried: (scene: string, step: number): number | undefined => kept[first(scene, step)],
  };
}

export type Predictions = ReturnType<typeof createPredictions>;
