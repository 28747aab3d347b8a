# Labels of the drawer that the first picture does not need.

## The equation

equation-energy = Energy
equation-flow = Equation
symbols = Symbols, as they are now
symbols-beta = angle between the circumcircles of the triangles at edge ij
symbols-epsilon = rounds off the cone of an angle at 0
symbols-p = exponent
symbols-mean = mean curvature, (κ₁ + κ₂)/2, positive on a sphere
symbols-gauss = Gaussian curvature
symbols-normal = outward normal
symbols-spontaneous = spontaneous curvature, without a unit
symbols-tension = tension that keeps the area
symbols-pressure = pressure that keeps or leads the volume
symbols-mass = mass of a vertex
symbols-matrix = second variation of the circle energy, made semi-definite star by star
symbols-dt = step size
symbols-tau = step size without a unit
symbols-edge = mean edge length at the start
symbols-size = √(A/4π) at the start
symbols-localised = localised energies before and after the flip

## Refinement study

study-of = Of
study-sample = The sample, at its start
study-surface = The surface as it is now
study-run = Measure
study-cancel = Cancel
study-crashed = The study stopped unexpectedly ({ $reason }).
study-preparing = Preparing the surface…
study-measuring = Measuring resolution { $level }…
study-order = order { $order }
study-smooth = Smooth
study-refined-by = { $refinedBy ->
    [sampled] The smooth shape, sampled anew at each resolution; { $most } vertices at most.
    [polyhedron] The polyhedron, its faces split into four each time; { $most } vertices at most.
   *[loop] The limit surface of Loop’s scheme with this mesh as its control mesh, which lies a little inside; { $most } vertices at most.
}
trend-name = { $quantity ->
    [area] The area
    [circle] W/2
    [cotangent] ∫H² by cotangents
    [fitted] ∫H² by quadratic fits
   *[power] ∫|H|^{ $p }
}
trend-symbol = { $quantity ->
    [area] A
    [circle] W/2
    [cotangent] ∫H² cot
    [fitted] ∫H² fit
   *[power] ∫|H|^p
}
trend = { $tendency ->
    [exact] { $name } is right at every resolution, up to rounding.
    [converges] { $name } tends to the smooth value { NUMBER($smooth, digits: 5) }; observed order { NUMBER($order, digits: 2) }.
    [nears] { $name } tends to ∫(H²−K) dA, { NUMBER($smooth, digits: 5) } by quadratic fits on the finest mesh.
    [settles] { $name } settles; observed order { NUMBER($order, digits: 2) }.
    [elsewhere] { $name } does not tend to the smooth value { NUMBER($smooth, digits: 5) }, but to about { $ratio } times it.
    [elsewhereThanZero] { $name } settles, but not at the smooth value { NUMBER($smooth, digits: 5) }.
    [diverges] { $name } does not settle: each refinement changes it as much as the one before.
   *[unknown] Of { $name } two resolutions tell no more.
}
study-polyhedron = The curvature of a polyhedron sits in its edges: split faces resolve them ever more sharply, and every Willmore energy grows like 1/h.
study-lattice = The circle-angle energy tends to the smooth one only where the edges follow the lines of curvature in a right-angled lattice. On other lattices its limit is larger, and where triangles are not Delaunay it has none (Bobenko and Schröder 2005, section 2). Compare it between steps, not between meshes.
study-minimisers = That values converge on given meshes does not make minimisers converge: minimising any piecewise-linear Willmore energy proposed so far fails to converge to a solution of the smooth problem (Chen, Yu, Brogan, Kusner, Yang and Zigerelli, arXiv 1901.09990).

## The conjecture

conjecture-holds = { $against ->
    [0] On this mesh it holds for all { $total } edges: area and localised energy rise or fall together.
   *[other] On this mesh area and localised energy rise or fall together at { $percent } % of { $total } edges, and not at { $against }.
}
conjecture-plot = What a flip of each edge gains: area to the right, localised energy upwards
both-fall = Both fall
neither-falls = Neither falls
only-area = Only the area falls
only-localised = Only the localised energy falls
counterexamples = Counterexamples
counterexample = Edge { $i }–{ $j }: f_a { $area }, f_l { $localised }
quad = Quadrilateral
quad-gained = { $gained } of { $area }
quad-fold = Angle between the faces
lab-run = Draw quadrilaterals
lab-stop = Stop
lab-found = { $total } random tetrahedra, { $against } against: { $areaOnly } lower only the area, { $localisedOnly } only the localised energy.
lab-total = Drawn
lab-against = Against

## A gap, and how elements are numbered

found-gap = A gap
    .hint = Two rims run side by side, closer than half an edge. Welding within this length joins them; it can be undone.
weld-length = Length
weld = Weld
counted-from = counted from { $first }

# Why it stands where it does.
why-heading = Why did it stop?
why-show = Show it
nothing-wrong = Nothing is wrong. It was paused, and Play goes on from here.
what-measures = What the energy measures
why-ended = { $ended }: { $reason }.
next = Next: { $name }
