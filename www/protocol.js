// @ts-check
// What the page, the worker, the command line and the wasm `Session` say to each
// other. Types only: nothing here runs. Arrays named `Float32Array` and the like
// are transferred, never copied, between worker and page.

/**
 * What is to be said, in no language; `www/words.js` says it. A value is a number, a text, a
 * message, null or a list of these.
 * @typedef {{ id: string, values?: Readonly<Record<string, any>> }} Message
 */

/**
 * A refusal or failure, the only shape of error that crosses the seams of wasm and worker.
 * Code switches on `kind`, never on the message.
 * @typedef {object} Refusal
 * @property {string} kind            noun of what is wrong, e.g. `NonManifoldEdge`
 * @property {Message} message        what is wrong and where (line, face, vertex, edge)
 * @property {Message | null} hint    what the user can do about it
 * @property {Record<string, unknown>} detail  the elements, for highlighting
 */

/**
 * The same in words.
 * @typedef {object} Fault
 * @property {string} kind
 * @property {string} message
 * @property {string} hint
 * @property {Record<string, unknown>} detail
 */

/**
 * Diagnosis card of a mesh: the JSON of `umbilic info`.
 * @typedef {object} Info
 * @property {number} vertices
 * @property {number} edges
 * @property {number} faces
 * @property {number} components
 * @property {number} boundaryLoops
 * @property {number} eulerCharacteristic
 * @property {number | null} genus  summed over components with loops capped; null when not orientable
 * @property {boolean} closed
 * @property {boolean} oriented     false when no consistent orientation exists
 * @property {number} area
 * @property {number | null} volume signed, positive with outward normals; null unless closed and oriented
 * @property {number} meanEdgeLength
 * @property {number} minAngleDegrees
 * @property {number | null} selfIntersections  pairs of triangles that pass through each other; null
 *                                   where there are too many triangles to compare in about a second
 * @property {Message[]} warnings
 */

/**
 * What `selfIntersections` answers, of the surface as it is; `final` and `initial` of a report have
 * the number of pairs where it is asked for.
 * @typedef {object} SelfIntersections
 * @property {Uint32Array} pairs      two triangles a pair, the smaller number first; sorted
 * @property {Uint32Array} triangles  of all pairs, each once; sorted
 */

/**
 * What `load` and `sample` answer: everything the viewer needs to build a surface.
 * @typedef {object} Loaded
 * @property {string} name             base name without extension, for downloads
 * @property {Info} info
 * @property {Float32Array} positions  3 per vertex
 * @property {Uint32Array} triangles   3 per triangle (polygons are fanned for drawing)
 * @property {Uint32Array} wireEdges   2 per edge: the mesh's own edges
 * @property {Uint32Array} boundaryEdges  2 per boundary edge
 * @property {boolean} trianglesOnly   false when the file had other polygons
 * @property {Uint32Array | null} [fixed]  vertices to hold, of a sample that suggests them
 * @property {Uint32Array | null} [free]   vertices to move, likewise, or new ones after a fill
 */

/**
 * @typedef {'circle' | 'p-willmore' | 'mean-curvature' | 'surface-diffusion' | 'willmore' |
 *           'mmcv' | 'flips'} FlowName
 */

