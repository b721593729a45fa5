/** What node asks of this folder: check.mjs, and tests. */
export { alikeIn, toldApartIn } from "./alike";
export { check, wantsTiles } from "./check";
export { compare } from "./compare";
export { aboutOf, rightOf, sceneOf, stripsOf } from "./data";
export { atlasOf } from "./atlas";
export { pictureOrSentence, readPicture } from "./formats/read";
export { sentenceOf } from "./formats/sentences";
export { allScenesOf, otherScene, toldApartFromAfar } from "./other-scene";
export { placeAt, whereWrong } from "./places";
export { recogniserOf } from "./recognise";
export { refused, reportOf, sentenceAlone, written } from "./report";
export { apartOf } from "./telling-apart";
export { isRefusal, nearestSize, sourceFor, squareOf, taken } from "./square";
export { gridFor, worstTiles } from "./tiles";
