// The tab for what leaves the page: the link, pictures, films, meshes, recipes, code for other pages.

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { createFilm } from "../film.js";
import { formats, named, savedMeshes } from "../options.js";
import { saveFile, saveSequence } from "../save.js";
import { elementCode, iframeCode, pageAddress, sayLack, sizes } from "../share.js";
import { sceneTitle, surfaceLabel } from "../status.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, into, labelled, number, section, select } from "./parts.js";

const format = signal("ply");
const embedAs = signal(/** @type {"iframe" | "element"} */ ("iframe"));
const embedSize = signal("640 × 480");
/** One that is recorded goes on while another tab is open. @type {ReturnType<typeof createFilm> | null} */
let film = null;
const sequence = { format: signal("ply"), every: signal(1), size: signal("") };

/** @param {string} text @param {string} said */
async function copy(text, said) {
  try {
    await navigator.clipboard.writeText(text);
    page.notes.answer(said);
  } catch {
    page.notes.error({ message: say("not-copied"), hint: text });
  }
}

async function copyLink() {
  await page.run.pause();
  const { text, lacks } = await page.open.writeLink(true);
  const said = [say("link-copied"), ...lacks.map(sayLack)].join(" ");
  await copy(`${pageAddress(location)}#${text}`, said);
}

async function copyCode() {
  const { text } = await page.open.writeLink(true);
  const size = /** @type {[number, number]} */ (embedSize.value.split(" × ").map(Number));
  const [address, hash] = [pageAddress(location), `#${text}`];
  const isElement = embedAs.value === "element";
  const code = isElement
    ? elementCode(address, hash, size)
    : iframeCode(address, hash, surfaceLabel(page.get(), page.shown()), size);
  await copy(code, say("code-copied"));
}

/** How large a ZIP would be. */
async function measure() {
  const { format: as, every, size } = sequence;
  const found = await page.solver
    .ask("sequenceSize", { format: as.value, every: every.value })
    .catch(() => null);
  const values = found && { meshes: found.meshes, megabytes: found.bytes / 1e6 };
  size.value = values ? say("sequence-size", values) : "";
}

function zip() {
  const { format: as, every, size } = sequence;
  const choose =
    (/** @type {{ value: any }} */ to) => (/** @type {string | number | null} */ value) => {
      to.value = value ?? 1;
      measure();
    };
  const input = number(say("every"), every.value, choose(every), { min: 1, step: 1 });
  const save = () => saveSequence(page, as.value, every.value);
  return html`${select(say("each-step-as"), named(savedMeshes, "save-as"), as.value, choose(as))}
    ${labelled(say("every"), html`<span class="number">${input}</span>`)}<p class="hint">${size.value}</p>
    ${button(say("save-steps"), save, "", { icon: "share" })}`;
}

function embed() {
  const kinds = named(["iframe", "element"], "embed");
  const sizesOf = sizes.map((id) => ({ id, label: id }));
  return html`${select(say("embed-as"), kinds, embedAs.value, into(embedAs))}
    ${select(say("embed-size"), sizesOf, embedSize.value, into(embedSize))}
    ${button(say("copy-code"), () => copyCode().catch(page.report))}`;
}

export function share() {
  const { mesh, source } = page.state.value;
  if (!mesh) return nothing;
  film ??= createFilm(page);
  const { recorder, isAble, time, turn } = film;
  const pressed = recorder.value !== null;
  const record = say(pressed ? "film-stop" : "film-record");
  return html`<p class="hint">${say("share-hint", { name: sceneTitle(source) })}</p>
    ${button(say("copy-link"), () => copyLink().catch(page.report), "primary")}<hr />
    ${select(say("save-as"), named(formats, "save-as"), format.value, into(format))}
    ${button(say("download"), () => saveFile(page, format.value), "", { icon: "share" })}<hr />
    <h3>${say("film")}</h3>
    <div class="row">${button(record, () => turn().catch(page.report), "", { pressed, disabled: !isAble })}
      <span class="hint">${isAble ? time.value : say("film-unable")}</span></div>
    <p class="hint">${say("film-hint")}</p>
    ${section("zip", say("save-all-steps"), zip)}${section("embed", say("embed"), embed)}`;
}
