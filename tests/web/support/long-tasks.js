// @ts-check
// Tasks of the main thread that last longer than 50 ms, as the browser itself counts them.

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {{ start: number, duration: number }} Task  in milliseconds */

/** Rounds that a test takes at most. */
const ROUNDS = 3;

/** To be called before the page is opened. @param {Page} page */
export async function watchLongTasks(page) {
  await page.addInitScript(() => {
    /** @type {Task[]} */
    const tasks = [];
    Object.assign(globalThis, { longTasks: tasks });
    new PerformanceObserver((list) => {
      for (const { startTime, duration } of list.getEntries()) {
        tasks.push({ start: startTime, duration });
      }
    }).observe({ type: "longtask", buffered: true });
  });
}

/** Since the page began. @param {Page} page @returns {Promise<Task[]>} */
export const longTasks = (page) => page.evaluate(() => /** @type {any} */ (globalThis).longTasks);

/** On the clock of the tasks. @param {Page} page @returns {Promise<number>} */
export const now = (page) => page.evaluate(() => performance.now());

/** @param {Task[]} tasks */
export const durations = (tasks) =>
  tasks.map(({ duration }) => `${duration.toFixed(0)} ms`).join(", ") || "none";

/**
 * Long tasks of some work. On a busy machine a task may be long because it had to wait for its
 * turn; what is long by itself is long every time, so the work is done again a few times if need
 * be.
 * @param {Page} page
 * @param {(round: number) => Promise<void>} work
 * @param {(text: string) => void} tell  of each round
 * @returns {Promise<Task[]>} those of the last round
 */
export async function lastingLongTasks(page, work, tell) {
  /** @type {Task[]} */
  let long = [];
  for (let round = 1; round <= ROUNDS; round += 1) {
    const began = await now(page);
    await work(round);
    long = (await longTasks(page)).filter(({ start }) => start >= began);
    tell(`round ${round}: ${durations(long)}`);
    if (long.length === 0) break;
  }
  return long;
}
