# SPDX-License-Identifier: Apache-2.0
"""A recording that teaches nothing, or hardly anything, is refused, or the model says so."""

from pacer_command import (BAD_USAGE, DONE, DRIVES, FAILED, LEARN_LITTLE, MODEL, SCENARIO, SMALL,
                           CommandTest, main, run, settings)

# The same hand whatever is seen: neither stick moves.
ONE_ACTION = settings(teacher__steering_per_rad="[0,0]", teacher__edge_px=0,
                      teacher__steering_noise=0, limits__throttle_cap=0.004,
                      limits__brake_cap=0.004)
NO_TARGET = settings(simulated__world__lead="false")
ALL_CORRUPTED = settings(simulated__camera__link__corrupted=1)
ALL_SNOW = ALL_CORRUPTED + settings(simulated__camera__link__whole=1)
TEN_FRAMES = settings(simulated__duration_s=0.4)


class LittleData(CommandTest):

    def record(self, *how, episodes=2):
        out = self.scratch / "drives"
        self.pacer("collect", SCENARIO, "--out", out, "--episodes", episodes, *SMALL, *how)
        return out

    def refused(self, dataset, *more):
        model = self.scratch / "a.model"
        done = run("train", "affordance", dataset, "--out", model, *LEARN_LITTLE, *more)
        lines = [line for line in done.stderr.splitlines() if line.startswith("pacer: ")]
        self.assertIn(done.returncode, [FAILED, BAD_USAGE], done.stdout + done.stderr)
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertFalse(model.exists())
        return lines[0]

    def test_one_action_is_refused(self):
        self.assertIn("one action only", self.refused(self.record(*ONE_ACTION)))

    def test_no_target_in_view_is_refused(self):
        self.assertIn("one action only", self.refused(self.record(*NO_TARGET)))

    def test_ten_frames_are_refused(self):
        self.assertRegex(self.refused(self.record(*TEN_FRAMES, episodes=1)),
                         "one action only|no rule holds")

    def test_snow_alone_is_refused(self):
        self.assertIn("one action only", self.refused(self.record(*ALL_SNOW)))

    def test_what_is_learnt_from_corrupted_frames_alone_is_refused_or_said_to_be_little(self):
        dataset = self.record(*ALL_CORRUPTED)
        model = self.scratch / "a.model"
        done = run("train", "affordance", dataset, "--out", model, *LEARN_LITTLE)
        if done.returncode != DONE:
            self.assertRegex(self.refused(dataset), "one action only|no rule holds|no features")
            return
        self.assertIn("knows little: ", done.stdout)
        self.assertIn("knows little: ", self.pacer("inspect", model).stdout)
        self.assertTrue(self.json_of("inspect", model)["knows_little"])

    def test_a_model_says_in_one_line_what_it_knows(self):
        said = self.pacer("inspect", MODEL).stdout
        self.assertEqual(said.count("\nknows "), 1, said)
        self.assertIn("of 6 action types", said)

    def test_a_lag_is_not_looked_for_in_one_episode(self):
        lines = self.refused(self.record(episodes=1),
                             *settings(affordance__transactions__lag_s="found"))
        self.assertIn("two episodes", lines)

    def test_settings_out_of_range_are_refused(self):
        for key, value in [("transactions__lag_s", "soon"), ("transactions__lag_s", "2"),
                           ("features__kinds", "[surf]"), ("features__kinds", "[sift, sift]"),
                           ("features__kinds", "[]"), ("features__kinds", "[sift, orb, akaze]"),
                           ("mining__wanted_rules", "-1"), ("mining__wanted_rules", "60000"),
                           ("transactions__most_frames", "0")]:
            line = self.refused(DRIVES, *settings(**{f"affordance__{key}": value}))
            self.assertRegex(line, key.split("__")[1] + "|words.descriptor", key)


if __name__ == "__main__":
    main()
