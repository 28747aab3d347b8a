// All words of the page but those that are read before there is a solver, as one file: it packs the
// better.

/** @type {Record<string, string>} */
const files = import.meta.glob(["./*.ftl", "!./{command,first,viewer}.ftl"], {
  query: "?raw",
  import: "default",
  eager: true,
});

export default Object.values(files).join("\n");
