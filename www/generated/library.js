// Samples and figures as src/app/library has them. Written by tests/suite/library.rs.

/** @import { FlowOptions } from "./schema.js" */
/** @import { Arrangement, FieldName, FillOptions } from "./types.js" */

/**
 * A surface to begin with; the words are `sample-<id>`.
 * @typedef {object} Sample
 * @property {string} id
 * @property {'closed' | 'tubes' | 'boundary' | 'repair' | 'flips'} group
 * @property {string} shape        name of the solver's shape …
 * @property {Record<string, number>} parameters  … and its parameters
 * @property {FlowOptions} options  over the defaults
 * @property {Partial<FillOptions>} [fill]   holes filled at once
 * @property {number} vertices     that it then has
 */

/**
 * A figure of a paper; the words are `figure-<id>`.
 * @typedef {object} Figure
 * @property {string} id
 * @property {string} paper        the words are `paper-<paper>`
 * @property {string} number       as the paper has it
 * @property {string} sample       id of the sample it begins with
 * @property {FlowOptions} options  over those of the sample
 * @property {Arrangement} arrangement
 * @property {FieldName | 'none'} colour
 * @property {number | 'rest'} steps  how far it runs; 0 for a figure without a flow
 * @property {Record<string, number>} [back]  parameters of the surface from which the same is run
 *   first, to be shown backwards ahead of it
 * @property {boolean} quick       a few seconds at most
 * @property {boolean} fallsShort  known not to come out as the paper has it
 */

