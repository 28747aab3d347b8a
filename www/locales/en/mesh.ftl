# Meshes, shapes, linear systems, fills and regularisation: src/mesh, src/linalg, src/remesh.

## What is no surface

mesh-vertex-out-of-range = face { $face } uses vertex { $vertex }, but there are only { $vertices } vertices
    .hint = The file is damaged or was cut off: export it again from the program it came from.
mesh-non-finite-vertex = vertex { $vertex } has a coordinate that is not a finite number
    .hint = Remove the vertex, or give it a position, in a mesh editor.
mesh-non-manifold-edge = the edge between vertices { $a } and { $b } has { COUNT($faces) } faces ({ LIST($faces, most: 6) }){ $others ->
    [0] {""}
    [one] ; one other edge is like it
   *[other] ; { $others } other edges are like it
}{ $first ->
    [1] {" "}(counted from 1, as in the file)
   *[other] {""}
}
    .hint = A surface has at most two faces at an edge. A repair drops small sheets that hang on such an edge, and cuts others loose.
mesh-no-faces = there is no face with three different corners and an area
    .hint = Check that the file holds a surface and not only points or lines.
mesh-too-large = { $count } face corners are more than 32-bit indices can name
    .hint = Simplify the mesh first; about a million faces are practical.

## What was repaired

repair-degenerate-faces = Dropped { $count ->
    [one] { $count } degenerate face (a corner repeated)
   *[other] { $count } degenerate faces (a corner repeated)
}, the first being face { $face }{ $first ->
    [1] {""} (counted from 1, as in the file)
   *[other] {""}
}.
repair-bridged-faces = Cut { $count ->
    [one] { $count } face that passes a vertex twice
   *[other] { $count } faces that pass a vertex twice
}, as around a hole, into triangles.
repair-spiked-faces = Cut off where { $count ->
    [one] { $count } face runs
   *[other] { $count } faces run
} out to a vertex and back.
repair-duplicate-faces = Dropped { $count ->
    [one] { $count } face
   *[other] { $count } faces
} on the same vertices as an earlier face.
repair-split-vertices = Split { $count ->
    [one] { $count } non-manifold vertex
   *[other] { $count } non-manifold vertices
}, where several sheets touch in a point, into one vertex a sheet ({ LIST($vertices, most: 5) }{ $first ->
    [1] {"; "}counted from 1, as in the file
   *[other] {""}
}).
repair-flat-pieces = Dropped { $count ->
    [one] { $count } face
   *[other] { $count } faces
} in pieces without any area.
repair-unused-vertices = Dropped { $count ->
    [one] { $count } vertex
   *[other] { $count } vertices
} that no face uses.
repair-one-sided = { $count ->
    [one] { $count } component
   *[other] { $count } components
} without a consistent orientation (like a Möbius strip); flows that need no normal still work.
repair-turned-faces = Turned { $count ->
    [one] { $count } face
   *[other] { $count } faces
} to agree with the neighbours.
repair-inside-out = The surface was inside out (negative volume): all faces were turned.
repair-turned-parts = Turned { $count ->
    [one] { $count } closed part that was
   *[other] { $count } closed parts that were
} inside out.

repaired-uncrossed = Put the corners of { $count ->
    [one] { $count } quadrilateral whose sides crossed
   *[other] { $count } quadrilaterals whose sides crossed
} in order.
repaired-doubled-faces = Dropped { $count ->
    [one] { $count } face that lies
   *[other] { $count } faces that lie
} exactly on an earlier sheet.
repaired-welded = Welded { $count ->
    [one] { $count } boundary vertex
   *[other] { $count } boundary vertices
} to { $count ->
    [one] another
   *[other] others
} at the same place, where that closes the surface.
repaired-collapsed-edges = Collapsed { $count ->
    [one] { $count } edge
   *[other] { $count } edges
} without length, and the faces at { $count ->
    [one] it
   *[other] them
}.
repaired-flat-faces = Dropped { $count ->
    [one] { $count } triangle
   *[other] { $count } triangles
} without area, and closed what that opened.
repaired-inserted = Inserted { $count ->
    [one] { $count } vertex
   *[other] { $count } vertices
} into the edge on which { $count ->
    [one] it lies (a T-junction)
   *[other] each lies (T-junctions)
}.
repaired-fins = Dropped { $count ->
    [one] { $count } face
   *[other] { $count } faces
} of small sheets that hang on an edge of two other faces.
repaired-cut-edges = Cut { $count ->
    [one] { $count } edge of more than two faces
   *[other] { $count } edges of more than two faces
}, so that each sheet has its own.
repaired-doubled-edges = Doubled { $count ->
    [one] { $count } edge of more than two faces that no cut takes apart: the sheets that meet there have
   *[other] { $count } edges of more than two faces that no cut takes apart: the sheets that meet there have
} a vertex of their own in its middle.
repaired-walls = Dropped { $count ->
    [one] { $count } face of a wall inside, which
   *[other] { $count } faces of walls inside, which
} the surface around closes without.

