// What <umbilic-surface> (embed.js) is to a page that is checked by TypeScript.

import type { FieldName, FlowOptions, Status } from "./generated/types.js";

/** Options of a flow, as they are written in HTML: `smoothSteps` is `smooth-steps`. */
type Hyphenated<Text extends string> = Text extends `${infer First}${infer Rest}`
  ? `${First extends Lowercase<First> ? First : `-${Lowercase<First>}`}${Hyphenated<Rest>}`
  : Text;

/** Words of a link. A value that there is not is refused by name. */
export interface Scene extends Partial<FlowOptions> {
  /** Id of a sample. */
  sample?: string;
  /** Id of a figure of a paper. */
  figure?: string;
  step?: number;
  colour?: FieldName | "none";
  /** As the address of the page shows it. */
  camera?: string;
  [word: string]: unknown;
}

/** Where the surface stands. */
export interface SurfaceState {
  /** `paused` also where a run has come to its end; `status` says how. */
  phase: "empty" | "loading" | "failed" | "ready" | "running" | "paused";
  step: number;
  /** Of the flow, in its own unit. */
  time: number;
  /** The functional that the flow lowers. */
  energy: number | null;
  area: number | null;
  /** None of a surface with a boundary. */
  volume: number | null;
  status: Status | null;
  /** How the run ended, in a sentence. */
  message: string;
  canStepBack: boolean;
  /** Jump of mean curvature where a patch meets the rest, relative. */
  jump: number | null;
  /** Plays once it is seen. */
  isWaiting: boolean;
  flow: FlowOptions["flow"];
  version: string;
  /** Of the mesh. */
  name: string | null;
  vertices: number;
  faces: number;
}

/** What a promise is rejected with. */
export interface SurfaceError extends Error {
  kind: string;
  /** What to do about it. */
  hint: string;
}

export type MeshFormat = "ply" | "ply-ascii" | "obj" | "off" | "stl" | "stl-ascii" | "glb";
export type ExportFormat = MeshFormat | "csv" | "recipe" | "png";

export interface UmbilicSurfaceEventMap {
  /** A scene is there. */
  ready: CustomEvent<SurfaceState>;
  /** A surface that was not shown before. */
  frame: CustomEvent<SurfaceState>;
  /** Another `phase`. */
  statechange: CustomEvent<SurfaceState>;
  error: CustomEvent<{ message: string; hint: string; kind?: string }>;
  /** Pressed in the surface: a clicker is meant for the slides around it. */
  key: CustomEvent<{ key: "PageUp" | "PageDown" }>;
}

/** A scene of Umbilic. Whatever a method does is done when its promise is kept. */
export interface UmbilicSurface extends HTMLElement {
  /** Another scene; or a mesh, with `name` where it is no file, and words of a link. */
  load(scene: string | Scene): Promise<SurfaceState>;
  load(
    mesh: Blob | ArrayBuffer | Uint8Array,
    words?: Scene & { name?: string },
  ): Promise<SurfaceState>;
  play(): Promise<SurfaceState>;
  pause(): Promise<SurfaceState>;
  step(): Promise<SurfaceState>;
  back(): Promise<SurfaceState>;
  reset(): Promise<SurfaceState>;
  seek(step: number): Promise<SurfaceState>;
  /** Flow, its options, colour, camera; not another scene. */
  set(words: string | Scene): Promise<SurfaceState>;
  state(): Promise<SurfaceState>;
  /** `ply` unless another is asked for. */
  exportMesh(format?: ExportFormat): Promise<File>;

  addEventListener<Type extends keyof UmbilicSurfaceEventMap>(
    type: Type,
    listener: (this: UmbilicSurface, event: UmbilicSurfaceEventMap[Type]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener<Type extends Exclude<keyof HTMLElementEventMap, "error">>(
    type: Type,
    listener: (this: UmbilicSurface, event: HTMLElementEventMap[Type]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
}

/** Attributes, for templates that are checked; each may be changed at any time. */
export type UmbilicSurfaceAttributes = {
  [Word in keyof FlowOptions as Hyphenated<Word>]?: FlowOptions[Word] | string;
} & {
  sample?: string;
  figure?: string;
  step?: number | `${number}`;
  colour?: FieldName | "none";
  camera?: string;
  /** Address of a mesh file, which the embedding page fetches. */
  mesh?: string;
  /** Plays as soon as it is seen. */
  autoplay?: "" | boolean;
  /** No buttons. */
  controls?: "none";
  /** Otherwise as the system. */
  theme?: "light" | "dark";
  /** Address of the page of Umbilic, where it is not beside the script. */
  page?: string;
  /** What it shows, for whoever does not see it. */
  title?: string;
};

declare global {
  interface HTMLElementTagNameMap {
    "umbilic-surface": UmbilicSurface;
  }
}
