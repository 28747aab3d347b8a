// <umbilic-surface>: a scene of Umbilic in any page. One script, without any others:
//
//   <script type="module" src="https://…/embed.js"></script>
//   <umbilic-surface sample="pipe" colour="mean-curvature" autoplay></umbilic-surface>
//
// Attributes are the words of a link (`flow`, `p`, `step`, `camera`, …; `smoothSteps` is written
// `smooth-steps`), and those of `own` below. Methods return promises; events are
// `ready`, `frame`, `statechange`, `error` and `key` (Page Up or Down, pressed in the surface);
// what they tell is in `detail`. `element.d.ts` has the types of all of it.

/** @import { UmbilicSurface as Typed } from "./element.js" */

/**
 * Attributes that are no words of a link: `mesh`, the address of a mesh file, which the
 * embedding page fetches; `controls="none"`, no buttons; `autoplay`, plays once it is seen;
 * `theme`, light or dark, else as the system; `page`, the address of Umbilic, where this script
 * was copied elsewhere; `title`, what it shows, for whoever does not see it.
 */
const own = ["mesh", "controls", "autoplay", "theme", "page", "title"];
/** What is opened anew where one of these changes. */
const again = ["mesh", "edits", "path", "controls", "autoplay", "theme", "page"];
/** Global attributes that mean nothing here. */
const global =
  /^(?:id|class|style|slot|part|lang|dir|hidden|tabindex|role|name|data-.*|aria-.*|on.*)$/;

const script = import.meta.url;
/** Bundled with other code it does not know where the page is. */
const isBundled = !/\/embed\.js$/.test(new URL(script).pathname);
/** @param {string} attribute */
const wordOf = (attribute) => attribute.replace(/-(\w)/g, (_, letter) => letter.toUpperCase());
/** @param {string} address @returns {string} the last part of it, as a file is called */
const fileNameOf = (address) =>
  decodeURIComponent(new URL(address, document.baseURI).pathname.split("/").pop() ?? "");

const style = new CSSStyleSheet();
style.replaceSync(`
  :host { display: block; aspect-ratio: 4 / 3; min-height: 12rem; }
  :host([hidden]) { display: none; }
  iframe { display: block; width: 100%; height: 100%; border: 0; }
`);