## Subdivision

subdivision-not-a-triangle = face { FACE($face) } has { $degree } corners; subdivision needs triangles
    .hint = Triangulate the mesh first.
subdivision-non-manifold-edge = edge { VERTEX($a, bare: 1) }-{ VERTEX($b) } has more than two faces
    .hint = Split the surface along this edge first.

## Sample shapes

shape-unknown-shape = there is no shape `{ $name }`
    .hint = The shapes are { $known }.
shape-unknown-parameter = shape `{ $shape }` has no parameter `{ $name }`
    .hint = { COUNT($known) ->
        [0] `{ $shape }` takes no parameters.
       *[other] `{ $shape }` takes { $known }.
    }
shape-out-of-range = `{ $parameter }` of shape `{ $shape }` is { NUMBER($value, digits: 17) }, outside { NUMBER($low, digits: 17) } to { NUMBER($high, digits: 17) }
    .hint = Use a value from { NUMBER($low, digits: 17) } to { NUMBER($high, digits: 17) }.
shape-not-an-integer = `{ $parameter }` of shape `{ $shape }` is { NUMBER($value, digits: 17) }, not a whole number
    .hint = Use { $nearest }.
shape-incompatible = shape `{ $shape }` cannot be made: { $reason }
    .hint = Change one of the values named.
conflict-thick-tube = minor = { NUMBER($minor, digits: 17) } is not below major = { NUMBER($major, digits: 17) }
conflict-shear = shear × rows = { NUMBER($turn, digits: 17) } is not a whole number
conflict-odd = { $parameter } = { $value } is odd
conflict-too-coarse = level { $level } is too coarse for holes of radius { NUMBER($radius, digits: 17) }
conflict-holes-overlap = { $count } holes of radius { NUMBER($radius, digits: 17) } do not fit; at this level it must be below { $most }
conflict-tubes-meet = { $count } tubes of radius { NUMBER($radius, digits: 17) } meet; it must be below { $most }
conflict-patches-too-long = patches of radius { NUMBER($radius, digits: 17) } do not fit the length
conflict-no-room = resolution { $resolution } has no room for { $count } holes
conflict-subdivision = { $reason }

## Linear systems

linear-zero-pivot = the matrix is singular: the pivot of row { $row } is zero
    .hint = Take a smaller step.
linear-non-finite-entry = the matrix has an entry that is not finite in column { $column }
    .hint = A triangle may have collapsed: take a smaller step or repair the mesh.
linear-non-finite-right-hand-side = the right-hand side is not finite at vertex { $row }
    .hint = A triangle may have collapsed: take a smaller step or repair the mesh.
linear-out-of-memory = the factor of a matrix of { $n } rows does not fit into memory
    .hint = Use a coarser mesh.
linear-index-overflow = the factor of a matrix of { $n } rows has too many entries to be indexed
    .hint = Use a coarser mesh.
linear-interrupted = the work was given up
    .hint = Ask for it again.

## Fills

fill-no-loops = the mesh has no boundary loop
    .hint = There is nothing to fill.
fill-loop-out-of-range = there is no boundary loop { $index }; the mesh has { $loops }, counted from 0
    .hint = Ask for all loops, or for one of those there are.
