/** What is wrong with a file, said to a person in the page's language: check.fault of words/. */
import { say } from "../../viewer/words";
import type { WordKeys } from "../../viewer/word-keys";
import type { PictureFault } from "./fault";

type Of<K> = K extends `check.fault.${infer Word}` ? Word : never;
export type FaultWord = Of<keyof WordKeys>;

const tell = say as (key: string, figures: PictureFault["figures"]) => string; // a fault has the figures of its word

export const sentenceOf = ({ word, figures }: PictureFault) => tell(`check.fault.${word}`, figures);
