# SPDX-License-Identifier: Apache-2.0
"""A study as a user runs it, on pictures of his own."""

import math

from pacer_command import BAD_USAGE, SCENARIO, CommandTest, main, run


def write_picture(file, shift):
    """A grey texture of 160 x 140 pixels, as a binary PGM."""
    def value(x, y):
        return 128 + 60 * math.sin(0.21 * x + 0.13 * y + shift) + 60 * math.sin(
            0.19 * y - 0.17 * x * math.cos(0.02 * y + shift))
    pixels = bytes(int(value(x, y)) for y in range(140) for x in range(160))
    file.write_bytes(b"P5\n160 140\n255\n" + pixels)


class Study(CommandTest):

    def test_convergence_is_the_same_for_any_number_of_jobs_and_says_what_it_was_tried_on(self):
        pictures = self.scratch / "pictures"
        (pictures / "more").mkdir(parents=True)
        write_picture(pictures / "a.pgm", 0.0)
        write_picture(pictures / "more" / "b.pgm", 1.0)
        results = []
        for jobs in [1, 2]:
            out = self.scratch / f"out{jobs}"
            result = self.json_of("study", "convergence", "--scenario", SCENARIO, "--images",
                                  pictures, "--jobs", str(jobs), "--out", out)
            self.assertIn("more/b.pgm", (out / "convergence.html").read_text())
            results.append(result)
        figures = results[0]["figures"]
        self.assertEqual(figures["tests"], 60000)
        self.assertEqual(figures["pictures"], ["a.pgm", "more/b.pgm"])
        self.assertEqual(len(figures["curves"]["LP flock"]["error_px"]), 20)
        named = [claim["name"] for claim in results[0]["claims"]]
        self.assertTrue(set(named) <= set(figures), named)
        for result in results:
            del result["figures"]["seconds"]
        self.assertEqual(results[0]["figures"], results[1]["figures"])

    def test_tracking_says_what_is_wrong_with_its_sequences_before_any_work(self):
        (self.scratch / "empty").mkdir()
        for folder, why in [("nowhere", "no such folder"), ("empty", "no sequences")]:
            result = run("study", "tracking", "--scenario", SCENARIO, "--sequences",
                         self.scratch / folder, "--cache", self.scratch / "cache")
            self.assertEqual(result.returncode, BAD_USAGE)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
            self.assertIn(why, result.stderr)
        self.assertFalse((self.scratch / "cache").exists())


if __name__ == "__main__":
    main()
