"""How scripts write a figure."""

from ..kept import keep_inputs


def save(figure, path, *inputs):
    """Writes the figure in the format of the file's ending (.png, .pdf, .svg), never over one of `inputs`."""
    keep_inputs(path, *inputs)
    from .. import figures  # only imported by scripts that make a figure

    figures.save(figure, path)
    print(path)
