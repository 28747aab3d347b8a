# Mesh files: src/io/error.rs.

## Places and formats

place-line = line { $line }
place-byte = byte { $byte }
format-obj = OBJ
format-off = OFF
format-ply = PLY
format-ply-ascii = ASCII PLY
format-ply-big = big-endian PLY
format-stl = binary STL
format-stl-ascii = ASCII STL
format-glb = GLB
format-gltf = glTF
format-3mf = 3MF
format-vtk = VTK
format-vtp = VTK XML
format-msh = MSH

## What stands in a file, and what should

found-end-of-line = end of line
found-end-of-file = end of file
found-nothing = nothing
found-word = `{ $word }`
expected-keyword = `{ $word }`
expected-coordinate = the coordinate { $axis }
expected-vertex = a vertex
expected-face = a face
expected-vertex-index = a vertex index
expected-obj-corner = a vertex index such as 7, 7/1 or 7//2
expected-vertex-count = the number of vertices
expected-off-or-vertex-count = OFF or the number of vertices
expected-face-count = the number of faces
expected-corner-count = the number of corners
expected-number = a number
expected-property-name = the property's name
expected-element-name = the element's name
expected-element-count = the number of elements
expected-other-element = a line of another element
expected-list-length = the length of a list
expected-integer-type = an integer type for the length of a list
expected-number-type = a type such as float or uchar
expected-one-element-each = vertices and faces in one element each
expected-vertex-properties = one property each `x`, `y` and `z` in element vertex
expected-face-property = one list `vertex_indices` of integers in element face
expected-cell-count = the number or the end of cells
expected-cell-type = a known type of cell
expected-vertex-number = a number that no other vertex has
expected-xml-element = `{ $name }` of XML
expected-xml-attribute = the attribute { $name } with a fitting value
expected-json-value = well-formed JSON
expected-json-member = a fitting `{ $name }`
expected-scene-node = the number of a node that stands in one place of the scene and not within itself
expected-base64 = whole base64 text
expected-compressed = undamaged zlib data
expected-model-object = the number of an object that is not part of itself
expected-transform = twelve numbers

## Files that are refused

read-empty = the file is empty
    .hint = Check that the export or download finished.
read-unknown-format = `{ $name }` is not recognised as a mesh
    .hint = Open a file that ends in one of these: { $known }.
read-substituted = { $what ->
    [git-lfs] this is a pointer of Git LFS and not the file itself
   *[html] this is an HTML page and not a mesh
}
    .hint = { $what ->
        [git-lfs] Fetch the file with `git lfs pull`, or by the download link of its page.
       *[html] The link led to a page about the file, or to an error: download the file itself.
    }
read-required-extension = the glTF file cannot be read without its extension { $name }, which is not known here
    .hint = Export the surface without it, or as OBJ, PLY or STL.
read-unsupported = { $what ->
    [vtk-data-set] VTK without polygonal data or an unstructured grid: such
    [vtk-compressor] VTK compressed by anything but zlib: such
    [msh-version] MSH of another version than 1, 2 or 4: such
    [gltf-version] glTF of another version than 2: such
    [gltf-external] glTF with its data in other files: such
    [gltf-draco] Draco-compressed glTF
    [gltf-meshopt] meshopt-compressed glTF
    [obj-free-form] OBJ with free-form surfaces alone: such
   *[nd-off] higher-dimensional OFF
} files cannot be read
    .hint = { $what ->
        [gltf-external] Open the .gltf together with the files beside it, or export a GLB.
        [gltf-draco] Export without compression.
        [gltf-meshopt] Export without compression.
        [msh-version] Save it again as MSH 4.1 or 2.2.
        [obj-free-form] Export it as triangles: most programs have a setting for how fine.
       *[other] Export the surface as OBJ, PLY or STL.
    }
read-not-text = { $format }: byte { $offset } is not text
    .hint = The file is binary or UTF-16 text; save it as UTF-8 or give it the right ending.
read-syntax = { $format }, { $place }: found { $found }, expected { $expected }
    .hint = Look at that place in the file, or export it again.
read-decimal-comma = { $format }, { $place }: found { $found }, expected { $expected }
    .hint = Export with a decimal point instead of a decimal comma.
read-index-out-of-range = { $format }, { $place }: a face names vertex { $index }, the file has { $vertices }
    .hint = { $format ->
        [OBJ] OBJ counts vertices from 1, or from -1 backwards. Export the file again.
        [MSH] MSH names vertices by numbers of their own. Export the file again.
       *[other] This format counts vertices from 0. Export the file again.
    }
read-non-finite-vertex = { $place }: vertex number { $number } (counted from 1) is not finite
    .hint = Remove the vertex or give it a position, then export again.
read-truncated = the file is cut short: { $needed } bytes needed at byte { $offset }, { $available } there
    .hint = The download or copy may have stopped early; fetch it again.
