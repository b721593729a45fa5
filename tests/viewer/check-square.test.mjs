/** Which part of a student's picture is held against which right one, and where it is wrong. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./typescript.mjs";

const { apartOf, gridFor, isRefusal, nearestSize, placeAt, sourceFor, squareOf, taken, whereWrong, worstTiles } = await load("../check/main.ts");

const SIZES = { own: [5, 7, 35], others: [10, 64] };
const of = (width, height, value = (x, y) => [x, y, 0]) => ({
  width, height, values: Uint8Array.from(Array.from({ length: width * height }, (_, i) => value(i % width, Math.floor(i / width))).flat()), isLossy: false, hadAlpha: false,
});

test("a square picture is taken whole", () => {
  const picture = of(7, 7);
  assert.deepEqual(squareOf(picture), { picture, isCut: false });
});

test("of a wider one the middle is taken, as high as it is", () => {
  const { picture, isCut } = squareOf(of(13, 7));
  assert.ok(isCut);
  assert.deepEqual([picture.width, picture.height, picture.values.length], [7, 7, 147]);
  assert.deepEqual([...picture.values.subarray(0, 3)], [3, 0, 0], "three columns are left out at each side");
  assert.deepEqual([...picture.values.subarray(-3)], [9, 6, 0]);
});

test("a picture that is higher than wide, or hardly there, is refused in words", () => {
  for (const [picture, word] of [[of(7, 9), "tall"], [of(4, 4), "tiny"], [of(9, 1), "tiny"]]) {
    const refusal = squareOf(picture);
    assert.ok(isRefusal(refusal));
    assert.equal(refusal.word, word);
  }
});

test("a size that the scene's picture has is part of it, another one has its own, any other comes from the finest", () => {
  assert.deepEqual(sourceFor(7, SIZES), { from: 35, isExact: true });
  assert.deepEqual(sourceFor(10, SIZES), { from: 10, isExact: true });
  assert.deepEqual(sourceFor(11, SIZES), { from: 64, isExact: false });
  assert.equal(nearestSize(11, SIZES), 10);
});

test("what is taken of a picture are the pixels at the same centres", () => {
  const part = taken(of(35, 35), 7);
  assert.deepEqual([...part.values.subarray(0, 6)], [2, 2, 0, 7, 2, 0], "of five pixels the third");
});

/** Half of the picture is object 0 in the light, half object 1 in shadow; one row is background. */
const places = of(10, 10, (x, y) => (y === 9 ? [0, 0, 0] : x < 5 ? [1, 2, 0] : [2, 1, 0]));
const right = of(20, 20, () => [100, 100, 100]);

test("places are found at the same share of any picture", () => {
  assert.deepEqual(placeAt(places, 20, 9, 0), { object: 0, bits: 2 });
  assert.deepEqual(placeAt(places, 20, 10, 17), { object: 1, bits: 1 });
  assert.deepEqual(placeAt(places, 20, 10, 18), { object: -1, bits: 0 });
});

test("what is wrong only in shadow is told as that", () => {
  const student = of(20, 20, (x, y) => (x >= 10 && y < 18 ? [140, 100, 100] : [100, 100, 103]));
  const { told, objects } = whereWrong(student, right, places);
  assert.deepEqual(told.map(({ kind, object }) => [kind, object]).sort(), [["object", 1], ["shadow", -1]]);
  assert.deepEqual(told[0], { ...told[0], ofWrong: 1, ofPicture: 0.45 });
  assert.deepEqual(objects[0], { object: 1, wrong: 1, ofWrong: 1 });
});

test("what is wrong everywhere is told of no place", () => {
  assert.deepEqual(whereWrong(of(20, 20, () => [0, 0, 0]), right, places).told, []);
});

