/** Which mistakes of an atlas does a student's picture look like? One, or two together. */
import { namesLike } from "./alike";
import type { Atlas } from "./atlas";
import type { Picture } from "./formats/picture";
import { agreement, deviationOf, layerOf, meansOf, MOST_OF_BLOCK, MOST_OF_PIXEL, sampled, type Deviation, type Layer } from "./layer";
import { halfAPixelOff, shiftedHalfWay, withoutEdges, withoutTies, wrongPixels } from "./near-edges";
import { agreementOfPair } from "./together";

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
/** But where so few pixels are wrong, noise is much of what is seen: then one that agrees this far, so many times better than any other. */
const [FEW, FAINT, AHEAD] = [0.02, 0.12, 3];
/** Speckles of another size fall elsewhere: half of an agreement is lost, but no other agrees half as far. */
const [SPECKLED, TWICE] = [0.25, 2];
/** A second mistake is named if it leaves less than this share of what the first leaves unexplained. */
const LEFT_BY_SECOND = 0.7;
/** One that leaves less than this is worth a look: it stands behind the first, though not as one of two. */
const LEFT_BY_PERHAPS = 0.995;
/** Where one explains so much no two are told, and from the second figure on none is looked for beside it. */
const [EXPLAINED, WHOLLY] = [0.97, 0.998];
const ANSWERS = 3;
const BLOCK = 7; // pixels along: of the grid's 231, 33 blocks
const PAIRS_LOOKED_AT = 16; // of all, by all pixels

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
type Layered<Of> = { pixels: Of; blocks: Of; middles: Of };

const RIGHT_INDEED: Recognised = { isRight: true, answers: [], isPair: false };

interface Reference {
  name: string;
  family: string;
  picture: Uint8Array;
  on: Layered<Deviation>;
}

interface Scored {
  references: Reference[]; // one or two
  agreement: number;
}

