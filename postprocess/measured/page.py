"""docs/validation.md, made of what was predicted (prediction.json) and of what is computed today (numbers.json)."""

import json
from pathlib import Path

import numpy as np

from . import beach, choices, flume, lumped_slip, more, paper, parapet, peers
from .runs import CASES, design

KEPT = "kept apart"
SOFT, YIELDS, FORCE = *list(choices.OF_SLIP)[:2], "response.shear_to_force_ratio"
MEASURED = {  # what is known of the blind cases; None: nobody who predicted has seen it
    "parapet": (-4.3, -1.7),  # natural frequencies "reduced by 1.7%-4.3% after heightening", doi 10.1155/2013/806482, abstract
}


def predictions():
    return {path.parent.name: json.loads(path.read_text()) for path in sorted(CASES.glob("*/prediction.json"))}


def range_of(pair, form, scale=1.0):
    return f"{scale * pair[0]:{form}} to {scale * pair[1]:{form}}"


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head), *("| " + " | ".join(str(cell) for cell in row) + " |" for row in rows), ""]


def overview(said, now):
    column, frame, slide, deep = said["column"], said["parapet"], said["flume"], said["deep"]
    base = column["0.99"]["1.8"]
    low, high = MEASURED["parapet"]
    middle = (low + high) / 2
    before, after = now["beach"]["before the storm"], now["beach"]["after the storm"]
    model = now["paper"]
    wall = now["wall"]["p_1 over rho g h_s"]
    return [
        ("[C](#c-a-column-of-sand-under-waves): p/p_0 at the base of a column of sand, 1 % of air", f"{base['ratio']:.2f} ({range_of(base['interval'], '.2f')})", KEPT, "", "yes"),
        ("[O](#o-a-parapet): first frequency by a parapet", f"{frame['change']:.1f} % ({range_of(frame['interval'], '.1f')})", f"{high} to {low} %", f"{frame['change'] / middle:.1f}", "yes"),
        ("[W](#w-a-caisson-that-slides-in-a-flume): slip after five waves", f"{1e3 * slide['slip']:.1f} mm ({range_of(slide['interval'], '.2g', 1e3)})", KEPT, "", "yes"),
        ("[breakwater in 63 m of water](#a-breakwater-in-63-m-of-water): first frequency", f"{deep['first']:.2f} Hz ({range_of(deep['first_interval'], '.2f')})", KEPT, "", "yes"),
        ("the same: second frequency", f"{deep['second']:.1f} Hz ({range_of(deep['second_interval'], '.1f')})", KEPT, "", "yes"),
        ("[beach](#a-beach-of-sand-and-gravel), before a storm: lag over 35 cm", f"{before[3]:.1f} degrees", "about 20", f"{before[3] / 20:.2f}", "no; S fitted to another number"),
        ("beach, after it: lag over 35 cm", f"{after[3]:.1f} degrees", "more than 40", f"{after[3] / 40:.2f}", "no; k fitted to another number"),
        ("[the paper](#the-paper-itself): F_T/P in the 1/20 model", f"{model['model, G of 7.72 MPa']:.2f}", "about 0.80", "1.00", "no; calibrated to it"),
        ("the paper: F_T acts for, in the model", f"{range_of(model['tau_0 of the model'][::2], '.2f')} s, r from 2 to 1.2", "0.1 to 0.2 s", "", "no, but not calibrated"),
        ("[wall with a cantilever](#a-wall-with-a-cantilever): largest local pressure", f"{wall:.2f} rho g h_s, Goda's p_1", "82 rho g h_s", f"{wall / 82:.3f}", "no"),
    ]  # fmt: skip


def of_column(said, now):
    rows = []
    for saturation, depths in said["column"].items():
        today = now["column"][saturation]
        rows.append([saturation, *(f"{value['ratio']:.3f} ({range_of(value['interval'], '.2f')})" for depth, value in depths.items() if depth in ("0.4", "0.9", "1.8")),
                     f"{depths['0.9']['lag']:.0f}", f"{100 * today['error']:.2g} %", KEPT])  # fmt: skip
    head = ("degree of saturation", "p/p_0 0.4 m below the top", "0.9 m", "1.8 m, the base", "lag at 0.9 m (degrees)", "largest difference to theory", "measured")
    return table(head, rows)


def ranks(prediction):
    """What goes with the change by a parapet in the design of experiments, from the strongest on."""
    words = {"sand": "thickness of the sand", "rubble_modulus": "G of the rubble", "parapet_share": "width of the parapet"}
    points = design(parapet.SPREADS, parapet.POINTS)
    place = np.argsort(np.argsort([change for _, change in prediction["points"][1:]]))
    found = {name: float(np.corrcoef(np.argsort(np.argsort([point[name] for point in points])), place)[0, 1]) for name in parapet.SPREADS}
    return [(words.get(name, name), found[name]) for name in sorted(found, key=lambda name: -abs(found[name]))[:3]]


