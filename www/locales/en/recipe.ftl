## Recipes that cannot be read or followed

recipe-not-json = The recipe is not JSON: line { $line } cannot be read.
    .hint = Recipes are made by “Save as: Recipe”.
recipe-too-long = The recipe has { $bytes } bytes, more than the { $most } that are read.
    .hint = Do the work in fewer parts, and save the mesh between them.
recipe-malformed = The recipe’s “{ $key }” must be { $must }.
    .hint = Recipes are made by “Save as: Recipe”.
recipe-option = { $error }
recipe-old-option = { $error } (the recipe was written by version { $version }; this is version { $present })
    .hint = Open it with version { $version }, or correct it by hand.
recipe-too-many-selected = The selections hold { $count } vertices in all, more than the { $most } that are read.
    .hint = Do the work in fewer parts, and save the mesh between them.
recipe-too-many-flows = The flow changes { $count } times on a mesh of { $vertices } vertices: that is too much.
    .hint = Do the work in fewer parts, and save the mesh between them.
recipe-mesh-missing = The recipe needs the mesh { $name }.
    .hint = Open it first.
recipe-another-mesh = The file given is not the mesh { $name }: its SHA-256 begins with { $found }, not with { $asked }.
    .hint = The recipe holds for that very file only, to the last byte.
recipe-ends-early = The flow ends at step { $step } of { $goal }: { $reason }.
    .hint = Take fewer steps.
recipe-no-flow = No flow has been chosen yet.
    .hint = Choose one first.
recipe-origin-unknown = A recipe of this surface cannot be made: where its mesh came from is not known any more.
    .hint = Open the mesh or choose the sample again; what is done from then on is recorded.
recipe-not-replaying = No recipe is being followed.
    .hint = Open one first.

must-be-version = the version, as text
must-be-object = an object
must-be-list = a list
must-be-count = a whole number from 0 to { $most }
must-be-number = a number
must-be-number-or-null = a number or null
must-be-digest = a SHA-256, 64 digits from 0 to f
must-be-shape = the name of a shape
must-be-sample = the name of a sample
must-be-file = the name of a file
must-be-numbers = an object of numbers
must-be-options = an object of options
must-be-action = {"{"} steps {"}"}, {"{"} regularise {"}"}, {"{"} flow {"}"} or “anew”
must-be-edit = “adopt”, {"{"} fill {"}"}, {"{"} flip {"}"}, {"{"} subdivide {"}"}, {"{"} remesh {"}"} or {"{"} invert: [x, y, z] {"}"}, with options that there are
must-be-regularisation = options of a regularisation
must-be-steps = a list whose steps are { $total } in all, as “steps” says

## Links that cannot be read

link-too-long = The link has { $bytes } bytes, more than the { $most } that are read.
    .hint = Copy a link from the page to see how its words are written.
link-twice = The link has “{ $word }” more than once.
    .hint = Copy a link from the page to see how its words are written.
link-bad-word = “{ $word }” cannot be “{ $value }”.
    .hint = It may be { $allowed }.
link-figure = { $error }
link-option = { $error }
link-recipe = { $reason }

link-value-sample = the id of a sample
link-value-digest = the first 16 digits of a SHA-256, or more of them
link-value-step = a whole number of at most seven digits
link-value-percent = a whole number from 0 to 100
link-value-camera = the numbers of a camera, with commas between them
link-value-one-of = one of { $names }
link-value-energy = a number
link-value-version = a version
link-value-edits = edits as a link writes them
link-value-path = a path as a link writes it, to step { $step }
link-value-panes = at most three panes, of flows that move vertices
link-value-pane = the letter of a pane
