/** Files of one picture in every format that the page of checks reads, and hostile ones; written here, by the formats' documents. */
import { deflateSync, gzipSync } from "node:zlib";
import jpeg from "jpeg-js";
import { PNG } from "pngjs";

export const WIDTH = 7;
export const HEIGHT = 5;
/** No two pixels and no two colours of one are equal. */
export const BYTES = Uint8Array.from({ length: 3 * WIDTH * HEIGHT }, (_, i) => (37 * i + 11) % 256);
export const GREYS = Uint8Array.from({ length: WIDTH * HEIGHT }, (_, i) => (7 * i + 3) % 256);
export const GREY_BYTES = Uint8Array.from({ length: 3 * WIDTH * HEIGHT }, (_, i) => GREYS[Math.floor(i / 3)]);

export const text = (string) => new TextEncoder().encode(string);
export const joined = (...parts) => new Uint8Array(Buffer.concat(parts.map((part) => (typeof part === "string" ? Buffer.from(part, "latin1") : Buffer.from(part)))));
const little = (...numbers) => joined(...numbers.map(([value, size]) => Uint8Array.from({ length: size }, (_, i) => Math.floor((value < 0 ? value + 2 ** 32 : value) / 256 ** i) % 256)));
const eachRow = (rows) => Array.from({ length: HEIGHT }, (_, y) => rows(y));
const colour = (x, y) => [...BYTES.subarray(3 * (y * WIDTH + x), 3 * (y * WIDTH + x) + 3)];
const grid = () => eachRow((y) => Array.from({ length: WIDTH }, (_, x) => colour(x, y)));

// PNG: chunks by hand, so that they can be wrong

const CRC = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; k++) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n >>> 0;
});
const crc = (bytes) => (bytes.reduce((sum, byte) => CRC[(sum ^ byte) & 255] ^ (sum >>> 8), 0xffffffff) ^ 0xffffffff) >>> 0;
const big = (value) => Uint8Array.from([24, 16, 8, 0], (shift) => (value >>> shift) & 255);
export const chunk = (type, data, sum = crc(joined(type, data))) => joined(big(data.length), type, data, big(sum));
export const header = (width, height, depth, kind, interlace = 0) => chunk("IHDR", joined(big(width), big(height), [depth, kind, 0, 0, interlace]));
export const png = (...chunks) => joined("\x89PNG\r\n\x1a\n", ...chunks, chunk("IEND", []));
export const pixels = (raw) => chunk("IDAT", deflateSync(Buffer.from(raw)));
const rowsOf = (row) => joined(...eachRow((y) => joined([0], row(y))));
const rgbRow = (y) => BYTES.subarray(3 * WIDTH * y, 3 * WIDTH * (y + 1));
const PASSES = [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]];
const interlaced = PASSES.flatMap(([x0, y0, dx, dy]) => {
  const rows = [];
  for (let y = y0; y < HEIGHT; y += dy) {
    const row = [];
    for (let x = x0; x < WIDTH; x += dx) row.push(...colour(x, y));
    if (row.length) rows.push(0, ...row);
  }
  return rows;
});
const bits = (row, depth) => Uint8Array.from({ length: Math.ceil((WIDTH * depth) / 8) }, (_, i) => {
  let byte = 0;
  for (let k = 0; k < 8 / depth; k++) byte = (byte << depth) | (row[(i * 8) / depth + k] ?? 0);
  return byte;
});
const library = (options, channels) => {
  const picture = new PNG({ width: WIDTH, height: HEIGHT });
  for (let i = 0; i < WIDTH * HEIGHT; i++) picture.data.set([...BYTES.subarray(3 * i, 3 * i + 3), channels === 4 ? 9 : 255], 4 * i);
  return new Uint8Array(PNG.sync.write(picture, options));
};
const palette = joined(...Array.from({ length: WIDTH * HEIGHT }, (_, i) => BYTES.subarray(3 * i, 3 * i + 3)));

// BMP, TGA, PFM, numbers

