/**
 * Numbers as text, parted by commas, semicolons, tabs or spaces, with decimal points. Three layouts: n lines of 3n numbers (any
 * other height too), lines of x, y, r, g, b with y from the top, n times n lines of r, g, b. A first line of names is passed over.
 */
import { checkSize, PictureFault } from "./fault";
import { MOST_PIXELS_ALONG, pictureOf, type Picture } from "./picture";
import { scaleOf, toShown } from "./scale";

const FORMAT = "text";
const SEPARATORS = [/;/, /,/, /\t/, /\s+/];

interface Table {
  rows: number;
  columns: number;
  numbers: Float32Array; // row by row
  firstLine: number; // in the file, from 1
}

export function readCsv(text: string): Picture {
  const table = tableOf(text);
  const { rows, columns, numbers } = table;
  if (!rows) throw new PictureFault("unknown"); // text without a number
  if (columns === 5) return byPlace(table);
  const isList = columns === 3 && Number.isInteger(Math.sqrt(rows));
  if (columns % 3 || (columns === 3 && !isList)) throw new PictureFault("layout", { rows, columns });
  const width = isList ? Math.sqrt(rows) : columns / 3;
  checkSize(FORMAT, width, isList ? width : rows);
  return pictureOf(width, isList ? width : rows, toShown(numbers, scaleOf(numbers, false)));
}

/** Each line that is not blank, with its number from 1. */
function* linesOf(text: string): Generator<[number, string]> {
  for (let at = 0, line = 1; at < text.length; line++) {
    const end = text.indexOf("\n", at) < 0 ? text.length : text.indexOf("\n", at);
    const content = text.slice(at, end).trim();
    if (content) yield [line, content];
    at = end + 1;
  }
}

const isNumber = (field: string) => field !== "" && Number.isFinite(Number(field));
/** A trailing separator is no number more. */
const parted = (content: string, separator: RegExp) => content.replace(/[;,\t]\s*$/, "").split(separator).map((field) => field.trim());

function tableOf(text: string): Table {
  let separator: RegExp | undefined;
  let [columns, rows, firstLine, filled] = [0, 0, 0, 0];
  let numbers = new Float32Array(1024);
  for (const [line, content] of linesOf(text)) {
    separator ??= SEPARATORS.find((one) => one.test(content)) ?? /,/;
    const fields = parted(content, separator);
    if (!rows && !firstLine && fields.every((field) => !isNumber(field) && /^["']?[A-Za-z_#][\w#." ']*$/.test(field) && !/^(nan|[-+]?inf)/i.test(field))) {
      firstLine = line + 1; // names
      separator = undefined;
      continue;
    }
    if (!rows) [columns, firstLine] = [fields.length, line];
    if (fields.length !== columns) throw new PictureFault("columns", { line, has: fields.length, expected: columns });
    if (columns > 3 * MOST_PIXELS_ALONG) throw new PictureFault("tooLarge", { format: FORMAT, width: columns / 3, height: 1, most: MOST_PIXELS_ALONG });
    if (filled + columns > numbers.length) numbers = grown(numbers, filled + columns);
    for (const field of fields) {
      if (!isNumber(field)) throw new PictureFault("notANumber", { line, text: field.slice(0, 40) });
      numbers[filled++] = Number(field);
    }
    rows++;
  }
  if (!rows) throw new PictureFault("layout", { rows, columns });
  return { rows, columns, numbers: numbers.subarray(0, filled), firstLine };
}

function grown(numbers: Float32Array<ArrayBuffer>, least: number): Float32Array<ArrayBuffer> {
  const most = 5 * MOST_PIXELS_ALONG ** 2;
  if (least > most) throw new PictureFault("tooLarge", { format: FORMAT, width: Math.ceil(Math.sqrt(least / 3)), height: Math.ceil(Math.sqrt(least / 3)), most: MOST_PIXELS_ALONG });
  const larger = new Float32Array(Math.min(Math.max(2 * numbers.length, least), most));
  larger.set(numbers);
  return larger;
}

function byPlace(table: Table): Picture {
  const { rows, numbers } = table;
  const { width, height } = extentOf(table);
  checkSize(FORMAT, width, height);
  const values = new Float32Array(3 * width * height);
  const isGiven = new Uint8Array(width * height);
  for (let row = 0; row < rows; row++) {
    const [x, y] = [numbers[5 * row], numbers[5 * row + 1]];
    const pixel = y * width + x;
    if (isGiven[pixel]) throw new PictureFault("pixelTwice", { line: table.firstLine + row, x, y });
    isGiven[pixel] = 1;
    values.set(numbers.subarray(5 * row + 2, 5 * row + 5), 3 * pixel);
  }
  const gap = isGiven.indexOf(0);
  if (gap >= 0) throw new PictureFault("pixelMissing", { x: gap % width, y: Math.floor(gap / width), has: rows, expected: width * height });
  return pictureOf(width, height, toShown(values, scaleOf(values, false)));
}

/** One more than the largest x and y. */
function extentOf({ rows, numbers, firstLine }: Table): { width: number; height: number } {
  let [width, height] = [0, 0];
  for (let row = 0; row < rows; row++) {
    const [x, y] = [numbers[5 * row], numbers[5 * row + 1]];
    const isPlace = Number.isInteger(x) && Number.isInteger(y) && Math.min(x, y) >= 0 && Math.max(x, y) < MOST_PIXELS_ALONG;
    if (!isPlace) throw new PictureFault("pixelPlace", { line: firstLine + row, x, y, most: MOST_PIXELS_ALONG });
    [width, height] = [Math.max(width, x + 1), Math.max(height, y + 1)];
  }
  return { width, height };
}
