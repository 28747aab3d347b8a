# What there is to choose from: flows, samples, the figures of the papers, and what was measured on them.

## Flows: their names, and the plain line under them

flow-circle = Willmore by circle angles
    .plain = As round as it can be. Any closed or open mesh.
flow-p-willmore = p-Willmore
    .plain = Area or volume kept, any exponent p. Closed meshes.
flow-mean-curvature = Mean curvature
    .plain = Shrinks the area as fast as possible.
flow-volume-preserving = Volume-preserving mean curvature
    .plain = Shrinks the area while the volume stays: a ball is best. Closed meshes.
flow-surface-diffusion = Surface diffusion
    .plain = Shrinks the area, the volume stays.
flow-willmore = Willmore by fitted operators
    .plain = Bends as little as it can between what is held.
flow-mmcv = Minimal curvature variation, sixth order
    .plain = The smoothest patch: curvature varies least.
flow-flips = Edge flips
    .plain = Moves no vertex, only swaps edges.

## Samples

sample-icosahedron = Subdivided icosahedron
sample-bumpy-sphere = Bumpy sphere
sample-clifford-torus = Clifford torus
sample-pipe = Pipe with clamped ends
sample-six-sided-hole = Six-sided hole
sample-scar = Scar on a stone
sample-noisy-scan = Noisy scan
sample-trefoil = Trefoil knot
sample-blob = Blob, deflated
sample-spheroid = Spheroid of axes 2, 1, 1
sample-letter-c = Letter C
sample-thin-torus = Thin torus
sample-torus-knot = Torus knot
sample-bad-mesh = Ellipsoid, badly meshed
sample-trefoil-kept = Trefoil, area and volume kept
sample-trefoil-tube = Trefoil knot, area kept
sample-linked-tubes = Two linked tubes, area kept
sample-bumps-kept = Bumpy sphere, area kept
sample-ellipsoid-p = Ellipsoid, volume kept, p = 4
sample-cylinder-gaps = Cylinder with four gaps
sample-sphere-openings = Sphere with eight openings
sample-two-tubes = Two tubes blended
sample-three-tubes = Three tubes blended
sample-six-tubes = Six tubes blended
sample-holed-scan = Scan with holes filled
sample-holed-sphere = Sphere with holes filled
sample-dodecahedron = Dodecahedron, corners kept
sample-four-bumps = Four bumps, flows compared
sample-sampled-torus = Sampled torus
sample-uneven-torus = Sampled torus, uneven
sample-creased-face = Face with creases
sample-eared-head = Head with ears
sample-counterexample = Counterexample
sample-moebius = Möbius strip
sample-klein-bottle = Klein bottle
sample-saddle = Saddle, boundary free
sample-genus-4 = Surface with four handles
sample-morin = Morin’s surface, pushed
sample-morin-fine = Morin’s surface, pushed, 5,000 vertices
sample-boy = Boy’s surface
sample-cyclide = Cyclide of Dupin
sample-inverted-catenoid = Inverted catenoid
sample-lawson-two-handles = Towards Lawson’s surface, two handles
sample-lawson-three-handles = Towards Lawson’s surface, three handles
sample-rough-mesh = Ellipsoid, skewed triangles
sample-range-scan = Noisy scan, 38,000 vertices

## Shelves of samples

group-closed = Closed surfaces
group-tubes = Tubes and knots
group-boundary = With a boundary
group-repair = Repair
group-flips = Edge flips

## Papers

paper-circle = { paper-circle.authors }: discrete Willmore flow
    .authors = Bobenko and Schröder
paper-p-willmore = { paper-p-willmore.authors }: p-Willmore flow
    .authors = Gruber and Aulisa
paper-flips = { paper-flips.authors }: edge flips
    .authors = Brink and Alboul
paper-curvature = { paper-curvature.authors }: mean-curvature variation
    .authors = Xu and Zhang
paper-volume-preserving = { paper-volume-preserving.authors }: volume-preserving mean-curvature flow
    .authors = Huisken
