// Written by a test from the Rust types (src/web/types.rs); changes here are lost.

/**
 * How edges lie to the lines of curvature.
 */
export type Alignment = { 
/**
 * Edges within [`ALIGNED_DEGREES`] of a line of curvature …
 */
aligned: number, 
/**
 * … of those not between umbilics.
 */
edges: number, };

/**
 * What is shown of edge flips.
 */
export type Arrangement = { 
/**
 * Side by side.
 */
compare: Compare, 
/**
 * Steps of Loop's scheme before drawing.
 */
subdivide: number, 
/**
 * Flips a step makes; all that gain anything if absent.
 */
flipsPerStep: number | null, };

/**
 * What is measured.
 */
export type BenchOptions = { 
/**
 * Which table; there must be one.
 */
table: TableName | null, 
/**
 * Larger meshes are left out.
 */
maxVertices: number | null, 
/**
 * Steps measured a row, after one that is not.
 */
steps: number, 
/**
 * Of the table of figures these, by their ids.
 */
figures: Array<string> | null, 
/**
 * Of the table of figures those that take a few seconds.
 */
quick: boolean, 
/**
 * Of the table of robustness: meshes to try instead of shapes with noise.
 */
meshes: Array<OpenedFile>, };

/**
 * A table as far as it has come.
 */
export type BenchReport = { 
/**
 * Keys of a row, in order.
 */
columns: Array<string>, 
/**
 * How many of them are set flush left.
 */
left: number, 
/**
 * Significant digits of a number that is not whole; none: one after the point.
 */
digits: number | null, 
/**
 * The next row, a cell a column; none after the last.
 */
row: unknown[] | null, };

/**
 * What the energy of an open surface is (Section 3.3 of the paper).
 */
export type Boundary = "clamped" | "fixed" | "free";

/**
 * Shapes that go over into each other as the volume changes.
 */
export type Branch = "prolate" | "oblate" | "stomatocyte";

/**
 * A branch, for people to choose from.
 */
export type BranchInfo = { 
/**
 * Its number.
 */
id: number, 
/**
 * The step it leaves.
 */
from: number, 
/**
 * Its last step.
 */
last: number, 
/**
 * The flow's own energy there.
 */
energy: number, };

/**
 * Options that a remedy changes; the others stay.
 */
export type Change = { 
/**
 * See [`FlowOptions::flow`].
 */
flow?: FlowName, 
/**
 * See [`FlowOptions::scheme`].
 */
scheme?: Scheme, 
/**
 * See [`FlowOptions::boundary`].
 */
boundary?: Boundary, 
/**
 * See [`FlowOptions::tau`]; the inner `None` leaves the step to the flow.
 */
tau?: number | null, 
/**
 * See [`FlowOptions::dt`]; always back to none, so that τ rules.
 */
dt?: number | null, 
/**
 * See [`FlowOptions::epsilon`].
 */
epsilon?: number, 
/**
 * See [`FlowOptions::prefill`].
 */
prefill?: boolean, 
/**
 * See [`FlowOptions::p`].
 */
p?: number, 
/**
 * See [`FlowOptions::keep`].
 */
keep?: Array<Kept>, 
/**
 * See [`FlowOptions::reduced_volume`].
 */
reducedVolume?: number | null, 
/**
 * See [`FlowOptions::regularise`].
 */
regularise?: Mode, };

/**
 * How an energy compares with the one sent.
 */
export type Check = "same" | "near" | "off" | "endsEarly";

/**
 * The flow that stands where the session does.
 */
export type ChosenFlow = { 
/**
 * Its options.
 */
options: FlowOptions, 
/**
 * What they amount to.
 */
configured: Configured, };

/**
 * A class of random quadrilaterals.
 */
export type ClassReport = { 
/**
 * Upper end of the angle between the faces, in degrees.
 */
below: number, 
/**
 * Quadrilaterals drawn.
 */
total: number, 
/**
 * Of which counterexamples.
 */
counterexamples: number, };

/**
 * What stands beside the surface.
 */
export type Compare = "none" | "start" | "criteria" | "flows";

/**
 * Flows side by side. Panes are numbered from 0, the first among them.
 */
export type Comparison = { 
/**
 * Those beside the first.
 */
panes: Array<PaneChange>, 
/**
 * What is kept level.
 */
lockstep: Lockstep, 
/**
 * The only pane that is shown; none where all are, side by side.
 */
shown: number | null, 
/**
 * The pane whose distance colours the others.
 */
difference: number | null, };

/**
 * What a configuration amounts to.
 */
export type Configured = { 
/**
 * Number of vertices that move.
 */
freeVertices: number, 
/**
 * h, the mean edge length.
 */
meanEdgeLength: number, 
/**
 * The first step's raw size.
 */
dt: number, 
/**
 * The same without a unit.
 */
tau: number, 
/**
 * Readings at the start.
 */
state: State, 
/**
 * 1 for each vertex that is held, 0 for each that moves.
 */
heldVertices: Uint8Array<ArrayBuffer>, };

/**
 * f_a against f_l for the edges of a mesh that can be flipped.
 */
export type ConjectureReport = { 
/**
 * Those shown: ends and apexes i, j, k, l, …
 */
corners: Uint32Array<ArrayBuffer>, 
/**
 * … f_a over the area of both triangles …
 */
area: Float32Array<ArrayBuffer>, 
/**
 * … and f_l in radians. Counterexamples come first, the strongest of them foremost.
 */
localised: Float32Array<ArrayBuffer>, 
/**
 * How many of those shown are counterexamples.
 */
counterexamples: number, 
/**
 * The flip lowers both.
 */
both: number, 
/**
 * It lowers neither.
 */
neither: number, 
/**
 * It lowers the area only: a counterexample.
 */
areaOnly: number, 
/**
 * It lowers the localised energy only: a counterexample.
 */
localisedOnly: number, };

/**
 * Costs before or after.
 */
export type Costs = { 
/**
 * Total area.
 */
area: number, 
/**
 * W, with a free boundary where there is one.
 */
circle: number, };

/**
 * Operations of a pass.
 */
export type Counts = { 
/**
 * Edges split.
 */
splits: number, 
/**
 * Edges collapsed.
 */
collapses: number, 
/**
 * Edges flipped.
 */
flips: number, };

/**
 * What becomes of edges of the shape, where faces meet at more than 60°, or flat sides at more than 40°.
 */
export type Creases = "keep" | "smooth";

/**
 * What is to become small.
 */
export type Criterion = "area" | "willmore" | "localised";

/**
 * The jump of H across the boundary of the free patches.
 */
export type CurvatureJump = { 
/**
 * J = rms |H_in − H_out| over the boundary vertices, unit 1/length.
 */
absolute: number, 
/**
 * J over rms H_out: without a unit. 0 where a patch joins with continuous curvature;
 * on a mesh it is then of the size of an edge, and halves with it.
 */
relative: number, 
/**
 * Number of boundary vertices where both sides could be extrapolated.
 */
vertices: number, };

/**
 * Area and W by one criterion after each of the [`Curves::flips`]; NaN after its last flip.
 */
export type Curve = { 
/**
 * The criterion.
 */
criterion: Criterion, 
/**
 * Total area.
 */
area: Float64Array<ArrayBuffer>, 
/**
 * W.
 */
circle: Float64Array<ArrayBuffer>, };

/**
 * Area and W against the number of flips, for plots.
 */
export type Curves = { 
/**
 * Numbers of flips, from 0 to those of the run that made most.
 */
flips: Float64Array<ArrayBuffer>, 
/**
 * One a criterion.
 */
runs: Array<Curve>, };

/**
 * What is the matter, where, and what helps.
 */
