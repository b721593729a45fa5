/** What decoding a level takes, and the floor it is compared with, in one run. */

/** What no decoder of this text and trace can go below: parse the text, look at each character of each
 *  column once, and write as much memory as the trace holds. */
function floorOf(text, sizes) {
  const { columns } = JSON.parse(text);
  const encoder = new TextEncoder();
  let sum = 0;
  for (const column of Object.values(columns)) {
    const bytes = encoder.encode(column);
    for (let k = 0; k < bytes.length; k++) sum = (sum + bytes[k]) | 0;
  }
  return [sum, sizes.map((size) => new Uint8Array(size).fill(1))];
}

const sizesOf = (trace) => Object.values(trace).filter(ArrayBuffer.isView).map((column) => column.byteLength);
/** ms of this process's own work, which other programs do not add to. */
function now() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}
const pause = () => new Promise((resolve) => setTimeout(resolve, 1));

/** Milliseconds, of at most `rounds` of each, fewer if isEnough says so: floor; start: from the text to
 *  tiles and rays; slice: the longest part of what is left then, the lights; whole: all. The first round
 *  may be a decoder's first ever. */
export async function decodingTimes({ begin }, text, rounds, isEnough = () => false) {
  const times = { floor: [], start: [], slice: [], whole: [] };
  let trace;
  for (let k = 0; k < rounds && !isEnough(times); k++) {
    const zero = now();
    const lights = begin(JSON.parse(text)).light();
    const started = now();
    let slice = 0, last = started, step;
    do {
      step = lights.next();
      const at = now();
      slice = Math.max(slice, at - last);
      last = at;
    } while (!step.done);
    trace = step.value;
    times.start.push(started - zero);
    times.slice.push(slice);
    times.whole.push(last - zero);
    const before = now();
    floorOf(text, sizesOf(trace));
    times.floor.push(now() - before);
    await pause(); // for the collector, as between the levels of a page
  }
  return { count: trace.count, times };
}

export const best = (times) => Math.min(...times);
export const middle = (times) => [...times].sort((a, b) => a - b)[times.length >> 1];
