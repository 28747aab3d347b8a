// @ts-check
// Reads PNG as browsers write it: eight bits a channel, colour with or without alpha, not
// interlaced. Here and not in the page, whose main thread is itself measured.

import { inflateSync } from "node:zlib";

/** @typedef {{ width: number, height: number, channels: number, data: Uint8Array }} Picture */

/**
 * @param {Buffer} png
 * @returns {Picture} rows from the top, without padding
 */
export function decodePng(png) {
  let [width, height, channels] = [0, 0, 0];
  /** @type {Buffer[]} */
  const packed = [];
  for (let at = 8; at < png.length; ) {
    const length = png.readUInt32BE(at);
    const type = png.toString("latin1", at + 4, at + 8);
    const body = png.subarray(at + 8, at + 8 + length);
    if (type === "IHDR") {
      [width, height] = [body.readUInt32BE(0), body.readUInt32BE(4)];
      const [depth, colour, , , interlace] = body.subarray(8);
      channels = { 2: 3, 6: 4 }[colour] ?? 0;
      if (depth !== 8 || channels === 0 || interlace !== 0) throw new Error("another kind of PNG");
    } else if (type === "IDAT") packed.push(body);
    at += 12 + length;
  }
  return {
    width,
    height,
    channels,
    data: unfilter(inflateSync(Buffer.concat(packed)), width * channels, height, channels),
  };
}

/**
 * Undoes the prediction of every byte from those to the left and above.
 * @param {Uint8Array} rows  each begins with the number of its filter
 * @param {number} stride    bytes of a row
 * @param {number} height
 * @param {number} channels
 */
function unfilter(rows, stride, height, channels) {
  const data = new Uint8Array(stride * height);
  for (let y = 0; y < height; y += 1) {
    const filter = rows[y * (stride + 1)];
    for (let x = 0; x < stride; x += 1) {
      const at = y * stride + x;
      const left = x >= channels ? data[at - channels] : 0;
      const above = y > 0 ? data[at - stride] : 0;
      const corner = x >= channels && y > 0 ? data[at - stride - channels] : 0;
      const guess = [0, left, above, (left + above) >> 1, paeth(left, above, corner)][filter];
      data[at] = rows[y * (stride + 1) + 1 + x] + guess;
    }
  }
  return data;
}

/** Of the three the one nearest to left + above − corner. @param {number} left @param {number} above @param {number} corner */
function paeth(left, above, corner) {
  const [a, b, c] = [above - corner, left - corner, left + above - 2 * corner].map(Math.abs);
  if (a <= b && a <= c) return left;
  return b <= c ? above : corner;
}
