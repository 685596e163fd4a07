#!/usr/bin/python3
"""Prints the benchmark program's output as one table, with a row on how fast the offline program classifies a bag."""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import rosbag

REFERENCES = {
    "KernelAgainstFftw": "planned single-precision FFTW per window",
    "UnprunedKernelAgainstPeak": "as many multiply-adds at this machine's peak",
    "KernelAgainstNaiveLoop": "a naive loop of the definition, -O3",
    "DefaultTrainingAgainstFftw": "its matches alone by FFTW, extrapolated from 7 pushes",
    "FeaturesOfOneEpisode": "the same features by FFTW",
    "TrainingOfTenTimesAsMany": "training of a tenth of the episodes",
}


def rows_of(path):
    """Yields one row for each benchmark in the program's JSON output."""
    for entry in json.loads(pathlib.Path(path).read_text())["benchmarks"]:
        if "reference_seconds" not in entry:
            raise SystemExit(f"{entry['name']}: {entry.get('error_message', 'it gave no times')}")
        name = re.sub(r"/(iterations|manual_time)[^/]*", "", entry["name"])
        row = {
            "name": name,
            "seconds": entry["seconds"],
            "reference": REFERENCES[name.split("/")[0]],
            "reference_seconds": entry["reference_seconds"],
            "ratio": entry["reference_seconds"] / entry["seconds"],
        }
        for extra in ("p99_seconds", "shapelets", "shortest", "longest", "peak_gigabytes"):
            if extra in entry:
                row[extra] = entry[extra]
        yield row


def classify_row(program, bags):
    """Times the offline program, its start included, on the raw bag and compares it with the bag's duration."""
    raw = bags / "switch_push_raw.bag"
    with rosbag.Bag(str(raw)) as bag:
        duration = bag.get_end_time() - bag.get_start_time()
    with tempfile.TemporaryDirectory() as folder:
        model = str(pathlib.Path(folder) / "model.bag")
        quiet = {"check": True, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        subprocess.run([program, "train", str(bags / "switch_push_train.bag"), "--model", model], **quiet)
        times = []
        for _ in range(5):
            start = time.monotonic()
            subprocess.run([program, "classify", str(raw), "--model", model], **quiet)
            times.append(time.monotonic() - start)
    seconds = sorted(times)[len(times) // 2]
    return {"name": "ClassifyOfARawBag", "seconds": seconds, "reference": "the bag's duration",
            "reference_seconds": duration, "ratio": duration / seconds}


def main():
    """Prints the table and writes the JSON file."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results")
    parser.add_argument("--program", required=True)
    parser.add_argument("--bags", type=pathlib.Path, required=True)
    parser.add_argument("--filter", default=".")
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    rows = list(rows_of(arguments.results))
    if re.search(arguments.filter, "ClassifyOfARawBag"):
        rows.append(classify_row(arguments.program, arguments.bags))
    print("| measure | seconds | reference | seconds | ratio | |")
    print("|---|---|---|---|---|---|")
    for row in rows:
        extras = ", ".join(f"{key} {value:.4g}" for key, value in row.items()
                           if key not in ("name", "seconds", "reference", "reference_seconds", "ratio"))
        print(f"| {row['name']} | {row['seconds']:.3g} | {row['reference']} | {row['reference_seconds']:.3g} "
              f"| {row['ratio']:.3g} | {extras} |")
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=2) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
