"""Which soil decides: Sobol's indices of F_T/P, S and others by a model of soils, and a tornado diagram.

usage: sensitivity.py soils.h5 wave.csv [--of ratio --of sliding] [--samples 300] [--jobs 2] [--out DIR]

Soils are spread over the box of the model; SAMPLES x (2 + keys) soils are answered. Writes sensitivity.json,
sensitivity.png and sensitivity.csv (a row for each quantity and key) into a folder. docs/soils.md has the meaning.
"""

import argparse
import csv
import json
import os
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

from .. import SoilModel, figures, sensitivity
from ..kept import keep_inputs
from ..sensitivity import Sensitivity
from . import ending
from .figure import save

WRITTEN = ("sensitivity.json", "sensitivity.csv", "sensitivity.png")
LABELS = {"ratio": "peak $F_T$ / peak $P$", "sliding": "S (m)", "peak_shear": "peak $F_T$ (N/m)", "peak_heel_pressure": "heel pressure (Pa)"}
COLUMNS = ("quantity", "key", "first", "first_low", "first_high", "total", "total_low", "total_high", "at_low", "at_high")


def progress() -> Callable[[int, int], None]:
    """Tells on stderr how far it is, and how long it will take; nothing in the first second."""
    begun = time.monotonic()

    def told(done: int, of: int) -> None:
        passed = time.monotonic() - begun
        if passed > 1.0:
            end = "\n" if done == of or not sys.stderr.isatty() else "\r"
            print(f"{done:,} of {of:,} soils, {passed * (of - done) / done / 60:.1f} min left  ", end=end, file=sys.stderr, flush=True)

    return told


def rows(found: list[Sensitivity]) -> Iterator[tuple[object, ...]]:
    for of in found:
        for share in of.keys:
            first, total = share.first_interval or (None, None), share.total_interval or (None, None)
            yield (of.quantity, share.key, share.first, *first, share.total, *total, share.at_low, share.at_high)


def table(of: Sensitivity) -> list[str]:
    lines = [f"{of.quantity}: {of.value:.4g} by the case's soil" if of.value is not None else of.quantity]
    lines += [f"  over the box {of.mean:.4g}, standard deviation {of.deviation:.2g}; F_T's error at most {100 * of.largest_error:.2g} %"]
    if of.left_out:
        lines += [f"  {of.left_out} rows of soils left out: {of.why_left_out}"]
    if of.keys[0].total is None:
        return lines + ["  it does not vary"]
    lines += ["  share of the variance    alone   with interactions"]
    for share in sorted(of.keys, key=lambda key: -(key.total or 0.0)):
        assert share.first_interval and share.total_interval
        lines += [f"  {share.key:<40} {share.first:6.3f} ({share.first_interval[0]:.3f} to {share.first_interval[1]:.3f})"
                  f"  {share.total:6.3f} ({share.total_interval[0]:.3f} to {share.total_interval[1]:.3f})"]
    return lines


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", type=Path, help="soils.h5 of `upbead reduce --soils`")
    parser.add_argument("waves", nargs="+", help="a wave (.csv, .h5, a case), as `upbead respond` takes it")
    parser.add_argument("--of", action="append", metavar="NAME", help="a number of a wave's answer; may be given many times (default: ratio)")
    parser.add_argument("--samples", type=int, default=300, help="rows of the design (default: 300); the intervals narrow with its root")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="soils at once (default: one for each core)")
    parser.add_argument("--friction", type=float, help="as of `upbead respond`")
    parser.add_argument("--buoyant-weight", type=float, help="as of `upbead respond`, N/m")
    parser.add_argument("--out", type=Path, help="folder (default: that of the model)")
    return parser.parse_args()


def main() -> None:
    ending.watch()
    given = arguments()
    out = given.out or given.model.parent
    for name in WRITTEN:
        keep_inputs(out / name, given.model, *given.waves)
    with SoilModel(given.model, friction=given.friction, buoyant_weight=given.buoyant_weight, jobs=given.jobs) as model:
        found = sensitivity(model, given.waves, given.of or ["ratio"], samples=given.samples, seed=given.seed, told=progress())
        title = model.title
    out.mkdir(parents=True, exist_ok=True)
    (out / WRITTEN[0]).write_text(json.dumps([of.summary() for of in found], indent=2) + "\n")
    with open(out / WRITTEN[1], "w", newline="") as file:
        csv.writer(file).writerows([COLUMNS, *rows(found)])
    print("\n".join(line for of in found for line in table(of)))
    for name, text in {(name, text) for of in found for name, text in of.warnings.items()}:
        print(f"warning: {name}: {text}", file=sys.stderr)
    save(figures.sensitivity(found, LABELS, title), out / WRITTEN[2], given.model)

