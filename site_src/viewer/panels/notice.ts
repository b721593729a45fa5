/** What is wrong and what still works: a sentence for each subject, with a remedy where there is one. */
import { say } from "../words";
import { button, element } from "../element";

/** "act": what the person did last; every other subject has its sentence until it is put right. */
export type Subject = "act" | "address" | "scene" | "trace" | "picture" | "stage" | "error" | `part ${string}`;

export interface Remedy {
  word: string;
  go: () => void;
}

/** Of another scene they would no longer be true. */
const OF_A_SCENE: readonly Subject[] = ["act", "address", "scene", "trace", "picture"];

export interface More {
  about?: Subject;
  /** Does what failed once more. */
  again?: () => void;
  remedies?: readonly Remedy[];
}

export function createNotice(root: HTMLElement) {
  const messages = new Map<Subject, More & { sentence: string }>();
  const text = element("span", "notice-text");
  const remedies = element("span", "notice-ways");
  const close = button("\u00d7", say("trouble.close"), () => (messages.clear(), show()), { className: "sign quiet" });
  root.replaceChildren(text, remedies, close);

  /** Each of these two says that the other works. */
  const areBoth = () => messages.has("trace") && messages.has("picture");
  function sentences() {
    const others = [...messages].filter(([about]) => !areBoth() || (about !== "trace" && about !== "picture")).map(([, { sentence }]) => sentence);
    return [...(areBoth() ? [say("trouble.raysAndPicture")] : []), ...new Set(others)].join(" ");
  }

  function show() {
    const all = [...messages.values()];
    root.hidden = !all.length;
    text.textContent = sentences(); // one text: it is read out as a whole
    const isRepeatable = all.some(({ again }) => again);
    const buttons = [...(isRepeatable ? [{ word: say("trouble.again"), go: tryAgain }] : []), ...all.flatMap(({ remedies = [] }) => remedies)];
    const once = new Map(buttons.map((each) => [each.word, each]));
    remedies.replaceChildren(...[...once.values()].map(({ word, go }) => button(word, word, go)));
  }

  function hide(...about: Subject[]) {
    if (about.map((each) => messages.delete(each)).includes(true)) show();
  }

  /** What cannot be repeated stays. */
  function tryAgain() {
    const repeatable = [...messages].filter(([, { again }]) => again);
    hide(...repeatable.map(([about]) => about));
    for (const [, { again }] of repeatable) again!();
  }

  return {
    say(sentence: string, more: More = {}) {
      const { about = "act" } = more;
      messages.delete(about);
      messages.set(about, { ...more, sentence });
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