paper-eversion = { paper-eversion.authors }: a sphere eversion
    .authors = Francis, Sullivan, Kusner, Brakke, Hartman and Chappell
paper-lawson = { paper-lawson.authors }: minimal surfaces of the 3-sphere
    .authors = Lawson
paper-knots = { paper-knots.authors }: regular homotopy of surfaces
    .authors = Pinkall

## Figures: their number; the paper’s report and what to expect here

figure-circle-6 = Fig. { $number }
    .title = Subdivided icosahedron to a sphere
    .reports = After 24 steps the energy is 1e-7; a perfect sphere would have zero.
    .expected = W starts at 60π and is at most 1e-7 after 24 steps of dt = 0.0345; a round sphere
figure-circle-6-adaptive = Fig. { $number }
    .title = Subdivided icosahedron, adaptive steps
    .reports = The sphere is reached within a few minimisation steps.
    .expected = W ≤ 1e-7 after at most 12 steps, then converged
figure-circle-7-fixed = Fig. { $number }, left
    .title = Boundary fixed
    .reports = A cat's head with its boundary fixed relaxes between its boundary curves.
    .expected = Another shape, a saddle: W falls by at least nine tenths, the surface stays curved
figure-circle-7-free = Fig. { $number }, right
    .title = Boundary free
    .reports = A cat's head with its boundary free evolves to a planar polygon, its boundary convex.
    .expected = Another shape, a saddle: W < 1e-6, that is planar with a convex boundary
figure-circle-8 = Fig. { $number }
    .title = Coarse torus becomes geometric
    .reports = Almost immediately the vertices flow to the surface of a geometric torus.
    .expected = τ = 0.01: W within 5 % of 57 after 100 steps, less than 2.5 % off a torus
figure-circle-8-long = Fig. { $number }, long
    .title = Coarse torus fattens
    .reports = Subsequent evolution aligns edges with the curvature directions and fattens the torus.
    .expected = τ = 0.003, 1000 steps: R/r from 2.13 to 2.04 (±0.02), less than 1.5 % off a torus
figure-circle-9 = Fig. { $number }
    .title = Pipe between two circles
    .reports = A pipe with circular boundary loops evolves as the torus does, to a fat pipe.
    .expected = W from 398.65 to below 80 in 50 steps
figure-circle-10 = Fig. { $number }
    .title = Six-sided hole filled
    .reports = A six-sided hole is filled smoothly though many edges begin with β = 0.
    .expected = Not frozen: after 100 steps W is at least 60 lower
figure-circle-11 = Fig. { $number }
    .title = Scar restored
    .reports = A marked region of the Egea model is restored, its surroundings held.
    .expected = Another shape, a scarred stone: W within 2 % of 6.408, where the undamaged stone comes to rest, in 20 steps
figure-circle-12-10 = Fig. { $number }, 10 steps
    .title = Scan smoothed by 10 steps
    .reports = A scan of 37,000 vertices with 88 boundary loops loses its noise; shown after 10 steps.
    .expected = A made scan with 88 loops and 38,000 vertices: distance to the clean surface below 0.7 of the noise
figure-circle-12-100 = Fig. { $number }, 100 steps
    .title = Scan smoothed by 100 steps
    .reports = A scan of 37,000 vertices with 88 boundary loops loses its noise; shown after 100 steps.
    .expected = A made scan with 88 loops and 38,000 vertices, whose features begin to go: distance to the clean surface below 1.5 of the noise
figure-p-willmore-1 = Fig. { $number }
    .title = Area kept, p = 2
    .reports = A cow of 23,400 triangles rounds off, its area all but unchanged.
    .expected = Another shape, a bumpy sphere: ∫H² within 0.6 % of 4π, a sphere to 1e-3, area to 1e-8
figure-p-willmore-2-p0 = Fig. { $number }, p = 0
    .title = Letter C, p = 0
    .reports = Under p = 0, mean-curvature flow, the letter C shrinks.
    .expected = Area below a fifth after at most 100 steps
