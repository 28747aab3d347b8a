// @ts-check
// The language of the page. It is spoken from the first sentence on, so another one takes loading
// the page again: at once where nothing is lost by that, else when the user says so.

/** @import { Controller } from "../controller.js" */
/** @import { PageState } from "../state.js" */

import { currentLanguage, languages, rememberLanguage } from "../language.js";

/**
 * Loads the page again, in this language.
 * @param {string} language @param {Pick<Controller, "writeLink">} controller
 */
async function reload(language, controller) {
  // The address follows the scene with a delay, which there is no time for now.
  const link = await controller.writeLink().catch(() => null);
  if (link) history.replaceState(null, "", `#${link.text}`);
  const kept = rememberLanguage(/** @type {keyof typeof languages} */ (language));
  const address = new URL(location.href);
  // What the address asks for goes before what is remembered.
  if (kept && !address.searchParams.has("lang")) return location.reload();
  address.searchParams.set("lang", language);
  location.replace(address);
}

/** Whether the address alone brings everything back, and at once. @param {Readonly<PageState>} state */
const isInAddress = ({ source, reading, earlier }) =>
  source?.kind === "sample" && reading?.step === 0 && earlier.length === 0;

/** @param {Pick<Controller, "writeLink">} controller @param {() => Readonly<PageState>} state */
export function createLanguageChoice(controller, state) {
  /** @type {NodeListOf<HTMLSelectElement>} */
  const selects = document.querySelectorAll("[data-language]");
  /** @type {NodeListOf<HTMLElement>} */
  const notes = document.querySelectorAll("[data-language-note]");
  for (const select of selects) {
    // Each by its own name, whatever the page speaks.
    select.replaceChildren(
      ...Object.entries(languages).map(([id, name]) => {
        const option = new Option(name, id);
        option.lang = id;
        return option;
      }),
    );
    select.value = currentLanguage();
    select.addEventListener("change", () => {
      const isOther = select.value !== currentLanguage();
      if (isOther && isInAddress(state())) return reload(select.value, controller);
      for (const one of selects) one.value = select.value;
      for (const note of notes) note.hidden = !isOther;
    });
  }
  for (const note of notes) {
    note
      .querySelector("button")
      ?.addEventListener("click", () => reload(selects[0].value, controller));
  }
}
