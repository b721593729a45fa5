/** The picture plane's n x n tiles as one quad. An empty tile is see-through, a filled one has exactly
 *  its colour; the selected one has a ring. */
import { BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, Group, Mesh, NearestFilter, ShaderMaterial, Vector2 } from "three";
import { STAGE } from "../palette";
import { planeCorners, type PicturePlane } from "../state/frustum";
import { memo } from "../state/memo";

const VERTEX = `
varying vec2 at;
void main() { at = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;

// Lengths on the tiles are measured in screen pixels, so that lines stay thin at any distance. Lines that would merge, seen
// edge-on, are not drawn; the ring is round a small tile and not in it, for a ray hides its middle.
const FRAGMENT = `
uniform sampler2D colours;
uniform float n;
uniform vec2 selected;
uniform vec3 ring, gridEmpty, gridFilled;
uniform float ringShown;
varying vec2 at;
void main() {
  vec2 cell = at * n;
  vec2 perPixel = max(fwidth(cell), vec2(1e-6));
  vec4 tile = texture2D(colours, (min(floor(cell), n - 1.0) + 0.5) / n);
  bool filled = tile.a > 0.5;
  vec2 toEdge = (0.5 - abs(fract(cell) - 0.5)) / perPixel;
  float tilePixels = 1.0 / max(perPixel.x, perPixel.y);
  vec2 lines = (1.0 - smoothstep(0.2, 1.1, toEdge)) * smoothstep(2.0, 7.0, 1.0 / perPixel);
  float line = max(lines.x, lines.y);
  vec2 border = min(cell, n - cell) / perPixel;
  float frame = 1.0 - smoothstep(0.6, 1.6, min(border.x, border.y));
  vec2 q = (abs(cell - selected - 0.5) - 0.5) / perPixel;
  float outside = tilePixels < 24.0 ? 3.0 : 0.0;
  vec2 thick = outside > 0.0 ? vec2(0.0) : clamp(0.16 / perPixel, 1.2, 4.0);
  bool onRing = ringShown > 0.5 && max(q.x, q.y) < outside && (q.x > -thick.x || q.y > -thick.y);
#ifdef FILLED
  if (!filled && !onRing) discard;
  vec3 c = filled ? mix(tile.rgb, gridFilled, 0.55 * line) : ring;
  gl_FragColor = vec4(onRing ? ring : c, 1.0);
#else
  if (filled || onRing) discard;
  gl_FragColor = vec4(gridEmpty, max(max(0.05, 0.42 * line), 0.85 * frame));
#endif
}`;

/** The tiles' colours as a texture: red, green, blue, and whether the tile is filled. */
function createTexels() {
  const texture = { value: null as DataTexture | null };
  const painted = memo<void>();
  function paint(colours: Uint8Array | null, n: number, count: number) {
    if (texture.value?.image.width !== n) {
      texture.value?.dispose();
      texture.value = new DataTexture(new Uint8Array(4 * n * n), n, n);
      texture.value.magFilter = texture.value.minFilter = NearestFilter;
    }
    const data = texture.value.image.data as Uint8Array;
    data.fill(0);
    for (let k = 0; colours && k < count; k++) {
      data.set(colours.subarray(3 * k, 3 * k + 3), 4 * k);
      data[4 * k + 3] = 255;
    }
    texture.value.needsUpdate = true;
  }
  return { texture, show: (colours: Uint8Array | null, n: number, count: number) => painted([colours, n, count], () => paint(colours, n, count)) };
}

function quadOf(plane: PicturePlane): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(planeCorners(plane).flat()), 3));
  geometry.setAttribute("uv", new BufferAttribute(new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]), 2));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}

export function createTiles(plane: PicturePlane) {
  const geometry = quadOf(plane);
  const texels = createTexels();
  const uniforms = {
    colours: texels.texture,
    n: { value: 1 },
    selected: { value: new Vector2() },
    ring: { value: new Color() },
    ringShown: { value: 1 },
    gridEmpty: { value: new Color(STAGE.gridEmpty) },
    gridFilled: { value: new Color(STAGE.gridFilled) },
  };
  const object = new Group();
  // Filled tiles hide what is behind them, empty ones must not: two passes over the same quad.
  for (const filled of [true, false]) {
    const passes = { defines: filled ? { FILLED: 1 } : {}, transparent: !filled, depthWrite: filled };
    const mesh = new Mesh(geometry, new ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms, side: DoubleSide, ...passes }));
    if (!filled) mesh.renderOrder = 5;
    object.add(mesh);
  }
  return {
    object,
    /** colours: (3 * n * n) 8-bit. count: tiles filled, in scan order. ring: colour of the selected tile's outline, null while it blinks off. */
    show(colours: Uint8Array | null, n: number, count: number, selected: readonly [number, number], ring: string | null) {
      texels.show(colours, n, count);
      uniforms.n.value = n;
      uniforms.selected.value.set(...selected);
      uniforms.ringShown.value = ring ? 1 : 0;
      if (ring) uniforms.ring.value.set(ring);
    },
  };
}