/**
 * Options of a flow. Every field may be left out; `Configured` tells what was chosen.
 * @typedef {object} FlowOptions
 * @property {FlowName} [flow]
 * @property {'auto' | 'paper'} [scheme]   `paper`: constant dt, exact energy, plain K, uniform mass
 * @property {'semi-implicit' | 'forward-euler' | 'backward-euler' | 'l-bfgs'} [integrator]
 * @property {'clamped' | 'fixed' | 'free' | null} [boundary]  default clamped; of the flows by mean
 *                                         curvature and its derivatives fixed
 * @property {'relax' | 'smooth'} [goal]   `relax`: adaptive step towards a minimum; `smooth`: a set amount
 * @property {number} [detail]             smooth: removes detail below this many mean edge lengths
 * @property {number} [smoothSteps]        smooth: in so many steps (default 10)
 * @property {number | null} [dt]          raw step size, unit length²; null or absent = automatic
 * @property {number | null} [tau]         dt / h², the same scale-free; h = mean edge length at the start;
 *                                         flows by mean curvature and its derivatives: dt / L^k,
 *                                         k the order, L² the area of a free patch (default 1)
 * @property {'auto' | 'uniform' | 'area'} [mass]
 * @property {number} [epsilon]            angle smoothing φ(β) = √(β²+ε²) − ε (default 0.1)
 * @property {boolean} [sharpen]           lets ε go to 0 at the end (default true)
 * @property {boolean} [prefill]           pre-fill of the free region before the first step: harmonic, or
 *                                         smooth under the flows by mean curvature
 * @property {number[] | null} [free]      only these vertices move
 * @property {number[] | null} [fixed]     these vertices never move
 * @property {number | null} [maxSteps]    budget of steps (default null: none)
 * @property {number | null} [maxSeconds]  budget of seconds of computing, where no number of steps is
 *                                         set (default 120; null: none)
 * @property {number} [perturbation]       p-Willmore: the start is pushed along its normals by up to so
 *                                         many mean edge lengths, 0 to 0.3 (default 0)
 * @property {number} [p]                  p-Willmore: exponent, 0 or at least 1 (default 2)
 * @property {('area' | 'volume')[]} [keep]  p-Willmore: what is kept
 * @property {'off' | 'linear' | 'nonlinear'} [regularise]  p-Willmore: after each step (default nonlinear)
 * @property {number} [regulariseEpsilon]  p-Willmore: ε of it (default 0.01)
 * @property {number} [tauGrowth]          p-Willmore, paper's scheme: factor on the step (default 1.2)
 * @property {number | null} [tauMax]      p-Willmore, paper's scheme: largest τ
 * @property {number | null} [reducedVolume]  p-Willmore: 6√π V/A^(3/2) to lead the volume to
 * @property {number} [spontaneousCurvature]  p-Willmore, p = 2: H₀ L, L = √(A/4π) at the start
 * @property {number} [tension]            p-Willmore, p = 2: σ L²
 * @property {number} [pressure]           p-Willmore, p = 2: P L³
 * @property {number | null} [rungs]       mmcv: steps of surface diffusion first; null or absent
 *                                         = as many as a rough start needs
 * @property {Criterion} [criterion]       edge flips: what is to become small (default localised)
 * @property {boolean} [guardFolds]        edge flips: faces may not be turned over
 */

/** @typedef {'area' | 'willmore' | 'localised'} Criterion */

/**
 * A surface to begin with; the words are `sample-<id>`.
 * @typedef {object} Sample
 * @property {string} id
 * @property {'closed' | 'tubes' | 'boundary' | 'repair' | 'flips'} group
 * @property {string} shape        name of the solver's shape …
 * @property {Record<string, number>} parameters  … and its parameters
 * @property {FlowOptions} options  over the defaults
 * @property {FillOptions} [fill]   holes filled at once
 */

/**
 * A figure of a paper; the words are `figure-<id>`, see `library.js`.
 * @typedef {object} Figure
 * @property {string} id
 * @property {'circle' | 'p-willmore' | 'flips' | 'curvature'} paper
 * @property {string} number       as the paper has it
 * @property {string} sample       id of the sample it begins with
 * @property {FlowOptions} options  over those of the sample
 * @property {Arrangement} arrangement
 * @property {FieldName} colour
 * @property {number | 'rest'} steps  how far it runs; 0 for a figure without a flow
 * @property {boolean} quick       a few seconds at most
 * @property {boolean} fallsShort  known not to come out as the paper has it
 */

/**
 * What a run of a figure came to: whether as expected, and what was measured.
 * @typedef {{ ok: boolean, message: Message }} Finding
 */

