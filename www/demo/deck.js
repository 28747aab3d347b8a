// Slides: one section at a time, by keys, clicker, buttons, swipe or address.

/** A swipe is as long as this, in CSS pixels, and more across than along. */
const SWIPE = 50;

/** Slides on that keys go; a clicker sends Page Up and Page Down. @type {Record<string, number>} */
const moves = {
  ...{ ArrowRight: 1, ArrowDown: 1, PageDown: 1, End: Infinity },
  ...{ ArrowLeft: -1, ArrowUp: -1, PageUp: -1, Home: -Infinity },
};

/** @param {string} hash @returns {number} the slide in an address `#/3`, from 0; NaN for none */
export const slideIn = (hash) => Number(/^#\/(\d{1,3})$/.exec(hash)?.[1] ?? Number.NaN) - 1;

/** @param {HTMLElement[]} slides @param {(slide: HTMLElement, number: number) => void} onShow */
export function createDeck(slides, onShow) {
  let at = -1;

  /** @param {number} wanted @param {boolean} [byHand] */
  function show(wanted, byHand = true) {
    const next = Math.min(Math.max(wanted || 0, 0), slides.length - 1);
    if (next === at) return;
    at = next;
    // Hidden, not taken away: what runs in a slide rests, and is there when it is shown again.
    for (const [n, slide] of slides.entries()) slide.hidden = n !== at;
    history.replaceState(null, "", `#/${at + 1}`);
    // Reading aloud goes on where the eye is.
    if (byHand) slides[at].focus({ preventScroll: true });
    onShow(slides[at], at);
  }

  for (const [n, slide] of slides.entries()) {
    slide.tabIndex = -1;
    slide.setAttribute("aria-roledescription", "slide");
    const heading = slide.querySelector("h1, h2");
    if (heading) {
      heading.id = `slide-${n + 1}`;
      slide.setAttribute("aria-labelledby", heading.id);
    }
  }

  /** @param {string} key @returns {boolean} whether it is a key of the deck's */
  function press(key) {
    if (!Object.hasOwn(moves, key)) return false;
    show(at + moves[key]);
    return true;
  }
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    if (press(event.key)) event.preventDefault();
  });
  addEventListener("hashchange", () => show(slideIn(location.hash)));

  /** @type {Touch | undefined} */
  let first;
  addEventListener("touchstart", ({ touches }) => {
    first = touches.length === 1 ? touches[0] : undefined;
  });
  addEventListener("touchend", ({ changedTouches: [last] }) => {
    if (!first || !last) return;
    const [x, y] = [last.clientX - first.clientX, last.clientY - first.clientY];
    if (Math.abs(x) > SWIPE && Math.abs(x) > 2 * Math.abs(y)) show(at - Math.sign(x));
  });

  show(slideIn(location.hash), false);
  return { press, next: () => show(at + 1), previous: () => show(at - 1) };
}