/** @type {readonly Sample[]} */
export const samples = [
  {"id":"icosahedron","group":"closed","shape":"icosahedron","parameters":{"level":4},"options":{},"vertices":2562},
  {"id":"bumpy-sphere","group":"closed","shape":"bumpy-sphere","parameters":{"level":4},"options":{},"vertices":2562},
  {"id":"coarse-torus","group":"closed","shape":"coarse-torus","parameters":{"level":2},"options":{},"vertices":768},
  {"id":"clifford-torus","group":"closed","shape":"clifford-torus","parameters":{},"options":{"epsilon":0.001},"vertices":1024},
  {"id":"pipe","group":"tubes","shape":"pipe","parameters":{},"options":{"boundary":"clamped"},"vertices":792},
  {"id":"six-sided-hole","group":"boundary","shape":"six-sided-hole","parameters":{},"options":{"boundary":"clamped","prefill":true},"vertices":469},
  {"id":"scar","group":"repair","shape":"scar","parameters":{},"options":{},"vertices":10242},
  {"id":"noisy-scan","group":"repair","shape":"scan","parameters":{"resolution":140,"loops":30},"options":{"goal":"smooth"},"vertices":9298},
  {"id":"trefoil","group":"tubes","shape":"trefoil","parameters":{},"options":{},"vertices":1440},
  {"id":"vesicle","group":"closed","shape":"ellipsoid","parameters":{"a":1,"b":1,"c":0.65,"level":4},"options":{"flow":"p-willmore","keep":["area","volume"],"reducedVolume":0.6},"vertices":2562},
  {"id":"blob","group":"closed","shape":"bumpy-sphere","parameters":{"level":4,"amplitude":0.2,"frequency":3,"seed":2},"options":{"flow":"p-willmore","keep":["area","volume"],"reducedVolume":0.6},"vertices":2562},
  {"id":"spheroid","group":"closed","shape":"ellipsoid","parameters":{"a":2,"b":1,"c":1,"level":4},"options":{"flow":"volume-preserving"},"vertices":2562},
  {"id":"letter-c","group":"closed","shape":"letter-c","parameters":{},"options":{"flow":"p-willmore"},"vertices":2946},
  {"id":"thin-torus","group":"closed","shape":"torus","parameters":{"major":1,"minor":0.25,"around":72,"tube":24},"options":{"flow":"p-willmore"},"vertices":1728},
  {"id":"torus-knot","group":"tubes","shape":"torus-knot","parameters":{"p":3,"q":4,"along":240,"around":16},"options":{"flow":"p-willmore","keep":["area","volume"]},"vertices":3840},
  {"id":"bad-mesh","group":"repair","shape":"ellipsoid","parameters":{"level":4,"jitter":0.35},"options":{"flow":"p-willmore","keep":["volume"]},"vertices":2562},
  {"id":"trefoil-kept","group":"tubes","shape":"trefoil","parameters":{"along":180,"around":18},"options":{"flow":"p-willmore","keep":["area","volume"]},"vertices":3240},
  {"id":"trefoil-tube","group":"tubes","shape":"trefoil","parameters":{"along":180,"around":18},"options":{"flow":"p-willmore","keep":["area"]},"vertices":3240},
  {"id":"linked-tubes","group":"tubes","shape":"torus-knot","parameters":{"p":2,"q":4,"tube":0.4,"along":100,"around":14},"options":{"flow":"p-willmore","keep":["area"]},"vertices":2800},
  {"id":"bumps-kept","group":"closed","shape":"bumpy-sphere","parameters":{"level":4},"options":{"flow":"p-willmore","keep":["area"]},"vertices":2562},
  {"id":"ellipsoid-p","group":"closed","shape":"ellipsoid","parameters":{"level":4},"options":{"flow":"p-willmore","keep":["volume"],"p":4},"vertices":2562},
  {"id":"cylinder-gaps","group":"repair","shape":"cylinder-gaps","parameters":{},"options":{"flow":"mmcv"},"vertices":3608},
  {"id":"sphere-openings","group":"repair","shape":"sphere-openings","parameters":{},"options":{"flow":"mmcv"},"vertices":10242},
  {"id":"two-tubes","group":"tubes","shape":"tubes","parameters":{"count":2},"options":{"flow":"mmcv"},"fill":{"loops":[0,2],"connect":true,"maxVertices":null},"vertices":1968},
  {"id":"three-tubes","group":"tubes","shape":"tubes","parameters":{"count":3},"options":{"flow":"mmcv"},"fill":{"loops":[0,2,4],"connect":true,"maxVertices":null},"vertices":2847},
  {"id":"six-tubes","group":"tubes","shape":"tubes","parameters":{"count":6},"options":{"flow":"mmcv"},"fill":{"loops":[0,2,4,6,8,10],"connect":true,"maxVertices":null},"vertices":4540},
  {"id":"holed-scan","group":"repair","shape":"scan-clean","parameters":{"resolution":140,"loops":30},"options":{"flow":"mmcv"},"fill":{"loops":"small","connect":false,"maxVertices":null},"vertices":9306},
  {"id":"holed-sphere","group":"repair","shape":"holed-sphere","parameters":{},"options":{"flow":"mmcv"},"fill":{"loops":"all","connect":false,"maxVertices":null},"vertices":9937},
  {"id":"dodecahedron","group":"boundary","shape":"dodecahedron","parameters":{},"options":{"flow":"mmcv","prefill":true},"vertices":1154},
  {"id":"four-bumps","group":"boundary","shape":"four-bumps","parameters":{},"options":{"flow":"mmcv","prefill":true},"vertices":3721},
  {"id":"sampled-torus","group":"flips","shape":"sampled-torus","parameters":{"jitter":0.05},"options":{"flow":"flips"},"vertices":392},
  {"id":"uneven-torus","group":"flips","shape":"sampled-torus","parameters":{},"options":{"flow":"flips"},"vertices":392},
  {"id":"creased-face","group":"flips","shape":"creased-face","parameters":{},"options":{"flow":"flips"},"vertices":3087},
  {"id":"eared-head","group":"flips","shape":"eared-head","parameters":{"jitter":0.2},"options":{"flow":"flips"},"vertices":2562},
  {"id":"counterexample","group":"flips","shape":"counterexample","parameters":{},"options":{"flow":"flips"},"vertices":4},
  {"id":"moebius","group":"boundary","shape":"moebius","parameters":{},"options":{"boundary":"fixed"},"vertices":1248},
  {"id":"klein-bottle","group":"closed","shape":"klein-bottle","parameters":{},"options":{},"vertices":3072},
  {"id":"saddle","group":"boundary","shape":"hyperbolic-paraboloid","parameters":{"cells":16},"options":{"boundary":"free"},"vertices":289},
  {"id":"genus-4","group":"closed","shape":"double-torus","parameters":{"genus":4,"level":3},"options":{"flow":"p-willmore"},"vertices":5498},
  {"id":"morin","group":"closed","shape":"morin","parameters":{"vertices":1200,"push":-0.03},"options":{"flow":"p-willmore","keep":["area"]},"vertices":1200},
  {"id":"morin-fine","group":"closed","shape":"morin","parameters":{"vertices":5000,"push":-0.03},"options":{"flow":"p-willmore","keep":["area"]},"vertices":5000},
  {"id":"boy","group":"closed","shape":"boy","parameters":{},"options":{},"vertices":2000},
  {"id":"cyclide","group":"closed","shape":"cyclide","parameters":{},"options":{"epsilon":0.001},"vertices":4096},
  {"id":"inverted-catenoid","group":"closed","shape":"inverted-catenoid","parameters":{},"options":{},"vertices":2000},
  {"id":"lawson-two-handles","group":"closed","shape":"lawson","parameters":{"genus":2},"options":{"flow":"p-willmore","keep":["area"]},"vertices":2350},
  {"id":"lawson-three-handles","group":"closed","shape":"lawson","parameters":{"genus":3,"cells":12},"options":{"flow":"p-willmore","keep":["area"]},"vertices":2300},
  {"id":"rough-mesh","group":"repair","shape":"ellipsoid","parameters":{"level":4,"jitter":0.2},"options":{"flow":"p-willmore","keep":["volume"]},"vertices":2562},
  {"id":"range-scan","group":"repair","shape":"scan","parameters":{"resolution":285,"loops":88},"options":{"goal":"smooth"},"vertices":38221},
];