/**
 * How edge flips are shown, and how many a step makes.
 * @typedef {object} Arrangement
 * @property {'none' | 'start' | 'criteria' | 'flows'} compare  what stands beside the surface
 * @property {number} subdivide            steps of Loop's scheme before drawing
 * @property {number | null} flipsPerStep  null: all that gain anything
 */

/**
 * A picture of edge flips, with connectivity of its own, or of one of several flows.
 * @typedef {object} Pane
 * @property {Criterion | FlowName | 'start'} name
 * @property {Standing | null} standing  of flows
 * @property {Float32Array} positions
 * @property {Uint32Array} triangles
 * @property {Uint32Array} wireEdges
 * @property {Uint32Array} boundaryEdges
 * @property {Uint32Array} highlight  two ends an edge that the last step made
 * @property {Field | null} field     all panes share one range
 */

/**
 * Where a flow beside others stands.
 * @typedef {{ step: number, status: Status, message: Message | null, jump: CurvatureJump | null }} Standing
 */

/**
 * Where edge flips by one criterion stand.
 * @typedef {object} FlipReading
 * @property {Criterion} criterion
 * @property {number} flips
 * @property {number} rejected
 * @property {number} area
 * @property {number} circle
 * @property {number | null} reduction  what the last flip gained
 */

/**
 * Area and W against the number of flips; NaN after the last flip of a criterion.
 * @typedef {object} Curves
 * @property {Float64Array} flips
 * @property {{ criterion: Criterion, area: Float64Array, circle: Float64Array }[]} runs
 */

/**
 * f_a against f_l for the edges that can be flipped, counterexamples first, the strongest
 * foremost; of those that agree a selection.
 * @typedef {object} Conjecture
 * @property {number} both           edges whose flip lowers area and localised energy, …
 * @property {number} neither
 * @property {number} areaOnly       … and the counterexamples
 * @property {number} localisedOnly
 * @property {number} counterexamples  of those listed
 * @property {Uint32Array} corners   i, j, k, l of each
 * @property {Float32Array} area     f_a over the area of both triangles
 * @property {Float32Array} localised  f_l, radians
 */

/**
 * The numbers of a quadrilateral about an edge (i, j) with apexes k, l.
 * @typedef {object} Quadrilateral
 * @property {[number, number, number][]} points  of i, j, k, l
 * @property {number} area        f_a
 * @property {number} localised   f_l
 * @property {number} totalArea
 * @property {[number, number]} foldDegrees      between the faces, before and after the flip
 * @property {[number, number]} minAngleDegrees  before and after
 */

/**
 * Random quadrilaterals so far.
 * @typedef {object} Lab
 * @property {number} tetrahedra
 * @property {[number, number]} counterexamples  of the tetrahedra: area only, localised only
 * @property {{ below: number, total: number, counterexamples: number }[]} classes  by the larger angle between the faces
 * @property {Quadrilateral | null} strongest
 */

/**
 * Options of `regularise`, conformal regularisation of the mesh as it is.
 * @typedef {object} RegulariseOptions
 * @property {'linear' | 'nonlinear'} [mode]  default nonlinear
 * @property {number} [epsilon]     a pure number: 1e-3 faithful, 1e-1 aggressive (default 0.01)
 * @property {number} [iterations]  passes at most (default 5)
 * @property {number} [features]    how strongly sharp features are kept, 0 for not (default 0.3)
 */

/**
 * @typedef {object} MeshQuality
 * @property {number} minAngleDegrees
 * @property {number} distortion   conformal distortion over area; 0 is perfect
 * @property {number} inverted     faces against their surroundings
 * @property {number} area
 * @property {number | null} volume
 */

/**
 * What `regularise` answers; 0 passes where the mesh is as regular as it gets.
 * @typedef {object} Regularised
 * @property {number} passes
 * @property {MeshQuality} before
 * @property {MeshQuality} after
 * @property {number} distance    two-sided, over the size before: of the farthest vertex after from
 *                                the surface before, or before from after; at most 0.01
 * @property {number} pinned      vertices on creases, which stay
 */

