// @ts-check
// Builds the parts, wires them to the state, and opens the scene in the address.

import { createController } from "./controller.js";
import { createLinkWriter, readLink } from "./link.js";
import { createStore } from "./state.js";
import { createChoices } from "./ui/choices.js";
import { createHelp, createPanel, createPresenter } from "./ui/chrome.js";
import { createColourBar } from "./ui/colour-bar.js";
import { createDownload } from "./ui/download.js";
import { createEnergyPlot } from "./ui/energy-plot.js";
import { createKeys } from "./ui/keys.js";
import { createMeshInput } from "./ui/mesh-input.js";
import { createMessages } from "./ui/messages.js";
import { createMethodForm } from "./ui/method-form.js";
import { createPicture } from "./ui/picture.js";
import { createReadings } from "./ui/readings.js";
import { createStatus } from "./ui/status.js";
import { createTransport } from "./ui/transport.js";
import { createViewForm } from "./ui/view-form.js";

const store = createStore();
const messages = createMessages();
const controller = createController(store, messages);
// Fewer samples a pixel draw faster where there is no graphics card.
const msaa = new URLSearchParams(location.search).get("msaa") === "1" ? 1 : 4;
const picture = createPicture(controller, store.get, msaa);
const help = createHelp();

createPanel();
createKeys(controller, help.open);
createDownload(controller, store.get, picture.snapshot);
const pictured = picture.start();

const parts = [
  createTransport(controller),
  createStatus(),
  createChoices(controller),
  createReadings(),
  createMethodForm(controller),
  createViewForm(controller, picture.fit),
  picture,
  createColourBar(picture.colours, pictured),
  createEnergyPlot(controller, pictured),
  createPresenter(controller),
  createLinkWriter(),
  help,
];
for (const part of parts) store.subscribe((state) => part.update(state));

/** A link to a mesh names it only; its scene waits for the user to open the file. */
let awaited = readLink(location);

/** @param {{ search: string, hash: string }} address */
function openLink(address) {
  awaited = readLink(address);
  controller.view(awaited.view);
  if (awaited.sample) controller.sample(awaited.sample, awaited);
  else {
    const message = `This link shows the mesh “${awaited.mesh}”, a file on its author’s computer.`;
    messages.error({ message, hint: "Open that file here; the scene then follows." });
  }
}

createMeshInput((file) => {
  const isAwaited = awaited.mesh !== null && file.name.replace(/\.[^.]+$/, "") === awaited.mesh;
  controller.open(file, isAwaited ? awaited : {});
});

// The event's address and not `location`: by now the old scene may have been written there.
addEventListener("hashchange", ({ newURL }) => openLink(new URL(newURL)));
openLink(location);
