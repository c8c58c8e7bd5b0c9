"""Problems of other people's programs, most with stored answers: peer, exact answer and ours side by side."""

import json
from pathlib import Path

import h5py

from . import peer_schemes, peer_theory
from .runs import CASES, run

FOLDER = CASES / "peers"
FINE = 1e-5  # differences below this share of the scale are shown as smaller than it


def answers():
    found = json.loads((FOLDER / "answers.json").read_text(encoding="utf-8"))
    for problem, scheme in peer_schemes.UNSTORED.items():
        for row in found[problem]["rows"]:
            row["peer"] = float(scheme(row))
    return found


def exact(problem, row):
    reading = row["reading"].rsplit("/", 1)[1]
    ways = {
        "aster-terzaghi": lambda: peer_theory.terzaghi(row["at"], row["time"]),
        "moose-mandel": lambda: peer_theory.mandel(reading, row["at"], row["time"]),
        "ogs-ramp": lambda: peer_theory.ramp(row["time"]),
        "pylith-terzaghi": lambda: peer_theory.compressible(row["at"], row["time"]),
        "aster-gravity": lambda: peer_theory.gravity(reading, row["at"]),
        "kratos-bar": lambda: peer_theory.bar(row["time"]) + answers()[problem]["base"],
        "aster-shear": lambda: peer_theory.bell(row["at"], row["time"]),
        "specfem-force": lambda: peer_theory.force(reading[-1], row["at"], row["time"]),
    }
    return ways[problem]()


def computed(program, problem, folder):
    """Our answers, one a row. Kratos' column is computed from its loaded state on, which is added."""
    known = answers()[problem]
    run(program, FOLDER / f"{problem}.toml", {}, folder)
    with h5py.File(Path(folder) / "results.h5") as file:
        times = list(file["at_times/time"][:])
        return [float(file[f"at_times/{row['reading']}"][nearest(times, row["time"])]) + known.get("base", 0.0) for row in known["rows"]]


def nearest(times, time):
    return min(range(len(times)), key=lambda number: abs(times[number] - time))


def compared(program, folder, only=None):
    """{problem: [{exact, ours, and differences over the problem's scale; again: computed on the other's mesh with its steps}]}"""
    found = {}
    for problem, known in answers().items():
        if only and problem not in only:
            continue
        ours = computed(program, problem, Path(folder) / problem)
        found[problem] = [differences(row["peer"], exact(problem, row), value, row.get("scale", known["scale"])) for row, value in zip(known["rows"], ours, strict=True)]
        if problem in peer_schemes.AGAIN:
            for row, line in zip(known["rows"], found[problem], strict=True):
                line["again - peer"] = (peer_schemes.AGAIN[problem](row) - row["peer"]) / row.get("scale", known["scale"])
    return found


def differences(peer, true, ours, scale):
    true = 0.0 if abs(true) < 1e-12 * scale else true
    return {"exact": true, "ours": ours, "peer - exact": (peer - true) / scale, "ours - exact": (ours - true) / scale, "ours - peer": (ours - peer) / scale}


def share(value):
    return f"{100 * value:+.2g} %" if abs(value) >= FINE else f"< {100 * FINE:g} %"


def worst(now, name):
    """Largest difference of all problems, in per cent."""
    return f"{100 * max(abs(row[name]) for rows in now.values() for row in rows):.2g}"


def largest(rows, name, without="not tried"):
    return share(max((row[name] for row in rows), key=abs)) if name in rows[0] else without


def summary(now):
    """Rows of the page: each problem with the largest differences."""
    return [
        (f"{known['name']} ([case](../cases/validation/peers/{problem}.toml))", known["program"], known["mesh"],
         *(largest(now[problem], name, "nothing stored" if problem in peer_schemes.UNSTORED else "not tried") for name in ("peer - exact", "again - peer", "ours - exact", "ours - peer")))
        for problem, known in answers().items()
    ]  # fmt: skip


def details(now):
    """Rows of the page: each value."""
    rows = []
    for problem, known in answers().items():
        for row, found in zip(known["rows"], now[problem], strict=True):
            rows.append((f"{known['program']}, {known['name']}", row["what"], f"{row['time']:.4g}", f"{found['exact']:.5g}", f"{row['peer']:.5g}", f"{found['ours']:.5g}",
                         share(found["peer - exact"]), share(found["ours - exact"]), share(found["ours - peer"])))  # fmt: skip
    return rows
