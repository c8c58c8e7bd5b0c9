"""Which breakwaters of 67 ports slide in the tsunami of 2011: widths and heights as Takagi and others tell them, the rest assumed."""

import json
import subprocess

from .runs import CASES, design, toml

CASE = CASES / "tsunami/tsunami.toml"
GROUPS = {  # what they say of widths (m) and tsunami heights (m); share that was greatly damaged
    "narrower than 8 m, tsunami above 14 m": ((4.0, 8.0), (14.0, 20.0), 1.0),
    "any width, tsunami below 6 m": ((4.0, 22.0), (2.0, 6.0), 0.0),
    "wider than 14 m, tsunami below 6 m": ((14.0, 22.0), (2.0, 6.0), 0.0),
    "wider than 14 m, tsunami above 6 m": ((14.0, 22.0), (6.0, 20.0), 0.0),
}
SPREADS = {
    "depth": (3.0, 10.0, "linear"),  # of the bottom below still water
    "crest": (2.0, 5.0, "linear"),
    "density": (2100.0, 2300.0, "linear"),
    "friction": (0.5, 0.7, "linear"),
    "share": (0.5, 1.0, "linear"),  # of the tsunami's height that presses: the harbour fills meanwhile
    "width": (0.0, 1.0, "linear"),
    "height": (0.0, 1.0, "linear"),
}
POINTS = 24
SEA, GRAVITY = 1030.0, 9.81


def keys_of(point, widths, heights):
    width, height = (low + share * (high - low) for (low, high), share in ((widths, point["width"]), (heights, point["height"])))
    depth, crest = point["depth"], point["crest"]
    body = {"water_depth": depth + 2, "foundation_depth": depth, "berm_depth": depth - 0.5, "crest": crest, "width": width, "friction": point["friction"]}
    weights = {"weight": point["density"] * GRAVITY * width * (depth + crest), "submerged_weight": GRAVITY * width * (point["density"] * (depth + crest) - SEA * depth)}
    pressed = {f"waves.tsunami.{key}": height * point["share"] for key in ("height", "significant_height")}
    return {f"section.{key}": value for key, value in (body | weights).items()} | pressed


def safety(program, keys, folder):
    words = [word for key, value in keys.items() for word in ("--set", f"{key}={toml(value)}")]
    done = subprocess.run([program, "waves", CASE, *words, "--out", folder, "--json"], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)["waves"]["tsunami"]["safety_sliding"]


def shares(program, folder):
    """{group: share of the designs that slide}, and the height that slides the middle design by its width."""
    points = design(SPREADS, POINTS)
    found = {}
    for name, (widths, heights, _) in GROUPS.items():
        found[name] = sum(safety(program, keys_of(point, widths, heights), folder / "tsunami") < 1 for point in points) / POINTS
    widths, heights, _ = GROUPS["wider than 14 m, tsunami above 6 m"]
    for name, share in (("not filled", 1.0), ("filled", 0.5)):
        found[name] = sum(safety(program, keys_of(point | {"share": share}, widths, heights), folder / "tsunami") < 1 for point in points) / POINTS
    return found | {"threshold": {str(width): threshold(program, width, folder) for width in (8, 14)}}


def threshold(program, width, folder):
    """Height of the tsunami (m) that slides a breakwater whose other inputs are in the middle of their spreads."""
    middle = {name: (low + high) / 2 for name, (low, high, _) in SPREADS.items()}
    low, high = 0.5, 40.0
    for _ in range(14):
        height = (low + high) / 2
        slides = safety(program, keys_of(middle, (width, width), (height, height)), folder / "tsunami") < 1
        low, high = (low, height) if slides else (height, high)
    return (low + high) / 2