class UmbilicSurface extends HTMLElement {
  #shadow = this.attachShadow({ mode: "open" });
  /** @type {HTMLIFrameElement | null} */
  #frame = null;
  /** @type {Map<number, { resolve: (ok: any) => void, reject: (reason: unknown) => void }>} */
  #waiting = new Map();
  /** Whatever is asked of the page waits until it listens. */
  #listening = Promise.resolve();
  #listen = () => {};
  #lastId = 0;
  /** All that change in one go come together. */
  #attributes = new MutationObserver((records) =>
    this.#follow(records.map(({ attributeName }) => attributeName ?? "")),
  );
  /** Of what nobody waits for there is no other way to whoever made the element. @param {unknown} error */
  #tell = (error) => this.#announce("error", error);
  /** @param {MessageEvent} event */
  #hear = ({ source, origin, data }) => {
    const isPage = this.#frame && source === this.#frame.contentWindow;
    if (!isPage || origin !== this.#address.origin || data?.umbilic !== 1) return;
    if ("id" in data) this.#settle(data);
    else if (data.event === "listening") this.#begin();
    else this.#announce(String(data.event), data.detail);
  };

  constructor() {
    super();
    this.#shadow.adoptedStyleSheets = [style];
  }

  connectedCallback() {
    addEventListener("message", this.#hear);
    this.#attributes.observe(this, { attributes: true });
    this.#open();
  }

  disconnectedCallback() {
    removeEventListener("message", this.#hear);
    this.#attributes.disconnect();
    this.#close();
  }

  /**
   * Another scene, or a mesh: words of a link as text or as an object, or a mesh file with
   * such words.
   * @param {string | Record<string, unknown> | Blob | ArrayBuffer | Uint8Array} scene
   * @param {{ name?: string } & Record<string, unknown>} [words]  `name` of a mesh that is no file
   */
  async load(scene, { name, ...words } = {}) {
    if (scene instanceof Blob) {
      const bytes = await scene.arrayBuffer();
      return this.#send(bytes, name ?? /** @type {File} */ (scene).name, words);
    }
    if (scene instanceof ArrayBuffer) return this.#send(scene.slice(0), name, words);
    if (ArrayBuffer.isView(scene)) return this.#send(Uint8Array.from(scene).buffer, name, words);
    return this.#ask("load", { scene });
  }
  play = () => this.#ask("play");
  pause = () => this.#ask("pause");
  step = () => this.#ask("step");
  back = () => this.#ask("back");
  reset = () => this.#ask("reset");
  state = () => this.#ask("state");
  /** @type {Typed["seek"]} */
  seek = (step) => this.#ask("seek", { step });
  /** @type {Typed["set"]} */
  set = (words) => this.#ask("set", { words });
  /** @type {Typed["exportMesh"]} */
  exportMesh = async (format = "ply") => {
    const { name, bytes } = await this.#ask("export", { format });
    return new File([bytes], name);
  };

  /** Where Umbilic is. */
  get #address() {
    const page = this.getAttribute("page");
    if (page) return new URL(page, document.baseURI);
    // By its name: not every host shows it for its folder.
    return new URL(import.meta.env.DEV ? "../index.html" : "./index.html", script);
  }

  /** The attributes that are words of a link. @param {(attribute: string) => boolean} [which] */
  #words(which = () => true) {
    /** @type {Record<string, string>} */
    const words = {};
    for (const { name, value } of this.attributes) {
      if (!own.includes(name) && !global.test(name) && which(name)) words[wordOf(name)] = value;
    }
    return words;
  }

  #open() {
    if (isBundled && !this.hasAttribute("page")) return this.#miss();
    const frame = document.createElement("iframe");
    const address = this.#address;
    const query = address.searchParams;
    query.set("embed", "");
    for (const name of ["controls", "theme"]) {
      const value = this.getAttribute(name);
      if (value) query.set(name, value);
    }
    if (this.hasAttribute("autoplay")) query.set("autoplay", "");
    const mesh = this.getAttribute("mesh");
    if (mesh !== null) query.set("wait", "");
    const words = { ...(mesh === null ? {} : { mesh: fileNameOf(mesh) }), ...this.#words() };
    address.hash = new URLSearchParams(words).toString();
    frame.title = this.title || "Umbilic";
    frame.loading = "lazy";
    frame.allow = "fullscreen";
    frame.src = address.href;
    this.#frame = frame;
    this.#listening = new Promise((resolve) => {
      this.#listen = resolve;
    });
    this.#shadow.replaceChildren(frame);
  }

  /** Whatever stands where the page is looked for would be shown instead, maybe this very page. */
  #miss() {
    const message = "The page of Umbilic is not where this script was bundled to.";
    const hint = "Add the plugin `umbilic/vite`, or say where the page is in the attribute `page`.";
    this.#shadow.replaceChildren(`${message} ${hint}`);
    // After whoever made the element has had time to listen.
    queueMicrotask(() => this.#tell({ message, hint }));
  }

  #close() {
    this.#frame?.remove();
    this.#frame = null;
    const gone = new DOMException("The surface was taken out of the page.", "AbortError");
    for (const { reject } of this.#waiting.values()) reject(gone);
    this.#waiting.clear();
  }

  /** The page listens, first to what the mesh is. */
  async #begin() {
    const listen = this.#listen;
    const mesh = this.getAttribute("mesh");
    if (mesh !== null) await this.#fetch(mesh, () => this.#listen === listen);
    listen();
  }

  /** @param {string} mesh  an address @param {() => boolean} isStill  whether it is wanted */
  async #fetch(mesh, isStill) {
    try {
      const response = await fetch(new URL(mesh, document.baseURI));
      if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
      const [bytes, words] = [await response.arrayBuffer(), this.#words()];
      // Before whatever was asked of it meanwhile.
      const now = Promise.resolve();
      if (isStill()) this.#send(bytes, fileNameOf(mesh), words, now).catch(this.#tell);
    } catch (error) {
      const message = `The mesh ${mesh} could not be had: ${/** @type {Error} */ (error).message}`;
      this.#tell({ message, hint: "Look at the attribute `mesh`." });
    }
  }

  /**
   * @param {ArrayBuffer} bytes @param {string | undefined} name
   * @param {Record<string, unknown>} words @param {Promise<void>} [ready]
   */
  #send(bytes, name, words, ready) {
    return this.#ask("load", { name: name ?? "mesh.ply", bytes, scene: words }, ready);
  }

  /**
   * @param {string} type @param {Record<string, unknown>} [fields]
   * @param {Promise<void>} [ready]  that it waits for @returns {Promise<any>}
   */
  async #ask(type, fields = {}, ready = this.#listening) {
    const frame = this.#frame;
    if (!frame) throw new DOMException("The surface is not shown.", "InvalidStateError");
    this.#lastId += 1;
    const id = this.#lastId;
    const transfer = fields.bytes instanceof ArrayBuffer ? [fields.bytes] : [];
    // Whoever asks does not wait until somebody scrolls there.
    frame.loading = "eager";
    ready.then(() => {
      const message = { umbilic: 1, id, type, ...fields };
      // Taken out of the page meanwhile, it is no more wanted.
      if (!this.#waiting.has(id)) return;
      frame.contentWindow?.postMessage(message, this.#address.origin, transfer);
    });
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
    });
  }

  /** @param {{ id: number, ok?: unknown, error?: { kind: string, message: string, hint: string } }} reply */
  #settle({ id, ok, error }) {
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (!error) waiting?.resolve(ok);
    else waiting?.reject(Object.assign(new Error(error.message), error));
  }

  /** @param {string} event @param {unknown} detail */
  #announce(event, detail) {
    if (!["ready", "frame", "statechange", "error", "key"].includes(event)) return;
    this.dispatchEvent(new CustomEvent(event, { detail }));
  }

  /** Does what the changed attributes say. @param {string[]} attributes */
  #follow(attributes) {
    const changed = attributes.filter((name) => !global.test(name));
    if (!this.#frame && !changed.includes("page")) return;
    if (this.#frame && changed.includes("title")) this.#frame.title = this.title || "Umbilic";
    const isNew = changed.some((name) => ["sample", "figure"].includes(name));
    const isGone = changed.some((name) => !own.includes(name) && !this.hasAttribute(name));
    if (changed.some((name) => again.includes(name))) {
      this.#close();
      this.#open();
    } else if (isNew || (isGone && !this.hasAttribute("mesh"))) {
      this.load(this.#words()).catch(this.#tell);
    } else {
      const words = this.#words((name) => changed.includes(name));
      if (Object.keys(words).length > 0) this.set(words).catch(this.#tell);
    }
  }
}

if (!customElements.get("umbilic-surface")) {
  /** @type {new () => Typed} */
  const typed = UmbilicSurface;
  customElements.define("umbilic-surface", typed);
}
