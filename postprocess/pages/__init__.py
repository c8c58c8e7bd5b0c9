"""Parts of the scripts gallery.py and reference.py, which write pages of docs/."""
