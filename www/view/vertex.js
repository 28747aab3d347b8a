import { nothing } from "lit-html";
export const vertex = (page) => nothing;
