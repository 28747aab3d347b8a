## An option that there is not, or a value that it cannot have

option-error-unknown-option = there is no option `{ $name }`
    .hint = { $near ->
        [none] --help and copied links show how they are written.
       *[other] Did you mean `{ $near }` (--{ $flag })?
    }
option-error-bad-option = `{ $name }` cannot be `{ $value }`
    .hint = It may be { $allowed }.
option-error-unread-option = `{ $name }` changes nothing here: it is for { $flows }{ $scheme ->
        [any] { $goal ->
            [any] {""}
           *[other] {" with goal "}{ $goal }
        }
       *[other] {" with scheme "}{ $scheme }
    }
    .hint = Leave it out, or choose what reads it.
option-error-missing-option = `{ $name }` is missing
    .hint = It may be { $allowed }.
option-error-lone-option = `{ $name }` needs `{ $other }` to be `{ $value }`
    .hint = Leave it out, or choose what reads it.
option-error-conflicting-options = `{ $first }` and `{ $second }` cannot both be given
    .hint = Each says the same thing in its own way.

## What the value of an option may be

allowed-range = a number from { $low } to { $high }
allowed-zero-or-range = 0, or a number from { $low } to { $high }
allowed-above = a number above { $low }, at most { $high }
allowed-whole-range = a whole number from { $low } to { $high }
allowed-one-of = one of { $names }
allowed-any-of = none, or any of { $names }
allowed-switch = true or false
allowed-several-of = any number of these, with commas between them: { $allowed }
allowed-vertices = a list of vertex numbers from 0
allowed-word-or = { $word }, or { $allowed }
allowed-moving-flow = one that moves vertices
allowed-curvature-flow = one by mean curvature or its derivatives
allowed-with-area-and-volume = given only where both area and volume are kept
allowed-helfrich-two = only 2 with spontaneous curvature, tension or pressure
allowed-zero-on-quadrilaterals = 0 on quadrilaterals; triangulate the mesh for others
allowed-zero-in-paper = only 0 in the paper's scheme
