// Keeps the built site for when there is no connection. A page that cannot do that works as
// before, and says nothing of it.

import { say } from "./words.js";

/** Milliseconds after the first picture until the rest of the site is fetched. */
const CALM = 5000;

/** @returns {ServiceWorkerContainer | undefined} */
function containerIfAny() {
  try {
    return import.meta.env.PROD ? navigator.serviceWorker : undefined;
  } catch {
    // In a sandbox of no origin even asking is forbidden.
    return undefined;
  }
}

const container = containerIfAny();
/** Whether this very page came from a worker, which another may replace. */
const isKept = Boolean(container?.controller);

/**
 * @param {Promise<unknown>} pictured  the page shows its scene; nothing is fetched or said before
 * @param {(text: string) => void} note
 */
export async function keepOffline(pictured, note) {
  if (!container) return;
  container.addEventListener("controllerchange", async () => {
    await pictured;
    if (isKept) note(say("new-version"));
  });
  try {
    await pictured;
    const script = new URL("./service-worker.js", document.baseURI);
    await container.register(script, { updateViaCache: "none" });
    const { active } = await container.ready;
    await new Promise((resolve) => setTimeout(resolve, CALM));
    const { saveData = false } = /** @type {any} */ (navigator).connection ?? {};
    if (!saveData) active?.postMessage({ type: "idle", script: import.meta.url });
  } catch {
    // Not over https, or not allowed: there is always the network.
  }
}