figure-p-willmore-2-p2 = Fig. { $number }, p = 2
    .title = Letter C, p = 2
    .reports = Under p = 2 the letter C becomes a round sphere.
    .expected = ∫H² within 1 % of a sphere's after at most 160 steps
figure-p-willmore-2-p4 = Fig. { $number }, p = 4
    .title = Letter C, p = 4
    .reports = Under p = 4 the letter C grows without end.
    .expected = Area above 1.8 times after at most 160 steps
figure-p-willmore-3-linear = Fig. { $number }, linear
    .title = Regularisation, linear
    .reports = Linear regularisation improves a cow's mesh, more roughly than the nonlinear one with slight changes to its shape.
    .expected = Another shape, an ellipsoid with folded triangles: none left, distortion below a third, moved less than 1 % of its size
figure-p-willmore-3-nonlinear = Fig. { $number }, nonlinear
    .title = Regularisation, nonlinear
    .reports = Nonlinear regularisation improves a cow's mesh with slight changes to its shape.
    .expected = Another shape, an ellipsoid with folded triangles: none left, distortion below a third, moved less than 1 % of its size
figure-p-willmore-4 = Fig. { $number }
    .title = Torus to the Clifford torus
    .reports = A deformed torus flows to the Clifford torus, the global minimum.
    .expected = A thin torus: ∫H² within 1.6 % of 2π², reduced volume within 1.2 % of 0.7116
figure-p-willmore-5 = Fig. { $number }
    .title = Torus knot, area and volume kept
    .reports = A (3,4)-torus knot relaxes, area and volume kept, and stays nearly isometric.
    .expected = ∫H² falls, area and volume to 1e-8, smallest angle above half of the first
figure-p-willmore-6 = Fig. { $number }
    .title = Biconcave disc from a vesicle
    .reports = A rabbit, area and volume kept, becomes a biconcave disc as a red blood cell.
    .expected = Another shape, a spheroid, led to v = 0.6: ∫H² within 1.2 % of 1.95568·4π, the axisymmetric minimiser
figure-p-willmore-6-blob = Fig. { $number }
    .title = Biconcave disc from a blob
    .reports = A rabbit, area and volume kept, becomes a biconcave disc as a red blood cell.
    .expected = Another shape, a blob without symmetry, led to v = 0.6: ∫H² within 1.2 % of 1.95568·4π, the axisymmetric minimiser
figure-p-willmore-7 = Fig. { $number }
    .title = One pass of linear regularisation
    .reports = One linear pass improves a statue of 483,000 triangles.
    .expected = Another shape, an ellipsoid with skewed triangles: none folded, distortion below a third, moved less than 1 %
figure-p-willmore-8 = Fig. { $number }
    .title = Genus 4, free
    .reports = A statue of genus 4 flows to a round surface with four handles.
    .expected = Another surface of genus 4: ∫H² from above to between 2π² and 8π
figure-p-willmore-9 = Fig. { $number }, top
    .title = Trefoil, regularised
    .reports = Regularised, a trefoil keeps nearly perfect triangles all the way to the minimum.
    .expected = ∫H² falls to a plateau, area and volume to 1e-8, smallest angle not below the first (no final minimum is known)
figure-p-willmore-9-off = Fig. { $number }, bottom
    .title = Trefoil, not regularised
    .reports = Without regularisation the mesh degenerates and the flow gets stuck.
    .expected = Area and volume to 1e-8, smallest angle below half of the first
figure-p-willmore-10-p0 = Fig. { $number }, p = 0
    .title = Energy under refinement, p = 0
    .reports = The energy decreases in every case and appears to converge with refinement.
    .expected = Another shape, an ellipsoid on three meshes: at one time the energies come closer by a factor of 3 to 5
figure-p-willmore-10-p2 = Fig. { $number }, p = 2
    .title = Energy under refinement, p = 2
    .reports = The energy decreases in every case and appears to converge with refinement.
    .expected = Another shape, an ellipsoid on three meshes: at one time the energies come closer by a factor of 3 to 5
