# SPDX-License-Identifier: Apache-2.0
"""Learning the percept-action hierarchy from clicks, looking at it, correcting it, driving by it."""

import pathlib
import struct

from pacer_command import (BAD_USAGE, DRIVES, FAILED, MODEL, SCENARIO, CommandTest, main,
                           settings)

BALLOON = pathlib.Path(SCENARIO).with_name("balloon.yaml")
NEAR = settings(simulated__camera__width_px=160, simulated__camera__height_px=120,
                simulated__world__placement__distance_m="[1.2, 2.0]")


def of_its_first(model, exemplars):
    """The bytes of a model, with the first of its exemplars alone."""
    header = 8 + 4 + 8
    body = model[header:-8]
    percepts, actions = 8 * 18, 8 * 2
    first_action = len(body) - exemplars * actions
    first_percept = first_action - 8 - exemplars * percepts
    body = (body[:first_percept - 8]
            + struct.pack("<Q", 18) + body[first_percept:first_percept + percepts]
            + struct.pack("<Q", 2) + body[first_action:first_action + actions])
    checksum = 0xcbf29ce484222325
    for byte in body:
        checksum = (checksum ^ byte) * 0x100000001b3 % 2**64
    return model[:12] + struct.pack("<Q", len(body)) + body + struct.pack("<Q", checksum)


