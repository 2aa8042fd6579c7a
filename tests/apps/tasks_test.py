# SPDX-License-Identifier: Apache-2.0
"""Other tasks than following the vehicle, from demonstrations to scores: a person, a lane."""

import pathlib

from pacer_command import (BAD_USAGE, EPISODES, LEARN_LITTLE, SCENARIO, SMALL, CommandTest, main,
                           settings)

PERSON = pathlib.Path(SCENARIO).with_name("person.yaml")
LANE = pathlib.Path(SCENARIO).with_name("lane.yaml")
SHORT = settings(following__duration_s=6, keeping__duration_s=6, keeping__least_distance_m=1)


class Tasks(CommandTest):

    def learn(self, scenario):
        """A few short demonstrations, and a model of them."""
        out = self.scratch / "drives"
        self.pacer("collect", scenario, "--out", out, "--episodes", EPISODES, *SMALL)
        self.assertTrue(self.json_of("inspect", out)["whole"])
        model = self.scratch / "learned.model"
        self.pacer("train", "affordance", out, "--out", model, *LEARN_LITTLE)
        return out, model

    def scores(self, scenario, model, jobs):
        found = self.json_of("evaluate", scenario, *SMALL, *SHORT, "--policy", model, "teacher",
                             "neutral", "--episodes", 2, "--clips", 1, "--jobs", jobs, "--out",
                             self.scratch / "report.html")["policies"]
        for policy in found.values():
            del policy["response_ms"]
        return found

    def assert_refused(self, model, scenario, way_out):
        """A model drives for the goal that it was learnt with."""
        for command in [["drive", scenario], ["evaluate", scenario, "--episodes", 1]]:
            self.assertIn(way_out, self.refusal(*command, *SMALL, "--policy", model,
                                                status=BAD_USAGE))

    def test_a_person_is_followed_as_the_vehicle_is(self):
        _, model = self.learn(PERSON)
        found = self.scores(PERSON, model, jobs=2)
        self.assertEqual(set(found["teacher"]["episodes"][0]) & {"followed", "lost"},
                         {"followed", "lost"})
        self.assertGreater(found["teacher"]["in_view"]["value"], 0.8)
        self.assertEqual(found["teacher"]["collided"]["value"], 0.0)
        self.assertIn("Follow the walking person.", (self.scratch / "report.html").read_text())
        self.assert_refused(model, LANE, "learnt with goal: follow; set goal=follow, as "
                            "scenarios/follow.yaml does")

    def test_a_lane_is_taught_learnt_driven_and_scored(self):
        drives, model = self.learn(LANE)
        again = self.scratch / "again"
        self.pacer("collect", LANE, "--out", again, "--episodes", EPISODES, "--jobs", 2, *SMALL)
        self.assert_same_trees(drives, again)
        found = self.scores(LANE, model, jobs=1)
        self.assertEqual(found, self.scores(LANE, model, jobs=2))
        self.assertEqual(found["teacher"]["kept"]["value"], 1.0)
        self.assertGreater(found["teacher"]["distance_m"]["value"], 1.0)
        self.assertEqual(found["neutral"]["kept"]["value"], 0.0)
        self.assertEqual(found["neutral"]["stuck"]["value"], 1.0)
        page = (self.scratch / "report.html").read_text()
        self.assertIn("not kept, stuck", page)
        self.assertIn("Action signals", page)
        self.assertNotIn("ollowed", page.split("<pre")[0])
        self.assert_refused(model, SCENARIO, "learnt with goal: keep; set goal=keep, as "
                            "scenarios/lane.yaml does")

    def test_an_episode_in_a_lane_is_filmed(self):
        film = self.scratch / "lane.mp4"
        found = self.json_of("drive", LANE, *SMALL, *SHORT, "--video", film)
        self.assertTrue(found["score"]["kept"])
        self.assertGreater(film.stat().st_size, 10000)

    def test_what_the_world_does_not_serve_is_refused(self):
        self.assertIn("simulated.world.lead_body", self.refusal(
            "drive", PERSON, "--set", "simulated.world.lead_body=dog", status=BAD_USAGE))
        self.assertIn("simulated.world.layout", self.refusal(
            "drive", SCENARIO, "--set", "goal=keep", status=BAD_USAGE))
        self.assertIn("simulated.world.lane.radius_m", self.refusal(
            "drive", LANE, "--set", "simulated.world.lane.radius_m=0.3", status=BAD_USAGE))


if __name__ == "__main__":
    main()
