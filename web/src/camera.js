// Where one looks from: a place around what is followed, which turns with its heading. A drag turns, the wheel and two fingers zoom.
import { Quaternion, Vector3 } from "three";

// Azimuth from the nose to the right, elevation [rad], and distance in spans.
export const VIEWS = {
  chase: [Math.PI, 0.28, 2],
  side: [Math.PI / 2, 0.1, 2.4],
  top: [Math.PI, 1.57, 12],
  whole: [Math.PI / 2, 0.2, 2.2],
};
const STEEPEST = 1.57;
const [NEAREST, FARTHEST] = [0.7, 20000];
const UP = new Vector3(0, 1, 0);

export class Orbit {
  constructor(canvas, redraw) {
    this.redraw = redraw;
    this.fingers = new Map();
    this.look("chase");
    canvas.style.touchAction = "pan-y"; // a finger that goes up or down scrolls the page
    canvas.addEventListener("pointerdown", (e) => {
      canvas.setPointerCapture(e.pointerId);
      this.fingers.set(e.pointerId, [e.offsetX, e.offsetY]);
      this.moved = 0;
    });
    canvas.addEventListener("pointermove", (e) => this.drag(e));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (e) => this.fingers.delete(e.pointerId));
    canvas.addEventListener("wheel", (e) => this.wheel(e), { passive: false });
  }

  look(view) {
    this.view = view;
    [this.azimuth, this.elevation, this.distance] = VIEWS[view];
  }

  drag({ pointerId, offsetX, offsetY }) {
    const from = this.fingers.get(pointerId);
    if (!from) return;
    const before = this.spread();
    this.fingers.set(pointerId, [offsetX, offsetY]);
    const [dx, dy] = [offsetX - from[0], offsetY - from[1]];
    this.moved += Math.abs(dx) + Math.abs(dy);
    if (this.fingers.size === 1) this.turn(-0.008 * dx, 0.008 * dy);
    else this.zoom(before / Math.max(this.spread(), 1));
  }

  // How far apart two fingers are [px].
  spread() {
    const [a, b] = [...this.fingers.values()];
    return b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 1;
  }

  turn(right, up) {
    this.azimuth += right;
    this.elevation = Math.min(Math.max(this.elevation + up, -STEEPEST), STEEPEST);
    this.redraw();
  }

  zoom(times) {
    this.distance = Math.min(Math.max(this.distance * times, NEAREST), FARTHEST);
    this.redraw();
  }

  // The wheel scrolls the page, but for one who has clicked into the picture, or holds Ctrl, as a touchpad does that zooms.
  wheel(e) {
    if (!e.ctrlKey && document.activeElement !== e.target) return;
    e.preventDefault();
    this.zoom(Math.exp(0.0015 * e.deltaY));
  }

  // Puts a camera around a point, given the heading and the length of a span [m].
  place(camera, at, heading, span) {
    const level = Math.cos(this.elevation);
    const offset = new Vector3(level * Math.cos(this.azimuth), Math.sin(this.elevation), level * Math.sin(this.azimuth));
    offset.multiplyScalar(this.distance * span).applyQuaternion(new Quaternion().setFromAxisAngle(UP, -heading));
    camera.position.copy(at).add(offset);
  }
}
