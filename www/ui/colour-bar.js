// @ts-check
// The scale of the colours on the surface.

/** @import { PageState } from "../state.js" */

import { choices } from "../options.js";
import { byId, setText } from "./element.js";
import { formatShort } from "./number.js";

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

  function update() {
    const field = shown?.field ?? null;
    const kind = field ? String(field.signed) : "";
    if (kind !== painted) painted = field && paint(field.signed) ? kind : "";
    bar.hidden = !field || painted === "";
    if (!field) return;
    const name = choices.colour.find(({ id }) => id === field.name)?.label ?? field.label;
    const from = formatShort(field.low);
    const to = formatShort(field.high);
    setText(low, from);
    setText(label, name);
    setText(high, to);
    scale.ariaLabel = `Colours: ${name} from ${from} to ${to}`;
  }

  // A scene from a link may stand still, coloured, before the viewer is there.
  pictured.then(update);
  return {
    /** @param {Readonly<PageState>} state */
    update({ frame }) {
      shown = frame;
      update();
    },
  };
}
