"""Shared by tests of studies: small ones, how they are run, and disks that are full, slow or without hard links."""

import csv
import pathlib
import subprocess
import sys
import time

import h5py

from program import PROGRAM, ProgramTest, upbead

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
from section_scene import scene  # noqa: E402

SMALL = scene(("cells = 0.5, seabed_front = 60, seabed_back = 60", "cells = 0.3, grading = 4"), ("peak = 1e6", "peak = 8e6"),
              ("end = 0.6", "end = 0.3"), *2 * [(", frequencies = [1, 10]", "")]) + "[sliding]\nsubmerged_weight = 4.3e6\n"

STUDY = """title = "small"
case = "small.toml"
read = ["response.shear_to_force_ratio", "sliding.sliding_history", "response.arm"]
[vary."regions.seabed.shear_modulus"]
from = 20e6
to = 60e6
n = 3
[vary."mesh.parameters.mound_height"]
values = [5, 6]
[vary."sliding.friction"]
values = [0.5, 0.6]
[follow."regions.mound.shear_modulus"]
key = "regions.seabed.shear_modulus"
factor = 1.5
"""

# two solutions, four rows
SHORT = """case = "small.toml"
read = ["response.shear_to_force_ratio"]
[vary."mesh.parameters.mound_height"]
values = [5, 6]
[vary."sliding.friction"]
values = [0.5, 0.6]
"""

RANDOM = """case = "small.toml"
sample = "random"
n = {n}
[vary."regions.seabed.shear_modulus"]
distribution = "log_normal"
mean = 30e6
cov = 0.3
"""
MANY = 60  # runs, so that a study has not ended before a test interrupts it


# A disk on which writing to a journal takes long, that is full in the middle of its third line, or has no hard links; locks of a file system may
# hang; or the first process that has written the line of a run ends before it can say so
DISK = """#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>
static int is(const char* mode) { const char* set = getenv("DISK"); return set && !strcmp(set, mode); }
int flock(int fd, int op) { return op & LOCK_EX ? (abort(), 0) : ((int (*)(int, int))dlsym(RTLD_NEXT, "flock"))(fd, op); }
int link(const char* from, const char* to) {
  if (is("no_links")) { errno = EPERM; return -1; }
  return ((int (*)(const char*, const char*))dlsym(RTLD_NEXT, "link"))(from, to);
}
ssize_t write(int fd, const void* bytes, size_t n) {
  static int lines = 0;
  ssize_t (*real)(int, const void*, size_t) = (ssize_t (*)(int, const void*, size_t))dlsym(RTLD_NEXT, "write");
  int is_line = n > 8 && !memcmp(bytes, "{\\"run\\":", 7);
  if (is_line && is("slow")) usleep(150000);
  if (is("full") && lines >= 3) { errno = ENOSPC; return -1; }
  if (is_line && is("full") && ++lines == 3) n /= 2;
  ssize_t written = real(fd, bytes, n);
  if (is_line && is("ends") && open("ended", O_CREAT | O_EXCL, 0600) >= 0) kill(getpid(), SIGKILL);
  return written;
}
"""


def preloaded(folder):
    (folder / "disk.c").write_text(DISK)
    subprocess.run(["gcc", "-shared", "-fPIC", "-o", "disk.so", "disk.c", "-ldl"], cwd=folder, check=True)
    return str(folder / "disk.so")


class StudyTest(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "small.toml").write_text(SMALL)
        (self.folder / "study.toml").write_text(STUDY)

    def study(self, *arguments, code=0, jobs="1", **options):
        """Runs the study on so many processes; None: on as many as the program chooses."""
        words = [] if jobs is None else ["--jobs", jobs]
        done = upbead("study", "study.toml", *arguments, *words, cwd=self.folder, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def rows(self, out="results/study"):
        with open(self.folder / out / "study.csv", newline="") as file:
            return list(csv.DictReader(file))

    def table(self, out):
        """All results of a study: the bytes of study.csv, and all datasets of study.h5."""
        found = {"csv": (self.folder / out / "study.csv").read_bytes()}
        with h5py.File(self.folder / out / "study.h5") as file:
            file.visititems(lambda name, data: found.update({name: data[()].tobytes() if data.dtype.kind == "f"
                            else [*data.asstr()]}) if isinstance(data, h5py.Dataset) else None)
        return found

    def journal_lines(self, out):
        return sum(max(0, len(path.read_text().splitlines()) - 1) for path in (self.folder / out / "journal").glob("*.jsonl"))

    def processes_of(self, process):
        """The workers of a study that runs."""
        try:
            return [int(n) for n in pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()]
        except FileNotFoundError:
            return []

    def start(self, n, *arguments, out="killed", done=3, **options):
        """Starts a study of n runs and waits until so many are done."""
        (self.folder / "study.toml").write_text(RANDOM.format(n=n))
        process = subprocess.Popen([PROGRAM, "study", "study.toml", "--out", out, *arguments], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
        while self.journal_lines(out) < done:
            self.assertIsNone(process.poll(), "it ended too soon")
            time.sleep(0.01)
        return process