export type Diagnosis = { 
/**
 * What it is: name of a [`Symptom`].
 */
kind: string, 
/**
 * The same, to be said in one sentence.
 */
message: Message, 
/**
 * Vertices at fault.
 */
vertices: Uint32Array<ArrayBuffer>, 
/**
 * Triangles at fault.
 */
faces: Uint32Array<ArrayBuffer>, 
/**
 * Two ends an edge at fault.
 */
edges: Uint32Array<ArrayBuffer>, 
/**
 * What helps, the best first; three at most.
 */
remedies: Array<Remedy>, };

/**
 * Circles or crosses drawn of those there are.
 */
export type Drawn = { 
/**
 * So many of them …
 */
drawn: number, 
/**
 * … of so many.
 */
total: number, 
/**
 * Left out: circles larger than the surface, umbilics.
 */
leftOut: number, };

/**
 * Which energies. Unknown names are refused.
 */
export type EnergyOptions = { 
/**
 * Exponents beside the usual ones.
 */
p: Array<number>, 
/**
 * What holds at the boundary.
 */
boundary: Boundary, };

/**
 * All energies and integrals of a surface.
 */
export type EnergyReadings = { 
/**
 * W = Σ W_i as printed by Bobenko & Schröder.
 */
circle: number, 
/**
 * W/2, which tends to ∫(H² − K) dA on curvature-aligned lattices.
 */
circleNormalised: number, 
/**
 * ∫H² dA, H = (κ₁+κ₂)/2, with the lumped mass.
 */
willmore: number, 
/**
 * The same with the consistent mass, never less. Where they part by more than a few per
 * cent, the mesh does not resolve its curvature.
 */
willmoreConsistent: number, 
/**
 * ∫|H|^p dA by p.
 */
pWillmore: { [key in string]: number }, 
/**
 * Total area.
 */
area: number, 
/**
 * Signed volume, of a closed oriented surface.
 */
volume: number | null, 
/**
 * Σ 2(D_T − A_T) against the reference angles of Gruber & Aulisa's Algorithm 1.
 */
conformalDistortion: number, 
/**
 * Frobenius norm of ∇W over the vertices free under the boundary condition.
 */
gradientNorm: number, };

/**
 * What it takes to do something again.
 */
export type Estimate = { 
/**
 * Steps in all.
 */
steps: number, 
/**
 * Whether one would rather be asked first.
 */
isLong: boolean, };

/**
 * A refusal or failure: what is wrong and where, and what to do about it.
 *
 * Code switches on `kind`, never on the message.
 */
export type Fault = { 
/**
 * Noun of what is wrong.
 */
kind: string, 
/**
 * What is wrong and where.
 */
message: Message, 
/**
 * What the user can do.
 */
hint: Message, 
/**
 * The elements at fault: lists of indices by name.
 */
detail: { [key in string]: Array<number> }, 
/**
 * Of a file that is no surface, or a surface that is not whole: what a repair would change.
 */
repairs?: Array<RepairItem>, };

/**
 * A value per vertex and how to show it.
 */
export type Field = { 
/**
 * Which field.
 */
name: FieldName, 
/**
 * One value a vertex.
 */
values: Float32Array<ArrayBuffer>, 
/**
 * Lower end of the robust range; −`high` when signed.
 */
low: number, 
/**
 * Upper end of the robust range.
 */
high: number, 
/**
 * Whether the sign matters: diverging colours about 0.
 */
signed: boolean, };

/**
 * What a surface can be coloured by.
 */
export type FieldName = "mean-curvature" | "gauss-curvature" | "willmore" | "gradient" | "displacement";

/**
 * How holes are filled. Unknown names are refused.
 */
export type FillOptions = { 
/**
 * Which loops.
 */
loops: Loops, 
/**
 * Whether one patch connects them all.
 */
connect: boolean, 
/**
 * New vertices at most; 200,000 if absent.
 */
maxVertices: number | null, };

/**
 * What the fill did. The new vertices are those from `first_vertex` on, and the free ones
 * of the next flow.
 */
export type FillOutcome = { 
/**
 * The loops that are no more, by the numbers they had.
 */
filled: Array<number>, 
/**
 * Those that are still open, by the numbers they had.
 */
left: Array<number>, 
/**
 * Number of new vertices.
 */
newVertices: number, 
/**
 * The first new vertex.
 */
firstVertex: number, 
/**
 * What is worth knowing.
 */
warnings: Array<Message>, };

/**
 * How connectivity is optimised. Unknown names are refused.
 */
export type FlipOptions = { 
/**
 * What is to become small.
 */
criterion: Criterion, 
/**
 * Flips at most; all that gain anything if absent.
 */
max: number | null, 
/**
 * Whether faces may not be turned over.
 */
guardFolds: boolean, 
/**
 * Whether every flip is listed.
 */
history: boolean, };

/**
 * What the flips did.
 */
export type FlipOutcome = { 
/**
 * Flips made.
 */
flips: number, 
/**
 * Flips that would have gained and were refused.
 */
rejected: number, 
/**
 * Before the first.
 */
before: Costs, 
/**
 * After the last.
 */
after: Costs, 
/**
 * What is to be known of it.
 */
warnings: Array<Message>, 
/**
 * A row a flip with a header, as comma-separated values, if asked for.
 */
history?: string, };

/**
 * Where the optimisation by one criterion stands.
 */
export type FlipReading = { 
/**
 * What is to become small.
 */
criterion: Criterion, 
/**
 * Flips made.
 */
flips: number, 
/**
 * Flips refused that would have gained.
 */
rejected: number, 
/**
 * Total area.
 */
area: number, 
/**
 * W = 2 Σ β − 2πV over interior edges.
 */
circle: number, 
/**
 * What the last flip gained.
 */
reduction: number | null, };

/**
 * Which flow runs.
 */
export type FlowName = "circle" | "p-willmore" | "mean-curvature" | "volume-preserving" | "surface-diffusion" | "willmore" | "mmcv" | "flips";

/**
 * Options of a flow; what each may be, and which flows read it, is in [`option`](super::option).
 */
export type FlowOptions = { 
/**
 * Which flow.
 */
flow: FlowName, 
/**
 * Recommended or the paper's.
 */
scheme: Scheme, 
/**
 * Time discretisation.
 */
integrator: Integrator, 
/**
 * What happens at the boundary; by default as usual of the flow ([`spec`](crate::flow::spec)).
 */
boundary: Boundary | null, 
/**
 * Relax or smooth.
 */
goal: Goal, 
/**
 * Smoothing: wavelengths below this many mean edge lengths are at least halved.
 */
detail: number, 
/**
 * Smoothing: in so many steps.
 */
smoothSteps: number, 
/**
 * Raw step size; overrides `tau` and `detail`.
 */
dt: number | null, 
/**
 * Step size over h², h the mean edge length at the start; overrides `detail`. Under the
 * flows by mean curvature and its derivatives, over L^k, k the order of the flow and L²
 * the area of a free patch.
 */
tau: number | null, 
/**
 * Metric.
 */
mass: MassChoice, 
/**
 * ε of the angle smoothing, in radians.
 */
epsilon: number, 
/**
 * Whether ε goes to 0 at the end of relaxing.
 */
sharpen: boolean, 
/**
 * Pre-fill of the free vertices before the first step: harmonic under the circle flow,
 * smooth under the flows by mean curvature and its derivatives.
 */
prefill: boolean, 
/**
 * Only these vertices move.
 */
free: Array<number> | null, 
/**
 * These vertices never move.
 */
fixed: Array<number> | null, 
/**
 * Budget of steps, for a set number of them.
 */
maxSteps: number | null, 
/**
 * Budget of seconds of computing, counted anew each time a run is asked to go on; it
 * holds only where no number of steps is set, as a set amount of smoothing does.
 */
maxSeconds: number | null, 
/**
 * Closed surfaces: the start is pushed along its normals by up to so many mean edge lengths, so
 * that a symmetric one can leave a shape that is unstable.
 */
perturbation: number, 
/**
 * p-Willmore: the exponent; 0 (mean-curvature flow) or at least 1.
 */
p: number, 
/**
 * p-Willmore: what is kept.
 */
keep: Array<Kept>, 
/**
 * p-Willmore, recommended scheme: passes of remeshing where a closed triangle mesh has become
 * bad, in place of its regularisation.
 */
remesh: Remeshing, 
/**
 * Closed surfaces: conformal regularisation after each step.
 */
regularise: Mode, 
/**
 * Closed surfaces: ε of the regularisation, a pure number.
 */
regulariseEpsilon: number, 
/**
 * Closed surfaces, paper's scheme: factor on the step size after each step.
 */
tauGrowth: number, 
/**
 * Closed surfaces, paper's scheme: largest τ.
 */
tauMax: number | null, 
/**
 * p-Willmore: the volume is led to this share of the volume of the ball of the same
 * area; needs area and volume kept.
 */
reducedVolume: number | null, 
/**
 * p-Willmore, p = 2: spontaneous curvature H₀ in ∫(H − H₀)² dA, times L.
 */
spontaneousCurvature: number, 
/**
 * p-Willmore, p = 2: tension σ in ∫|Y|² dA + σA, times L².
 */
tension: number, 
/**
 * p-Willmore, p = 2: pressure P in ∫|Y|² dA − PV, times L³.
 */
pressure: number, 
/**
 * Edge flips: what is to become small.
 */
criterion: Criterion, 
/**
 * Edge flips: no flip may turn a face over.
 */
guardFolds: boolean, 
/**
 * Mean-curvature variation: steps of surface diffusion taken first; by default some
 * where the start is rough.
 */
rungs: number | null, };

