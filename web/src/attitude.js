// Frames. Body: x forward, y right, z down. World of the picture: x north, y up, z east. Angles in radians.
import { Euler, Matrix4, Quaternion, Vector3 } from "three";

export function fromBody([x, y, z]) {
  return new Vector3(x, -z, y);
}

// Rotation from the picture's axes of an aircraft that flies level to the north.
export function attitude(roll, pitch, heading) {
  return new Quaternion().setFromEuler(new Euler(roll, -heading, pitch, "YZX"));
}

// Rotation of a surface about its hinge: a positive angle moves the trailing edge down, of an upright surface to the left.
export function deflection(hingeA, hingeB, trailing, angle, sense = 1) {
  const a = fromBody(hingeA);
  const axis = fromBody(hingeB).sub(a).normalize();
  const arm = fromBody(trailing).sub(a);
  const moved = new Vector3().crossVectors(axis, arm); // where the trailing edge goes for a small positive angle about `axis`
  const towards = Math.abs(moved.y) > 0.2 * moved.length() ? -moved.y : -moved.z;
  const signed = (towards < 0 ? -angle : angle) * sense;
  return new Matrix4()
    .makeTranslation(a.x, a.y, a.z)
    .multiply(new Matrix4().makeRotationAxis(axis, signed))
    .multiply(new Matrix4().makeTranslation(-a.x, -a.y, -a.z));
}
