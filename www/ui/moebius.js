// @ts-check
// Möbius inversion: its centre is dragged over the picture or typed in, the surface inverted is
// seen at once, and kept or let go.

/** @import { InversionReport } from "../generated/types.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";

/** @typedef {{ x: number, y: number, depth: number }} Seen */

/**
 * What the handle needs of the picture.
 * @typedef {object} Canvas
 * @property {(point: ArrayLike<number>) => Seen | null} project  in CSS pixels of the canvas
 * @property {(seen: Seen) => number[] | null} unproject
 */

/** How far the centre is from the middle at first: outside, and the surface is seen to change. */
const FIRST = 0.62;
/** What it keeps from the edge of the picture to be in reach, in CSS pixels. */
const MARGIN = 28;

/** A press of an arrow key, in CSS pixels; with Shift four of them. */
const STEP = 6;
/** Away from the eye by this factor. */
const DEEPER = 1.02;

/** Middle and diagonal of the box about the surface. @param {Float32Array} positions */
export function boxOf(positions) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 1) {
    const axis = i % 3;
    if (positions[i] < low[axis]) low[axis] = positions[i];
    if (positions[i] > high[axis]) high[axis] = positions[i];
  }
  const size = Math.hypot(...high.map((value, axis) => value - low[axis]));
  return { middle: high.map((value, axis) => (value + low[axis]) / 2), size };
}

/** @param {number} change  a difference, of which only the size matters */
const asChange = (change) => (change === 0 ? "0" : change.toExponential(1));

/** @param {InversionReport} report @returns {[string, number, number][]} */
function rowsOf({ before, after }) {
  /** @type {[string, number, number][]} */
  const rows = [
    [
      before.circleClosed === null ? t("W") : t("W of interior vertices"),
      before.circle,
      after.circle,
    ],
  ];
  if (before.circleClosed !== null && after.circleClosed !== null) {
    rows.push([t("W closed at infinity"), before.circleClosed, after.circleClosed]);
  }
  rows.push([t("∫H² dA"), before.willmore, after.willmore], [t("Area"), before.area, after.area]);
  return rows;
}

/** @param {InversionReport} report */
function noteOf({ before, after, angles, largestChange, mirrored }) {
  const share = Math.abs(after.circle - before.circle) / angles;
  return [
    t("W changes by {share} of the sum of all angles, rounding; no vertex’s by more than {most}.", {
      share: asChange(share),
      most: asChange(largestChange),
    }),
    before.circleClosed === null
      ? t("∫H² dA stays on smooth closed surfaces; on a mesh it changes with its triangles.")
      : t(
          "With the boundary closed by a vertex at infinity W is not invariant: the inversion takes infinity to a point. ∫H² dA changes by what ∫K dA does.",
        ),
    mirrored
      ? t("A reflection follows, so that normals point where they did.")
      : t("The centre is inside: outside and inside change places, and normals still point out."),
    t("The size of the surface is kept."),
  ].join(" ");
}

/**
 * @param {Controller} controller
 * @param {Canvas} canvas
 * @param {Promise<unknown>} pictured  settled once there is a picture to find a place in
 */
