# The application: src/app.

## What cannot be done

app-no-mesh = there is no mesh
    .hint = Open a mesh or choose a sample first.
app-not-fetched = a part of the program that this needs could not be fetched
    .hint = Nothing is lost: check the connection, and try again.
app-cancelled = it was given up
    .hint = Nothing has changed.
app-bad-options = the options cannot be read: { $reason }
    .hint = See the list of options and their values.
app-bad-option = { $name } cannot be { $value }
    .hint = It may be { $allowed }.
app-bad-selection = The mesh has no vertex { $number }.
    .hint = Vertices have the numbers of the mesh file, from { $first } on; one that no face uses is none.
app-unknown-loops = `{ $word }` names no boundary loops
    .hint = Use all, inner, or a list of numbers.
app-unknown-field = there is no field `{ $name }`
    .hint = It may be none, { $known }.
app-unknown-format = there is no format `{ $name }`
    .hint = It may be { $known }.
app-unknown-figure = there is no figure `{ $name }`
    .hint = See the list of figures.
app-not-configured = no flow has been chosen yet
    .hint = Configure one before asking for a field.
app-held-positions = edge flips hold the positions, which a regularisation would move
    .hint = Choose another flow, and regularise then.
app-fixed-start = edge flips, and flows side by side, go from the mesh itself
    .hint = Start from here, or change the flow from the start.
app-bad-positions = { $coordinates } coordinates do not fit { $vertices } vertices
    .hint = Load the mesh again.
app-bad-point = { $coordinates ->
    [one] { $coordinates } coordinate is
   *[other] { $coordinates } coordinates are
} given
    .hint = A centre has three.
app-bad-quadrilateral = { $corners ->
    [one] { $corners } corner is
   *[other] { $corners } corners are
} given
    .hint = A quadrilateral has four.
app-no-such-vertex = there are no vertices { $corners }
    .hint = Choose an edge anew.
app-no-such-branch = there is no branch { $branch }
    .hint = Branches are forgotten, the oldest first, when there are many.
app-nothing-to-undo = there is no edit to undo
    .hint = A fill or edge flips can be undone once they are done.
app-no-recipe = how this surface came about is not known: its positions were put in place after the solver was lost
    .hint = Go back to the start with Reset, or load the mesh again.
app-no-study = no study has begun
    .hint = Say what is to be studied.
app-no-bench = no table of measurements has begun
    .hint = Say which.
app-no-step = there is no step to measure: { $reason }
    .hint = Leave the mesh out, or choose other options.
app-too-many-faces = the finer mesh would have { $faces } faces
    .hint = No more than { $most } are made.
app-too-many-vertices = the new mesh would have { $vertices } vertices
    .hint = No more than { $most } are made.
app-centre-too-far = the centre is more than { $most } times the size of the surface away
    .hint = From so far an inversion looks like doing nothing: choose a centre nearer by.
app-centre-too-near = the centre is { $percent } % of the size of the surface away from it, and needs { $least } %
    .hint = A point of the surface at the centre would go to infinity: move the centre off it.

## How a run ended

run-over = { $ended }: { $reason }
run-not-at-rest = The patch is not at rest: { $reason }.
run-folds = Faces folded over in { $folding } of { $steps ->
    [one] { $steps } step
   *[other] { $steps } steps
}.

## What is to be known of a mesh

notice-polygons = The mesh has { $count ->
    [one] { $count } face
   *[other] { $count } faces
} of more than three corners: { $kept ->
    [p-willmore] the p-Willmore flow keeps them, other flows work on a triangulated copy
   *[none] flows work on a triangulated copy
}; files are written with the original faces, after edge flips with triangles.
notice-flat-triangles = The mesh has { $count ->
    [one] { $count } triangle
   *[other] { $count } triangles
} without area (collinear corners), the first being face { FACE($face, bare: 1) } at vertices { VERTEX($vertices) }: a repair takes { $count ->
    [one] it
   *[other] them
} out and closes what that opens.
notice-short-edges = The mesh has { $count ->
    [one] { $count } edge
   *[other] { $count } edges
} shorter than a millionth of the mean, the first between vertices { VERTEX($a, bare: 1) } and { VERTEX($b) }: merge such vertices (merge by distance) for a better flow.
notice-flipped-volume = The volume went from { NUMBER($before, digits: 4) } to { NUMBER($after, digits: 4) }: flips hold the vertices and not the shape, and cut across its edges.
notice-self-intersections = The surface passes through itself in { $count ->
    [one] { $count } pair of triangles
   *[other] { $count } pairs of triangles
}: the flows go on all the same.
notice-filled = Filled { $count ->
    [one] { $count } boundary loop
   *[other] { $count } boundary loops
} with { $vertices ->
    [one] { $vertices } new vertex
   *[other] { $vertices } new vertices
}.

## What is the matter