read-count-too-large = { $place } announces { $count } { $what ->
    [bytes] bytes of memory
    [vertices] vertices
    [faces] faces
    [corners] corners
   *[elements] elements
}, at most { $at_most } are possible
    .hint = The count is wrong or the file is cut short.
read-no-faces = the file has { $vertices ->
    [one] { $vertices } vertex
   *[other] { $vertices } vertices
} and no faces
    .hint = { $vertices ->
        [0] Check that the file is what its name says.
       *[other] Point clouds and curves have no surface; open a mesh.
    }

## Oddities of files that are read

oddity-transcoded = The text is UTF-16; it was read as such.
oddity-other-ending = The name ends in .{ $ending }, the contents are { $format }.
oddity-short-faces = Faces of fewer than three corners were dropped: { $count }, the first at { $first }.
oddity-unplaced-vertices = { $count ->
    [one] { $count } vertex without a position, which no face uses, was
   *[other] { $count } vertices without a position, which no face uses, were
} put where the first vertex is (the first at { $first }).
oddity-nothing-to-build = The model lists nothing to be built; all of its objects were read.
oddity-other-lines = Lines that are no part of a polygon mesh were skipped: { $count }, the first at { $first }.
oddity-lines-left = { $count ->
    [one] { $count } line after what the header counts was
   *[other] { $count } lines after what the header counts were
} left aside.
oddity-bytes-left = { $count ->
    [one] { $count } byte after the end of the mesh was
   *[other] { $count } bytes after the end of the mesh were
} left aside.
oddity-no-end = The last solid has no end; the file may be cut short.
oddity-uncounted = The header counts { $announced ->
    [0] no triangles; { $count } were read, to the end of the file.
   *[other] { $announced } triangles; the { $count } that the file has were read.
}
oddity-fourth-numbers = { $count ->
    [one] { $count } vertex has
   *[other] { $count } vertices have
} a fourth number, the first at { $first }; it was left aside.
oddity-other-cells = Points, lines and volumes are no part of a surface and were skipped: { $count }, the first at { $first }.
oddity-solid-cells = The file has solid cells ({ $count }) and no faces: the surface around them was read.
oddity-seams-joined = { $count ->
    [one] { $count } vertex at the position of another was
   *[other] { $count } vertices at the position of another were
} joined to it: the format splits vertices along seams.
oddity-left-out = Left out: { $what }.
extra-colours = colours
extra-texture-coordinates = texture coordinates
extra-materials = materials
extra-groups = groups
extra-data = values at vertices and cells

## What a written file lacks

loss-moved = { $format } holds coordinates in single precision: the mesh was moved to the origin, by ({ NUMBER($x, digits: 17) }, { NUMBER($y, digits: 17) }, { NUMBER($z, digits: 17) }). PLY, OBJ and OFF keep its place.
loss-polygons = { $format } holds triangles alone: polygons were cut ({ $count }). PLY, OBJ and OFF keep them.
loss-joined = { $format } knows vertices by their places: those at the place of another are joined to it when the file is read ({ $count }). PLY, OBJ, OFF and GLB keep them apart.
loss-colours = { $format } has no place for colours of vertices: they were left out. PLY, OBJ, OFF and GLB keep them.
loss-colours-lost = The file’s vertex colours are lost: the solver was restarted on vertices that a remeshing had made. Play from the start to have them again.

## Meshes that cannot be written

write-no-faces = there are no faces to write
    .hint = Load a mesh first.
write-index-out-of-range = face { $face } names vertex { $index } of { $vertices }
    .hint = This is a fault of the program; please report it.
write-non-finite-vertex = vertex { $vertex } cannot be written as a number
    .hint = Step back to a state with finite positions.
write-beyond-single = vertex { $vertex } cannot be written as a 32-bit float
    .hint = Scale the mesh down, or use OBJ, OFF or PLY: they keep double precision.
write-below-single = the mesh is too small for 32-bit floats, which cannot tell its vertices apart
    .hint = Scale the mesh up, or use OBJ, OFF or PLY: they keep double precision.
write-normal-count = { $normals } normals given for { $vertices } vertices
    .hint = This is a fault of the program; please report it.
write-read-only = { $format } is read and not written
    .hint = Use PLY, OBJ, OFF, STL or GLB.
write-too-large = the mesh is too large for { $format }
    .hint = Use OBJ, OFF or PLY.

## Archives, and several files at once

unpack-no-mesh = There is no mesh among these files: { LIST($names, most: 6) }
    .hint = Open the mesh itself, or an archive with it.
unpack-damaged = The archive is damaged or cut short.
    .hint = The download or copy may have stopped early; fetch it again.
unpack-encrypted = The archive is encrypted.
    .hint = Unpack it, and open what is in it.
unpack-unsupported = The archive is compressed by method { $method }, which is not read.
    .hint = Unpack it, and open what is in it.
unpack-too-large = Unpacked, the file would be larger than { $megabytes } MB.
    .hint = Unpack it, and open what is in it, if that is a mesh.
