#!/usr/bin/python3
"""Writes the tables of docs/evaluation.md from the JSON of `shapelets evaluate`.

    evaluation_tables.py RESULTS docs/evaluation.md

RESULTS holds method_*.json and ablation_*.json from scripts/evaluate.sh. A table stands between the lines
`<!-- table NAME -->` and `<!-- end -->`. A table without results says so.
"""

import json
import pathlib
import re
import statistics
import sys

METHODS = ["kmeans", "udfs", "kshape", "uslm", "nn_stne_paper", "nn_stne"]
OTHERS = ["kmeans", "udfs", "kshape", "uslm"]
# The paper's own figures for K-means, UDFS and NN-STNE.
PAPER = {
    "ECG200": (0.60, 0.55, 0.70),
    "CBF": (0.74, 0.73, 0.93),
    "FaceFour": (0.74, 0.73, 0.81),
    "OSULeaf": (0.76, 0.76, 0.76),
    "switch push": (0.74, 0.74, 1.00),
}
DEVELOPMENT = (
    "ECG200 CBF FaceFour OSULeaf ArrowHead BeetleFly Car DistalPhalanxTW FaceAll Ham ItalyPowerDemand Meat MoteStrain "
    "SwedishLeaf"
).split() + ["switch push"]


class Scores:
    """Rand indices of methods on data sets."""

    def __init__(self, paths):
        self._runs = {}
        for path in paths:
            for run in json.loads(path.read_text()):
                self._runs.setdefault((run["method"], run["dataset"]), []).append(run)

    def data_sets(self):
        return sorted({data_set for _, data_set in self._runs}, key=str.lower)

    def methods(self):
        return {method for method, _ in self._runs}

    def has(self, method, data_set):
        return (method, data_set) in self._runs

    def seeds(self):
        return max(len(runs) for runs in self._runs.values())

    def values(self, method, data_set, part):
        return [run[part]["rand_index"] for run in self._runs[method, data_set]]

    def mean(self, method, data_set, part):
        return statistics.mean(self.values(method, data_set, part))

    def better(self, method, data_set):
        """Returns the better mean of nearest centroid and clustered anew."""
        return max(self.mean(method, data_set, "test"), self.mean(method, data_set, "test_anew"))

    def seconds(self, method, data_sets):
        """Returns the mean seconds of learning and the mean milliseconds of the features of one series."""
        runs = [run for name in data_sets if self.has(method, name) for run in self._runs[method, name]]
        return (
            statistics.mean(run["fit_seconds"] for run in runs),
            statistics.mean(run["transform_ms_per_series"] for run in runs),
        )


def average(values):
    """Returns the mean, or None if a value is missing, because averages over different data sets do not compare."""
    values = list(values)
    return statistics.mean(values) if values and None not in values else None


def text(value, form="{:.2f}"):
    return "" if value is None else form.format(value)


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|---" * len(header) + "|"]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]


def better_or_none(scores, method, data_set):
    return scores.better(method, data_set) if scores.has(method, data_set) else None


def paper_table(scores):
    """Returns the paper's rows: nearest centroid / clustered anew of every method, and the paper's figures."""
    rows = []
    for data_set, figures in PAPER.items():
        cells = []
        for method in METHODS:
            cells.append(
                " / ".join(text(scores.mean(method, data_set, part)) for part in ("test", "test_anew"))
                if scores.has(method, data_set)
                else ""
            )
        rows.append([data_set] + cells + [text(figure) for figure in figures])
    averages = [text(average(better_or_none(scores, method, name) for name in PAPER)) for method in METHODS]
    rows.append(
        ["average of the better"] + averages + [text(average(row[index] for row in PAPER.values())) for index in range(3)]
    )
    header = ["data"] + METHODS + ["paper: kmeans", "paper: udfs", "paper: nn_stne"]
    return table(header, rows)


def spread_table(scores):
    """Returns mean, standard deviation and best over the seeds, on the paper's rows."""
    rows = []
    for data_set in PAPER:
        for part, name in (("train", "train"), ("test", "nearest centroid"), ("test_anew", "clustered anew")):
            cells = []
            for method in METHODS:
                if not scores.has(method, data_set):
                    cells.append("")
                    continue
                values = scores.values(method, data_set, part)
                spread = statistics.stdev(values) if len(values) > 1 else 0.0
                cells.append(f"{statistics.mean(values):.3f} ± {spread:.3f} ({max(values):.3f})")
            rows.append([data_set, name] + cells)
    return table(["data", "score"] + METHODS, rows)


def all_table(scores, development):
    """Returns the better of the two means on test for every data set of one side of the split."""
    names = [name for name in scores.data_sets() if (name in DEVELOPMENT) == development]
    rows = [[name] + [text(better_or_none(scores, m, name), "{:.3f}") for m in METHODS] for name in names]
    rows.append(
        ["**average**"] + [text(average(better_or_none(scores, m, name) for name in names), "{:.3f}") for m in METHODS]
    )
    return table(["data"] + METHODS, rows)


