# SPDX-License-Identifier: Apache-2.0
"""The built `pacer`, run as a user runs it. The tests of whole commands are made of this.

From the environment: PACER, the command; PACER_SCENARIO, the shipped scenario; PACER_RECORDED, the
folder where record_and_learn.py left a dataset (drives) and a model (learned.model) to share.
"""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

COMMAND = os.environ["PACER"]
SCENARIO = os.environ["PACER_SCENARIO"]
RECORDED = pathlib.Path(os.environ.get("PACER_RECORDED", "."))
DRIVES = RECORDED / "drives"
MODEL = RECORDED / "learned.model"
EPISODES = 3

DONE, FAILED, BAD_USAGE = 0, 1, 2


def settings(**values):
    """--set for each; two underscores stand for the dot."""
    return [word for key, value in values.items()
            for word in ("--set", f"{key.replace('__', '.')}={value}")]


# Small pictures and short episodes: seconds, where the shipped scenario takes minutes.
SMALL = settings(simulated__duration_s=6, simulated__camera__width_px=160,
                 simulated__camera__height_px=120)
LEARN_LITTLE = settings(affordance__transactions__wanted=3000, affordance__words__samples=3000,
                        affordance__mining__min_stretches=1,
                        affordance__mining__confidence_percent=80)


def collect(out, episodes=EPISODES, jobs=1):
    return ["collect", SCENARIO, "--out", out, "--episodes", episodes, "--jobs", jobs, *SMALL]


def train(out, dataset=DRIVES, jobs=1):
    return ["train", "affordance", dataset, "--out", out, "--jobs", jobs, *LEARN_LITTLE]


def run(*arguments, **options):
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True,
                          timeout=300, **options)


def tree(folder):
    """Every file below and its bytes."""
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in sorted(folder.rglob("*")) if path.is_file()}


class CommandTest(unittest.TestCase):
    """A test with a scratch folder of its own."""

    maxDiff = 2000

    def setUp(self):
        self.scratch = pathlib.Path(tempfile.mkdtemp(prefix="pacer-"))
        self.addCleanup(shutil.rmtree, self.scratch, ignore_errors=True)

    def pacer(self, *arguments, status=DONE, **options):
        """Runs it, demands that it ends with `status`, and returns what it said."""
        done = run(*arguments, **options)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def refusal(self, *arguments, status, **options):
        """The one line with which it refuses."""
        done = self.pacer(*arguments, status=status, **options)
        lines = [line for line in done.stderr.splitlines() if line.startswith("pacer: ")]
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertEqual(done.stderr.splitlines()[-1], lines[0], "and it is the last")
        return lines[0]

    def assert_same_trees(self, one, other):
        one, other = tree(one), tree(other)
        self.assertTrue(one)
        self.assertEqual(one.keys(), other.keys())
        self.assertEqual([name for name in one if one[name] != other[name]], [])

    def json_of(self, *arguments, **options):
        out = self.scratch / "result.json"
        self.pacer(*arguments, "--json", out, **options)
        return json.loads(out.read_text())


main = unittest.main
