// A place of a scroll as an address: all that the scroll is made of, so that it is the same in any studio.

/** What says where one is or is no text, and so is not in it. */
const OWN = new Set(["seed", "from_", "span", "title", "font", "left_out"]);

/** @param {Record<string, any>} params @param {number} x @returns {string} */
export function address(params, x) {
  const told = Object.entries(params).filter(([name, value]) => !OWN.has(name) && value !== null && value !== undefined);
  const parts = [["seed", params.seed ?? "1"], ...told, ["x", Math.round(x)]];
  return `#/ink?${parts.map(([name, value]) => `${name}=${encodeURIComponent(String(value))}`).join("&")}`;
}

/** What a new piece is made of, and its place; null: it is no such address. @param {string} text an address, or its end from # on
 * @returns {{body: {craft: "ink", seed: string, title: string, params: Record<string, string>}, x: number}|null} */
export function scrollOf(text) {
  const found = /^\S*#\/ink\?(\S+)$/.exec(text.trim());
  if (!found) return null;
  const told = Object.fromEntries(new URLSearchParams(found[1])), { seed = "1", x, ...params } = told;
  return { body: { craft: "ink", seed, title: seed.slice(0, 80) || "Scroll", params }, x: Number(x) || 0 };
}
