"""Pareto fronts of error against time, and the time at a given error on one."""

import math


def front(rows, error):
    """The rows that no other row beats in both wall time and error, fastest first."""
    found = []
    for row in sorted(rows, key=lambda row: (row["wall"], row[error])):
        if not found or row[error] < found[-1][error]:
            found.append(row)
    return found


def sure(rows, error):
    """Copies of the rows whose error is the largest of the run and of all finer ones of its family.

    An error of a mesh may cancel that of a step, and that of a peak passes zero on its way. Without the exact
    solution nobody can choose such a run, so its small error does not count.
    """
    def finer(a, b):  # 0 steps: exact in time
        in_time = a["steps"] == 0 or 0 < b["steps"] <= a["steps"]
        return a["family"] == b["family"] and a["unknowns"] >= b["unknowns"] and in_time

    return [{**row, error: max(other[error] for other in rows if finer(other, row))} for row in rows]


def time_at(rows, error, target):
    """Seconds to reach the target on the front of the rows, by straight lines in log-log; None if they never do.

    If the fastest run is already more accurate than the target, its time counts, as no faster run is known.
    """
    points = front(rows, error)
    if not points or points[-1][error] > target:
        return None
    if points[0][error] <= target:
        return points[0]["wall"]
    for fast, slow in zip(points, points[1:]):
        if slow[error] <= target:
            part = math.log(target / fast[error]) / math.log(slow[error] / fast[error])
            return fast["wall"] * (slow["wall"] / fast["wall"]) ** part


def mark(rows, errors=("peak_error", "history_error")):
    """Adds to each row for which errors it is on the front: row["front"] = ["peak_error", ...]."""
    for row in rows:
        row["front"] = []
    for error in errors:
        for row in front(rows, error):
            row["front"].append(error)
