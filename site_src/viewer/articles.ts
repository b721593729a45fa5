/** Articles before names. Apart from words.ts, which is in the first view: only what is shown later tells in whole sentences. */
import { say } from "./words";

/** A name as it stands in a sentence: "green sphere" is the green sphere, "mirror A" and "light 1" are called so. */
export const the = (name: string): string => name.replace(new RegExp(say("language.articled")), say("language.article"));