def margin_table(scores):
    """Returns how far nn_stne is ahead of the best other method, and on which data set it is least ahead of K-means."""
    archive = [name for name in scores.data_sets() if name != "switch push" and scores.has("nn_stne", name)]
    rows = []
    for side, names in (
        ("all sets of the archive", archive),
        ("development", [name for name in archive if name in DEVELOPMENT]),
        ("confirmation", [name for name in archive if name not in DEVELOPMENT]),
    ):
        if not names:
            continue
        own = average(scores.better("nn_stne", name) for name in names)
        others = {m: average(better_or_none(scores, m, name) for name in names) for m in OTHERS}
        others = {method: value for method, value in others.items() if value is not None}
        best = max(others, key=others.get)
        worst = min(names, key=lambda name: scores.better("nn_stne", name) - scores.better("kmeans", name))
        least = scores.better("nn_stne", worst) - scores.better("kmeans", worst)
        rows.append(
            [f"{side} ({len(names)})", f"{own:.3f}", f"{best} {others[best]:.3f}", f"{own - others[best]:+.3f}",
             f"{worst} {least:+.3f}"]
        )
    return table(["data sets", "nn_stne", "best other", "ahead by", "least ahead of kmeans"], rows)


def udfs_table(scores):
    """Returns UDFS with each size of the neighbourhood, and the best per data set, which needs the labels to choose."""
    sizes = {"udfs": 5}
    for method in scores.methods():
        found = re.fullmatch(r"udfs_k(\d+)", method)
        if found:
            sizes[method] = int(found.group(1))
    methods = sorted(sizes, key=sizes.get)
    names = list(PAPER)
    rows = []
    for name in names:
        values = [better_or_none(scores, method, name) for method in methods]
        best = max((value for value in values if value is not None), default=None)
        rows.append([name] + [text(value) for value in values] + [text(best)])
    return table(["data"] + [f"k = {sizes[method]}" for method in methods] + ["best k"], rows)


def time_table(scores):
    rows = []
    for method in METHODS:
        if method not in scores.methods():
            continue
        seconds, milliseconds = scores.seconds(method, scores.data_sets())
        rows.append([method, f"{seconds:.2f}", f"{milliseconds:.3f}"])
    return table(["method", "learning [s]", "features of a series [ms]"], rows)


def ablation_table(scores, folder):
    """Returns scores of nn_stne with one ingredient changed at a time: the better of the two on test, then the averages
    of that and of the nearest centroid alone over the development sets."""

    def nearest_or_none(variant, data_set):
        return variant.mean("nn_stne", data_set, "test") if variant.has("nn_stne", data_set) else None

    rows = []
    variants = [("default", scores)]
    for path in sorted(folder.glob("ablation_*.json")):
        variants.append((path.stem.replace("ablation_", "").replace("_", " "), Scores([path])))
    reference = None
    for name, variant in variants:
        values = [better_or_none(variant, "nn_stne", data_set) for data_set in PAPER]
        side = average(better_or_none(variant, "nn_stne", data_set) for data_set in DEVELOPMENT)
        nearest = average(nearest_or_none(variant, data_set) for data_set in DEVELOPMENT)
        reference = side if reference is None else reference
        difference = None if None in (side, reference) else side - reference
        cells = [text(value, "{:.3f}") for value in values + [side]]
        rows.append([name] + cells + [text(difference, "{:+.3f}"), text(nearest, "{:.3f}")])
    return table(["variant"] + list(PAPER) + ["all development sets", "difference", "nearest centroid alone"], rows)


def main():
    folder = pathlib.Path(sys.argv[1])
    page = pathlib.Path(sys.argv[2])
    scores = Scores(sorted(folder.glob("method_*.json")))
    makers = {
        "paper": lambda: paper_table(scores),
        "spread": lambda: spread_table(scores),
        "development": lambda: all_table(scores, True),
        "confirmation": lambda: all_table(scores, False),
        "margin": lambda: margin_table(scores),
        "udfs": lambda: udfs_table(scores),
        "time": lambda: time_table(scores),
        "ablation": lambda: ablation_table(scores, folder),
    }

    def replaced(match):
        needs_own = match.group(1) in ("margin", "ablation") and "nn_stne" not in scores.methods()
        lines = ["Not computed yet."] if needs_own else makers[match.group(1)]()
        return "\n".join([f"<!-- table {match.group(1)} -->"] + lines + ["<!-- end -->"])

    page.write_text(re.sub(r"<!-- table (\w+) -->\n.*?<!-- end -->", replaced, page.read_text(), flags=re.DOTALL))
    print(f"{page}: tables of {len(scores.data_sets())} data sets, {scores.seeds()} seeds", file=sys.stderr)


if __name__ == "__main__":
    main()
