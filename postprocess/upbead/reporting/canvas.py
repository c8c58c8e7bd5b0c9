"""A drawing to scale: from metres to SVG elements, with the symbols of engineering drawings."""

from . import labels
from .markup import Markup, join, tag

SIGN = 4  # half a tick of a dimension line, px
SIZES = {"small": 11.0, "name": 12.0}
MIDDLE = 0.36  # of a font's size: from its base line to the middle of its letters
GRID = 14.0  # px between the places that are tried for a name within its area


class Canvas:
    """A window (x0, x1, y0, y1) in m, `width` px wide, with room for dimensions around it."""

    def __init__(self, window, width, margins=(8, 8, 26, 34), name="drawing"):
        self.x0, self.x1, self.y0, self.y1 = window
        left, right, top, bottom = margins
        self.left, self.top, self.name = left, top, f"{name}-{width}"
        self.scale = (width - left - right) / (self.x1 - self.x0)
        self.width, self.inner = width, (width - left - right, self.scale * (self.y1 - self.y0))
        self.height = self.inner[1] + top + bottom
        self.parts, self.labels, self.lines, self.outlines, self.patterns = [], [], [], [], {}

    def at(self, x, y):
        return self.left + (x - self.x0) * self.scale, self.top + (self.y1 - y) * self.scale

    def add(self, *parts):
        self.parts += parts

    def visible(self, points):
        """A loop (m) cut off at the window's sides, in px."""
        for side, keep in ((self.x0, 1), (self.x1, -1)):
            points = cut(points, side, keep)
        return [self.at(*point) for point in points]

    def loop(self, points, class_, pattern=None):
        """A closed area, cut off at the window's sides; with a pattern of patterns.py over its colour."""
        seen = self.visible(points)
        if len(seen) < 3:
            return Markup("")
        self.outlines += [(*a, *b) for a, b in zip(seen, seen[1:] + seen[:1])]
        where = " ".join(f"{x:.1f},{y:.1f}" for x, y in seen)
        area = tag("polygon", points=where, class_=class_)
        if not pattern:
            return area
        name = f"{self.name}-{pattern.name}"
        self.patterns[name] = pattern
        return join([area, tag("polygon", points=where, fill=f"url(#{name})")])

    def text(self, x, y, *words, anchor="middle", class_="note", dx=0, dy=0):
        """Words whose base line begins, ends or has its middle at one place."""
        px, py = self.at(x, y)
        size = size_of(class_)
        self.label(join(words), [(px + dx, py + dy - MIDDLE * size, anchor)], class_)

    def label(self, words, places, class_="note", **more):
        """Words at the first of these places (px) that is free."""
        self.labels.append(labels.Label(words, places, class_, size_of(class_), **more))

    def around(self, px, py, words, class_="note small", near=8, **more):
        """Words beside a point (px)."""
        far = 0.7 * near
        places = [(px + far, py - far, "start"), (px + near, py, "start"), (px + far, py + far, "start"), (px - far, py - far, "end"),
                  (px - near, py, "end"), (px, py - 1.6 * near, "middle"), (px, py + 1.6 * near, "middle"), (px - far, py + far, "end")]  # fmt: skip
        self.label(words, places, class_, **more)

    def line(self, a, b, class_="thin"):
        (xa, ya), (xb, yb) = a, b
        self.lines.append((xa, ya, xb, yb))
        self.add(tag("line", x1=f"{xa:.1f}", y1=f"{ya:.1f}", x2=f"{xb:.1f}", y2=f"{yb:.1f}", class_=class_))

    def across(self, x0, x1, y, words, shift):
        """A dimension from x0 to x1, `shift` px below the height y."""
        (a, py), (b, _) = self.at(x0, y), self.at(x1, y)
        py += shift
        self.line((a, py), (b, py))
        self.slash(a, py)
        self.slash(b, py)
        middle = (a + b) / 2
        self.label(words, [(middle, py - 9, "middle"), (middle, py + 11, "middle"), (middle, py + 23, "middle")])

    def upright(self, x, y0, y1, words, side=1):
        """A dimension from y0 to y1 at x; its number stands on the right (side 1) or on the left."""
        (px, a), (_, b) = self.at(x, y0), self.at(x, y1)
        self.line((px, a), (px, b))
        self.slash(px, a)
        self.slash(px, b)
        ways = [(side, "start" if side > 0 else "end"), (-side, "end" if side > 0 else "start")]
        heights = [b + share * (a - b) for share in (0.5, 0.35, 0.65, 0.2, 0.8)]
        self.label(words, [(px + 6 * way, y, anchor) for way, anchor in ways for y in heights])

    def slash(self, px, py):
        """The end of a dimension; a number may touch it, as short dimensions have no room between their ends."""
        self.line((px - SIGN, py + SIGN), (px + SIGN, py - SIGN))
        self.lines.pop()

    def arrow(self, start, end, class_="load"):
        """From start to end, in px."""
        (xa, ya), (xb, yb) = start, end
        length = ((xb - xa) ** 2 + (yb - ya) ** 2) ** 0.5
        ux, uy = (xb - xa) / length, (yb - ya) / length
        head = [
            (xb, yb),
            (xb - 10 * ux - 4 * uy, yb - 10 * uy + 4 * ux),
            (xb - 10 * ux + 4 * uy, yb - 10 * uy - 4 * ux),
        ]
        self.line(start, (xb - 8 * ux, yb - 8 * uy), class_)
        self.add(tag("polygon", points=" ".join(f"{x:.1f},{y:.1f}" for x, y in head), class_=class_ + "head"))

    def level(self, x, y):
        """The symbol of a water level: a triangle above it."""
        px, py = self.at(x, y)
        self.add(tag("polygon", points=f"{px:.1f},{py:.1f} {px - 5:.1f},{py - 8:.1f} {px + 5:.1f},{py - 8:.1f}", class_="level"))
        self.lines.append((px, py - 8, px, py + 6))
        self.line((px - 8, py + 3), (px + 8, py + 3))
        self.line((px - 4, py + 6), (px + 4, py + 6))

    def within(self, loops, words, class_="name"):
        """Words within an area of loops (m), as near to its middle as there is room; else beside it, with a line to it."""
        seen = [loop for loop in map(self.visible, loops) if len(loop) > 2]
        if not seen:
            return
        loop = max(seen, key=area)
        x, y = ([point[axis] for point in loop] for axis in (0, 1))
        middle = ((min(x) + max(x)) / 2, (min(y) + max(y)) / 2)
        size = size_of(class_)
        inner = [place for place in spots(min(x), max(x), min(y), max(y), middle)
                 if labels.inside(labels.box_of(words, place, size + 3), loop)]  # fmt: skip
        target = next((spot[:2] for spot in spots(min(x), max(x), min(y), max(y), middle, 4.0) if labels.within(spot[:2], loop)), middle)
        outer = spots(self.left, self.left + self.inner[0], self.top, self.top + self.inner[1], target)
        self.label(words, inner + outer, class_, leader=target, away=len(inner))

    def svg(self, label, class_):
        edge = (1, 1, self.width - 1, self.height - 1)
        words = [set_(one) for one in labels.place(self.labels, self.lines, self.outlines, edge)]
        defs = tag("defs", *(pattern.svg(name) for name, pattern in self.patterns.items())) if self.patterns else ""
        box = f"0 0 {self.width} {self.height:.0f}"
        return tag("svg", defs, join([*self.parts, *words], Markup("\n")), viewBox=box, role="img", aria_label=label, class_=class_)