/**
 * A picture of the surface with everything that is shown beside it.
 */
export type Frame = { 
/**
 * Readings.
 */
state: State, 
/**
 * The steps that no frame has told of yet, oldest first.
 */
reports: Array<PlotPoint>, 
/**
 * Three coordinates a vertex, relative to the mesh's frame, for drawing.
 */
positions: Float32Array<ArrayBuffer>, 
/**
 * The same in full precision, to go on from after a crash.
 */
exact: Float64Array<ArrayBuffer>, 
/**
 * Three corners each, where remeshing or edge flips made others than were loaded.
 */
triangles: Uint32Array<ArrayBuffer> | null, 
/**
 * Colours; null where there are none, or panes have their own.
 */
field: Field | null, 
/**
 * Triangles that folded over in the last step.
 */
flippedTriangles: Uint32Array<ArrayBuffer>, 
/**
 * Pictures side by side; none of a single flow.
 */
panes: Array<Pane>, 
/**
 * Of edge flips.
 */
curves: Curves | null, 
/**
 * Across the boundary of what moves.
 */
jump: CurvatureJump | null, 
/**
 * Null where nothing is looked at more closely.
 */
look: Look | null, 
/**
 * The steps that can be shown.
 */
timeline: Timeline, 
/**
 * The flow that stands there, where no frame has told of it yet.
 */
flow?: ChosenFlow, };

/**
 * What the run is for.
 */
export type Goal = "relax" | "smooth";

/**
 * Diagnosis card of a mesh.
 */
export type Info = { 
/**
 * Number of vertices.
 */
vertices: number, 
/**
 * Number of edges.
 */
edges: number, 
/**
 * Number of faces, of any degree.
 */
faces: number, 
/**
 * Number of connected components.
 */
components: number, 
/**
 * Number of boundary loops; of holes that touch in a vertex each counts.
 */
boundaryLoops: number, 
/**
 * V − E + F.
 */
eulerCharacteristic: number, 
/**
 * Summed over components with loops capped; none if not orientable.
 */
genus: number | null, 
/**
 * Whether there is no boundary.
 */
closed: boolean, 
/**
 * Whether the faces are, or could be, consistently oriented.
 */
oriented: boolean, 
/**
 * Total area.
 */
area: number, 
/**
 * Signed volume, of a closed oriented surface.
 */
volume: number | null, 
/**
 * Mean edge length.
 */
meanEdgeLength: number, 
/**
 * Smallest corner angle.
 */
minAngleDegrees: number, 
/**
 * Pairs of triangles that pass through each other, see
 * [`self_intersection`](crate::geometry::self_intersection); `None` where there are too
 * many triangles to be compared in about a second.
 */
selfIntersections: number | null, 
/**
 * What was repaired or is worth knowing.
 */
warnings: Array<Message>, 
/**
 * What a repair does to the file: what was safe, and done when it was opened, and what
 * [`Session::repair`](super::Session::repair) would change now.
 */
repairs: Array<RepairItem>, 
/**
 * A length within which a weld closes gaps that the usual repair leaves; see
 * [`gap`](crate::remesh::repair::gap). Left out where there is none.
 */
gap?: number, };

/**
 * How time is discretised.
 */
export type Integrator = "semi-implicit" | "forward-euler" | "backward-euler" | "l-bfgs";

/**
 * What an inversion leaves and what it changes.
 */
export type InversionReadings = { 
/**
 * W over interior vertices, made of angles between circles through vertices: invariant.
 */
circle: number, 
/**
 * Of an open surface W with a vertex at infinity closing each boundary loop. An inversion
 * takes infinity to a point, and another vertex closes the loop: not invariant.
 */
circleClosed: number | null, 
/**
 * ∫H² dA by the lumped formula. It is invariant on smooth closed surfaces; a mesh has it
 * up to the error of discretisation.
 */
willmore: number, 
/**
 * Total area.
 */
area: number, };

/**
 * An inversion in numbers.
 */
export type InversionReport = { 
/**
 * Its centre, in the coordinates of the file.
 */
centre: [number, number, number], 
/**
 * Radius of the sphere with which the surface keeps its size.
 */
radius: number, 
/**
 * Whether a reflection follows, so that normals point where they did.
 */
mirrored: boolean, 
/**
 * Distance of the centre from the surface, in diagonals of its bounding box.
 */
distance: number, 
/**
 * Of the surface at hand.
 */
before: InversionReadings, 
/**
 * Of its image.
 */
after: InversionReadings, 
/**
 * Sum of all angles, W + 2πN: what the rounding of W is measured by.
 */
angles: number, 
/**
 * Largest change of a W_i.
 */
largestChange: number, };

/**
 * A surface inverted, to look at.
 */
export type Inverted = { 
/**
 * What changes.
 */
report: InversionReport, 
/**
 * Three coordinates a vertex.
 */
positions: Float32Array<ArrayBuffer>, 
/**
 * The colours asked for.
 */
field: Field | null, 
/**
 * What is drawn over it: circles stay circles.
 */
look: Look, };

/**
 * What can be kept.
 */
export type Kept = "area" | "volume";

/**
 * What decides how long edges are.
 */
export type Kind = "adaptive" | "isotropic";

/**
 * What the random quadrilaterals say so far.
 */
export type LabReport = { 
/**
 * Random tetrahedra drawn …
 */
tetrahedra: number, 
/**
 * … and those that lower the area only, or the localised energy only.
 */
counterexamples: [number, number], 
/**
 * Of all quadrilaterals, flattened ones too.
 */
classes: Array<ClassReport>, 
/**
 * The clearest counterexample.
 */
strongest: QuadReport | null, };

/**
 * Something that a link does not carry.
 */
export type Lack = "editsTooLong" | "editsUnknown" | "file" | "fileByDigest" | "regionTooLong" | "pathTooLong";

/**
 * What came of the scene of a link.
 */
export type LinkCheck = { 
/**
 * In a word.
 */
outcome: Check, 
/**
 * The step here; of the half of a film that is shown backwards a negative one.
 */
step: number, 
/**
 * The energy here.
 */
energy: number, 
/**
 * The energy sent.
 */
sent: number, };

/**
 * What a page shows of a link.
 */
