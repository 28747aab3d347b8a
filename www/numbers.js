// How the file at hand numbers the vertices and faces that sentences name.

/** @import { Numbers } from "./generated/types.js" */

/** @type {Numbers} */
let numbers = { first: 0, vertices: null, faces: null };

/** What is named from now on is of another surface. @param {Numbers | undefined} next */
export function numberAs(next) {
  numbers = next ?? { first: 0, vertices: null, faces: null };
}

/** Of the first vertex. */
export const firstNumber = () => numbers.first;

/** The file's number of an element. @param {"vertices" | "faces"} what @param {number} n */
export const numberOf = (what, n) => (numbers[what]?.[n] ?? n) + numbers.first;

/** The vertex of a number; -1 where there is none. @param {number} number */
export function vertexOf(number) {
  const n = number - numbers.first;
  return numbers.vertices ? numbers.vertices.indexOf(n) : n;
}
