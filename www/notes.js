// What is said to the user: a line at a time, in the status line. Refusals stay until they are
// dismissed, other lines go to a list after a while. Nothing is said twice.

/** @import { Note, Store } from "./store.js" */

/** Milliseconds a line stays. */
const STAYS = 6000;
/** Lines that the list keeps. */
const MOST = 20;

/** @param {Store} store */
export function createNotes(store) {
  let lastId = 0;
  /** @type {Set<string>} */
  const told = new Set();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  /** The next line, once this one has been read. */
  function next() {
    clearTimeout(timer);
    const { notes, noteShown } = store.get();
    const later = notes.find(({ id }) => id > noteShown);
    const isError = notes.some(({ kind }) => kind === "error");
    if (!later) return void store.patch({ noteShown: lastId, isNoteFresh: isError });
    store.patch({ noteShown: later.id, isNoteFresh: true });
    timer = setTimeout(next, STAYS);
  }

  /** @param {(note: Note) => boolean} isPast */
  function drop(isPast) {
    const { notes } = store.get();
    if (!notes.some(isPast)) return;
    store.patch({ notes: notes.filter((one) => !isPast(one)) });
    next();
  }

  /** @param {Note["kind"]} kind @param {string} text @param {string} hint @param {Note["offers"]} offers */
  function add(kind, text, hint, offers) {
    lastId += 1;
    const { notes, isNoteFresh } = store.get();
    const others = notes.filter((one) => one.text !== text);
    const kept = kind === "answer" ? others.filter((one) => one.kind !== "answer") : others;
    const added = { id: lastId, kind, text, hint, offers };
    store.patch({ notes: [...kept, added].slice(-MOST) });
    if (kind !== "note" || !isNoteFresh) {
      store.patch({ noteShown: lastId - 1 });
      next();
    }
  }

  return {
    /** Worth knowing, said once; of what has the same key, once for all. @param {string} text @param {string} [key] */
    note(text, key = text) {
      if (told.has(key)) return;
      told.add(key);
      add("note", text, "", []);
    },
    /** To what was asked for: said every time. @param {string} text */
    answer: (text) => add("answer", text, "", []),
    /** @param {{ message: string, hint: string }} fault @param {Note["offers"]} [offers] */
    error: ({ message, hint }, offers = []) => add("error", message, hint, offers),
    /** @param {number} id */
    dismiss: (id) => drop((one) => one.id === id),
    /** What was refused has been done otherwise. */
    settle: () => drop(({ kind }) => kind === "error"),
    /** Whether to do what takes long. @param {string} text @returns {Promise<boolean>} */
    ask: (text) =>
      new Promise((resolve) => {
        const answer = (/** @type {boolean} */ yes) => {
          store.patch({ question: null });
          resolve(yes);
        };
        store.patch({ question: { text, answer } });
      }),
    /** What was said of the mesh before no longer holds. */
    clear() {
      told.clear();
      clearTimeout(timer);
      store.patch({ notes: [], isNoteFresh: false });
    },
  };
}

/** @typedef {ReturnType<typeof createNotes>} Notes */