export type LinkScene = { 
/**
 * Id of a sample; null where the mesh came from a file.
 */
sample: string | null, 
/**
 * What the file's mesh is called.
 */
mesh: string | null, 
/**
 * The first 16 digits of its SHA-256.
 */
hash: string | null, 
/**
 * Id of the figure that is shown.
 */
figure: string | null, 
/**
 * Whether the mesh was edited, so that it must be prepared.
 */
edited: boolean, 
/**
 * Whether what leads to the step must be followed.
 */
hasPath: boolean, 
/**
 * Options that are said.
 */
options: Partial<FlowOptions>, 
/**
 * How it is arranged, where that is said.
 */
arrangement: Partial<Arrangement>, 
/**
 * What the surface is coloured by; null for nothing.
 */
colour: FieldName | null, 
/**
 * Flows beside it.
 */
comparison: Comparison | null, 
/**
 * The step that is shown; of the half of a film that is shown backwards a negative one.
 */
step: number, 
/**
 * As the viewer gave it.
 */
camera: Float32Array<ArrayBuffer> | null, 
/**
 * How it is drawn.
 */
view: LinkView, 
/**
 * The energy at the step, as it was written.
 */
check: string | null, 
/**
 * The version that computed it.
 */
version: string | null, 
/**
 * What it takes to show it.
 */
estimate: Estimate, 
/**
 * The link itself, to be prepared and followed.
 */
text: string, };

/**
 * How the surface is drawn; what is left out stays as it is.
 */
export type LinkView = { 
/**
 * How faces are lit.
 */
shading?: Shading, 
/**
 * Whether edges are drawn.
 */
wireframe?: boolean, 
/**
 * Whether the boundary is drawn.
 */
boundary?: boolean, 
/**
 * What share of the surface's depth is cut away in front, so that one sees inside; in percent.
 */
cut?: number, 
/**
 * Of the energy's axis.
 */
scale?: Scale, };

/**
 * What is known after a mesh was loaded, and everything a viewer needs to draw it.
 */
export type Loaded = { 
/**
 * Base name without extension, for downloads.
 */
name: string, 
/**
 * Diagnosis card.
 */
info: Info, 
/**
 * Three coordinates a vertex, relative to the mesh's frame.
 */
positions: Float32Array<ArrayBuffer>, 
/**
 * What is added to positions for the file's coordinates; zero unless those lie far from the
 * origin.
 */
shift: [number, number, number], 
/**
 * Red, green, blue and opacity of each vertex, from 0 to 1; null where the file has none.
 */
colours: Float32Array<ArrayBuffer> | null, 
/**
 * How the file numbers what sentences name.
 */
numbers: Numbers, 
/**
 * Three corners a triangle.
 */
triangles: Uint32Array<ArrayBuffer>, 
/**
 * Two ends an edge of the file's own faces.
 */
wireEdges: Uint32Array<ArrayBuffer>, 
/**
 * Two ends a boundary edge.
 */
boundaryEdges: Uint32Array<ArrayBuffer>, 
/**
 * Whether the file has triangles only.
 */
trianglesOnly: boolean, 
/**
 * Vertices a sample suggests to hold.
 */
fixed: Uint32Array<ArrayBuffer> | null, 
/**
 * Vertices a sample suggests to move.
 */
free: Uint32Array<ArrayBuffer> | null, 
/**
 * What a repair changed to make this of what was there before.
 */
repaired: Array<RepairItem>, 
/**
 * Which way up it is looked at.
 */
up: Up, };

/**
 * What is kept level between panes.
 */
export type Lockstep = "step" | "time";

/**
 * What is seen.
 */
export type Look = { 
/**
 * The vertex probed.
 */
probe: Probe | null, 
/**
 * Two ends a segment, three coordinates each, relative to the mesh's frame.
 */
ends: Float32Array<ArrayBuffer>, 
/**
 * The [`SegmentKind`] of each segment, by its number.
 */
kinds: Uint8Array<ArrayBuffer>, 
/**
 * Of all circumcircles.
 */
circles: Drawn | null, 
/**
 * Of principal directions.
 */
directions: Drawn | null, 
/**
 * Likewise.
 */
alignment: Alignment | null, };

/**
 * What to look at.
 */
export type LookOptions = { 
/**
 * A vertex with its star and the circumcircles of its triangles.
 */
probe: number | null, 
/**
 * The circumcircles of all triangles.
 */
circles: boolean, 
/**
 * Principal directions.
 */
directions: boolean, 
/**
 * The curves along which the surface passes through itself.
 */
crossings: boolean, };

/**
 * A boundary loop, for people to choose from.
 */
export type LoopInfo = { 
/**
 * Number of edges, and of vertices.
 */
edges: number, 
/**
 * Sum of the edge lengths.
 */
length: number, 
/**
 * Its vertices in order.
 */
vertices: Array<number>, 
/**
 * Whether it is a hole rather than the outer rim of a sheet: those are filled unless told
 * otherwise.
 */
small: boolean, };

/**
 * Which loops are filled: a word, or their numbers, counted from 0; unless told otherwise the
 * small ones.
 */
export type Loops = Array<number> | string | null;

/**
 * The metric the gradient is taken in.
 */
export type MassChoice = "auto" | "uniform" | "area";

/**
 * How good a mesh is.
 */
export type MeshQuality = { 
/**
 * Smallest corner angle.
 */
minAngleDegrees: number, 
/**
 * CD / A: 0 where every element has its reference shape.
 */
distortion: number, 
/**
 * Elements whose normal opposes that of the surface around them, on their side of
 * creases.
 */
inverted: number, 
/**
 * Area.
 */
area: number, 
/**
 * Signed volume, of a closed oriented surface.
 */
volume: number | null, };

/**
 * Readings of a mesh before or after.
 */
export type MeshReadings = { 
/**
 * Number of vertices.
 */
vertices: number, 
/**
 * Mean length of the edges.
 */
meanEdgeLength: number, 
/**
 * Smallest corner angle.
 */
minAngleDegrees: number, 
/**
 * Total area.
 */
area: number, 
/**
 * Enclosed volume, of a closed surface.
 */
volume: number | null, 
/**
 * Whether the readings of the mesh can be believed; null of open surfaces.
 */
soundness: Soundness | null, };

/**
 * Something to be said. In JSON `{ id, values }`.
 */
export type Message = { 
/**
 * Of the words, which may use each of the values.
 */
id: string, 
/**
 * By name.
 */
values: Record<string, unknown>, };

/**
 * Where the normals are taken that a pass holds.
 */
export type Mode = "off" | "linear" | "nonlinear";

/**
 * The functional that does not rise on an accepted step of the recommended scheme.
 */
export type Monitored = "smoothedCircle" | "area" | "willmore" | "pWillmore" | "helfrich" | "curvatureVariation";

/**
 * Lagrange multipliers of a step: ∇∫|H|^p + tension ∇A − pressure ∇V would vanish at rest.
 */
export type Multipliers = { 
/**
 * Of the area.
 */
tension: number | null, 
/**
 * Of the volume; positive pushes outwards.
 */
pressure: number | null, };

/**
 * Numbers of a file's vertices and faces.
 */
export type Numbers = { 
/**
 * That of the first: 0, or 1 of a format that counts so.
 */
first: number, 
/**
 * For each vertex the file's, counted from 0; null where these are the same.
 */
vertices: Uint32Array<ArrayBuffer> | null, 
/**
 * For each triangle the file's face that it was cut from.
 */
faces: Uint32Array<ArrayBuffer> | null, };

/**
 * A file that was opened.
 */
export type OpenedFile = { 
/**
 * What it is called.
 */
name: string, 
/**
 * What is in it.
 */
bytes: Uint8Array<ArrayBuffer>, };

/**
 * What the open mesh was made of, before any edits; as the page tells it.
 */
export type Origin = { "kind": "sample", 
/**
 * Its id.
 */
id: string, } | { "kind": "file", 
/**
 * What people call it.
 */
name: string, 
/**
 * Its own name, where it was opened here.
 */
file?: string, 
/**
 * Its digest; empty or left out where that is not known.
 */
sha256?: string, 
/**
 * Its length.
 */
bytes?: number, } | { "kind": "shape", 
/**
 * Its name.
 */
shape: string, 
/**
 * Parameters that are not the usual ones.
 */
parameters: { [key in string]: number }, };

