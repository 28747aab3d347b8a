// @ts-check
// Films that the page has saved, played in a page of their own.

/**
 * @param {import("playwright-core").Page} page  a blank one
 * @param {Buffer} bytes  WebM
 * @returns {Promise<{ width: number, height: number, halves: number[] }>}  size, and how many
 *   different colours the left and the right half of the first picture have
 */
export function playFilm(page, bytes) {
  return page.evaluate(async (data) => {
    const video = document.createElement("video");
    video.muted = true;
    video.src = `data:video/webm;base64,${data}`;
    await new Promise((resolve, reject) => {
      video.onloadeddata = resolve;
      video.onerror = () => reject(new Error(video.error?.message));
    });
    // The first picture that is shown.
    await new Promise((resolve) => {
      video.requestVideoFrameCallback(resolve);
      video.play();
    });
    const { videoWidth: width, videoHeight: height } = video;
    const canvas = new OffscreenCanvas(width, height);
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d"));
    context.drawImage(video, 0, 0);
    const halves = [0, width >> 1].map((left) => {
      const { data: pixels } = context.getImageData(left, 0, width >> 1, height);
      return new Set(new Uint32Array(pixels.buffer)).size;
    });
    return { width, height, halves };
  }, bytes.toString("base64"));
}
