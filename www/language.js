// @ts-check
// What the page says to people goes through `t`.

/**
 * A sentence with its values in place. Numbers in it are formatted before.
 * @param {string} english  with `{name}` where a value stands
 * @param {Readonly<Record<string, string | number>>} [values]
 */
export function t(english, values = {}) {
  return english.replace(/\{(\w+)\}/g, (whole, name) =>
    Object.hasOwn(values, name) ? String(values[name]) : whole,
  );
}
