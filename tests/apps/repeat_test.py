# SPDX-License-Identifier: Apache-2.0
"""The same command writes the same bytes: with more workers, interrupted, killed, or again."""

import json
import os
import random
import re
import shutil
import signal
import subprocess
import time

from pacer_command import (COMMAND, DRIVES, FAILED, MODEL, SCENARIO, SMALL, CommandTest, collect,
                           main, train)


class Repeat(CommandTest):

    def start(self, command, **options):
        child = subprocess.Popen([COMMAND, *map(str, command)], stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True, **options)
        self.addCleanup(child.stdout.close)
        self.addCleanup(child.stderr.close)
        self.addCleanup(child.kill)
        return child

    def test_two_workers_record_the_same_bytes_as_one(self):
        self.pacer(*collect(self.scratch / "two", jobs=2))
        self.assert_same_trees(DRIVES, self.scratch / "two")

    def test_a_dataset_recorded_in_two_goes_is_the_same(self):
        out = self.scratch / "resumed"
        self.pacer(*collect(out, episodes=1))
        self.assertIn("3 episodes (2 new)", self.pacer(*collect(out)).stdout)
        self.assert_same_trees(DRIVES, out)
        self.assertIn("3 episodes (0 new)", self.pacer(*collect(out)).stdout)
        self.assert_same_trees(DRIVES, out)

    def test_a_killed_recording_is_whole_and_ends_up_the_same(self):
        out = self.scratch / "killed"
        moments = random.Random(5)
        started = time.monotonic()
        kills = 0
        while time.monotonic() < started + 40:  # then the machine is too slow for more
            child = self.start(collect(out))
            try:
                child.wait(timeout=moments.uniform(0.2, 2.5))
                break
            except subprocess.TimeoutExpired:
                child.send_signal(signal.SIGKILL)
                child.wait()
                kills += 1
            if (out / "meta" / "info.json").exists():
                self.pacer("inspect", out)  # it ends with 0: whole, as far as it goes
        self.assertGreater(kills, 0)
        self.pacer(*collect(out))
        self.assert_same_trees(DRIVES, out)

    def test_ctrl_c_leaves_what_is_written_whole(self):
        out = self.scratch / "interrupted"
        child = self.start(collect(out))
        while not list(out.glob("meta/episodes/**/*.parquet")) and child.poll() is None:
            time.sleep(0.05)
        child.send_signal(signal.SIGINT)
        _, said = child.communicate(timeout=60)
        self.assertEqual(child.returncode, FAILED, said)
        self.assertIn("interrupted: the same command goes on from here", said)
        self.pacer("inspect", out)
        self.pacer(*collect(out))
        self.assert_same_trees(DRIVES, out)

    def test_an_evaluation_that_timeout_ends_shows_what_was_finished(self):
        out = self.scratch / "scores.json"
        child = self.start(["evaluate", SCENARIO, *SMALL, "--policy", "neutral", "--episodes", 500,
                            "--clips", 0, "--jobs", 1, "--json", out], start_new_session=True)
        while not re.match(r"episodes: [1-9]", child.stderr.readline()):
            self.assertIsNone(child.poll())
        child.send_signal(signal.SIGTERM)  # as `timeout` does: the process, then its group
        time.sleep(0.05)
        os.killpg(child.pid, signal.SIGTERM)
        said, errors = child.communicate(timeout=60)
        self.assertEqual(child.returncode, FAILED, errors)
        self.assertIn("| neutral", said)
        finished = len(json.loads(out.read_text())["policies"]["neutral"]["episodes"])
        self.assertTrue(0 < finished < 500, finished)

    def test_a_model_learnt_again_with_two_threads_is_the_same(self):
        self.pacer(*train(self.scratch / "again.model", jobs=2))
        self.assertEqual((self.scratch / "again.model").read_bytes(), MODEL.read_bytes())

    def test_another_seed_gives_another_dataset(self):
        out = self.scratch / "other"
        self.pacer(*collect(out, episodes=1), "--seed", "2")
        data = "data/chunk-000/file-000.parquet"
        self.assertNotEqual((out / data).read_bytes(), (DRIVES / data).read_bytes())

    def test_scores_repeat_but_for_measured_times(self):
        def scores(jobs):
            shutil.copy(MODEL, self.scratch / "learned.model")
            found = self.json_of("evaluate", SCENARIO, *SMALL, "--policy",
                                 self.scratch / "learned.model", "teacher", "neutral", "mean",
                                 "--episodes", 2, "--clips", 0, "--jobs", jobs)
            self.assertEqual(list(found["policies"]), ["learned", "teacher", "neutral", "mean"])
            for policy in found["policies"].values():
                self.assertEqual(len(policy["episodes"]), 2)
                del policy["response_ms"]
            return found
        self.assertEqual(scores(1), scores(2))


if __name__ == "__main__":
    main()
