#!/usr/bin/python3
"""Draws docs/simulated_cell.png and docs/push_curves.png.

usage: draw_pictures.py FOLDER_OF_PROGRAMS DOCS

Needs python3-matplotlib, and the programs of cmake --build BUILD --target push_curves render_cell.
"""

import csv
import io
import os
import pathlib
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

OUTCOMES = ["switched", "already_on", "broken", "slipped_off", "collision", "missing"]
FORTH, HOLD, REACT, BACK = 2, 3, 4, 5


def draw_cell(programs, path):
    """Draws the views of the cell and of the switch side by side."""
    environment = {"EGL_PLATFORM": "surfaceless", **os.environ}
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.9))
    with tempfile.TemporaryDirectory() as folder:
        for axis, view in zip(axes, ["cell", "switch"]):
            picture = os.path.join(folder, view + ".ppm")
            subprocess.run([programs / "render_cell", view, picture], check=True, env=environment)
            axis.imshow(plt.imread(picture))
            axis.axis("off")
    figure.subplots_adjust(0.005, 0.01, 0.995, 0.99, wspace=0.01)
    figure.savefig(path, dpi=100, pil_kwargs={"optimize": True})


def read_curves(programs, seed):
    """Returns arrays per outcome: time, force, contact force, lever angle, phase."""
    text = subprocess.run([programs / "push_curves", str(seed)], check=True, capture_output=True, text=True).stdout
    curves = {outcome: [] for outcome in OUTCOMES}
    for row in csv.reader(io.StringIO(text)):
        if row[0] in curves:
            curves[row[0]].append([float(value) for value in row[1:]])
    return {outcome: numpy.array(rows).T for outcome, rows in curves.items()}


def first(condition, after=0):
    """Returns the index of the first true value from `after` on, or None."""
    indices = numpy.flatnonzero(condition[after:])
    return int(indices[0]) + after if len(indices) else None


def events(outcome, curve):
    """Returns the events of a push as (index, text), from the simulation's own state."""
    _, _, contact, lever, phase = curve
    touch = first(contact > 0.5)
    found = [(first(phase == FORTH), "moves")]
    if touch is not None:
        found.append((touch, "obstacle" if outcome == "collision" else "contact"))
    if outcome == "switched":
        snap = first(lever > 0.0)
        stop = first(lever > 0.95 * lever.max(), snap)
        found += [(snap, "snap"), (first(contact > 1.0, stop), "stop met")]
    if outcome == "slipped_off":
        quiet = numpy.convolve(contact[touch:] > 0.0, numpy.ones(100), "valid") == 0
        found.append((first(quiet, 1) + touch, "slips off"))
    if REACT in phase:
        found.append((first(phase == REACT), "force limit"))
    if outcome in ("switched", "already_on"):
        found.append((first(phase == HOLD), "hold"))
    found.append((first(phase == BACK), "back"))
    return [(index, text) for index, text in found if index is not None]


def draw_curves(curves, path):
    """Draws one panel per outcome and marks its events."""
    figure, axes = plt.subplots(3, 2, figsize=(10, 8), sharex=True)
    for axis, outcome in zip(axes.T.flat, OUTCOMES):
        time, force, _, lever, _ = curves[outcome]
        top = 1.45 * max(force.max(), 10.0)
        axis.plot(time, force, lw=0.8, color="tab:blue")
        axis.set(title=outcome, ylim=(0.0, top), xlim=(0.0, 4.33))
        angle = axis.twinx()
        if outcome != "missing":
            angle.plot(time, numpy.degrees(lever), lw=0.8, color="tab:green", alpha=0.7)
        angle.set(ylim=(-30.0, 90.0), yticks=[-28, 0, 28])
        angle.tick_params(colors="tab:green")
        for row, (index, text) in enumerate(events(outcome, curves[outcome])):
            axis.axvline(time[index], color="0.6", lw=0.6)
            height = top * (0.95 - 0.07 * (row % 6))
            axis.text(time[index] + 0.02, height, text, fontsize=7, va="top")
    for axis in axes[-1]:
        axis.set_xlabel("time [s]")
    figure.supylabel("tared force of the robot's estimate [N] (blue), lever angle [degrees] (green)", fontsize=9)
    figure.tight_layout()
    figure.savefig(path, dpi=90, pil_kwargs={"optimize": True})


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    programs, docs = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    draw_curves(read_curves(programs, 4), docs / "push_curves.png")
    draw_cell(programs, docs / "simulated_cell.png")


if __name__ == "__main__":
    main()
