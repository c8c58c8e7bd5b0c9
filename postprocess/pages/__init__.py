"""What the scripts that write pages of docs/ are made of: gallery.py and reference.py."""