/**
 * How a run ended, or how far it has come.
 */
export type Outcome = { 
/**
 * Whether it is over, and of which kind its end is.
 */
status: Status, 
/**
 * Whether the surface could not be kept good any longer: what is left is the last good one.
 */
isBreakdown: boolean, 
/**
 * How it ended, and why.
 */
message: Message, 
/**
 * The reason alone.
 */
reason: Message | null, 
/**
 * The failure of its last step.
 */
fault: Fault | null, 
/**
 * Which functional its steps must not raise.
 */
monitored: Monitored, 
/**
 * Whether the readings at the end can be believed, of the p-Willmore flow and of a rest under
 * flows by fits.
 */
soundness: Soundness | null, 
/**
 * The jump of H across the boundary of what moves.
 */
curvatureJump: CurvatureJump | null, 
/**
 * What its steps warned of, the last of each kind, and whether it came to rest.
 */
warnings: Array<Message>, };

/**
 * What the page knows of its scene and the session does not.
 */
export type PageScene = { 
/**
 * What the open mesh is called.
 */
source: Origin, 
/**
 * What it was made of; null where that is not known.
 */
origin: Origin | null, 
/**
 * Id of the figure that is shown.
 */
figure: string | null, 
/**
 * Flows beside it, changed from the options in force.
 */
comparison: Comparison | null, 
/**
 * How it is drawn.
 */
view: LinkView, 
/**
 * As the viewer gives it.
 */
camera: Float32Array<ArrayBuffer> | null, 
/**
 * The step that it runs to; of the half of a film that is shown backwards a negative one.
 */
goal: number | null, 
/**
 * Whether it is sent to somebody, so that there is always an energy to compare.
 */
shared: boolean, };

/**
 * A picture: all of what a viewer draws.
 */
export type Pane = { 
/**
 * `start`, the criterion or the flow.
 */
name: string, 
/**
 * Of flows side by side: where this one stands.
 */
state: State | null, 
/**
 * Of these: the jump of H across the boundary of what moves.
 */
jump: CurvatureJump | null, 
/**
 * Three coordinates a vertex.
 */
positions: Float32Array<ArrayBuffer>, 
/**
 * Three corners a triangle.
 */
triangles: Uint32Array<ArrayBuffer>, 
/**
 * Two ends an edge.
 */
wireEdges: Uint32Array<ArrayBuffer>, 
/**
 * Two ends a boundary edge.
 */
boundaryEdges: Uint32Array<ArrayBuffer>, 
/**
 * Two ends an edge that the last step made.
 */
highlight: Uint32Array<ArrayBuffer>, 
/**
 * Colours.
 */
field: Field | null, };

/**
 * A pane beside the first.
 */
export type PaneChange = { 
/**
 * The options it has otherwise.
 */
change: Partial<FlowOptions>, 
/**
 * The step it stands at; none where that is the step of the first.
 */
step: number | null, };

/**
 * A pass of remeshing between two steps.
 */
export type Pass = { 
/**
 * The step before it.
 */
afterStep: number, 
/**
 * Vertices after it.
 */
vertices: number, 
/**
 * Edges split.
 */
splits: number, 
/**
 * Edges collapsed.
 */
collapses: number, 
/**
 * Edges flipped.
 */
flips: number, 
/**
 * Smallest corner angle before and after, in degrees.
 */
angles: [number, number], 
/**
 * The monitored functional before and after: what it jumps by is the error of the meshes.
 */
objective: [number, number], };

/**
 * One shape of the diagram.
 */
export type Phase = { 
/**
 * Which shapes it belongs to.
 */
branch: Branch, 
/**
 * 6√π V/A^(3/2), 1 of a ball.
 */
reducedVolume: number, 
/**
 * ∫H²/4π, 1 of a sphere.
 */
energy: number, 
/**
 * The same of the smooth shape of revolution at rest, where it is known.
 */
expected: number | null, 
/**
 * How the flow ended.
 */
status: Status, 
/**
 * The flow under which it is at rest, and stays on its branch.
 */
options: FlowOptions, 
/**
 * How many shapes the diagram has.
 */
of: number, };

/**
 * What a plot has of a step, and what the step warns of.
 */
export type PlotPoint = { 
/**
 * Number of the step.
 */
step: number, 
/**
 * Flow time after it.
 */
time: number, 
/**
 * Raw step size.
 */
dt: number, 
/**
 * See [`StepReport::energy`].
 */
energy: number, 
/**
 * See [`StepReport::objective`].
 */
objective: number, 
/**
 * Total area.
 */
area: number, 
/**
 * Signed volume of a closed oriented surface.
 */
volume: number | null, 
/**
 * Smallest corner angle.
 */
minAngleDegrees: number, 
/**
 * Worth telling the user; none where the step was told of before.
 */
warnings: Array<Message>, };

/**
 * What is known of a vertex. Angles are in radians; H, K and the areas have the units of the
 * file, 1/length, 1/length² and length².
 */
export type Probe = { 
/**
 * Its number, from 0.
 */
vertex: number, 
/**
 * In the coordinates of the file.
 */
position: [number, number, number], 
/**
 * Whether it lies on the boundary.
 */
boundary: boolean, 
/**
 * Its edges in cyclic order.
 */
edges: Array<ProbedEdge>, 
/**
 * β₃ of a boundary vertex, the exterior angle of the boundary there, where it counts.
 */
turn: number | null, 
/**
 * Σβ over its edges, with β₃.
 */
sum: number, 
/**
 * W_i = Σβ − 2π; absent where it is no part of the energy.
 */
energy: number | null, 
/**
 * K_i, the angle defect 2π − Σ angles, π − Σ on the boundary.
 */
defect: number, 
/**
 * Pointwise H as the flow measures it.
 */
meanCurvature: number, 
/**
 * Pointwise K, the defect over the area; 0 on the boundary.
 */
gaussCurvature: number, 
/**
 * κ₁ ≥ κ₂ by the quadratic fit.
 */
principal: [number, number] | null, 
/**
 * A third of the area of its triangles.
 */
area: number, 
/**
 * Circumradii of its triangles.
 */
radii: Array<number>, };

/**
 * An edge at the vertex.
 */
export type ProbedEdge = { 
/**
 * Its other end.
 */
neighbour: number, 
/**
 * Its length.
 */
length: number, 
/**
 * Angle between the circumcircles of its two triangles, in radians; of a boundary edge β₂,
 * to the line through it, where a vertex at infinity closes the boundary. Absent where
 * the energy has no angle there.
 */
beta: number | null, 
/**
 * Whether it has one triangle only.
 */
boundary: boolean, };

/**
 * The numbers of one quadrilateral.
 */
export type QuadReport = { 
/**
 * Positions of i, j, k, l.
 */
points: [[number, number, number], [number, number, number], [number, number, number], [number, number, number]], 
/**
 * f_a.
 */
area: number, 
/**
 * f_l.
 */
localised: number, 
/**
 * Area of both triangles before the flip.
 */
totalArea: number, 
/**
 * Angle between the normals before and after the flip, in degrees.
 */
foldDegrees: [number, number], 
/**
 * Smallest angle of the triangles before and after, in degrees.
 */
minAngleDegrees: [number, number], };

/**
 * What is known of a recipe before it is followed.
 */
export type RecipeCard = { 
/**
 * The version that wrote it.
 */
version: string, 
/**
 * The mesh it begins with.
 */
mesh: RecipeMesh, 
/**
 * The same, as the page calls what it opens.
 */
origin: Origin, 
/**
 * Whether the mesh is the one that is shown at the start: nothing is done to it before.
 */
plain: boolean, 
/**
 * Options of the flow.
 */
flow: FlowOptions, 
/**
 * How it is shown.
 */
arrangement: Arrangement, 
/**
 * Steps after the last edit.
 */
steps: number, 
/**
 * The energy that it promises.
 */
energy: number, 
/**
 * What it takes to follow it.
 */
estimate: Estimate, };

