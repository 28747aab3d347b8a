// Builds the page: the state, what can be asked for, the views, and the scene in the address.

import { effect, signal } from "@preact/signals-core";
import { nothing, render } from "lit-html";
import { commands, listenForKeys } from "./commands.js";
import { openLanguage, remembered } from "./language.js";
import { createLinkWriter, linkIn } from "./link.js";
import { packedEndings, readEndings } from "./mesh-format.js";
import { keepOffline } from "./offline.js";
import { sceneTitle } from "./status.js";
import { isDark } from "./store.js";
import { dock } from "./view/dock.js";
import { page } from "./view/page.js";
import { fetchViews } from "./view/parts.js";
import * as shell from "./view/shell.js";
import { createStage } from "./view/stage.js";
import { fetchRest } from "./words.js";

/** @import { Mode, S } from "./store.js" */

// Sentences are made when the views are: the language comes first.
await openLanguage();

/** @param {string} id @returns {HTMLElement} */
const byId = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

const dark = matchMedia("(prefers-color-scheme: dark)");
const file = /** @type {HTMLInputElement} */ (byId("file"));
const asked = new URLSearchParams(location.search);
// Fewer samples a pixel, and no effects, draw faster where there is no graphics card; pictures to
// be kept are worth all of them there too.
const quality = {
  samples: /** @type {1 | 4} */ (asked.get("msaa") === "1" ? 1 : 4),
  effects: /** @type {"always" | "auto" | "never"} */ (asked.get("effects") ?? "auto"),
};

Object.assign(page, {
  keysOn: signal(remembered("keys") !== "off"),
  finding: signal(null),
  chooseFile: () => file.click(),
  turn: shell.turn,
  tool(/** @type {Mode} */ mode) {
    page.patch({ tab: "surface" });
    page.edit.mode(mode);
  },
  present: (/** @type {boolean | undefined} */ on) =>
    page.patch({
      presenting: on ?? !page.get().presenting,
      dialog: null,
      welcome: false,
      legend: false,
    }),
});
page.stage = createStage(byId("panes"), quality);

const theme = remembered("theme");
if (theme === "light" || theme === "dark") page.run.view({ theme });
page.run.view({ systemDark: dark.matches });
dark.addEventListener("change", () => page.run.view({ systemDark: dark.matches }));

const { top, rail, drawer, overStage: cards, dialog, question: ask } = shell;
// Each view in its place, anew whenever what it shows changes.
for (const [id, view] of Object.entries({ top, rail, drawer, dock, cards, dialog, ask })) {
  effect(() => void render(view() ?? nothing, byId(id)));
}
for (const [id, isOpen] of /** @type {const} */ ([
  ["dialog", shell.isDialogOpen],
  ["ask", (/** @type {S} */ s) => s.question !== null],
])) {
  const element = /** @type {HTMLDialogElement} */ (byId(id));
  effect(() => {
    const s = page.state.value;
    element.className = s.dialog ?? "";
    if (isOpen(s) === element.open) return;
    if (isOpen(s)) element.showModal();
    else element.close();
    element.scrollTop = 0;
  });
  // Of a dialog that is closed with its key this comes at once, and no key after it is lost.
  for (const kind of ["cancel", "close"]) {
    element.addEventListener(kind, () => {
      // Known already: there may be another by now, or one on its way.
      if (kind === "close" && isOpen(page.get()) === element.open) return;
      if (id === "dialog") page.patch({ dialog: null });
      else page.get().question?.answer(false);
    });
  }
  element.addEventListener("click", (event) => event.target === element && element.close());
}
effect(() => {
  const s = page.state.value;
  const { dataset } = document.documentElement;
  dataset.theme = isDark(s) ? "dark" : "light";
  dataset.tab = s.tab ?? "";
  const title = sceneTitle(s.source);
  document.title = title ? `${title} · Umbilic` : "Umbilic";
});

