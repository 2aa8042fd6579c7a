# SPDX-License-Identifier: Apache-2.0
"""`drive` films an episode, `evaluate` reports on several, `doctor` looks at the machine."""

import json
import subprocess

from pacer_command import MODEL, SCENARIO, SMALL, CommandTest, main


class Drive(CommandTest):

    def test_an_episode_is_driven_scored_and_filmed(self):
        film = self.scratch / "drive.mp4"
        found = self.json_of("drive", SCENARIO, *SMALL, "--policy", MODEL, "--until-the-end",
                             "--video", film)
        self.assertEqual(found["frames"], 150)
        self.assertAlmostEqual(found["score"]["driven_s"], 6.0)
        stream = json.loads(subprocess.run(
            ["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames",
             "-of", "json", film], check=True, capture_output=True).stdout)["streams"][0]
        self.assertEqual(int(stream["nb_read_frames"]), 150)

    def test_an_evaluation_leaves_a_report_that_carries_all_it_needs(self):
        report = self.scratch / "report.html"
        said = self.pacer("evaluate", SCENARIO, *SMALL, "--policy", MODEL, "teacher", "neutral",
                          "--episodes", 1, "--clips", 1, "--out", report).stdout
        for policy in ["learned", "teacher", "neutral"]:
            self.assertIn(f"| {policy} |", said)
        page = report.read_text()
        self.assertIn("data:video/mp4;base64,", page)
        self.assertNotIn('src="http', page)

    def test_the_doctor_finds_what_the_program_needs(self):
        found = self.json_of("doctor")["findings"]
        self.assertLessEqual({"processors", "OpenGL", "simulated frames", "MuJoCo", "video"},
                             {finding["what"] for finding in found})
        self.assertNotIn("missing", {finding["verdict"] for finding in found})


if __name__ == "__main__":
    main()