const bgr = (x, y) => colour(x, y).reverse();
function bmp({ bits: depth = 24, topDown = false, headerLength = 40, compression = 0, width = WIDTH, height = HEIGHT, masks = [], pixel = bgr }) {
  const rows = eachRow((y) => {
    const row = joined(...Array.from({ length: WIDTH }, (_, x) => pixel(x, y)));
    return joined(row, new Uint8Array((4 - (row.length % 4)) % 4));
  });
  const extra = headerLength === 40 ? masks : [];
  const core = headerLength === 12 ? little([12, 4], [width, 2], [height, 2], [1, 2], [depth, 2])
    : joined(little([headerLength, 4], [width, 4], [topDown ? -height : height, 4], [1, 2], [depth, 2], [compression, 4], [0, 4], [0, 4], [0, 4], [0, 4], [0, 4]), headerLength > 40 ? joined(...masks, new Uint8Array(headerLength - 40 - 4 * masks.length)) : "");
  const start = 14 + core.length + 4 * extra.length;
  return joined("BM", little([0, 4], [0, 4], [start, 4]), core, ...extra, ...(topDown ? rows : rows.reverse()));
}
const MASKS = [0xff, 0xff00, 0xff0000].map((mask) => little([mask, 4])); // red first in memory
const rgbx = (x, y) => [...colour(x, y), 0];

const tgaHeader = (type, depth, descriptor, width = WIDTH, height = HEIGHT, id = 0) => joined([id, 0, type, 0, 0, 0, 0, 0], little([0, 2], [0, 2], [width, 2], [height, 2]), [depth, descriptor]);
const bottomUp = (row) => joined(...eachRow(row).reverse());
const tgaRow = (y) => joined(...grid()[y].map((pixel) => pixel.slice().reverse()));
const packed = (y) => joined(...Array.from({ length: WIDTH }, (_, x) => joined([x % 2 ? 0 : 128], bgr(x, y)))); // runs and pixels of one

function pfm(kind, isLittle, values = BYTES, divisor = 255) {
  const channels = kind === "PF" ? 3 : 1;
  const view = new DataView(new ArrayBuffer(4 * WIDTH * HEIGHT * channels));
  for (let y = 0; y < HEIGHT; y++) for (let i = 0; i < WIDTH * channels; i++) view.setFloat32(4 * ((HEIGHT - 1 - y) * WIDTH * channels + i), values[y * WIDTH * channels + i] / divisor, isLittle);
  return joined(`${kind}\n${WIDTH} ${HEIGHT}\n${isLittle ? "-1.0" : "1.0"}\n`, new Uint8Array(view.buffer));
}
const places = (separator) => eachRow((y) => Array.from({ length: WIDTH }, (_, x) => [x, y, ...colour(x, y)].join(separator)).join("\n")).join("\n");
const lines = (separator, of = (value) => value) => eachRow((y) => [...rgbRow(y)].map(of).join(separator)).join("\n");