figure-p-willmore-10-p4 = Fig. { $number }, p = 4
    .title = Energy under refinement, p = 4
    .reports = The energy decreases in every case and appears to converge with refinement.
    .expected = Another shape, an ellipsoid on three meshes: at one time the energies come closer by a factor of 3 to 5
figure-p-willmore-11 = Fig. { $number }
    .title = One step, then regularisation
    .reports = One step of the flow and two nonlinear passes remesh an armadillo all but unseen.
    .expected = Another shape, an ellipsoid with folded triangles: none left, distortion below a third, moved less than 1 %
figure-p-willmore-12-p0 = Fig. { $number }, p = 0
    .title = Volume kept, p = 0
    .reports = A rabbit, its volume kept, becomes a sphere for every p, on different ways.
    .expected = Another shape, an ellipsoid: a sphere to 2e-3, volume to 1e-8
figure-p-willmore-12-p2 = Fig. { $number }, p = 2
    .title = Volume kept, p = 2
    .reports = A rabbit, its volume kept, becomes a sphere for every p, on different ways.
    .expected = Another shape, an ellipsoid: a sphere to 2e-3, volume to 1e-8
figure-p-willmore-12-p4 = Fig. { $number }, p = 4
    .title = Volume kept, p = 4
    .reports = A rabbit, its volume kept, becomes a sphere for every p, on different ways.
    .expected = Another shape, an ellipsoid: a sphere to 2e-3, volume to 1e-8
figure-flips-6 = Fig. { $number }, top
    .title = Torus, one mesh by all criteria
    .reports = On points of a torus all three criteria lead to exactly the same mesh.
    .expected = Other points, chosen so: 203 flips each, one area and one W (not so on all points)
figure-flips-6-curvature = Fig. { $number }, bottom
    .title = Torus, Gaussian curvature after Loop subdivision
    .reports = Plots of Gaussian curvature of the subdivided meshes show it is visibly smoother.
    .expected = Variation of K along the edges below 0.7 of the start
figure-flips-7 = Fig. { $number }
    .title = Face with creases
    .reports = By area or localised energy a face reaches a lower W than by the Willmore energy.
    .expected = A made face: W by area and by localised energy below W by itself
    .shortfall = On this face flips by the Willmore energy end lower. Which end is lower depends on the mesh: each is only a local minimum.
figure-flips-8 = Fig. { $number }
    .title = Head with ears
    .reports = Area and localised energy fall together and so does W.
    .expected = Another shape than the bunny: area ≤ localised < Willmore in area, both below it in W
figure-flips-8-volume = Fig. { $number }, ears
    .title = Ears lose volume
    .reports = By area, narrow parts such as the bunny's ears lose volume.
    .expected = A head with ears loses 0.2 to 2 % of its volume
figure-curvature-5-1-cylinder = Fig. { $number }
    .title = Cylinder recovered
    .reports = A cylinder with missing parts is correctly recovered, in 100 steps.
    .expected = The cylinder of radius 1 to 0.0005, at rest
figure-curvature-5-1-sphere = Fig. { $number }
    .title = Sphere recovered
    .reports = A sphere with eight openings is perfectly recovered, in 350 steps.
    .expected = The sphere of radius 1 to 0.0005, at rest
figure-curvature-5-4 = Fig. { $number }
    .title = Corners of a dodecahedron interpolated
    .reports = A smooth surface interpolates the corners of a dodecahedron.
    .expected = The sphere of radius 1 to 0.001, at rest
figure-curvature-5-2-two = Fig. { $number }
    .title = Two tubes blended
    .reports = Tubes are blended smoothly by the sixth-order flow, in 5 steps.
    .expected = Coaxial tubes of radius 0.5: the cylinder between them to 1e-3 of it, at rest
figure-curvature-5-2-three = Fig. { $number }
    .title = Three tubes blended
    .reports = Tubes are blended smoothly by the sixth-order flow, in 50 steps.
    .expected = At rest, its jump of curvature at most 0.45 of that of surface diffusion
