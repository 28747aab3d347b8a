# What is read before there is a solver; in the page it comes with the script.

## The page without a surface

library = Library
present = Present
help = Help
close = Close
full-height = Full height
full-page = Full page
    .title = Open this scene in the whole page
dismiss = Dismiss
panels = Panels
tab-surface = Surface
tab-flow = Flow
tab-measure = Measure
tab-compare = Compare
tab-share = Share
messages = Messages

## The status line

status-starting = Starting the solver…
status-loading = Loading { $name }…
status-restoring = Restoring the surface…
status-failed = The solver is not running
status-stuck = The flow cannot start
status-empty = Open a mesh to begin
clause-private = Nothing you open here leaves this device.
notes = { $count ->
    [one] { $count } note
   *[other] { $count } notes
}
why = Why?

## A solver that is not there

solver-silent = No sign of life from the solver for some time; it may be at work on something large.
solver-gone = What is shown can still be saved.
restart-solver = Restart the solver
solver-not-started = The solver could not be started.
    .hint = Reload the page; its address keeps the scene.
too-many-requests = More than { $most } requests wait to be answered.
    .hint = Wait for the answers before asking for more.
worker-forbidden = The solver may not be started here: { $reason }
    .hint = If this page is in a frame with `sandbox`, that needs `allow-same-origin` beside `allow-scripts`.
worker-not-loaded = it could not be loaded

## The surface

surface-none = Surface: none yet
drawn-with = Drawn with { $name }: { $reason }.

## Cards

welcome = Watch a surface find its shape
welcome-text = This dented ball moves so as to bend as little as possible. In a few seconds it will be round, and you see every step of the way.
watch = Watch it flow
    .name = Play: Watch it flow
sample-vesicle = Vesicle
    .small = to a red blood cell
sample-coarse-torus = Coarse torus
    .small = to Clifford’s torus
own-mesh = Your own mesh
    .small = never uploaded
no-picture-here = No picture here
no-picture-hint = Everything else works without it: the flow runs, the numbers and the curve follow it, and the mesh can be saved.

## What draws

viewer-context-taken = the browser took the WebGL context away
viewer-no-picture = no picture
viewer-not-loaded = the viewer could not be loaded: { $reason }
    .hint = Check the connection and reload the page.
renderer-asked = the address asks for it
renderer-no-webgpu = this browser has no WebGPU, or the page is not served securely
renderer-offered = this browser offers it
renderer-no-adapter = WebGPU offers no graphics adapter
renderer-no-webgl = this browser has no WebGL2
renderer-neither = { $reason }; there is no WebGL2 either
    .hint = Use a current Chrome, Edge, Firefox or Safari, over https or on localhost, and switch on hardware acceleration in its settings.
