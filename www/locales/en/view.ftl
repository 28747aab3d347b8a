# The labels of the page.

## Top, rail, dialogs

run-them = Run them
leave-it = Leave it

## The status line

status-ready = Ready
status-running = Running
status-running-to = Running to step { $goal }
status-paused = Paused at step { $step }
clause-ready = Press Play or the space bar.
clause-step = step { $step }
clause-film = step { $step } of the half shown backwards, then the film begins
clause-step-of = step { $step } of { $last }
computing = Computing…
stop-now = Stop now
progress = Progress
stage-assemble = Assembling
stage-factor = Factorising
stage-newton = Newton iterations
stage-project = Keeping area and volume
stage-regularise = Evening out the triangles
stage-fill = Filling
stage-triangulate = Triangulating the holes
stage-remesh = Remeshing
stage-flips = Flipping edges
stage-finish = Measuring the surface
stage-repair = Repairing
stage-replay = Following the recipe
stage-sequence = Writing the stored steps
mode-paint = Drag over the surface to let parts of it move, or to hold them.
mode-fill = Click a boundary to choose it.
mode-remesh = Choose how small the triangles are to be.
mode-subdivide = Choose how the new vertices are placed.
mode-invert = Drag the centre of the inversion.
mode-pick = Click a vertex.
mode-edge = Click an edge.

## The dock

transport = Transport
play = Play
pause = Pause
again = Play again
step = Step
back = Back
reset = Reset
history = History
start = start
curve-empty = The energy will be drawn here as it falls
energy-was = { $symbol }, was { $energy }
speed = Speed { $times }×
speed-keys = Speed ([ and ])
loop = Loop
larger-plot = Larger plot
branches = Branches
count-branches = { $count ->
    [one] { $count } branch
   *[other] { $count } branches
}
branch = From step { $from }: { $count ->
    [one] { $count } step
   *[other] { $count } steps
}, energy { $energy }
symbol-smoothedCircle = Willmore energy W
symbol-willmore = ∫H²
symbol-curvatureVariation = ∫|∇H|²
symbol-area = Area
symbol-helfrich = Energy

## The surface in words

surface-named = Surface: { $name }
surface-at = Surface: { $name }, step { $step }, energy { $energy }, area { $area }
surface-pane = Surface { $name }: { $what }
pane-note = step { $step } · { $symbol } { $energy }
pane-step = step { $step }
pane-flips = { $flips ->
    [one] { $flips } flip
   *[other] { $flips } flips
}, area { $area }, W { $circle }

## Surface

sample = Sample
yours = Yours
open-mesh = Open mesh…
mesh-size = { $vertices } vertices · { $faces } faces{ $loops ->
    [0] {""}
    [one] {" · "}{ $loops } boundary
   *[other] {" · "}{ $loops } boundaries
}
found = Found in this mesh
found-broken = Not whole
    .hint = A repair would do this; it can be undone.
found-repaired = Repaired
repair = Repair
repair-and-open = Repair and open
repair-would = A repair would do this:
repaired-all = { $count ->
    [0] There is nothing to repair.
    [one] Repaired: { $count } change.
   *[other] Repaired: { $count } changes.
}
found-holes = { $count ->
    [one] { $count } boundary
   *[other] { $count } boundaries
}
    .hint = { $count ->
        [one] It can be filled.
       *[other] Each can be filled, or two be bridged.
    }
found-closed = Closed
found-two-sided = No boundary, with an inside and an outside.
found-one-sided = No boundary, one-sided.
found-even = Faces are even
found-uneven = Some triangles are slivers
found-angle = Smallest angle { $angle }°
fill-start = Fill…
even-out = Even out triangles
crossings-hint = The flows go on all the same.
change-it = Change it
tool-paint = Paint
tool-fill = Fill holes
tool-remesh = Remesh
tool-subdivide = Subdivide
tool-invert = Invert
tool-pick = Choose a vertex
tool-edge = Choose an edge
start-from-here = Start from here
undo = Undo { $what }
edit-remesh = the remeshing
edit-subdivision = the subdivision
edit-repair = the repair
edit-inversion = the inversion
edit-flips = the edge flips

## Tools

apply = Apply
done = Done
paint-free = Let move
paint-hold = Hold
brush-size = Size
grow = Grow
shrink = Shrink
hold-boundary = Hold boundary
clear-paint = Clear paint
paint-count = { $free } of { $all } move
region-count = { $free } of { $all } vertices move.
loops-chosen = { $count } of { $all } chosen
boundary-loop = { $edges } edges, length { NUMBER($length, digits: 3) }
fill-chosen = { $count ->
    [one] Fill this one
   *[other] Fill these { $count }
}
fill-small = { $count ->
    [one] Fill the small hole
   *[other] Fill { $count } small holes
}
fill-all = { $count ->
    [one] Fill it
   *[other] Fill all { $count }
}
bridge = Bridge
most-vertices = New vertices ≤
remesh-number = Vertices
remesh-edges = Keep edges
    .about = Where faces meet at more than 60°, or flat sides at more than 40°
