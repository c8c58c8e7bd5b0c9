"""Random mistakes in the text of a case file."""

import re

NUMBER = re.compile(r"(?<![\w\".])-?\d+(\.\d+)?(e[+-]?\d+)?(?![\w\"])|\binf\b")
ABSURD = ["0", "-1", "1", "inf", "-inf", "nan", "1e308", "-1e308", "1e-308", "5e-324", "9223372036854775807", "0.5", "1e30",
          "1e-30", "true", '"text"', "[]", "[1.0, 2.0]", "{}", "1979-05-27"]
WORDS = ["porous", "solid", "rigid", "water", "auto", "darcy", "inertial", "drained", "fixed", "roller", "free", "absorbing",
         "sealed", "open", "surface_waves", "force", "traction", "pressure", "triangle", "step", "half_sine", "church_roof",
         "harmonic", "generalised_alpha", "sdirk4", "reduced", "elastic", "compressible", "incompressible", "tied",
         "friction", "column", "composite", "caisson", "front", "bed", "lower", "upper", "", "nonsense", "\\u0000", "ü"]
ADDITIONS = ["[output]\nfields = { every = 1e-3 }", "[accuracy]\ntolerance = 1e-9", "[initial]\nwater_level = 1e9",
             "[initial]\nk0 = 4.9", "[sliding]\nfriction = 0.6\nsubmerged_weight = 1e5", "[probes.far]\nat = [1e9, 0]",
             "[loads.again]\nregion = \"caisson\"\nat = [0, 0]\npulse = { shape = \"step\", peak = 1e5 }",
             "[loads.none]\nboundary = \"bed\"\nkind = \"traction\"\npulse = { shape = \"step\", peak = 0 }",
             "[regions.caisson.interface]\nkind = \"friction\"", "[regions.upper.strain]\nreference_strain = 1e-6",
             "[regions.upper.shear_modulus]\nreference = 1e7\n[initial]\nwater_level = 1", "gravity = 1e-9", "[nothing]",
             "gravity = 9.81\n"]


def lines_with(lines, pattern):
    return [i for i, line in enumerate(lines) if re.search(pattern, line)]


def other_number(draw, lines):
    """Another value for a number: absurd, or far from what it was."""
    i = draw.choice(lines_with(lines, NUMBER) or [0])
    found = list(NUMBER.finditer(lines[i]))
    if not found or lines[i].startswith("title"):
        return
    number = draw.choice(found)
    value = draw.choice(ABSURD)
    if draw.random() < 0.75 and number[0] != "inf":
        value = repr(float(number[0]) * draw.choice([-1] + 9 * [1]) * 10 ** draw.uniform(-8, 8))
    lines[i] = lines[i][: number.start()] + value + lines[i][number.end() :]


def other_word(draw, lines):
    quoted = [i for i in lines_with(lines, r'"\w+"') if not lines[i].startswith(("title", "file"))]
    if quoted:
        i = draw.choice(quoted)
        word = draw.choice(re.findall(r'"\w+"', lines[i]))
        lines[i] = lines[i].replace(word, f'"{draw.choice(WORDS)}"', 1)


def missing_line(draw, lines):
    del lines[draw.randrange(len(lines))]


def line_twice(draw, lines):
    i = draw.randrange(len(lines))
    lines.insert(draw.randrange(len(lines)), lines[i])


def swapped_tables(draw, lines):
    heads = lines_with(lines, r"^\[\w+\.\w+\]")
    if len(heads) > 1:
        i, j = draw.sample(heads, 2)
        lines[i], lines[j] = lines[j], lines[i]


def misspelt_key(draw, lines):
    i = draw.choice(lines_with(lines, r"^\w+ =") or [0])
    lines[i] = draw.choice([lines[i].replace(" =", "x =", 1), "x" + lines[i], lines[i].replace(" = ", " ", 1)])


def added_table(draw, lines):
    lines.append(draw.choice(ADDITIONS))


def cut_short(draw, lines):
    i = draw.randrange(len(lines))
    lines[i:] = [lines[i][: draw.randrange(len(lines[i]) + 1)]]


MISTAKES = [other_number] * 16 + [other_word] * 6 + [missing_line] * 3 + [added_table] * 5 + \
           [line_twice, swapped_tables, misspelt_key, cut_short]


def with_mistakes(draw, text):
    """The text with none to three mistakes; some of them are legal."""
    lines = text.splitlines()
    for _ in range(draw.choice([0, 1, 1, 1, 1, 2, 3])):
        if lines:
            draw.choice(MISTAKES)(draw, lines)
    return "\n".join(lines) + "\n"
