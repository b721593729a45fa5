/** Which mistakes of an atlas does a student's picture look like? One, or two together. */
import { namesLike } from "./alike";
import type { Atlas, Factors } from "./atlas";
import { agreement, deviationOf, seenOf, type Deviation, type Seen } from "./deviation";
import type { Picture } from "./formats/picture";
import { layerOf, meansOf, MOST_OF_BLOCK, MOST_OF_PIXEL, NOISE, sampled, type Layer } from "./layer";
import { shifted, withoutEdges, withoutTies, wrongPixels } from "./near-edges";
import { agreementWith, aloneOf, type Alone } from "./together";
import { undoOf, type Undo } from "./undone";

/** Pixels further than NOISE from the right picture in a right one: float32 moves two in 10,000, the least mistake 27. */
const RIGHT = 0.001;
/** The same where the right picture only stands in for one of the size: what is behind glass changes within a pixel. */
const NEARLY_RIGHT = 0.01;
/** Blocks whose mean JPEG moves further than NOISE: fewer than this share. */
const BLOCKS_OF_JPEG = 0.005;
/** Among so many pixels a single one may hang on a rounding. */
const ONE_MAY_BE_WRONG = 200;
/** Of mistakes.json: the one that deviates the less the finer a picture is. */
const SHIFT = "pixel-corner";
/** A shift deviates at all edges: by what it explains, at least this share of what a picture half way between shifted ones does. */
const LEAST_OF_SHIFT = 0.4;
/** Few pixels beside edges that look so much like a mistake are one, and no ties. */
const SURE = 0.8;
/** What agrees less is none that we know. */
const KNOWN = 0.5;
/** But where so few pixels are wrong, noise is much of what is seen: one that agrees this far will do, so many times better than any other. */
const [FEW, FAINT, AHEAD] = [0.02, 0.12, 3];
/** Speckles of another size fall elsewhere: three quarters of an agreement may be lost, but no other agrees nearly as far. The more
 *  is left of it, the less far ahead it need be. */
const SPECKLED = [[0.2, 1.75], [0.35, 1.5]];
/** A second mistake is named if it leaves less than this share of what the first leaves unexplained. */
const LEFT_BY_SECOND = 0.7;
/** One that leaves less than this is worth a look: it stands behind the first, though not as one of two. */
const LEFT_BY_PERHAPS = 0.995;
/** Where one explains so much no two are told, and from the second figure on none is looked for beside it. */
const [EXPLAINED, WHOLLY] = [0.97, 0.998];
/** What is left once one is undone is a second mistake if it agrees this far: another gamma than ours leaves something, too. */
const LEFT_IS_KNOWN = 0.75;
const ANSWERS = 3;
const BLOCK = 7; // pixels along: of the grid's 231, 33 blocks
const [SINGLES_LOOKED_AT, PAIRS_LOOKED_AT] = [16, 16]; // of all, by all pixels

export interface Answer {
  names: string[]; // one, or those whose pictures are alike in this scene
  agreement: number; // 0 to 1
}

export interface Recognised {
  isRight: boolean;
  answers: Answer[]; // best first, three at most; none: no mistake that we know
  isPair: boolean; // the first two together look more like it than any alone
}

/** A picture on all layers: every pixel of the grid, means of blocks, and the pixels in the middle of blocks. */
type Layered<Of, Pixels = Of> = { pixels: Pixels; blocks: Of; middles: Of };
/** Red, green, blue, row by row. */
type Colours = Float32Array | Uint8Array;

const RIGHT_INDEED: Recognised = { isRight: true, answers: [], isPair: false };

interface Reference {
  name: string;
  family: string;
  picture: Uint8Array;
  drawnIn?: Factors;
  on: Layered<Deviation>; // by pixels when first asked for: of most mistakes nobody asks
}

interface Scored {
  references: Reference[]; // one or two
  agreement: number;
}

