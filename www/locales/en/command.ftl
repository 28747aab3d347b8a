# What the command line alone says: options of its commands, and tables of measurements.

## Boundary loops, as `umbilic info` lists them

loop-line = loop { $number }: { $edges } edges, length { $length }, at vertex { $vertex }{ $small ->
    [true] {""}
   *[other] ; no small hole
}
loop-more = … and { $count } more: --json lists all

## Options of other commands

energy-p-help = further exponents of ∫|H|^p dA, beside 0 to 4
energy-boundary-help = of open meshes: which terms count and which vertices move

regularise-mode-help = nonlinear keeps the volume better
regularise-epsilon-help = 1e-3 is faithful, 1e-1 aggressive
regularise-iterations-help = passes at most
regularise-features-help = how strongly features stay; with 0 creases slide too

repair-weld-help = welds boundary vertices within this length; auto is 1e-6 of the size, or what single precision rounds by, and at most a hundredth of an edge
fill-loops-help = which boundary loops, counted from 0; small leaves outer rims and mouths of tubes open
fill-connect-help = connects these loops, by default all, by one patch instead of closing each
fill-maxVertices-help = at most so many new vertices; auto is 200000

flips-criterion-help = { option-criterion-help }
flips-guardFolds-help = { option-guardFolds-help }
flips-max-help = at most so many flips

remesh-kind-help = adaptive edges are short where the surface bends, isotropic ones are equal
remesh-target-help = mean length of the edges, away from boundaries, which stay
remesh-creases-help = edges of the shape, where faces meet at more than 60°, or flat sides at more than 40°: keep holds them, smooth takes them for noise
remesh-vertices-help = number of vertices; as many as there are if neither is given

bench-table-help = which table
bench-maxVertices-help = leaves out larger meshes
bench-steps-help = steps measured a row, after one that is not
bench-figures-help = of the table figures only these
bench-quick-help = of the table figures only those that take a few seconds

## Tables of measurements

measured-refused = { $kind }: { $message }

bench-circle = One step of the circle-angle flow on a torus, and one trial of a step, in milliseconds (medians)
bench-p-willmore = p-Willmore flow, p = 2, on a torus: a step with area and volume kept and nonlinear
    regularisation, or one pass of regularisation alone; milliseconds (medians of steps),
    and those of table 1 of the paper, measured on another machine
bench-flips = Edge flips to the end on a torus of jittered points, its cells cut at random: milliseconds,
    thousands of flips a second, and nanoseconds over E log₂ E
bench-mmcv = Minimal mean-curvature-variation flow: milliseconds of the first step and of a later one
    (medians), steps to rest, and forming and solving the system in table 5.1 of the paper,
    measured on another machine, with the ratio of its step to ours
bench-refinement = Area, W/2 and ∫H² by cotangents and by fits under refinement, with observed orders; the
    circle energy tends to ∫(H² − K) dA only along lines of curvature
bench-repair = Loose triangles of an STL made a surface: milliseconds to open the file and find what is to be
    repaired, and to repair it
bench-robustness = How flows end, left to themselves: on shapes with noise (h the mean edge length), or on the
    meshes of a folder in 100 steps. The energy at first and last, the largest relative rise of
    the monitored functional in a step, the smallest angle there was
bench-vesicles = Vesicles at rest, area and volume kept: ∫H²/4π over the reduced volume on three branches, and where
    they cross; what is expected is of shapes of revolution
bench-figures = The figures of the four papers: what is expected, and what was measured here just now