/** An atlas made ready, once a scene. */
export function recogniserOf(atlas: Atlas) {
  const { size } = atlas;
  const right = layered(Float32Array.from(atlas.right), size);
  const along = Math.floor(size / BLOCK);
  const layers = { pixels: layerOf(right.pixels, size, MOST_OF_PIXEL), blocks: layerOf(right.blocks, along, MOST_OF_BLOCK), middles: layerOf(right.middles, along, MOST_OF_PIXEL) };
  const references = atlas.mistakes.flatMap(({ name, family, pictures }) =>
    pictures.map((picture) => ({ name, family, picture, on: deviations(layers, layered(Float32Array.from(picture), size)) }))).filter(({ on }) => on.pixels.sizes.some((of) => of > 0));

  function singlesOf(student: Picture, expected: Picture): { seen: Layered<Deviation>; singles: Scored[] } {
    const onLayers = (picture: Picture) => deviations(layers, layered(asIfOnGrid(picture, expected, layers.pixels), size));
    const seen = onLayers(student);
    const singles = references.map((one) => {
      if (one.name !== SHIFT) return { references: [one], agreement: mean((key) => agreement(layers[key], seen[key], one.on[key])) };
      const own = { ...one, on: onLayers(halfAPixelOff(student, expected)) };
      const usual = onLayers(shiftedHalfWay(expected));
      const share = Math.min(amount(layers.pixels, own.on.pixels) / (LEAST_OF_SHIFT * amount(layers.pixels, usual.pixels)), 1);
      return { references: [{ ...one, on: usual }], agreement: share * mean((key) => agreement(layers[key], seen[key], own.on[key])) };
    });
    return { seen, singles: singles.sort(byAgreement) };
  }

  return {
    /** Both pictures of one size, whichever. isExact: as in isAsRight. */
    recognise(student: Picture, expected: Picture, isExact = true): Recognised {
      const wrong = wrongPixels(student, expected);
      if (areFew(wrong, expected)) return RIGHT_INDEED;
      if (!isExact) return isAsRight(student, expected, false) ? RIGHT_INDEED : this.recognise(withoutEdges(student, expected, wrong), expected);
      let given = withoutTies(student, expected, wrong);
      if (given !== student && areFew(wrongPixels(given, expected), expected)) {
        if (singlesOf(student, expected).singles[0].agreement < SURE) return RIGHT_INDEED;
        given = student;
      }
      const { seen, singles } = singlesOf(given, expected);
      if (student.isLossy && looksPacked(seen.blocks)) return RIGHT_INDEED;
      const pairs = singles[0].agreement < WHOLLY ? pairsOf(layers, singles, seen) : [];
      const isFaint = wrong.length < FEW * expected.width * expected.height;
      return ranked(singles, pairs, isFaint, (reference) => [...new Set([reference.name, ...namesLike(reference.picture, atlas)])]);
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

const layered = (pixels: Float32Array, size: number): Layered<Float32Array> => ({ pixels, blocks: meansOf(pixels, size, BLOCK), middles: sampled(pixels, size, Math.floor(size / BLOCK)) });

const deviations = (layers: Layered<Layer>, of: Layered<Float32Array>): Layered<Deviation> => ({
  pixels: deviationOf(layers.pixels, of.pixels), blocks: deviationOf(layers.blocks, of.blocks), middles: deviationOf(layers.middles, of.middles),
});

function areFew({ length }: number[], { width, height }: Picture): boolean {
  return length < RIGHT * width * height || (length === 1 && width * height >= ONE_MAY_BE_WRONG);
}

/** JPEG moves single pixels, and hardly the mean of a block. */
const looksPacked = ({ sizes }: Deviation) => sizes.filter((size) => size > 0).length < BLOCKS_OF_JPEG * sizes.length;

/** Of a deviation: what counts of it. */
const amount = ({ weights }: Layer, { sizes }: Deviation) => sizes.reduce((sum, size, i) => sum + weights[i] * size, 0);

/** The right picture of the grid with what the student's deviates from that of its own size: sampling at other places adds nothing. */
function asIfOnGrid(student: Picture, expected: Picture, { right, size }: Layer): Float32Array {
  const own = sampled(student.values, student.width, size);
  const of = sampled(expected.values, expected.width, size);
  for (let i = 0; i < own.length; i++) own[i] += right[i] - of[i];
  return own;
}

const mean = (of: (key: "pixels" | "blocks") => number) => (of("pixels") + of("blocks")) / 2;

/** The best pairs of different families: all by blocks and their middles, the best of these by all pixels. */
function pairsOf(layers: Layered<Layer>, singles: Scored[], seen: Layered<Deviation>): Scored[] {
  const known = singles.map(({ references: [one] }) => one);
  const on = (key: keyof Layered<Layer>, a: Reference, b: Reference) => agreementOfPair(layers[key], seen[key], { name: a.name, deviation: a.on[key] }, { name: b.name, deviation: b.on[key] });
  const found: Scored[] = [];
  known.forEach((a, i) => {
    for (const b of known.slice(i + 1)) {
      if (a.family !== b.family) found.push({ references: [a, b], agreement: (on("middles", a, b) + on("blocks", a, b)) / 2 });
    }
  });
  const best = found.sort(byAgreement).slice(0, PAIRS_LOOKED_AT);
  return best.map(({ references: [a, b] }) => ({ references: [a, b], agreement: (on("pixels", a, b) + on("blocks", a, b)) / 2 })).sort(byAgreement);
}

/** One is believed before two: of these the one that explains more comes first. */
function ranked(singles: Scored[], pairs: Scored[], isFaint: boolean, namesOf: (reference: Reference) => string[]): Recognised {
  const [single, pair] = [singles[0], pairs[0]];
  const isPair = !!pair && single.agreement < EXPLAINED && 1 - pair.agreement < LEFT_BY_SECOND * (1 - single.agreement);
  const alone = new Map(singles.map(({ references: [one], agreement }) => [one, agreement]));
  const better = pairs.filter(({ agreement }) => 1 - agreement < (isPair ? 1 : LEFT_BY_PERHAPS) * (1 - single.agreement));
  const ofPairs = better.flatMap(({ references, agreement }) => [...references].sort((a, b) => alone.get(b)! - alone.get(a)!).map((one) => ({ references: [one], agreement })));
  const answers: Answer[] = [];
  const names = namesOf(single.references[0]);
  const next = singles.find(({ references: [one] }) => !names.includes(one.name))?.agreement ?? 0;
  const [least, ahead] = isFaint ? [FAINT, AHEAD] : [SPECKLED, TWICE];
  if (single.agreement < KNOWN && single.agreement >= least && single.agreement > ahead * next) answers.push({ names, agreement: single.agreement });
  for (const { references: [one], agreement } of [...(isPair ? [] : [single]), ...ofPairs, ...singles]) {
    if (answers.length === ANSWERS) break;
    if (agreement < KNOWN) continue;
    if (!answers.some(({ names }) => names.includes(one.name))) answers.push({ names: namesOf(one), agreement });
  }
  return { isRight: false, answers, isPair };
}
