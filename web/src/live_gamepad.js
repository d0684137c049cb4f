// Orders by a gamepad: the first stick turns and climbs, the second one's height sets the speed, and the first button pauses.
const AXES = [["heading_deg", 1], ["altitude_m", -1], [null, 0], ["airspeed_m_s", -1]];
const [FAR, EVERY_MS] = [0.6, 250]; // a stick that is held orders again and again

export function gamepad(order, pause, page) {
  let pressed = false;
  let last = 0;
  const look = () => {
    const pad = navigator.getGamepads?.().find((each) => each?.connected);
    if (!pad || !page.flies) return;
    const now = Boolean(pad.buttons[0]?.pressed);
    if (now && !pressed) pause();
    pressed = now;
    if (performance.now() - last < EVERY_MS) return;
    AXES.forEach(([name, sense], i) => {
      if (!name || !(Math.abs(pad.axes[i] ?? 0) > FAR)) return;
      order(name, Math.sign(pad.axes[i]) * sense);
      last = performance.now();
    });
  };
  setInterval(look, 30);
}