remesh-adaptive = Remesh by curvature
remesh-isotropic = Remesh evenly
subdivide-loop = Split and smooth (Loop)
subdivide-linear = Split only
inversion-centre = Centre of the inversion
inversion-numbers = W { $before } → { $after }, ∫H² { $bending } → { $bendingNow }
pick-hint = Its numbers stand under Measure.

## Flow

flow-unsuitable = Not for this surface.
automatic = automatic
unit = { $kind ->
    [mean] mean edges
    [steps] steps
    [flips] flips
   *[other] { $unit }
}
applies = Changes apply from
applies-start = Start
applies-here = This step
flip-all = All flips at once
advanced = Advanced
advanced-what = step size, method, limits
step-size-as = as { $other ->
    [tau] τ
   *[dt] dt
}
recommended = Recommended settings

## Colours and drawing

legend = Legend
look = Look
colour-by = Colour by
colour-none = Nothing
colour-mean-curvature = Mean curvature H
colour-gauss-curvature = Gaussian curvature K
colour-willmore = Willmore energy Wᵢ
colour-gradient = Gradient size
colour-displacement = Displacement
colour-distance = Distance between panes
colours-from-to = Colours: { $what }, from { $low } to { $high }
round = round
range-held = Scale held for the whole run
fit-range = Fit to this step
wireframe = Wireframe
wireframe-dense = Zoom in to see edges.
boundary-lines = Boundary
cut = Cut open
double-curves = Curves where it crosses itself
shading = Shading
shading-smooth = Smooth
shading-flat = Flat
high-contrast = High contrast
theme = Theme
theme-auto = System
theme-light = Light
theme-dark = Dark
language = Language / Sprache
fit-view = Fit the view

## Measure

readings = Readings
reading-energy = Energy
reading-step = Step
reading-time = Time
reading-dt = Step size
reading-area = Area
reading-volume = Volume
reading-genus = Genus
reading-vertices = Vertices
reading-faces = Faces
reading-crossings = Pairs of triangles that cross
reading-angle = Smallest angle
reading-milliseconds = Milliseconds per step
reading-tension = Tension λ
reading-pressure = Pressure μ
reading-jump = Jump of H where the patch ends
genus-none = not orientable
volume-none = none enclosed
volume-reduced = { $volume } (reduced { NUMBER($reduced, digits: 4) })
what-w-says = W is summed from the angles between circumcircles, and 0 only where all vertices lie on one sphere. W/2 is comparable with ∫(H² − K) dA.
over-the-surface = { $what } over the surface
histogram-table = Histogram as a table
histogram-from = From
histogram-share = Share
figure-expects = Expected here:
figure-holds = ✓ As expected:
figure-differs = Otherwise than expected:
all-steps = Table of all steps
look-at-vertex = Look at one vertex
equation = The equation, symbol by symbol
study = Refinement study
conjecture = The conjecture on this mesh
lab = Random quadrilaterals

## The larger plot

quantity = Quantity
quantity-energy = Energy
quantity-monitored = What never rises
quantity-area = Area
quantity-volume = Volume
quantity-angle = Smallest angle
quantity-dt = Step size
against = Against
against-step = Step
against-time = Time
scale = Axis
scale-auto = Automatic
scale-log = Logarithmic
scale-linear = Linear
plot-label = { $what } over the run

## Compare

compare-hint = Same start, camera and colours. What differs:
contrast-flow = Flow
contrast-p = Exponent p
contrast-regularise = Mesh care
contrast-scheme = Scheme
contrast-then = Then and now
pane-flow = Flow of { $name }
add-pane = Add { $name }
remove-pane = Remove { $name }
lockstep = In step by
lockstep-progress = Progress
lockstep-time = Time
lockstep-step = Step
axis-progress = end of each flow
axis-time = time
axis-step = steps
times-differ = Their times cannot be compared: the flows measure time in different units.
show-panes = Show
show-panes-side = Side by side
show-panes-place = In place
in-place-hint = In place, one after the other:
pane-colours = Colours
distance-to = Distance to { $name }
close-comparison = Close the comparison
nothing-to-flip = There is no pane to flip to yet: choose what differs under Compare.
pane-lost = A pane beside cannot go on: { $reason }
    .hint = Change it or remove it under Compare; the others go on.

## Share