/** An atlas made ready, once a scene. */
export function recogniserOf(atlas: Atlas) {
  const { size } = atlas;
  const right = layered(new Float32Array(atlas.right), size);
  const along = Math.floor(size / BLOCK);
  const layers = { pixels: layerOf(right.pixels, size, MOST_OF_PIXEL), blocks: layerOf(right.blocks, along, MOST_OF_BLOCK), middles: layerOf(right.middles, along, MOST_OF_PIXEL) };
  const references = atlas.mistakes.flatMap(({ pictures, ...each }) => pictures.filter((picture) => differs(picture, atlas.right)).map((picture): Reference => {
    let pixels: Deviation | null = null;
    const { blocks, middles } = layered(new Float32Array(picture), size);
    const on = { blocks: deviationOf(layers.blocks, blocks), middles: deviationOf(layers.middles, middles), get pixels() { return (pixels ??= deviationOf(layers.pixels, new Float32Array(picture))); } };
    return { ...each, picture, on };
  }));

  function singlesOf(student: Picture, expected: Picture): { seen: Layered<Seen>; singles: Scored[] } {
    const of = sampled(expected.values, expected.width, size);
    const onGrid = (own: Float32Array) => layered(asIfOnGrid(own, of, layers.pixels), size);
    const seen = onLayers(seenOf, layers, onGrid(sampled(student.values, student.width, size)));
    const held = (one: Reference, key: keyof Layered<Layer>, on = one.on) => agreement(layers[key], seen[key], on[key]);
    const singles = references.map((one): Scored => {
      if (one.name !== SHIFT) return { references: [one], agreement: (held(one, "middles") + held(one, "blocks")) / 2 };
      const { nearest, halfWay } = shifted(student, expected, size);
      const [own, usual] = [nearest, halfWay].map((picture) => onLayers(deviationOf, layers, onGrid(picture)));
      const share = Math.min(own.pixels.amount / (LEAST_OF_SHIFT * usual.pixels.amount), 1);
      return { references: [{ ...one, on: usual }], agreement: (share * (held(one, "pixels", own) + held(one, "blocks", own))) / 2 };
    }).sort(byAgreement);
    for (const single of singles.slice(0, SINGLES_LOOKED_AT)) {
      const [one] = single.references;
      if (one.name !== SHIFT) single.agreement = (held(one, "pixels") + held(one, "blocks")) / 2;
    }
    return { seen, singles: singles.sort(byAgreement) };
  }

  const undoes = new Map<string, Undo | null>(); // when first asked for
  function undo(one: Reference): Undo | null {
    if (!undoes.has(one.name)) undoes.set(one.name, undoOf(one, atlas.right, size));
    return undoes.get(one.name)!;
  }

  /** A mistake that acts on a whole picture, and what deviates once that is undone; null if nothing does that we know. */
  function besideUndone(whole: Reference, undoing: Undo, student: Picture, expected: Picture): Scored | null {
    const onGrid = { ...expected, width: size, height: size, values: sampled(expected.values, expected.width, size) };
    const undone = { ...onGrid, values: undoing(sampled(student.values, student.width, size), size) };
    const left = (whole.drawnIn ? withoutEdges : withoutTies)(undone, onGrid, wrongPixels(undone, onGrid));
    const wrong = wrongPixels(left, onGrid);
    if (areFew(wrong, onGrid) || (whole.drawnIn && wrong.length < NEARLY_RIGHT * size * size)) return null;
    const { seen, singles } = singlesOf(left, onGrid);
    if (student.isLossy && looksPacked(seen.blocks)) return null;
    const second = singles.find(({ references: [one] }) => one.family !== whole.family);
    return second && second.agreement >= LEFT_IS_KNOWN ? { references: [whole, ...second.references], agreement: second.agreement } : null;
  }

  /** The same of the one to undo: the first that is named, or else that which leaves most of a likeness, by blocks. */
  function undonePair(student: Picture, expected: Picture, { references: [first], agreement: most }: Scored): Scored | null {
    const undoing = undo(first);
    if (undoing) return most >= KNOWN ? besideUndone(first, undoing, student, expected) : null;
    if (most >= EXPLAINED) return null;
    const [own, of] = [student, expected].map(({ values, width }) => sampled(values, width, size));
    const likeness = (whole: Reference, undoing: Undo) => {
      const left = undoing(own, size);
      for (let i = 0; i < left.length; i++) left[i] += layers.pixels.right[i] - of[i];
      const seen = seenOf(layers.blocks, meansOf(left, size, BLOCK));
      return Math.max(...references.map((one) => (one.family === whole.family ? 0 : agreement(layers.blocks, seen, one.on.blocks))));
    };
    const wholes = references.flatMap((whole) => {
      const undoing = undo(whole);
      return undoing ? [{ whole, undoing, agreement: likeness(whole, undoing) }] : [];
    });
    const [best] = wholes.sort(byAgreement);
    return best?.agreement > most ? besideUndone(best.whole, best.undoing, student, expected) : null;
  }

  /** mayUndo: not where the right picture only stands in for one of the size, as all edges would be left. */
  function named(student: Picture, expected: Picture, mayUndo: boolean): Recognised {
    const wrong = wrongPixels(student, expected);
    if (areFew(wrong, expected)) return RIGHT_INDEED;
    let given = withoutTies(student, expected, wrong);
    if (given !== student && areFew(wrongPixels(given, expected), expected)) {
      if (singlesOf(student, expected).singles[0].agreement < SURE) return RIGHT_INDEED;
      given = student;
    }
    const { seen, singles } = singlesOf(given, expected);
    if (student.isLossy && looksPacked(seen.blocks)) return RIGHT_INDEED;
    const undone = mayUndo ? undonePair(student, expected, singles[0]) : null;
    const pairs = singles[0].agreement < WHOLLY ? pairsOf(layers, singles, seen) : [];
    const isFaint = wrong.length < FEW * expected.width * expected.height;
    return ranked(singles, pairs, undone, isFaint, (reference) => [...new Set([reference.name, ...namesLike(reference.picture, atlas)])]);
  }

  return {
    right: atlas.right,
    /** What a mistake makes of the scene, size x size. */
    pictureOf: (name: string): Uint8Array | null => references.find((one) => one.name === name)?.picture ?? null,
    /** Both pictures of one size, whichever. isExact: as in isAsRight. */
    recognise(student: Picture, expected: Picture, isExact = true): Recognised {
      if (isExact) return named(student, expected, true);
      if (isAsRight(student, expected, false)) return RIGHT_INDEED;
      return named(withoutEdges(student, expected, wrongPixels(student, expected)), expected, false);
    },
  };
}

