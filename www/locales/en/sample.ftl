# Samples: their names.

## Samples

sample-icosahedron = Subdivided icosahedron
sample-bumpy-sphere = Bumpy sphere
sample-coarse-torus = Subdivided coarse torus
sample-clifford-torus = Clifford torus
sample-pipe = Pipe with clamped ends
sample-six-sided-hole = Six-sided hole
sample-scar = Scar on a stone
sample-noisy-scan = Noisy scan
sample-trefoil = Trefoil knot
sample-vesicle = Vesicle, deflated
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
