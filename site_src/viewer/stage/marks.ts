/** What a lesson's step points at: a ring round it and its name on the stage; and on which side of its thing a name stands. */
import { element } from "../element";
import { ringsOf } from "../state/rings";
import { stopOf } from "../state/view-state";
import type { View } from "../trace/types";
import type { Label } from "./labels";
import type { Drawn } from "./renderer";

const NEAR = 1 / 300; // of the scene's radius: what is nearer to the observer is not ringed
const SIDES = { left: [-1, 0], right: [1, 0], above: [0, -1], below: [0, 1] } as const;

/** As a step names what has this label: an area light's points are one lamp. */
const nameOf = ({ key }: Label) => key.replace(/^(light|ring) /, "").replace(/ \d+\/\d+$/, "");

export function createMarks() {
  const root = element("div", "rings");
  root.setAttribute("aria-hidden", "true"); // the step says in words what they are round
  return {
    element: root,
    /** labels: the most important first; told their sides. Gives those of rings, too. */
    show({ view: { scene, state }, projection }: Drawn, labels: readonly Label[]): Label[] {
      const view: View = stopOf(scene, state)?.view ?? {};
      const rings = ringsOf(view, scene, projection, NEAR * scene.bounds.radius);
      while (root.children.length > rings.length) root.lastElementChild!.remove();
      while (root.children.length < rings.length) root.append(element("div"));
      rings.forEach(({ left, right, top, bottom, isRound }, k) => {
        const ring = root.children[k] as HTMLElement;
        ring.classList.toggle("round", isRound);
        Object.assign(ring.style, { left: `${left}px`, top: `${top}px`, width: `${right - left}px`, height: `${bottom - top}px` });
      });
      const named = rings.filter(({ isLamp }) => !isLamp).map(({ name, left, right, top }): Label => ({ key: `ring ${name}`, text: name, x: (left + right) / 2, y: top, kind: "sign", side: SIDES.above }));
      return [...named, ...labels].map((label) => {
        const side = view.labels?.[nameOf(label)];
        return side ? { ...label, side: SIDES[side] } : label;
      });
    },
  };
}
