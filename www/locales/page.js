// The words of each language in the page. English comes along as far as it is read before there
// is a solver; all others are fetched.

const first = ["first", "viewer"];

/** @type {Record<string, string>} */
const files = import.meta.glob("./en/{first,viewer}.ftl", {
  query: "?raw",
  import: "default",
  eager: true,
});
/** @type {Record<string, any>} a way to fetch each */
const fetched = import.meta.glob(["./*/*.ftl", "!./en/{first,viewer}.ftl"], {
  query: "?raw",
  import: "default",
});

export const english = Object.values(files).join("\n");

/**
 * @param {"en" | "de"} language
 * @param {"first" | "rest"} part  what is read before there is a solver, or all else
 */
export async function fetchWords(language, part) {
  if (language === "en" && part === "first") return english;
  const isFirst = (/** @type {string} */ file) =>
    first.some((name) => file.endsWith(`/${name}.ftl`));
  const names = Object.keys(fetched).filter(
    (file) => file.startsWith(`./${language}/`) && isFirst(file) === (part === "first"),
  );
  return (await Promise.all(names.map((name) => fetched[name]()))).join("\n");
}
