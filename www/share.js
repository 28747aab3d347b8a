// The scene as a link, and as a piece of another page; and what of it neither can carry.

/** @import { Lack } from "./generated/types.js" */

import { say } from "./words.js";

/** What stands before `#` in an address of the whole page. @param {{ href: string }} location */
export const pageAddress = ({ href }) => href.replace(/[?#].*$/s, "");

/** @param {string} text  within double quotes */
const quoted = (text) =>
  text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");

/**
 * @param {string} page   address of the page @param {string} hash   the scene, from `#` on
 * @param {string} title  for whoever does not see the surface @param {[number, number]} size
 */
export function iframeCode(page, hash, title, [width, height]) {
  const address = quoted(`${page}?embed${hash}`);
  return (
    `<iframe src="${address}" title="${quoted(title)}" width="${width}" height="${height}" ` +
    `loading="lazy" allow="fullscreen" style="border: 0"></iframe>`
  );
}

/** @param {string} page @param {string} hash @param {[number, number]} size */
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
export const sayLack = (lack) => say(`lack-${lack}`);

/** Sizes that are offered, in CSS pixels. */
export const sizes = ["640 × 480", "480 × 360", "800 × 600", "1280 × 720"];