/**
 * Options of `flip`, edge-flip optimisation to the end.
 * @typedef {object} FlipOptions
 * @property {Criterion} [criterion]  default localised
 * @property {number} [max]          flips at most
 * @property {boolean} [guardFolds]  faces may not be turned over
 * @property {boolean} [history]     every flip is listed
 */

/**
 * What `flip` answers: the JSON of `umbilic flips`. `circle` is W = 2 Σ β − 2πV over
 * interior edges.
 * @typedef {object} Flipped
 * @property {number} flips
 * @property {number} rejected  flips that would have gained and were refused
 * @property {{ area: number, circle: number }} before
 * @property {{ area: number, circle: number }} after
 * @property {string} [history]  CSV
 */

/**
 * Options of `fill`, hole filling and blending.
 * @typedef {object} FillOptions
 * @property {'all' | 'inner' | number[]} [loops]  boundary loops by number, from 0; inner: all but the
 *                                  longest (default all)
 * @property {boolean} [connect]      one patch connects the loops, instead of one closing each
 * @property {number | null} [maxVertices]  new vertices at most (default 200,000)
 */

/**
 * What `fill` answers; `loaded` then tells the new mesh, in which what was there keeps its
 * numbers. `umbilic fill` prints it without `firstVertex`, with `info` and what `--fair` did.
 * @typedef {object} Filled
 * @property {number[]} loops       those that are no more, by the numbers they had
 * @property {number} verticesAdded
 * @property {number} facesAdded
 * @property {number} firstVertex   the first new vertex; the next flow moves it and those after it
 * @property {Message[]} warnings
 */

/**
 * What `umbilic fill --fair` tells of the flow: it has come to rest only if `status` is
 * `converged`.
 * @typedef {object} Fairing
 * @property {string} flow
 * @property {Status} status
 * @property {string} message
 * @property {string | null} messageId
 * @property {number} steps
 * @property {CurvatureJump | null} curvatureJump  across the rims of the patches
 */

/**
 * One of the `boundaryLoops`.
 * @typedef {object} BoundaryLoop
 * @property {number} edges
 * @property {number} length
 * @property {number[]} vertices  in order
 */

/**
 * What is looked at more closely: a vertex, the circumcircles of all triangles, principal
 * directions.
 * @typedef {{ probe: number | null, circles: boolean, directions: boolean }} Wanted
 */

/**
 * A vertex in numbers; angles in radians.
 * @typedef {object} Probe
 * @property {number} vertex
 * @property {[number, number, number]} position  in the coordinates of the file
 * @property {boolean} boundary
 * @property {{ neighbour: number, length: number, beta: number | null, boundary: boolean }[]} edges
 *                                in cyclic order; `beta` null where the energy has no angle
 * @property {number | null} turn    β₃ of a boundary vertex, where it counts
 * @property {number} sum         Σβ, with β₃
 * @property {number | null} energy  W_i = Σβ − 2π; null where it is no part of the energy
 * @property {number} defect      K_i, integrated
 * @property {number} meanCurvature   pointwise
 * @property {number} gaussCurvature  pointwise; 0 on the boundary
 * @property {[number, number] | null} principal  κ₁ ≥ κ₂ by the quadratic fit
 * @property {number} area        a third of its triangles
 * @property {number[]} radii     circumradii of its triangles
 */

/** @typedef {{ drawn: number, total: number, leftOut: number }} Drawn */

/**
 * What `look` answers, and every frame brings.
 * @typedef {object} Look
 * @property {Probe | null} probe  null also where there is no such vertex
 * @property {Float32Array} ends   of segments over the surface, two of three coordinates each
 * @property {Uint8Array} kinds    a segment: 0 spoke, 1 circle at the vertex, 2 any circle,
 *                                 3 larger, 4 smaller principal curvature
 * @property {Drawn | null} circles  left out: circles larger than the surface
 * @property {Drawn | null} directions  left out: umbilics
 * @property {{ aligned: number, edges: number } | null} alignment  edges within 5° of a line of
 *                                 curvature, of those not between umbilics
 */

