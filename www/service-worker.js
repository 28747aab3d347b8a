// The site without a connection: keeps its files, and answers with those of one version only.
// The build puts this at the root of the site, with a list of its files in front
// (www/tools/service-worker.js); every file is checked against its SHA-256 as it comes in.

/**
 * What is used here of a service worker's scope; the types of a page's do not have it.
 * @typedef {object} Scope
 * @property {{ version: string, core: Record<string, string>, later: Record<string, string> }} built
 *   paths and their integrity: `core` is kept at once, `later` when there is time
 * @property {Location} location
 * @property {() => Promise<void>} skipWaiting
 * @property {{ matchAll: (options: object) => Promise<unknown[]> }} clients
 * @property {(type: string, listener: (event: any) => void) => void} addEventListener
 */
const scope = /** @type {Scope} */ (/** @type {unknown} */ (self));
const { version, core, later } = scope.built;
const files = { ...core, ...later };

const root = new URL("./", scope.location.href).href;
/** Of this copy of the site: a host may have several, in folders of their own. */
const prefix = `umbilic ${root} `;
const own = prefix + version;

/** All caches of this copy, oldest first. */
const kept = async () => (await caches.keys()).filter((name) => name.startsWith(prefix));

/** @param {string} path @returns {Promise<Response | undefined>} from whatever version has it */
async function find(path) {
  for (const name of (await kept()).reverse()) {
    const found = await (await caches.open(name)).match(root + path);
    if (found) return found;
  }
  return undefined;
}

/** @param {Response} response @param {string} integrity */
async function matches(response, integrity) {
  const digest = await crypto.subtle.digest("SHA-256", await response.clone().arrayBuffer());
  return `sha256-${btoa(String.fromCharCode(...new Uint8Array(digest)))}` === integrity;
}

/** A file of this version, kept from now on. @param {string} path @returns {Promise<Response>} */
async function keep(path) {
  const integrity = files[path];
  const cache = await caches.open(own);
  const before = await cache.match(root + path);
  if (before) return before;
  const older = await find(path);
  // Most files of a new version are those of the one before.
  if (older && (await matches(older, integrity))) {
    await cache.put(root + path, older.clone());
    return older;
  }
  // A host may send index.html on to its folder, or the other way round.
  const address = path === "index.html" ? root : root + path;
  const fetched = await fetch(address, { integrity, cache: "no-cache" });
  if (!fetched.ok) throw new Error(`${path}: ${fetched.status}`);
  // Made anew: a browser refuses to navigate to what was redirected.
  const headers = { "content-type": fetched.headers.get("content-type") ?? "" };
  const response = new Response(await fetched.blob(), { headers });
  await cache.put(root + path, response.clone());
  return response;
}

/** @param {string} path @param {Request} request */
async function answer(path, request) {
  // What is not among these is of a page of the version before, still open.
  const known = Object.hasOwn(files, path) ? keep(path).catch(() => undefined) : find(path);
  return (await known) ?? fetch(request);
}

scope.addEventListener("install", (event) => {
  // All or nothing: a site that is just being replaced fails its checks, and is tried again.
  const all = Promise.all(Object.keys(core).map(keep));
  const failed = (/** @type {unknown} */ reason) =>
    caches.delete(own).then(() => Promise.reject(reason));
  event.waitUntil(all.then(() => scope.skipWaiting(), failed));
});

scope.addEventListener("fetch", (event) => {
  /** @type {Request} */
  const request = event.request;
  const { origin, pathname } = new URL(request.url);
  const address = origin + pathname;
  if (request.method !== "GET" || !address.startsWith(root)) return;
  const path = address.slice(root.length) || "index.html";
  const isOurs = Object.hasOwn(files, path) || path.startsWith("assets/");
  if (isOurs) event.respondWith(answer(path, request));
});

/** Keeps the rest, and lets go of versions that no open page is of. @param {string} script  of the page */
async function settle(script) {
  for (const path of Object.keys(later)) await keep(path);
  const pages = await scope.clients.matchAll({ type: "window", includeUncontrolled: true });
  const isCurrent = Object.hasOwn(files, script.slice(root.length));
  if (pages.length > 1 || !isCurrent) return;
  for (const name of await kept()) if (name !== own) await caches.delete(name);
}

scope.addEventListener("message", (event) => {
  if (event.data?.type !== "idle" || typeof event.data.script !== "string") return;
  event.waitUntil(settle(event.data.script).catch(() => {}));
});