figure-curvature-5-2-six = Fig. { $number }
    .title = Six tubes blended
    .reports = Tubes are blended smoothly by the sixth-order flow, in 10 steps.
    .expected = At rest, its jump of curvature at most 0.45 of that of surface diffusion
figure-curvature-5-3 = Fig. { $number }
    .title = Holes filled
    .reports = Holes of a head are filled smoothly, with continuous curvature at their rims.
    .expected = A sphere with holes instead of a head: closed, at rest, and the jump of curvature at the rims below 0.1
figure-curvature-5-5 = Fig. { $number }
    .title = Flows compared on a blend
    .reports = The sixth-order flow joins with continuous mean curvature, the fourth-order ones do not.
    .expected = Jump at most 0.45 of that of surface diffusion and of the Willmore flow
figure-curvature-5-6 = Fig. { $number }
    .title = Flows compared on a graph
    .reports = Mean-curvature and Willmore flow are not curvature continuous, the sixth-order one is.
    .expected = The function as repaired: jump at most 0.06 and half of the fourth-order flows', 0.9 and more under mean-curvature flow
figure-volume-preserving-round = Theorem, { $number }
    .title = A convex surface becomes round
    .reports = Volume-preserving mean-curvature flow makes every convex surface a round sphere of the same volume.
    .expected = A sphere to 2e-3, volume to 1e-10, 36πV²/A³ risen to 0.99 and more
figure-eversion = The minimax eversion, { $number }
    .title = The sphere turned inside out
    .reports = A sphere can be turned inside out through itself without a crease (Smale, 1958). It has to pass through a quadruple point and ∫H² = 16π (Max and Banchoff, 1981; Li and Yau, 1982); Morin’s surface after Kusner has just that much, and bending less it flows to the sphere on either side.
    .expected = Both ways end at a round sphere, ∫H² below 1.005·4π; volumes of opposite signs, within 1 % of the ball’s; no crossings at the ends; immersed at every step, least product of face and vertex normals above 0.3
figure-eversion-fine = The minimax eversion, { $number }, finer
    .title = The sphere turned inside out, 5,000 vertices
    .reports = A sphere can be turned inside out through itself without a crease (Smale, 1958); the same film on a finer mesh, which takes about ten times as long.
    .expected = Both ways end at a round sphere, ∫H² below 1.005·4π; volumes of opposite signs, within 1 % of the ball’s; no crossings at the ends; immersed at every step, least product of face and vertex normals above 0.3
figure-lawson-2 = ξ₂,₁, { $number }
    .title = The surface with two handles that bends least
    .reports = Lawson’s minimal surface ξ₂,₁ of the 3-sphere has the area 21.89, and so its image in space has the Willmore energy 21.89. Kusner conjectures (1989) that no surface with two handles bends less; for one handle Marques and Neves proved it (2014).
    .expected = Two handles at the end, ∫H² = 21.89 to 0.7 %, the area kept to 1e-8
figure-lawson-3 = ξ₃,₁, { $number }
    .title = The surface with three handles that bends least
    .reports = Lawson’s ξ₃,₁ has the Willmore energy 22.82. The series goes on towards 8π: 8π(1 − ln 2/(2g + 2) − …) for g handles (Heller, Heller and Traizet, 2023).
    .expected = Three handles at the end, ∫H² = 22.82 to 0.7 %, the area kept to 1e-8
figure-knot-undone = A knot, { $number }
    .title = A knot that comes undone
    .reports = An immersion may pass through itself, and so a knotted torus can be carried into one without a knot. Of all tori the Clifford torus bends least, ∫H² = 2π² (Marques and Neves, 2014).
    .expected = One torus at the end, ∫H² = 2π² to 1 %, having passed through itself on the way; the area kept to 1e-8
figure-link-undone = A link, { $number }
    .title = A link that comes undone
    .reports = An immersion may pass through itself, and so two linked tori can each take the shape that bends least, as if the other were not there: ∫H² = 2·2π².
    .expected = Two tori at the end, ∫H² = 4π² to 1 %, which pass through each other; the area kept to 1e-8

