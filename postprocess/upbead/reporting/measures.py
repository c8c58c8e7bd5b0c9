"""The measures of the sliding distance that a summary may have, best first."""

from dataclasses import dataclass

from .language import told


@dataclass
class Measure:
    key: str
    value: float
    short: str
    what: str


KNOWN = [  # best first: key, short name, description
    (
        "contact.solved.slip",
        "contact followed node by node, mean over the bottom",
        "Friction and uplift node by node under the caisson, on the shaken ground; mean over the bottom, in the end.",
    ),
    (
        "contact.solved.least_slip",
        "of the node that slipped least",
        "The same, of the node that slipped least: the bottom as a whole slid this far.",
    ),
    (
        "sliding.sliding_coupled",
        "sliding as a rigid block on the moving ground",
        "A caisson that slides as a rigid block on the moving ground; the slip changes the shear force.",
    ),
    (
        "sliding.sliding_history",
        "eq. (4) on the computed shear force",
        "Rigid block, eq. (4) of Shimosako and Takahashi (1994) on F_T(t) of the bonded caisson and the uplift.",
    ),
    (
        "sliding.sliding_normal_force",
        "eq. (4) with the changing normal force",
        "The same, with friction on the normal force as it changes with the caisson's vertical motion.",
    ),
    (
        "sliding.equal_impulse.sliding_exact",
        "triangle of equal peak and impulse, integrated",
        "Rigid block under the triangular pulse of the same peak and impulse, integrated.",
    ),
    (
        "sliding.equal_impulse.sliding_paper",
        "triangle of equal peak and impulse, eq. (7)",
        "The same pulse by eq. (7) of the paper.",
    ),
    (
        "sliding.sliding_exact",
        "wave of the case, integrated",
        "Rigid block under the triangular pulse of duration tau_0 of the case's wave, eqs. (8) to (11), integrated.",
    ),
    ("sliding.sliding_paper", "wave of the case, eq. (7)", "The same pulse by eq. (7): S_CAL of the paper."),
]


def at(summary, key):
    for part in key.split("."):
        summary = summary.get(part) if isinstance(summary, dict) else None
    return summary


def measures(summary):
    return [Measure(key, at(summary, key), told(short), told(what)) for key, short, what in KNOWN if at(summary, key) is not None]


def best(summary):
    """The most detailed measure; None if sliding was not asked for."""
    found = measures(summary)
    design = at(summary, "sliding.design")
    if design:
        short = next((short for key, short, _ in KNOWN if key == design["measure"]), design["why"])
        return Measure(design["measure"], design["value"], told(short), told(design["why"]))
    return found[0] if found else None
