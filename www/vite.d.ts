import type { Plugin } from "vite";

/** The page behind <umbilic-surface>: served in development, and copied to what is built. */
export function umbilic(): Plugin;
