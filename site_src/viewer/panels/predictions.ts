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

export function createPredictions() {
  const kept = recall();
  const key = (scene: string, step: number) => `${scene} ${step}`;
  return {
    /** undefined: none was made. of: how many choices there are; a new build may have fewer. */
    made(scene: string, step: number, of: number): number | undefined {
      const choice = kept[key(scene, step)];
      return Number.isInteger(choice) && choice >= 0 && choice < of ? choice : undefined;
    },
    make(scene: string, step: number, choice: number) {
      kept[key(scene, step)] = choice;
      try {
        sessionStorage.setItem(NAME, JSON.stringify(kept));
      } catch {
        // refused: then it is known until the page is left
      }
    },
  };
}

export type Predictions = ReturnType<typeof createPredictions>;