/**
 * The mesh a recipe begins with.
 */
export type RecipeMesh = { 
/**
 * Id of the sample that it is the surface of, if it is.
 */
sample?: string, 
/**
 * Its name.
 */
shape: string, 
/**
 * Parameters that are not the usual ones.
 */
parameters: { [key in string]: number }, } | { 
/**
 * Its name.
 */
name: string, 
/**
 * Its digest.
 */
sha256: string, 
/**
 * Its length.
 */
bytes: number, };

/**
 * How a surface is refined.
 */
export type RefinedBy = "sampled" | "polyhedron" | "loop";

/**
 * How a mesh at rest is regularised. Unknown names are refused.
 */
export type RegulariseOptions = { 
/**
 * Linear or nonlinear.
 */
mode: Mode, 
/**
 * ε, a pure number: 1e-3 is faithful to the surface, 1e-1 aggressive.
 */
epsilon: number, 
/**
 * Passes at most.
 */
iterations: number, 
/**
 * η: damping by η (|Y_i| h_i)² keeps vertices where the surface bends within an edge
 * length, so that features stay; 0 lets them slide, those on creases too, as far as
 * the bounds allow.
 */
features: number, };

/**
 * What the passes did.
 */
export type Regularised = { 
/**
 * Passes that were taken.
 */
passes: number, 
/**
 * Before the first.
 */
before: MeshQuality, 
/**
 * After the last.
 */
after: MeshQuality, 
/**
 * Two-sided distance from the surface at the start, as a share of the diagonal of its
 * bounding box: of the vertices at the end from that surface, and of its vertices from
 * the surface at the end, the largest.
 */
distance: number, 
/**
 * Vertices on creases, which stay where they are.
 */
pinned: number, };

/**
 * Something that helps.
 */
export type Remedy = { 
/**
 * What is done.
 */
id: RemedyId, 
/**
 * What the button says.
 */
label: Message, 
/**
 * Options that change.
 */
change: Change, 
/**
 * Whether the run begins anew, the present surface being past help; otherwise that is
 * the new start.
 */
fromStart: boolean, 
/**
 * Steps to go back.
 */
steps: number, };

/**
 * What is done.
 */
export type RemedyId = "regularise" | "regulariseEachStep" | "repair" | "subdivide" | "smallerStep" | "automaticStep" | "largerEpsilon" | "recommendedScheme" | "continue" | "back" | "keepAndFlips" | "keepVolume" | "otherFlow" | "prefill" | "lowerExponent" | "refine";

/**
 * What a remeshing makes. Unknown names are refused.
 */
export type RemeshOptions = { 
/**
 * What decides how long edges are.
 */
kind: Kind, 
/**
 * Mean length of the edges between vertices that are not held; not together with `vertices`.
 */
target: number | null, 
/**
 * Number of vertices; as many as there are if both are absent.
 */
vertices: number | null, 
/**
 * What becomes of edges of the shape.
 */
creases: Creases, };

/**
 * What a remeshing did.
 */
export type RemeshOutcome = { 
/**
 * Operations.
 */
counts: Counts, 
/**
 * Before it.
 */
before: MeshReadings, 
/**
 * After it.
 */
after: MeshReadings, };

/**
 * Passes of remeshing between the steps of a flow.
 */
export type Remeshing = "adaptive" | "isotropic" | "off";

/**
 * A kind of change that a repair makes, or has made.
 */
export type RepairItem = { 
/**
 * Noun of what is changed.
 */
kind: string, 
/**
 * How often.
 */
count: number, 
/**
 * The same to be said.
 */
message: Message, 
/**
 * Vertices of the surface at which it is, of many only some.
 */
vertices: Uint32Array<ArrayBuffer>, 
/**
 * Whether that was safe, and so done when the file was opened.
 */
done: boolean, };

/**
 * How a surface is repaired. Unknown names are refused.
 */
export type RepairOptions = { 
/**
 * How near boundary vertices are welded.
 */
weld: Weld, };

/**
 * How far it is.
 */
export type ReplayProgress = { 
/**
 * From 0 to 1.
 */
share: number, 
/**
 * Whether that was all.
 */
isDone: boolean, };

/**
 * How what came of a recipe compares with what it promised.
 */
export type ReplayReport = { 
/**
 * Whether all of it agrees.
 */
same: boolean, 
/**
 * Whether it must agree to the last bit: the versions are the same.
 */
exact: boolean, 
/**
 * How far it may be off otherwise, relative to the larger.
 */
tolerance: number, 
/**
 * The version that wrote the recipe.
 */
version: string, 
/**
 * Steps after the last edit.
 */
steps: number, 
/**
 * As promised.
 */
expected: ReplayResult, 
/**
 * As it came.
 */
got: ReplayResult, 
/**
 * Names of the readings that disagree.
 */
differing: Array<string>, };

/**
 * What came of a surface: the flow's own readings, and the fingerprint of the positions.
 */
export type ReplayResult = { 
/**
 * The flow's own energy.
 */
energy: number, 
/**
 * Total area.
 */
area: number, 
/**
 * Signed volume, of a closed oriented surface.
 */
volume: number | null, 
/**
 * Smallest corner angle.
 */
minAngleDegrees: number, 
/**
 * Flow time.
 */
time: number, 
/**
 * SHA-256 of the positions relative to the mesh's frame, as single-precision numbers with
 * the low byte first.
 */
positions?: string, };

/**
 * The surface at one resolution; the trends have its energies for who only shows them.
 */
export type Resolution = { 
/**
 * Vertices.
 */
vertices: number, 
/**
 * Mean edge length.
 */
h: number, };

/**
 * What a command of the same name is answered with.
 */
export type RunAnswer = { "sample": Loaded } | { "loaded": Loaded } | { "info": Info } | { "configure": Configured } | { "continueWith": Configured } | { "step": StepReport | null } | { "state": State } | { "back": State } | { "reset": State } | { "seek": State } | { "branch": State } | { "timeline": Timeline } | { "arrange": State } | { "colour": Field | null };

/**
 * A request by name, with its fields.
 */
export type RunCommand = { "sample": { 
/**
 * Its name.
 */
name: string, 
/**
 * Parameters that are not the usual ones.
 */
parameters: { [key in string]: number }, } } | { "loaded": Record<symbol, never> } | { "info": Record<symbol, never> } | { "configure": { 
/**
 * Those that are not the usual ones.
 */
options: FlowOptions, } } | { "continueWith": { 
/**
 * All of them.
 */
options: FlowOptions, } } | { "step": Record<symbol, never> } | { "state": Record<symbol, never> } | { "back": Record<symbol, never> } | { "reset": Record<symbol, never> } | { "seek": { 
/**
 * Its number.
 */
step: number, } } | { "branch": { 
/**
 * Its number.
 */
branch: number, } } | { "timeline": Record<symbol, never> } | { "arrange": { 
/**
 * All of it.
 */
arrangement: Arrangement, } } | { "colour": { 
/**
 * A field by name, or `none`.
 */
field: string, } };

/**
 * Of the energy's axis.
 */
export type Scale = "auto" | "linear" | "log";

/**
 * Recommended treatment or the paper's own.
 */
export type Scheme = "auto" | "paper";

/**
 * A text that tells what is to be done to a surface.
 */
export type ScriptText = { "recipe": string } | { "link": string };

/**
 * The triangles that pass through each other.
 */
export type SelfIntersections = { 
/**
 * Two triangles a pair, the smaller number first; sorted.
 */
pairs: Uint32Array<ArrayBuffer>, 
/**
 * The triangles of all pairs, each once; sorted.
 */
triangles: Uint32Array<ArrayBuffer>, };

/**
 * How faces are lit.
 */