share-hint = A link carries the whole scene: surface, flow, step, camera and colours.
copy-link = Copy link
link-copied = Link copied.
not-copied = The browser does not let the page copy. Here it is:
save-as = Save as
download = Download
film = Film
film-record = Record film
film-stop = Stop and save
film-unable = This browser cannot record films.
film-hint = What is on the stage is recorded, as it is played.
film-failed = The browser stopped recording.
    .hint = What was recorded until then is saved.
save-all-steps = All steps as a ZIP
each-step-as = Each step as
every = Every so manyth
save-steps = Save the steps
sequence-size = { $meshes ->
    [one] { $meshes } mesh
   *[other] { $meshes } meshes
}, about { NUMBER($megabytes, digits: 3) } MB before compression; 1 GB at most.
embed = In another page
embed-as = Embed as
embed-iframe = Frame (iframe)
embed-element = Element with a script
embed-size = Size
copy-code = Copy the code
code-copied = Code copied.
lack-editsTooLong = The edits are too large for a link: send the mesh along, saved with Download, or a recipe.
lack-editsUnknown = The surface was edited by hand, which the link does not carry: send the mesh along, saved with Download.
lack-file = The link does not hold your mesh: send the file too.
lack-fileByDigest = The link does not hold your mesh: send the file too. It is recognised by its SHA-256.
lack-regionTooLong = The painted region is too large for a link and is not in it.
lack-pathTooLong = What was changed on the way is too large for a link: send a recipe, saved with Download.
save-as-ply = PLY
save-as-ply-ascii = PLY, text
save-as-ply-big = PLY, big-endian
save-as-obj = OBJ
save-as-off = OFF
save-as-stl = STL
save-as-stl-ascii = STL, text
save-as-glb = glTF (GLB)
save-as-csv = History, CSV
save-as-recipe = Recipe, JSON
save-as-png = Picture, PNG

## Library

search = Search
search-hint = Search, for example “knot” or “fig 6”
shelves = Shelves
open-now = Open now
library-size = { $vertices } vertices
library-none = Nothing is called so or speaks of it. Clear the search to see everything.
library-count = { $count ->
    [one] { $count } surface or figure
   *[other] { $count } surfaces and figures
}
shelf-all = All
shelf-first = Start here
    .about = Four that show what a flow does
shelf-closed = Closed surfaces
    .about = Nothing is held
shelf-tubes = Tubes and knots
    .about = Long ways to go
shelf-boundary = With a boundary
    .about = What the boundary does decides the rest
shelf-repair = Repair
    .about = Scans, scars and holes
shelf-flips = Edge flips
    .about = No vertex moves
shelf-papers = From the papers
    .about = Each figure, with what the paper says and what comes of it here

## Help

help-what = Umbilic lets triangle meshes flow so that they bend less, along the equations of four papers. It computes in this browser.
help-how = Choose a surface in the Library or open your own, press Play, and drag over the curve below to look at any moment. Flow changes the equation, Measure shows its numbers, Compare sets two side by side.
help-private = Nothing you open leaves this device. After the first visit the page works without a connection.
keys = Keys
keys-on = Single keys
keys-turn = turn the surface that has the focus
keys-clicker = next and previous, while presenting
surface-gestures = On the surface
gestures = Drag turns it, with Shift or two fingers it moves, the wheel or a pinch zooms, a double click fits it.
purpose = What is this mesh for?
purpose-smooth = Smooth a little
purpose-relax = Relax fully
purpose-fill = Only fill holes
guide = The guide:
guide-first-look = a first look
guide-lecture = for the lecture
guide-mesh = a mesh of your own
welcome-again = Show the welcome again
version = Version { $version }.
commands = Commands
commands-hint = What do you want to do?
key-space = Space
key-home = Home
key-end = End
key-ctrl-z = Ctrl Z
key-ctrl-k = Ctrl K

## Commands

command-play = Play or pause
command-step = One step on
command-back = One step back
command-reset = Back to the start, forgetting the steps
command-start = To the start
command-end = To the latest step
command-slower = Slower
command-faster = Faster
command-loop = Loop
command-plot = Larger plot
command-library = Open the library
command-open = Open a mesh…
command-surface = Surface
command-flow = Flow
command-measure = Measure
command-compare = Compare
command-share = Share
command-colour = Next colours
command-wireframe = Wireframe
command-fit = Fit the view
command-flip-panes = Swap the panes
command-present = Present
command-undo = Undo the last edit
command-commands = List of commands
command-help = Help
command-paint = Paint what moves
command-fill = Fill holes
command-remesh = Remesh
command-subdivide = Subdivide
command-invert = Invert in a sphere
command-repair = Repair
command-regularise = Even out triangles
command-adopt = Start from here
command-download = Download the mesh
command-picture = Save a picture
command-boundary-lines = Show the boundary
command-contrast = High contrast