/** name, bytes, and what differs from the picture of BYTES: grey, within (steps), alpha, lossy. */
export const GOOD = [
  ["PNG of 8 bits", library({ colorType: 2 })],
  ["PNG with alpha, which is left out", library({ colorType: 6 }, 4), { alpha: true }],
  ["PNG of 16 bits", png(header(WIDTH, HEIGHT, 16, 2), pixels(rowsOf((y) => [...rgbRow(y)].flatMap((byte) => [byte, byte]))))],
  ["PNG of greys", png(header(WIDTH, HEIGHT, 8, 0), pixels(rowsOf((y) => GREYS.subarray(WIDTH * y, WIDTH * (y + 1))))), { grey: true }],
  ["PNG of greys of 4 bits", png(header(WIDTH, HEIGHT, 4, 0), pixels(rowsOf((y) => bits([...GREYS.subarray(WIDTH * y, WIDTH * (y + 1))].map((grey) => Math.round(grey / 17)), 4)))), { grey: true, within: 8.5 }],
  ["PNG with a palette", png(header(WIDTH, HEIGHT, 8, 3), chunk("PLTE", palette), pixels(rowsOf((y) => Array.from({ length: WIDTH }, (_, x) => y * WIDTH + x))))],
  ["PNG, interlaced", png(header(WIDTH, HEIGHT, 8, 2, 1), pixels(interlaced))],
  ["PNG in two IDAT chunks", png(header(WIDTH, HEIGHT, 8, 2), ...[0, 30].map((at, k, all) => chunk("IDAT", deflateSync(Buffer.from(rowsOf(rgbRow))).subarray(at, all[k + 1]))))],
  ["JPEG", new Uint8Array(jpeg.encode({ width: WIDTH, height: HEIGHT, data: Buffer.from(Array.from({ length: WIDTH * HEIGHT }, (_, i) => [90 + i, 90 + i, 90 + i, 255]).flat()) }, 100).data), { lossy: true }],
  ["P6 with comments", joined(`P6\n# made by hand\n${WIDTH} # wide\n${HEIGHT}\n255\n`, BYTES)],
  ["P6 of 16 bits", joined(`P6 ${WIDTH} ${HEIGHT} 65535\n`, Uint8Array.from([...BYTES].flatMap((byte) => [byte, byte])))],
  ["P3", text(`P3\n${WIDTH} ${HEIGHT}\n255\n${[...BYTES].join("\n")}\n`)],
  ["P3 of 16 bits", text(`P3 ${WIDTH} ${HEIGHT} 65535 ${[...BYTES].map((byte) => 257 * byte).join(" ")}`)],
  ["P5", joined(`P5 ${WIDTH} ${HEIGHT} 255\n`, GREYS), { grey: true }],
  ["P2 with a comment between numbers", text(`P2 ${WIDTH} ${HEIGHT} 255\n${[...GREYS].join(" # grey\n")}`), { grey: true }],
  ["BMP of 24 bits, from the bottom", bmp({})],
  ["BMP of 24 bits, from the top", bmp({ topDown: true })],
  ["BMP of 32 bits", bmp({ bits: 32, pixel: (x, y) => [...bgr(x, y), 0] })],
  ["BMP of 32 bits by masks", bmp({ bits: 32, compression: 3, masks: MASKS, pixel: rgbx })],
  ["BMP with the header of version 5", bmp({ bits: 32, compression: 3, headerLength: 124, masks: MASKS, pixel: rgbx })],
  ["BMP with the oldest header", bmp({ headerLength: 12 })],
  ["TGA, type 2", joined(tgaHeader(2, 24, 0), bottomUp(tgaRow))],
  ["TGA, type 2 from the top, with an id", joined(tgaHeader(2, 24, 0x20, WIDTH, HEIGHT, 3), "abc", ...eachRow(tgaRow))],
  ["TGA, type 3", joined(tgaHeader(3, 8, 0x20), GREYS), { grey: true }],
  ["TGA, type 10", joined(tgaHeader(10, 24, 0), bottomUp(packed))],
  ["TGA, type 11", joined(tgaHeader(11, 8, 0x20), ...[...GREYS].map((grey) => [128, grey])), { grey: true }],
  ["PFM, the low byte first", pfm("PF", true)],
  ["PFM, the high byte first", pfm("PF", false)],
  ["PFM of greys", pfm("Pf", true, GREYS), { grey: true }],
  ["n lines of 3n numbers", text(lines(","))],
  ["the same, parted by semicolons, from Windows, with a byte order mark", joined([0xef, 0xbb, 0xbf], text(lines(";").replaceAll("\n", "\r\n")))],
  ["the same, parted by tabs", text(lines("\t"))],
  ["the same as shares of white", text(lines(", ", (value) => value / 255)), { within: 1e-4 }],
  ["lines of x, y, r, g, b with names", text(`x,y,r,g,b\n${places(",")}\n`)],
];

const tooLong = (array, cut) => array.subarray(0, cut);
const square = Array.from({ length: 4 }, (_, i) => `${i},1,2`).join("\n");

