"""Round numbers along an axis."""

import math

FEWEST = 3
MANTISSAS = ((1, 2, 5), (1, 3), (1,))


def step_for(span, count):
    """1, 2 or 5 times a power of ten, for which about `count` steps cover the span."""
    raw = span / max(1, count)
    power = 10.0 ** math.floor(math.log10(raw))
    return power * next(factor for factor in (1.0, 2.0, 5.0, 10.0) if factor * power >= raw * (1 - 1e-9))


def ticks(low, high, count):
    """[(value, text)] of the round numbers in [low, high]: about `count`, and not fewer than FEWEST."""
    if not high > low:
        return []
    steps = (step_for(high - low, wanted) for wanted in range(count, 3 * FEWEST + count))
    step = next(step for step in steps if math.floor(high / step) - math.ceil(low / step) + 1 >= FEWEST)
    decimals = max(0, -math.floor(math.log10(step) + 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [(i * step, f"{i * step + 0.0:,.{decimals}f}".replace("-", "−")) for i in range(first, last + 1)]


def decades(low, high, count):
    """[(value, text)] of an axis over decades from 10^low to 10^high: 1, 2 and 5 of each; of less than a decade round numbers."""
    for mantissas in MANTISSAS:
        found = [factor * 10.0**power for power in range(math.floor(low), math.ceil(high) + 1) for factor in mantissas]
        found = [value for value in found if 10.0**low * (1 - 1e-9) <= value <= 10.0**high * (1 + 1e-9)]
        if len(found) <= count + 1:
            break
    if len(found) < FEWEST:
        return [(math.log10(value), text) for value, text in ticks(10.0**low, 10.0**high, count) if value > 0]
    return [(math.log10(value), f"{value:,.10g}") for value in found]