/**
 * @typedef {object} InversionReadings
 * @property {number} circle         W over interior vertices: Möbius invariant
 * @property {number | null} circleClosed  open surfaces: W with loops closed at infinity, not invariant
 * @property {number} willmore       ∫H² dA
 * @property {number} area
 */

/**
 * An inversion in numbers: what `invert` answers beside `loaded`.
 * @typedef {object} InversionReport
 * @property {[number, number, number]} centre  in the coordinates of the file
 * @property {number} radius
 * @property {boolean} mirrored      a reflection follows, so that normals point where they did
 * @property {number} distance       of the centre from the surface, in diagonals of its box
 * @property {InversionReadings} before
 * @property {InversionReadings} after
 * @property {number} angles         sum of all angles, which the rounding of W is measured by
 * @property {number} largestChange  of a W_i
 */

/**
 * What `previewInversion` answers: nothing has changed.
 * @typedef {{ report: InversionReport, positions: Float32Array, field: Field | null, look: Look }} Inverted
 */

/**
 * What `configure` and `continueWith` answer.
 * @typedef {object} Configured
 * @property {number} freeVertices
 * @property {number} meanEdgeLength   h
 * @property {number} dt               the first step's raw size
 * @property {number} tau              the same without a unit
 * @property {State} state
 * @property {Uint8Array} heldVertices  1 where a vertex is held, 0 where it moves
 */

/**
 * `singular`: the surface pinches off or vanishes; `collapsed`: a step would go below what a theorem
 * leaves to smooth surfaces of this topology.
 * @typedef {'ready' | 'running' | 'converged' | 'stepLimit' | 'stalled' | 'singular' | 'collapsed' |
 *           'failed'} Status
 */

/**
 * The functional that never rises on a step of the recommended scheme.
 * @typedef {'smoothedCircle' | 'area' | 'willmore' | 'pWillmore' | 'helfrich' |
 *           'curvatureVariation'} Monitored
 */

/**
 * One accepted step. The keys up to `milliseconds` are those of `flow --report`.
 * @typedef {object} StepReport
 * @property {number} step
 * @property {number} time
 * @property {number} dt
 * @property {number} energy            W = Σ W_i as printed in the paper, or ∫|H|^p dA; the area
 *                                      (mean-curvature, surface-diffusion), ∫H² dA (willmore) or
 *                                      ∫|∇H|² dA (mmcv) near the free vertices
 * @property {number} energyNormalised  W/2, or ∫|H|^p dA over that of the sphere of the same area
 * @property {Monitored} monitored
 * @property {number} objectiveBefore   that functional, before …
 * @property {number} objective         … and after
 * @property {boolean} prepares         the step prepares a rough start, and may raise the objective
 * @property {number} gradientNorm
 * @property {number} area
 * @property {number | null} volume
 * @property {number} minAngleDegrees
 * @property {number} rejected          trial steps refused before this one
 * @property {number} iterations        inner iterations (linear or Newton)
 * @property {number} milliseconds
 * @property {number} tau               dt/h², or dt/L^(p+2)
 * @property {number} epsilon
 * @property {number} negativePivots
 * @property {number} skippedAngles     angles whose gradient is undefined and was left out
 * @property {number} flippedFaces      faces that folded over in this step, against their neighbours
 * @property {number} maxDisplacement   from the start, in mean edge lengths
 * @property {Multipliers} [multipliers]  where area or volume is kept
 * @property {number} [reducedVolume]   6√π V/A^(3/2), 1 for a sphere; p-Willmore only
 * @property {FlipReading[]} [flips]    edge flips: each criterion, the chosen one first
 * @property {number} [update]          flows by mean curvature and its derivatives: how far a vertex
 *                                      was to move at most, in mean edge lengths
 * @property {number} [linearResidual]  the same flows: relative residual of the linear system
 * @property {number} assembleMilliseconds
 * @property {number} factorMilliseconds
 * @property {number} solveMilliseconds
 * @property {number} regulariseMilliseconds  for sliding vertices along the surface
 * @property {Message[]} warnings
 */

