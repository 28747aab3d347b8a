// @ts-check
// Builds the parts, wires them to the state, and opens the scene in the address.

import { createController } from "./controller.js";
import { createLinkWriter, readLink } from "./link.js";
import { samples } from "./samples.js";
import { createStore } from "./state.js";
import { createChoices } from "./ui/choices.js";
import { createHelp, createPanel, createPresenter } from "./ui/chrome.js";
import { createColourBar } from "./ui/colour-bar.js";
import { createConjecture } from "./ui/conjecture.js";
import { createCurvatureForm } from "./ui/curvature-form.js";
import { createDownload } from "./ui/download.js";
import { createEnergyPlot } from "./ui/energy-plot.js";
import { createFlipPlots } from "./ui/flip-plots.js";
import { createFlipsForm } from "./ui/flips-form.js";
import { createGallery } from "./ui/gallery.js";
import { createHoles } from "./ui/holes.js";
import { createKeys } from "./ui/keys.js";
import { createLab } from "./ui/lab.js";
import { createMeshInput } from "./ui/mesh-input.js";
import { createMessages } from "./ui/messages.js";
import { createMethodForm } from "./ui/method-form.js";
import { createPWillmoreForm } from "./ui/p-willmore-form.js";
import { createPanes } from "./ui/panes.js";
import { createPicture } from "./ui/picture.js";
import { createReadings } from "./ui/readings.js";
import { createRecord } from "./ui/record.js";
import { createRegion } from "./ui/region.js";
import { createScrubber } from "./ui/scrubber.js";
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
createLab(controller);
createKeys(controller, help.open);
createDownload(controller, store.get, picture.snapshot);
/** A link to a mesh names it only; its scene waits for the user to open the file. */
let awaited = readLink(location);
// The page without a link shows its sample before the solver is there.
const isFirst = awaited.sample === samples[0].id && awaited.step === 0 && !awaited.camera;
controller.view(awaited.view);
const pictured = picture.start(isFirst ? samples[0].parameters.level : null);

const parts = [
  createTransport(controller),
  createScrubber(controller),
  createStatus(),
  createChoices(controller),
  createReadings(),
  createPWillmoreForm(controller),
  createFlipsForm(controller),
  createCurvatureForm(controller),
  createHoles(controller, picture.nearestEdge),
  createRecord(controller, store.get, picture.snapshot),
  createRegion(controller, picture),
  createMethodForm(controller),
  createViewForm(controller, picture.fit),
  picture,
  createPanes(controller, msaa),
  createColourBar(picture.colours, pictured),
  createEnergyPlot(controller, pictured),
  createFlipPlots(controller),
  createConjecture(controller, picture.nearestEdge),
  createGallery(controller),
  createPresenter(controller),
  createLinkWriter(),
  help,
];
for (const part of parts) store.subscribe((state) => part.update(state));

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

createMeshInput(async (file) => {
  const isAwaited = awaited.mesh !== null && file.name.replace(/\.[^.]+$/, "") === awaited.mesh;
  const open = () => controller.open(file, isAwaited ? awaited : {});
  if (!(await controller.takes(file, open))) open();
});

// The event's address and not `location`: by now the old scene may have been written there.
addEventListener("hashchange", ({ newURL }) => openLink(new URL(newURL)));
// The solver is the larger half: the first picture does not wait for it to be fetched, nor
// the solver for a picture that takes its time.
const patience = new Promise((resolve) => setTimeout(resolve, 4000));
(isFirst ? Promise.race([pictured, patience]) : Promise.resolve()).then(() => {
  controller.begin();
  openLink(location);
});
