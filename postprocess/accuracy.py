"""Histograms and tables of docs/accuracy.md from the table that tests/stability/accuracy_map writes.

    postprocess/accuracy.py docs/reliability/accuracy.csv docs
"""

import argparse
import csv
import statistics
from pathlib import Path

import matplotlib

from common import UserError  # its hook shows errors without a traceback

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402  (the backend must be chosen first)

KINDS = {
    "history": "history of F_T",
    "peak": "peak of F_T",
    "slip": "S by eq. (4)",
    "coupled": "S of the caisson that slips as a whole",
    "contact_slip": "S of contact node by node",
}
SURE = 0.2  # the last refinement of the truth must have changed it by less than this share of the error
BEGIN, END = "<!-- made by postprocess/accuracy.py -->", "<!-- end -->"


def number(text):
    return float(text) if text else None


def judged(row, kind):
    """The estimated and the true error; None if there is no estimate."""
    told, error = number(row[kind + "_told"]), number(row[kind + "_error"])
    return None if told is None else (told, error)


def is_sure(row, kind, error):
    moved = {"history": "truth_history", "peak": "truth_peak"}.get(kind)
    return moved is None or float(row[moved]) <= SURE * error


def facts(rows, kind):
    pairs = [(row, *pair) for row in rows if (pair := judged(row, kind))]
    moving = [(row, told, error) for row, told, error in pairs if error > 0 and told > 0]
    return {
        "kind": KINDS[kind],
        "told": len(pairs),
        "bounded": sum(told >= error for _, told, error in pairs),
        "unsure": sum(not is_sure(row, kind, error) for row, _, error in moving),
        "ratios": [told / error for _, told, error in moving],
    }


def table(rows):
    lines = ["| | scenes | bounded | share | median of estimate / error | 5 %, 95 % | truth not sure to a fifth |", "|---|---:|---:|---:|---:|---:|---:|"]
    for kind in KINDS:
        f = facts(rows, kind)
        if not f["told"]:
            continue
        ratios = sorted(f["ratios"])
        low, high = (ratios[min(int(part * len(ratios)), len(ratios) - 1)] if ratios else 0 for part in (0.05, 0.95))
        median = f"{statistics.median(ratios):.2f}" if ratios else "-"
        lines.append(
            f"| {f['kind']} | {f['told']} | {f['bounded']} | {100 * f['bounded'] / f['told']:.1f} % | {median} "
            f"| {low:.2f}, {high:.1f} | {f['unsure']} |"
        )
    return lines


def account(rows):
    answered = [row for row in rows if not row["refused"]]
    unknowns = sorted(int(row["unknowns"]) for row in answered)
    seconds = sorted(float(row["seconds"]) for row in answered)
    met = [row for row in answered if float(row[row["of"] + "_error"]) <= float(row["tolerance"])]
    seeds = list(dict.fromkeys(row["seed"] for row in rows))
    return [
        f"{len(rows)} scenes of seed{'s' if len(seeds) > 1 else ''} {', '.join(seeds)}, {len(rows) - len(answered)} refused; the error asked for was "
        f"met in {len(met)} of {len(answered)}. Unknowns: median {statistics.median(unknowns):,.0f}, most "
        f"{unknowns[-1]:,}; seconds on a busy core: median {statistics.median(seconds):.1f}, most {seconds[-1]:.0f}.",
        "",
    ], answered


def draw(rows, path):
    kinds = [kind for kind in KINDS if facts(rows, kind)["ratios"]][:4]
    figure, axes = plt.subplots(1, len(kinds), figsize=(3.2 * len(kinds), 2.8), sharey=False)
    edges = [10 ** (-1 + 0.1 * i) for i in range(31)]
    for ax, kind in zip(axes if len(kinds) > 1 else [axes], kinds):
        ratios = [min(max(ratio, edges[0]), edges[-1] * 0.999) for ratio in facts(rows, kind)["ratios"]]
        ax.hist(ratios, bins=edges, color="tab:blue")
        ax.axvline(1.0, color="tab:red", lw=1)
        ax.axvline(statistics.median(ratios), color="k", lw=1, ls=":")
        ax.set_xscale("log")
        ax.set_title(KINDS[kind].replace("F_T", "$F_T$").replace(" of the caisson that slips", ", slipping"), fontsize=9)
        ax.set_xlabel("estimate / error")
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("table", type=Path, help="written by accuracy_map")
    parser.add_argument("docs", type=Path, nargs="?", help="folder of accuracy.md and figures; else prints the tables")
    arguments = parser.parse_args()
    with arguments.table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows or not {"seed", "refused", "unknowns", "tolerance"} <= set(rows[0]):
        raise UserError(f"'{arguments.table}' is no table of accuracy_map: it has no rows with seed, refused, unknowns and tolerance")
    text, answered = account(rows)
    text += table(answered)
    if arguments.docs is None:
        print("\n".join(text))
        return
    draw(answered, arguments.docs / "figures" / "accuracy.png")
    page = arguments.docs / "accuracy.md"
    before, rest = page.read_text().split(BEGIN)
    page.write_text(before + BEGIN + "\n" + "\n".join(text) + "\n" + END + rest.split(END)[1])
    print(page)


if __name__ == "__main__":
    main()
