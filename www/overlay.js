// Colours of what is drawn over the surface.

/** @import { Look } from "./generated/types.js" */

/**
 * By the kinds of `Look`: spoke, circle at the vertex, any circle, larger and smaller principal
 * curvature, double curve. Chosen against the plain surface and against both colour maps.
 */
const palettes = {
  light: ["#101014", "#b00c6c", "#685cb0", "#be1e1e", "#0a46be", "#c46800"],
  dark: ["#ffffff", "#ff7ac8", "#968ac8", "#ff7860", "#78c8ff", "#ffd040"],
};

/** A colour as CSS has it. @param {number} kind @param {boolean} dark */
export const colourOf = (kind, dark) => palettes[dark ? "dark" : "light"][kind];

/**
 * Segments over the surface: two ends each, their colours, and their opacity where it hides them.
 * @param {Look} look @param {boolean} dark
 */
export function overlayOf({ ends, kinds, circles, directions }, dark) {
  // Four bytes at once: there may be hundreds of thousands.
  const packed = palettes[dark ? "dark" : "light"].map((colour) => {
    const rgb = Number.parseInt(colour.slice(1), 16);
    return new Uint32Array(Uint8Array.of(rgb >> 16, rgb >> 8, rgb, 255).buffer)[0];
  });
  const colours = Uint32Array.from(kinds, (kind) => packed[kind]);
  // Behind the surface a few circles are a help, thousands are a thicket.
  const hidden = circles || directions ? 0 : 0.3;
  return { ends, colours: new Uint8Array(colours.buffer), hidden };
}

/** @typedef {ReturnType<typeof overlayOf>} Overlay */
