// What tells one file from another.

/**
 * @param {BufferSource} bytes
 * @returns {Promise<string>} SHA-256, 64 hexadecimal digits; empty where the browser keeps it
 *   from pages that came over plain http
 */
export async function sha256(bytes) {
  if (!globalThis.crypto?.subtle) return "";
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
