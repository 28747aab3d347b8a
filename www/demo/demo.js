// The slides about Willmore flow.

import { remembered } from "../language.js";
import { formatNumber } from "../number.js";
import { keepOffline } from "../offline.js";
import { openProse } from "../prose.js";
import { createDeck } from "./deck.js";

const byId = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** @import {} from "../element.js" */

// The surfaces speak as these slides do, also where only the address asks for that.
const lang = new URLSearchParams(location.search).get("lang");
if (lang) {
  for (const surface of document.querySelectorAll("umbilic-surface")) {
    surface.setAttribute("page", `./index.html?${new URLSearchParams({ lang })}`);
  }
}

// As any other page loads it: bundled with this one it would no longer know where it stands.
// From here it is one folder up, in the sources as in what is built of them.
const embed = "../embed.js";
const element = import(/* @vite-ignore */ new URL(embed, import.meta.url).href);

// As on the page itself, whose surfaces know nothing of these slides.
const theme = remembered("theme");
if (theme) document.documentElement.dataset.theme = theme;

await openProse(() => import("../locales/de/demo.json"));
const slides = [...document.querySelectorAll("section")];
const place = byId("place");
const previous = byId("previous");
const next = byId("next");
const bar = byId("progress");

/** @type {HTMLElement} */
let current = slides[0];
const deck = createDeck(slides, (slide, n) => {
  current = slide;
  place.textContent = `${n + 1} / ${slides.length}`;
  bar.style.width = `${(100 * (n + 1)) / slides.length}%`;
  previous.ariaDisabled = String(n === 0);
  next.ariaDisabled = String(n === slides.length - 1);
});
previous.addEventListener("click", deck.previous);
next.addEventListener("click", deck.next);

/** Plays what stands in the slide, or pauses it. */
async function toggle() {
  await element;
  const surfaces = [...current.querySelectorAll("umbilic-surface")];
  const states = await Promise.all(surfaces.map((surface) => surface.state()));
  const isPlaying = states.some(({ phase, isWaiting }) => phase === "running" || isWaiting);
  await Promise.all(surfaces.map((surface) => (isPlaying ? surface.pause() : surface.play())));
}

function fullScreen() {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen?.().catch(() => {});
}
byId("full").addEventListener("click", fullScreen);

addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const isPressed = event.target instanceof Element && event.target.matches("button, a");
  if (event.key === " " && !isPressed) {
    event.preventDefault();
    // What a surface refuses it says itself.
    toggle().catch(() => {});
  } else if (event.key === "f") fullScreen();
});

for (const surface of document.querySelectorAll("umbilic-surface")) {
  const figure = surface.closest("figure");
  const number = [...(figure?.querySelectorAll("umbilic-surface") ?? [])].indexOf(surface);
  const outputs = [...(figure?.querySelectorAll("output") ?? [])].filter(
    ({ dataset }) => Number(dataset.of ?? 0) === number,
  );
  surface.addEventListener("frame", ({ detail }) => {
    for (const output of outputs) {
      const { reading = "", digits } = output.dataset;
      const value = /** @type {Record<string, any>} */ (detail)[reading];
      output.textContent = digits ? formatNumber(value, Number(digits)) : String(value);
    }
  });
  // Who has clicked into a surface still has the clicker in hand.
  surface.addEventListener("key", ({ detail }) => deck.press(detail.key));
}

keepOffline(new Promise((resolve) => addEventListener("load", resolve)), () => {});
