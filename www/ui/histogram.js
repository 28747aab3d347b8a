// @ts-check
// How the values that colour the surface are spread over its vertices.

/** @import { Field } from "../state.js" */
/** @import { PageState } from "../state.js" */

import { t } from "../language.js";
import { colourLabel } from "./colour-bar.js";
import { byId, setText } from "./element.js";
import { formatNumber, formatShort } from "./number.js";

/** Bars of the histogram. */
const BARS = 40;
/** How far bars reach beyond the scale of colours, in lengths of it. */
const BEYOND = 0.15;

/**
 * Vertices by value in equal bars over the scale of colours and somewhat beyond; the first and the
 * last also hold what lies farther out. Values that are not finite count nowhere.
 * @param {Pick<Field, "values" | "low" | "high">} field
 */
export function histogram({ values, low, high }) {
  const reach = BEYOND * (high - low);
  let [least, most, sum, count] = [Infinity, -Infinity, 0, 0];
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    if (value < least) least = value;
    if (value > most) most = value;
    sum += value;
    count += 1;
  }
  const from = Math.max(low - reach, Math.min(least, low));
  const to = Math.min(high + reach, Math.max(most, high));
  const counts = new Uint32Array(BARS);
  const scale = BARS / (to - from);
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    counts[Math.min(Math.max(Math.floor((value - from) * scale), 0), BARS - 1)] += 1;
  }
  return { counts, from, to, least, most, mean: sum / count, count };
}

/** @param {(signed: boolean, count: number) => Uint8Array | null} colours  rgb, as the surface is painted */
export function createHistogram(colours) {
  const section = byId("look", HTMLDetailsElement);
  const note = byId("histogram-note", HTMLElement);
  const canvas = byId("histogram-bars", HTMLCanvasElement);
  const table = byId("histogram-table", HTMLTableElement);
  const rows = byId("histogram-rows", HTMLElement);
  const bins = byId("histogram-bins", HTMLDetailsElement);
  const binRows = byId("histogram-bin-rows", HTMLElement);

  /** @type {Field | null} */
  let field = null;
  /** @type {Field | null | undefined} what is told of; undefined before anything is */
  let drawn;

  /** @param {Field} of @param {ReturnType<typeof histogram>} bars */
  function paint(of, { counts, from, to }) {
    const context = canvas.getContext("2d");
    if (!context) return;
    const { width, height } = canvas;
    const palette = colours(of.signed, 256);
    const tallest = Math.max(...counts, 1);
    const colour = getComputedStyle(canvas).color;
    context.clearRect(0, 0, width, height);
    const room = height - 10;
    for (const [n, count] of counts.entries()) {
      const value = from + ((n + 0.5) * (to - from)) / BARS;
      const share = Math.min(Math.max((value - of.low) / (of.high - of.low), 0), 1);
      const k = 3 * Math.round(255 * share);
      context.fillStyle = palette
        ? `rgb(${palette[k]} ${palette[k + 1]} ${palette[k + 2]})`
        : colour;
      // One vertex is a line at least.
      const tall = count === 0 ? 0 : Math.max((room * count) / tallest, 2);
      const [x, wide] = [(n * width) / BARS, width / BARS - 2];
      context.fillRect(x, height - tall, wide, tall);
      context.globalAlpha = 0.35;
      context.strokeStyle = colour;
      if (tall > 0) context.strokeRect(x + 0.5, height - tall + 0.5, wide - 1, tall - 1);
      context.globalAlpha = 1;
    }
    // The ends of the scale of colours: the 2nd and the 98th percentile.
    context.strokeStyle = colour;
    context.lineWidth = 2;
    context.setLineDash([6, 4]);
    for (const end of [of.low, of.high]) {
      const x = ((end - from) / (to - from)) * width;
      context.beginPath();
      context.moveTo(x, 0);
      context.lineTo(x, height);
      context.stroke();
    }
    context.setLineDash([]);
    context.lineWidth = 1;
  }

  /** @param {string} name @param {string} value */
  function row(name, value) {
    const element = document.createElement("tr");
    const head = document.createElement("th");
    head.scope = "row";
    head.textContent = name;
    element.append(head);
    element.insertCell().textContent = value;
    return element;
  }

  function show() {
    if (!section.open || field === drawn) return;
    drawn = field;
    for (const part of [canvas, table, bins]) part.hidden = !field;
    if (!field) {
      setText(note, t("Choose what to colour by, and its values are counted here."));
      return;
    }
    setText(note, t("{label}: dashed are the ends of the colours.", { label: colourLabel(field) }));
    const bars = histogram(field);
    paint(field, bars);
    const { least, most, mean, count, from, to, counts } = bars;
    canvas.ariaLabel = t("Histogram of {label}: {count} vertices from {least} to {most}", {
      label: colourLabel(field),
      count,
      least: formatShort(least),
      most: formatShort(most),
    });
    rows.replaceChildren(
      row(t("Least"), formatNumber(least, 5)),
      row(
        field.signed ? t("Colours, symmetric about 0") : t("Colours, 2nd to 98th percentile"),
        `${formatShort(field.low)} … ${formatShort(field.high)}`,
      ),
      row(t("Mean over vertices"), formatNumber(mean, 5)),
      row(t("Greatest"), formatNumber(most, 5)),
    );
    const edge = (/** @type {number} */ n) => from + (n * (to - from)) / BARS;
    binRows.replaceChildren(
      ...[...counts].map((vertices, n) => {
        const element = document.createElement("tr");
        // What lies farther out is in the bars at the ends.
        const ends = [n === 0 ? least : edge(n), n === BARS - 1 ? most : edge(n + 1)];
        for (const end of ends) element.insertCell().textContent = formatShort(end);
        element.insertCell().textContent = String(vertices);
        return element;
      }),
    );
  }

  section.addEventListener("toggle", show);
  return {
    /** @param {Readonly<PageState>} state */
    update({ preview, frame }) {
      field = (preview ?? frame)?.field ?? null;
      show();
    },
  };
}