## Measured on a figure

figure-waiting = { $steps ->
    [rest] Play, until it comes to rest.
    [0] As it stands.
   *[other] Play, at least to step { $steps }.
}
figure-measuring = Measuring…
measured-round = W { NUMBER($first, digits: 4) }π → { NUMBER($last, digits: 2) } in { $steps } steps, off the sphere { NUMBER($off, digits: 2) }
measured-rest = W { NUMBER($last, digits: 2) } after { $steps } steps, { $status }
measured-plane = W { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }, out of plane { NUMBER($off, digits: 2) }
measured-torus = W { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }, off a torus { NUMBER($off, digits: 2) } %
measured-proportions = R/r { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }, off a torus { NUMBER($off, digits: 2) } %
measured-energy = W { NUMBER($first, digits: 5) } → { NUMBER($last, digits: 4) }
measured-noise = W { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }, distance × { $ratio }
measured-area-kept = ∫H² = { NUMBER($energy, digits: 4) }·4π, off { NUMBER($off, digits: 2) }, drift { NUMBER($drift, digits: 1) }
measured-letter = area × { $area }, ∫|H|^p = { NUMBER($energy, digits: 4) } of the sphere's, { $status }
measured-mended = inverted { $firstInverted } → { $lastInverted }, angle { NUMBER($firstAngle, digits: 2) }° → { $lastAngle }°, distortion { $firstDistortion } → { $lastDistortion }, moved { NUMBER($moved, digits: 2) } %, volume { NUMBER($volume, digits: 2) } %
measured-clifford = ∫H² = { NUMBER($energy, digits: 4) }·2π², v = { NUMBER($volume, digits: 4) }
measured-kept = ∫H² { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }, angle { $firstAngle }° → { $lastAngle }°, drift { NUMBER($drift, digits: 1) }, { $status }
measured-vesicle = ∫H² = { NUMBER($energy, digits: 4) }·4π at v = { NUMBER($volume, digits: 6) }, { $status }
measured-genus = genus { $genus }, ∫H² { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) } = { NUMBER($energy, digits: 4) }·8π, { $status }
measured-refinement = { NUMBER($coarse, digits: 5) }, { NUMBER($middle, digits: 5) }, { NUMBER($fine, digits: 5) }: ratio { $ratio }
measured-refinement-apart = { NUMBER($coarse, digits: 5) }, { NUMBER($middle, digits: 5) }, { NUMBER($fine, digits: 5) }: ratio { $ratio }, not at one time
measured-ball = off { NUMBER($off, digits: 2) }, drift { NUMBER($drift, digits: 1) }, { $steps } steps, { $status }
measured-isoperimetric = 36πV²/A³ { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 5) }, off { NUMBER($off, digits: 2) }, drift { NUMBER($drift, digits: 1) }, { $steps } steps, { $status }
measured-eversion = ∫H²/4π { NUMBER($firstEnergy, digits: 5) } ← { NUMBER($halfway, digits: 4) } → { NUMBER($lastEnergy, digits: 5) }, V over the ball’s { NUMBER($firstVolume, digits: 4) } and { NUMBER($lastVolume, digits: 4) }, crossings { $firstCrossings } ← { $crossings } → { $lastCrossings }, least product of normals { NUMBER($alignment, digits: 2) }
measured-lawson = genus { $genus }, ∫H² { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 5) }, expected { NUMBER($least, digits: 4) }: { NUMBER($off, digits: 2) } %; drift { NUMBER($drift, digits: 1) }, angle { NUMBER($angle, digits: 2) }°, { $status }
measured-undone = ∫H² { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 5) } times { $tubes }·2π²; crossings at most { $crossings }, at the end { $left }; least product of normals { NUMBER($alignment, digits: 2) }, drift { NUMBER($drift, digits: 1) }, { $status }
measured-flips = area/Willmore/localised: { $areaFlips }/{ $willmoreFlips }/{ $localisedFlips } flips, area { NUMBER($area, digits: 5) }/{ NUMBER($willmoreArea, digits: 5) }/{ NUMBER($localisedArea, digits: 5) }, W { NUMBER($areaCircle, digits: 4) }/{ NUMBER($willmoreCircle, digits: 4) }/{ NUMBER($localisedCircle, digits: 4) }
measured-variation = Σ|ΔK| { NUMBER($first, digits: 4) } → { NUMBER($last, digits: 4) }
measured-lost = { $lost } % lost
measured-recovered = off { NUMBER($first, digits: 2) } → { NUMBER($last, digits: 2) } in { $steps } steps, { $status }
measured-tube = off { NUMBER($off, digits: 2) }, jump { NUMBER($jump, digits: 2) } in { $steps } steps, { $status }
measured-holes = { $loops } loops left, { $status } in { $steps } steps, jump { NUMBER($jump, digits: 2) }
measured-jumps = mean-curvature { $meanCurvature }, surface-diffusion { $surfaceDiffusion }, willmore { $willmore }, mmcv { $mmcv }
measured-incomplete = Not all of it has run.