def size_of(class_):
    return next((SIZES[word] for word in class_.split() if word in SIZES), 12.0)


def set_(label):
    """A label as text, with its line where it is far from what it names."""
    x, y, anchor = label.at
    parts = [tag("text", label.words, x=f"{x:.1f}", y=f"{y + MIDDLE * label.size:.1f}", text_anchor=anchor, class_=label.class_)]
    if label.leader and label.rank >= label.away:
        (left, top, right, bottom), (px, py) = label.box, label.leader
        ax, ay = min(max(px, left), right), min(max(py, top - 1), bottom + 1)
        ends = {"x1": f"{ax:.1f}", "y1": f"{ay:.1f}", "x2": f"{px:.1f}", "y2": f"{py:.1f}"}
        parts.insert(0, tag("circle", cx=f"{px:.1f}", cy=f"{py:.1f}", r=1.8, class_="leaderdot"))
        parts.insert(0, tag("line", **ends, class_="leader"))
    return join(parts)


def spots(x0, x1, y0, y1, middle, step=GRID):
    """Places of a grid over a box, the nearest to the middle first."""
    columns, rows = int((x1 - x0) / (2 * step)), int((y1 - y0) / (2 * step))
    found = [(middle[0] + i * step, middle[1] + j * step, "middle") for i in range(-2 * columns, 2 * columns + 1) for j in range(-2 * rows, 2 * rows + 1)]
    found = [spot for spot in found if x0 <= spot[0] <= x1 and y0 <= spot[1] <= y1] or [(*middle, "middle")]
    return sorted(found, key=lambda spot: abs(spot[0] - middle[0]) + 2 * abs(spot[1] - middle[1]))


def cut(points, side, keep):
    """The part of a loop on one side of an upright line at x = side: Sutherland and Hodgman (1974)."""
    found = []
    for (xa, ya), (xb, yb) in zip(points, [*points[1:], *points[:1]]):
        if keep * (xa - side) >= 0:
            found.append((xa, ya))
        if (xa - side) * (xb - side) < 0:
            found.append((side, ya + (side - xa) / (xb - xa) * (yb - ya)))
    return found


def area(loop):
    return abs(sum(xa * yb - xb * ya for (xa, ya), (xb, yb) in zip(loop, loop[1:] + loop[:1]))) / 2
