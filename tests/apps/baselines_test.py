# SPDX-License-Identifier: Apache-2.0
"""Baselines: learnt from a recording, looked at, driven side by side, by the same commands."""

import json

from pacer_command import (BAD_USAGE, DRIVES, FAILED, SCENARIO, SMALL, CommandTest, main, settings)

GIVEN = {"supervised": "in training", "tracker": "in training and at the start"}
QUICK = ["nearest", "ridge", "ridge-hog", "tracker"]
SHORT = [*SMALL, *settings(simulated__duration_s=2, following__duration_s=2)]


class Baselines(CommandTest):

    def learn(self, method, jobs=1, name=None):
        model = self.scratch / f"{name or method}.model"
        report = self.json_of("train", method, DRIVES, "--out", model, "--jobs", jobs)
        self.assertEqual(report["frames"], 450)
        self.assertEqual(report["marked"] > 0, method in GIVEN, "who is not given boxes reads none")
        return model

    def test_each_is_learnt_looked_at_and_driven_and_says_what_it_was_given(self):
        models = {method: self.learn(method) for method in [*QUICK, "supervised"]}
        for method, model in models.items():
            about = self.json_of("inspect", model)
            self.assertEqual(about.get("given_boxes"), GIVEN.get(method), method)
            self.assertTrue(about["fingerprint"], method)
        report = self.scratch / "report.html"
        out = self.scratch / "report.json"
        said = self.pacer("evaluate", SCENARIO, *SHORT, "--policy", *models.values(), "teacher",
                          "mean", "--episodes", 1, "--clips", 0, "--out", report, "--json",
                          out).stdout
        self.assertIn("given boxes", said)
        found = json.loads(out.read_text())["policies"]
        self.assertEqual(list(found), [*models, "teacher", "mean"])
        for method in found:
            self.assertEqual(found[method].get("given_boxes"), GIVEN.get(method), method)
        page = report.read_text()
        self.assertIn("Given boxes", page)
        self.assertIn("Action signals", page, "all models watch the teacher")

    def test_the_same_recording_makes_the_same_bytes_on_any_number_of_threads(self):
        one, two = self.learn("ridge", 1), self.learn("ridge", 2, name="other")
        self.assertEqual(one.read_bytes(), two.read_bytes())

    def test_a_tracker_is_refused_where_nobody_can_point(self):
        replay = settings(car="replayed", replayed__dataset=DRIVES)
        why = self.refusal("drive", SCENARIO, *replay, "--policy", self.learn("tracker"),
                           status=BAD_USAGE)
        self.assertIn("set car=simulated", why)
        self.pacer("drive", SCENARIO, *replay, "--policy", self.learn("ridge"))

    def test_who_is_given_boxes_refuses_a_recording_without_them(self):
        laps = self.scratch / "laps"
        lane = SCENARIO.replace("follow.yaml", "lane.yaml")
        self.pacer("collect", lane, "--out", laps, "--episodes", 1, *SMALL)
        for method in GIVEN:
            why = self.refusal("train", method, laps, "--out", self.scratch / "x.model",
                               status=BAD_USAGE)
            self.assertIn("privileged.lead_box", why)

    def test_a_damaged_model_is_refused(self):
        whole = self.learn("ridge").read_bytes()
        damaged = self.scratch / "damaged.model"
        for size in (0, 7, 100, len(whole) - 1):
            damaged.write_bytes(whole[:size])
            self.assertIn("damaged.model", self.refusal("inspect", damaged, status=FAILED))

    def test_a_baseline_does_not_grow(self):
        self.assertIn("only exemplar models grow", self.refusal(
            "train", "ridge", DRIVES, "--onto", self.learn("ridge"), "--out",
            self.scratch / "x.model", status=BAD_USAGE))


if __name__ == "__main__":
    main()