measured-ready = ready
measured-converged = converged
measured-step-limit = stepLimit
measured-stalled = stalled
measured-singular = singular
measured-collapsed = collapsed
measured-failed = failed

## The phase diagram of vesicles

phases = Vesicles: phase diagram
phases-hint = The least ∫H² over the reduced volume v = 6√π V/A^(3/2), of three branches of shapes with area and volume kept (Seifert, Berndl and Lipowsky, 1991). Prolate shapes bend least above 0.651, oblate ones down to 0.592, stomatocytes below. Every point is computed here; a click shows its surface.
phases-run = Compute the shapes
phases-count = { $count } of { $of } shapes
phase-of = Branch
phase-expected = Expected
phase-branch = { $branch ->
    [prolate] prolate
    [oblate] oblate
   *[stomatocyte] stomatocyte
}
phase-point = Show the { phase-branch } shape of volume { $volume }, ∫H²/4π = { $energy }

## Samples, and what to look for

sample-icosahedron-shows = Becomes a round sphere; W starts at exactly 60π and falls to zero (figure 6).
sample-bumpy-sphere-shows = Bumps melt, short ones first, until the sphere is round and W is zero.
sample-coarse-torus-shows = Rounds off, then its proportions creep towards R/r = √2 (figure 8).
sample-clifford-torus-shows = The minimum among tori: W/2 is near 2π², and the flow hardly moves it.
sample-pipe-shows = Both ends keep their position and tangent; the bend between them relaxes (figure 9).
sample-six-sided-hole-shows = Fills a hexagonal hole smoothly, from a harmonic first guess (figure 10).
sample-scar-shows = Only the damaged patch moves, and closes without a seam (figure 11).
sample-noisy-scan-shows = Ten steps take away the noise and leave the shape (figure 12).
sample-trefoil-shows = A knotted tube fattens; it cannot untie itself.
sample-vesicle-shows = Area kept, the volume is led down to 0.6 of the ball’s: a biconcave disc, as a red blood cell (p-Willmore, figure 6).
sample-blob-shows = Without any symmetry at the start it ends as a biconcave disc too, an elliptical one (p-Willmore, figure 6).
sample-spheroid-shows = Becomes round while its volume stays: the area falls, and 36πV²/A³ rises to 1.
sample-letter-c-shows = Rounds off to a sphere with p = 2; shrinks with p = 0, grows with p = 4 (p-Willmore, figure 2).
sample-thin-torus-shows = Thickens into the Clifford torus: ∫H² falls to 2π² (p-Willmore, figure 4).
sample-torus-knot-shows = Area and volume kept; without regularisation the mesh degenerates (p-Willmore, figure 5).
sample-bad-mesh-shows = Triangles have turned over; “Even out triangles” mends them without changing the shape (p-Willmore, figures 3, 7 and 11).
sample-trefoil-kept-shows = A thick knotted tube comes to rest on a plateau of ∫H² (p-Willmore, figure 9).
sample-trefoil-tube-shows = A knotted tube passes through itself and ends as the Clifford torus: ∫H² = 2π² (Pinkall; Marques and Neves).
sample-linked-tubes-shows = Two linked tubes pass through each other and end as two Clifford tori: ∫H² = 4π².
sample-bumps-kept-shows = Rounds off without growing or shrinking (p-Willmore, figure 1).
sample-ellipsoid-p-shows = A sphere in the end, on another way for every exponent p (p-Willmore, figure 12).
sample-cylinder-gaps-shows = Sunken patches rise back to the cylinder: its mean curvature is constant (variation of curvature, figure 5.1).
sample-sphere-openings-shows = Eight flat lids become the sphere they were cut from (variation of curvature, figure 5.1).
sample-two-tubes-shows = A patch that connects both becomes the cylinder between them (variation of curvature, figure 5.2).
sample-three-tubes-shows = The blend joins its tubes with continuous curvature; compare all four flows (variation of curvature, figure 5.2).
sample-six-tubes-shows = Along all three axes (variation of curvature, figure 5.2).
sample-holed-scan-shows = What the scanner did not see is filled and faired (variation of curvature, figure 5.3).
sample-holed-sphere-shows = Holes are triangulated, remeshed, pre-filled and faired: the sphere again (variation of curvature, figure 5.3).
sample-dodecahedron-shows = Twenty points are interpolated: the sphere through them (variation of curvature, figure 5.4).
sample-four-bumps-shows = Only the sixth-order flow joins with continuous mean curvature: look at the jump (variation of curvature, figures 5.5 and 5.6; its function as repaired, exp(−27/16 …)).
sample-sampled-torus-shows = Each cell is cut along either diagonal; flips tidy that up. Here the three criteria end at the same mesh (edge flips, figure 6).
sample-uneven-torus-shows = Here area and localised energy lead to one mesh, the Willmore energy to another.
sample-creased-face-shows = Long vertical edges make creases; flips smooth most of them out (edge flips, figure 7).
sample-eared-head-shows = By area or localised energy W ends lower than by itself, and the ears lose volume (edge flips, figure 8).
sample-counterexample-shows = Flipping this edge raises the area and lowers the localised energy: f_a = 15/2 − 2√2 − √89/2 = −0.0454, f_l = +0.0068.
sample-moebius-shows = One side and one edge; the energy needs no orientation.
sample-klein-bottle-shows = Closed and one-sided: it has no volume, but it has an energy.
sample-saddle-shows = Set free it becomes a flat, convex piece of the plane; with its boundary fixed it stays a saddle (figure 7).
sample-genus-4-shows = Its handles round off; ∫H² tends below 8π (p-Willmore, figure 8).
sample-morin-shows = Half of a sphere turned inside out: from 16π through itself to a round sphere (Kusner).
sample-morin-fine-shows = The same half of an eversion on a finer mesh.
sample-boy-shows = A projective plane, one-sided, and the least bent of all that there are in space: ∫H² = 12π (Bryant, Kusner).
sample-cyclide-shows = A Möbius image of the Clifford torus, with the same energy: W/2 is near 2π².
sample-inverted-catenoid-shows = Two sheets that touch in a point: ∫H² = 8π, as of every inverted minimal surface with two ends.
sample-lawson-two-handles-shows = Flows to Lawson’s ξ₂,₁, of which it has the symmetries and the great circles: ∫H² = 21.89, the least known with two handles.
sample-lawson-three-handles-shows = Flows to Lawson’s ξ₃,₁: ∫H² = 22.82, the least known with three handles.
sample-rough-mesh-shows = One pass of “Even out triangles” is enough here (p-Willmore, figure 7).
sample-range-scan-shows = As large as the paper’s, with as many holes; a hundred steps begin to take the features too (figure 12).

## New triangles between steps

step-remeshed = step { $step }, after remeshing: energy { NUMBER($before, digits: 5) } to { NUMBER($after, digits: 5) }
