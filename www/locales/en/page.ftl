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
}. Play fairs them by the flow { $flow }. Undo takes the fill back.

## How a run ended

play-goes-on = { $reason }. Play goes on.
end-untrusted = { $reason }. Not to be trusted: the mesh is too coarse or too crumpled

## A fill

fair-nothing = There is no new vertex, and nothing for { $flow } to move.

## The worker, and sequences of meshes

worker-internal = The solver met an error of its own: { $reason }
    .hint = Please report this, with the mesh if you can.
worker-cancelled = It was given up.
    .hint = Open it again to begin anew.
sequence-too-large = { $meshes } meshes would be { NUMBER($gigabytes, digits: 2) } GB, more than 1 GB.
    .hint = Take fewer of the steps, or a smaller format.

## A solver that was lost, or is silent

solver-lost-again = The solver stopped each time the surface was to be restored.
    .hint = Download saves what is shown. “Restart the solver” tries again; if memory is short, close other tabs first.
lost-with-solver = { $what ->
    [steps] Its stored steps are gone; the history starts anew.
    [edits] Edits made before can no longer be undone.
   *[both] Its stored steps are gone, the history starts anew, and edits made before can no longer be undone.
}
saved-own-copy = The solver cannot be asked now: the mesh was saved as PLY, as triangles, from what the page itself has.
no-mesh-yet = There is no mesh yet.

## Archives, and several files at once

unpack-others = Of several meshes the largest was opened, { $name }; left aside: { LIST($others, most: 6) }
