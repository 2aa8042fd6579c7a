# SPDX-License-Identifier: Apache-2.0
"""Simulated tracking sequences: whole or not at all, the same bytes again, nothing overwritten."""

import json
import signal
import subprocess
import time

from pacer_command import BAD_USAGE, COMMAND, FAILED, CommandTest, main

NAME = "car-surveillance"  # the quickest
FRAMES = 282


class Sequences(CommandTest):

    def start(self, *arguments):
        child = subprocess.Popen([COMMAND, *map(str, arguments)], stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True)
        self.addCleanup(child.stdout.close)
        self.addCleanup(child.stderr.close)
        self.addCleanup(child.kill)
        return child

    def render(self, out, *rest):
        return ["sequences", "--out", out, NAME, *rest]

    def cut_short(self, out, frame, how):
        """Renders as far as `frame`, ends it, and returns its exit status and what it said."""
        child = self.start(*self.render(out))
        while not list(out.glob(f".unfinished-*/img/{frame:04}.jpg")):
            self.assertIsNone(child.poll(), "it ended before it was ended")
            time.sleep(0.02)
        child.send_signal(how)
        _, said = child.communicate(timeout=60)
        return child.returncode, said

    def test_they_are_whole_or_not_there_and_the_same_bytes_again(self):
        out = self.scratch / "cut"
        self.cut_short(out, 10, signal.SIGKILL)
        self.assertFalse((out / NAME).exists())
        status, said = self.cut_short(out, 60, signal.SIGINT)
        self.assertEqual(status, FAILED, said)
        self.assertIn("interrupted: the same command goes on from here", said)
        self.assertFalse((out / NAME).exists())

        self.assertIn(f"{FRAMES} frames of 320 x 240\n", self.pacer(*self.render(out)).stdout)
        self.assertEqual([path.name for path in out.iterdir()], [NAME])
        pictures = sorted(path.name for path in (out / NAME / "img").iterdir())
        self.assertEqual(pictures, [f"{i:04}.jpg" for i in range(1, FRAMES + 1)])
        boxes = (out / NAME / "groundtruth_rect.txt").read_text().splitlines()
        self.assertEqual(len(boxes), FRAMES)
        self.assertTrue(all(float(number) > 0 for box in boxes for number in box.split(",")))
        self.assertEqual(json.loads((out / NAME / "simulated.json").read_text())["seed"], 1)

        again = self.scratch / "again"
        found = self.json_of(*self.render(again, "--jobs", 2, "--seed", 1))
        self.assert_same_trees(out, again)
        self.assertEqual([(one["name"], one["frames"], one["was_there"])
                          for one in found["sequences"]], [(NAME, FRAMES, False)])

        self.assertIn(", was there", self.pacer(*self.render(out)).stdout)
        self.assert_same_trees(out, again)
        self.assertIn("another seed",
                      self.refusal(*self.render(out, "--seed", 2), status=BAD_USAGE))
        self.assert_same_trees(out, again)

    def test_a_folder_of_something_else_is_left_as_it_is(self):
        place = self.scratch / "out" / NAME
        place.mkdir(parents=True)
        (place / "letter.txt").write_text("dear")
        line = self.refusal(*self.render(self.scratch / "out"), status=BAD_USAGE)
        self.assertIn(str(place), line)
        self.assertEqual([path.name for path in place.iterdir()], ["letter.txt"])

    def test_a_name_there_is_not_is_answered_with_those_there_are(self):
        line = self.refusal("sequences", "--out", self.scratch / "out", "car-chase",
                            status=BAD_USAGE)
        self.assertIn("car-chase", line)
        self.assertIn(NAME, line)
        self.assertFalse((self.scratch / "out").exists(), "nothing was begun")

    def test_a_folder_that_cannot_be_made_is_named(self):
        file = self.scratch / "file"
        file.write_text("not a folder")
        self.assertIn(str(file), self.refusal(*self.render(file / "out"), status=FAILED))


if __name__ == "__main__":
    main()
