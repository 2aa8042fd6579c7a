# SPDX-License-Identifier: Apache-2.0
"""Collecting, driving and evaluating where the goal is to reach the red balloon."""

import pathlib

from pacer_command import BAD_USAGE, SCENARIO, CommandTest, main, settings

BALLOON = pathlib.Path(SCENARIO).with_name("balloon.yaml")
# Small pictures of near balloons: seconds.
NEAR = settings(simulated__camera__width_px=160, simulated__camera__height_px=120,
                simulated__world__placement__distance_m="[1.2, 2.0]")


class Balloon(CommandTest):

    def collect(self, name, jobs=1):
        out = self.scratch / name
        said = self.pacer("collect", BALLOON, "--out", out, "--episodes", 2, "--jobs", jobs,
                          *NEAR).stdout
        self.assertIn("2 episodes (2 new)", said)
        return out

    def test_demonstrations_end_at_the_balloon_and_repeat_byte_for_byte(self):
        one = self.collect("one")
        found = self.json_of("inspect", one)
        self.assertTrue(found["whole"], found)
        self.assertLess(found["seconds"], 2 * 70)
        self.assert_same_trees(one, self.collect("two", jobs=2))
        said = self.pacer("drive", BALLOON, "--set", "car=replayed", "--set",
                          f"replayed.dataset={one}", "--policy", "neutral").stdout
        self.assertIn("neutral: ", said)

    def test_policies_are_scored_by_what_they_reach(self):
        def scores(jobs):
            found = self.json_of("evaluate", BALLOON, *NEAR, "--policy", "teacher", "neutral",
                                 "--episodes", 2, "--clips", 1, "--jobs", jobs, "--out",
                                 self.scratch / "report.html")["policies"]
            for policy in found.values():
                del policy["response_ms"]
            return found
        found = scores(1)
        self.assertEqual(found, scores(2))
        self.assertEqual(found["teacher"]["reached"]["value"], 1.0)
        self.assertEqual(found["neutral"]["reached"]["value"], 0.0)
        self.assertEqual(found["neutral"]["stuck"]["value"], 1.0)
        self.assertEqual(found["neutral"]["impulses"]["value"], 0.0)
        for episode in found["teacher"]["episodes"]:
            self.assertGreater(episode["impulses"], 0)
            self.assertLessEqual(episode["distance_m"], 0.5)
        page = (self.scratch / "report.html").read_text()
        self.assertIn("teacher reached", page)
        self.assertIn("not reached, stuck", page)
        self.assertNotIn("ollowed", page.split("<pre")[0])
        self.assertIn("data:video/mp4;base64,", page)

    def test_an_episode_is_driven_scored_and_filmed(self):
        film = self.scratch / "drive.mp4"
        found = self.json_of("drive", BALLOON, *NEAR, "--video", film)
        self.assertTrue(found["score"]["reached"])
        self.assertGreater(film.stat().st_size, 10000)

    def test_a_goal_that_the_world_does_not_serve_is_refused(self):
        self.assertIn("simulated.world.layout", self.refusal(
            "drive", BALLOON, "--set", "goal=follow", status=BAD_USAGE))
        self.assertIn("simulated.world.layout", self.refusal(
            "drive", SCENARIO, "--set", "goal=reach", status=BAD_USAGE))
        self.assertIn("goal: expected follow, reach or keep", self.refusal(
            "drive", BALLOON, "--set", "goal=flee", status=BAD_USAGE))


if __name__ == "__main__":
    main()
