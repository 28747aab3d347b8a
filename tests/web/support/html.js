// @ts-check
// As much of an HTML parser as our own page needs: elements that are closed, attributes in
// double quotes. The nodes have what `www/document-text.js` asks of the browser's.

const VOID = ["meta", "link", "input", "br", "path"];

class FakeNode {
  nodeType = 3;
  nodeName = "#text";
  /** @type {any[]} */
  childNodes = [];
  /** @type {Map<string, string>} */
  attributes = new Map();
  nodeValue = "";

  /** @returns {string} */
  get textContent() {
    if (this.nodeType === 3) return this.nodeValue;
    return this.childNodes.map((/** @type {FakeNode} */ node) => node.textContent).join("");
  }
  set textContent(text) {
    this.replaceChildren(text);
  }
  /** Of a template. */
  get content() {
    return this;
  }
  /** @param {string} name */
  getAttribute(name) {
    return this.attributes.get(name) ?? null;
  }
  /** @param {string} name @param {string} value */
  setAttribute(name, value) {
    this.attributes.set(name, value);
  }
  /** @param {(FakeNode | string)[]} nodes */
  replaceChildren(...nodes) {
    this.childNodes = nodes.map((node) => (typeof node === "string" ? textNode(node) : node));
  }
}

/** @param {string} text */
function textNode(text) {
  const node = new FakeNode();
  node.nodeValue = text;
  return node;
}

/** @param {string} html @returns {any} an element around it all */
export function parseHtml(html) {
  const root = new FakeNode();
  Object.assign(root, { nodeType: 1, nodeName: "#root" });
  const open = [root];
  const pieces = html
    .replace(/<!--.*?-->/gs, "")
    .matchAll(/<(\/?)([\w!-]+)((?:[^>"]|"[^"]*")*)>|([^<]+)/g);
  for (const [, closing, name, attributes, text] of pieces) {
    const inside = open[open.length - 1];
    if (text) inside.childNodes.push(textNode(text));
    else if (closing) {
      const left = open.pop();
      if (left?.nodeName !== name.toUpperCase())
        throw new Error(`</${name}> closes ${left?.nodeName}`);
    } else if (name !== "!doctype") {
      const element = new FakeNode();
      Object.assign(element, { nodeType: 1, nodeName: name.toUpperCase() });
      for (const [, key, value] of attributes.matchAll(/([\w-]+)="([^"]*)"/g)) {
        element.setAttribute(key, value);
      }
      inside.childNodes.push(element);
      if (!VOID.includes(name) && !attributes.endsWith("/")) open.push(element);
    }
  }
  if (open.length > 1) throw new Error(`<${open[open.length - 1].nodeName}> is not closed`);
  return root;
}
