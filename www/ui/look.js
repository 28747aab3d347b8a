// @ts-check
// Looking closer: a vertex with its circles and its numbers, circumcircles, lines of curvature.

/** @import { Drawn, Look, Probe } from "../generated/types.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { isDark } from "../state.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";
import { colourOf } from "./overlay.js";

/** @typedef {import("./moebius.js").Seen} Seen */

/**
 * @typedef {object} Canvas
 * @property {(event: MouseEvent) => number[] | null} pick  the point of the surface
 * @property {(point: ArrayLike<number>) => Seen | null} project
 */

/** A click that moved farther than this, in CSS pixels, was a drag. */
const STILL = 5;

/** @param {number} radians */
const degrees = (radians) => `${formatNumber((180 / Math.PI) * radians, 5)}°`;

/** The vertex nearest to a point. @param {Float32Array} positions @param {number[]} point */
export function nearestVertex(positions, [x, y, z]) {
  let [best, nearest] = [Infinity, 0];
  for (let v = 0; v < positions.length / 3; v += 1) {
    const square =
      (positions[3 * v] - x) ** 2 +
      (positions[3 * v + 1] - y) ** 2 +
      (positions[3 * v + 2] - z) ** 2;
    if (square < best) [best, nearest] = [square, v];
  }
  return nearest;
}

/** @param {Probe} probe @returns {[string, string][]} */
function rowsOf(probe) {
  const { position, edges, sum, turn, energy, defect, principal, radii } = probe;
  return [
    [t("Position"), position.map((value) => formatNumber(value, 5)).join(", ")],
    [t("Valence"), String(edges.length)],
    ...(turn === null ? [] : [/** @type {[string, string]} */ ([t("β₃"), degrees(turn)])]),
    [t("Σβ"), `${formatNumber(sum, 6)} (${degrees(sum)})`],
    [t("Wᵢ = Σβ − 2π"), energy === null ? t("not part of the energy") : formatNumber(energy, 6)],
    [t("Kᵢ, angle defect"), `${formatNumber(defect, 6)} (${degrees(defect)})`],
    [t("H, pointwise"), formatNumber(probe.meanCurvature, 6)],
    [t("K, pointwise"), probe.boundary ? "–" : formatNumber(probe.gaussCurvature, 6)],
    [
      t("κ₁, κ₂ by a fit"),
      principal ? principal.map((value) => formatNumber(value, 5)).join(", ") : "–",
    ],
    [t("Area, a third"), formatNumber(probe.area, 6)],
    [
      t("Circumradii"),
      `${formatNumber(Math.min(...radii), 4)} … ${formatNumber(Math.max(...radii), 4)}`,
    ],
  ];
}

/** What of the energy is missing, in words. @param {Probe} probe */
function missing({ boundary, energy, edges }) {
  if (!boundary) return "";
  if (energy !== null) {
    return t(
      "A boundary vertex: at its boundary edges stands β₂, against the line through a vertex at infinity.",
    );
  }
  const count = edges.filter(({ beta }) => beta === null).length;
  return t(
    "A boundary vertex: its {count} boundary edges have one circle only and no β, and Wᵢ is no part of the energy under this boundary condition.",
    { count },
  );
}

/** @param {Drawn | null | undefined} circles */
function circlesText(circles) {
  if (!circles) return "";
  const { drawn, total, leftOut } = circles;
  const said =
    drawn + leftOut < total
      ? t("{drawn} of {total} circles, evenly chosen: of more than 6000 triangles only a part.", {
          drawn,
          total,
        })
      : t("{drawn} circles of {total} triangles.", { drawn, total });
  return leftOut === 0
    ? said
    : `${said} ${t("{leftOut} larger than the surface are left out.", { leftOut })}`;
}

/** @param {Look | null} look */
function directionsText(look) {
  const { directions, alignment } = look ?? {};
  if (!directions || !alignment) return "";
  const { drawn, leftOut, total } = directions;
  const { aligned, edges } = alignment;
  const share = edges > 0 ? `${((100 * aligned) / edges).toFixed(1)} %` : "–";
  return [
    drawn + leftOut < total
      ? t("{drawn} of {total} vertices: of more than 20000 only a part.", { drawn, total })
      : t("{drawn} of {total} vertices.", { drawn, total }),
    t("At umbilics, κ₁ − κ₂ below 5 % of √(κ₁² + κ₂²), there are no directions."),
    t("{share} of the edges lie within 5° of a line of curvature; 11 % do by chance.", { share }),
  ].join(" ");
}

