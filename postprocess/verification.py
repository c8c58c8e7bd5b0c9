"""Writes docs/reference/verification.md and its figures from the results of the verification tests.

    ctest -C long -L verification -E page      (in the build folder; writes build/verification/*.json)
    /usr/bin/python3 postprocess/verification.py build/verification docs
"""

import argparse
import json
import tomllib
from pathlib import Path

from common import UserError, save
from upbead import figures

PROBLEMS = Path(__file__).parent.parent / "tests/verification/problems.toml"
HEAD = """# Verification

Does the program solve its equations correctly? This page compares it with all exact solutions that we have. It is made from
the results of the tests by

    ctest -C long -L verification -E page
    /usr/bin/python3 postprocess/verification.py build/verification docs

so every number below is compared with the limit beside it whenever the tests run. An error is the largest over all points
and times. `full` is the full equations of Biot (`flow = "inertial"`), `upB` the u-p equations without the fluid's own
inertia (`flow = "darcy"`). The tables of exact solutions are in tests/reference; none was made with this program. The
equations are in [theory](../theory.md). Whether they describe a breakwater is another question (validation), which this page
does not answer.
"""


def read_results(folder):
    """The records of all tests, by problem."""
    if not folder.is_dir():
        raise UserError(f"there is no folder '{folder}'; run 'ctest -C long -L verification' in the build folder first")
    problems = {}
    for path in sorted(folder.glob("*.json")):
        record = json.loads(path.read_text())
        problems.setdefault(record["problem"], []).append(record)
    if not problems:
        raise UserError(f"'{folder}' holds no results; run 'ctest -C long -L verification' in the build folder first")
    return problems


def holds(check):
    """Whether a check is met; a check whose value is NaN is not."""
    value, limit = check["value"], check["limit"]
    if check["kind"] == "measured":
        return True
    if value is None:
        return False
    return value <= limit if check["kind"] == "at_most" else value >= limit


def number(value, is_order):
    if value is None:
        return "not finite"
    return f"{value:.2f}" if is_order else f"{value:.1e}"


def row(check):
    is_order = check["kind"] == "at_least"
    value = number(check["value"], is_order)
    if check["kind"] == "measured":
        return f"| {check['what']} | {value} | measured only |"
    sign = "at least " if is_order else ""
    failed = "" if holds(check) else " **not met**"
    return f"| {check['what']} | {value} | {sign}{check['limit']:g}{failed} |"


def table(checks):
    return ["| compared | found | limit |", "|---|---:|---:|"] + [row(check) for check in checks]


def summary_row(key, problem, records):
    """One line of the overview: the number of checks, of those not met, and the largest error over its limit."""
    checks = [c for r in records for c in r["checks"] if c["kind"] != "measured"]
    errors = [c for c in checks if c["kind"] == "at_most" and c["value"] is not None]
    closest = max((c["value"] / c["limit"] for c in errors if c["limit"] > 0), default=None)
    missed = sum(not holds(c) for c in checks)
    return (
        f"| [{problem['title']}](#{anchor(problem['title'])}) | {len(checks)} | {missed or 'none'} |"
        f" {'' if closest is None else f'{100 * closest:.0f} %'} |"
    )


def anchor(title):
    kept = "".join(c for c in title.lower() if c.isalnum() or c in " -_")
    return kept.replace(" ", "-")


def draw(records, path):
    """One figure for a problem; False where it has no curves."""
    figure = figures.verification(records)
    if figure is not None:
        save(figure, path)
    return figure is not None


def section(key, problem, records, figures):
    lines = [f"## {problem['title']}", "", problem["text"], "", f"Source: {problem['source']}.", ""]
    if draw(records, figures / f"{key}.png"):
        lines += [f"![Exact solution as lines between its tabulated points, computed as dots](../figures/verification/{key}.png)", ""]
    return lines + table([check for record in records for check in record["checks"]]) + [""]


def write(results, docs):
    problems = tomllib.loads(PROBLEMS.read_text())
    found = read_results(results)
    if unknown := sorted(set(found) - set(problems)):
        raise UserError(f"'{PROBLEMS.name}' does not know the problems {', '.join(unknown)}; give them a table there")
    figures = docs / "figures/verification"
    figures.mkdir(parents=True, exist_ok=True)
    present = {key: problem for key, problem in problems.items() if key in found}
    lines = [HEAD, "| problem | checks | not met | closest to its limit |", "|---|---:|---:|---:|"]
    lines += [summary_row(key, problem, found[key]) for key, problem in present.items()]
    lines.append("")
    for key, problem in present.items():
        lines += section(key, problem, found[key], figures)
    (docs / "reference").mkdir(exist_ok=True)
    (docs / "reference/verification.md").write_text("\n".join(lines).rstrip() + "\n")
    print(docs / "reference/verification.md")
    for key in problems:
        if key not in found:
            print(f"no results of {key}")


def rows_of(lines):
    """The claims of a page: each compared quantity with its limit, without the results, which change by round-off."""
    cells = [line.strip("|").split(" | ") for line in lines if line.startswith("| ") and line.count(" | ") == 2]
    return {(what.strip(), limit.strip()) for what, _, limit in cells}


def check(results, docs):
    """Raises an error that lists where the page and the tests differ, or where a limit is not met."""
    checks = [c for records in read_results(results).values() for r in records for c in r["checks"]]
    path = docs / "reference/verification.md"
    if not path.is_file():
        raise UserError(f"there is no '{path}'; make it with this script, without --check")
    claimed, tested = rows_of(path.read_text().splitlines()), rows_of(row(c) for c in checks)
    claimed.discard(("compared", "limit"))
    missing = [f"only in the tests: {what}" for what, _ in sorted(tested - claimed)]
    missing += [f"only on the page: {what}" for what, _ in sorted(claimed - tested)]
    missing += [f"not met: {c['what']}" for c in checks if not holds(c)]
    if missing:
        raise UserError(f"'{path}' is not what the tests found; make it anew\n  " + "\n  ".join(missing))
    print(f"{path}: {len(tested)} rows agree with the tests")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path, help="folder of the tests' records: build/verification")
    parser.add_argument("docs", type=Path, help="folder to write verification.md and figures/verification to: docs")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where the page and the tests differ")
    arguments = parser.parse_args()
    (check if arguments.check else write)(arguments.results, arguments.docs)


if __name__ == "__main__":
    main()
