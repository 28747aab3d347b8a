import { nothing } from "lit-html";
export const conjecture = (page) => nothing;
export const lab = (page) => nothing;
