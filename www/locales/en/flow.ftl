# Flows: src/flow.

## Why a flow cannot start or go on

flow-not-triangular = face { FACE($face) } has { $corners } corners; this flow works on triangles
    .hint = Triangulate the mesh first.
flow-zero-length-edge = the edge between vertices { VERTEX($a, bare: 1) } and { VERTEX($b) } has no length{ $others ->
    [0] {""}
    [one] ; one other edge is like it
   *[other] ; { $others } other edges are like it
}
    .hint = A repair collapses the edge.
flow-nothing-free = no vertex is free to move
    .hint = Choose a larger selection. A clamped boundary holds the vertices within one edge of it too: a fixed or free one does not, or a finer mesh helps.
flow-selection-out-of-range = the selection names vertex { VERTEX($vertex) }, but there are only { $vertices } vertices
    .hint = Vertices have the numbers that the file gives them.
flow-option = { $error }
flow-not-closed = the surface has { $loops ->
    [one] { $loops } boundary loop
   *[other] { $loops } boundary loops
}; this flow is for closed surfaces
    .hint = Fill its holes, or choose the circle-angle Willmore flow, which takes boundaries.
flow-not-oriented = the surface is one-sided; this flow is for orientable surfaces
    .hint = Choose the circle-angle Willmore flow, which needs no orientation.
flow-mixed-faces = the mesh mixes faces of different degree
    .hint = Triangulate the mesh first.
flow-too-large = the mesh has { $vertices } vertices; the paper's scheme takes { $limit }
    .hint = Choose the recommended scheme, which tends to the same flow, or a coarser mesh.
flow-unfit = the surface cannot be fitted at vertex { VERTEX($vertex) }
    .hint = It has too few neighbours, some of them coincide, or faces around it have collapsed or are folded: subdivide the mesh, repair it there, or hold the vertices around it.
flow-inaccurate = the linear system was solved to a residual of { NUMBER($residual, digits: 2) } only
    .hint = Choose a smaller step size, a coarser mesh or a flow of lower order.
flow-non-finite-energy = the energy is not a finite number at step { $step }
    .hint = Go back a step, choose a smaller step size or the recommended scheme, and look for a folded or collapsed triangle.
flow-linear = the linear system could not be solved: { $reason }

## Warnings of a step

warning-near-bound = ∫H² is below that of every smooth surface with these handles: the mesh no longer resolves the surface.
warning-growth = The area has grown several times over: a bubble, round and thus cheap, may be forming. From a rough start, smooth a little first.
warning-balloon = Half of the area is held by few large faces: a part inflates, which this energy does not mind. The p-Willmore flow with area and volume kept prevents that.
warning-reading-rose = W rose from { NUMBER($before, digits: 5) } to { NUMBER($after, digits: 5) } in this step, although the smoothed energy fell: many angles were near zero.
warning-roughened = ∫H² rose from { NUMBER($before, digits: 4) } to { NUMBER($after, digits: 4) } while W fell: the surface became rougher. Where edges cross the lines of curvature at a slant, W tells more of the mesh than of the surface. Remesh it first, or smooth by surface diffusion.
warning-coarse = At vertex { VERTEX($vertex) } edges are too long for the curvature: use a finer mesh.
warning-nearly-singular = At vertex { VERTEX($vertex) } the surface is about to become singular, as a neck that pinches off: use a finer mesh.
warning-large-face = The largest face has grown to { $times } times the mean: one part of the surface inflates, and the energy shown is too low. A finer mesh helps.
warning-slivers = The mesh degenerates: its smallest angle is { NUMBER($degrees, digits: 2) }°, { NUMBER($before, digits: 2) }° when these triangles were new. { $advice }.
warning-folded-faces = { $count ->
    [one] { $count } face
   *[other] { $count } faces
} folded over in this step.
warning-far-moves = The recommended scheme limits how far vertices move.
warning-iterative-mesh = The mesh is too large to factor its matrices in memory: they are solved iteratively, and steps take longer.
warning-iterative-patch = The patch is too large to factor its matrix in memory: it is solved iteratively, and steps take longer.
warning-inaccurate = The linear system was solved to a residual of { NUMBER($residual, digits: 2) } only.
warning-margin = { $rings ->
    [2] Fewer than two rings of held vertices lie between the free patch's boundary and the mesh's: there the surface is fitted from one side, and only positions are given, not the curvature.
   *[other] Fewer than one ring of held vertices lies between the free patch's boundary and the mesh's: there the surface is fitted from one side, and only positions are given, not the tangent plane.
}
warning-disagreement = Two readings of ∫H², with a lumped and with a consistent mass, part by { NUMBER($percent, digits: 2) } %: the mesh does not resolve its curvature well.
warning-untrusted = Not to be trusted: the mesh is too coarse or too crumpled for its readings to mean much.
warning-branch = The volume is where it was to go. The shape is { $shape ->
    [round] round
    [prolate] prolate
    [oblate] oblate
   *[triaxial] of three different axes
}: its principal lengths are 1 : { $middle } : { $shortest }. Others at rest with this area and volume may have less energy; a perturbation of the start lets a symmetric shape leave an unstable branch.
warning-halved-step = The step was too large, I/dt + K not positive definite, and was halved { $times ->
    [one] once
   *[other] { $times } times
}.
warning-newton-failed = Newton's method did not converge in this step.
warning-near-sphere = Near a sphere semi-implicit steps take over again.
warning-away-from-sphere = Away from a sphere angles are smoothed again.
warning-little-gain = Steps gain little: L-BFGS takes over.
warning-no-gain = Steps gain nothing: L-BFGS takes over.
warning-exact-halt = Exact steps have come to a halt: angles are smoothed again.
warning-another-round = W still falls: another round of L-BFGS.
warning-open-boundary = The area has grown by { $percent } %: a boundary held in place alone does not determine a flow of this order. A clamped one holds its tangent planes too.
warning-rough-start = The start is too rough for the sixth-order flow, which would move it by { NUMBER($edges, digits: 2) } edge lengths: up to { $steps } steps of surface diffusion go before.
warning-back-to-start = No rest in sight: back to the start, up to { $steps } steps of surface diffusion go before.
warning-better-before = A surface on the way had less energy than the last: it is put in place.

