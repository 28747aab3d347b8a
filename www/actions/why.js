// @ts-check
// Why the flow stands as it does, where that is, and what helps.

import { facing, trianglesAt, vectorArea } from "../facing.js";
import { say } from "../words.js";
import { stepsOf } from "./run.js";

/** @import { Diagnosis, Remedy } from "../generated/types.js" */
/** @import { Fault } from "../words.js" */
/** @import { Core } from "./core.js" */

/** Refusals of a flow, not of a file: their elements are those of the mesh on screen. */
const ofFlows = ["NotTriangular", "ZeroLengthEdge", "SelectionOutOfRange", "Unfit"];

/**
 * @param {Core} core
 * @param {ReturnType<typeof import("./edit.js").createEdit>} edits
 * @param {ReturnType<typeof import("./run.js").createRun>} run
 */
export function createWhy(core, { adopt, edit }, run) {
  const { get, patch, solver, enqueue, rest } = core;

  /** Other options, from the start or from the surface as it is. @param {Remedy} remedy */
  async function change(remedy) {
    const { options, reading } = get();
    const wanted = { ...options, ...remedy.change };
    if (remedy.fromStart || !reading || reading.step === 0) await core.configure(wanted);
    else await adopt(wanted, stepsOf(reading.step));
  }

  /** All flips that gain anything, and back to the flow. */
  async function flip() {
    const { options, reading, arrangement } = get();
    const flips = /** @type {const} */ ({ flow: "flips", criterion: "localised" });
    await adopt({ ...options, ...flips }, stepsOf(reading?.step ?? 0));
    await solver.arrange({ ...arrangement, flipsPerStep: null });
    await solver.step();
    await solver.arrange(arrangement);
    await adopt(options, say("edit-flips"));
  }

  const why = {
    /** Opens the card that says why. */
    ask: () =>
      enqueue(async () => {
        await rest();
        if (get().reading) patch({ why: { diagnosis: await solver.why(), isShown: false } });
      }),
    close: () => patch({ why: null, marks: null }),

    /**
     * Marks elements, and turns to them.
     * @param {Pick<Diagnosis, "vertices" | "faces" | "edges">} elements
     * @param {Float32Array | null} camera
     */
    point({ vertices, faces, edges }, camera) {
      const { mesh } = get();
      const point = core.lead.clip.surface(core.lead.u);
      if (!mesh || !point?.positions) return;
      const { positions } = point;
      const all = point.drawable?.triangles ?? mesh.triangles;
      const triangles = Uint32Array.from(new Set([...faces, ...trianglesAt(all, vertices)]));
      patch({ marks: { edges, triangles } });
      const near = triangles.length > 0 ? triangles : trianglesAt(all, edges.subarray(0, 2));
      const turned = camera && facing(camera, vectorArea(positions, all, near));
      if (turned) patch({ camera: turned });
    },

    /** Carries a remedy out, and goes on with the flow. @param {Remedy} remedy */
    async remedy(remedy) {
      why.close();
      if (remedy.id === "refine") return patch({ tab: "measure", section: "study" });
      if (remedy.id === "regularise") {
        if (remedy.fromStart) await enqueue(() => rest().then(() => change(remedy)));
        await edit.regularise();
      }
      if (remedy.id === "repair") await edit.repair();
      if (remedy.id === "subdivide") await edit.subdivide("loop");
      await enqueue(async () => {
        await rest();
        const { reading } = get();
        if (!reading) return;
        if (remedy.id === "back")
          return void (await solver.seek(Math.max(reading.step - remedy.steps, 0)));
        if (remedy.id === "keepAndFlips") await flip();
        else if (Object.keys(remedy.change).length > 0) await change(remedy);
      });
      if (remedy.id !== "back") await run.play();
    },
  };

  core.showRepairs = ({ repaired }) => {
    const kinds = repaired.filter(({ done }) => !done);
    const vertices = Uint32Array.from(new Set(kinds.flatMap((item) => [...item.vertices])));
    const none = new Uint32Array();
    if (vertices.length > 0) why.point({ vertices, faces: none, edges: none }, null);
    const count = kinds.reduce((sum, item) => sum + item.count, 0);
    core.notes.answer(say("repaired-all", { count }));
    patch({ tab: "surface" });
  };

  /** What helps against a refusal of a mesh that is on screen. @param {Fault} fault */
  core.offers = ({ kind, detail, repairs }) => {
    const { mesh, options } = get();
    if (!mesh) return [];
    const { flow, free, fixed } = options;
    const circle =
      flow === "circle"
        ? []
        : [
            {
              label: say("remedy-use-flow", { flow: { id: "flow-circle", values: {} } }),
              act: () => run.configure({ flow: "circle" }),
            },
          ];
    const fill = () => patch({ tab: "surface", mode: "fill" });
    /** @type {Record<string, { label: string, act: () => unknown }[]>} */
    const known = {
      NotClosed: [{ label: say("tool-fill"), act: fill }, ...circle],
      NotOriented: circle,
      NothingFree: [
        { label: say("offer-fixed"), act: () => run.configure({ boundary: "fixed" }) },
        ...(free || fixed
          ? [{ label: say("offer-free"), act: () => run.configure({ free: null, fixed: null }) }]
          : []),
      ],
      TooLarge: [
        { label: say("remedy-recommended-scheme"), act: () => run.configure({ scheme: "auto" }) },
      ],
    };
    const list = (/** @type {string} */ name) => Uint32Array.from(detail?.[name] ?? []);
    const elements = { vertices: list("vertices"), faces: list("faces"), edges: new Uint32Array() };
    const isHere = ofFlows.includes(kind) && elements.vertices.length + elements.faces.length > 0;
    const place = { label: say("why-show"), act: () => why.point(elements, get().camera) };
    const repair = repairs?.length ? [{ label: say("repair"), act: () => edit.repair() }] : [];
    return [...(isHere ? [place] : []), ...repair, ...(known[kind] ?? [])];
  };
  return why;
}
