// @ts-check
// A refinement study: a table of energies at several resolutions, with orders and a verdict.
// It has a solver of its own, so that the flow on screen goes on.

/** @import { StudyReport as Study, StudyOptions, Trend } from "../generated/types.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { Solver } from "../solver.js" */

import { LOST } from "../channel.js";
import { samples } from "../generated/library.js";
import { t } from "../language.js";
import { createSolver } from "../solver.js";
import { byId, fillSelect, setText } from "./element.js";
import { formatNumber } from "./number.js";
import { drawOrders } from "./study-plot.js";

/** @type {Readonly<Record<Trend["quantity"], string>>} */
const symbols = {
  area: "A",
  circle: "W/2",
  cotangent: "∫H² cot",
  fitted: "∫H² fit",
  power: "∫|H|^p",
};

/** @param {Trend} trend @param {number} p */
function nameOf({ quantity }, p) {
  if (quantity === "area") return t("The area");
  if (quantity === "circle") return "W/2";
  if (quantity === "cotangent") return t("∫H² by cotangents");
  if (quantity === "fitted") return t("∫H² by quadratic fits");
  return `∫|H|^${p}`;
}

/** What a quantity does, in one sentence. @param {Trend} trend @param {number} p */
function finding(trend, p) {
  const { tendency, smooth, isKnown, values } = trend;
  const last = values.at(-1) ?? 0;
  const order = trend.orders.at(-1);
  const said = {
    name: nameOf(trend, p),
    smooth: formatNumber(smooth, 5),
    order: order === null || order === undefined ? "–" : order.toFixed(1),
    ratio: smooth ? formatNumber(last / smooth, 3) : "–",
  };
  if (tendency === "exact") return t("{name} is right at every resolution, up to roundoff.", said);
  if (tendency === "converges" && isKnown) {
    return t("{name} tends to the smooth value {smooth}; observed order {order}.", said);
  }
  if (tendency === "converges" && smooth !== null) {
    return t("{name} tends to ∫(H²−K) dA, {smooth} by quadratic fits on the finest mesh.", said);
  }
  if (tendency === "converges") return t("{name} settles; observed order {order}.", said);
  if (tendency === "elsewhere" && smooth) {
    return t(
      "{name} does not tend to the smooth value {smooth}, but to about {ratio} times it.",
      said,
    );
  }
  if (tendency === "elsewhere") {
    return t("{name} settles, but not at the smooth value {smooth}.", said);
  }
  if (tendency === "diverges") {
    return t("{name} does not settle: each refinement changes it as much as the one before.", said);
  }
  return t("Of {name} two resolutions tell no more.", said);
}

/** @param {Study} study */
function findings({ manner, trends, p }) {
  const circle = trends.find(({ quantity }) => quantity === "circle")?.tendency;
  return [
    ...trends.map((trend) => finding(trend, p)),
    ...(manner === "polyhedron"
      ? [
          t(
            "The curvature of a polyhedron sits in its edges: split faces resolve them ever more " +
              "sharply, and every Willmore energy grows like 1/h.",
          ),
        ]
      : []),
    ...(circle === "elsewhere" || circle === "diverges"
      ? [
          t(
            "The circle-angle energy tends to the smooth one only where the edges follow the " +
              "lines of curvature in a right-angled lattice. On other lattices its limit is " +
              "larger, and where triangles are not Delaunay it has none (Bobenko and Schröder " +
              "2005, section 2). Compare it between steps, not between meshes.",
          ),
        ]
      : []),
    t(
      "That values converge on given meshes does not make minimisers converge: minimising any " +
        "piecewise-linear Willmore energy proposed so far fails to converge to a solution of the " +
        "smooth problem (Chen, Yu, Brogan, Kusner, Yang and Zigerelli, arXiv 1901.09990).",
    ),
  ];
}

/** @param {Study} study */
function mannerText({ manner, rows, mostVertices }) {
  const said = { most: mostVertices, found: rows.at(-1)?.vertices ?? 0 };
  if (manner === "sampled") {
    return t("The smooth shape, sampled anew at each resolution; {most} vertices at most.", said);
  }
  if (manner === "polyhedron") {
    return t("The polyhedron, its faces split into four each time; {most} vertices at most.", said);
  }
  return t(
    "The limit surface of Loop’s scheme with this mesh as its control mesh, which lies a little " +
      "inside: edges split at their midpoints would get no closer to a smooth surface. {most} " +
      "vertices at most.",
    said,
  );
}

