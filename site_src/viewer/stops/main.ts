/** What site_src/stops.mjs answers with. */
export { boxesFrom } from "../state/box-lines";
export { decode } from "../trace/decode";
export { inWords } from "../trace/spoken";
export { sceneAt, stopIn } from "../state/swept";
export { wholeAgain } from "../trace/whole";
export { ask } from "./asked";
export { eventsBeside } from "./beside";
export { lessonOf } from "./lesson";
export { listEvents } from "./worded";
