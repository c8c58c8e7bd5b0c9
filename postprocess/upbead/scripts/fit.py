"""Fits keys of a case to a measured record, to measured natural frequencies and damping, or to both, with confidence.

usage: fit.py CASE --record lab.csv --column F_T --parameter regions.seabed.shear_modulus
              --parameter regions.seabed.damping.ratio=0.05 --tie regions.mound.shear_modulus=1.667*regions.seabed.shear_modulus
       fit.py CASE --frequency 1.20:0.03 --damping 0.031:0.006 --parameter regions.seabed.shear_modulus

A parameter begins with the case's value, with KEY=GUESS, or anywhere in KEY=LOW:HIGH; all SI units. Writes fit.json,
fit.csv (time, record, first guess, fit; with a record), fit.png and with --posterior posterior.csv (a row for each point of
the chain) into a folder. docs/fit.md explains the meaning of the numbers.
"""

import argparse
import csv
import json
import tomllib
from pathlib import Path

from ..errors import UserError
from ..kept import keep_inputs
from .. import figures, fit
from . import ending
from .figure import save


WRITTEN = ("fit.json", "fit.csv", "fit.png", "posterior.csv")


def pairs(texts, what):
    """{key: text} of KEY=TEXT."""
    for text in texts:
        if "=" not in text:
            raise UserError(f"--{what} {text}: write KEY=...")
    return dict(text.split("=", 1) for text in texts)


def guess(text):
    """A number, or the (low, high) of LOW:HIGH."""
    try:
        ends = tuple(map(float, text.split(":")))
    except ValueError as error:
        raise UserError(f"'{text}' is no first guess; write a number or LOW:HIGH") from error
    return ends[0] if len(ends) == 1 else ends


def mode(text):
    """(value, standard deviation) of VALUE:STANDARD_DEVIATION, followed by N if @N is given; None for "none"."""
    if text == "none":
        return None
    pair, _, rank = text.partition("@")
    try:
        value, uncertainty = map(float, pair.split(":"))
        return (value, uncertainty, int(rank)) if rank else (value, uncertainty)
    except ValueError as error:
        raise UserError(f"'{text}' is no measured mode; write VALUE:STANDARD_DEVIATION, as --frequency 1.20:0.03, and @2 behind it "
                        "for the second mode by the first guess") from error


def toml(text):
    """A value as read by --set of the program; a text that is no TOML is a word."""
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", type=Path)
    parser.add_argument("--record",
                        help="CSV (units in the header, .gz) or HDF5, times first; or NAME of [measured.NAME]")
    parser.add_argument("--column", help="of the record (default: the one after the time)")
    parser.add_argument("--unit", help="of the column, in place of its header")
    parser.add_argument("--reading", help="what was measured, a path below /history (default: shear_force)")
    parser.add_argument("--frequency", action="append", default=[], metavar="HZ:SD[@N]",
                        help="measured, with its standard deviation; of the N-th of `periods` by the first guess; repeatable")
    parser.add_argument("--damping", action="append", default=[], metavar="RATIO:SD",
                        help="the n-th is of the n-th frequency; none: not measured; repeatable")
    parser.add_argument("--parameter", action="append", required=True, metavar="KEY[=GUESS|=LOW:HIGH]",
                        help="key to fit; repeatable")
    parser.add_argument("--tie", action="append", default=[], metavar="KEY=FACTOR*KEY", help="goes along; repeatable")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="further keys of the case; repeatable")
    parser.add_argument("--start", type=float, default=0.0, metavar="S", help="time of the record that is t = 0 of the run")
    parser.add_argument("--zero", type=float, default=0.0, metavar="S", help="so much of the record's beginning is at rest")
    parser.add_argument("--noise", type=float, help="standard deviation of a sample (SI; default: by the residual)")
    parser.add_argument("--posterior", type=int, metavar="N",
                        help="sample the posterior by N evaluations, some thousands; each is a run, if there is no --model")
    parser.add_argument("--model", type=Path, help="soils.h5 of the case, by 'upbead reduce --soils', which answers in place of runs")
    parser.add_argument("--also", action="append", default=[], metavar="NAME",
                        help="a further record of the posterior, [measured.NAME] of the case; repeatable")
    parser.add_argument("--checks", type=int, default=20, metavar="N",
                        help="points of the posterior by --model that are answered again by runs (default: %(default)s)")
    parser.add_argument("--jobs", type=int, default=2, help="runs at once (default: %(default)s)")
    parser.add_argument("--out", type=Path, metavar="DIR", help="folder (default: results/NAME-fit)")
    return parser.parse_args()


def main() -> None:
    ending.watch()
    options = parse()
    parameters = {text.split("=")[0]: guess(text.split("=", 1)[1]) if "=" in text else None for text in options.parameter}
    folder = options.out or Path("results") / f"{options.case.stem}-fit"
    for name in WRITTEN:
        keep_inputs(folder / name, options.case, *([options.record] if options.record else []), *([options.model] if options.model else []))
    found = fit(options.case, options.record, options.reading, parameters, pairs(options.tie, "tie"), column=options.column,
                unit=options.unit, start=options.start, zero=options.zero, noise=options.noise, jobs=options.jobs,
                frequencies=[mode(text) for text in options.frequency], dampings=[mode(text) for text in options.damping],
                posterior=options.posterior, model=options.model, also=options.also, checks=options.checks,
                set={key: toml(text) for key, text in pairs(options.set, "set").items()})
    print(found)
    print(" ".join(["run it with", *(f"--set {key}={value:.6g}" for key, value in found.settings.items())]))
    write(found, folder)


def write(found, folder):
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "fit.json").write_text(json.dumps(found.summary(), indent=2) + "\n", encoding="utf-8")
        if found.time.size:
            write_histories(found, folder)
        if found.posterior:
            write_sample(found.posterior, folder)
    except OSError as error:
        raise UserError(f"cannot write to '{folder}': {error}") from error
    save(figures.fit(found), folder / "fit.png")


def write_histories(found, folder):
    with open(folder / "fit.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["time (s)", *(f"{name} ({found.record.unit})" for name in ("record", "first guess", "fit"))])
        writer.writerows(zip(*(map(float, column) for column in (found.time, found.record, found.first, found.computed))))


def write_sample(posterior, folder):
    with open(folder / "posterior.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(posterior.keys)
        writer.writerows([f"{value:.8g}" for value in row] for row in posterior.sample)
