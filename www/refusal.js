// What the page and the worker refuse themselves, in the shape of the solver's refusals.

/** @param {string} kind @param {string} id  of words @param {Record<string, unknown>} [values] */
export const refusal = (kind, id, values = {}) => ({
  kind,
  message: { id, values },
  hint: { id: `${id}.hint`, values },
  detail: {},
});
