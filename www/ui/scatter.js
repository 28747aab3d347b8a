// @ts-check
// f_a against f_l, a dot an edge. Both axes are stretched by the cube root: near zero, where
// signs are decided, most edges lie.

/** @import { ConjectureReport as Conjecture } from "../generated/types.js" */

/** How near to a dot a click counts, in CSS pixels. */
const REACH = 14;

/** @param {HTMLCanvasElement} canvas */
export function createScatter(canvas) {
  /** @type {[number, number][]} where each dot is, in CSS pixels */
  let places = [];

  return {
    /** @param {Conjecture} conjecture @param {number | null} selected */
    show({ area, localised, counterexamples }, selected) {
      const ratio = devicePixelRatio;
      const [width, height] = [canvas.clientWidth, canvas.clientHeight];
      const context = canvas.getContext("2d");
      if (!context || width === 0) return;
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      context.scale(ratio, ratio);
      const style = getComputedStyle(canvas);
      const colour = (/** @type {string} */ name) => style.getPropertyValue(name);
      const largest = (/** @type {Float32Array} */ values) =>
        Math.cbrt(values.reduce((most, v) => Math.max(most, Math.abs(v)), 1e-30));
      const [right, top] = [largest(area), largest(localised)];
      const [x0, y0] = [width / 2, height / 2];
      places = Array.from(area, (fa, n) => [
        x0 + (x0 - 8) * (Math.cbrt(fa) / right),
        y0 - (y0 - 8) * (Math.cbrt(localised[n]) / top),
      ]);
      // The quadrants that the conjecture says are empty.
      context.fillStyle = colour("--tint");
      context.fillRect(0, 0, x0, y0);
      context.fillRect(x0, y0, x0, y0);
      context.fillStyle = colour("--line");
      context.fillRect(0, y0 - 0.5, width, 1);
      context.fillRect(x0 - 0.5, 0, 1, height);
      context.fillStyle = colour("--edge");
      context.globalAlpha = 0.5;
      for (let n = counterexamples; n < places.length; n += 1) {
        context.fillRect(places[n][0] - 1, places[n][1] - 1, 2, 2);
      }
      context.globalAlpha = 1;
      context.fillStyle = colour("--danger");
      for (let n = 0; n < counterexamples; n += 1) {
        context.beginPath();
        context.arc(places[n][0], places[n][1], 3.5, 0, 2 * Math.PI);
        context.fill();
      }
      if (selected !== null && places[selected]) {
        context.strokeStyle = colour("--text");
        context.lineWidth = 2;
        context.beginPath();
        context.arc(places[selected][0], places[selected][1], 7, 0, 2 * Math.PI);
        context.stroke();
      }
    },
    /** @param {MouseEvent} event @returns {number | null} the dot next to a click */
    nearest({ clientX, clientY }) {
      const box = canvas.getBoundingClientRect();
      const [x, y] = [clientX - box.left, clientY - box.top];
      let best = REACH;
      let found = null;
      for (const [n, place] of places.entries()) {
        const distance = Math.hypot(place[0] - x, place[1] - y);
        if (distance < best) [best, found] = [distance, n];
      }
      return found;
    },
  };
}
