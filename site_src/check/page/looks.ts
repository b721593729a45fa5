/** Which mistakes of the atlas make a picture most like it. */
import { element } from "../../viewer/element";
import { percent, say } from "../../viewer/words";
import type { Answer } from "../recognise";
import type { Found } from "./found";

const mistakes: Record<string, { title: string; url: string }> = JSON.parse(document.getElementById("found")!.dataset.mistakes!);

export function looksLike({ checked: { isRight, answers, isPair }, about: { leftOut } }: Found): HTMLElement | null {
  if (isRight) return null;
  const parts = answers.length
    ? [element("p", "check-notes", say(isPair ? "check.looks.pair" : "check.looks.says")), element("ol", "check-answers", ...answers.map(shown))]
    : [element("p", "check-notes", leftOut ? say(`check.looks.left.${leftOut}`) : say("check.looks.none"))];
  return element("section", "", element("h2", "", say("check.looks.head")), ...parts);
}

function shown({ names, agreement }: Answer): HTMLElement {
  const lines = names.map((name) => {
    const { title, url } = mistakes[name];
    if (!url) return element("h3", "", title);
    const link = element("a", "", title);
    link.href = `${document.body.dataset.root}${url}`;
    return element("h3", "", link);
  });
  return element("li", "", element("span", "check-agree", say("check.looks.agree", { share: percent(agreement) })), ...lines, ...(names.length > 1 ? [element("p", "", say("check.looks.alike"))] : []));
}
