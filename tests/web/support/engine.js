// @ts-check
// What the tests ask of a browser other than Chromium, whatever protocol it speaks.

import { findProgram, start } from "./programs.js";

/** @typedef {Record<string, string>} Element  as the protocol passes it */

/**
 * @typedef {object} Engine
 * @property {string[]} faults  exceptions and errors in the console, where the protocol tells
 * @property {(width: number, height: number) => Promise<void>} resize  the page, in CSS pixels
 * @property {(url: string) => Promise<void>} open
 * @property {(code: string) => Promise<any>} evaluate  an expression in the page, or what it
 *   promises; the value as JSON
 * @property {(code: string) => Promise<Element>} element  an expression that is an element
 * @property {(element: Element) => Promise<void>} click  in the middle of it, with a mouse
 * @property {(element: Element, file: string) => Promise<void>} setFile  of a file input
 * @property {(element: Element) => Promise<Buffer>} picture  PNG, as it reached the screen
 * @property {() => Promise<void>} close
 */

/** Input actions of both protocols. @param {object} origin  what is pressed */
export const pressing = (origin) => [
  {
    type: "pointer",
    id: "mouse",
    actions: [
      { type: "pointerMove", x: 0, y: 0, origin },
      { type: "pointerDown", button: 0 },
      { type: "pointerUp", button: 0 },
    ],
  },
];

/** The program of a display in memory; only Linux needs one. */
export const findDisplay = () => findProgram(["Xvfb"]);

/** A display in memory, drawn on by the processor and in no language, where there is the program for it. */
export async function startDisplay() {
  const program = findDisplay();
  if (!program) return null;
  // It takes a free number and says which.
  const parameters = ["-displayfd", "1", "-screen", "0", "1400x1000x24", "-nolisten", "tcp"];
  const { sign, stop } = await start(program, parameters, /^(\d+)\n/m);
  return { stop, env: { DISPLAY: `:${sign}`, LIBGL_ALWAYS_SOFTWARE: "1", LC_ALL: "C.UTF-8" } };
}
