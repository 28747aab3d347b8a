// @ts-check
// A file's fingerprint.

/**
 * SHA-256 in hexadecimal. Browsers have it on `https://` and `localhost` only.
 * @param {BufferSource} bytes
 * @returns {Promise<string>}
 */
export async function sha256(bytes) {
  if (!globalThis.crypto?.subtle) {
    throw new Error("Fingerprints of files need https:// or localhost.");
  }
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return Array.from(digest, (byte) => byte.toString(16).padStart(2, "0")).join("");
}
