// Numbers and small elements for people.

/** Four digits, without zeros that say nothing. */
export function number_text(value) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "no value";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) return value.toExponential(3).replace(/\.?0+e/, "e").replace("e+", "e");
  return String(Number(value.toPrecision(4)));
}

/** Numbers at equal distances, with as many digits as tell them apart. */
export function tick_texts(numbers) {
  const known = numbers.filter((value) => value !== null);
  const most = Math.max(...known.map(Math.abs)), step = Math.abs(known[1] - known[0]) || most || 1;
  const digits = Math.ceil(-Math.log10(step) - 1e-9);
  if (most < 1e5 && digits <= 5) return numbers.map((value) => value?.toFixed(Math.max(0, digits + (is_round(step, digits) ? 0 : 1))));
  const places = Math.max(0, Math.ceil(Math.log10(most / step) - 1e-9));
  return numbers.map((value) => (value === 0 ? "0" : value?.toExponential(places).replace("e+", "e")));
}

const is_round = (step, digits) => Math.abs(step * 10 ** digits - Math.round(step * 10 ** digits)) < 1e-6;

const raised = (unit) => unit.replaceAll("^2", "²").replaceAll("^3", "³");
export const unit_text = (unit) => (unit && unit !== "1" ? `[${raised(unit)}]` : "");
export const with_unit = (text, unit) => (unit && unit !== "1" ? `${text} ${raised(unit)}` : text);
export const label_of = (name, unit) => (unit && unit !== "1" ? `${name} ${unit_text(unit)}` : name);
export const words_of = (name) => name.replaceAll("_", " ");

/** element("td", { class: "number" }, "text", other elements ...) */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

export const by_id = (id) => document.getElementById(id);
export const style_of = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
