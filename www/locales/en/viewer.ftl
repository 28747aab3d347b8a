# The viewer: src/viewer/error.rs.

viewer-no-web-gpu = this browser has no WebGPU, or the page is not served securely
    .hint = Use a current Chrome, Edge, Firefox or Safari, over https or on localhost.
viewer-no-adapter = { $api } offers no graphics adapter
    .hint = Switch on hardware acceleration in the browser's settings, or update the graphics driver.
viewer-no-device = the graphics adapter gives no device: { $reason }
    .hint = Switch on hardware acceleration in the browser's settings, or update the graphics driver.
viewer-no-canvas = the canvas gives no { $api } context: { $reason }
    .hint = Reload the page.
viewer-gpu-lost = the graphics device was lost: { $reason }
    .hint = Reload the page. Your surface is safe: download it first if you changed it.
viewer-wrong-length = { $array } has { $found } entries; the mesh wants { $expected }
    .hint = This is a fault of the program; please report it.
viewer-wrong-time = the time of a step is not after that of the step before
    .hint = This is a fault of the program; please report it.
viewer-out-of-range = { $array } names element { $index } of { $count }
    .hint = This is a fault of the program; please report it.
viewer-too-large = { $vertices } vertices are more than the { $limit } this graphics device can draw
    .hint = Simplify the mesh first.
