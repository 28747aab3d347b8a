// The guide: its language, its theme, and the element that makes surfaces live.

import { remembered } from "../language.js";
import { openProse } from "../prose.js";

// As any other page loads it: bundled with this one it would no longer know where it stands.
const embed = "../embed.js";
import(/* @vite-ignore */ new URL(embed, import.meta.url).href);

const dark = matchMedia("(prefers-color-scheme: dark)");
const follow = () => {
  const auto = dark.matches ? "dark" : "light";
  document.documentElement.dataset.theme = remembered("theme") ?? auto;
};
dark.addEventListener("change", follow);
follow();
await openProse(() => import("../locales/de/guide.json"));
