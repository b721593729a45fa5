/** What the built site holds students' pictures against, and pictures as files. */
import { readFileSync } from "node:fs";
import { PNG } from "pngjs";
import { DIST } from "./browser.mjs";
import { load } from "./typescript.mjs";

const { aboutOf, atlasOf, rightOf, stripsOf } = await load("../check/main.ts");

export const dataOf = (scene, name) => Buffer.from(readFileSync(`${DIST}/check/${scene}/${name}.js`, "latin1").split('"')[3], "base64");

/** A file of a picture's bytes. */
export function pngOf({ width, height, values }) {
  const png = new PNG({ width, height });
  for (let i = 0; i < width * height; i++) png.data.set([...values.subarray(3 * i, 3 * i + 3), 255], 4 * i);
  return PNG.sync.write(png, { colorType: 2 });
}

export const rightPicture = (scene, n) => rightOf(dataOf(scene, n));

/** What a mistake makes of a scene, as its atlas has it. */
export async function wrongPicture(scene, name) {
  const { size, mistakes } = atlasOf(aboutOf(dataOf(scene, "about")), await stripsOf(dataOf(scene, "atlas")));
  const found = mistakes.find((each) => each.name === name);
  if (!found) throw new Error(`${scene} shows no ${name}`);
  return { width: size, height: size, values: found.pictures[0] };
}
