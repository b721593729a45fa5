/** What is wrong and what still works: a sentence for each subject, with a way on where there is one. */
import { say } from "../words";
import { button, element } from "./element";

/** "act": what the person did last; every other subject has its sentence until it is put right. */
export type Subject = "act" | "address" | "scene" | "trace" | "picture" | "stage" | "error" | `part ${string}`;

export interface Way {
  word: string;
  go: () => void;
}

interface Told {
  sentence: string;
  again: (() => void) | null;
  ways: readonly Way[];
}

/** Of another scene they would no longer be true. */
const OF_A_SCENE: readonly Subject[] = ["act", "address", "scene", "trace", "picture"];

export interface More {
  about?: Subject;
  /** Does what failed once more. */
  again?: () => void;
  ways?: readonly Way[];
}

export function createNotice(root: HTMLElement) {
  const told = new Map<Subject, Told>();
  const text = element("span", "notice-text");
  const ways = element("span", "notice-ways");
  const close = button("\u00d7", say("trouble.close"), () => (told.clear(), show()), { className: "sign quiet" });
  root.replaceChildren(text, ways, close);

  /** Each of these two says that the other works. */
  const areBoth = () => told.has("trace") && told.has("picture");
  function sentences() {
    const others = [...told].filter(([about]) => !areBoth() || (about !== "trace" && about !== "picture")).map(([, { sentence }]) => sentence);
    return [...(areBoth() ? [say("trouble.raysAndPicture")] : []), ...new Set(others)].join(" ");
  }

  function show() {
    const all = [...told.values()];
    root.hidden = !all.length;
    text.textContent = sentences(); // one text: it is read out as a whole
    const isRepeatable = all.some(({ again }) => again);
    const buttons = [...(isRepeatable ? [{ word: say("trouble.again"), go: tryAgain }] : []), ...all.flatMap((each) => each.ways)];
    const once = new Map(buttons.map((each) => [each.word, each]));
    ways.replaceChildren(...[...once.values()].map(({ word, go }) => button(word, word, go)));
  }

  function hide(...about: Subject[]) {
    if (about.map((each) => told.delete(each)).includes(true)) show();
  }

  /** What cannot have changed meanwhile stays said. */
  function tryAgain() {
    const repeatable = [...told].filter(([, { again }]) => again);
    hide(...repeatable.map(([about]) => about));
    for (const [, { again }] of repeatable) again!();
  }

  return {
    say(sentence: string, { about = "act", again, ways: more = [] }: More = {}) {
      told.delete(about);
      told.set(about, { sentence, again: again ?? null, ways: more });
      show();
    },
    hide,
    /** Another scene is shown. */
    leaveScene: () => hide(...OF_A_SCENE),
    tryAgain,
    text: sentences,
  };
}

export type Notice = ReturnType<typeof createNotice>;
