# SPDX-License-Identifier: Apache-2.0
"""What is asked wrongly is answered by one line that helps, and status 2."""

import pathlib
import subprocess

from pacer_command import BAD_USAGE, COMMAND, SCENARIO, CommandTest, main, run

COMMANDS = ["collect", "train", "evaluate", "drive", "sequences", "track", "inspect", "study", "doctor"]


class Usage(CommandTest):

    def test_help_lists_every_command_and_says_where_to_begin(self):
        said = self.pacer("--help").stdout
        for command in COMMANDS:
            self.assertIn(f"\n  {command} ", said)
        self.assertIn("Begin with:", said)

    def test_every_command_explains_itself_with_an_example(self):
        for command in COMMANDS:
            said = self.pacer(command, "--help").stdout
            self.assertIn(f"Example: pacer {command}", said)
            for option in ["--set", "--seed", "--json", "--jobs"]:
                self.assertIn(option, said, command)

    def test_no_arguments_point_to_the_help(self):
        self.assertIn("--help", self.pacer(status=BAD_USAGE).stderr)

    def test_an_unknown_command_is_named(self):
        self.assertIn("frobnicate", self.refusal("frobnicate", status=BAD_USAGE))

    def test_an_unknown_option_is_named(self):
        done = self.pacer("collect", SCENARIO, "--out", self.scratch / "d", "--frob",
                          status=BAD_USAGE)
        self.assertIn("--frob", done.stderr)

    def test_a_missing_option_is_named(self):
        self.assertIn("--out", self.pacer("collect", SCENARIO, status=BAD_USAGE).stderr)

    def test_an_unknown_key_is_named_with_the_keys_there_are(self):
        line = self.refusal("collect", SCENARIO, "--out", self.scratch / "d",
                            "--set", "simulated.camera.witdh_px=160", status=BAD_USAGE)
        self.assertIn("--set: simulated.camera.witdh_px: unknown key", line)
        self.assertIn("width_px", line)
        self.assertFalse((self.scratch / "d").exists(), "nothing was begun")

    def test_a_value_out_of_its_range_is_named(self):
        for setting in ["simulated.camera.frame_rate_hz=-1", "limits.throttle_cap=7",
                        "simulated.camera.width_px=many", "car=flying"]:
            line = self.refusal("inspect", SCENARIO, "--set", setting, status=BAD_USAGE)
            self.assertIn(setting.split("=")[0].split(".")[-1], line)

    def test_json_to_a_redirected_standard_output_comes_after_what_is_printed(self):
        both = self.scratch / "both"
        with both.open("w") as stdout:
            subprocess.run([COMMAND, "inspect", SCENARIO, "--json", "/dev/stdout"], stdout=stdout,
                           check=True, timeout=60)
        said = both.read_text()
        self.assertLess(said.index("name: "), said.index('"scenario": '))

    def test_a_setting_without_a_value_is_refused(self):
        self.assertIn("limits", self.refusal("inspect", SCENARIO, "--set", "limits.throttle_cap",
                                             status=BAD_USAGE))

    def test_a_wrong_key_in_a_file_is_found_by_file_and_line(self):
        file = self.scratch / "wrong.yaml"
        file.write_text("name: wrong\nlimits:\n  throttle_cup: 0.3\n")
        line = self.refusal("inspect", file, status=BAD_USAGE)
        self.assertIn(f"{file}:3: limits.throttle_cup: unknown key", line)

    def test_a_file_that_is_no_yaml_is_found_by_file_and_line(self):
        file = self.scratch / "broken.yaml"
        file.write_text("name: broken\nlimits: [1, 2\n")
        self.assertIn(f"{file}:", self.refusal("inspect", file, status=BAD_USAGE))

    def test_a_file_that_is_not_there_is_named(self):
        missing = self.scratch / "missing.yaml"
        for command in [["collect", missing, "--out", self.scratch / "d"],
                        ["drive", missing],
                        ["evaluate", missing, "--policy", "neutral"],
                        ["inspect", missing]]:
            self.assertIn(str(missing), self.refusal(*command, status=BAD_USAGE))

    def test_an_unknown_policy_is_named_with_those_there_are(self):
        line = self.refusal("drive", SCENARIO, "--policy", "nobody", status=BAD_USAGE)
        self.assertIn("nobody", line)
        self.assertIn("teacher", line)

    def test_the_mean_of_no_model_is_refused(self):
        self.refusal("evaluate", SCENARIO, "--policy", "mean", status=BAD_USAGE)

    def test_a_study_of_the_other_goal_is_refused(self):
        self.assertIn("goal: reach", self.refusal("study", "generalisation", "--scenario",
                                                  SCENARIO, status=BAD_USAGE))

    def test_tasks_are_not_measured_behind_another_lead_than_a_person(self):
        self.assertIn("simulated.world.lead_body: vehicle", self.refusal(
            "study", "tasks", "--scenario", SCENARIO, cwd=pathlib.Path(SCENARIO).parents[1],
            status=BAD_USAGE))

    def test_an_unknown_study_is_named_with_those_there_are(self):
        line = self.refusal("study", "nothing", "--scenario", SCENARIO, status=BAD_USAGE)
        self.assertIn("nothing", line)
        self.assertIn("following", line)

    def test_pictures_that_are_not_there_are_named(self):
        empty = self.scratch / "empty"
        empty.mkdir()
        for folder in [empty, self.scratch / "missing"]:
            line = self.refusal("study", "convergence", "--scenario", SCENARIO, "--images", folder,
                                status=BAD_USAGE)
            self.assertIn(str(folder), line)

    def test_a_picture_that_is_none_is_named(self):
        file = self.scratch / "picture.png"
        file.write_text("no picture")
        line = self.refusal("study", "weighting", "--scenario", SCENARIO, "--images", self.scratch,
                            status=1)
        self.assertIn(str(file), line)

    def test_a_written_out_scenario_is_the_same_scenario(self):
        whole = self.pacer("inspect", SCENARIO, "--set", "simulated.duration_s=7",
                           "--seed", "5").stdout
        file = self.scratch / "whole.yaml"
        file.write_text(whole)
        self.assertIn("duration_s: 7\n", whole)
        self.assertIn("seed: 5\n", whole)
        self.assertEqual(self.pacer("inspect", file).stdout, whole)

    def test_a_result_is_never_put_in_the_place_of_what_is_no_file(self):
        link = self.scratch / "out"
        link.symlink_to("/proc/self/fd/1")  # as /dev/stdout is, which is not to be risked
        self.assertIn('"findings"', run("doctor", "--json", link).stdout)
        self.assertTrue(link.is_symlink())


if __name__ == "__main__":
    main()
