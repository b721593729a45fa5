/** Each law is asked in every run, of the cases where it breaks most easily; of all of them by `make stress`. */
import { test } from "node:test";

const EVERY = !!process.env.RAYWALK_EVERY_CASE;

/** all: a law's cases. few: those of them that every run asks. */
export const cases = (all, few) => (EVERY ? all : few);
/** A test of what others ask too, in another language, size or engine. */
export const oneMore = EVERY ? test : () => {};
