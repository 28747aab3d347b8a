// The words that are read before there is a solver.

/** @type {Record<string, string>} */
const files = import.meta.glob("./{first,viewer}.ftl", {
  query: "?raw",
  import: "default",
  eager: true,
});

export default Object.values(files).join("\n");
