"""Places texts of a drawing where they cover neither each other nor its lines."""

import html
import re
from dataclasses import dataclass, field

LETTER, WIDE = 0.62, 1.0  # widths of a letter over the size of the font: DejaVu Sans on average; Japanese
OVER_TEXT, OVER_LINE, OVER_OUTLINE, BEYOND = 100.0, 8.0, 1.5, 60.0  # what is worst to cover; beyond the drawing's edge
AWAY = 12.0  # of a place that needs a line
MARKS = re.compile(r"<[^>]*>")


@dataclass
class Label:
    """`places`: [(x, y of the letters' middle, anchor)] in px, the best first."""

    words: object
    places: list
    class_: str = "note"
    size: float = 12.0
    leader: tuple | None = None  # the point to which a line leads from a place away from it
    away: int = 0  # the first of the places that needs the line
    rank: int = 0
    box: tuple = field(default=None)
    at: tuple = field(default=None)


def width_of(words, size):
    """Of words as they will be set, in px."""
    text = html.unescape(MARKS.sub("", str(words)))
    return size * sum(WIDE if ord(letter) > 0x2E80 else LETTER for letter in text)


def box_of(words, place, size):
    """(left, top, right, bottom) of words at a place."""
    x, y, anchor = place
    width = width_of(words, size)
    left = x - {"start": 0.0, "middle": 0.5, "end": 1.0}[anchor] * width
    return left, y - 0.5 * size, left + width, y + 0.5 * size


def overlap(a, b, room=2.0):
    """Whether two boxes are nearer than `room`."""
    return a[0] < b[2] + room and b[0] < a[2] + room and a[1] < b[3] + 0.5 * room and b[1] < a[3] + 0.5 * room


def crosses(box, line):
    """Whether a line (x, y, x, y) touches a box: Liang and Barsky (1984)."""
    (left, top, right, bottom), (xa, ya, xb, yb) = box, line
    low, high = 0.0, 1.0
    for along, inside in ((xa - xb, xa - left), (xb - xa, right - xa), (ya - yb, ya - top), (yb - ya, bottom - ya)):
        if along == 0:
            if inside < 0:
                return False
            continue
        share = inside / along
        if along < 0:
            low = max(low, share)
        else:
            high = min(high, share)
    return low <= high


def inside(box, loop):
    """Whether the corners and middles of a box's sides are in a loop (px): even-odd rule."""
    left, top, right, bottom = box
    points = [(x, y) for x in (left, (left + right) / 2, right) for y in (top, bottom)]
    return all(within(point, loop) for point in points)


def within(point, loop):
    x, y = point
    odd = False
    for (xa, ya), (xb, yb) in zip(loop, loop[1:] + loop[:1]):
        if (ya > y) != (yb > y) and x < xa + (y - ya) / (yb - ya) * (xb - xa):
            odd = not odd
    return odd


def place(labels, lines, outlines, edge):
    """Chooses a place for each label, in their order, those last that may be led to by a line; `edge` is (left, top, right, bottom) of the drawing."""
    taken = []
    for label in sorted(labels, key=lambda one: one.leader is not None and not one.away):
        best = None
        for rank, at in enumerate(label.places):
            box = box_of(label.words, at, label.size)
            cost = 0.02 * rank + (AWAY if label.leader and rank >= label.away else 0.0)
            cost += sum(OVER_TEXT for other in taken if overlap(box, other))
            cost += sum(OVER_LINE for line in lines if crosses(box, line))
            cost += sum(OVER_OUTLINE for line in outlines if crosses(box, line))
            if box[0] < edge[0] or box[2] > edge[2] or box[1] < edge[1] or box[3] > edge[3]:
                cost += BEYOND
            if best is None or cost < best[0]:
                best = (cost, rank, at, box)
            if cost <= 0.02 * rank:
                break
        _, label.rank, label.at, label.box = best
        taken.append(label.box)
    return labels