## What helps, in half a sentence

advice-finer-mesh = A finer mesh helps
advice-better-mesh = A better mesh helps, as conformal regularisation makes it
advice-regular-or-finer = Conformal regularisation or a finer mesh helps
advice-keep-volume = Where it thins out the surface becomes singular, and keeping the volume prevents that
advice-smooth-first = Smooth with p = 2 first, or use a finer mesh
advice-p-willmore-zero = The p-Willmore flow with p = 0 keeps its mesh a better one
advice-regular-or-p-willmore = Conformal regularisation or the p-Willmore flow helps
advice-first-guess = A smooth first guess, a finer mesh or a flow of lower order helps

## Why a trial step was refused

cause-rise = the energy would rise
cause-reading-jump = the energy as printed would jump up
cause-bound = the energy would be below that of every smooth surface of this topology
cause-unfit = curvatures could no longer be fitted
cause-fold = faces would fold over
cause-too-far = a vertex would move by more than half an edge
cause-turn = a face would turn by more than 60°
cause-sliver = a face would become a sliver
cause-constraints = the constraints cannot be met together
cause-not-finite = the energy is not finite
cause-newton = Newton’s method does not converge, or a face would turn over

## Why a run is over, after its status

clock-own = by this flow’s law
clock-mean-curvature = by the normal velocity −H
clock-area-gradient = by the normal velocity −2H, which takes half as long as −H
reason-at-rest = the surface is at rest
reason-still = no vertex moves any more
reason-zero-energy = the energy is zero to rounding
reason-smoothed = { $steps ->
    [one] { $steps } step of smoothing is
   *[other] { $steps } steps of smoothing are
} done, as asked
reason-step-limit = the limit of { $steps ->
    [one] { $steps } step
   *[other] { $steps } steps
} is reached
reason-time-limit = the { $seconds } seconds of computing are used up, and the surface is not at rest
reason-large-face = face { FACE($face) } is { $times } times as large as the mean, and the mesh no longer resolves the surface. A finer mesh helps, or keeping area and volume under the p-Willmore flow
reason-refused = every step tried was refused, the last because { $cause }. { $advice }
reason-flat-face = { $count ->
    [one] face { FACE($face) } has
   *[other] { $count } faces, the first of them face { FACE($face) }, have
} no area, and no step leads on from there. A repair takes such faces out
reason-creeping = only ever smaller steps lower the energy, which is not at rest. { $advice }
reason-grows-on = the surface has grown to { $times } times its area, and grows for ever: there is no rest unless area or volume is kept
reason-rises = steps of this size lead to more energy, { NUMBER($times, digits: 2) } times what there was on the way. A smaller step size helps, or the scheme that chooses it
reason-rises-on = the energy has risen to { NUMBER($times, digits: 2) } times what it was on the way. { $advice }
reason-worse-rest = the flow ends with more energy than on the way. { $advice }
reason-below-bound = any further step has less energy than every smooth surface of this topology: these triangles no longer show one. A finer or better mesh helps
reason-unresolved = the curvatures of these triangles add up to less than every smooth surface of this topology has. The surface is as it was. Even triangles help, or the p-Willmore flow
reason-vanishes = at about time { NUMBER($time, digits: 2) } ({ $clock }) the surface shrinks to a point near ({ $place }). Keeping the volume prevents that
reason-part-vanishes = by time { NUMBER($time, digits: 2) } ({ $clock }) at the latest a part of the surface has shrunk to a point near ({ $place })
reason-vanishes-to-curve = at about time { NUMBER($time, digits: 2) } ({ $clock }) the surface shrinks to a curve. Keeping the volume prevents that
reason-pinched-neck = at about time { NUMBER($time, digits: 2) } ({ $clock }) a neck pinches off at vertex { VERTEX($vertex) }, near ({ $place }). The flow has no solution beyond it. { $advice }
reason-sharp-tip = the surface bends more at vertex { VERTEX($vertex) }, near ({ $place }), than its triangles show. { $advice }
reason-no-flips = no flip lowers { $criterion ->
    [area] the area
    [willmore] the Willmore energy
    [localised] the localised Willmore energy
   *[all] any of the three costs
} any more