fill-touching-loop = boundary loop { $index } touches itself: vertices { VERTEX($a, bare: 1) } and { VERTEX($b) } lie in the same place
    .hint = A repair stitches boundaries that lie on each other.
fill-straight-loop = all of boundary loop { $index } lies on one line, and has no inside
    .hint = A repair closes such a gap, as a vertex in the middle of an edge leaves it.
fill-no-small-loops = { $loops ->
    [one] the boundary loop is
   *[other] the { $loops } boundary loops are
} no small hole: the outer rim of a sheet and the mouth of a tube are left open unless chosen
    .hint = Ask for all loops, or for some by their numbers: `umbilic info` lists them, and Fill holes shows them.
fill-no-room = there is no room for a patch at boundary loop { $index }: it would fall onto faces that are there
    .hint = Leave the loop open, or delete the faces around it.
fill-not-orientable = the surface has no consistent orientation
    .hint = A one-sided surface cannot be filled.
fill-too-few-loops = { $loops ->
    [one] { $loops } boundary loop
   *[other] { $loops } boundary loops
} cannot be connected
    .hint = Name two loops or more, or fill them one by one.
fill-hidden-loop = boundary loop { $index } does not lie on the convex hull of the loops to be connected, at vertex { VERTEX($vertex) }
    .hint = Move the parts apart or leave the loop out; loops that are round and face each other can be connected.
fill-loops-too-close = vertices { VERTEX($a, bare: 1) } and { VERTEX($b) } of two loops are joined by an edge already
    .hint = Fill the loops one by one.
fill-cancelled = filling was cancelled
    .hint = Start again whenever you like.
fill-mesh = the filled mesh is not a surface: { $reason }
fill-linear = the linear system could not be solved: { $reason }
fill-notice-left-open = Left open: { $reason }.
fill-notice-large-hole = The hole at { COUNT($loops) ->
    [one] loop { $loops }
   *[other] loops { $loops }
} is larger than a hemisphere: closing it smoothly takes { NUMBER($hemispheres, digits: 2) } times as much curvature, and its shape is a guess.
fill-notice-low-order = The patch at { COUNT($loops) ->
    [one] loop { $loops }
   *[other] loops { $loops }
} { $order ->
    [2] meets the surface around it with its tangent planes but not its curvature
    [1] meets the surface around it with a kink
   *[other] stays a membrane
}, as { $cause ->
    [near-boundary] there are fewer than three rings of surface around it
    [size] it has { $vertices } new vertices
    [folds] a smoother one would fold over
    [side] its rim is flat and edges of the shape end there: a side is missing
   *[rough] the surface around it is too rough to be continued
}.
fill-notice-coarser = The loops' edge lengths ask for about { $vertices } new vertices, more than the limit of { $most }: the patches' edges are { NUMBER($times, digits: 2) } times as long.

## Regularisation

regularise-only-creases = all { $vertices } vertices lie on creases, which a regularisation keeps
    .hint = Refine the mesh first: new vertices inside its faces are free to slide.
regularise-distance-bound = any pass would move the surface by more than { $percent } % of its size
    .hint = Refine the mesh first: new vertices inside its faces are free to slide.
regularise-volume-bound = any pass would change the volume by more than { $percent } %
    .hint = Refine the mesh first: new vertices inside its faces are free to slide.
regularise-box-bound = any pass would change the bounding box by more than { $percent } %
    .hint = Refine the mesh first: new vertices inside its faces are free to slide.
regularise-angle-bound = any pass would make the smallest angle smaller, and smaller than { $degrees }°
    .hint = Refine the mesh first: new vertices inside its faces are free to slide.
regularise-linear = the linear system could not be solved: { $reason }

## Remeshing

remesh-not-triangular = remeshing needs triangles
    .hint = Write the mesh as triangles first.
remesh-not-oriented = a one-sided surface is not remeshed
    .hint = Remesh its double cover instead.
remesh-all-held = nothing may be changed: all vertices are held or lie on the boundary
    .hint = Free some vertices, or subdivide the mesh first.
remesh-spoilt = the surface would have become another: it is too coarse, too thin or too crumpled to be remeshed
    .hint = Ask for more vertices, or subdivide or smooth it first: what is thinner than its triangles are long is not kept.
