/** A set of rays drawn together: thick for the selected pixel, hair-thin for a row, a column or all. */
import { BufferAttribute, GreaterDepth, Group, InstancedBufferAttribute, InstancedBufferGeometry, LineSegments, Mesh, type ShaderMaterial } from "three";
import { LINES, rgb } from "../palette";
import type { Line } from "../state/lines";
import type { LitLine } from "../state/types";
import { createLineMaterial } from "./line-shader";

const ARROWS_UP_TO = 500; // lines; beyond that heads would cover the lines
const FAINTEST_FROM = 15000;
const FAINT_FROM = 1000; // lines; so many would cover the scene

const RIBBON = { position: [0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0], index: [0, 1, 2, 0, 2, 3] };
const HAIR = { position: [0, 0, 0, 1, 0, 0], index: [0, 1] };
const HEAD = { position: [0.6, 0, 0, -0.6, 0.55, 0, -0.6, -0.55, 0], index: [0, 1, 2] };

function shape({ position, index }: typeof HEAD) {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(position), 3));
  geometry.setIndex(index);
  return geometry;
}

export function createLineSet(thick: boolean) {
  const object = new Group();
  const body = shape(thick ? RIBBON : HAIR);
  const heads = shape(HEAD);
  const materials: ShaderMaterial[] = [];
  const put = (geometry: InstancedBufferGeometry, material: ShaderMaterial, order: number) => {
    const drawn = geometry === body && !thick ? new LineSegments(geometry, material) : new Mesh(geometry, material);
    drawn.frustumCulled = false; // the shader places the instances, three cannot know where
    drawn.renderOrder = order;
    materials.push(material);
    object.add(drawn);
    return drawn;
  };
  if (thick) put(body, createLineMaterial("casing", 3, 0.75), 3.5);
  const drawn = createLineMaterial("line", thick ? 3 : 1, thick ? 1 : 0.6);
  put(body, drawn, 4);
  put(heads, createLineMaterial("arrow", thick ? 13 : 8, thick ? 1 : 0.75), 4);
  // What an object hides of the selected rays shines through it faintly: they must be followed.
  if (thick) put(body, createLineMaterial("line", 3, 0.28, { depthFunc: GreaterDepth }), 6);

  return {
    object,
    show(lines: readonly Line[], lit: LitLine | null) {
      const attribute = (size = 3) => new Float32Array(size * lines.length);
      const [from, to, tints, styles] = [attribute(), attribute(), attribute(), attribute(4)];
      lines.forEach((line, k) => {
        from.set(line.from, 3 * k);
        to.set(line.to, 3 * k);
        tints.set(rgb(LINES[line.kind].colour), 3 * k);
        styles.set([...LINES[line.kind].dash, lit && lit.ray === line.ray && lit.light === line.light ? 1 : 0, LINES[line.kind].wide], 4 * k);
      });
      for (const geometry of [body, heads]) {
        geometry.dispose(); // sizes differ from pixel to pixel: let three make new buffers
        geometry.setAttribute("lineFrom", new InstancedBufferAttribute(from, 3));
        geometry.setAttribute("lineTo", new InstancedBufferAttribute(to, 3));
        geometry.setAttribute("tint", new InstancedBufferAttribute(tints, 3));
        geometry.setAttribute("style", new InstancedBufferAttribute(styles, 4));
        geometry.instanceCount = lines.length;
      }
      heads.instanceCount = lines.length > ARROWS_UP_TO ? 0 : lines.length;
      object.visible = lines.length > 0;
      if (!thick) drawn.uniforms.opacity.value = lines.length > FAINTEST_FROM ? 0.07 : lines.length > FAINT_FROM ? 0.2 : 0.6;
    },
    /** CSS pixels. */
    resize(width: number, height: number) {
      for (const material of materials) material.uniforms.stage.value.set(width, height);
    },
  };
}