## What has happened

flips-adopted = The flow starts from the mesh with its edges flipped. Undo brings the one before back.
regular-already = { $pinned ->
    [0] The triangles are as even as they get.
   *[other] The triangles are as even as they get while vertices on creases stay, { $pinned } of them; a finer mesh has more to move.
}
remeshed = { $vertices } vertices, smallest angle { $angle }° before and { $angleNow }° now. Undo takes it back.
subdivided = Subdivided into { $count } triangles. Undo takes it back.
inverted = The surface is inverted, and W has changed by { NUMBER($change, digits: 2) }. Undo brings the one before back.
offer-fixed = Use a fixed boundary
offer-free = Free what the flow frees
new-version = A new version is ready. Reload the page to use it.
no-picture = There is no picture to save.
    .hint = Save the mesh.
solver-crashed = The solver crashed ({ $reason }). A new one goes on from step { $step }.
    .hint = If it was short of memory, close other tabs or use a mesh with fewer faces.
solver-ended = The computation was ended. The surface is as after step { $step }.
    .hint = Play goes on from there.

## Links and recipes

link-is-long = This link runs about { $steps } steps.
link-wants-file = This link shows the mesh “{ $mesh }”, a file on its author’s computer.
    .hint = Open that file here; the scene then follows.
link-other-file = “{ $name }” is not the file of the link, which shows “{ $mesh }”; it is opened all the same.
link-checked = { $outcome ->
    [same] The scene is as it was sent: energy { NUMBER($energy, digits: 6) }.
    [near] The scene is as it was sent to six digits: energy { NUMBER($energy, digits: 6) }.
    [endsEarly] The link shows step { $wanted }; here the flow ends at step { $step }.
   *[off] The scene is not as it was sent: the energy is { NUMBER($energy, digits: 6) } at step { $step }, where the link says { NUMBER($sent, digits: 6) }.
}
link-differs = { $why ->
    [file] The mesh is not the file of the link.
    [version] The link was made by version { $theirs } of the solver; this is version { $ours }.
    [unknown] Perhaps the file is not the one the link was made with.
   *[same] The same version should give the same numbers; please report this, with the link.
}
recipe-is-long = This recipe runs about { $steps } steps.
recipe-wants-mesh = This recipe is for the mesh “{ $name }”. Open that file now; the recipe follows.
recipe-other-mesh = This is not the mesh “{ $name }” of the recipe: its contents differ.
recipe-compared = { $same ->
    [true] The recipe gives the energy that it promised, to the last bit.
   *[false] The recipe promised the energy { NUMBER($expected, digits: 9) }; here it is { NUMBER($got, digits: 9) }.
}

## What an embedding page is answered

embed-bad-value = “{ $word }” cannot be “{ $text }”.
    .hint = Copy a link from the page to see how its words are written.
embed-bad-step = A step is a whole number from 0 on, not “{ $step }”.
embed-no-format = There is no format “{ $format }”.
embed-no-request = There is no request “{ $type }”.
embed-known = Known are { $known }.
embed-bad-mesh = A mesh is sent as `name`, with its extension, and `bytes`, an ArrayBuffer.

## One vertex

vertex-number = Number
vertex-leave = None
vertex-missing = There is no vertex { VERTEX($vertex) }.
vertex-numbers = Vertex { VERTEX($vertex) }
vertex-position = Position
vertex-valence = Valence
vertex-outside = not part of the energy
vertex-defect = Kᵢ, angle defect
vertex-mean = H, pointwise
vertex-gauss = K, pointwise
vertex-principal = κ₁, κ₂ by a fit
vertex-area = Area, a third
vertex-radii = Circumradii
vertex-edges = Its edges
vertex-to = To
vertex-length = Length
vertex-none = none
vertex-go = Go to vertex { VERTEX($neighbour) }
vertex-boundary = { $counts ->
    [true] A boundary vertex: at its boundary edges stands β₂, against the line through a vertex at infinity.
   *[false] A boundary vertex: its { $count } boundary edges have one circle only and no β, and Wᵢ is no part of the energy under this boundary condition.
}
circles = Circumcircles
circles-drawn = { $some ->
    [true] { $drawn } circles of { $total } triangles, of more only a part.
   *[false] { $drawn } circles of { $total } triangles.
} { $leftOut ->
    [0] {""}
   *[other] { $leftOut } larger than the surface are left out.
}
directions = Lines of curvature
directions-drawn = { $drawn } of { $total } vertices, { $leftOut } at umbilics have none. { $share } % of the edges lie within 5° of a line of curvature; 11 % do by chance.