symptom-rejected-steps = Nothing is wrong: in step { $step } { $count ->
    [one] a longer trial, which would have moved vertex { VERTEX($vertex) } most, was refused
   *[other] { $count } longer trials, the last of which would have moved vertex { VERTEX($vertex) } most, were refused
}, and τ = { $tau } taken, for which the energy falls.
symptom-refused-steps = Every step tried was refused: { $cause ->
    [TooFar] even the last and shortest would move vertex { VERTEX($vertex) } by more than half an edge.
    [Turn] even the last and shortest would turn face { FACE($face) } by more than 60°.
    [Fold] even the last and shortest would fold face { FACE($face) } over.
    [Sliver] even the last and shortest would make a sliver of face { FACE($face) }.
    [Constraints] area and volume cannot both be kept by a small move of this surface, which would move vertex { VERTEX($vertex) } most.
    [Bound] even the last and shortest would have less energy than any smooth surface of this topology, and move vertex { VERTEX($vertex) } most.
    [Unfit] even the last and shortest would leave no surface that can be fitted about vertex { VERTEX($vertex) }.
   *[other] none lowers the energy, not even the last and shortest, which would move vertex { VERTEX($vertex) } most.
}
symptom-cocircular-kink = At { $count ->
    [one] { $count } edge
   *[other] { $count } edges
} the four points of both triangles lie on one circle; there the energy has the tip of a cone, and with angle smoothing ε = { $epsilon } no step descends from it.
symptom-rising-energy = The energy rises, from { $least } to { $energy }: { $halved ->
    [0] this scheme does not test for descent, and steps of τ = { $tau } are too long for it; vertex { VERTEX($vertex) } moved by { $moved } edge lengths in the last one.
   *[other] the matrix of the step is indefinite for steps longer than τ = { $tau }, so that errors are amplified; vertex { VERTEX($vertex) } moved by { $moved } edge lengths in the last step.
}
symptom-pinch = The surface pinches off at vertex { VERTEX($vertex) }: the neck there is { $width } wide, { $edges ->
    [0] too thin for a ring of edges
    [1] too thin for a ring of edges
    [2] too thin for a ring of edges
   *[other] with room for { $edges } edges around
}, and this flow shrinks a neck to nothing in finite time.
symptom-inflating = The surface has swollen to { $times } times its area, as ∫H² does not depend on size, and its mesh is worn out: the smallest angle of face { FACE($face) } is { $angle }°.
symptom-growing = ∫|H|^p falls as the surface grows, for every exponent above 2: with p = { $p } its area is { $times } times that at the start, and it never comes to rest.
symptom-shrinking = ∫|H|^p falls as the surface shrinks, for every exponent below 2: with p = { $p } its area is 1/{ $times } of that at the start, and it vanishes in finite time.
symptom-untrusted = The mesh is too coarse or too crumpled for its readings to mean much, most at vertex { VERTEX($vertex) }. Largest curvature times edge { NUMBER($bend, digits: 2) }, least product of face and vertex normals { NUMBER($alignment, digits: 2) }, ∫K/4π off by { NUMBER($topology, digits: 2) }, ∫H² of fits { NUMBER($energy, digits: 2) } times that of the mesh.
symptom-halved-step = The scheme of the paper takes steps of a set size: step { $step } was halved { $count ->
    [one] once
   *[other] { $count } times
}, to τ = { $tau }, as its matrix was not positive definite. It goes on; the energy may rise.
symptom-degenerate-faces = The mesh degenerates: the smallest angle of face { FACE($face) } is { $angle }°, and at the start no angle was below { $before }°; that limits the steps.
symptom-folded-faces = { $count ->
    [one] Face { FACE($face) } is folded over, against its neighbours: about it normals and curvatures mean nothing, and steps are short or go astray.
   *[other] { $count } faces are folded over, against their neighbours, the first of them face { FACE($face) }: about them normals and curvatures mean nothing, and steps are short or go astray.
}
symptom-below-smooth-minimum = The energy is { $energy }, and no smooth surface of this topology has less than { $smooth }: the mesh is too coarse to notice what bends between its vertices, most of all at vertex { VERTEX($vertex) }.
symptom-flat-faces = { $count ->
    [one] Face { FACE($face) } has
   *[other] { $count } faces, the first of them face { FACE($face) }, have
} no area: nothing can be measured there, and no step leads on.
symptom-unresolved = The mesh does not show its surface: the curvatures of these triangles add up to less energy than every smooth surface of this topology has, as those of needles do.
symptom-large-exponent = With p = { $p } the sharpest points outweigh all others, most of all vertex { VERTEX($vertex) }: even the shortest step tried would go too far.
symptom-too-rough = After { $steps } steps vertices are still to move by up to { $update } edge lengths: the start is too rough for a flow of sixth order; the last step moved vertex { VERTEX($vertex) } most.
symptom-unfit = About vertex { VERTEX($vertex) } the surface has collapsed so far that no quadratic surface fits it, and curvatures by fits are what this flow goes by.
symptom-step-limit = Nothing is wrong: after { $steps ->
    [one] { $steps } step
   *[other] { $steps } steps
} the energy still falls, by { $percent } % in the last one, which moved vertex { VERTEX($vertex) } most.
symptom-not-at-rest = After { $steps ->
    [one] { $steps } step
   *[other] { $steps } steps
} the surface is not at rest; the last one moved vertex { VERTEX($vertex) } most.

## What helps

remedy-more-steps = More steps
remedy-refinement-study = Refinement study
remedy-flip-and-go-on = Flip edges and go on
remedy-back = { $steps ->
    [one] One step back
   *[other] Go { $steps } steps back
}
remedy-regularise-and-go-on = Regularise the mesh and go on
remedy-regularise-and-diffuse = Regularise and use surface diffusion
remedy-repair-and-go-on = Repair the surface and go on
remedy-regularise-each-step = Regularise after each step
remedy-subdivide-and-go-on = Subdivide the mesh and go on
remedy-set-tau = Set τ to { $tau }
remedy-automatic-step = Choose τ automatically
remedy-recommended-scheme = Use the recommended scheme
remedy-set-epsilon = Set ε to { $epsilon }
remedy-first-guess = Begin from a smooth first guess
remedy-keep-volume = Keep the volume
remedy-keep-area = Keep the area
remedy-keep-both = Keep area and volume
remedy-keep-only-volume = Keep only the volume
remedy-smooth-first = Smooth with p = { $p } first
remedy-use-flow = Use the flow “{ $flow }”
