// Flows, options and file formats as the solver knows them. Written from src/flow/spec.rs,
// src/flow/option/rows.rs, src/app/given.rs, src/app/options.rs and src/io/format.rs by
// `UPDATE_SCHEMA=1 cargo test --test schema`.

/**
 * What an option may be, and what reads it. `absent` is the word for null.
 * @typedef {object} Row
 * @property {string} name
 * @property {string} flag
 * @property {'number' | 'choice' | 'set' | 'switch' | 'numbers' | 'vertices'} kind
 * @property {{ low: number, high: number, lowOpen: boolean, whole: boolean, also: number | null } | null} range
 * @property {readonly string[]} ids
 * @property {any} default
 * @property {string | null} absent
 * @property {string} unit
 * @property {string} group
 * @property {readonly FlowName[]} flows
 * @property {string | null} scheme
 * @property {string | null} goal
 * @property {string | null} remesh
 * @property {boolean} ofOneFlow  a change of flow takes its value back
 */

/**
 * @typedef {object} Flow
 * @property {FlowName} id
 * @property {string} family
 * @property {string} paper
 * @property {number} order
 * @property {number} timePower      dt has the unit length^k with this k …
 * @property {boolean} timePowerAddsP  … and p more
 * @property {string} tau
 * @property {readonly import('./types.js').Monitored[]} monitored
 * @property {string} formula
 * @property {{ open: boolean, quads: boolean, oneSided: boolean }} meshes
 * @property {'clamped' | 'fixed' | 'free' | null} boundary  unless told otherwise
 * @property {Partial<FlowOptions>} sets  options of its family that make it this flow
 */

/**
 * A flag of a command, or of the flow that fairs a fill, and what help says of it: what follows it,
 * where it counts, what it may be, and its words by their id.
 * @typedef {{ name: string, flag: string, value: string | null, isMany: boolean, of: string, notes: string, words: string }} Flag
 */

/** A format of mesh files. @typedef {{ name: string, extensions: readonly string[], isWritten: boolean }} MeshFormat */

/** @typedef {'circle' | 'p-willmore' | 'mean-curvature' | 'volume-preserving' | 'surface-diffusion' | 'willmore' | 'mmcv' | 'flips'} FlowName */

/**
 * @typedef {object} FlowOptions
 * @property {'circle' | 'p-willmore' | 'mean-curvature' | 'volume-preserving' | 'surface-diffusion' | 'willmore' | 'mmcv' | 'flips'} [flow]
 * @property {'auto' | 'paper'} [scheme]
 * @property {'clamped' | 'fixed' | 'free' | null} [boundary]
 * @property {number[] | null} [free]
 * @property {number[] | null} [fixed]
 * @property {boolean} [prefill]
 * @property {number} [p]
 * @property {('area' | 'volume')[]} [keep]
 * @property {number | null} [reducedVolume]
 * @property {number} [spontaneousCurvature]
 * @property {number} [tension]
 * @property {number} [pressure]
 * @property {number} [epsilon]
 * @property {boolean} [sharpen]
 * @property {'area' | 'willmore' | 'localised'} [criterion]
 * @property {boolean} [guardFolds]
 * @property {'relax' | 'smooth'} [goal]
 * @property {number} [detail]
 * @property {number} [smoothSteps]
 * @property {number | null} [tau]
 * @property {number | null} [dt]
 * @property {number} [tauGrowth]
 * @property {number | null} [tauMax]
 * @property {'semi-implicit' | 'forward-euler' | 'backward-euler' | 'l-bfgs'} [integrator]
 * @property {'auto' | 'uniform' | 'area'} [mass]
 * @property {'adaptive' | 'isotropic' | 'off'} [remesh]
 * @property {'off' | 'linear' | 'nonlinear'} [regularise]
 * @property {number} [regulariseEpsilon]
 * @property {number} [perturbation]
 * @property {number | null} [rungs]
 * @property {number | null} [maxSteps]
 * @property {number | null} [maxSeconds]
 */

/**
 * @typedef {object} Arrangement
 * @property {'none' | 'start' | 'criteria' | 'flows'} [compare]
 * @property {number} [subdivide]
 * @property {number | null} [flipsPerStep]
 */