/** @param {Controller} controller */
export function createStudy(controller) {
  const section = byId("study", HTMLDetailsElement);
  const subject = byId("study-subject", HTMLSelectElement);
  const start = byId("study-run", HTMLButtonElement);
  const cancel = byId("study-cancel", HTMLButtonElement);
  const status = byId("study-status", HTMLElement);
  const result = byId("study-result", HTMLElement);
  const manner = byId("study-manner", HTMLElement);
  const head = byId("study-head", HTMLTableSectionElement);
  const rows = byId("study-rows", HTMLTableSectionElement);
  const foot = byId("study-foot", HTMLTableSectionElement);
  const plot = byId("study-plot", SVGSVGElement);
  const list = byId("study-findings", HTMLUListElement);

  /** @type {Readonly<PageState> | null} */
  let state = null;
  /** @type {Solver | null} */
  let solver = null;

  /** @param {Readonly<PageState> | null} now */
  function sampleOf(now) {
    const source = now?.source;
    return source?.kind === "sample" ? samples.find(({ id }) => id === source.id) : undefined;
  }

  /** @param {HTMLTableSectionElement} section @param {string} first @param {string[]} cells */
  function addRow(section, first, cells) {
    const row = section.insertRow();
    const head = document.createElement("th");
    head.scope = "row";
    head.textContent = first;
    row.append(head);
    for (const text of cells) row.insertCell().textContent = text;
    return row;
  }

  /** @param {Study} study */
  function show(study) {
    result.hidden = false;
    setText(manner, mannerText(study));
    const header = document.createElement("tr");
    for (const text of [t("Vertices"), "h", ...study.trends.map((one) => symbols[one.quantity])]) {
      const cell = document.createElement("th");
      cell.scope = "col";
      cell.textContent = text;
      header.append(cell);
    }
    head.replaceChildren(header);
    rows.replaceChildren();
    study.rows.forEach(({ vertices, h }, k) => {
      const row = addRow(rows, String(vertices), [formatNumber(h, 3)]);
      for (const { values, orders } of study.trends) {
        const cell = row.insertCell();
        cell.textContent = formatNumber(values[k], 5);
        const order = orders[k];
        if (order === null) continue;
        const small = document.createElement("div");
        small.className = "order";
        small.textContent = t("order {order}", { order: order.toFixed(2) });
        cell.append(small);
      }
    });
    foot.replaceChildren();
    if (study.trends.some(({ smooth }) => smooth !== null)) {
      const smooth = study.trends.map((one) => {
        const text = one.smooth === null ? "–" : formatNumber(one.smooth, 5);
        return one.isKnown || one.smooth === null ? text : `≈ ${text}`;
      });
      addRow(foot, t("Smooth"), ["0", ...smooth]);
    }
    plot.toggleAttribute("hidden", !drawOrders(plot, study, symbols));
    list.replaceChildren(
      ...(study.finished ? findings(study) : []).map((text) => {
        const item = document.createElement("li");
        item.textContent = text;
        return item;
      }),
    );
  }

  function end() {
    solver?.dismiss();
    solver = null;
    start.hidden = false;
    cancel.hidden = true;
  }

  async function run() {
    if (solver || !state?.mesh) return;
    const own = createSolver({
      onReady: () => {},
      onFrame: () => {},
      onStopped: () => {},
      onProgress: () => {},
      // It can be cancelled at any time.
      onSilent: () => {},
      onCrashed: (reason) => {
        setText(status, t("The study stopped unexpectedly ({reason}).", { reason }));
        end();
      },
    });
    solver = own;
    start.hidden = true;
    cancel.hidden = false;
    result.hidden = true;
    setText(status, t("Preparing the surface…"));
    const { options } = state;
    const p = options.flow === "p-willmore" ? options.p : 2;
    const sample = subject.value === "shape" ? sampleOf(state) : undefined;
    try {
      /** @type {Partial<StudyOptions>} */
      let asked = { p };
      if (sample) asked = { shape: sample.shape, parameters: sample.parameters, p };
      else {
        const { name, bytes } = await controller.presentSurface();
        if (solver !== own) return;
        await own.load(name, new Uint8Array(bytes));
      }
      /** @type {Partial<StudyOptions> | null} */
      let next = asked;
      for (let level = 1; ; level += 1) {
        setText(status, t("Measuring resolution {level}…", { level }));
        const study = await own.study(next);
        if (solver !== own) return;
        next = null;
        show(study);
        if (study.finished) break;
      }
      setText(status, t("Done."));
      end();
    } catch (error) {
      const { kind, message } = /** @type {import("../words.js").Fault} */ (error);
      if (solver !== own || kind === LOST) return;
      setText(status, message);
      end();
    }
  }

  start.addEventListener("click", run);
  cancel.addEventListener("click", () => {
    setText(status, t("Cancelled."));
    end();
    start.focus();
  });

  return {
    /** Opens the section and studies the surface as it is. */
    begin() {
      section.open = true;
      section.scrollIntoView({ block: "nearest" });
      section.querySelector("summary")?.focus();
      run();
    },
    /** @param {Readonly<PageState>} now */
    update(now) {
      const before = state;
      state = now;
      if (now.source === before?.source && now.mesh === before?.mesh) return;
      const sample = sampleOf(now);
      const shape = { id: "shape", label: t("The sample, at its start") };
      const present = { id: "surface", label: t("The surface as it is now") };
      fillSelect(subject, sample && !sample.fill ? [shape, present] : [present]);
      // What was measured was another surface.
      if (solver) end();
      setText(status, "");
      result.hidden = true;
      start.ariaDisabled = String(now.mesh === null);
    },
  };
}
