/** What pages and node ask of this folder. */
export { toldApartIn } from "./alike";
export { atlasOf } from "./atlas";
export { compare, faultOfSize } from "./compare";
export { readPicture, pictureOrSentence } from "./formats/read";
export { sentenceOf } from "./formats/sentences";
export { alikeIn } from "./alike";
export { recogniserOf } from "./recognise";
