// @ts-check
// Builds the parts, wires them to the state, and opens the scene in the address.

import { createArrival, sceneOfFigure } from "./arrival.js";
import { createController } from "./controller.js";
import { createEmbedding, isEmbedded } from "./embed/host.js";
import { samples } from "./generated/library.js";
import { openLanguage, t } from "./language.js";
import { createLinkWriter, readLink, sceneOf } from "./link.js";
import { keepOffline } from "./offline.js";
import { createStore } from "./state.js";
import { createChoices } from "./ui/choices.js";
import { createHelp, createPanel } from "./ui/chrome.js";
import { createColourBar } from "./ui/colour-bar.js";
import { createComparisonForm } from "./ui/comparison-form.js";
import { createComparisonPlot } from "./ui/comparison-plot.js";
import { createConjecture } from "./ui/conjecture.js";
import { createCrossings } from "./ui/crossings.js";
import { createCurvatureForm } from "./ui/curvature-form.js";
import { createDownload } from "./ui/download.js";
import { createEditsForm } from "./ui/edits.js";
import { createEnergyPlot } from "./ui/energy-plot.js";
import { createEquations } from "./ui/equations.js";
import { createFlipPlots } from "./ui/flip-plots.js";
import { createFlipsForm } from "./ui/flips-form.js";
import { createGallery } from "./ui/gallery.js";
import { createGoingOn } from "./ui/going-on.js";
import { createHistogram } from "./ui/histogram.js";
import { createHoles } from "./ui/holes.js";
import { createKeys } from "./ui/keys.js";
import { createLab } from "./ui/lab.js";
import { createLanguageChoice } from "./ui/language-choice.js";
import { createLook } from "./ui/look.js";
import { createMeshInput } from "./ui/mesh-input.js";
import { createMessages } from "./ui/messages.js";
import { createMethodForm } from "./ui/method-form.js";
import { createMoebius } from "./ui/moebius.js";
import { createPWillmoreForm } from "./ui/p-willmore-form.js";
import { createPanes } from "./ui/panes.js";
import { createPicture } from "./ui/picture.js";
import { createPresenter } from "./ui/presenter.js";
import { createReadings } from "./ui/readings.js";
import { createRecord } from "./ui/record.js";
import { createRegion } from "./ui/region.js";
import { createScrubber } from "./ui/scrubber.js";
import { createShare } from "./ui/share.js";
import { createStatus } from "./ui/status.js";
import { createStudy } from "./ui/study.js";
import { createTransport } from "./ui/transport.js";
import { createViewForm } from "./ui/view-form.js";
import { createWhy } from "./ui/why.js";

// Sentences are made when the parts are built: the language comes first.
await openLanguage();
const store = createStore();
const messages = createMessages();
const controller = createController(store, messages);
// Fewer samples a pixel draw faster where there is no graphics card.
const msaa = new URLSearchParams(location.search).get("msaa") === "1" ? 1 : 4;
const picture = createPicture(controller, store.get, msaa);
const panes = createPanes(controller, picture, msaa);
const help = createHelp();
const arrival = createArrival(controller, store.get, messages);
const gallery = createGallery(controller);
const study = createStudy(controller);

createPanel();
createLanguageChoice(store.get);
createLab(controller);
createKeys(controller, store.get, help.open);
createDownload(controller, store.get, panes.snapshot);
const first = readLink(location);
// The page without a link shows its sample before the solver is there.
const isFirst = first.sample === samples[0].id && first.step === 0 && !first.camera;
controller.view(first.view);
/** A link to a mesh names it only; its scene waits for the user to open the file. */
let awaited = sceneOf(readLink({ search: "", hash: "" }));
const pictured = picture.start(isFirst ? samples[0].parameters.level : null);

const { get } = store;
const { snapshot } = panes;
const { still } = arrival;
const embedding = isEmbedded(location)
  ? createEmbedding({ controller, get, still, openLink, messages, snapshot })
  : null;

const parts = [
  createTransport(controller),
  createScrubber(controller),
  createGoingOn(controller),
  createStatus(),
  createWhy(controller, messages, { camera: picture.camera, study: study.begin }),
  createChoices(controller),
  createReadings(),
  study,
  createPWillmoreForm(controller),
  createFlipsForm(controller),
  createCurvatureForm(controller),
  createHoles(controller, picture.nearestEdge),
  createEditsForm(controller),
  createRecord(controller, store.get, panes),
  createRegion(controller, picture),
  createMethodForm(controller),
  createViewForm(controller, picture.fit),
  picture,
  createMoebius(controller, picture, pictured),
  createLook(controller, picture),
  createCrossings(controller),
  createHistogram(picture.colours),
  createEquations(),
  panes,
  createComparisonForm(controller),
  createComparisonPlot(controller),
  createColourBar(picture.colours, pictured),
  createEnergyPlot(controller, pictured),
  createFlipPlots(controller),
  createConjecture(controller, picture.nearestEdge),
  gallery,
  createPresenter(controller, store.get, gallery.open),
  embedding ?? createLinkWriter(),
  createShare(),
  arrival,
  help,
];
for (const part of parts) store.subscribe((state) => part.update(state));

/** @param {{ search: string, hash: string }} address */
async function openLink(address) {
  let scene;
  try {
    scene = await controller.sceneOf(readLink(address));
  } catch (error) {
    // Where nothing is shown yet, that would be a dead end; a mesh that is loaded clears what was
    // said before.
    if (!store.get().mesh) await controller.sample(samples[0].id);
    return controller.report(error);
  }
  awaited = scene;
  controller.view(awaited.view);
  if (scene.sample) return controller.sample(scene.sample, scene).then(() => arrival.check(scene));
  if (scene.figure) {
    try {
      const whole = sceneOfFigure(scene);
      return controller.sample(whole.sample, whole).then(() => arrival.check(whole));
    } catch (error) {
      return controller.report(error);
    }
  }
  messages.error({
    message: t("This link shows the mesh “{mesh}”, a file on its author’s computer.", {
      mesh: awaited.mesh ?? "",
    }),
    hint: t("Open that file here; the scene then follows."),
  });
}

// Whoever embeds the page could take away what a visitor opens in it.
if (!embedding) {
  createMeshInput(async (file) => {
    const open = () => arrival.open(awaited, file);
    if (!(await controller.takes(file, open))) open();
  });
}

// The event's address and not `location`: by now the old scene may have been written there.
addEventListener("hashchange", ({ newURL }) => openLink(new URL(newURL)));
// The solver is the larger half: the first picture does not wait for it to be fetched, nor
// the solver for a picture that takes its time.
const patience = new Promise((resolve) => setTimeout(resolve, 4000));
const opened = (isFirst ? Promise.race([pictured, patience]) : Promise.resolve())
  .then(() => embedding?.wanted)
  .then(() => {
    controller.begin();
    if (!embedding?.isFed) return openLink(location);
  });
embedding?.begin(opened);
// In another page it is that one's concern.
if (!embedding) keepOffline(Promise.all([pictured, opened]), messages.note);