export type Shading = "smooth" | "flat";

/**
 * What tells a sound mesh of a closed triangulated surface from a spoilt one. No unit.
 */
export type Soundness = { 
/**
 * Largest κh: the larger principal curvature times the mean edge at a vertex.
 */
bend: number, 
/**
 * Least product of a unit face normal with a unit normal at its corners.
 */
alignment: number, 
/**
 * ∫K of the fitted quadrics less 2πχ, which it is on smooth surfaces, over their ∫|K|; where
 * that is less than 4π, over 4π. Handles and knots have more to be measured, and to err by.
 */
gaussBonnet: number, 
/**
 * ∫H² of the fitted quadrics over ∫H² of the mesh.
 */
fittedEnergy: number, 
/**
 * Whether the readings of the mesh can be believed: all four are within their limits.
 */
isSound: boolean, };

/**
 * Where a session stands.
 */
export type State = { 
/**
 * Steps taken.
 */
step: number, 
/**
 * Flow time.
 */
time: number, 
/**
 * Whether and why the run is over.
 */
status: Status, 
/**
 * The reason.
 */
message: Message | null, 
/**
 * The flow's own energy, as in [`StepReport::energy`].
 */
energy: number, 
/**
 * See [`StepReport::energy_normalised`].
 */
energyNormalised: number, 
/**
 * The next step's raw size.
 */
dt: number, 
/**
 * The same without a unit.
 */
tau: number, 
/**
 * What keeps area and volume, where they are kept.
 */
multipliers: Multipliers | null, 
/**
 * See [`StepReport::reduced_volume`].
 */
reducedVolume: number | null, 
/**
 * Edge flips: where each criterion stands, the chosen one first.
 */
flips: Array<FlipReading> | null, 
/**
 * Total area.
 */
area: number, 
/**
 * Signed volume, of a closed oriented surface.
 */
volume: number | null, 
/**
 * Pairs of triangles that pass through each other, of a surface that did so when it was opened
 * and has not too many triangles to be looked at after every step.
 */
crossings?: number, 
/**
 * Smallest corner angle.
 */
minAngleDegrees: number, 
/**
 * Which functional a step must not raise.
 */
monitored: Monitored, 
/**
 * What it is.
 */
objective: number, 
/**
 * Norm of the objective's gradient.
 */
gradientNorm: number, 
/**
 * Duration of the last step.
 */
milliseconds: number, 
/**
 * Whether the readings can be believed, as far as was looked at last: every tenth step, after
 * a pass and at the end of a run of the p-Willmore flow.
 */
soundness?: Soundness, 
/**
 * The pass of remeshing that the last step began with.
 */
pass?: Pass, 
/**
 * Whether an earlier state is stored.
 */
canStepBack: boolean, };

/**
 * Where a run stands.
 */
export type Status = "ready" | "converged" | "stepLimit" | "stalled" | "singular" | "collapsed" | "failed";

/**
 * One accepted step. Keys in JSON are the field names in camel case.
 */
export type StepReport = { 
/**
 * Number of the step, from 1.
 */
step: number, 
/**
 * Flow time after it, Σ dt, or what the flow's law takes for as much where steps are longer; for the circle flow with uniform mass unit length².
 */
time: number, 
/**
 * Raw step size.
 */
dt: number, 
/**
 * The flow's own reading: W = Σ W_i as printed, or ∫|H|^p dA, or with the terms of
 * Helfrich ∫(H − H₀)² dA + (σA − PV)/4; the area under the flow by mean curvature and
 * surface diffusion, ∫H² dA under the Willmore flow, ∫|∇H|² dA under mean-curvature
 * variation, within two edges of the free vertices.
 */
energy: number, 
/**
 * The same made comparable: W/2, or ∫|H|^p dA over its value on the round sphere of
 * the same area.
 */
energyNormalised: number, 
/**
 * Which functional the step must not raise.
 */
monitored: Monitored, 
/**
 * Whether the step only prepares a rough start for the flow, and so may raise it.
 */
prepares: boolean, 
/**
 * That functional before the step.
 */
objectiveBefore: number, 
/**
 * The same after.
 */
objective: number, 
/**
 * Circle flow: Frobenius norm of the objective's gradient over the free vertices, after.
 * p-Willmore flow: its normal, constrained part, scale-free. Flows by mean curvature and
 * its derivatives: root mean square of the velocity, scale-free; it need not vanish at
 * rest on irregular meshes.
 */
gradientNorm: number, 
/**
 * Total area.
 */
area: number, 
/**
 * Signed volume of a closed oriented surface.
 */
volume: number | null, 
/**
 * Smallest corner angle.
 */
minAngleDegrees: number, 
/**
 * Trial steps refused before this one.
 */
rejected: number, 
/**
 * Whether any of them was refused for what it would make of the mesh, or for a theorem's
 * bound.
 */
isGuarded: boolean, 
/**
 * Inner iterations: of the linear solver, or of Newton's method.
 */
iterations: number, 
/**
 * Wall-clock time of the step.
 */
milliseconds: number, 
/**
 * dt without a unit: dt/h², h the mean edge length at the start, or dt/L^(p+2), L the
 * radius of the sphere with the area at the start.
 */
tau: number, 
/**
 * Angle smoothing ε.
 */
epsilon: number, 
/**
 * Negative eigenvalues of the system matrix, where it was factored.
 */
negativePivots: number, 
/**
 * Angles left out of the gradient.
 */
skippedAngles: number, 
/**
 * Faces that folded over in this step: turned by more than a right angle, against
 * their neighbours.
 */
flippedFaces: number, 
/**
 * Largest displacement of a vertex from the start, in units of h.
 */
maxDisplacement: number, 
/**
 * What keeps area and volume, where they are kept.
 */
multipliers?: Multipliers, 
/**
 * 6√π V / A^(3/2), 1 for a sphere; of closed surfaces under the p-Willmore flow.
 */
reducedVolume?: number, 
/**
 * Edge flips: where each criterion stands, the chosen one first.
 */
flips?: Array<FlipReading>, 
/**
 * Largest distance a vertex was to move, in mean edge lengths; under the flows by mean
 * curvature and its derivatives, where it tells convergence.
 */
update?: number, 
/**
 * Norm of the residual of the linear system over that of its right-hand side, under the
 * same flows.
 */
linearResidual?: number, 
/**
 * Time for energy, gradient and matrix where the step begins and ends.
 */
assembleMilliseconds: number, 
/**
 * Time for factorisations.
 */
factorMilliseconds: number, 
/**
 * Time for triangular solves and iterations.
 */
solveMilliseconds: number, 
/**
 * Time for trials: the functional at each, and what the mesh would be.
 */
searchMilliseconds: number, 
/**
 * Time for sliding vertices along the surface.
 */
regulariseMilliseconds: number, 
/**
 * Time for the pass of remeshing before the step, which is no part of `milliseconds`.
 */
remeshMilliseconds: number, 
/**
 * The pass of remeshing that came before the step, where there was one.
 */
pass?: Pass, 
/**
 * Whether readings can be believed, looked at in every tenth step of the p-Willmore flow.
 */
soundness?: Soundness, 
/**
 * Worth telling the user.
 */
warnings: Array<Message>, };

/**
 * What is studied.
 */
export type StudyOptions = { 
/**
 * A sample shape by name; the present surface if absent.
 */
shape: string | null, 
/**
 * Its parameters.
 */
parameters: { [key in string]: number }, 
/**
 * Exponent of ∫|H|^p dA.
 */
p: number | null, };

/**
 * A study as far as it has come.
 */
export type StudyReport = { 
/**
 * How the surface is refined.
 */
refinedBy: RefinedBy, 
/**
 * Coarsest first.
 */
rows: Array<Resolution>, 
/**
 * What each quantity tends to.
 */
trends: Array<Trend>, 
/**
 * Whether there is no finer one to come.
 */
finished: boolean, 
/**
 * What that means, once there is none.
 */
findings: Array<Message>, 
/**
 * Vertices of the finest mesh at most.
 */
mostVertices: number, };

