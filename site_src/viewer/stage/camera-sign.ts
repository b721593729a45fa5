/** The ray-tracing camera and the lines through its picture's corners. */
import { BoxGeometry, CylinderGeometry, Group, Matrix4, Mesh, MeshMatcapMaterial, Vector3 } from "three";
import { STAGE } from "../palette";
import { planeCorners, type PicturePlane } from "../state/frustum";
import { length } from "../state/vectors";
import { createSegments } from "./segments";

const SIZE = 0.065; // of the picture plane's width
const LARGEST = 0.05; // of the scene's radius

export function createCameraSign(plane: PicturePlane, radius: number) {
  const object = new Group();
  const size = Math.min(SIZE * length(plane.across), LARGEST * radius);
  const paint = new MeshMatcapMaterial({ color: STAGE.camera });
  // The lens ends at the eye: rays start where they are traced from.
  const box = new BoxGeometry(1.5 * size, size, 1.5 * size).translate(0, 0, 1.35 * size);
  const lens = new CylinderGeometry(0.42 * size, 0.28 * size, 0.6 * size, 24).rotateX(-Math.PI / 2).translate(0, 0, 0.3 * size);
  const body = new Group();
  body.add(new Mesh(box, paint), new Mesh(lens, paint));
  body.applyMatrix4(new Matrix4().lookAt(new Vector3(), new Vector3(...plane.forward), new Vector3(...plane.up)));
  body.position.set(...plane.eye);

  const edges = createSegments(STAGE.frustum, 0.8, false);
  edges.show(planeCorners(plane).map((corner) => [plane.eye, corner]));
  object.add(body, edges.object);
  return { object };
}
