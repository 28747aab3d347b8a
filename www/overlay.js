// Colours of what is drawn over the surface.

/** @import { Look } from "./generated/types.js" */

/**
 * By the kinds of `Look`: spoke, circle at the vertex, any circle, larger and smaller principal
 * curvature, double curve. Chosen against the plain surface and against both colour maps.
 * @type {Record<"light" | "dark", [number, number, number][]>}
 */
const palettes = {
  light: [
    [16, 16, 20],
    [176, 12, 108],
    [104, 92, 176],
    [190, 30, 30],
    [10, 70, 190],
    [196, 104, 0],
  ],
  dark: [
    [255, 255, 255],
    [255, 122, 200],
    [150, 138, 200],
    [255, 120, 96],
    [120, 200, 255],
    [255, 208, 64],
  ],
};

/** A colour as CSS has it. @param {number} kind @param {boolean} dark */
export const colourOf = (kind, dark) => `rgb(${palettes[dark ? "dark" : "light"][kind].join(" ")})`;

/** @param {Look} look @param {boolean} dark */
export function overlayOf({ ends, kinds, circles, directions }, dark) {
  // Four bytes at once: there may be hundreds of thousands.
  const packed = palettes[dark ? "dark" : "light"].map(
    (rgb) => new Uint32Array(Uint8Array.from([...rgb, 255]).buffer)[0],
  );
  const colours = Uint32Array.from(kinds, (kind) => packed[kind]);
  // Behind the surface a few circles are a help, thousands are a thicket.
  const hidden = circles || directions ? 0 : 0.3;
  return { ends, colours: new Uint8Array(colours.buffer), hidden };
}
