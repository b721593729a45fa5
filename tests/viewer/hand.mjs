/** Fingers on the glass. When they move is the test's: by the time that a machine takes from one touch to the next a slow
 *  swipe would be a fast one, after which the page goes on scrolling, or one that never came to an end. */

const MOMENT = 0.016; // s from one touch to the next
const REST = 0.3; // s that fingers rest before they leave the glass: then nothing swings on

/** touches(type, points): "touchStart" or "touchMove" with [x, y] of each finger, or "touchEnd" with none. */
export async function handOf(page) {
  const devtools = await page.context().newCDPSession(page);
  let timestamp = Date.now() / 1000;
  return (type, points = []) => {
    timestamp += type === "touchEnd" ? REST : MOMENT;
    return devtools.send("Input.dispatchTouchEvent", { type, timestamp, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  };
}
