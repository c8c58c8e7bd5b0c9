"""A drawing to scale: from metres to SVG elements, with the symbols of engineering drawings."""

from .markup import Markup, join, tag

SIGN = 4  # half a tick of a dimension line, px


class Canvas:
    """A window (x0, x1, y0, y1) in m, `width` px wide, with room for dimensions around it."""

    def __init__(self, window, width, margins=(8, 8, 26, 34)):
        self.x0, self.x1, self.y0, self.y1 = window
        left, right, top, bottom = margins
        self.left, self.top = left, top
        self.scale = (width - left - right) / (self.x1 - self.x0)
        self.width, self.inner = width, (width - left - right, self.scale * (self.y1 - self.y0))
        self.height = self.inner[1] + top + bottom
        self.parts = []

    def at(self, x, y):
        return self.left + (x - self.x0) * self.scale, self.top + (self.y1 - y) * self.scale

    def add(self, *parts):
        self.parts += parts

    def loop(self, points, class_):
        """A closed area, cut off at the window's sides."""
        place = [(min(max(x, self.x0), self.x1), y) for x, y in points]  # areas beyond a side end at it
        return tag("polygon", points=" ".join("{:.1f},{:.1f}".format(*self.at(*p)) for p in place), class_=class_)

    def text(self, x, y, *words, anchor="middle", class_="note", dx=0, dy=0):
        px, py = self.at(x, y)
        self.add(tag("text", *words, x=f"{px + dx:.1f}", y=f"{py + dy:.1f}", text_anchor=anchor, class_=class_))

    def line(self, a, b, class_="thin"):
        (xa, ya), (xb, yb) = a, b
        self.add(tag("line", x1=f"{xa:.1f}", y1=f"{ya:.1f}", x2=f"{xb:.1f}", y2=f"{yb:.1f}", class_=class_))

    def across(self, x0, x1, y, words, shift):
        """A dimension from x0 to x1, `shift` px below the height y."""
        (a, py), (b, _) = self.at(x0, y), self.at(x1, y)
        py += shift
        self.line((a, py), (b, py))
        self.slash(a, py)
        self.slash(b, py)
        self.add(tag("text", words, x=f"{(a + b) / 2:.1f}", y=f"{py - 5:.1f}", text_anchor="middle", class_="note"))

    def upright(self, x, y0, y1, words, side=1):
        """A dimension from y0 to y1 at x; its number stands on the right (side 1) or on the left."""
        (px, a), (_, b) = self.at(x, y0), self.at(x, y1)
        self.line((px, a), (px, b))
        self.slash(px, a)
        self.slash(px, b)
        self.add(
            tag(
                "text",
                words,
                x=f"{px + 6 * side:.1f}",
                y=f"{(a + b) / 2:.1f}",
                dy=".35em",
                class_="note",
                text_anchor="start" if side > 0 else "end",
            )
        )

    def slash(self, px, py):
        self.line((px - SIGN, py + SIGN), (px + SIGN, py - SIGN))

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
        self.add(tag("polygon", points=f"{px},{py} {px - 5},{py - 8} {px + 5},{py - 8}", class_="level"))
        self.line((px - 8, py + 3), (px + 8, py + 3))
        self.line((px - 4, py + 6), (px + 4, py + 6))

    def svg(self, label, class_):
        box = f"0 0 {self.width} {self.height:.0f}"
        return tag("svg", join(self.parts, Markup("\n")), viewBox=box, role="img", aria_label=label, class_=class_)
