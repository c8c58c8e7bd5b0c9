"""Runs of a case with some of its keys changed, and designs of experiments over what a prediction assumes."""

import json
import math
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from common import UserError  # noqa: E402

CASES = Path(__file__).resolve().parents[2] / "cases/validation"
PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29)


def toml(value):
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {toml(part)}" for key, part in value.items()) + "}"
    return json.dumps(value) if isinstance(value, (str, list)) else repr(value)


def run(program, case, keys, folder):
    """Summary of a run of `case`, whose other files are in `folder`."""
    words = [word for key, value in keys.items() for word in ("--set", f"{key}={toml(value)}")]
    done = subprocess.run([program, "run", case, *words, "--out", folder, "--json"], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 3):  # 3: a check fails, which is no mistake of the run
        raise UserError(f"{case} with {keys}: {done.stderr}")
    return json.loads(done.stdout)


def side_by_side(task, inputs, jobs=2):
    with ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(task, range(len(inputs)), inputs))


def halton(number, base):
    share, result = 1.0, 0.0
    while number:
        share /= base
        number, digit = divmod(number, base)
        result += share * digit
    return result


def design(spreads, points):
    """Points that fill the box of `spreads`, {name: (low, high, "linear" or "log")}, evenly (Halton 1960): no seed."""
    found = []
    for number in range(1, points + 1):
        point = {}
        for prime, (name, (low, high, scale)) in zip(PRIMES, spreads.items(), strict=False):
            share = halton(number, prime)
            point[name] = low * (high / low) ** share if scale == "log" else low + share * (high - low)
        found.append(point)
    return found


def interval(values, share=0.9):
    """Ends between which `share` of the values lie, as many below as above."""
    ordered = sorted(values)

    def at(quantile):
        place = quantile * (len(ordered) - 1)
        low = math.floor(place)
        return ordered[low] + (place - low) * (ordered[min(low + 1, len(ordered) - 1)] - ordered[low])

    return [at((1 - share) / 2), at((1 + share) / 2)]


def rounded(value, digits=4):
    """Numbers of a nest of lists and tables to some digits: what a prediction says, not round-off."""
    if isinstance(value, dict):
        return {key: rounded(part, digits) for key, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(part, digits) for part in value]
    return float(f"{value:.{digits}g}") if isinstance(value, float) else value
