// The text of the slides: found, and replaced by its translation. A sentence with
// marks in it, as `Press <kbd>F</kbd> twice.`, is one sentence: its translation names the same
// marks, in any order, and the elements themselves are put in their new places.

/** Attributes that are read by people. */
const ATTRIBUTES = ["aria-label", "title", "placeholder", "alt"];
/** Elements that are marks within a sentence, when nothing fills them later. */
const MARKS = ["B", "EM", "KBD", "SUB", "SUP", "STRONG", "CODE", "SPAN"];
/** Not for people. */
const SKIPPED = ["SCRIPT", "STYLE", "META", "LINK", "NOSCRIPT", "MATH"];

const ELEMENT = 1;
const TEXT = 3;

/** @param {string | null} text */
const plain = (text) => (text ?? "").replace(/\s+/g, " ").trim();

/** Whether there is anything to translate: two letters of a word. @param {string} text */
const hasWords = (text) => /\p{L}{2}/u.test(text);

/** @param {Node} node */
const isBlank = (node) =>
  node.nodeType !== ELEMENT && (node.nodeType !== TEXT || !plain(node.nodeValue));

/** @param {Node} node */
function isMark(node) {
  return (
    MARKS.includes(node.nodeName) &&
    !(/** @type {Element} */ (node).getAttribute("id")) &&
    [...node.childNodes].every(({ nodeType }) => nodeType === TEXT)
  );
}

/** Whether an element is one sentence with marks in it. @param {Element} element */
function isMarked(element) {
  const nodes = [...element.childNodes].filter((node) => !isBlank(node));
  const elements = nodes.filter(({ nodeType }) => nodeType === ELEMENT);
  return elements.length > 0 && elements.length < nodes.length && elements.every(isMark);
}

/** @param {Element} element */
function markedText(element) {
  const parts = [...element.childNodes].map((node) => {
    if (node.nodeType === TEXT) return node.nodeValue ?? "";
    if (node.nodeType !== ELEMENT) return "";
    const name = node.nodeName.toLowerCase();
    return `<${name}>${plain(node.textContent)}</${name}>`;
  });
  return plain(parts.join(""));
}

/** @param {Element} element @param {string} text */
function putMarked(element, text) {
  const marks = [...element.childNodes].filter(({ nodeType }) => nodeType === ELEMENT);
  const parts = text.split(/<(\w+)>([^<]*)<\/\w+>/);
  /** @type {(Node | string)[]} */
  const nodes = [];
  for (let n = 0; n < parts.length; n += 3) {
    nodes.push(parts[n]);
    const mark = marks.findIndex(({ nodeName }) => nodeName.toLowerCase() === parts[n + 1]);
    if (mark < 0) continue;
    const [taken] = marks.splice(mark, 1);
    taken.textContent = parts[n + 2];
    nodes.push(taken);
  }
  element.replaceChildren(...nodes);
}

/**
 * Every text of a document, in its order.
 * @param {Element} root @param {(english: string, put: (text: string) => void) => void} visit
 */
export function visitTexts(root, visit) {
  /** @param {string} english @param {(text: string) => void} put */
  const offer = (english, put) => hasWords(english) && visit(english, put);
  /** @param {Element} element */
  function walk(element) {
    // Of MathML, browsers give names as they were written.
    if (SKIPPED.includes(element.nodeName.toUpperCase())) return;
    if (element.getAttribute("translate") === "no") return;
    for (const name of ATTRIBUTES) {
      const value = element.getAttribute(name);
      if (value) offer(plain(value), (text) => element.setAttribute(name, text));
    }
    if (isMarked(element)) return offer(markedText(element), (text) => putMarked(element, text));
    const inside = element.nodeName === "TEMPLATE" ? /** @type {any} */ (element).content : element;
    for (const node of [...inside.childNodes]) {
      if (node.nodeType === ELEMENT) walk(node);
      else if (!isBlank(node)) {
        // The space around a text keeps it apart from its neighbours.
        const [before] = /^\s*/.exec(node.nodeValue) ?? [""];
        const [after] = /\s*$/.exec(node.nodeValue) ?? [""];
        offer(plain(node.nodeValue), (text) => {
          node.nodeValue = before + text + after;
        });
      }
    }
  }
  walk(root);
}

/** @param {Element} root @param {(english: string) => string} translate */
export function translateDocument(root, translate) {
  visitTexts(root, (english, put) => put(translate(english)));
}
