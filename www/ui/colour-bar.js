// @ts-check
// The scale of the colours on the surface.

/** @import { Field } from "../state.js" */
/** @import { PageState } from "../state.js" */

import { t, translated } from "../language.js";
import { choices } from "../options.js";
import { hasContrast } from "../state.js";
import { byId, setText } from "./element.js";
import { formatShort } from "./number.js";

/** What a surface is coloured by. @param {Pick<Field, "name" | "label">} field */
export const colourLabel = ({ name, label }) =>
  label ?? translated(choices.colour.find(({ id }) => id === name)?.label ?? name);

/**
 * @param {(signed: boolean, count: number) => Uint8Array | null} colours  rgb, as the surface is painted
 * @param {Promise<unknown>} pictured  settled once the viewer, who knows the colours, is there
 */
export function createColourBar(colours, pictured) {
  const bar = byId("colour-bar", HTMLElement);
  const scale = byId("colour-bar-scale", HTMLCanvasElement);
  const low = byId("colour-bar-low", HTMLElement);
  const label = byId("colour-bar-label", HTMLElement);
  const high = byId("colour-bar-high", HTMLElement);

  /** @param {boolean} signed @returns {boolean} whether there is anything to see */
  function paint(signed) {
    const rgb = colours(signed, scale.width);
    const context = scale.getContext("2d");
    if (!rgb || !context) return false;
    const picture = context.createImageData(scale.width, 1);
    for (let i = 0; i < scale.width; i += 1) {
      picture.data.set([rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2], 255], 4 * i);
    }
    context.putImageData(picture, 0, 0);
    return true;
  }

  let painted = "";
  /** @type {PageState["frame"]} */
  let shown = null;
  let contrast = false;

  function update() {
    const field = shown?.field ?? null;
    const kind = field ? `${field.signed} ${contrast}` : "";
    if (kind !== painted) painted = field && paint(field.signed) ? kind : "";
    bar.hidden = !field || painted === "";
    if (!field) return;
    const name = colourLabel(field);
    const from = formatShort(field.low);
    const to = formatShort(field.high);
    setText(low, from);
    setText(label, name);
    setText(high, to);
    scale.ariaLabel = t("Colours: {name} from {from} to {to}", { name, from, to });
  }

  // A scene from a link may stand still, coloured, before the viewer is there.
  pictured.then(update);
  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      shown = state.frame;
      contrast = hasContrast(state);
      update();
    },
  };
}
