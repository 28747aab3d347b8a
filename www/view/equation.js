import { nothing } from "lit-html";
export const equation = (page) => nothing;
