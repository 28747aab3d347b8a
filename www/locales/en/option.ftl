# Options of a flow, as forms, menus and `umbilic flow --help` call them.

option-flow = Flow
option-flow-help = which flow

option-scheme = Scheme
    .auto = Recommended
    .paper = As in the paper
option-scheme-help = auto chooses the step size; paper keeps the paper's integrator and a constant --dt

option-boundary = Boundary
    .clamped = Clamped (with tangent)
    .fixed = Fixed (position only)
    .free = Free
option-boundary-help = what holds at the boundary of an open mesh; auto is as usual of the flow

option-free = Free vertices
option-free-help = only these vertices move
option-fixed = Held vertices
option-fixed-help = these vertices do not move
option-prefill = Smooth first guess
option-prefill-help = lays the free vertices out smoothly before the first step

option-p = Exponent p
option-p-help = the exponent of ∫|H|^p dA
option-keep = Keep
    .area = Area
    .volume = Volume
option-keep-help = what is kept
option-reducedVolume = Reduced volume
option-reducedVolume-help = leads the volume to this share of that of the ball of the same area; area and volume are kept
option-spontaneousCurvature = Spontaneous H₀ · L
option-spontaneousCurvature-help = with p = 2, H₀ in ∫(H − H₀)² dA, times L = √(A/4π)
option-tension = Tension σ · L²
option-tension-help = with p = 2, σ in ∫|Y|² dA + σA, times L²
option-pressure = Pressure P · L³
option-pressure-help = with p = 2, P in ∫|Y|² dA − PV, times L³

option-epsilon = Angle smoothing ε
option-epsilon-help = smoothing of the angles
option-sharpen = Sharpen at the end (ε → 0)
option-sharpen-help = lets ε go to 0 at the end

option-criterion = Criterion
    .area = Area
    .willmore = Willmore energy
    .localised = Localised Willmore energy
option-criterion-help = what is to become small
option-guardFolds = No flip may turn a face over
option-guardFolds-help = no flip turns a face over; that also forbids unfolding

option-goal = Goal
    .relax = Come to rest
    .smooth = Smooth a bit
option-goal-help = relax goes to a minimum; smooth removes a set amount of detail
option-detail = Smooth away detail below L
option-detail-help = removes detail below so many mean edge lengths
option-smoothSteps = Spread over (steps)
option-smoothSteps-help = in so many steps

option-tau = Time step τ
    .absent = automatic
option-tau-help = step size without a unit: dt/h² of the flow by circle angles, h the mean edge length; else dt/L^k, k the order, L the size of what moves
option-dt = Time step dt
option-dt-help = step size in the unit of the mesh: length², for p-Willmore length^(p+2), for a flow of order k length^k
option-tauGrowth = Growth of τ
option-tauGrowth-help = factor on the step size after each step
option-tauMax = Largest τ
option-tauMax-help = largest step size without a unit

option-compare = Beside it
    .none = Nothing
    .start = The start
    .criteria = The other criteria
    .flows = The other flows
option-compare-help = what stands side by side
option-subdivide = Show subdivided
option-subdivide-help = so many times, by Loop’s scheme, in the picture only
option-flipsPerStep = Flips a step
    .absent = all
option-flipsPerStep-help = how many flips are one step

option-integrator = Integrator
    .semi-implicit = Semi-implicit
    .forward-euler = Forward Euler
    .backward-euler = Backward Euler (Newton)
    .l-bfgs = L-BFGS
option-integrator-help = how a step is taken
option-mass = Mass
    .auto = Automatic
    .uniform = Uniform
    .area = Vertex area
option-mass-help = weight of a vertex
option-remesh = Remesh
    .adaptive = By curvature
    .isotropic = Evenly
    .off = Off
option-remesh-help = new triangles where a closed mesh has become bad, in place of regularisation
option-regularise = Regularise
    .off = Never
    .linear = After each step, linear
    .nonlinear = After each step
option-regularise-help = conformal regularisation after each step
option-regulariseEpsilon = Regularisation ε
option-regulariseEpsilon-help = 0.001 is faithful to the surface, 0.1 aggressive
option-perturbation = Perturb the start by
option-perturbation-help = pushes the start along its normals by up to so many mean edge lengths
option-rungs = Steps of surface diffusion first
option-rungs-help = so many steps of surface diffusion first; auto is as many as a rough start needs

option-maxSteps = Step limit
    .absent = none
option-maxSteps-help = at most so many steps, however long they take
option-maxSeconds = Stop after (seconds)
    .absent = never
option-maxSeconds-help = at most so many seconds of computing, where no number of steps is set

# Beside what may be chosen.
option-nothing = Nothing
option-no = No
option-yes = Yes
