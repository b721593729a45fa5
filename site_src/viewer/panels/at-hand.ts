/** What is at hand and not seen: the page's menu, all keys, and a pixel's rays as text to take away. One part, for all of them
 *  say what they have done and open sheets. */
export { copy } from "./clipboard";
export { copyRays } from "./copies";
export { createHelp, createKeySign, createSwipeHint } from "./help";
export { createTools, createWayOut } from "./tools";
