"""Time at equal error, and ratios to the best peer."""

from front import sure, time_at
from table import ERRORS, TARGETS

PEERS = ("FEniCSx", "FreeFEM")
LEAN = "lean upbead"  # its libraries inside, see packaging/
UPBEAD = ("upbead", "upbead, marched", LEAN)
PROGRAMS = {  # name: how its series begin
    "upbead": ("upbead",),
    "upbead, marched": ("upbead, sdirk4", "upbead, generalised_alpha"),
    LEAN: (LEAN,),
    "FEniCSx": ("FEniCSx",),
    "FEniCSx, uniform meshes": ("FEniCSx, uniform",),
    "FreeFEM": ("FreeFEM",),
    "FreeFEM, adaptmesh": ("FreeFEM, adaptmesh",),
    "FreeFEM, uniform meshes": ("FreeFEM, uniform",),
}


def of(rows, prefixes):
    return [row for row in rows if row["series"].startswith(prefixes)]


def fastest(times):
    known = [time for time in times if time is not None]
    return min(known) if known else None


def beyond_start(rows, floors):
    """The rows, less the time of a process of the same program that does nothing.

    A run that is no slower than such a process is left out: its own time is below the resolution of the clock. The
    target is then reached by a slower run, so this makes no program look faster.
    """
    found = [{**row, "wall": row["wall"] - floors[row["series"].split(",")[0]]} for row in rows]
    return [row for row in found if row["wall"] > 0]


def times_of(rows, error):
    """{program: [seconds per target]} and the ratios; None where a program does not reach the target."""
    rows = sure(rows, error)
    times = {name: [time_at(of(rows, prefixes), error, target) for target in TARGETS]
             for name, prefixes in PROGRAMS.items()}
    best = [fastest(pair) for pair in zip(*(times[peer] for peer in PEERS))]
    for name in UPBEAD:
        times[f"ratio best peer / {name}"] = [b / t if b and t else None for b, t in zip(best, times[name])]
    return times


def comparison(rows, floors):
    """{error: {"whole process": times, "beyond its start": times}}"""
    return {error: {"whole process": times_of(rows, error),
                    "beyond its own start": times_of(beyond_start(rows, floors), error)} for error in ERRORS}