/** @type {readonly Figure[]} */
export const figures = [
  {"id":"circle-6","paper":"circle","number":"6","sample":"icosahedron","options":{"dt":0.0345,"scheme":"paper"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":24,"quick":true,"fallsShort":false},
  {"id":"circle-6-adaptive","paper":"circle","number":"6","sample":"icosahedron","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":true,"fallsShort":false},
  {"id":"circle-7-fixed","paper":"circle","number":"7","sample":"saddle","options":{"boundary":"fixed"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":100,"quick":true,"fallsShort":false},
  {"id":"circle-7-free","paper":"circle","number":"7","sample":"saddle","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":100,"quick":true,"fallsShort":false},
  {"id":"circle-8","paper":"circle","number":"8","sample":"coarse-torus","options":{"scheme":"paper","tau":0.01},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":100,"quick":true,"fallsShort":false},
  {"id":"circle-8-long","paper":"circle","number":"8","sample":"coarse-torus","options":{"scheme":"paper","tau":0.003},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":1000,"quick":false,"fallsShort":false},
  {"id":"circle-9","paper":"circle","number":"9","sample":"pipe","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":50,"quick":true,"fallsShort":false},
  {"id":"circle-10","paper":"circle","number":"10","sample":"six-sided-hole","options":{"prefill":false},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":100,"quick":true,"fallsShort":false},
  {"id":"circle-11","paper":"circle","number":"11","sample":"scar","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":20,"quick":true,"fallsShort":false},
  {"id":"circle-12-10","paper":"circle","number":"12","sample":"range-scan","options":{"boundary":"fixed","tau":0.01},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":10,"quick":true,"fallsShort":false},
  {"id":"circle-12-100","paper":"circle","number":"12","sample":"range-scan","options":{"boundary":"fixed","smoothSteps":100,"tau":0.01},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":100,"quick":false,"fallsShort":false},
  {"id":"p-willmore-1","paper":"p-willmore","number":"1","sample":"bumps-kept","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":true,"fallsShort":false},
  {"id":"p-willmore-2-p0","paper":"p-willmore","number":"2","sample":"letter-c","options":{"p":0,"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":100,"quick":false,"fallsShort":false},
  {"id":"p-willmore-2-p2","paper":"p-willmore","number":"2","sample":"letter-c","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":160,"quick":false,"fallsShort":false},
  {"id":"p-willmore-2-p4","paper":"p-willmore","number":"2","sample":"letter-c","options":{"p":4,"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":160,"quick":false,"fallsShort":false},
  {"id":"p-willmore-3-linear","paper":"p-willmore","number":"3","sample":"bad-mesh","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":0,"quick":true,"fallsShort":false},
  {"id":"p-willmore-3-nonlinear","paper":"p-willmore","number":"3","sample":"bad-mesh","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":0,"quick":true,"fallsShort":false},
  {"id":"p-willmore-4","paper":"p-willmore","number":"4","sample":"thin-torus","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":true,"fallsShort":false},
  {"id":"p-willmore-5","paper":"p-willmore","number":"5","sample":"torus-knot","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":50,"quick":false,"fallsShort":false},
  {"id":"p-willmore-6","paper":"p-willmore","number":"6","sample":"vesicle","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":false,"fallsShort":false},
  {"id":"p-willmore-6-blob","paper":"p-willmore","number":"6","sample":"blob","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":false,"fallsShort":false},
  {"id":"p-willmore-7","paper":"p-willmore","number":"7","sample":"rough-mesh","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":0,"quick":true,"fallsShort":false},
  {"id":"p-willmore-8","paper":"p-willmore","number":"8","sample":"genus-4","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":false,"fallsShort":false},
  {"id":"p-willmore-9","paper":"p-willmore","number":"9","sample":"trefoil-kept","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":60,"quick":false,"fallsShort":false},
  {"id":"p-willmore-9-off","paper":"p-willmore","number":"9","sample":"trefoil-kept","options":{"regularise":"off","remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":false,"fallsShort":false},
  {"id":"p-willmore-10-p0","paper":"p-willmore","number":"10","sample":"ellipsoid-p","options":{"dt":0.002,"keep":[],"p":0,"regularise":"off","remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":30,"quick":false,"fallsShort":false},
  {"id":"p-willmore-10-p2","paper":"p-willmore","number":"10","sample":"ellipsoid-p","options":{"dt":0.0002,"keep":[],"p":2,"regularise":"off","remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":30,"quick":true,"fallsShort":false},
  {"id":"p-willmore-10-p4","paper":"p-willmore","number":"10","sample":"ellipsoid-p","options":{"dt":0.00001,"keep":[],"regularise":"off","remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":30,"quick":false,"fallsShort":false},
  {"id":"p-willmore-11","paper":"p-willmore","number":"11","sample":"bad-mesh","options":{"keep":[],"regularise":"off","remesh":"off","tau":0.0001},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":1,"quick":true,"fallsShort":false},
  {"id":"p-willmore-12-p0","paper":"p-willmore","number":"12","sample":"ellipsoid-p","options":{"p":0,"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":false,"fallsShort":false},
  {"id":"p-willmore-12-p2","paper":"p-willmore","number":"12","sample":"ellipsoid-p","options":{"p":2,"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":false,"fallsShort":false},
  {"id":"p-willmore-12-p4","paper":"p-willmore","number":"12","sample":"ellipsoid-p","options":{"remesh":"off"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":false,"fallsShort":false},
  {"id":"flips-6","paper":"flips","number":"6","sample":"sampled-torus","options":{},"arrangement":{"compare":"criteria","subdivide":0,"flipsPerStep":null},"colour":"none","steps":"rest","quick":true,"fallsShort":false},
  {"id":"flips-6-curvature","paper":"flips","number":"6","sample":"sampled-torus","options":{},"arrangement":{"compare":"start","subdivide":2,"flipsPerStep":null},"colour":"gauss-curvature","steps":"rest","quick":true,"fallsShort":false},
  {"id":"flips-7","paper":"flips","number":"7","sample":"creased-face","options":{},"arrangement":{"compare":"criteria","subdivide":0,"flipsPerStep":null},"colour":"none","steps":"rest","quick":true,"fallsShort":true},
  {"id":"flips-8","paper":"flips","number":"8","sample":"eared-head","options":{},"arrangement":{"compare":"criteria","subdivide":0,"flipsPerStep":null},"colour":"none","steps":"rest","quick":true,"fallsShort":false},
  {"id":"flips-8-volume","paper":"flips","number":"8","sample":"eared-head","options":{"criterion":"area"},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":null},"colour":"none","steps":"rest","quick":true,"fallsShort":false},
  {"id":"curvature-5.1-cylinder","paper":"curvature","number":"5.1 (a–c)","sample":"cylinder-gaps","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":"rest","quick":true,"fallsShort":false},
  {"id":"curvature-5.1-sphere","paper":"curvature","number":"5.1 (d–f)","sample":"sphere-openings","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":"rest","quick":true,"fallsShort":false},
  {"id":"curvature-5.4","paper":"curvature","number":"5.4","sample":"dodecahedron","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":"rest","quick":true,"fallsShort":false},
  {"id":"curvature-5.2-two","paper":"curvature","number":"5.2 (a–c)","sample":"two-tubes","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":"rest","quick":true,"fallsShort":false},
  {"id":"curvature-5.2-three","paper":"curvature","number":"5.2 (d–f)","sample":"three-tubes","options":{},"arrangement":{"compare":"flows","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":60,"quick":true,"fallsShort":false},
  {"id":"curvature-5.2-six","paper":"curvature","number":"5.2 (g–i)","sample":"six-tubes","options":{},"arrangement":{"compare":"flows","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":60,"quick":true,"fallsShort":false},
  {"id":"curvature-5.3","paper":"curvature","number":"5.3","sample":"holed-sphere","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":"rest","quick":true,"fallsShort":false},
  {"id":"curvature-5.5","paper":"curvature","number":"5.5","sample":"three-tubes","options":{},"arrangement":{"compare":"flows","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":60,"quick":true,"fallsShort":false},
  {"id":"curvature-5.6","paper":"curvature","number":"5.6","sample":"four-bumps","options":{},"arrangement":{"compare":"flows","subdivide":0,"flipsPerStep":1},"colour":"mean-curvature","steps":60,"quick":true,"fallsShort":false},
  {"id":"volume-preserving-round","paper":"volume-preserving","number":"1987","sample":"spheroid","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":true,"fallsShort":false},
  {"id":"eversion","paper":"eversion","number":"1997","sample":"morin","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":600,"back":{"push":0.03},"quick":true,"fallsShort":false},
  {"id":"eversion-fine","paper":"eversion","number":"1997","sample":"morin-fine","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":600,"back":{"push":0.03},"quick":false,"fallsShort":false},
  {"id":"lawson-2","paper":"lawson","number":"1970","sample":"lawson-two-handles","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":true,"fallsShort":false},
  {"id":"lawson-3","paper":"lawson","number":"1970","sample":"lawson-three-handles","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":true,"fallsShort":false},
  {"id":"knot-undone","paper":"knots","number":"1985","sample":"trefoil-tube","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":false,"fallsShort":false},
  {"id":"link-undone","paper":"knots","number":"1985","sample":"linked-tubes","options":{},"arrangement":{"compare":"none","subdivide":0,"flipsPerStep":1},"colour":"none","steps":"rest","quick":true,"fallsShort":false},
];
