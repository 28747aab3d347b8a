// @ts-check
// As much of TeX as the formulas of the tables use, as MathML.

const NAMESPACE = "http://www.w3.org/1998/Math/MathML";

/** @type {Record<string, string>} */
const symbols = {
  ...{ nabla: "∇", Delta: "Δ", sum: "∑", int: "∫", beta: "β", pi: "π", epsilon: "ε", lambda: "λ" },
  ...{ mu: "μ", tau: "τ", varphi: "φ", sigma: "σ", kappa: "κ", alpha: "α", mapsto: "↦", cdot: "·" },
  ...{
    Pi: "Π",
    ell: "ℓ",
    quad: "\u2003",
    ",": "\u2009",
    ";": "\u2005",
    "|": "‖",
    langle: "⟨",
    rangle: "⟩",
  },
};
/** Sizes of brackets that MathML finds by itself. */
const sizes = ["bigl", "bigr", "Bigl", "Bigr", "left", "right"];

/** @param {string} name @param {...(Element | string)} children */
function element(name, ...children) {
  const made = document.createElementNS(NAMESPACE, name);
  made.append(...children);
  return made;
}

/** @param {string} text */
function letter(text) {
  const name = /^[\d.]+$/.test(text) ? "mn" : /^[\p{L}∞]$/u.test(text) ? "mi" : "mo";
  const made = element(name, text === "-" ? "−" : text);
  if (name === "mo") made.setAttribute("stretchy", "false");
  return made;
}

/** @param {string} source @returns {Element} */
function parse(source) {
  const tokens = source.match(/\\[a-zA-Z]+|\\.|[\d.]+|[^\s]/g) ?? [];
  let at = 0;

  /** @returns {Element} */
  function group() {
    const parts = [];
    while (at < tokens.length && tokens[at] !== "}") parts.push(scripted());
    at += 1;
    return parts.length === 1 ? parts[0] : element("mrow", ...parts);
  }
  /** @returns {Element} one part with what hangs on it */
  function scripted() {
    const base = atom();
    /** @type {Record<string, Element>} */
    const scripts = {};
    while (tokens[at] === "^" || tokens[at] === "_") {
      const kind = tokens[at];
      at += 1;
      scripts[kind] = atom();
    }
    const { "^": above, _: below } = scripts;
    if (above && below) return element("msubsup", base, below, above);
    if (above) return element("msup", base, above);
    return below ? element(base.textContent === "∑" ? "munder" : "msub", base, below) : base;
  }
  /** @returns {Element} */
  function atom() {
    const token = tokens[at] ?? "";
    at += 1;
    if (token === "{") return group();
    if (!token.startsWith("\\")) return letter(token);
    const name = token.slice(1);
    if (name === "dot") return element("mover", atom(), element("mo", "˙"));
    if (name === "sqrt") return element("msqrt", atom());
    if (name === "frac") return element("mfrac", atom(), atom());
    if (name === "tfrac") {
      // As in \tfrac12.
      const digits = tokens[at] ?? "";
      if (!/^\d\d$/.test(digits)) return element("mfrac", atom(), atom());
      at += 1;
      return element("mfrac", letter(digits[0]), letter(digits[1]));
    }
    if (name === "text") {
      let depth = 1;
      const from = source.indexOf("{", place(at - 1)) + 1;
      let to = from;
      for (; depth > 0 && to < source.length; to += 1)
        depth += source[to] === "{" ? 1 : source[to] === "}" ? -1 : 0;
      while (at < tokens.length && place(at) < to) at += 1;
      return element("mtext", `\u2005${source.slice(from, to - 1)}\u2005`);
    }
    if (sizes.includes(name)) {
      const bracket = atom();
      bracket.setAttribute("stretchy", "true");
      return bracket;
    }
    const symbol = symbols[name] ?? name;
    return /^\s$/.test(symbol) ? element("mtext", symbol) : letter(symbol);
  }
  /** @type {number[]} */
  const places = [];
  let from = 0;
  for (const token of tokens) {
    places.push(source.indexOf(token, from));
    from = places[places.length - 1] + token.length;
  }
  const place = (/** @type {number} */ n) => places[n] ?? source.length;
  return element("math", group());
}

/** @type {Map<string, Element>} */
const known = new Map();

/** @param {string} source @param {boolean} [isBlock] */
export function tex(source, isBlock = false) {
  const made = known.get(source) ?? parse(source);
  known.set(source, made);
  const copy = /** @type {Element} */ (made.cloneNode(true));
  if (isBlock) copy.setAttribute("display", "block");
  return copy;
}
