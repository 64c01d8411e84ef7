// What the summary of a run says, as tables.
import { element, number_text, with_unit, words_of } from "./text.js";

function card(parent, title, ...children) {
  const made = element("article", { class: "card" }, element("h2", {}, title), ...children);
  parent.append(made);
  return made;
}

function table(headings, rows) {
  const head = headings && element("thead", {}, element("tr", {}, ...headings.map((text, i) =>
    element("th", { scope: "col", class: i > 0 ? "number" : "" }, text))));
  const body = element("tbody", {}, ...rows.map(([name, ...cells]) =>
    element("tr", {}, element("th", { scope: "row" }, name), ...cells.map((cell) =>
      cell instanceof Element ? cell : element("td", { class: "number" }, cell)))));
  return element("div", { class: "scroll" }, element("table", {}, ...(head ? [head] : []), body));
}

const time_text = (seconds) => with_unit(number_text(seconds), "s");

export function add_phases(parent, summary) {
  const phases = Object.entries(summary.phases ?? {});
  if (phases.length === 0) return;
  const sum = phases.reduce((total, [, seconds]) => total + seconds, 0) || 1;
  const rows = phases.map(([name, seconds]) => {
    const bar = element("div", { style: `width:${(100 * seconds) / sum}%` });
    return [name, time_text(seconds), `${((100 * seconds) / sum).toFixed(1)} %`, element("td", { class: "share" }, bar)];
  });
  const made = table(["phase", "over all threads", "share"], rows);
  made.querySelector("thead tr").append(element("th", { "aria-hidden": "true" }));
  card(parent, "Time of each phase", made);
}

export function add_conserved(parent, summary) {
  const { start, end } = summary.conserved ?? {};
  if (!start || !end) return;
  const units = { mass: "kg", momentum: "N s", angular_momentum: "N m s" };
  const rows = Object.keys(start).flatMap((name) => {
    const unit = units[name] ?? "J";
    if (!Array.isArray(start[name])) return [[`${words_of(name)} [${unit}]`, number_text(start[name]), number_text(end[name])]];
    return start[name].map((value, a) => [`${words_of(name)}, ${"xyz"[a]} [${unit}]`, number_text(value), number_text(end[name][a])]);
  });
  card(parent, "Conserved quantities", table(["", "start", "end"], rows));
}

export function add_measurements(parent, summary) {
  const entries = Object.entries(summary.measurements ?? {});
  if (entries.length === 0) return;
  const rows = entries.map(([name, { value, unit, reason }]) =>
    [words_of(name), value === null ? `no value: ${reason ?? "not finite"}` : with_unit(number_text(value), unit)]);
  card(parent, "Measurements at the end", table(null, rows));
}

export function add_speed(parent, summary) {
  const { performance: speed, particles, versions } = summary;
  if (!speed) return;
  const rows = [
    ["particles at start and end", `${particles.start}, ${particles.end}`],
    ["steps", String(summary.steps)],
    ["wall time of the run", time_text(summary.wall_time)],
    ["wall time of the steps", time_text(speed.step_wall_time)],
    ["particle stages per second", number_text(speed.particle_stages_per_second)],
    ["threads, instruction set", `${speed.threads}, ${speed.isa}`],
    ["precision", summary.precision],
    ["versions", Object.entries(versions).map(([name, version]) => `${name} ${version}`).join(", ")],
  ];
  card(parent, "Run", table(null, rows));
}

export function add_settings(parent, text) {
  const details = element("details", {}, element("summary", {}, "The case with every default"), element("pre", {}, text));
  card(parent, "Settings", details).classList.add("wide");
}

/** All runs of a batch, one row each. */
export function add_runs(parent, headings, rows) {
  card(parent, "Runs", table(headings, rows)).classList.add("wide");
}
