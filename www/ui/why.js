// @ts-check
// Why did this happen? A sentence under the status line once the flow rests, the place on
// the surface, and what helps as buttons. Refusals get the last two beside their message.

/** @import { Diagnosis, Fault, Remedy } from "../generated/types.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { facing, vectorArea } from "../facing.js";
import { t } from "../language.js";
import { say } from "../words.js";
import { byId, setText } from "./element.js";

/** Milliseconds of rest before it is asked why: steps taken one by one are not held up. */
const REST = 150;

/** What is said only when asked: nothing is wrong there. */
const calm = ["RejectedSteps", "StepLimit", "NotAtRest"];

/**
 * @param {Controller} controller
 * @param {ReturnType<typeof import("./messages.js").createMessages>} messages
 * @param {{ camera: () => Float32Array | null, study: () => void }} parts
 */
export function createWhy(controller, messages, { camera, study }) {
  const box = byId("why", HTMLElement);
  const ask = byId("why-ask", HTMLButtonElement);
  const answer = byId("why-answer", HTMLElement);
  const sentence = byId("why-sentence", HTMLElement);
  const show = byId("why-show", HTMLButtonElement);
  const remedies = byId("why-remedies", HTMLElement);

  /** @type {Readonly<PageState> | null} */
  let state = null;
  /** @type {PageState["reading"]} of which it was asked */
  let asked = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;
  /** @type {Diagnosis | null} */
  let diagnosis = null;
  /** @type {PageState["marks"]} made here, to be taken away here */
  let marked = null;

  /** Triangles with one of these corners. @param {ArrayLike<number>} vertices */
  function trianglesAt(vertices) {
    const corners = state?.mesh?.triangles ?? new Uint32Array();
    const wanted = new Set(Array.from(vertices));
    const found = new Set();
    corners.forEach((v, k) => {
      if (wanted.has(v)) found.add(Math.floor(k / 3));
    });
    return Uint32Array.from(found);
  }

  /**
   * Marks elements, and turns to them.
   * @param {Pick<Diagnosis, 'vertices' | 'faces' | 'edges'>} elements
   */
  function point({ vertices, faces, edges }) {
    const own = new Set([...faces, ...trianglesAt(vertices)]);
    const triangles = Uint32Array.from(own);
    marked = { edges, triangles };
    controller.mark(marked);
    const positions = state?.frame?.positions;
    const corners = state?.mesh?.triangles;
    const from = camera();
    if (!positions || !corners || !from) return;
    const near = triangles.length > 0 ? triangles : trianglesAt(edges.subarray(0, 2));
    const turned = facing(from, vectorArea(positions, corners, near));
    if (turned) controller.look(turned);
  }

  function unmark() {
    show.ariaPressed = "false";
    if (marked && state?.marks === marked) controller.mark(null);
    marked = null;
  }

  /** @param {boolean} open */
  function disclose(open) {
    answer.hidden = !open;
    ask.ariaExpanded = String(open);
    if (!open) unmark();
  }

  /** @param {Remedy} remedy */
  function carryOut(remedy) {
    unmark();
    if (remedy.id === "refine") study();
    else controller.remedy(remedy);
  }

  /** @param {Diagnosis | null} found */
  function tell(found) {
    diagnosis = found;
    unmark();
    box.hidden = found === null;
    if (!found) return;
    setText(sentence, say(found.message));
    const elements = found.vertices.length + found.faces.length + found.edges.length;
    show.hidden = elements === 0;
    remedies.replaceChildren(
      ...found.remedies.map((remedy) => button(say(remedy.label), () => carryOut(remedy))),
    );
    disclose(!calm.includes(found.kind));
  }

  async function inquire() {
    const reading = state?.reading ?? null;
    try {
      const found = await controller.why();
      if (reading === state?.reading) tell(found);
    } catch {
      // Whoever ended the solver has said so.
      tell(null);
    }
  }

  ask.addEventListener("click", () => disclose(answer.hidden === true));
  show.addEventListener("click", () => {
    if (show.ariaPressed === "true") return unmark();
    if (!diagnosis) return;
    point(diagnosis);
    show.ariaPressed = "true";
  });

  /** What helps against a refusal of a mesh that is on screen. @param {Fault} fault */
  function offers({ kind, detail }) {
    if (!state?.mesh) return [];
    const { flow, free, fixed } = state.options;
    const configured = (/** @type {Partial<PageState["options"]>} */ change) => () =>
      controller.configure(change);
    const circle = {
      label: t("Use the circle-angle Willmore flow"),
      act: configured({ flow: "circle" }),
    };
    /** @type {Record<string, { label: string, act: () => unknown }[]>} */
    const known = {
      NotClosed: [
        { label: t("Fill holes"), act: openHoles },
        ...(flow === "circle" ? [] : [circle]),
      ],
      NotOriented: flow === "circle" ? [] : [circle],
      NothingFree: [
        { label: t("Use fixed boundary"), act: configured({ boundary: "fixed" }) },
        ...(free || fixed
          ? [{ label: t("Free what the flow frees"), act: configured({ free: null, fixed: null }) }]
          : []),
      ],
      TooLarge: [{ label: t("Use the recommended scheme"), act: configured({ scheme: "auto" }) }],
    };
    const list = (/** @type {string} */ name) =>
      Uint32Array.from(/** @type {number[]} */ (detail?.[name] ?? []));
    const elements = { vertices: list("vertices"), faces: list("faces"), edges: new Uint32Array() };
    const isHere = refusals.includes(kind) && elements.vertices.length + elements.faces.length > 0;
    const place = { label: t("Show"), act: () => point(elements) };
    return [...(isHere ? [place] : []), ...(known[kind] ?? [])];
  }
  messages.offer(offers);

  return {
    /** @param {Readonly<PageState>} now */
    update(now) {
      state = now;
      const { phase, reading } = now;
      const rests = phase === "paused" && reading !== null && reading.flips === null;
      if (rests && reading === asked) return;
      clearTimeout(waiting);
      if (asked !== null || diagnosis) {
        asked = null;
        if (diagnosis) tell(null);
      }
      if (!rests) return;
      asked = reading;
      waiting = setTimeout(inquire, REST);
    },
  };
}

/** Refusals of a flow, not of a file: their elements are those of the mesh on screen. */
const refusals = ["NotTriangular", "ZeroLengthEdge", "SelectionOutOfRange", "Unfit"];

function openHoles() {
  const holes = byId("holes", HTMLDetailsElement);
  holes.open = true;
  holes.scrollIntoView({ block: "nearest" });
  holes.querySelector("summary")?.focus();
}

/** @param {string} label @param {() => unknown} act */
function button(label, act) {
  const made = document.createElement("button");
  made.type = "button";
  made.className = "small";
  made.textContent = label;
  made.addEventListener("click", act);
  return made;
}