test("tiles to walk are of different places first, and some way apart", () => {
  const coarse = of(10, 10, (x, y) => (y > 6 ? [0, 0, 0] : x < 5 ? [1, 2, 0] : [2, 1, 0])); // each larger than what counts as beside an edge
  const tiles = worstTiles(of(30, 30, (x) => (x < 15 ? [200, 100, 100] : [150, 100, 100])), of(30, 30, () => [100, 100, 100]), of(30, 30, () => [100, 100, 100]), of(30, 30, (x, y) => [...coarse.values.subarray(30 * Math.floor(y / 3) + 3 * Math.floor(x / 3)).subarray(0, 3)]), 10, []);
  assert.deepEqual(new Set(tiles.map(({ object }) => object)), new Set([-1, 0, 1]));
  for (const [k, a] of tiles.entries()) for (const b of tiles.slice(0, k)) assert.ok(Math.hypot(a.x - b.x, a.y - b.y) >= 10 / 9);
  assert.deepEqual([tiles[0].own, tiles[0].right], [[200, 100, 100], [100, 100, 100]]);
});

test("tiles to walk lie in the place that is told, and beside an edge only where all that is wrong does", () => {
  const places = of(60, 60, (x) => (x < 30 ? [1, 2, 0] : [2, 1, 0]));
  const right = of(60, 60, (x) => (x < 30 ? [90, 90, 90] : [100, 100, 100]));
  const shadow = { kind: "shadow", object: -1, ofWrong: 0.9, ofPicture: 0.5 };
  const tilesOf = (isWrong, told) => worstTiles(of(60, 60, (x, y) => (isWrong(x, y) ? [200, 0, 0] : [...right.values.subarray(180 * y + 3 * x, 180 * y + 3 * x + 3)])), right, right, places, 20, told);
  assert.ok(tilesOf(() => true, []).some(({ object }) => object === 0));
  const there = tilesOf(() => true, [shadow]);
  assert.ok(there.length > 3 && there.every(({ object, x }) => object === 1 && x > 10), JSON.stringify(there));
  assert.deepEqual([...new Set(tilesOf((x) => x === 28 || x === 31, []).map(({ x }) => x))].sort(), [10, 9].sort(), "where nothing else is wrong");
});

test("the right colour of a tile is its own where no pixel of the picture has its centre, and such tiles hold nearly the same colour", () => {
  const [right, exact] = [of(64, 64, (x) => [x, 0, 0]), of(105, 105, (x, y) => [Math.round((x * 64) / 105), 0, y < 50 ? 2 : 9])];
  const tiles = worstTiles(of(64, 64, () => [200, 0, 0]), right, exact, of(105, 105, () => [1, 2, 0]), 21, []);
  assert.ok(tiles.length > 3);
  for (const { x, y, right: told } of tiles) assert.deepEqual([y < 10, told], [true, [Math.round(((5 * x + 2) * 64) / 105), 0, 2]]);
});

test("the grid is the finest whose tiles have a pixel in their middle, else the finest with as many pixels of which the right colours are there", () => {
  const grids = [5, 7, 11, 15, 21, 33, 55, 77, 105];
  for (const [n, grid] of [[1155, 105], [231, 77], [385, 77], [165, 55], [105, 105], [33, 33]]) assert.deepEqual(gridFor(n, grids), { n: grid, isShared: true }, n);
  for (const [n, grid] of [[512, 105], [400, 105], [100, 21], [6, 5]]) assert.deepEqual(gridFor(n, grids), { n: grid, isShared: false }, n);
});

test("what tells two answers apart is a pixel where their pictures differ and hardly change, and what each has there", () => {
  const n = 70;
  const flat = of(n, n, () => [50, 50, 50]).values;
  const other = of(n, n, (x, y) => (y > 35 && x < 35 ? [90, 50, 50] : x > 50 ? [(x * 97) % 256, 0, 0] : [50, 50, 50])).values; // rough at the right
  const places = of(n, n, () => [1, 2, 0]);
  const found = (answers, isPair = false) => apartOf({ answers, isPair, isRight: false }, (name) => (name === "a" ? flat : other), of(2 * n, 2 * n, () => [51, 50, 50]), of(2 * n, 2 * n), places);
  const two = [{ names: ["a"], agreement: 0.9 }, { names: ["b"], agreement: 0.8 }];
  const { x, y, first, second, own } = found(two);
  assert.ok(x < n && y > n, `${x}, ${y}`);
  assert.deepEqual([first, second, own], [[50, 50, 50], [90, 50, 50], [51, 50, 50]]);
  assert.deepEqual([found(two.slice(1)), found(two, true), found([two[0], two[0]])], [null, null, null], "one answer, a pair, two that look the same");
});