/** @param {Controller} controller @param {Canvas} canvas */
export function createLook(controller, canvas) {
  const section = byId("look", HTMLDetailsElement);
  const surface = byId("surface", HTMLCanvasElement);
  const pick = byId("probe-pick", HTMLButtonElement);
  const number = byId("probe-vertex", HTMLInputElement);
  const none = byId("probe-none", HTMLButtonElement);
  const said = byId("probe-said", HTMLElement);
  const table = byId("probe-table", HTMLTableElement);
  const edges = byId("probe-edges", HTMLTableElement);
  const numberRows = byId("probe-rows", HTMLElement);
  const edgeRows = byId("probe-edge-rows", HTMLElement);
  const circles = byId("circles", HTMLInputElement);
  const directions = byId("directions", HTMLInputElement);
  const key = byId("directions-key", HTMLElement);

  /** @type {Readonly<PageState> | null} */
  let state = null;
  /** @type {Look | null} */
  let shown = null;
  let dark = false;

  const isPicking = () => pick.ariaPressed === "true";
  const positions = () => (state?.preview ?? state?.frame)?.positions ?? new Float32Array();

  /** @param {boolean} on */
  function take(on) {
    pick.ariaPressed = String(on);
    surface.classList.toggle("picking", on);
  }

  /** @param {number | null} vertex */
  const probe = (vertex) => controller.inspect({ probe: vertex });

  /** @param {number} v */
  const at = (v) => canvas.project(positions().subarray(3 * v, 3 * v + 3));

  /** The neighbour seen in a direction, within 60° of it. @param {[number, number]} direction */
  function walk([x, y]) {
    const probed = shown?.probe;
    const from = probed && at(probed.vertex);
    if (!probed || !from) return;
    let [best, next] = [0.5, probed.vertex];
    for (const { neighbour } of probed.edges) {
      const to = at(neighbour);
      if (!to) continue;
      const [dx, dy] = [to.x - from.x, to.y - from.y];
      const cosine = (dx * x + dy * y) / Math.max(Math.hypot(dx, dy), 1e-9);
      if (cosine > best) [best, next] = [cosine, neighbour];
    }
    if (next !== probed.vertex) probe(next);
  }

  /** @param {Probe["edges"][number]} edge @param {number} vertex */
  function edgeRow({ neighbour, length, beta }, vertex) {
    const row = document.createElement("tr");
    const head = document.createElement("th");
    head.scope = "row";
    const button = document.createElement("button");
    button.type = "button";
    button.className = "small";
    button.textContent = String(neighbour);
    button.ariaLabel = t("Go to vertex {neighbour}", { neighbour });
    button.addEventListener("click", () => probe(neighbour));
    const ends = Uint32Array.of(vertex, neighbour);
    const mark = () => controller.mark({ edges: ends, triangles: new Uint32Array() });
    const unmark = () => controller.mark(null);
    row.addEventListener("pointerenter", mark);
    row.addEventListener("pointerleave", unmark);
    button.addEventListener("focus", mark);
    button.addEventListener("blur", unmark);
    head.append(button);
    row.append(head);
    row.insertCell().textContent = formatNumber(length, 4);
    row.insertCell().textContent = beta === null ? t("none") : degrees(beta);
    return row;
  }

  /** @param {Probe | null} probed @param {number | null} wanted */
  function describe(probed, wanted) {
    none.hidden = wanted === null;
    table.hidden = !probed;
    edges.hidden = !probed;
    if (document.activeElement !== number) number.value = wanted === null ? "" : String(wanted);
    if (!probed) {
      setText(said, wanted === null ? "" : t("There is no vertex {vertex}.", { vertex: wanted }));
      return;
    }
    table.dataset.vertex = String(probed.vertex);
    setText(said, missing(probed));
    const wasInside = edges.contains(document.activeElement);
    const head = (/** @type {string} */ text) => {
      const cell = document.createElement("th");
      cell.scope = "row";
      cell.textContent = text;
      return cell;
    };
    numberRows.replaceChildren(
      ...rowsOf(probed).map(([name, value]) => {
        const row = document.createElement("tr");
        row.append(head(name));
        row.insertCell().textContent = value;
        return row;
      }),
    );
    edgeRows.replaceChildren(...probed.edges.map((edge) => edgeRow(edge, probed.vertex)));
    if (wasInside) edgeRows.querySelector("button")?.focus();
  }

  pick.addEventListener("click", () => take(!isPicking()));
  pick.addEventListener("keydown", (event) => {
    /** @type {Record<string, [number, number]>} */
    const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const way = ways[event.key];
    if (!way) return;
    event.preventDefault();
    if (shown?.probe) walk(way);
    else probe(0);
  });
  section.addEventListener("toggle", () => section.open || take(false));
  number.addEventListener("change", () => {
    if (number.value === "") probe(null);
    else if (number.reportValidity()) probe(number.valueAsNumber);
  });
  none.addEventListener("click", () => probe(null));
  circles.addEventListener("change", () => controller.inspect({ circles: circles.checked }));
  directions.addEventListener("change", () =>
    controller.inspect({ directions: directions.checked }),
  );

  let pressed = { x: 0, y: 0 };
  surface.addEventListener("pointerdown", ({ clientX: x, clientY: y }) => {
    pressed = { x, y };
  });
  surface.addEventListener("click", (event) => {
    const moved = Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y);
    if (!isPicking() || moved > STILL) return;
    const point = canvas.pick(event);
    if (point) probe(nearestVertex(positions(), point));
  });

  return {
    /** @param {Readonly<PageState>} now */
    update(now) {
      const before = state;
      state = now;
      if (isDark(now) !== dark || !before) {
        dark = isDark(now);
        for (const part of key.querySelectorAll("span")) {
          part.style.setProperty("--kind", colourOf(Number(part.dataset.kind), dark));
        }
      }
      const look = (now.preview ?? now.frame)?.look ?? null;
      if (look === shown && now.wanted === before?.wanted) return;
      shown = look;
      circles.checked = now.wanted.circles;
      directions.checked = now.wanted.directions;
      key.hidden = !now.wanted.directions;
      setText(byId("circles-note", HTMLElement), circlesText(look?.circles));
      setText(byId("directions-note", HTMLElement), directionsText(look));
      describe(look?.probe ?? null, now.wanted.probe);
    },
  };
}
