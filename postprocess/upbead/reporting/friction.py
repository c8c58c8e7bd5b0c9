"""A rigid block on friction under a force that is linear between its times: eq. (4) of Shimosako and Takahashi
(1994).

The same as src/sliding/block.cc without drag: (W/g) v' = F - R, where R = mu (W' - U) acts against the motion.
"""

import numpy as np


def slip(mass, time, force, resistance):
    """The position at which the block comes to rest (m, landward)."""
    moving = np.flatnonzero(np.abs(force) > resistance)
    if not moving.size:
        return 0.0
    place = speed = 0.0
    for n in range(max(int(moving[0]) - 1, 0), len(time) - 1):
        if speed == 0.0 and n >= moving[-1] + 1:
            break
        place, speed = through(mass, place, speed, time[n + 1] - time[n], force[n : n + 2], resistance[n : n + 2])
    return float(place + np.sign(speed) * mass * speed**2 / (2.0 * resistance[-1]))


def through(mass, place, speed, left, force, resistance):
    """Position and velocity at the end of an interval of `left` seconds."""
    length, way = left, np.sign(speed)
    while left > 0:
        if way == 0:
            wait, way = start((force, resistance), length, left)
            left -= wait
            if way == 0:
                break
        begin, end = (way * at(force, length, left) - at(resistance, length, left), way * force[1] - resistance[1])
        a, jerk = begin / mass, (end - begin) / (mass * left) if left > 0 else 0.0
        passed = min(stop(abs(speed), a, jerk), left)
        place += way * passed * (abs(speed) + passed * (a / 2 + passed * jerk / 6))
        stopped = passed < left
        speed = 0.0 if stopped else way * max(abs(speed) + passed * (a + passed * jerk / 2), 0.0)
        left, way = left - passed, 0 if stopped else way
        if not stopped:
            break
    return place, speed


def at(pair, length, left):
    """Value of a line with the end values `pair` at which `left` of its `length` remains."""
    return pair[1] + (pair[0] - pair[1]) * left / length


def start(lines, length, left):
    """(seconds until the block starts, its direction); direction 0 if it stays at rest."""
    found = (left, 0)
    for way in (1, -1):
        begin, end = (way * at(lines[0], length, left) - at(lines[1], length, left), way * lines[0][1] - lines[1][1])
        wait = 0.0 if begin > 0 else left * -begin / (end - begin) if end > 0 else left
        if wait < found[0]:
            found = (wait, way)
    return found


def stop(speed, a, jerk):
    """The least t > 0 with speed + a t + jerk t^2/2 = 0; infinity where there is none.

    Roots without cancellation, after Press et al., Numerical Recipes, section 5.6.
    """
    if speed == 0:
        return -2.0 * a / jerk if jerk < 0 else np.inf  # the block has just started: a >= 0
    square = a * a - 2.0 * jerk * speed
    if square < 0:
        return np.inf
    q = -(a + (-1.0 if a < 0 else 1.0) * np.sqrt(square))
    roots = [number / under for number, under in ((q, jerk), (2.0 * speed, q)) if under]
    return min((root for root in roots if root > 0), default=np.inf)
