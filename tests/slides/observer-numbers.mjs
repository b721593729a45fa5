/** node observer-numbers.mjs SCENES.json: what the viewer's own modules compute of views and points. */
import { readFile } from "node:fs/promises";
import { load } from "../viewer/typescript.mjs";

const viewer = await load("state/observer.ts", "state/frustum.ts", "state/projection.ts", "state/view-state.ts");
const asked = JSON.parse(await readFile(process.argv[2], "utf8"));
const answers = asked.map(({ scene, width, height }) => {
  const plane = viewer.picturePlane(scene);
  const kept = { speed: 1, still: true, gl: true };
  const stops = scene.lesson.flatMap((step) => [step, ...(step.answer ? [step.answer] : [])]);
  return stops.map(({ view }) => {
    const state = viewer.applyView(scene, viewer.startState(scene, kept), view);
    const observer = viewer.observerOf(state.observer, scene, plane, width / height);
    const projection = viewer.createProjection(observer, width, height);
    const points = [...viewer.planeCorners(plane), ...scene.lights.map((light) => light.position), scene.bounds.center];
    return {
      n: state.n, pixel: state.pixel, rays: state.rays, tiles: state.tiles,
      eye: observer.eye, target: observer.target, fov: observer.fov,
      corners: viewer.planeCorners(plane),
      seen: points.map((point) => Object.values(projection.project(point))),
    };
  });
});
console.log(JSON.stringify(answers));