/**
 * What `curvatureJump` answers: how H jumps across the boundary of what moves, root mean
 * square; `relative` to H outside, 0 where the curvature is continuous.
 * @typedef {{ absolute: number, relative: number, vertices: number }} CurvatureJump
 */

/**
 * What helps: options that `change`, from the start or from the surface as it is, or an action.
 * @typedef {object} Remedy
 * @property {'regularise' | 'regulariseEachStep' | 'subdivide' | 'smallerStep' | 'automaticStep' |
 *   'largerEpsilon' | 'recommendedScheme' | 'continue' | 'back' | 'keepAndFlips' | 'keepVolume' |
 *   'otherFlow' | 'prefill' | 'lowerExponent' | 'refine'} id
 * @property {Message} label
 * @property {FlowOptions} change
 * @property {boolean} fromStart
 * @property {number} steps  to go back
 */

/**
 * What `why` answers: what is the matter, where, and what helps.
 * @typedef {object} Diagnosis
 * @property {string} kind       a noun, e.g. `Pinch`
 * @property {Message} message
 * @property {Uint32Array} vertices
 * @property {Uint32Array} faces  triangles
 * @property {Uint32Array} edges  two ends each
 * @property {Remedy[]} remedies  three at most, the best first
 */

/**
 * Options of `study`: a sample shape by name, or the surface as it is.
 * @typedef {{ shape?: string, parameters?: Record<string, number>, p?: number }} StudyOptions
 */

/**
 * The surface at one resolution. Energies without a unit but for `power`, length^(2−p).
 * @typedef {object} Resolution
 * @property {number} vertices
 * @property {number} faces
 * @property {number} h          mean edge length
 * @property {number} area
 * @property {number} circle     W/2
 * @property {number} cotangent  ∫H² dA by cotangents
 * @property {number} fitted     ∫H² dA by quadratic fits
 * @property {number} power      ∫|H|^p dA by cotangents
 * @property {number} gauss      ∫K dA by quadratic fits
 * @property {number} unfit      vertices that no quadratic surface fits
 */

/**
 * Where the values of a quantity lead.
 * @typedef {object} Trend
 * @property {'area' | 'circle' | 'cotangent' | 'fitted' | 'power'} quantity
 * @property {number[]} values
 * @property {number | null} smooth
 * @property {boolean} isKnown   in closed form, and not from the finest mesh
 * @property {number[]} errors
 * @property {(number | null)[]} orders  between a resolution and the one before
 * @property {'exact' | 'converges' | 'elsewhere' | 'diverges' | 'unknown'} tendency
 */

/**
 * What `study` answers: a refinement study as far as it has come.
 * @typedef {object} Study
 * @property {'sampled' | 'polyhedron' | 'loop'} manner
 * @property {number} p
 * @property {Resolution[]} rows  coarsest first
 * @property {Trend[]} trends
 * @property {boolean} finished
 * @property {number} mostVertices
 */

/**
 * Lagrange multipliers per energy ∫|H|^p dA.
 * @typedef {{ tension: number | null, pressure: number | null }} Multipliers
 */

