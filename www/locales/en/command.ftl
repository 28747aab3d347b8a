# What the command line alone says: its commands and their options, what it refuses, and tables of
# measurements.

## Commands, and where to read more

overview = umbilic <command> [options]

    Willmore-type geometric flows on triangle meshes.

    { $commands }
    MESH is a file that ends in
    { $formats },
    or - for standard input.
    umbilic <command> --help lists a command's options; --version tells the version.
    Exit codes: 0 done, 2 bad usage, 3 refused input, 4 the surface could not be kept good: a failure,
    a singularity or a collapse.
overview-formats = { $read }, also in { $packed }

summary-info = what a mesh is and what is odd about it
summary-repair = makes a whole surface of a broken file, and lists what it changed
summary-energy = all energies and integrals
summary-flow = runs a flow on a mesh
summary-flips = flips edges as long as that lowers area or Willmore energy
summary-regularise = slides vertices along a closed surface towards a conformal mesh, or refuses
summary-remesh = gives a surface other triangles, of one size or as small as it bends
summary-fill = closes holes, or connects boundary loops, and fairs the patches
summary-replay = does again what a recipe says, and compares
summary-shape = writes a sample shape; its parameters are options
summary-bench = measures a table of the documentation

## Flags that say what is written, and how a command goes about it

flag-json-help = the result as JSON on standard output
flag-help-help = this
flag-out-help = { $command ->
    [shape] the mesh
   *[other] the mesh at the end
}: { $formats }
flag-history-help = { $command ->
    [flips] every flip: edge, reduction, area, W
   *[other] the readings of every step, as a table
}
flag-report-help = the report that --json prints
flag-selection-help = the vertices that a flow should hold or move, if any, by their numbers in the mesh
flag-list-help = all shapes and their parameters
flag-until-converged-help = until it comes to rest, however long that takes
flag-self-intersections-help = counts where the surface passes through itself, before and after
flag-meshes-help = of the table robustness: meshes to try every flow on
fill-fair-help = a flow that moves the new vertices afterwards

## What is refused before the solver is asked

usage-no-command = A command is missing.
    .hint = umbilic --help lists the commands.
usage-command = There is no command `{ $name }`.
    .hint = { $near ->
        [none] umbilic --help lists the commands.
       *[other] Did you mean `{ $near }`?
    }
usage-shape = There is no shape `{ $name }`.
    .hint = { $near ->
        [none] --list shows all there are.
       *[other] Did you mean `{ $near }`?
    }
usage-fair = `--fair` cannot be `{ $name }`
    .hint = { $near ->
        [none] It may be one of { $names }.
       *[other] Did you mean `{ $near }`? It may be one of { $names }.
    }
usage-operands = Arguments wanted: { $wanted }; given: { $given }.
    .hint = --help shows how.
usage-syntax = { $reason }
usage-takes-value = `--{ $flag }`: such an option takes a value, { $value }.
usage-no-shape = Name the shape first: umbilic shape NAME.
    .hint = --list shows all there are.
usage-no-out = --out FILE is missing.
usage-flips = Edge flips have a command of their own: umbilic flips.
usage-smooth = --until-converged is for --goal relax: smoothing takes a set amount of steps.
usage-both = Give --until-converged or --{ $flag }, not both.
usage-unfaired = --{ $flag } needs --fair FLOW.
usage-meshes = --meshes needs --table robustness.
usage-no-rows = No row of this table has so few vertices.
usage-no-folder = { $folder } is not a folder that can be read.
usage-empty-folder = { $folder } holds no mesh.
    .hint = Meshes end in { $formats }.
usage-format = { $file } does not say which format to write.
    .hint = End its name in { $formats }.
usage-unwritable = { $file } cannot be written: { $cause }.
usage-recipe-shape = The recipe begins with the sample { $shape }: { $given } has no use.
usage-recipe-mesh = The recipe begins with the mesh { $name }, which is missing.
    .hint = Give it after the recipe, or put it beside it.
usage-not-built = The solver has not been built yet.
    .hint = Run `npm run build` once in the project's folder.
file-unreadable = { $file } cannot be read: { $cause }.
file-fault = { $code ->
    [ENOENT] there is no such file or folder
    [EACCES] permission denied
    [EISDIR] it is a folder
   *[other] { $reason }
}
selection-no-json = { $file } is not JSON: { $reason }.
selection-no-list = { $file } holds no list of vertex numbers.
    .hint = Write [1, 2] or {"{"}"{ $key }": [1, 2]{"}"}, with the numbers of the mesh file: OBJ counts from 1, others from 0.
failure-crashed = The solver crashed: { $reason }.
    .hint = This is a defect of the solver; the mesh and the options will reproduce it.

## What comes of a command

repair-pending = repair: { $message }
repair-way = `umbilic repair MESH --out FILE` writes such a surface.
repair-nothing = Nothing was to be repaired.
repair-gap = Boundaries run close beside each other: try --weld { $gap }
result-warning = warning: { $message }
shape-written = { $file }: { $vertices } vertices, { $faces } faces
replay-long = The recipe runs about { $steps } steps.
replay-result = { $same ->
    [true] Reproduced after { $steps } steps, { $compared }.
   *[other] Not reproduced after { $steps } steps: these differ, compared { $compared }.
}
replay-compared = { $exact ->
    [true] to the last bit
   *[other] to { $tolerance } (made by version { $version }, so that the last bits may differ)
}

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