class Exemplars(CommandTest):

    def learn(self, name, seed, *more):
        clicks = self.scratch / f"{name}-clicks"
        self.pacer("collect", BALLOON, "--out", clicks, "--episodes", 3, "--seed", seed, *NEAR)
        model = self.scratch / f"{name}.model"
        self.pacer("train", "exemplar", clicks, "--out", model, *more)
        return model

    def test_a_hierarchy_is_learnt_looked_at_corrected_and_driven(self):
        model = self.learn("clicks", 1)
        about = self.json_of("inspect", model)
        self.assertGreater(about["exemplars"], 10)
        sheet = self.scratch / "hierarchy.png"
        self.pacer("inspect", model, "--sheet", sheet)
        self.assertTrue(sheet.read_bytes().startswith(b"\x89PNG"))

        corrected = self.learn("more", 2, "--onto", model)
        self.assertGreater(self.json_of("inspect", corrected)["exemplars"], about["exemplars"])

        found = self.json_of("evaluate", BALLOON, *NEAR, "--policy", corrected, "mean",
                             "--episodes", 2, "--clips", 0)["policies"]
        self.assertGreater(found["more"]["impulses"]["value"], 0.0)

    def test_a_model_of_one_exemplar_is_looked_at_and_driven(self):
        model = self.learn("clicks", 1)
        one = self.scratch / "one.model"
        one.write_bytes(of_its_first(model.read_bytes(),
                                     self.json_of("inspect", model)["exemplars"]))
        sheet = self.scratch / "one.png"
        about = self.json_of("inspect", one, "--sheet", sheet)
        self.assertEqual((about["exemplars"], about["nodes"], about["models"]), (1, 1, 0))
        self.assertTrue(sheet.read_bytes().startswith(b"\x89PNG"))
        self.assertNotIn("deviation", self.pacer("inspect", one).stdout)
        self.pacer("evaluate", BALLOON, *NEAR, "--policy", one, "--episodes", 1, "--clips", 0)

    def test_the_same_clicks_make_the_same_bytes(self):
        one = self.learn("clicks", 1)
        other = self.scratch / "other.model"
        self.pacer("train", "exemplar", self.scratch / "clicks-clicks", "--out", other)
        self.assertEqual(one.read_bytes(), other.read_bytes())

    def test_a_model_of_the_other_task_is_refused(self):
        model = self.learn("clicks", 1)
        self.assertIn("set goal=reach", self.refusal(
            "drive", SCENARIO, "--policy", model, status=BAD_USAGE))
        self.assertIn("set goal=follow", self.refusal(
            "drive", BALLOON, *NEAR, "--policy", MODEL, status=BAD_USAGE))
        self.assertIn("not an exemplar model", self.refusal(
            "train", "exemplar", self.scratch / "clicks-clicks", "--onto", MODEL, "--out",
            self.scratch / "x.model", status=BAD_USAGE))

    def test_a_wrong_goal_is_wrong_use_for_evaluate_as_for_drive(self):
        model = self.learn("clicks", 1)
        self.assertIn("set goal=reach", self.refusal(
            "evaluate", SCENARIO, "--policy", model, "--episodes", 1, status=BAD_USAGE))

    def test_a_recording_of_the_other_goal_is_refused_at_once(self):
        model = self.learn("clicks", 1)
        for method, dataset, *more in [("exemplar", DRIVES), ("exemplar", DRIVES, "--onto", model),
                                       ("affordance", self.scratch / "clicks-clicks")]:
            line = self.refusal("train", method, dataset, "--out", self.scratch / "x.model", *more,
                                status=BAD_USAGE)
            self.assertIn(str(dataset), line)
            self.assertIn("goal: ", line)
            self.assertFalse((self.scratch / "x.model").exists())

    def test_what_was_recorded_cannot_be_set(self):
        model = self.learn("clicks", 1)
        clicks = self.scratch / "clicks-clicks"
        out = self.scratch / "x.model"
        for setting in ["simulated.camera.width_px=640", "impulses.move_s=10"]:
            self.assertIn(setting, self.refusal("train", "exemplar", clicks, "--out", out, "--set",
                                                setting, status=BAD_USAGE))
        self.assertIn("keeps its settings", self.refusal(
            "train", "exemplar", clicks, "--onto", model, "--out", out, "--set",
            "exemplar.hierarchy.tau=20", status=BAD_USAGE))
        self.pacer("train", "exemplar", clicks, "--out", out, "--seed", 3, "--set",
                   "exemplar.hierarchy.tau=20")
        self.assertEqual(self.json_of("inspect", out)["tau"], 20)

    def test_no_dataset_is_learnt_twice(self):
        model = self.learn("clicks", 1)
        self.assertIn("already", self.refusal(
            "train", "exemplar", self.scratch / "clicks-clicks", "--onto", model, "--out",
            self.scratch / "x.model", status=BAD_USAGE))

    def test_what_grows_says_by_how_much(self):
        model = self.learn("clicks", 1)
        had = self.json_of("inspect", model)["exemplars"]
        more = self.scratch / "more"
        self.pacer("collect", BALLOON, "--out", more, "--episodes", 1, "--seed", 2, *NEAR)
        said = self.pacer("train", "exemplar", more, "--onto", model, "--out",
                          self.scratch / "grown.model").stdout
        self.assertRegex(said, rf"added \d+ exemplars? to {had}\b")

    def test_a_model_never_takes_the_place_of_something_else(self):
        self.learn("clicks", 1)
        letter = self.scratch / "letter.txt"
        letter.write_text("dear")
        self.assertIn("is no model", self.refusal(
            "train", "exemplar", self.scratch / "clicks-clicks", "--out", letter,
            status=BAD_USAGE))
        self.assertEqual(letter.read_text(), "dear")

    def test_pictures_of_another_size_are_wrong_use_and_the_model_is_named(self):
        model = self.learn("clicks", 1)
        for command in [["drive"], ["evaluate", "--episodes", 1]]:
            line = self.refusal(command[0], BALLOON, *command[1:], "--policy", model,
                                status=BAD_USAGE)
            self.assertIn("--policy clicks: a picture of 320 x 240", line)

    def test_the_same_model_twice_is_two_rows(self):
        model = self.learn("clicks", 1)
        teacher = self.scratch / "teacher.model"
        teacher.write_bytes(model.read_bytes())
        found = self.json_of("evaluate", BALLOON, *NEAR, "--policy", model, model, teacher,
                             "teacher", "--episodes", 1, "--clips", 0)["policies"]
        self.assertEqual(list(found), ["clicks", "clicks-2", "teacher-2", "teacher"])

    def test_colours_that_cannot_be_told_apart_are_refused(self):
        colours = "exemplar.percept.colours."
        for setting in [colours + "red_balloon.red=1000000", colours + "red_balloon.tint=0",
                        colours + "tolerance=0", "impulses.brake=0",
                        colours + "green_balloon={red: 0.86, green: 0.07, blue: 0.08}"]:
            self.refusal("inspect", BALLOON, "--set", setting, status=BAD_USAGE)

    def test_damaged_models_are_refused(self):
        whole = self.learn("clicks", 1).read_bytes()
        damaged = self.scratch / "damaged.model"
        for size in (0, 7, 100, len(whole) // 2, len(whole) - 1):
            damaged.write_bytes(whole[:size])
            self.assertIn("damaged.model", self.refusal("inspect", damaged, status=FAILED))


if __name__ == "__main__":
    main()
