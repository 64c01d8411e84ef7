// A batch: measurements over parameters.
import { add_points } from "./plots.js";
import { add_runs } from "./tables.js";
import { by_id, label_of, number_text, words_of } from "./text.js";

export function show_batch(batch) {
  by_id("title").textContent = batch.title;
  const done = batch.runs.filter((run) => run.status === "done").length;
  by_id("facts").textContent = `${batch.runs.length} runs, ${done} of them done`;
  by_id("notes").textContent = batch.notes.join("\n");
  const plots = by_id("plots");
  for (const parameter of batch.parameters) {
    for (const { name, unit } of batch.measurements) {
      const shown = batch.runs.filter((run) => run.parameters[parameter.key] !== undefined && (run.measurements[name] ?? null) !== null);
      if (shown.length === 0) continue;
      add_points(plots, {
        name, unit, over: parameter.label,
        x: shown.map((run) => parameter.words ? parameter.words.indexOf(run.parameters[parameter.key]) : Number(run.parameters[parameter.key])),
        y: shown.map((run) => run.measurements[name]),
      });
    }
  }
  const headings = ["run", "status", ...batch.parameters.map(({ key }) => key), ...batch.measurements.map(({ name, unit }) => label_of(words_of(name), unit))];
  add_runs(by_id("tables"), headings, batch.runs.map((run) => [
    run.name, run.status,
    ...batch.parameters.map(({ key }) => run.parameters[key] ?? ""),
    ...batch.measurements.map(({ name }) => (run.measurements[name] ?? null) === null ? "" : number_text(run.measurements[name])),
  ]));
}