/** Whether a picture is the right one, of a scene that has no atlas. isExact: false if expected only stands in for a size that
 *  there is no right picture of. */
export function isAsRight(student: Picture, expected: Picture, isExact = true): boolean {
  const wrong = wrongPixels(student, expected);
  if (areFew(wrong, expected)) return true;
  if (!isExact) return wrongPixels(withoutEdges(student, expected, wrong), expected).length < NEARLY_RIGHT * expected.width * expected.height;
  const settled = withoutTies(student, expected, wrong);
  return settled !== student && areFew(wrongPixels(settled, expected), expected);
}

const byAgreement = (a: { agreement: number }, b: { agreement: number }) => b.agreement - a.agreement;

const layered = <P extends Colours>(pixels: P, size: number): Layered<Float32Array, P> => ({ pixels, blocks: meansOf(pixels, size, BLOCK), middles: sampled(pixels, size, Math.floor(size / BLOCK)) });

const onLayers = <D>(deviation: (layer: Layer, of: Colours) => D, layers: Layered<Layer>, of: Layered<Colours>): Layered<D> => ({
  pixels: deviation(layers.pixels, of.pixels), blocks: deviation(layers.blocks, of.blocks), middles: deviation(layers.middles, of.middles),
});

function areFew({ length }: Int32Array, { width, height }: Picture): boolean {
  return length < RIGHT * width * height || (length === 1 && width * height >= ONE_MAY_BE_WRONG);
}

/** JPEG moves single pixels, and hardly the mean of a block. */
const looksPacked = ({ sizes }: Seen) => sizes.filter((size) => size > 0).length < BLOCKS_OF_JPEG * sizes.length;

/** The right picture of the grid with what the student's deviates from that of its own size: sampling at other places adds nothing.
 *  In place. */
function asIfOnGrid(own: Float32Array, of: Float32Array, { right }: Layer): Float32Array {
  for (let i = 0; i < own.length; i++) own[i] += right[i] - of[i];
  return own;
}

/** In more than noise. */
function differs(a: Uint8Array, b: Uint8Array): boolean {
  for (let i = 0; i < a.length; i++) if (Math.abs(a[i] - b[i]) > NOISE) return true;
  return false;
}