/** @type {readonly Flow[]} */
export const flows = [
  {"boundary":"clamped","family":"circle","formula":"\\dot x = -M^{-1} \\nabla W, \\quad W = \\sum_i \\bigl(\\sum_j \\beta_{ij} - 2\\pi\\bigr)","id":"circle","meshes":{"oneSided":true,"open":true,"quads":false},"monitored":["smoothedCircle"],"order":4,"paper":"Bobenko & Schröder, Discrete Willmore Flow","sets":{},"tau":"dt/h²","timePower":2,"timePowerAddsP":false},
  {"boundary":null,"family":"p-willmore","formula":"\\dot x = -\\nabla \\int |Y|^p \\, dA, \\quad Y = 2 H n","id":"p-willmore","meshes":{"oneSided":false,"open":false,"quads":true},"monitored":["area","willmore","pWillmore","helfrich"],"order":4,"paper":"Gruber & Aulisa, Computational p-Willmore Flow with Conformal Penalty","sets":{},"tau":"dt/L^(p+2)","timePower":2,"timePowerAddsP":true},
  {"boundary":"fixed","family":"curvature","formula":"\\dot x = -H n","id":"mean-curvature","meshes":{"oneSided":false,"open":true,"quads":false},"monitored":["area"],"order":2,"paper":"Xu & Zhang, Minimal Mean-Curvature-Variation Surfaces","sets":{},"tau":"dt/L²","timePower":2,"timePowerAddsP":false},
  {"boundary":null,"family":"p-willmore","formula":"\\dot x = 2 (\\bar H - H) n, \\quad \\bar H = \\int H \\, dA \\Big/ \\int dA","id":"volume-preserving","meshes":{"oneSided":false,"open":false,"quads":true},"monitored":["area"],"order":2,"paper":"Huisken, The volume preserving mean curvature flow","sets":{"keep":["volume"],"p":0},"tau":"dt/L²","timePower":2,"timePowerAddsP":false},
  {"boundary":"fixed","family":"curvature","formula":"\\dot x = \\Delta H \\, n","id":"surface-diffusion","meshes":{"oneSided":false,"open":true,"quads":false},"monitored":["area"],"order":4,"paper":"Xu & Zhang, Minimal Mean-Curvature-Variation Surfaces","sets":{},"tau":"dt/L⁴","timePower":4,"timePowerAddsP":false},
  {"boundary":"fixed","family":"curvature","formula":"\\dot x = \\bigl(\\Delta H + 2 H (H^2 - K)\\bigr) n","id":"willmore","meshes":{"oneSided":false,"open":true,"quads":false},"monitored":["willmore"],"order":4,"paper":"Xu & Zhang, Minimal Mean-Curvature-Variation Surfaces","sets":{},"tau":"dt/L⁴","timePower":4,"timePowerAddsP":false},
  {"boundary":"fixed","family":"curvature","formula":"\\dot x = -\\tfrac12 \\nabla \\int |\\nabla H|^2 \\, dA","id":"mmcv","meshes":{"oneSided":false,"open":true,"quads":false},"monitored":["curvatureVariation","area"],"order":6,"paper":"Xu & Zhang, Minimal Mean-Curvature-Variation Surfaces","sets":{},"tau":"dt/L⁶","timePower":6,"timePowerAddsP":false},
  {"boundary":null,"family":"flips","formula":"(i,j) \\mapsto (k,l) \\text{ where that lowers the criterion}","id":"flips","meshes":{"oneSided":true,"open":true,"quads":false},"monitored":["smoothedCircle","area"],"order":0,"paper":"Brink & Alboul, Willmore energy vs area as criteria for mesh optimisation","sets":{},"tau":"","timePower":2,"timePowerAddsP":false},
];

