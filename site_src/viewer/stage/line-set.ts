/** A set of rays drawn together: thick for the selected pixel, hair-thin for a row, a column or all. */
import { BufferAttribute, GreaterDepth, Group, InstancedBufferAttribute, InstancedBufferGeometry, LineSegments, Mesh, type ShaderMaterial } from "three";
import { LINES, rgb, STAGE } from "../palette";
import { faintness, worthOf, type Line } from "../state/lines";
import type { LitLine } from "../state/types";
import { createLineMaterial } from "./line-shader";

const OF_MISSES = 0.4; // of a thin line's opacity, where the ray leaves the scene

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
  if (thick) put(heads, createLineMaterial("arrow", 13, 1), 4);
  // What an object hides of the selected rays shines through it faintly: they must be followed.
  if (thick) put(body, createLineMaterial("line", 3, 0.28, { depthFunc: GreaterDepth }), 6);

  return {
    object,
    show(lines: readonly Line[], lit: LitLine | null) {
      const attribute = (size = 3) => new Float32Array(size * lines.length);
      const [from, to, tints, styles, worths] = [attribute(), attribute(), attribute(), attribute(4), attribute(1)];
      lines.forEach((line, k) => {
        from.set(line.from, 3 * k);
        to.set(line.to, 3 * k);
        tints.set(rgb(LINES[line.kind].colour), 3 * k);
        styles.set([...LINES[line.kind].dash, lit && lit.ray === line.ray && lit.light === line.light ? 1 : 0, LINES[line.kind].wide], 4 * k);
        worths[k] = thick ? worthOf(line) : line.leaves ? OF_MISSES : 1;
      });
      for (const geometry of [body, heads]) {
        geometry.dispose(); // sizes differ from pixel to pixel: let three make new buffers
        geometry.setAttribute("lineFrom", new InstancedBufferAttribute(from, 3));
        geometry.setAttribute("lineTo", new InstancedBufferAttribute(to, 3));
        geometry.setAttribute("tint", new InstancedBufferAttribute(tints, 3));
        geometry.setAttribute("style", new InstancedBufferAttribute(styles, 4));
        geometry.setAttribute("worth", new InstancedBufferAttribute(worths, 1));
        geometry.instanceCount = lines.length;
      }
      object.visible = lines.length > 0;
      if (!thick) drawn.uniforms.opacity.value = faintness(lines.length) * (STAGE.onPaper ? 1.6 : 1); // a hall sees less of them
    },
    /** CSS pixels. */
    resize(width: number, height: number) {
      for (const material of materials) material.uniforms.stage.value.set(width, height);
    },
  };
}