/** The best pairs of different families, one of the two looked at by itself: by blocks and their middles, the best of these by all pixels. */
function pairsOf(layers: Layered<Layer>, singles: Scored[], seen: Layered<Seen>): Scored[] {
  const known = singles.map(({ references: [one] }) => one);
  const kept = { pixels: new Map<Reference, Alone>(), blocks: new Map<Reference, Alone>(), middles: new Map<Reference, Alone>() };
  const alone = (key: keyof Layered<Layer>, one: Reference) => {
    const made = kept[key].get(one) ?? aloneOf(layers[key], seen[key], one.name, one.on[key]);
    kept[key].set(one, made);
    return made;
  };
  const beside = (key: keyof Layered<Layer>, a: Reference) => {
    const agreementOf = agreementWith(layers[key], seen[key], alone(key, a));
    return (b: Reference) => agreementOf(alone(key, b));
  };
  const best: (Scored & { ofBlocks: number })[] = []; // so far, PAIRS_LOOKED_AT at most
  known.slice(0, SINGLES_LOOKED_AT).forEach((a, i) => {
    const [byMiddles, byBlocks] = [beside("middles", a), beside("blocks", a)];
    for (const b of known.slice(i + 1)) {
      if (a.family === b.family) continue;
      const least = best.length < PAIRS_LOOKED_AT ? 0 : best[PAIRS_LOOKED_AT - 1].agreement;
      const ofMiddles = byMiddles(b);
      if ((ofMiddles + 1) / 2 < least) continue; // even with blocks that agree wholly
      const ofBlocks = byBlocks(b);
      insert(best, { references: [a, b], agreement: (ofMiddles + ofBlocks) / 2, ofBlocks });
    }
  });
  return best.map(({ references: [a, b], ofBlocks }) => ({ references: [a, b], agreement: (beside("pixels", a)(b) + ofBlocks) / 2 })).sort(byAgreement);
}

/** Where it belongs among the best so far, behind equals; the last one goes when they are too many. */
function insert<S extends Scored>(best: S[], one: S): void {
  const at = best.findIndex(({ agreement }) => agreement < one.agreement);
  best.splice(at < 0 ? best.length : at, 0, one);
  if (best.length > PAIRS_LOOKED_AT) best.pop();
}

/** One is believed before two: of these the one that explains more comes first. undone: two that are, as one was undone. */
function ranked(singles: Scored[], added: Scored[], undone: Scored | null, isFaint: boolean, namesOf: (reference: Reference) => string[]): Recognised {
  const [single] = singles;
  const isSure = undone?.references[0] === single.references[0];
  const pairs = undone && (isSure || undone.agreement > (added[0]?.agreement ?? 0)) ? [undone, ...added] : added;
  const [pair] = pairs;
  const isPair = isSure || (!!pair && single.agreement < EXPLAINED && 1 - pair.agreement < LEFT_BY_SECOND * (1 - single.agreement));
  const alone = new Map(singles.map(({ references: [one], agreement }) => [one, agreement]));
  const better = pairs.filter((each) => each === undone || 1 - each.agreement < (isPair ? 1 : LEFT_BY_PERHAPS) * (1 - single.agreement));
  const ofPairs = better.flatMap(({ references, agreement }) => [...references].sort((a, b) => alone.get(b)! - alone.get(a)!).map((one) => ({ references: [one], agreement })));
  const answers: Answer[] = [];
  const names = namesOf(single.references[0]);
  const next = singles.find(({ references: [one] }) => !names.includes(one.name))?.agreement ?? 0;
  const standsOut = (least: number, ahead: number) => single.agreement >= least && single.agreement > ahead * next;
  if (!isPair && single.agreement < KNOWN && (SPECKLED.some(([least, ahead]) => standsOut(least, ahead)) || (isFaint && standsOut(FAINT, AHEAD)))) answers.push({ names, agreement: single.agreement });
  for (const { references: [one], agreement } of [...(isPair ? [] : [single]), ...ofPairs, ...singles]) {
    if (answers.length === ANSWERS) break;
    if (agreement < KNOWN) continue;
    if (!answers.some(({ names }) => names.includes(one.name))) answers.push({ names: namesOf(one), agreement });
  }
  return { isRight: false, answers, isPair };
}
