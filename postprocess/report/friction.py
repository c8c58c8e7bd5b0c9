"""A rigid block on friction under a force that is straight between its times: eq. (4) of Shimosako and Takahashi (1994).

As src/sliding/block.cc without drag: (W/g) v' = F - R, where R = mu (W' - U) acts against the motion.
"""

import numpy as np


def slip(mass, time, force, resistance):
    """Where the block comes to rest (m, landward)."""
    place = speed = 0.0
    for n in range(len(time) - 1):
        place, speed = through(mass, place, speed, time[n + 1] - time[n], force[n : n + 2], resistance[n : n + 2])
    return float(place + np.sign(speed) * mass * speed**2 / (2.0 * resistance[-1]))


def through(mass, place, speed, left, force, resistance):
    """Place and speed at the end of a piece of `left` seconds."""
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
    """A line's value where `left` of its `length` is still to come."""
    return pair[1] + (pair[0] - pair[1]) * left / length


def start(lines, length, left):
    """(seconds until the block starts, its way); way 0 where it rests."""
    found = (left, 0)
    for way in (1, -1):
        begin, end = (way * at(lines[0], length, left) - at(lines[1], length, left), way * lines[0][1] - lines[1][1])
        wait = 0.0 if begin > 0 else left * -begin / (end - begin) if end > 0 else left
        if wait < found[0]:
            found = (wait, way)
    return found


def stop(speed, a, jerk):
    """The least t > 0 with speed + a t + jerk t^2/2 = 0; infinity where there is none."""
    if speed == 0 and a >= 0 and jerk >= 0:
        return np.inf
    roots = np.roots([jerk / 2, a, speed]) if jerk else np.array([-speed / a]) if a else np.array([])
    real = [root.real for root in np.atleast_1d(roots) if abs(root.imag) < 1e-12 and root.real > 1e-12]
    return min(real, default=np.inf)