/**
 * Where a session stands; the readings of the page.
 * @typedef {object} State
 * @property {number} step
 * @property {number} time
 * @property {Status} status
 * @property {Message | null} message  why the run is over
 * @property {number} energy          the flow's own, as in `StepReport`
 * @property {number} energyNormalised
 * @property {number} dt
 * @property {number} tau
 * @property {number} area
 * @property {number | null} volume
 * @property {number} minAngleDegrees
 * @property {Monitored} monitored
 * @property {number} objective       that functional
 * @property {number} gradientNorm
 * @property {number} milliseconds    of the last step
 * @property {Multipliers | null} multipliers
 * @property {number | null} reducedVolume
 * @property {FlipReading[] | null} flips
 * @property {boolean} canStepBack
 */

/**
 * The stored steps of the present path, and other ways on.
 * @typedef {object} Timeline
 * @property {number} start   always stored
 * @property {number} first   from here to `last` every step is stored; between it and the start, none
 * @property {number} last
 * @property {number} at      the step that is shown
 * @property {number | null} previous  the stored step before it
 * @property {number | null} next      after it; the same where the mesh was regularised next
 * @property {number} stored  moments of the path that are stored
 * @property {{ id: number, from: number, last: number, energy: number }[]} branches  oldest first
 */

/** @typedef {{ steps: number } | { regularise: RegulariseOptions } | { flow: FlowOptions } | 'anew'} RecipeLeg */

/**
 * A run, and what made another mesh of its end.
 * @typedef {object} RecipeChapter
 * @property {FlowOptions | null} flow
 * @property {RecipeLeg[]} path
 * @property {'adopt' | { fill: FillOptions } | { flip: FlipOptions } |
 *            { subdivide: { scheme: 'linear' | 'loop' } } | { invert: [number, number, number] }} edit
 */

/**
 * How the present surface came about.
 * @typedef {{ edits: RecipeChapter[], flow: FlowOptions | null, path: RecipeLeg[] }} Story
 */

/**
 * @typedef {'none' | 'mean-curvature' | 'gauss-curvature' | 'willmore' | 'gradient' | 'displacement' |
 *           'distance'} FieldName  `distance`, from one pane to another, is the page's own
 */

/**
 * A value per vertex and how to show it.
 * @typedef {object} Field
 * @property {FieldName} name
 * @property {string} [label]  of a field that is the page's own
 * @property {Float32Array} values
 * @property {number} low      robust range (2nd and 98th percentile); symmetric when signed
 * @property {number} high
 * @property {boolean} signed  true: diverging colours about 0
 */

/**
 * A picture of the surface after a step, at most one per display frame and only
 * after the last was acknowledged.
 * @typedef {object} Frame
 * @property {'frame'} type
 * @property {number} run            frames of an older run are dropped
 * @property {State} state
 * @property {StepReport[]} reports  of the steps taken since the last frame, oldest first
 * @property {Float32Array} positions
 * @property {Field | null} field
 * @property {Uint32Array} flippedTriangles  triangles to highlight
 * @property {Pane[]} panes          of edge flips, which change the connectivity, or of flows side by side
 * @property {Curves | null} curves  of edge flips
 * @property {CurvatureJump | null} jump  across the boundary of what moves
 * @property {Look | null} look      null where nothing is looked at more closely
 * @property {Timeline | null} timeline  null in a frame that the page makes itself
 * @property {Story | null} [story]  null where it is not known; none while the flow runs
 * @property {{ options: FlowOptions, configured: Configured }} [flow]  that stands there, where the
 *   page knows of another
 */

