"""Sources of a library that are compiled as one (packaging/unity.py) make the same program as one by one.

usage: unity_test.py FOLDER_OF_THE_PROJECT
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

UNITY = Path(sys.argv[1]).resolve() / "packaging/unity.py"


class Unity(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def units(self, largest=10, **sources):
        """The sources' names, a list for each unit; all units are compiled and linked, and the program's output is the last."""
        for name, text in sources.items():
            (self.folder / (name + ".cpp")).write_text(text)
        (self.folder / "said.h").write_text("#pragma once\nint a();\nint b();\n")
        units = self.folder / "units"
        listed = "\n".join(name + ".cpp" for name in sources)
        subprocess.run(["/usr/bin/python3", "-B", UNITY, self.folder, str(largest), units], input=listed, text=True, check=True)
        files = sorted(units.iterdir())
        subprocess.run(["c++", "-I", self.folder, *files, "-o", self.folder / "program"], check=True)
        told = subprocess.run([self.folder / "program"], capture_output=True, text=True, check=True).stdout
        return [[name for name in sources if f"/{name}.cpp" in file.read_text()] for file in files] + [told]

    def test_what_goes_together_is_one(self):
        main = "#include <cstdio>\n#include \"said.h\"\nint main() { std::printf(\"%d\", a()); }\n"
        self.assertEqual(self.units(a="int a() { return 3; }\n", main=main), [["a", "main"], "3"])
        self.assertEqual(self.units(largest=1, a="int a() { return 3; }\n", main=main)[-1], "3")

    def test_alike_names_come_apart(self):
        own = ("static int own() {{ return {0}; }}\n", "namespace {{\n  int own() {{ return {0}; }}\n}}\n", "static int own = {0};\nstatic int f() {{ return own; }}\n",
               "struct own {{ int n = {0}; }};\n", "static std::string own() {{ return std::string({0}, 'x'); }}\n", "static int (*own)(int) = nullptr;\nstatic int g = {0};\n",
               "namespace {{\ntypedef struct {{\n  int n;\n}} own;\nint g = {0};\n}}\n")
        for text in own:
            with self.subTest(text):
                sources = {name: f"#include <string>\n{text.format(n)}int {name}() {{ return {n}; }}\n" for n, name in ((1, "a"), (2, "b"))}
                main = "#include <cstdio>\n#include \"said.h\"\nint main() { std::printf(\"%d\", a() + b()); }\n"
                found = self.units(**sources, main=main)
                self.assertEqual(found, [["a", "main"], ["b"], "3"])
                for file in (self.folder / "units").iterdir():
                    file.unlink()

    def test_macros_end_with_their_source(self):
        main = "#include <cstdio>\n#include \"said.h\"\n#ifdef N\n#error\n#endif\nint main() { int N = a(); std::printf(\"%d\", N); }\n"
        self.assertEqual(self.units(a="#define N 4\nint a() { return N; }\n", main=main), [["a", "main"], "4"])

    def test_headers_without_guard_are_part_of_a_source(self):
        (self.folder / "open.h").write_text("static int table[] = {1, 2};\n")
        (self.folder / "guarded.h").write_text("#ifndef G\n#define G\nstatic int other = 5;\n#endif\n")
        both = '#include "{0}/open.h"\n#include "{0}/guarded.h"\n'.format(self.folder)
        main = both + "#include <cstdio>\n#include \"said.h\"\nint main() { std::printf(\"%d\", a() + other + table[0]); }\n"
        self.assertEqual(self.units(a=both + "int a() { return table[1]; }\n", main=main), [["a"], ["main"], "8"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
