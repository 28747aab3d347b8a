// @ts-check
// The tab for what leaves the page: the link, pictures, films, meshes, recipes, code for other pages.

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { createFilm } from "../film.js";
import { formats, named, savedMeshes } from "../options.js";
import { elementCode, iframeCode, pageAddress, sayLack, sizes } from "../share.js";
import { sceneTitle } from "../status.js";
import { say } from "../words.js";
import { button, idOf, into, section, select } from "./parts.js";

/** @import { Page } from "../actions.js" */

const format = signal("ply");
const embedAs = signal("iframe");
const embedSize = signal("640 × 480");
/** One that is recorded goes on while another tab is open. @type {ReturnType<typeof createFilm> | null} */
let film = null;
const sequence = { format: signal("ply"), every: signal(1), size: signal("") };

/** @param {Page} page @param {string} text @param {string} said */
async function copy(page, text, said) {
  try {
    await navigator.clipboard.writeText(text);
    page.notes.answer(said);
  } catch {
    page.notes.error({ message: say("not-copied"), hint: text });
  }
}

/** @param {Page} page */
async function copyLink(page) {
  await page.run.pause();
  const { text, lacks } = await page.open.writeLink(true);
  await copy(
    page,
    `${pageAddress(location)}#${text}`,
    [say("link-copied"), ...lacks.map(sayLack)].join(" "),
  );
}

/** @param {Page} page */
async function copyCode(page) {
  const { text } = await page.open.writeLink(true);
  const size = /** @type {[number, number]} */ (embedSize.value.split(" × ").map(Number));
  const address = pageAddress(location);
  const title = page.stage.label();
  const code =
    embedAs.value === "element"
      ? elementCode(address, `#${text}`, size)
      : iframeCode(address, `#${text}`, title, size);
  await copy(page, code, say("code-copied"));
}

/** How large a ZIP would be. @param {Page} page */
async function measure(page) {
  const found = await page.edit
    .sequenceSize(sequence.format.value, sequence.every.value)
    .catch(() => null);
  sequence.size.value = found
    ? say("sequence-size", { meshes: found.meshes, megabytes: found.bytes / 1e6 })
    : "";
}

/** @param {Page} page */
function zip(page) {
  const id = idOf("sequence-every");
  return html`
    ${select(say("each-step-as"), named(savedMeshes, "save-as"), sequence.format.value, (to) => {
      sequence.format.value = to;
      measure(page);
    })}
    <div class="field"><label for=${id}>${say("every")}</label><span class="number"><input id=${id} type="number" min="1" step="1"
      .value=${String(sequence.every.value)} @change=${(/** @type {any} */ { target }) => {
        if (target.reportValidity()) sequence.every.value = target.valueAsNumber;
        measure(page);
      }} /></span><p class="hint">${sequence.size.value}</p></div>
    ${button(say("save-steps"), () => page.save.sequence(sequence.format.value, sequence.every.value), { icon: "share" })}`;
}

/** @param {Page} page */
export function share(page) {
  const { mesh, source } = page.state.value;
  if (!mesh) return nothing;
  film ??= createFilm(page);
  const tools = [
    { id: "iframe", label: say("embed-iframe") },
    { id: "element", label: say("embed-element") },
  ];
  return html`
    <p class="hint">${say("share-hint", { name: sceneTitle(source) })}</p>
    ${button(say("copy-link"), () => copyLink(page).catch(page.report), { kind: "primary" })}
    <hr />
    ${select(say("save-as"), named(formats, "save-as"), format.value, into(format))}
    ${button(say("download"), () => page.save.file(format.value), { icon: "share" })}
    <hr />
    <h3>${say("film")}</h3>
    <div class="row">${button(say(film.isOn.value ? "film-stop" : "film-record"), film.turn, { pressed: film.isOn.value, disabled: !film.isAble })}
      <span class="hint">${film.isAble ? film.time.value : say("film-unable")}</span></div>
    <p class="hint">${say("film-hint")}</p>
    ${section(page, "zip", say("save-all-steps"), () => zip(page))}
    ${section(
      page,
      "embed",
      say("embed"),
      () => html`
      ${select(say("embed-as"), tools, embedAs.value, into(embedAs))}
      ${select(
        say("embed-size"),
        sizes.map((id) => ({ id, label: id })),
        embedSize.value,
        into(embedSize),
      )}
      ${button(say("copy-code"), () => copyCode(page).catch(page.report))}`,
    )}
    `;
}