/**
 * Requests to the worker: `{ id, type, … }`. Each is answered by exactly one
 * `{ id, ok }` or `{ id, error: Fault }`; `configure`, `run`, `step`, `back`, `reset` and
 * `restore` also cause `frame` events, and `run` ends with one `stopped` event unless it is paused.
 * `configure` goes back to the start, `continueWith` goes on from the surface as it is.
 *
 * | type        | fields                        | ok                          |
 * | ----------- | ----------------------------- | --------------------------- |
 * | `load`      | `name`, `bytes: ArrayBuffer`  | `Loaded`                    |
 * | `sample`    | `name`, `parameters`          | `Loaded`                    |
 * | `configure` | `options: FlowOptions`, `run` | `Configured`                |
 * | `continueWith` | `options: FlowOptions`, `run` | `Configured`: step, time and history go on; what was to come becomes a branch |
 * | `run`       | `run`, `until: number | null` | `true`, at once; pauses by itself at step `until`; otherwise edge flips take a step a frame |
 * | `pause`     |                               | `State`, after the current step |
 * | `step`      | `run`                         | `StepReport \| null`: null when there was none to take |
 * | `regularise` | `options: RegulariseOptions`, `run` | `Regularised`       |
 * | `arrange`   | `arrangement`                 | `State`; a run goes on      |
 * | `adopt`     |                               | `Loaded`                    |
 * | `undo`      | `run`                         | `Loaded`; the frame tells where the run stood, and its flow |
 * | `subdivide` | `options: { scheme: 'linear' \| 'loop' }` | `Loaded`       |
 * | `loops`     |                               | `BoundaryLoop[]`            |
 * | `fill`      | `options: FillOptions`, `run` | `{ filled: Filled, loaded: Loaded }` |
 * | `look`      | `wanted: Wanted`              | `Look`; frames then bring one too |
 * | `previewInversion` | `centre: number[]`     | `Inverted`; from the middle of the box, in diagonals of it |
 * | `invert`    | `centre`                      | `{ report: InversionReport, loaded: Loaded }` |
 * | `conjecture` |                              | `Conjecture`                |
 * | `quadrilateral` | `corners: number[]`       | `Quadrilateral`             |
 * | `lab`       | `pairs`                       | `Lab`                       |
 * | `why`       |                               | `Diagnosis \| null`        |
 * | `judge`     | `figure: string`              | `Finding \| null`: of the surface as it is or, where that does not say it all, of a run of its own; null where another mesh came first |
 * | `selfIntersections` |                       | `SelfIntersections \| null`: null where it would take too long |
 * | `study`     | `options: StudyOptions \| null` | `Study`: one more resolution; with options it begins anew |
 * | `back`      | `run`                         | `State`                     |
 * | `seek`      | `step`, `run`                 | `State`; of the steps that the page may not know the frame tells step, time, dt, energy and objective |
 * | `branch`    | `branch`, `run`               | `State`, likewise           |
 * | `story`     |                               | `{ story: Story, state: State, positions: Float32Array }` |
 * | `prepare`   | `recipe`, `bytes: ArrayBuffer \| null` | `Loaded`: the recipe's mesh and its edits |
 * | `follow`    | `recipe`, `run`               | `State` after its steps     |
 * | `sequence`  | `format`, `every`             | `Uint8Array`: a ZIP of the stored steps (transferred) |
 * | `sequenceSize` | `format`, `every`          | `{ meshes: number, bytes: number }` before compression, estimated |
 * | `reset`     | `run`                         | `State`                     |
 * | `colour`    | `field: FieldName`            | `Field \| null`             |
 * | `export`    | `format`                      | `Uint8Array` (transferred)  |
 * | `history`   |                               | `string` (CSV)              |
 * | `bending`   |                               | `number`, ∫H² dA            |
 * | `restore`   | `positions`, `step`, `time`, `run` | `State`                |
 * | `ack`       | `run`                         | nothing is answered         |
 *
 * @typedef {{ id: number, type: string } & Record<string, any>} Request
 * @typedef {{ id: number, ok?: any, error?: Refusal }} Reply
 * @typedef {{ type: 'ready', version: string }} Ready            solver loaded and warm
 * @typedef {{ type: 'progress', run: number, stage: string, fraction: number }} Progress  inside a long step
 * @typedef {{ type: 'stopped', run: number, state: State, fault: Refusal | null }} Stopped  `fault` when a step was refused
 * @typedef {{ type: 'crashed', message: string }} Crashed        the wasm instance is dead; discard the worker
 * @typedef {Frame | Ready | Progress | Stopped | Crashed} Event
 */

export {};
