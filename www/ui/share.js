// @ts-check
// The scene as a link, and as a piece of another page; and what of it neither can carry.

/** @import { PageState } from "../state.js" */

import { t } from "../language.js";
import { sharedLink } from "../link.js";
import { beginning, encodePath } from "../link-edits.js";
import { encodeRegion } from "../link-region.js";
import { isPlain } from "../recipe-schema.js";
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

/** @param {Readonly<PageState>} state @returns {string[]} sentences on what a link to it lacks */
export function missing(state) {
  const { source, origin, options, story, reading } = state;
  const lacks = [];
  const { from, edits } = beginning(state);
  if (source !== origin && edits === null && story?.edits.length !== 0) {
    lacks.push(
      story && origin
        ? t(
            "The edits are too large for a link: send the mesh along, saved with Download, or a recipe.",
          )
        : t(
            "The surface was edited by hand. The link does not carry that: send the mesh along, saved with Download.",
          ),
    );
  } else if (from?.kind === "file") {
    lacks.push(
      from.sha256
        ? t(
            "The mesh itself is not in the link: send the file along. It is recognised by its SHA-256.",
          )
        : t("The mesh itself is not in the link: send the file along."),
    );
  }
  const region = options.free ?? options.fixed;
  if (region && encodeRegion(region) === null) {
    lacks.push(t("The painted region is too large for a link; it is not in it."));
  }
  if (story && !isPlain(story.path) && encodePath(story.path, reading?.step ?? 0) === null) {
    lacks.push(
      t("What was changed on the way is too large for a link: send a recipe, saved with Download."),
    );
  }
  return lacks;
}

export function createShare() {
  const section = byId("share", HTMLDetailsElement);
  const embedding = byId("embed-as", HTMLSelectElement);
  const size = byId("embed-size", HTMLSelectElement);
  const field = byId("share-text", HTMLTextAreaElement);
  const said = byId("share-said", HTMLElement);
  const lacks = byId("share-lacks", HTMLElement);

  /** @type {Readonly<PageState> | null} */
  let state = null;

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

  byId("copy-link", HTMLButtonElement).addEventListener("click", () => {
    if (!state?.source) return;
    copy(pageAddress(location) + sharedLink(state), t("The link is copied."));
  });
  byId("copy-embed", HTMLButtonElement).addEventListener("click", () => {
    if (!state?.source) return;
    const [page, hash] = [pageAddress(location), sharedLink(state)];
    const [width, height] = size.value.split("x").map(Number);
    const title = t("Umbilic: {name}", { name: state.mesh?.name ?? "" });
    const code =
      embedding.value === "iframe"
        ? iframeCode(page, hash, title, [width, height])
        : elementCode(page, hash, [width, height]);
    copy(code, t("The code is copied."));
  });

  return {
    /** @param {Readonly<PageState>} now */
    update(now) {
      const same =
        state?.source === now.source && state.options === now.options && state.story === now.story;
      state = now;
      if (same) return;
      const sentences = missing(now);
      setText(lacks, sentences.join(" "));
      lacks.hidden = sentences.length === 0;
      if (section.open) setText(said, "");
    },
  };
}
