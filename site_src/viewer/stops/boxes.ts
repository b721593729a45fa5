/** A mesh's boxes as a stop shows them on paper: those that the selected ray tests; where its lesson works out the tree, those of
 *  the level at which it is cut off, of the whole tree those that the ray enters and those that are cut off. */
import { boxEdges, sphereCircles, type Boxes } from "../state/box-lines";
import type { ViewState } from "../state/types";
import type { Vec3 } from "../state/vectors";
import { pixelIndex, wantsBoxes } from "../state/view-state";
import type { SceneData, View, WorkedTree } from "../trace/types";

const DEEPEST = 9; // level: boxes further down are hardly wider than their lines
const [ENTERED, CUT_OFF] = [1, 2]; // of a visit, as trace/mesh_visits.py has them

export interface BoxLine {
  what: "level" | "entered" | "missed" | "cutOff";
  from: Vec3;
  to: Vec3;
}

/** What there is of a scene; null without a mesh, or without a lesson about its tree. */
export interface Drawable {
  boxes: Boxes | null;
  tree: WorkedTree | null;
}

type Segments = readonly (readonly [Vec3, Vec3])[];

const lines = (what: BoxLine["what"], segments: Segments): BoxLine[] => segments.map(([from, to]) => ({ what, from, to }));

const edgesOf = (box: readonly number[]): Segments => boxEdges({ low: [box[0], box[1], box[2]], high: [box[3], box[4], box[5]] });

function asked({ visits, boxes }: WorkedTree, ray: number): BoxLine[] {
  const flat = visits[ray];
  const found = Array.from({ length: flat.length / 3 }, (_, k) => ({ box: boxes[flat[3 * k]], what: flat[3 * k + 1] }));
  const of = (wanted: number) => found.filter(({ box, what }) => what === wanted && box[6] <= DEEPEST).flatMap(({ box }) => edgesOf(box));
  return [...lines("entered", of(ENTERED)), ...lines("cutOff", of(CUT_OFF))];
}

function ofTree(tree: WorkedTree, cut: View["tree_depth"], ray: number): BoxLine[] {
  const [x, y, z, radius] = tree.sphere;
  if (cut === "none") return [];
  if (cut === "sphere") return lines("level", sphereCircles({ centre: [x, y, z], radius }));
  if (cut === "all" || !cut) return asked(tree, ray);
  return lines("level", tree.boxes.filter((box) => box[6] === Number(cut)).flatMap(edgesOf));
}

export function boxesAt(state: ViewState, scene: SceneData, view: View, { boxes, tree }: Drawable): BoxLine[] {
  const ray = pixelIndex(state);
  if (view.works === "tree") return tree ? ofTree(tree, view.tree_depth, ray) : [];
  if (!boxes || !wantsBoxes(state, scene)) return [];
  const { entered, missed } = boxes.of(state.n, ray).lines;
  return [...lines("missed", missed), ...lines("entered", entered)];
}
