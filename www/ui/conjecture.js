// @ts-check
// The conjecture on the mesh at hand: a dot an edge, the count of each quadrant, and the
// counterexamples, on the surface and by their numbers.

/** @import { ConjectureReport as Conjecture } from "../generated/types.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { byId, setText } from "./element.js";
import { ownPane } from "./picture.js";
import { showQuadrilateral, signed } from "./quadrilateral.js";
import { createScatter } from "./scatter.js";

/** While flips run, so many milliseconds between surveys. */
const PAUSE = 400;
/** Counterexamples that the list names. */
const LISTED = 50;
/** Counterexamples drawn on the surface. */
const DRAWN = 20_000;

/**
 * @param {Controller} controller
 * @param {(event: MouseEvent, ends: Uint32Array) => number | null} nearestEdge  on the surface
 */
export function createConjecture(controller, nearestEdge) {
  const section = byId("conjecture", HTMLDetailsElement);
  const canvas = byId("scatter", HTMLCanvasElement);
  const surface = byId("surface", HTMLCanvasElement);
  const verdict = byId("conjecture-verdict", HTMLElement);
  const list = byId("counterexamples", HTMLSelectElement);
  const details = byId("quadrilateral", HTMLElement);
  const cells = {
    both: byId("quadrant-both", HTMLElement),
    neither: byId("quadrant-neither", HTMLElement),
    areaOnly: byId("quadrant-area", HTMLElement),
    localisedOnly: byId("quadrant-localised", HTMLElement),
  };
  const scatter = createScatter(canvas);

  /** @type {Conjecture | null} */
  let report = null;
  /** @type {number | null} */
  let selected = null;
  /** @type {Readonly<PageState> | null} */
  let state = null;
  /** @type {PageState["frame"]} that the report tells of */
  let surveyed = null;
  let busy = false;

  const isShown = () => section.open && state?.options.flow === "flips" && state.reading !== null;
  /** @param {Conjecture} of @param {number} n */
  const cornersOf = ({ corners }, n) => [...corners.subarray(4 * n, 4 * n + 4)];

  /** @param {Conjecture} of */
  function counterexampleEdges(of) {
    const count = Math.min(of.counterexamples, DRAWN);
    const edges = new Uint32Array(2 * count);
    for (let n = 0; n < count; n += 1) edges.set(cornersOf(of, n).slice(0, 2), 2 * n);
    return edges;
  }

  /** The edges of all counterexamples, and the triangles of the one that is looked at. */
  function mark() {
    // The lines of a subdivided surface are not the edges of the mesh.
    if (!report || !state || state.arrangement.subdivide > 0) return controller.mark(null);
    const edges = counterexampleEdges(report);
    const pane = ownPane(state) ?? state.mesh;
    const [i, j, k, l] = selected === null ? [] : cornersOf(report, selected);
    const triangles = [];
    const all = pane?.triangles ?? new Uint32Array();
    for (let t = 0; selected !== null && 3 * t < all.length; t += 1) {
      const corners = [all[3 * t], all[3 * t + 1], all[3 * t + 2]];
      const has = (/** @type {number} */ v) => corners.includes(v);
      if (has(i) && has(j) && (has(k) || has(l))) triangles.push(t);
    }
    const chosen = selected === null ? [] : [i, j];
    controller.mark({
      edges: Uint32Array.from([...edges, ...chosen]),
      triangles: Uint32Array.from(triangles),
    });
  }

  /** @param {number | null} n */
  async function select(n) {
    if (!report) return;
    selected = n;
    list.value = n === null ? "" : String(n);
    scatter.show(report, selected);
    mark();
    const asked = report;
    try {
      const quad = n === null ? null : await controller.quadrilateral(cornersOf(asked, n));
      if (asked === report && selected === n) showQuadrilateral(details, quad);
    } catch (error) {
      controller.report(error);
    }
  }

  /** @param {Conjecture} now */
  function show(now) {
    report = now;
    const total = now.both + now.neither + now.areaOnly + now.localisedOnly;
    const against = now.areaOnly + now.localisedOnly;
    for (const [name, cell] of Object.entries(cells)) {
      setText(cell, String(now[/** @type {keyof typeof cells} */ (name)]));
    }
    const share = total > 0 ? (100 * (total - against)) / total : 100;
    const percent = share.toFixed(against / total < 1e-4 ? 3 : 2);
    setText(
      verdict,
      against === 0
        ? t("On this mesh it holds for all {total} edges.", { total })
        : t("On this mesh it holds for {percent} % of {total} edges and fails for {against}.", {
            percent,
            total,
            against,
          }),
    );
    canvas.ariaLabel = t(
      "Reductions of {total} edges: {both} lower both, {neither} neither, {areaOnly} only the area, {localisedOnly} only the localised energy",
      {
        total,
        both: now.both,
        neither: now.neither,
        areaOnly: now.areaOnly,
        localisedOnly: now.localisedOnly,
      },
    );
    const names = Array.from({ length: Math.min(now.counterexamples, LISTED) }, (_, n) => {
      const [i, j] = cornersOf(now, n);
      return new Option(
        t("Edge {i}–{j}: f_a {area}, f_l {localised}", {
          i,
          j,
          area: signed(now.area[n]),
          localised: signed(now.localised[n]),
        }),
        String(n),
      );
    });
    list.replaceChildren(...names);
    list.parentElement?.toggleAttribute("hidden", names.length === 0);
    select(names.length > 0 ? 0 : null);
  }

  async function survey() {
    if (busy || !isShown() || !state || state.frame === surveyed) return;
    busy = true;
    const frame = state.frame;
    try {
      const now = await controller.conjecture();
      surveyed = frame;
      if (isShown()) show(now);
    } catch (error) {
      surveyed = frame;
      controller.report(error);
    }
    setTimeout(
      () => {
        busy = false;
        survey();
      },
      state.phase === "running" ? PAUSE : 0,
    );
  }

  section.addEventListener("toggle", () => {
    if (section.open) {
      surveyed = null;
      survey();
    } else controller.mark(null);
  });
  list.addEventListener("change", () => select(Number(list.value)));
  canvas.addEventListener("click", (event) => {
    const found = scatter.nearest(event);
    if (found !== null) select(found);
  });
  // A click, and not the end of a drag.
  let pressed = [0, 0];
  surface.addEventListener("pointerdown", ({ clientX, clientY }) => {
    pressed = [clientX, clientY];
  });
  surface.addEventListener("click", (event) => {
    if (
      !isShown() ||
      !report ||
      Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4
    )
      return;
    const found = nearestEdge(event, counterexampleEdges(report));
    if (found !== null) select(found);
  });

  return {
    /** @param {Readonly<PageState>} now */
    update(now) {
      const before = state;
      state = now;
      if (before?.options.flow === "flips" && now.options.flow !== "flips") {
        report = null;
        surveyed = null;
        if (now.marks) controller.mark(null);
      }
      if (
        report &&
        before &&
        (now.view !== before.view || now.arrangement !== before.arrangement)
      ) {
        scatter.show(report, selected);
        if (now.arrangement.subdivide !== before.arrangement.subdivide) mark();
      }
      survey();
    },
  };
}
