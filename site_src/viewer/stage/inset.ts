/** In which corner of the stage the picture stands, where there is no room beside it: in one where it covers no lamp and no ray of
 *  the selected pixel, small if need be. It stays where it is while that is free. */
import { linesOf } from "../state/lines";
import { pixelIndex } from "../state/view-state";
import { clearOf } from "./clear";
import { isStruck } from "./labels";
import type { Box } from "../state/outlines";
import type { Drawn } from "./renderer";

const SMALL = 84; // CSS pixels; as the style sheet has it
const EDGE = 8; // to the stage's edge
const LAMP = 14; // half a lamp's sign

interface Place {
  isLeft: boolean;
  isLow: boolean;
  isSmall: boolean;
}
const CORNERS = [false, true].flatMap((isLow) => [false, true].map((isLeft) => ({ isLeft, isLow })));
const PLACES: readonly Place[] = [false, true].flatMap((isSmall) => CORNERS.map((corner) => ({ ...corner, isSmall })));

/** changed: the picture stands elsewhere. */
export function createInset(picture: HTMLElement, changed: () => void) {
  let now = PLACES[0];
  let full = SMALL; // its size where it is not small
  function boxOf({ isLeft, isLow, isSmall }: Place, width: number, height: number): Box {
    const side = EDGE + (isSmall ? SMALL : full);
    return { left: isLeft ? 0 : width - side, right: isLeft ? side : width, top: isLow ? height - side : 0, bottom: isLow ? height : side };
  }
  return {
    show(drawn: Drawn | null) {
      if (!drawn?.view.trace || drawn.view.state.tiles === "filling") return;
      const { view, projection } = drawn;
      const { width, height } = projection;
      if (!now.isSmall) full = picture.offsetWidth;
      // All of the pixel's rays, also while the player has not come to some of them; lamps are where a stop has them.
      const { lights, asked = lights } = view.switched;
      const { strokes } = clearOf({ ...drawn, view: { ...view, chosen: linesOf(view.trace!, { ...view.scene, lights: asked }, pixelIndex(view.state)) } }, []);
      const lamps = lights.map(({ position }) => projection.project(position)).filter(({ depth }) => depth > 0);
      const isFree = (place: Place) => {
        const { left, right, top, bottom } = boxOf(place, width, height);
        return !isStruck({ left, right, top, bottom }, strokes) && !lamps.some(({ x, y }) => x > left - LAMP && x < right + LAMP && y > top - LAMP && y < bottom + LAMP);
      };
      const next = isFree(now) && !(now.isSmall && isFree({ ...now, isSmall: false })) ? now : PLACES.find(isFree);
      if (!next || next === now) return;
      now = next;
      picture.classList.toggle("at-left", now.isLeft);
      picture.classList.toggle("at-foot", now.isLow);
      picture.classList.toggle("small", now.isSmall);
      changed();
    },
  };
}
