"""What the outlines of a section tell: its corners, what lies above each other, its slopes."""

FLAT = 1e-6  # of a loop's size: a point nearer to the line between its neighbours is no corner


def corners(loops):
    """The loops without the points of the mesh that lie on straight sides."""
    return [simple(loop) for loop in loops]


def simple(loop):
    points = [point for i, point in enumerate(loop) if point != loop[i - 1]]
    size = max(max(p[axis] for p in points) - min(p[axis] for p in points) for axis in (0, 1))
    kept = []
    for i, (x, y) in enumerate(points):
        (xa, ya), (xb, yb) = kept[-1] if kept else points[-1], points[(i + 1) % len(points)]
        length = ((xb - xa) ** 2 + (yb - ya) ** 2) ** 0.5 or 1.0
        if abs((x - xa) * (yb - ya) - (y - ya) * (xb - xa)) / length > FLAT * size:
            kept.append((x, y))
    return kept if len(kept) > 2 else points


def features(loop, whole):
    """The corners of a loop that are not on the outer sides of the section."""
    room = 1e-6 * (whole[1] - whole[0])
    return [point for point in loop if whole[0] + room < point[0] < whole[1] - room]


def crossings(loop, x):
    """Heights at which a loop crosses the upright line at x."""
    return [ya + (x - xa) / (xb - xa) * (yb - ya) for (xa, ya), (xb, yb) in zip(loop, [*loop[1:], *loop[:1]]) if (xa > x) != (xb > x)]


def column_at(section, x):
    """Heights of the limits between regions at x, from the base up."""
    size = section.box()[3] - section.box()[2]
    return merged([y for loops in section.regions.values() for loop in loops for y in crossings(loop, x)], 1e-6 * size)


def top_at(section, x):
    heights = column_at(section, x)
    return heights[-1] if heights else section.box()[3]


def merged(values, room):
    """Ascending values, of those that are nearer than `room` the first."""
    found = []
    for value in sorted(values):
        if not found or value - found[-1] > room:
            found.append(value)
    return found


def slopes(loop):
    """[(middle, horizontal over vertical, -1 where it rises landward and else 1)] of the inclined sides of a loop that look up."""
    found = []
    top = max(y for _, y in loop)
    for (xa, ya), (xb, yb) in zip(loop, [*loop[1:], *loop[:1]]):
        across, up = xb - xa, yb - ya
        if abs(up) > 1e-9 and abs(across / up) > 0.05 and abs(up) > 0.2 * abs(across) / 3 and max(ya, yb) > top - 1e-6 * (1 + abs(top)):
            found.append((((xa + xb) / 2, (ya + yb) / 2), abs(across / up), -1 if across * up > 0 else 1))
    return found
