"""Soils as drawings of the ground know them: dots for sand, strokes for clay, stones for rubble.

What a soil is drawn as follows from its permeability, as its name may be anything. The limits are ours, and of drawing alone.
"""

from dataclasses import dataclass

from .markup import join, tag

CLAY, RUBBLE = 1e-7, 1e-2  # m/s: less is clay, more is rubble
TONES = 3  # tones of each, so that two sands differ
SIZES = {"sand": 9, "clay": 12, "rubble": 16}


@dataclass
class Pattern:
    kind: str

    @property
    def name(self):
        return self.kind

    def svg(self, name):
        size = SIZES[self.kind]
        return tag("pattern", MARKS[self.kind](), id=name, width=size, height=size, patternUnits="userSpaceOnUse")


def sand():
    return join(tag("circle", cx=x, cy=y, r=0.65, class_="grain") for x, y in ((2, 2), (6.5, 4), (3.5, 7)))


def clay():
    return join(tag("path", d=f"M{x} {y}h6", class_="hatch") for x, y in ((1, 3), (6, 9)))


def rubble():
    stones = ("M2 5l3-3 4 1 1 4-4 2z", "M10 12l2-3 3 1 0 4-4 1z", "M2 13l2-2 3 2-2 2z")
    return join(tag("path", d=stone, class_="hatch") for stone in stones)


MARKS = {"sand": sand, "clay": clay, "rubble": rubble}


def kind_of(region, name):
    """What a porous region is drawn as."""
    known = region.get("hydraulic_conductivity")
    if not isinstance(known, (int, float)) or known <= 0:
        return "rubble" if name == "mound" else "sand"
    return "clay" if known < CLAY else "rubble" if known > RUBBLE else "sand"


def looks(regions):
    """{region: (class, Pattern or None)} of {region: its keys}; regions of one soil differ in their tone."""
    found, counted = {}, {}
    for name, keys in regions.items():
        kind = keys.get("kind", "porous")
        if kind != "porous":
            found[name] = kind, None
            continue
        soil = kind_of(keys, name)
        tone = counted[soil] = counted.get(soil, -1) + 1
        found[name] = f"{soil}{min(tone, TONES - 1)}", Pattern(soil)
    return found
