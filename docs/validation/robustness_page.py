"""The page and the picture of robustness.py."""
import collections
import itertools
import math

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

head = """# Robustness

What happens off the shipped settings? [robustness.py](robustness.py) runs families of cases, each a shipped case with other spacings, loads,
shapes, remeshing and smoothing kernels, as [robustness_families.py](robustness_families.py) lists them. It needs many hours for all of them,
does those first that differ from the default in one axis only, and can be stopped and continued:

    docs/validation/robustness.py --hours 2 [--cases NAME ...]

Each run is judged by its reference: converged finite elements, beam theory, a conserved quantity; or, where there is none, by the finest run
of the same load and shape with default settings. It is right when its figure is within the tolerance (2 to 6 %; a period within 3 %; 10
to 15 % of the energy where a body oscillates or collides) and no more than 5 % of the energy was created without work.
A figure that is wrong has to come with a warning, or the run has to stop with a message: the column in bold must be empty.

| verdict | meaning |
| --- | --- |
| right | within the tolerance |
| right, warned | within the tolerance, and a warning was shown |
| wrong, warned | outside, and a warning was shown |
| stopped | the run ended by itself with a message |
| no value | the measurement has no value, and says why |
| not judged | the run that it is compared with has not been made |
| wrong without a word | outside, and nothing was said |

These are the runs made so far; [robustness.csv](robustness.csv) holds them one by one.
"""

colours = {"right": "#2e8b57", "right, warned": "#a6d9a6", "wrong, warned": "#f0c040",
           "stopped": "#d08770", "no value": "#b48ead", "not judged": "#dddddd", "wrong": "#c00020"}


def text_of(row):
    labels = [row[c] for c in sorted(row) if c.startswith("axis") and row[c]]
    return ", ".join(label.split(": ", 1)[1] if ": " in label else label for label in labels)


def axes_of(rows):
    """The labels of each axis of a family, in the order of the rows."""
    axes = collections.OrderedDict()
    for row in rows:
        for column in sorted(c for c in row if c.startswith("axis") and row[c]):
            axis, label = row[column].split(": ", 1)
            axes.setdefault(axis, []).append(label)
    return {axis: list(dict.fromkeys(labels)) for axis, labels in axes.items()}


def labels_of(row):
    return dict(row[c].split(": ", 1) for c in row if c.startswith("axis") and row[c])


def size_of(spacing):
    """A spacing as a number, to put the coarsest first."""
    if spacing.endswith("across"):
        return 1 / float(spacing.split()[0])
    return eval(spacing, {"sqrt": math.sqrt, "pi": math.pi})  # written in robustness_families.py


def draw(panel, rows, axes, others, shape, is_first):
    """Runs of one shape: spacings along x in each load, the other choices along y."""
    spacings = sorted(axes["spacing"], key=size_of, reverse=True)
    loads = axes["load"]
    ticks = [(i * (len(spacings) + 0.7) + j, spacing) for i in range(len(loads))
             for j, spacing in enumerate(spacings)]
    for row in rows:
        labels = labels_of(row)
        if labels["shape"] == shape:
            x = loads.index(labels["load"]) * (len(spacings) + 0.7) + spacings.index(labels["spacing"])
            y = others.index(tuple(labels[a] for a in labels if a not in ("spacing", "load", "shape")))
            panel.scatter([x], [-y], marker="s", s=40, c=colours[row["verdict"]], linewidths=0)
    panel.set_xticks([x for x, _ in ticks], [text for _, text in ticks], rotation=90, fontsize=6)
    panel.set_yticks([-y for y in range(len(others))],
                     [", ".join(other) for other in others] if is_first else [""] * len(others), fontsize=6)
    panel.set_xlim(-0.7, ticks[-1][0] + 0.7)
    panel.set_ylim(-len(others) + 0.3, 0.7)
    for i, load in enumerate(loads):
        panel.text(i * (len(spacings) + 0.7) + (len(spacings) - 1) / 2, 0.8, f"load {load}", fontsize=6,
                   ha="center", va="bottom")
    panel.set_title(shape, fontsize=7, pad=14)


def picture(by_family, file):
    """A square for each run made: a row of panels for each family, a panel for each shape."""
    heights = []
    for rows in by_family.values():
        axes = axes_of(rows)
        count = math.prod(len(axes[a]) for a in axes if a not in ("spacing", "load", "shape"))
        heights.append(1.35 + 0.16 * count)
    figure = plt.figure(figsize=(13, sum(heights) + 0.5), layout="constrained")
    parts = figure.subfigures(len(heights) + 1, 1, height_ratios=[*heights, 0.5])
    for part, (family, rows) in zip(parts, by_family.items()):
        axes = axes_of(rows)
        others = list(itertools.product(*(axes[a] for a in axes if a not in ("spacing", "load", "shape"))))
        panels = part.subplots(1, 3, squeeze=False)[0]
        part.suptitle(family, fontsize=9, x=0.01, ha="left")
        for panel in panels[len(axes["shape"]):]:
            panel.axis("off")
        for i, (panel, shape) in enumerate(zip(panels, axes["shape"])):
            draw(panel, rows, axes, others, shape, i == 0)
    handles = [plt.Line2D([], [], marker="s", linestyle="", color=c,
                          label="wrong without a word" if v == "wrong" else v)
               for v, c in colours.items()]
    parts[-1].legend(handles=handles, loc="center", ncols=len(handles), fontsize=8)
    figure.savefig(file, dpi=70)
    plt.close(figure)


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def write(rows, counts, folder):
    by_family = collections.OrderedDict()
    for row in rows:
        by_family.setdefault(row["family"], []).append(row)
    picture(by_family, folder / "robustness.png")
    total, summary = collections.Counter(), []
    for family, count in counts.items():
        verdicts = collections.Counter(row["verdict"] for row in by_family.get(family, []))
        total += verdicts
        commits = dict.fromkeys(row["commit"] for row in by_family.get(family, []))
        summary.append([family, ", ".join(commits), f"{sum(verdicts.values())} of {count}",
                        *(verdicts[v] or "" for v in colours)])
    summary.append(["all", "", f"{sum(total.values())} of {sum(counts.values())}",
                    *(total[v] or 0 for v in colours)])
    columns = ["family", "commit", "runs", *("**wrong without a word**" if v == "wrong" else v for v in colours)]
    silent = [[row["family"], text_of(row), row["figure"], row["value"], row["right"], row["deviation"],
               row["energy created"]] for row in rows if row["verdict"] == "wrong"]
    text = head + "\n" + table(columns, summary) + "\n![Verdict of each run](robustness.png)\n\nA square for each run made: a panel for each shape, with the spacings, coarse to fine, in each load along x, and\nremeshing, kernel and other choices along y.\n"
    text += "\n## Wrong without a word\n\n"
    text += table(["family", "run", "figure", "value", "right", "deviation", "energy created"],
                  silent) if silent else "None of these runs.\n"
    (folder / "robustness.md").write_text(text)
