import { nothing } from "lit-html";
export const study = (page) => nothing;
