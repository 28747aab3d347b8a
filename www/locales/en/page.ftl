# What the page, the worker and the command line say of their own.

## Counts

count-steps = { $count ->
    [one] { $count } step
   *[other] { $count } steps
}
count-flips = { $count ->
    [one] { $count } flip
   *[other] { $count } flips
}
count-fills = { $count ->
    [one] the fill of { $count } loop
   *[other] the fill of { $count } loops
}
boundary-loops = { $count ->
    [one] { $count } boundary loop.
   *[other] { $count } boundary loops.
}
crossings = { $count ->
    [one] { $count } pair of triangles passes through each other.
   *[other] { $count } pairs of triangles pass through each other.
}

## The status line of a run that is over

ended = { $status ->
    [converged] Converged
    [stalled] Stalled
    [singular] Singular
    [collapsed] Collapsed
    [failed] Failed
   *[stepLimit] Stopped
} after { $steps ->
    [one] { $steps } step
   *[other] { $steps } steps
}

## Edits

regularised = Regularised in { $passes ->
    [one] { $passes } pass
   *[other] { $passes } passes
}: smallest angle { $angle }° → { $angleNow }°, distortion { $distortion } → { $distortionNow }; no vertex is farther than { $distance } % of the size from the surface before. Back undoes it.
filled = Filled { $count ->
    [one] { $count } loop
   *[other] { $count } loops
} with { $vertices ->
    [one] { $vertices } new vertex
   *[other] { $vertices } new vertices
}. Play lets the flow fair them; Undo takes the fill back.