/** name, bytes, the word of what is wrong. */
export const HOSTILE = [
  ["an empty file", new Uint8Array(0), "noBytes"],
  ["PNG that claims 10^9 pixels along", png(header(1e9, 1e9, 8, 2), pixels([0])), "tooLarge"],
  ["PNG of no width", png(header(0, 5, 8, 2), pixels([0])), "empty"],
  ["PNG cut in its header", tooLong(GOOD[0][1], 20), "truncated"],
  ["PNG cut in its data", tooLong(GOOD[0][1], 90), "truncated"],
  ["PNG with fewer pixels than claimed", png(header(WIDTH, 2000, 8, 2), pixels(rowsOf(rgbRow))), "damaged"],
  ["PNG with a wrong checksum", png(header(WIDTH, HEIGHT, 8, 2), chunk("IDAT", deflateSync(Buffer.from(rowsOf(rgbRow))), 12345)), "damaged"],
  ["PNG whose pixels do not unpack", png(header(WIDTH, HEIGHT, 8, 2), chunk("IDAT", text("no deflate at all"))), "damaged"],
  ["a bomb: 200 MB in a PNG of 5 by 5", png(header(5, 5, 8, 2), pixels(new Uint8Array(2e8))), "tooMuch"],
  ["a bomb in a colour profile, which is not unpacked", png(header(WIDTH, HEIGHT, 8, 2), chunk("iCCP", joined("x\0\0", deflateSync(Buffer.alloc(2e8)))), pixels(rowsOf(rgbRow))), ""],
  ["PNG with a palette that is not there", png(header(WIDTH, HEIGHT, 8, 3), pixels(rowsOf(() => new Uint8Array(WIDTH)))), "damaged"],
  ["PNG whose palette is too short", png(header(WIDTH, HEIGHT, 8, 3), chunk("PLTE", [1, 2, 3]), pixels(rowsOf(() => new Uint8Array(WIDTH).fill(9)))), "damaged"],
  ["PNG of a colour type that there is not", png(header(WIDTH, HEIGHT, 8, 5), pixels([0])), "header"],
  ["PNG of greys of 4 bits, interlaced", png(header(WIDTH, HEIGHT, 4, 0, 1), pixels([0])), "variant"],
  ["JPEG that claims 65535 by 65535", joined([0xff, 0xd8, 0xff, 0xc0, 0, 17, 8, 0xff, 0xff, 0xff, 0xff, 3, 1, 0x11, 0, 2, 0x11, 0, 3, 0x11, 0], new Uint8Array(40)), "tooLarge"],
  ["JPEG cut in its header", tooLong(GOOD[8][1], 100), "header"],
  ["JPEG of garbage", joined([0xff, 0xd8, 0xff], new Uint8Array(500).fill(77)), "header"],
  ["P6 that claims 10^9 pixels along", text("P6 1000000000 1000000000 255\nabc"), "tooLarge"],
  ["P6 whose data is cut", joined("P6 100 100 255\n", BYTES), "truncated"],
  ["P6 cut in its header", text("P6 100"), "damaged"],
  ["P6 whose header is no number", text("P6 wide high 255\n"), "damaged"],
  ["P6 of no height", text("P6 5 0 255\n"), "empty"],
  ["P3 with too large a value", text("P3 1 1 255 1 2 256"), "aboveMost"],
  ["P4, black and white bits", text("P4 8 1\n\x01"), "variant"],
  ["BMP that claims 2 * 10^9 along", bmp({ width: 2e9, height: 2e9 }), "tooLarge"],
  ["BMP whose data is cut", tooLong(bmp({}), 100), "truncated"],
  ["BMP, compressed", bmp({ compression: 1 }), "variant"],
  ["TGA of a colour map", joined([0, 1, 1, 0, 0, 0, 1, 24], little([0, 4], [5, 2], [5, 2]), [8, 0], new Uint8Array(25)), "variant"],
  ["TGA whose runs are cut", joined(tgaHeader(10, 24, 0, 2000, 2000), [255, 1, 2, 3]), "truncated"],
  ["TGA of 65535 by 65535", joined(tgaHeader(2, 24, 0, 65535, 65535), [1]), "tooLarge"],
  ["PFM with a value that is no number", pfm("PF", true, BYTES.map((byte) => byte), NaN), "notFinite"],
  ["PFM with an infinite value", pfm("PF", true, BYTES, 0), "notFinite"],
  ["PFM that claims 10^9 along", text("PF\n999999999 999999999\n-1\n"), "tooLarge"],
  ["PFM without a scale", text("PF\n5 5\nnone\n"), "header"],
  ["numbers with letters among them", text("1,2,3\n4,five,6\n"), "notANumber"],
  ["numbers with nan", text("1,2,3\n4,nan,6\n"), "notANumber"],
  ["numbers with inf", text("inf,2,3\n"), "notANumber"],
  ["lines of unequal length", text("1,2,3\n1,2\n"), "columns"],
  ["a table of no picture", text("1,2,3,4\n1,2,3,4\n"), "layout"],
  ["a pixel twice", text("0,0,1,2,3\n0,0,1,2,3\n"), "pixelTwice"],
  ["a pixel that is not there", text("0,0,1,2,3\n1,1,1,2,3\n"), "pixelMissing"],
  ["a pixel at 10^9", text("1000000000,0,1,2,3\n"), "pixelPlace"],
  ["numbers in UTF-16", joined([0xff, 0xfe], new Uint8Array(Buffer.from(square, "utf16le"))), "utf16"],
  ["numbers in UTF-16 without a mark", new Uint8Array(Buffer.from(square, "utf16le")), "utf16"],
  ["GIF by another name", text("GIF89a\x01\0\x01\0"), "otherFormat"],
  ["WebP by another name", joined("RIFF", [9, 0, 0, 0], "WEBPVP8L"), "otherFormat"],
  ["a page of HTML", text("<!DOCTYPE html><title>Not found</title>"), "otherFormat"],
  ["a gzipped P6", new Uint8Array(gzipSync(joined(`P6 ${WIDTH} ${HEIGHT} 255\n`, BYTES))), "otherFormat"],
  ["bytes of no kind", Uint8Array.from({ length: 5000 }, (_, i) => (i * i * 31 + 200) % 256), "unknown"],
  ["a name in place of a picture", text("../../../etc/passwd\n"), "notANumber"],
];
