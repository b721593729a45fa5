/** A file's bytes to a picture. What kind it is stands in the bytes; names and endings are never looked at. */
import { readBmp } from "./bmp";
import { readCsv } from "./csv";
import { PictureFault } from "./fault";
import { readJpeg } from "./jpeg";
import { readNetpbm } from "./netpbm";
import { readPfm } from "./pfm";
import type { Picture } from "./picture";
import { readPng } from "./png";
import { sentenceOf } from "./sentences";
import { looksLikeTga, readTga } from "./tga";

const MOST_MEGABYTES = 64; // the largest picture as text has about 50

/** How files of other kinds begin: name, bytes as text, where. */
const OTHERS: [string, RegExp][] = [
  ["GIF", /^GIF8/], ["WebP", /^RIFF....WEBP/s], ["TIFF", /^(II\*\0|MM\0\*)/], ["OpenEXR", /^v\/1\x01/], ["Radiance HDR", /^#\?R/], ["QOI", /^qoif/],
  ["HEIF or AVIF", /^....ftyp/s], ["Photoshop", /^8BPS/], ["PDF", /^%PDF/], ["ZIP", /^PK\x03\x04/], ["gzip", /^\x1f\x8b/], ["SVG, XML or HTML", /^(\xef\xbb\xbf)?\s*</],
  ["NumPy array", /^\x93NUMPY/], ["JPEG XL", /^(\xff\x0a|\0\0\0\x0cJXL)/], ["JSON", /^\s*[[{]/],
];

/** Raises PictureFault. */
export function readPicture(bytes: Uint8Array): Picture {
  if (!bytes.length) throw new PictureFault("noBytes");
  if (bytes.length > MOST_MEGABYTES * 1e6) throw new PictureFault("tooManyBytes", { megabytes: Math.ceil(bytes.length / 1e6), most: MOST_MEGABYTES });
  const head = String.fromCharCode(...bytes.subarray(0, 64));
  if (head.startsWith("\x89PNG\r\n\x1a\n")) return readPng(bytes);
  if (head.startsWith("\xff\xd8\xff")) return readJpeg(bytes);
  if (/^P[1-7][\s#]/.test(head)) return readNetpbm(bytes);
  if (/^P[Ff]\s/.test(head)) return readPfm(bytes);
  if (head.startsWith("BM")) return readBmp(bytes);
  if (/^(\xff\xfe|\xfe\xff)/.test(head) || /^([\d\s.,;-]\0){4}|^(\0[\d\s.,;-]){4}/.test(head)) throw new PictureFault("utf16");
  const other = OTHERS.find(([, beginning]) => beginning.test(head));
  if (other) throw new PictureFault("otherFormat", { format: other[0] });
  if (isText(bytes)) return readCsv(new TextDecoder().decode(bytes)); // which drops a byte order mark
  if (looksLikeTga(bytes)) return readTga(bytes);
  throw new PictureFault("unknown");
}

/** The same for who shows it: a picture, or the sentence of what is wrong. */
export function pictureOrSentence(bytes: Uint8Array): { picture: Picture } | { sentence: string; fault: PictureFault } {
  try {
    return { picture: readPicture(bytes) };
  } catch (fault) {
    if (!(fault instanceof PictureFault)) throw fault;
    return { sentence: sentenceOf(fault), fault };
  }
}

/** Its beginning has no control characters but white space. */
const isText = (bytes: Uint8Array) => bytes.subarray(0, 4096).every((byte) => byte >= 32 || (byte >= 9 && byte <= 13));
