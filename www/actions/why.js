// Why the flow stands as it does, where that is, and what helps.

import { say } from "../words.js";

/** @import { Diagnosis, Remedy } from "../generated/types.js" */
/** @import { Options } from "../options.js" */
/** @import { Core, Offer } from "./core.js" */

/** Triangles with one of these corners. @param {Uint32Array} corners  of all, three each @param {ArrayLike<number>} vertices */
function trianglesAt(corners, vertices) {
  const wanted = new Set(Array.from(vertices));
  const found = [...corners.keys()].filter((k) => wanted.has(corners[k]));
  return new Set(found.map((k) => Math.floor(k / 3)));
}

/** Refusals of a flow, not of a file: their elements are those of the mesh on screen. */
const ofFlows = ["NotTriangular", "ZeroLengthEdge", "SelectionOutOfRange", "Unfit"];

/** @param {Core} core @param {ReturnType<typeof import("./edit.js").createEdit>} edits @param {ReturnType<typeof import("./run.js").createRun>} run */
export function createWhy(core, edits, run) {
  const { get, patch, solver } = core;
  const { edit } = edits;

  /** Other options, from the start or from the surface as it is. @param {Remedy} remedy */
  const change = ({ change, fromStart }) =>
    (fromStart ? core.configure : edits.restart)({ ...get().options, ...change });

  /** All flips that gain anything, and back to the flow. */
  async function flip() {
    const { options } = get();
    await edits.restart({ ...options, flow: "flips", criterion: "localised" });
    await edits.flipAll();
    await edits.adopt(options, say("edit-flips"));
  }

  const { ask, begin, undergo } = core.atRest({
    begin: change,
    /** Opens the card that says why. */
    async ask() {
      if (get().reading) patch({ why: { diagnosis: await solver.ask("why"), isShown: false } });
    },
    /** @param {Remedy} remedy */
    async undergo(remedy) {
      const { id, steps } = remedy;
      const { reading } = get();
      if (!reading) return;
      if (id === "back") await solver.seek(Math.max(reading.step - steps, 0));
      else if (id === "keepAndFlips") await flip();
      else if (Object.keys(remedy.change).length > 0) await change(remedy);
    },
  });

  const why = {
    ask,
    close: () => patch({ why: null, marks: null }),

    /** Marks elements, and turns to them. @param {Pick<Diagnosis, "vertices" | "faces" | "edges">} elements @param {boolean} [turns] */
    point({ vertices, faces, edges }, turns = true) {
      const { mesh } = get();
      const point = core.lead.clip.surface(core.lead.u);
      if (!mesh || !point) return;
      const all = point.drawable?.triangles ?? mesh.triangles;
      const triangles = Uint32Array.from(new Set([...faces, ...trianglesAt(all, vertices)]));
      const edge = trianglesAt(all, edges.subarray(0, 2));
      const near = triangles.length > 0 ? triangles : Uint32Array.from(edge);
      patch({ marks: { edges, triangles, ...(turns && { near }) } });
    },

    /** Carries a remedy out, and goes on with the flow. @param {Remedy} remedy */
    async remedy(remedy) {
      const { id, fromStart } = remedy;
      why.close();
      if (id === "refine") return patch({ tab: "measure", section: "study" });
      if (id === "regularise" && fromStart) await begin(remedy);
      if (id === "regularise") await edit.regularise();
      if (id === "repair") await edit.repair();
      if (id === "subdivide") await edit.subdivide("loop");
      await undergo(remedy);
      if (id !== "back") await run.play();
    },
  };

  core.showRepairs = ({ repaired }) => {
    const kinds = repaired.filter(({ done }) => !done);
    const vertices = Uint32Array.from(new Set(kinds.flatMap((item) => [...item.vertices])));
    const none = new Uint32Array();
    if (vertices.length > 0) why.point({ vertices, faces: none, edges: none }, false);
    const count = kinds.reduce((sum, item) => sum + item.count, 0);
    core.notes.answer(say("repaired-all", { count }));
    patch({ tab: "surface" });
  };

  core.offers = ({ kind, detail, repairs }) => {
    const { mesh, options } = get();
    if (!mesh) return [];
    /** @param {string} label @param {Partial<Options>} edit @returns {Offer} */
    const to = (label, edit) => ({ label, act: () => run.configure(edit) });
    const toCircle = say("remedy-use-flow", { flow: { id: "flow-circle", values: {} } });
    const circle = options.flow === "circle" ? [] : [to(toCircle, { flow: "circle" })];
    const fill = () => patch({ tab: "surface", mode: "fill" });
    const isPart = options.free || options.fixed;
    /** @type {Record<string, Offer[]>} */
    const known = {
      NotClosed: [{ label: say("tool-fill"), act: fill }, ...circle],
      NotOriented: circle,
      NothingFree: [
        to(say("offer-fixed"), { boundary: "fixed" }),
        ...(isPart ? [to(say("offer-free"), { free: null, fixed: null })] : []),
      ],
      TooLarge: [to(say("remedy-recommended-scheme"), { scheme: "auto" })],
    };
    const list = (/** @type {string} */ name) => Uint32Array.from(detail?.[name] ?? []);
    const elements = { vertices: list("vertices"), faces: list("faces"), edges: new Uint32Array() };
    const isHere = ofFlows.includes(kind) && elements.vertices.length + elements.faces.length > 0;
    const place = { label: say("why-show"), act: () => why.point(elements) };
    const repair = { label: say("repair"), act: () => edit.repair() };
    return [
      ...(isHere ? [place] : []),
      ...(repairs?.length ? [repair] : []),
      ...(known[kind] ?? []),
    ];
  };
  return why;
}