export function createMoebius(controller, canvas, pictured) {
  const section = byId("moebius", HTMLDetailsElement);
  const surface = byId("surface", HTMLCanvasElement);
  const handle = byId("inversion-centre", HTMLButtonElement);
  const where = byId("moebius-where", HTMLElement);
  const rows = byId("moebius-rows", HTMLElement);
  const help = byId("help-open", HTMLElement);
  const toggle = byId("panel-toggle", HTMLElement);
  const note = byId("moebius-note", HTMLElement);
  const refusal = byId("moebius-refusal", HTMLElement);
  const keep = byId("moebius-keep", HTMLButtonElement);
  const fields = [...section.querySelectorAll("input")];

  /** @type {Readonly<PageState> | null} */
  let state = null;
  let box = { middle: [0, 0, 0], size: 1 };
  let centre = [0, 0, FIRST];
  /** @type {PageState["preview"]} */
  let shown = null;
  /** What the preview was asked of. @type {unknown[]} */
  let subject = [];
  let isAsked = false;
  let isStale = false;
  let isRefused = false;
  let isKeeping = false;
  /** Whether the centre was chosen before there was a picture to choose it in. */
  let isStandIn = false;

  const isOn = () => section.open && !section.hidden;
  const point = () => centre.map((value, axis) => box.middle[axis] + box.size * value);

  /** @param {{ x: number, y: number }} at  the nearest place in reach: under no button */
  function within({ x, y }) {
    const picture = surface.getBoundingClientRect();
    const above = help.getBoundingClientRect().bottom - picture.top;
    // On a phone this one floats at the bottom.
    const floating = toggle.getBoundingClientRect().top - picture.top;
    const below = floating > picture.height / 2 ? floating : picture.height;
    return {
      x: Math.min(Math.max(x, MARGIN), picture.width - MARGIN),
      y: Math.min(Math.max(y, Math.max(above, 0) + MARGIN), below - MARGIN),
    };
  }

  /** Above the surface to the right, as it is seen, or nearer to the eye where there is no room. */
  function first() {
    const middle = canvas.project(box.middle);
    const right = middle && canvas.unproject({ ...middle, x: middle.x + 1 });
    isStandIn = !middle || !right;
    if (!middle || !right) return [0, 0, FIRST];
    const pixel = Math.hypot(...right.map((value, axis) => value - box.middle[axis])) / box.size;
    const reach = FIRST / pixel;
    const at = within({ x: middle.x + 0.9 * reach, y: middle.y - 0.44 * reach });
    const across = pixel * Math.hypot(at.x - middle.x, at.y - middle.y);
    const nearer = box.size * Math.sqrt(Math.max(FIRST ** 2 - across ** 2, 0));
    const found = canvas.unproject({ ...at, depth: Math.max(middle.depth - nearer, nearer) });
    return found ? asCentre(found) : [0, 0, FIRST];
  }

  /** @param {number[]} of  a point of space */
  const asCentre = (of) => of.map((value, axis) => (value - box.middle[axis]) / box.size);

  function place() {
    const seen = isOn() ? canvas.project(point()) : null;
    handle.hidden = !seen;
    if (seen) {
      const { x, y } = within(seen);
      handle.style.translate = `${x}px ${y}px`;
    }
    const text = centre.map((value) => value.toFixed(2));
    setText(where, t("at {x}, {y}, {z}", { x: text[0], y: text[1], z: text[2] }));
    for (const [axis, field] of fields.entries()) {
      if (document.activeElement !== field) field.value = String(Number(centre[axis].toFixed(4)));
    }
  }

  /** @param {any} error */
  function refuse(error) {
    isRefused = true;
    setText(refusal, `${error?.message ?? error}. ${error?.hint ?? ""}`);
    refusal.hidden = false;
    keep.ariaDisabled = "true";
  }

  /** At most one is under way; what was wanted meanwhile is asked for afterwards. */
  async function preview() {
    isStale = true;
    if (isAsked || isKeeping) return;
    isAsked = true;
    while (isStale && isOn()) {
      isStale = false;
      try {
        await controller.preview(centre);
        isRefused = false;
        refusal.hidden = true;
        keep.ariaDisabled = "false";
      } catch (error) {
        refuse(error);
      }
    }
    isAsked = false;
    if (!isOn()) controller.endPreview();
  }

  /** @param {number[] | null} to  a point of space */
  function move(to) {
    if (!to) return;
    centre = asCentre(to);
    place();
    preview();
  }

  /** @param {InversionReport} report */
  function tell(report) {
    rows.replaceChildren(
      ...rowsOf(report).map(([name, before, after]) => {
        const row = document.createElement("tr");
        const head = document.createElement("th");
        head.scope = "row";
        head.textContent = name;
        row.append(head);
        const texts = [formatNumber(before, 6), formatNumber(after, 6), asChange(after - before)];
        for (const text of texts) row.insertCell().textContent = text;
        return row;
      }),
    );
    setText(note, noteOf(report));
  }

  function close() {
    section.open = false;
  }

  // The picture is drawn in its new size first.
  new ResizeObserver(() =>
    requestAnimationFrame(() => requestAnimationFrame(() => isOn() && place())),
  ).observe(surface);

  section.addEventListener("toggle", () => {
    if (isOn()) centre = first();
    place();
    if (isOn()) {
      controller.pause();
      preview();
    } else controller.endPreview();
  });
  byId("moebius-cancel", HTMLButtonElement).addEventListener("click", close);
  keep.addEventListener("click", () => {
    if (isRefused || !state?.preview) return;
    // Until it is there the preview stands for it.
    isKeeping = true;
    controller.invert(centre).finally(() => {
      isKeeping = false;
      close();
    });
  });
  section.addEventListener("input", () => {
    if (!fields.every((field) => field.checkValidity() || field.validity.stepMismatch)) return;
    isStandIn = false;
    centre = fields.map((field) => field.valueAsNumber);
    place();
    preview();
  });

  /** @type {{ x: number, y: number, depth: number } | null} where it was taken, from its middle */
  let grip = null;
  handle.addEventListener("pointerdown", (event) => {
    const seen = canvas.project(point());
    if (!seen || !event.isPrimary || event.button !== 0) return;
    grip = { x: event.clientX - seen.x, y: event.clientY - seen.y, depth: seen.depth };
    handle.setPointerCapture(event.pointerId);
  });
  handle.addEventListener("pointermove", (event) => {
    if (!grip || !event.isPrimary) return;
    const { x, y, depth } = grip;
    move(canvas.unproject({ x: event.clientX - x, y: event.clientY - y, depth }));
  });
  handle.addEventListener("lostpointercapture", () => {
    grip = null;
  });
  handle.addEventListener("keydown", (event) => {
    const seen = canvas.project(point());
    const step = event.shiftKey ? 4 * STEP : STEP;
    /** @type {Record<string, [number, number, number]>} */
    const moves = {
      ArrowLeft: [-step, 0, 1],
      ArrowRight: [step, 0, 1],
      ArrowUp: [0, -step, 1],
      ArrowDown: [0, step, 1],
      PageUp: [0, 0, DEEPER],
      PageDown: [0, 0, 1 / DEEPER],
    };
    const by = moves[event.key];
    if (!seen || !by) return;
    event.preventDefault();
    move(canvas.unproject({ x: seen.x + by[0], y: seen.y + by[1], depth: seen.depth * by[2] }));
  });
  new ResizeObserver(place).observe(surface);
  pictured.then(() => {
    if (!isOn()) return;
    if (isStandIn) centre = first();
    place();
    preview();
  });

  return {
    /** @param {Readonly<PageState>} now */
    update(now) {
      const before = state;
      state = now;
      // What stands side by side has meshes of its own.
      section.hidden = !now.mesh || (now.frame?.panes.length ?? 0) > 0;
      if (section.open && (section.hidden || now.phase === "running" || now.phase === "loading")) {
        close();
      }
      if (now.frame?.positions !== before?.frame?.positions && now.frame) {
        box = boxOf(now.frame.positions);
      }
      if (!isOn()) return;
      if (now.camera !== before?.camera || now.frame !== before?.frame) place();
      if (now.preview !== shown) {
        shown = now.preview;
        if (shown) tell(shown.report);
      }
      const about = [now.frame?.positions, now.colour, now.wanted];
      if (about.some((value, n) => value !== subject[n])) {
        subject = about;
        preview();
      }
    },
  };
}
