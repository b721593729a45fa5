/** Where the selected camera ray meets each sphere: a point that slides along the ray, t^2 + 2bt + c as a curve, b, c, D and the
 *  roots as the pipeline found them. */
import { element, named, swatch } from "../element";
import { svg } from "../panels/svg";
import type { Drawn } from "../stage/renderer";
import type { Vec3 } from "../state/vectors";
import type { SceneData, WorkedRay } from "../trace/types";
import { fixed, hexOf, number, say, vector } from "../words";
import type { Worked, WorkedPanel } from "./types";

type Sphere = WorkedRay["spheres"][number];

const STEPS = 1000; // of the slider
const FARTHEST = 8; // t at its end
const BEGINS = 2; // t
const [WIDE, HIGH] = [256, 110]; // of the curves
const [LOW, ABOVE] = [-1.2, 3]; // the least value that they show, and how much more than a curve's least

const along = ({ origin, direction }: WorkedRay, t: number): Vec3 => [0, 1, 2].map((k) => origin[k] + t * direction[k]) as unknown as Vec3;
const value = ({ b, c }: Sphere, t: number): number => t * t + 2 * b * t + c;
const left = (t: number): number => (t / FARTHEST) * WIDE;
const colourOf = ({ objects, materials }: SceneData, sphere: Sphere): string => hexOf(materials[objects[sphere.object].material].diffuse);

function curve(sphere: Sphere, colour: string, down: (y: number) => number): SVGElement[] {
  const path = Array.from({ length: 97 }, (_, k) => (k / 96) * FARTHEST).map((t) => `${left(t).toFixed(1)},${down(value(sphere, t)).toFixed(1)}`);
  const roots = sphere.t.map((t) => svg("circle", { cx: left(t), cy: down(0), r: 3.5, fill: colour }));
  return [svg("polyline", { points: path.join(" "), stroke: colour, fill: "none", "stroke-width": 2 }), ...roots];
}

/** The curves of the spheres that are meant are seen down to their least value, also where it is above zero: the ray misses. */
function curves({ spheres }: WorkedRay, scene: SceneData, t: number, meant: readonly string[]): SVGElement {
  const top = ABOVE - Math.min(0, ...spheres.filter(({ object }) => meant.includes(scene.objects[object].name)).map(({ discriminant }) => discriminant));
  const down = (y: number): number => ((top - Math.min(top, Math.max(LOW, y))) / (top - LOW)) * HIGH;
  const zero = svg("line", { x1: 0, x2: WIDE, y1: down(0), y2: down(0), class: "axis" });
  const now = svg("line", { x1: left(t), x2: left(t), y1: 0, y2: HIGH, class: "now" });
  return svg("svg", { viewBox: `0 0 ${WIDE} ${HIGH}`, class: "worked-curves", role: "img", "aria-label": say("worked.equation.curves") }, zero, ...spheres.flatMap((sphere) => curve(sphere, colourOf(scene, sphere), down)), now);
}

/** D and the roots are the answer to a question that is still open. */
function row(sphere: Sphere, scene: SceneData, isMeant: boolean, isOpen: boolean): HTMLElement {
  const cell = (text: string, className = "") => element("td", className, text);
  const { b, c, discriminant, t } = sphere;
  const roots = t.length ? t.map((root) => cell(isOpen ? "?" : number(root))) : [cell(isOpen ? "?" : "\u2013"), cell(isOpen ? "?" : "\u2013")];
  const sign = discriminant < 0 ? "below" : "above";
  const digits = Math.abs(discriminant) < 0.01 ? 4 : 2;
  return element("tr", isMeant ? "meant" : "", element("th", "", swatch(colourOf(scene, sphere)), scene.objects[sphere.object].name), cell(fixed(b, 2)), cell(fixed(c, 2)), cell(isOpen ? "?" : fixed(discriminant, digits), isOpen ? "" : sign), ...roots);
}

function table(ray: WorkedRay, scene: SceneData, meant: readonly string[], isOpen: boolean): HTMLElement {
  const heads = ["", "b", "c", "D", "t\u2081", "t\u2082"].map((text) => element(text ? "th" : "td", "", text)); // a heading without words is none
  return element("table", "worked-table numbers", element("tr", "", ...heads), ...ray.spheres.map((sphere) => row(sphere, scene, meant.includes(scene.objects[sphere.object].name), isOpen)));
}

/** The point on the stage, and where the ray goes into the spheres that are meant and out of them. */
function points({ projection, view }: Drawn, ray: WorkedRay, t: number, meant: readonly string[], isOpen: boolean): SVGElement[] {
  const dot = (at: number, r: number, className: string) => {
    const { x, y, depth } = projection.project(along(ray, at));
    return depth > 0 ? [svg("circle", { cx: x, cy: y, r, class: className })] : [];
  };
  const roots = isOpen ? [] : ray.spheres.filter(({ object }) => meant.includes(view.scene.objects[object].name)).flatMap((sphere) => sphere.t);
  return [...roots.flatMap((root) => dot(root, 5, "root")), ...dot(t, 7, "point")];
}

export function createEquation(changed: () => void): WorkedPanel {
  const slider = named(element("input"), say("worked.equation.slider"));
  Object.assign(slider, { type: "range", min: "0", max: String(STEPS) });
  const place = element("p", "numbers");
  const ends = element("p", "worked-note numbers");
  const below = element("div", "worked-body");
  let t = BEGINS;
  slider.addEventListener("input", () => {
    t = (Number(slider.value) / STEPS) * FARTHEST;
    changed();
  });
  return {
    element: element("div", "", element("p", "worked-title numbers", "p(t) = o + t d"), ends, slider, place, below),
    show({ drawn, data, view, isAsking, isNew }: Worked, lines) {
      const { scene, state } = drawn.view;
      const ray = data.equations?.find(({ n, pixel }) => n === state.n && pixel.join() === state.pixel.join());
      if (!ray) return false;
      if (isNew) t = BEGINS;
      const meant = view.highlight ?? [];
      slider.value = String(Math.round((t / FARTHEST) * STEPS));
      slider.setAttribute("aria-valuetext", `t = ${fixed(t, 2)}`);
      ends.textContent = `o = ${vector(ray.origin)}, d = ${vector(ray.direction)}`;
      place.textContent = `t = ${fixed(t, 2)}: p = ${vector(along(ray, t))}`;
      const said = ray.spheres.filter(({ object }) => meant.includes(scene.objects[object].name)).map((sphere) => {
        const name = scene.objects[sphere.object].name;
        return element("p", "worked-note", say(value(sphere, t) > 0 ? "worked.equation.outside" : "worked.equation.inside", { name, value: fixed(value(sphere, t), 2) }));
      });
      below.replaceChildren(...(isAsking ? [] : [curves(ray, scene, t, meant)]), ...said, table(ray, scene, meant, isAsking));
      lines.append(...points(drawn, ray, t, meant, isAsking));
      return true;
    },
  };
}
