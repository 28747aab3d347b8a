// The page inside another one: answers what that asks, tells what happens, and rests while
// nobody sees it. Works only in an address with `?embed`.

/** @import { Page } from "../actions.js" */
/** @import { SurfaceState } from "../element.js" */
/** @import { Request } from "./messages.js" */

import "../style/embed.css";
import { linkIn, sceneOf } from "../link.js";
import { contents, fileName } from "../save.js";
import { pageAddress } from "../share.js";
import { fault, say } from "../words.js";
import * as messages from "./messages.js";

/** Requests that wait for nothing that was asked before. */
const isImmediate = ["pause", "state"];

/** @param {Page} page */
export function createEmbedding(page) {
  const { get, run, open, notes, player } = page;
  const asked = new URLSearchParams(location.search);
  const root = document.documentElement;
  root.classList.add("embedded");
  root.classList.toggle("bare", asked.get("controls") === "none");
  /** A way to the whole page, with the scene as it is. */
  const fullPage = Object.assign(document.createElement("a"), {
    ...{ className: "full-page", target: "_blank", rel: "noopener" },
    ...{ textContent: say("full-page"), title: say("full-page.title") },
    href: pageAddress(location) + location.hash,
  });
  document.getElementById("stage")?.append(fullPage);
  const isMoving = () => get().running || player.motion.peek() !== "still";

  const host = window.parent === window ? null : window.parent;
  /** Whoever embeds, once it has spoken; events hold nothing of a mesh but its numbers. */
  let origin = "*";

  /** @param {Record<string, unknown>} message @param {Transferable[]} [transfer] */
  function post(message, transfer = []) {
    host?.postMessage({ umbilic: messages.PROTOCOL, ...message }, origin, transfer);
  }
  /** @param {string} event @param {object} [detail] */
  const tell = (event, detail = {}) => post({ event, detail });

  /** A run that rests until it is seen. */
  let isSuspended = false;
  let isIntersecting = false;
  const isSeen = () => isIntersecting && document.visibilityState === "visible";

  /** @returns {SurfaceState["phase"]} */
  function phaseNow() {
    const { phase } = get();
    if (phase !== "ready") return phase;
    if (isMoving()) return "running";
    const shown = page.shown();
    return shown && shown.step === 0 && shown.status === "ready" ? "ready" : "paused";
  }

  /** Where it stands. @returns {SurfaceState} */
  function surfaceState() {
    const { mesh, options, version, extras } = get();
    const reading = page.shown();
    const { step = 0, time = 0, energy = null, area = null, status = null } = reading ?? {};
    const { volume = null, message = null } = reading ?? {};
    const { vertices = 0, faces = 0 } = mesh?.info ?? {};
    return {
      ...{ step, time, energy, area, volume, status, message: message ? say(message) : "" },
      canStepBack: page.lead.u > 0 || (reading?.canStepBack ?? false),
      jump: extras?.jump?.relative ?? null,
      ...{ phase: phaseNow(), isWaiting: isSuspended, flow: options.flow, version },
      ...{ name: mesh?.name ?? null, vertices, faces },
    };
  }

  // Errors are shown here and told there.
  /** @type {Set<{ message: string, hint: string }[]>} */
  const hearing = new Set();
  const show = notes.error;
  notes.error = (said, offers) => {
    show(said, offers);
    const { message, hint } = said;
    for (const list of hearing) list.push({ message, hint });
    // What goes wrong with a request is its answer.
    if (hearing.size === 0) tell("error", { message, hint });
  };

  let isPausing = false;
  /** Lets a run rest while nobody sees it, and go on after. */
  function settle() {
    const { phase, goal } = get();
    // On the way to a step it goes on: somebody waits for that.
    if (!isSeen() && isMoving() && goal === null && player.motion.peek() !== "easing") {
      // Once: a run comes to rest only after the step it is in, and what is shown until then
      // leads here again.
      if (isPausing) return;
      [isPausing, isSuspended] = [true, true];
      run.pause().finally(() => {
        isPausing = false;
        settle();
      });
    } else if (isSeen() && isSuspended && !isMoving() && phase === "ready") {
      isSuspended = false;
      run.play();
    }
  }

  /** @type {(value?: unknown) => void} */
  let want = () => {};
  const wanted = new Promise((resolve) => {
    want = resolve;
  });
  function look() {
    if (isSeen()) want();
    settle();
  }
  new IntersectionObserver((entries) => {
    isIntersecting = entries[entries.length - 1].isIntersecting;
    look();
  }).observe(root);
  document.addEventListener("visibilitychange", look);
  // Slides that embed it are turned with these, also by a clicker.
  addEventListener("keydown", ({ key }) => {
    if (key === "PageUp" || key === "PageDown") tell("key", { key });
  });

  /** A scene is there. */
  function arrived() {
    if (!get().mesh) return;
    isSuspended = asked.has("autoplay");
    tell("ready", surfaceState());
    settle();
  }

  /**
   * To the nearest stored step that is not beyond, and on from there: the same steps give the
   * same surface.
   * @param {number} step  less if the flow ends before
   */
  async function seek(step) {
    await run.pause();
    const { timeline } = get();
    if (!timeline) return;
    const { start, first, last } = timeline;
    await run.seek(step < first ? start : Math.min(step, last));
    if (step <= (get().reading?.step ?? 0)) return;
    await run.runTo(step);
    await open.still();
  }

  const move = (/** @type {"pause" | "step" | "back" | "reset"} */ name) => async () => {
    isSuspended = false;
    await run[name]();
  };

  /** What each request does; it is answered with where the surface stands, or with what is told. @type {Record<string, (request: Request) => Promise<any>>} */
  const answers = {
    async load(request) {
      const file = messages.fileOf(request);
      const address = { search: "", hash: messages.asHash(request.scene ?? "") };
      if (file) await open.open([file], (await open.readLink(address)) ?? {});
      else await open.openLink(address);
      await open.still();
      arrived();
    },
    async play() {
      isSuspended = !isSeen();
      if (!isSuspended) await run.play();
    },
    pause: move("pause"),
    async seek(request) {
      const step = messages.stepOf(request);
      isSuspended = false;
      await seek(step);
    },
    async set({ words }) {
      const { hash, named } = messages.wordsToSet(words);
      const scene = sceneOf(await page.solver.ask("readLink", linkIn({ search: "", hash })));
      const { options, arrangement, colour, camera, view, step } = scene;
      if (Object.keys(options).length > 0) await run.configure(options, { fromStart: true });
      if (Object.keys(arrangement).length > 0) await run.arrange(arrangement);
      if (named.has("colour")) await run.colour(colour);
      run.view(view);
      if (camera) page.patch({ camera });
      if (named.has("step")) await seek(step);
    },
    state: async () => {},
    step: move("step"),
    back: move("back"),
    reset: move("reset"),
    async export(request) {
      const asked = messages.formatOf(request);
      const shown = get();
      if (!shown.mesh) throw fault("NoMesh", "no-mesh-yet", {}, "");
      const { format, blob } = await contents(page, asked);
      return { name: fileName(shown, format), bytes: new Uint8Array(await blob.arrayBuffer()) };
    },
  };

  // In the order in which they were asked.
  let turn = Promise.resolve();
  let waiting = 0;
  addEventListener("message", (event) => {
    if (!host || event.source !== host) return;
    const request = messages.asRequest(event.data);
    if (!request) return;
    // A page from a file, or in a sandbox, has no origin that could be named.
    origin = event.origin === "null" ? "*" : event.origin;
    if (isImmediate.includes(request.type)) return void answer(request);
    const most = messages.MOST_WAITING;
    if (waiting === most) {
      return refuse(request, fault("TooManyRequests", "too-many-requests", { most }));
    }
    want();
    waiting += 1;
    turn = turn
      .then(() => loaded)
      .then(() => answer(request))
      .finally(() => {
        waiting -= 1;
      });
  });

  /** @param {Request} request @param {any} error */
  function refuse({ id }, { kind = "Refused", message, hint = "" }) {
    post({ id, error: { kind, message: String(message), hint } });
  }

  /** @param {Request} request */
  async function answer(request) {
    const { id, type } = request;
    /** @type {{ message: string, hint: string }[]} */
    const faults = [];
    try {
      if (!Object.hasOwn(answers, type)) throw messages.unknownRequest(type, Object.keys(answers));
      hearing.add(faults);
      const told = await answers[type](request).finally(() => hearing.delete(faults));
      if (faults.length > 0) throw faults[0];
      post({ id, ok: told ?? surfaceState() }, told ? [told.bytes.buffer] : []);
    } catch (error) {
      refuse(request, error);
    }
  }

  /** @type {unknown} */
  let told = null;
  /** @type {string | null} */
  let phase = null;
  /** @type {Promise<unknown>} the scene of the address */
  let loaded = Promise.resolve();
  return {
    /** Settled once it is seen, or something is asked of it: until then no solver is needed. */
    wanted,
    /** Whether the mesh comes from whoever embeds, and not from the address. */
    isFed: asked.has("wait"),

    /** Once the page listens. @param {Promise<unknown>} opened  the scene of the address */
    begin(opened) {
      const theme = asked.get("theme");
      if (theme === "light" || theme === "dark") run.view({ theme });
      loaded = opened.then(open.still).then(arrived, page.report);
      tell("listening", { version: get().version });
    },

    /** The scene has this address now. @param {string} hash */
    linkTo(hash) {
      fullPage.href = pageAddress(location) + hash;
    },

    /** Tells what is new. */
    update() {
      const { reading, phase: loaded } = get();
      // Between two flows there is nothing to tell.
      if (page.lead.clip.points.length === 0 && loaded === "ready") return;
      const shown = page.shown();
      if (shown !== told && reading && loaded !== "loading") {
        told = shown;
        tell("frame", surfaceState());
      }
      const now = phaseNow();
      if (now !== phase) {
        phase = now;
        tell("statechange", surfaceState());
      }
      // After everybody has been told of this state.
      queueMicrotask(settle);
    },
  };
}