def of_flume(said, now):
    ways, today = said["flume"]["ways"], now["flume"]
    return table(("way", "predicted (mm)", "today (mm)"), [(name, f"{1e3 * ways[name]:.2f}" if name in ways else "", f"{1e3 * value:.2f}") for name, value in today.items()])


def of_beach(now):
    rows = []
    for state, known in beach.STATES.items():
        saturation, conductivity, ratio, lag, shape = now["beach"][state]
        more = "more than " if state.startswith("after") else "about "
        rows.append((state, f"{saturation:.3f}", f"{conductivity:.2e}", f"{ratio:.2f}", f"{known['ratio']:.2f}", f"**{lag:.1f}**", f"{more}{known['lag']:.0f}",
                     f"{shape:.2f}", f"{beach.shape(known['ratio'], known['lag']):.2f}"))  # fmt: skip
    for state, known in beach.STATES.items():
        saturation, conductivity, ratio, lag, shape = now["beach"][f"{state}, their S and k"]
        loss, later = known["elsewhere"]
        rows.append((f"{state}, with their S and k", f"{saturation:.2f}", f"{conductivity:.2e}", f"{ratio:.2f}", f"{known['ratio']:.2f}, {loss:.2f}", f"{lag:.1f}",
                     f"{known['lag']:.0f}, {later:.0f}", f"{shape:.2f}", f"{beach.shape(known['ratio'], known['lag']):.2f}, {beach.shape(loss, later):.2f}"))  # fmt: skip
    return table(("state", "S", "k (m/s)", "variance ratio", "measured", "lag (degrees)", "measured", "lag over loss of amplitude", "measured"), rows)


def fill(text, said, now):
    """The page's words with its numbers and tables in place."""
    n = now["paper"]
    parts = {
        "more": more.text(now, table),
        "overview": "\n".join(table(("what", "predicted (90 %)", "measured", "ratio", "blind"), overview(said, now) + more.overview(now))),
        "column": "\n".join(of_column(said, now)),
        "inertia": f"{max(row['inertia'] for row in now['column'].values()):.1e}",
        "error": f"{100 * max(row['error'] for row in now['column'].values()):.2g}",
        "air": f"{max(now['air'].values()):.2g}",
        "flume": "\n".join(of_flume(said, now)),
        "as a mass": f"{1e3 * now['flume']['as a case, springs given, triangle, the water as a mass']:.1f}",
        "on springs": f"{1e3 * now['flume']['as a case, springs given, triangle']:.1f}",
        "no turning": f"{1e3 * now['flume']['lumped, springs given, triangle, U on friction alone']:.1f}",
        "by script": f"{1e3 * now['flume']['lumped, springs given, triangle']:.1f}",
        "beach": "\n".join(of_beach(now)),
        "paper": "\n".join(table(("said", "computed", "agrees", "why"), paper.rows(n))),
        "peers": "\n".join(table(("problem", "program", "its cells and steps", "program - exact", "its scheme here - program", "upbead - exact", "upbead - program"), peers.summary(now["peers"]))),
        "ours": peers.worst(now["peers"], "ours - exact"),
        "theirs": peers.worst(now["peers"], "peer - exact"),
        "peer values": "\n".join(table(("problem", "value", "time", "exact", "program", "upbead", "program - exact", "upbead - exact", "upbead - program"), peers.details(now["peers"]))),
        "change": f"{said['parapet']['change']:.1f}",
        "change_interval": range_of(said["parapet"]["interval"], ".1f"),
        "frequency": f"{said['parapet']['frequency']:.1f}",
        "stiffer": f"{now['parapet']['change, rubble stiffer by the weight']:.1f}",
        "swing": f"{lumped_slip.periods(flume.lumped_caisson())[0]:.2f}",
        "ranks": ", ".join(f"{words} {rank:+.1f}" for words, rank in ranks(said["parapet"])),
        "drag": f"{now['drag']['change']:.1g}",
        "flow": f"{now['drag']['velocity']:.2g}",
        "as a part": f"{now['parapet']['change, as a part']:.2f}",
        "by mass": f"{now['parapet']['change']:.2f}",
        "wide": f"{now['parapet']['change, 20 m wide and 13 m high']:.1f}",
        "first": f"{said['deep']['first']:.2f}",
        "second": f"{said['deep']['second']:.2f}",
        "wall": f"{now['wall']['p_1 over rho g h_s']:.2f}",
        "times": f"{82 / now['wall']['p_1 over rho g h_s']:.0f}",
        "central": f"{now['tornado']['']['response.shear_to_force_ratio']:.2f}",
        "soft": f"{now['choices'][SOFT][FORCE][0]:.2f}",
        "yields": f"{now['choices'][YIELDS][FORCE][0]:.2f}",
        "slide": f"{1e3 * now['tornado']['']['sliding.sliding_coupled']:.0f}",
    }
    for name, part in parts.items():
        text = text.replace("{{" + name + "}}", part)
    assert "{{" not in text, "a place of the page is not filled"
    return text


def page():
    said, now = predictions(), json.loads((CASES / "numbers.json").read_text())
    return fill(Path(__file__).with_name("validation.md").read_text(encoding="utf-8"), said, now)