/**
 * Options of [`Session::subdivide`](crate::app::Session::subdivide).
 */
export type SubdivideOptions = { 
/**
 * How.
 */
scheme: SubdivisionScheme, };

/**
 * How faces are divided into four.
 */
export type SubdivisionScheme = "linear" | "loop";

/**
 * Which table.
 */
export type TableName = "circle" | "p-willmore" | "flips" | "mmcv" | "refinement" | "repair" | "robustness" | "vesicles" | "figures";

/**
 * The steps that can be shown.
 */
export type Timeline = { 
/**
 * The step of the start, which is always stored.
 */
start: number, 
/**
 * From here to `last` every step is stored; between it and the start, none.
 */
first: number, 
/**
 * The last step of the present path.
 */
last: number, 
/**
 * The step that is shown.
 */
at: number, 
/**
 * The stored step before it.
 */
previous: number | null, 
/**
 * The stored step after it; the same where the mesh was regularised next.
 */
next: number | null, 
/**
 * Snapshots of the present path that are stored.
 */
stored: number, 
/**
 * Other ways on, oldest first.
 */
branches: Array<BranchInfo>, };

/**
 * What a command of the same name is answered with.
 */
export type ToolAnswer = { "unpack": Unpacked } | { "load": Loaded } | { "energy": EnergyReadings } | { "turn": State } | { "restore": State } | { "regularise": Regularised } | { "flip": FlipOutcome } | { "fill": FillOutcome } | { "repair": Loaded } | { "subdivide": Loaded } | { "remesh": RemeshOutcome } | { "invert": InversionReport } | { "adopt": Loaded } | { "undo": Loaded } | { "loops": Array<LoopInfo> } | { "numbered": Array<number> } | { "look": Look } | { "previewInversion": Inverted } | { "conjecture": ConjectureReport } | { "quadrilateral": QuadReport } | { "lab": LabReport } | { "why": Diagnosis | null } | { "selfIntersections": SelfIntersections | null } | { "study": StudyReport } | { "phase": Phase | null } | { "bench": BenchReport } | { "outcome": Outcome } | { "curvatureJump": CurvatureJump | null } | { "readRecipe": RecipeCard } | { "writeRecipe": string } | { "compareRecipe": ReplayReport } | { "readLink": LinkScene } | { "writeLink": WrittenLink } | { "checkLink": LinkCheck | null } | { "prepare": null } | { "follow": null } | { "advance": ReplayProgress } | { "cancelReplay": null } | { "export": Uint8Array<ArrayBuffer> } | { "losses": Array<Message> } | { "history": string };

/**
 * A request by name, with its fields.
 */
export type ToolCommand = { "unpack": { 
/**
 * At least one.
 */
files: Array<OpenedFile>, } } | { "load": { 
/**
 * The file.
 */
bytes: Uint8Array<ArrayBuffer>, 
/**
 * Its name.
 */
name: string, 
/**
 * How it is repaired; null for a file that is a surface.
 */
repair: RepairOptions | null, } } | { "energy": EnergyOptions } | { "turn": { 
/**
 * The figure that it is of, by its id.
 */
figure: string, } } | { "restore": { 
/**
 * Three coordinates a vertex.
 */
exact: Float64Array<ArrayBuffer>, 
/**
 * Three corners each, where those of the frame were its own; null or none else.
 */
triangles: Uint32Array<ArrayBuffer> | null, 
/**
 * The step they belong to.
 */
step: number, 
/**
 * Its time.
 */
time: number, } } | { "regularise": { 
/**
 * How.
 */
options: RegulariseOptions, } } | { "flip": { 
/**
 * Which, and how many.
 */
options: FlipOptions, } } | { "fill": { 
/**
 * Which, and how.
 */
options: FillOptions, } } | { "repair": { 
/**
 * How.
 */
options: RepairOptions, } } | { "subdivide": { 
/**
 * By which scheme.
 */
options: SubdivideOptions, } } | { "remesh": { 
/**
 * Which, and how many.
 */
options: RemeshOptions, } } | { "invert": { 
/**
 * From the middle of the bounding box, in diagonals of it.
 */
centre: [number, number, number], } } | { "adopt": Record<symbol, never> } | { "undo": Record<symbol, never> } | { "loops": Record<symbol, never> } | { "numbered": { 
/**
 * All of them.
 */
numbers: Array<number>, } } | { "look": { 
/**
 * All of it.
 */
options: LookOptions, } } | { "previewInversion": { 
/**
 * As for `invert`.
 */
centre: [number, number, number], } } | { "conjecture": Record<symbol, never> } | { "quadrilateral": { 
/**
 * Vertices i, j, k, l.
 */
corners: [number, number, number, number], } } | { "lab": { 
/**
 * So many of each kind.
 */
pairs: number, } } | { "why": Record<symbol, never> } | { "selfIntersections": Record<symbol, never> } | { "study": { 
/**
 * Of what.
 */
options: StudyOptions | null, } } | { "phase": { 
/**
 * From 0.
 */
number: number, } } | { "bench": { 
/**
 * Of what.
 */
options: BenchOptions | null, } } | { "outcome": Record<symbol, never> } | { "curvatureJump": Record<symbol, never> } | { "readRecipe": { 
/**
 * The recipe.
 */
text: string, } } | { "writeRecipe": { 
/**
 * What it was made of; null where that is not known.
 */
origin: Origin | null, } } | { "compareRecipe": { 
/**
 * The recipe.
 */
text: string, } } | { "readLink": { 
/**
 * Its words.
 */
text: string, 
/**
 * Whether none of them is of others, as there may be in the query of an address.
 */
isOwn: boolean, } } | { "writeLink": { 
/**
 * What the page knows of it.
 */
scene: PageScene, } } | { "checkLink": { 
/**
 * The energy, as the link has it.
 */
sent: string, 
/**
 * Its step.
 */
step: number, } } | { "prepare": { 
/**
 * Of which.
 */
script: ScriptText, 
/**
 * The file it begins with, if it does.
 */
bytes: Uint8Array<ArrayBuffer> | null, 
/**
 * Its name.
 */
name: string, } } | { "follow": { 
/**
 * Which.
 */
script: ScriptText, } } | { "advance": Record<symbol, never> } | { "cancelReplay": Record<symbol, never> } | { "export": { 
/**
 * Its format by name.
 */
format: string, } } | { "losses": { 
/**
 * Its format by name.
 */
format: string, } } | { "history": Record<symbol, never> };

/**
 * A quantity over all resolutions.
 */
export type Trend = { 
/**
 * Its name among the fields of [`Resolution`].
 */
quantity: string, 
/**
 * One a resolution.
 */
values: Array<number>, 
/**
 * The smooth value.
 */
smooth: number | null, 
/**
 * Whether that is known, and not taken from the finest mesh by quadratic fits.
 */
isKnown: boolean, 
/**
 * Observed order between this and the resolution before: log of the ratio of errors, or
 * where no smooth value is known of successive differences, over that of the widths.
 */
orders: Array<number | null>, };

/**
 * The mesh among files.
 */
export type Unpacked = { 
/**
 * What it is called, without folders and without `.gz`.
 */
name: string, 
/**
 * What is in it, out of whatever it was packed in.
 */
bytes: Uint8Array<ArrayBuffer>, 
/**
 * Further meshes, which were not taken.
 */
others: Array<string>, };

/**
 * The coordinate axis that points up where a surface is looked at.
 */
export type Up = "y" | "z";

/**
 * How near boundary vertices are welded: a word, or a length.
 */
export type Weld = "auto" | "off" | number;

/**
 * A link, and what it lacks.
 */
export type WrittenLink = { 
/**
 * Its words.
 */
text: string, 
/**
 * What must be sent along.
 */
lacks: Array<Lack>, };