/** @type {readonly Row[]} */
export const options = [
  {"absent":null,"default":"circle","flag":"flow","flows":["circle","p-willmore","mean-curvature","volume-preserving","surface-diffusion","willmore","mmcv","flips"],"goal":null,"group":"flow","ids":["circle","p-willmore","mean-curvature","volume-preserving","surface-diffusion","willmore","mmcv","flips"],"kind":"choice","name":"flow","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":"auto","flag":"scheme","flows":["circle","p-willmore","mean-curvature","volume-preserving","surface-diffusion","willmore","mmcv"],"goal":null,"group":"flow","ids":["auto","paper"],"kind":"choice","name":"scheme","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":"auto","default":null,"flag":"boundary","flows":["circle","mean-curvature","surface-diffusion","willmore","mmcv"],"goal":null,"group":"surface","ids":["clamped","fixed","free"],"kind":"choice","name":"boundary","ofOneFlow":true,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":"auto","default":null,"flag":"free","flows":["circle","mean-curvature","surface-diffusion","willmore","mmcv"],"goal":null,"group":"surface","ids":[],"kind":"vertices","name":"free","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":"auto","default":null,"flag":"fixed","flows":["circle","mean-curvature","surface-diffusion","willmore","mmcv"],"goal":null,"group":"surface","ids":[],"kind":"vertices","name":"fixed","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":false,"flag":"prefill","flows":["circle","mean-curvature","surface-diffusion","willmore","mmcv"],"goal":null,"group":"surface","ids":[],"kind":"switch","name":"prefill","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":2,"flag":"p","flows":["p-willmore"],"goal":null,"group":"functional","ids":[],"kind":"number","name":"p","ofOneFlow":false,"range":{"also":0,"high":16,"low":1,"lowOpen":false,"whole":false},"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":[],"flag":"keep","flows":["p-willmore"],"goal":null,"group":"functional","ids":["area","volume"],"kind":"set","name":"keep","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":"auto","default":null,"flag":"reduced-volume","flows":["p-willmore"],"goal":null,"group":"functional","ids":[],"kind":"number","name":"reducedVolume","ofOneFlow":false,"range":{"also":null,"high":1,"low":0,"lowOpen":true,"whole":false},"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":0,"flag":"spontaneous-curvature","flows":["p-willmore"],"goal":null,"group":"functional","ids":[],"kind":"number","name":"spontaneousCurvature","ofOneFlow":false,"range":{"also":null,"high":1000,"low":-1000,"lowOpen":false,"whole":false},"remesh":null,"scheme":null,"unit":"1/L"},
  {"absent":null,"default":0,"flag":"tension","flows":["p-willmore"],"goal":null,"group":"functional","ids":[],"kind":"number","name":"tension","ofOneFlow":false,"range":{"also":null,"high":1000000,"low":-1000000,"lowOpen":false,"whole":false},"remesh":null,"scheme":null,"unit":"1/L²"},
  {"absent":null,"default":0,"flag":"pressure","flows":["p-willmore"],"goal":null,"group":"functional","ids":[],"kind":"number","name":"pressure","ofOneFlow":false,"range":{"also":null,"high":1000000,"low":-1000000,"lowOpen":false,"whole":false},"remesh":null,"scheme":null,"unit":"1/L³"},
  {"absent":null,"default":0.1,"flag":"epsilon","flows":["circle"],"goal":null,"group":"functional","ids":[],"kind":"number","name":"epsilon","ofOneFlow":false,"range":{"also":null,"high":1,"low":0,"lowOpen":false,"whole":false},"remesh":null,"scheme":null,"unit":"rad"},
  {"absent":null,"default":true,"flag":"sharpen","flows":["circle"],"goal":"relax","group":"functional","ids":[],"kind":"switch","name":"sharpen","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":"localised","flag":"criterion","flows":["flips"],"goal":null,"group":"functional","ids":["area","willmore","localised"],"kind":"choice","name":"criterion","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":false,"flag":"guard-folds","flows":["flips"],"goal":null,"group":"functional","ids":[],"kind":"switch","name":"guardFolds","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":"relax","flag":"goal","flows":["circle"],"goal":null,"group":"step","ids":["relax","smooth"],"kind":"choice","name":"goal","ofOneFlow":true,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":4,"flag":"detail","flows":["circle"],"goal":"smooth","group":"step","ids":[],"kind":"number","name":"detail","ofOneFlow":false,"range":{"also":null,"high":1000,"low":0.1,"lowOpen":false,"whole":false},"remesh":null,"scheme":null,"unit":"mean edge lengths"},
  {"absent":null,"default":10,"flag":"smooth-steps","flows":["circle"],"goal":"smooth","group":"step","ids":[],"kind":"number","name":"smoothSteps","ofOneFlow":false,"range":{"also":null,"high":1000000000,"low":1,"lowOpen":false,"whole":true},"remesh":null,"scheme":null,"unit":"steps"},
  {"absent":"auto","default":null,"flag":"tau","flows":["circle","p-willmore","mean-curvature","volume-preserving","surface-diffusion","willmore","mmcv"],"goal":null,"group":"step","ids":[],"kind":"number","name":"tau","ofOneFlow":true,"range":{"also":null,"high":1000000000000,"low":0,"lowOpen":true,"whole":false},"remesh":null,"scheme":null,"unit":""},
  {"absent":"auto","default":null,"flag":"dt","flows":["circle","p-willmore","mean-curvature","volume-preserving","surface-diffusion","willmore","mmcv"],"goal":null,"group":"step","ids":[],"kind":"number","name":"dt","ofOneFlow":true,"range":{"also":null,"high":1e+300,"low":0,"lowOpen":true,"whole":false},"remesh":null,"scheme":null,"unit":"length^k"},
  {"absent":null,"default":1.2,"flag":"tau-growth","flows":["p-willmore","volume-preserving"],"goal":null,"group":"step","ids":[],"kind":"number","name":"tauGrowth","ofOneFlow":false,"range":{"also":null,"high":100,"low":0,"lowOpen":true,"whole":false},"remesh":null,"scheme":"paper","unit":""},
  {"absent":"auto","default":null,"flag":"tau-max","flows":["p-willmore","volume-preserving"],"goal":null,"group":"step","ids":[],"kind":"number","name":"tauMax","ofOneFlow":false,"range":{"also":null,"high":1000000000000,"low":0,"lowOpen":true,"whole":false},"remesh":null,"scheme":"paper","unit":""},
  {"absent":null,"default":"semi-implicit","flag":"integrator","flows":["circle"],"goal":null,"group":"method","ids":["semi-implicit","forward-euler","backward-euler","l-bfgs"],"kind":"choice","name":"integrator","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":"auto","flag":"mass","flows":["circle"],"goal":null,"group":"method","ids":["auto","uniform","area"],"kind":"choice","name":"mass","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":"adaptive","flag":"remesh","flows":["p-willmore"],"goal":null,"group":"method","ids":["adaptive","isotropic","off"],"kind":"choice","name":"remesh","ofOneFlow":false,"range":null,"remesh":null,"scheme":"auto","unit":""},
  {"absent":null,"default":"nonlinear","flag":"regularise","flows":["p-willmore","volume-preserving"],"goal":null,"group":"method","ids":["off","linear","nonlinear"],"kind":"choice","name":"regularise","ofOneFlow":false,"range":null,"remesh":"off","scheme":null,"unit":""},
  {"absent":null,"default":0.01,"flag":"regularise-epsilon","flows":["p-willmore","volume-preserving"],"goal":null,"group":"method","ids":[],"kind":"number","name":"regulariseEpsilon","ofOneFlow":false,"range":{"also":null,"high":1000,"low":0,"lowOpen":true,"whole":false},"remesh":"off","scheme":null,"unit":""},
  {"absent":null,"default":0,"flag":"perturbation","flows":["p-willmore","volume-preserving"],"goal":null,"group":"method","ids":[],"kind":"number","name":"perturbation","ofOneFlow":false,"range":{"also":null,"high":0.3,"low":0,"lowOpen":false,"whole":false},"remesh":null,"scheme":null,"unit":"mean edge lengths"},
  {"absent":"auto","default":null,"flag":"rungs","flows":["mmcv"],"goal":null,"group":"method","ids":[],"kind":"number","name":"rungs","ofOneFlow":false,"range":{"also":null,"high":1000000000,"low":0,"lowOpen":false,"whole":true},"remesh":null,"scheme":null,"unit":"steps"},
  {"absent":"auto","default":null,"flag":"steps","flows":["circle","p-willmore","mean-curvature","volume-preserving","surface-diffusion","willmore","mmcv"],"goal":null,"group":"budget","ids":[],"kind":"number","name":"maxSteps","ofOneFlow":false,"range":{"also":null,"high":1000000000,"low":0,"lowOpen":false,"whole":true},"remesh":null,"scheme":null,"unit":"steps"},
  {"absent":"auto","default":120,"flag":"seconds","flows":["circle","p-willmore","mean-curvature","volume-preserving","surface-diffusion","willmore","mmcv"],"goal":"relax","group":"budget","ids":[],"kind":"number","name":"maxSeconds","ofOneFlow":false,"range":{"also":null,"high":1000000000,"low":0,"lowOpen":true,"whole":false},"remesh":null,"scheme":null,"unit":"s"},
];

/** @type {readonly Row[]} */
export const arrangement = [
  {"absent":null,"default":"none","flag":"compare","flows":["mean-curvature","surface-diffusion","willmore","mmcv","flips"],"goal":null,"group":"display","ids":["none","start","criteria","flows"],"kind":"choice","name":"compare","ofOneFlow":false,"range":null,"remesh":null,"scheme":null,"unit":""},
  {"absent":null,"default":0,"flag":"subdivide","flows":["flips"],"goal":null,"group":"display","ids":[],"kind":"number","name":"subdivide","ofOneFlow":false,"range":{"also":null,"high":3,"low":0,"lowOpen":false,"whole":true},"remesh":null,"scheme":null,"unit":""},
  {"absent":"all","default":1,"flag":"flips-per-step","flows":["flips"],"goal":null,"group":"display","ids":[],"kind":"number","name":"flipsPerStep","ofOneFlow":false,"range":{"also":null,"high":1000000000,"low":1,"lowOpen":false,"whole":true},"remesh":null,"scheme":null,"unit":"flips"},
];

/** @type {readonly MeshFormat[]} */
export const meshFormats = [
  {"extensions":["ply"],"isWritten":true,"name":"ply"},
  {"extensions":["ply"],"isWritten":true,"name":"ply-ascii"},
  {"extensions":["ply"],"isWritten":true,"name":"ply-big"},
  {"extensions":["obj"],"isWritten":true,"name":"obj"},
  {"extensions":["off"],"isWritten":true,"name":"off"},
  {"extensions":["stl"],"isWritten":true,"name":"stl"},
  {"extensions":["stl"],"isWritten":true,"name":"stl-ascii"},
  {"extensions":["glb"],"isWritten":true,"name":"glb"},
  {"extensions":["gltf"],"isWritten":false,"name":"gltf"},
  {"extensions":["3mf"],"isWritten":false,"name":"3mf"},
  {"extensions":["vtk"],"isWritten":false,"name":"vtk"},
  {"extensions":["vtp","vtu"],"isWritten":false,"name":"vtp"},
  {"extensions":["msh"],"isWritten":false,"name":"msh"},
];

// What a surface can be coloured by.

/** @type {readonly import('./types.js').FieldName[]} */
export const fields = [
  "mean-curvature",
  "gauss-curvature",
  "willmore",
  "gradient",
  "displacement",
];

/** @type {Record<string, readonly Flag[]>} */
export const flags = {
  flow: [
    {"flag":"flow","isMany":false,"name":"flow","notes":"default circle","of":"","value":"circle|p-willmore|mean-curvature|volume-preserving|surface-diffusion|willmore|mmcv","words":"option-flow"},
    {"flag":"scheme","isMany":false,"name":"scheme","notes":"default auto","of":"","value":"auto|paper","words":"option-scheme"},
    {"flag":"boundary","isMany":false,"name":"boundary","notes":"default auto","of":"not p-willmore, not volume-preserving","value":"auto|clamped|fixed|free","words":"option-boundary"},
    {"flag":"free","isMany":false,"name":"free","notes":"numbered as in the file, OBJ from 1; default auto","of":"not p-willmore, not volume-preserving","value":"FILE.json","words":"option-free"},
    {"flag":"fixed","isMany":false,"name":"fixed","notes":"numbered as in the file, OBJ from 1; default auto","of":"not p-willmore, not volume-preserving","value":"FILE.json","words":"option-fixed"},
    {"flag":"prefill","isMany":false,"name":"prefill","notes":"","of":"not p-willmore, not volume-preserving","value":null,"words":"option-prefill"},
    {"flag":"p","isMany":false,"name":"p","notes":"default 2; 0 or from 1 to 16","of":"p-willmore","value":"VALUE","words":"option-p"},
    {"flag":"keep","isMany":false,"name":"keep","notes":"","of":"p-willmore","value":"area,volume","words":"option-keep"},
    {"flag":"reduced-volume","isMany":false,"name":"reducedVolume","notes":"default auto; above 0 to 1","of":"p-willmore","value":"auto|VALUE","words":"option-reducedVolume"},
    {"flag":"spontaneous-curvature","isMany":false,"name":"spontaneousCurvature","notes":"default 0; from -1000 to 1000","of":"p-willmore","value":"VALUE","words":"option-spontaneousCurvature"},
    {"flag":"tension","isMany":false,"name":"tension","notes":"default 0","of":"p-willmore","value":"VALUE","words":"option-tension"},
    {"flag":"pressure","isMany":false,"name":"pressure","notes":"default 0","of":"p-willmore","value":"VALUE","words":"option-pressure"},
    {"flag":"epsilon","isMany":false,"name":"epsilon","notes":"default 0.1; from 0 to 1","of":"circle","value":"VALUE","words":"option-epsilon"},
    {"flag":"sharpen","isMany":false,"name":"sharpen","notes":"default; --no-sharpen for not","of":"circle, --goal relax","value":null,"words":"option-sharpen"},
    {"flag":"goal","isMany":false,"name":"goal","notes":"default relax","of":"circle","value":"relax|smooth","words":"option-goal"},
    {"flag":"detail","isMany":false,"name":"detail","notes":"default 4; from 0.1 to 1000","of":"circle, --goal smooth","value":"VALUE","words":"option-detail"},
    {"flag":"smooth-steps","isMany":false,"name":"smoothSteps","notes":"default 10; from 1","of":"circle, --goal smooth","value":"N","words":"option-smoothSteps"},
    {"flag":"tau","isMany":false,"name":"tau","notes":"default auto; above 0","of":"","value":"auto|VALUE","words":"option-tau"},
    {"flag":"dt","isMany":false,"name":"dt","notes":"default auto; above 0","of":"","value":"auto|VALUE","words":"option-dt"},
    {"flag":"tau-growth","isMany":false,"name":"tauGrowth","notes":"default 1.2; above 0 to 100","of":"p-willmore, volume-preserving, --scheme paper","value":"VALUE","words":"option-tauGrowth"},
    {"flag":"tau-max","isMany":false,"name":"tauMax","notes":"default auto; above 0","of":"p-willmore, volume-preserving, --scheme paper","value":"auto|VALUE","words":"option-tauMax"},
    {"flag":"integrator","isMany":false,"name":"integrator","notes":"default semi-implicit","of":"circle","value":"semi-implicit|forward-euler|backward-euler|l-bfgs","words":"option-integrator"},
    {"flag":"mass","isMany":false,"name":"mass","notes":"default auto","of":"circle","value":"auto|uniform|area","words":"option-mass"},
    {"flag":"remesh","isMany":false,"name":"remesh","notes":"default adaptive","of":"p-willmore, --scheme auto","value":"adaptive|isotropic|off","words":"option-remesh"},
    {"flag":"regularise","isMany":false,"name":"regularise","notes":"default nonlinear","of":"p-willmore, volume-preserving, --remesh off","value":"off|linear|nonlinear","words":"option-regularise"},
    {"flag":"regularise-epsilon","isMany":false,"name":"regulariseEpsilon","notes":"default 0.01; above 0 to 1000","of":"p-willmore, volume-preserving, --remesh off","value":"VALUE","words":"option-regulariseEpsilon"},
    {"flag":"perturbation","isMany":false,"name":"perturbation","notes":"default 0; from 0 to 0.3","of":"p-willmore, volume-preserving","value":"VALUE","words":"option-perturbation"},
    {"flag":"rungs","isMany":false,"name":"rungs","notes":"default auto; from 0","of":"mmcv","value":"auto|N","words":"option-rungs"},
    {"flag":"steps","isMany":false,"name":"maxSteps","notes":"default auto; from 0","of":"","value":"auto|N","words":"option-maxSteps"},
    {"flag":"seconds","isMany":false,"name":"maxSeconds","notes":"default 120; above 0","of":"--goal relax","value":"auto|VALUE","words":"option-maxSeconds"},
  ],
  energy: [
    {"flag":"p","isMany":true,"name":"p","notes":"","of":"","value":"VALUE,VALUE","words":"energy-p"},
    {"flag":"boundary","isMany":false,"name":"boundary","notes":"default clamped","of":"","value":"clamped|fixed|free","words":"energy-boundary"},
  ],
  regularise: [
    {"flag":"mode","isMany":false,"name":"mode","notes":"default nonlinear","of":"","value":"linear|nonlinear","words":"regularise-mode"},
    {"flag":"epsilon","isMany":false,"name":"epsilon","notes":"default 0.01; above 0 to 1000","of":"","value":"VALUE","words":"regularise-epsilon"},
    {"flag":"iterations","isMany":false,"name":"iterations","notes":"default 5; from 0","of":"","value":"N","words":"regularise-iterations"},
    {"flag":"features","isMany":false,"name":"features","notes":"default 0.3; from 0","of":"","value":"VALUE","words":"regularise-features"},
  ],
  repair: [
    {"flag":"weld","isMany":false,"name":"weld","notes":"default auto; above 0","of":"","value":"auto|off|LENGTH","words":"repair-weld"},
  ],
  fill: [
    {"flag":"loops","isMany":true,"name":"loops","notes":"default small","of":"","value":"small|all|N,N","words":"fill-loops"},
    {"flag":"connect","isMany":false,"name":"connect","notes":"","of":"","value":null,"words":"fill-connect"},
    {"flag":"max-vertices","isMany":false,"name":"maxVertices","notes":"default auto; from 0","of":"","value":"auto|N","words":"fill-maxVertices"},
  ],
  fair: [
    {"flag":"fair","isMany":false,"name":"fair","notes":"default none","of":"","value":"none|circle|mean-curvature|surface-diffusion|willmore|mmcv","words":"fill-fair"},
    {"flag":"steps","isMany":false,"name":"maxSteps","notes":"default auto; from 0","of":"--fair","value":"auto|N","words":"option-maxSteps"},
    {"flag":"seconds","isMany":false,"name":"maxSeconds","notes":"default 120; above 0","of":"--fair","value":"auto|VALUE","words":"option-maxSeconds"},
  ],
  remesh: [
    {"flag":"kind","isMany":false,"name":"kind","notes":"default adaptive","of":"","value":"adaptive|isotropic","words":"remesh-kind"},
    {"flag":"target","isMany":false,"name":"target","notes":"default auto; above 0","of":"","value":"auto|LENGTH","words":"remesh-target"},
    {"flag":"vertices","isMany":false,"name":"vertices","notes":"default auto; from 4","of":"","value":"auto|N","words":"remesh-vertices"},
    {"flag":"creases","isMany":false,"name":"creases","notes":"default keep","of":"","value":"keep|smooth","words":"remesh-creases"},
  ],
  flips: [
    {"flag":"criterion","isMany":false,"name":"criterion","notes":"default localised","of":"","value":"area|willmore|localised","words":"flips-criterion"},
    {"flag":"guard-folds","isMany":false,"name":"guardFolds","notes":"","of":"","value":null,"words":"flips-guardFolds"},
    {"flag":"max","isMany":false,"name":"max","notes":"default all; from 0","of":"","value":"all|N","words":"flips-max"},
  ],
  bench: [
    {"flag":"table","isMany":false,"name":"table","notes":"","of":"","value":"circle|p-willmore|flips|mmcv|refinement|repair|robustness|vesicles|figures","words":"bench-table"},
    {"flag":"max-vertices","isMany":false,"name":"maxVertices","notes":"default all; from 1","of":"","value":"all|N","words":"bench-maxVertices"},
    {"flag":"steps","isMany":false,"name":"steps","notes":"default 3; from 1","of":"","value":"N","words":"bench-steps"},
    {"flag":"figures","isMany":false,"name":"figures","notes":"default all","of":"","value":"all|ID,ID","words":"bench-figures"},
    {"flag":"quick","isMany":false,"name":"quick","notes":"","of":"","value":null,"words":"bench-quick"},
  ],
};
