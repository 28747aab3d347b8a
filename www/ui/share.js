// @ts-check
// The scene as a link, and as a piece of another page; and what of it neither can carry.

/** @import { Controller } from "../controller.js" */
/** @import { Lack } from "../generated/types.js" */
/** @import { PageState } from "../state.js" */

import { t } from "../language.js";
import { byId, setText } from "./element.js";

/** What stands before `#` in an address of the whole page. @param {{ href: string }} location */
export const pageAddress = ({ href }) => href.replace(/[?#].*$/s, "");

/** @param {string} text  within double quotes */
const quoted = (text) =>
  text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");

/**
 * @param {string} page   address of the page
 * @param {string} hash   the scene, from `#` on
 * @param {string} title  for whoever does not see the surface
 * @param {[number, number]} size
 */
export function iframeCode(page, hash, title, [width, height]) {
  const address = quoted(`${page}?embed${hash}`);
  return (
    `<iframe src="${address}" title="${quoted(title)}" width="${width}" height="${height}" ` +
    `loading="lazy" allow="fullscreen" style="border: 0"></iframe>`
  );
}

/**
 * @param {string} page
 * @param {string} hash
 * @param {[number, number]} size
 */
export function elementCode(page, hash, [width, height]) {
  const script = new URL("embed.js", page).href;
  const attributes = [...new URLSearchParams(hash.slice(1))].map(([word, value]) => {
    const name = word.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
    return `${name}="${quoted(value)}"`;
  });
  return (
    `<script type="module" src="${quoted(script)}"></script>\n` +
    `<umbilic-surface ${attributes.join(" ")} style="width: ${width}px; height: ${height}px"></umbilic-surface>`
  );
}

/** What is to be sent along with a link. @param {Lack} lack */
export function sayLack(lack) {
  switch (lack) {
    case "editsTooLong":
      return t(
        "The edits are too large for a link: send the mesh along, saved with Download, or a recipe.",
      );
    case "editsUnknown":
      return t(
        "The surface was edited by hand. The link does not carry that: send the mesh along, saved with Download.",
      );
    case "file":
      return t("The mesh itself is not in the link: send the file along.");
    case "fileByDigest":
      return t(
        "The mesh itself is not in the link: send the file along. It is recognised by its SHA-256.",
      );
    case "regionTooLong":
      return t("The painted region is too large for a link; it is not in it.");
    case "pathTooLong":
      return t(
        "What was changed on the way is too large for a link: send a recipe, saved with Download.",
      );
  }
}

/** @param {Pick<Controller, "writeLink">} controller */
export function createShare(controller) {
  const section = byId("share", HTMLDetailsElement);
  const embedding = byId("embed-as", HTMLSelectElement);
  const size = byId("embed-size", HTMLSelectElement);
  const field = byId("share-text", HTMLTextAreaElement);
  const said = byId("share-said", HTMLElement);
  const lacks = byId("share-lacks", HTMLElement);

  /** @type {Readonly<PageState> | null} */
  let state = null;
  section.addEventListener("toggle", () => section.open && sayLacks());

  /** @param {string} text @param {string} done what to say then */
  async function copy(text, done) {
    field.value = text;
    field.hidden = true;
    try {
      await navigator.clipboard.writeText(text);
      setText(said, done);
    } catch {
      // Not allowed, or a page over plain http: the user copies by hand.
      field.hidden = false;
      field.focus();
      field.select();
      setText(
        said,
        t("The browser does not let the page copy: the text is selected, copy it with Ctrl+C."),
      );
    }
  }

  /** What comes after the address of the page. */
  async function hash() {
    setText(said, "");
    return `#${(await controller.writeLink(true)).text}`;
  }

  byId("copy-link", HTMLButtonElement).addEventListener("click", async () => {
    if (!state?.reading) return;
    copy(pageAddress(location) + (await hash()), t("The link is copied."));
  });
  byId("copy-embed", HTMLButtonElement).addEventListener("click", async () => {
    if (!state?.reading) return;
    const page = pageAddress(location);
    const words = await hash();
    const [width, height] = size.value.split("x").map(Number);
    const title = t("Umbilic: {name}", { name: state.mesh?.name ?? "" });
    const code =
      embedding.value === "iframe"
        ? iframeCode(page, words, title, [width, height])
        : elementCode(page, words, [width, height]);
    copy(code, t("The code is copied."));
  });

  return {
    /** @param {Readonly<PageState>} now */
    update(now) {
      const { mesh, options, reading } = now;
      const same =
        state?.mesh === mesh && state.options === options && state.reading?.step === reading?.step;
      state = now;
      if (same || !reading) return;
      if (section.open) {
        setText(said, "");
        sayLacks();
      }
    },
  };

  /** What a link to the present scene lacks. */
  async function sayLacks() {
    if (!state?.reading) return;
    // A solver that is gone says nothing.
    const sentences = await controller.writeLink().then(
      (link) => link.lacks.map(sayLack),
      () => [],
    );
    setText(lacks, sentences.join(" "));
    lacks.hidden = sentences.length === 0;
  }
}
