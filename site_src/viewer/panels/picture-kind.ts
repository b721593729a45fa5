/** How a picture is saved: how many times as large as it is on the page, and whether it has a ground. */
import { button, element, group, pressed } from "../element";
import { say } from "../words";

export interface PictureKind {
  scale: number; // its pixels for each of the page's
  isClear: boolean; // without ground and caption
}

const SCALES = [1, 2, 4];

export function createPictureKind() {
  const kind: PictureKind = { scale: 1, isClear: false };
  const scales = SCALES.map((scale) => button(say("tools.size.scale.word", { times: scale }), say("tools.size.scale.help", { count: scale }), () => choose({ scale })));
  const clear = button(say("tools.size.clear.word"), say("tools.size.clear.help"), () => choose({ isClear: !kind.isClear }));
  function choose(change: Partial<PictureKind>) {
    Object.assign(kind, change);
    for (const [k, each] of scales.entries()) pressed(each, SCALES[k] === kind.scale);
    pressed(clear, kind.isClear);
  }
  choose({});
  return { element: group(say("tools.size.name"), "picture-kind", element("div", "joined", ...scales), clear), kind };
}