// A figure is judged where it has come as far as it goes.
let judged = "";
effect(() => {
  const { figure, reading, running } = page.state.value;
  const isMoving = page.player.motion.value !== "still";
  if (!figure || !reading || running || isMoving) return;
  const isThere = figure.steps !== "rest" && reading.step >= figure.steps;
  const isFar = isThere || reading.status !== "ready";
  const place = `${figure.id} ${reading.step} ${reading.energy}`;
  if (!isFar || place === judged) return;
  judged = place;
  page.solver.ask("judge", { figure: figure.id }).then(
    (found) => {
      if (found && judged === place) page.finding.value = { id: figure.id, ...found };
    },
    () => {},
  );
});

listenForKeys(page);
file.accept = [...readEndings, ...packedEndings, ".bin", ".json"].join();
file.setAttribute("aria-keyshortcuts", commands.find(({ id }) => id === "open")?.keys[0] ?? "");

const isEmbedded = asked.has("embed");
const embedding = isEmbedded ? (await import("./embed/host.js")).createEmbedding(page) : null;
if (embedding) {
  effect(() => {
    page.state.value;
    page.player.tick.value;
    page.player.motion.value;
    queueMicrotask(embedding.update);
  });
}
const pictured = page.stage.start(linkIn(location).text === "" && !embedding?.isFed);
pictured.then(
  () => performance.mark("first-picture"),
  () => {},
);

// Whoever embeds the page could take away what a visitor opens in it. A file that is chosen or
// dropped before the solver is there waits for it.
if (!embedding) {
  file.addEventListener("change", () => {
    if (file.files?.length) openFiles([...file.files]);
    file.value = "";
  });
  for (const kind of /** @type {const} */ (["dragover", "dragleave", "drop"])) {
    addEventListener(kind, (event) => {
      if (kind !== "dragleave") event.preventDefault();
      document.documentElement.classList.toggle("dropping", kind === "dragover");
      const { files = [] } = event.dataTransfer ?? {};
      if (kind === "drop" && files.length > 0) openFiles([...files]);
    });
  }
}

/** After the scene of the address, which they replace. @param {File[]} files */
const openFiles = (files) => begun.catch(() => {}).then(() => page.open.open(files));

/** Links being opened: until their scene is there, the address is theirs. */
let opening = 0;
/** @param {import("./link.js").Address} address */
function openLink(address) {
  opening += 1;
  return page.open.openLink(address).finally(() => {
    opening -= 1;
  });
}
const writeLink = createLinkWriter(
  page.get,
  () => page.open.writeLink(embedding !== null),
  embedding?.linkTo ?? ((hash) => opening === 0 && history.replaceState(null, "", hash)),
);
/** Until a visitor does something, an address that names no scene stays so. */
const isTouched = signal(embedding !== null || linkIn(location).text !== "");
for (const kind of ["pointerdown", "keydown", "drop", "hashchange"])
  addEventListener(kind, () => (isTouched.value = true), { once: true });
effect(() => {
  const { running, reading } = page.state.value;
  if (running || page.player.motion.value !== "still") return;
  if (isTouched.value) writeLink();
  // Once something has run there is time for what opens only when it is asked for.
  if (reading && reading.step !== 0) fetchViews().catch(() => {});
});

// The event's address and not `location`: by now the old scene may have been written there.
addEventListener("hashchange", ({ newURL }) => openLink(new URL(newURL)));
if (!embedding && location.hash.length < 2 && remembered("visited") === null)
  page.patch({ welcome: true });
/** The solver is there. */
const up = new Promise((resolve) => {
  effect(() => {
    if (page.state.value.version !== "") resolve(null);
  });
});
const begun = Promise.resolve(embedding?.wanted).then(async () => {
  try {
    page.solver.begin();
  } catch (error) {
    page.patch({ phase: "failed" });
    throw error;
  }
  // What the solver says is said in words that the first picture need not wait for.
  await Promise.race([pictured, up]);
  await fetchRest().catch(console.error);
});
const opened = begun.then(() => (embedding?.isFed ? undefined : openLink(location)));
opened.catch(page.report);
embedding?.begin(opened);
// In another page it is that one's concern.
if (!embedding) keepOffline(Promise.all([pictured, opened]), page.notes.note);
