# Samples: their names, and what to look for.

## Samples, and what to look for

sample-icosahedron = Subdivided icosahedron
    .shows = Becomes a round sphere; W starts at exactly 60π and falls to zero (figure 6).
sample-bumpy-sphere = Bumpy sphere
    .shows = Bumps melt, short ones first, until the sphere is round and W is zero.
sample-coarse-torus = Subdivided coarse torus
    .shows = Rounds off, then its proportions creep towards R/r = √2 (figure 8).
sample-clifford-torus = Clifford torus
    .shows = The minimum among tori: W/2 is near 2π², and the flow hardly moves it.
sample-pipe = Pipe with clamped ends
    .shows = Both ends keep their position and tangent; the bend between them relaxes (figure 9).
sample-six-sided-hole = Six-sided hole
    .shows = Fills a hexagonal hole smoothly, from a harmonic first guess (figure 10).
sample-scar = Scar on a stone
    .shows = Only the damaged patch moves, and closes without a seam (figure 11).
sample-noisy-scan = Noisy scan
    .shows = Ten steps take away the noise and leave the shape (figure 12).
sample-trefoil = Trefoil knot
    .shows = A knotted tube fattens; it cannot untie itself.
sample-vesicle = Vesicle, deflated
    .shows = Area kept, the volume is led down to 0.6 of the ball’s: a biconcave disc, as a red blood cell (p-Willmore, figure 6).
sample-blob = Blob, deflated
    .shows = Without any symmetry at the start it ends as a biconcave disc too, an elliptical one (p-Willmore, figure 6).
sample-spheroid = Spheroid of axes 2, 1, 1
    .shows = Becomes round while its volume stays: the area falls, and 36πV²/A³ rises to 1.
sample-letter-c = Letter C
    .shows = Rounds off to a sphere with p = 2; shrinks with p = 0, grows with p = 4 (p-Willmore, figure 2).
sample-thin-torus = Thin torus
    .shows = Thickens into the Clifford torus: ∫H² falls to 2π² (p-Willmore, figure 4).
sample-torus-knot = Torus knot
    .shows = Area and volume kept; without regularisation the mesh degenerates (p-Willmore, figure 5).
sample-bad-mesh = Ellipsoid, badly meshed
    .shows = Triangles have turned over; “Regularise the mesh now” mends them without changing the shape (p-Willmore, figures 3, 7 and 11).
sample-trefoil-kept = Trefoil, area and volume kept
    .shows = A thick knotted tube comes to rest on a plateau of ∫H² (p-Willmore, figure 9).
sample-bumps-kept = Bumpy sphere, area kept
    .shows = Rounds off without growing or shrinking (p-Willmore, figure 1).
sample-ellipsoid-p = Ellipsoid, volume kept, p = 4
    .shows = A sphere in the end, on another way for every exponent p (p-Willmore, figure 12).
sample-cylinder-gaps = Cylinder with four gaps
    .shows = Sunken patches rise back to the cylinder: its mean curvature is constant (variation of curvature, figure 5.1).
sample-sphere-openings = Sphere with eight openings
    .shows = Eight flat lids become the sphere they were cut from (variation of curvature, figure 5.1).
sample-two-tubes = Two tubes blended
    .shows = A patch that connects both becomes the cylinder between them (variation of curvature, figure 5.2).
sample-three-tubes = Three tubes blended
    .shows = The blend joins its tubes with continuous curvature; compare all four flows (variation of curvature, figure 5.2).
sample-six-tubes = Six tubes blended
    .shows = Along all three axes (variation of curvature, figure 5.2).
sample-holed-scan = Scan with holes filled
    .shows = What the scanner did not see is filled and faired (variation of curvature, figure 5.3).
sample-holed-sphere = Sphere with holes filled
    .shows = Holes are triangulated, remeshed, pre-filled and faired: the sphere again (variation of curvature, figure 5.3).
sample-dodecahedron = Dodecahedron, corners kept
    .shows = Twenty points are interpolated: the sphere through them (variation of curvature, figure 5.4).
sample-four-bumps = Four bumps, flows compared
    .shows = Only the sixth-order flow joins with continuous mean curvature: look at the jump (variation of curvature, figures 5.5 and 5.6; its function as repaired, exp(−27/16 …)).
sample-sampled-torus = Sampled torus
    .shows = Each cell is cut along either diagonal; flips tidy that up. Here the three criteria end at the same mesh (edge flips, figure 6).
sample-uneven-torus = Sampled torus, uneven
    .shows = Here area and localised energy lead to one mesh, the Willmore energy to another.
sample-creased-face = Face with creases
    .shows = Long vertical edges make creases; flips smooth most of them out (edge flips, figure 7).
sample-eared-head = Head with ears
    .shows = By area or localised energy W ends lower than by itself, and the ears lose volume (edge flips, figure 8).
sample-counterexample = Counterexample
    .shows = Flipping this edge raises the area and lowers the localised energy: f_a = 15/2 − 2√2 − √89/2 = −0.0454, f_l = +0.0068.
sample-moebius = Möbius strip
    .shows = One side and one edge; the energy needs no orientation.
sample-klein-bottle = Klein bottle
    .shows = Closed and one-sided: it has no volume, but it has an energy.
sample-saddle = Saddle, boundary free
    .shows = Set free it becomes a flat, convex piece of the plane; with its boundary fixed it stays a saddle (figure 7).
sample-genus-4 = Surface with four handles
    .shows = Its handles round off; ∫H² tends below 8π (p-Willmore, figure 8).
sample-morin = Morin’s surface, pushed
    .shows = Half of a sphere turned inside out: from 16π through itself to a round sphere (Kusner).
sample-morin-fine = Morin’s surface, pushed, 5,000 vertices
    .shows = The same half of an eversion on a finer mesh.
sample-boy = Boy’s surface
    .shows = A projective plane, one-sided, and the least bent of all that there are in space: ∫H² = 12π (Bryant, Kusner).
sample-cyclide = Cyclide of Dupin
    .shows = A Möbius image of the Clifford torus, with the same energy: W/2 is near 2π².
sample-inverted-catenoid = Inverted catenoid
    .shows = Two sheets that touch in a point: ∫H² = 8π, as of every inverted minimal surface with two ends.
sample-rough-mesh = Ellipsoid, skewed triangles
    .shows = One pass of “Regularise the mesh now” is enough here (p-Willmore, figure 7).
sample-range-scan = Noisy scan, 38,000 vertices
    .shows = As large as the paper’s, with as many holes; a hundred steps begin to take the features too (figure 12).

## Shelves of samples

group-closed = Closed surfaces
group-tubes = Tubes and knots
group-boundary = With a boundary
group-repair = Repair
group-flips = Edge flips
