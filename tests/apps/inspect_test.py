# SPDX-License-Identifier: Apache-2.0
"""`inspect` tells what is in a dataset or a model, finds what is broken, and mends it."""

import shutil

from pacer_command import BAD_USAGE, DRIVES, FAILED, MODEL, SCENARIO, CommandTest, collect, main


class Inspect(CommandTest):

    def damaged(self):
        """A copy whose last episode's video lacks its end."""
        out = self.scratch / "damaged"
        shutil.copytree(DRIVES, out)
        video = sorted(out.glob("videos/**/*.mp4"))[-1]
        video.write_bytes(video.read_bytes()[:-5000])
        return out, video

    def test_a_dataset_is_summed_up(self):
        said = self.pacer("inspect", DRIVES).stdout
        self.assertIn("3 episodes, 450 frames, 18.0 s of 160 x 120 at 25 Hz", said)
        self.assertIn("Follow the lead vehicle.", said)
        self.assertIn("by teacher: 450 frames", said)
        self.assertEqual(said.splitlines()[-1], "whole")

    def test_the_summary_is_there_for_programs_too(self):
        found = self.json_of("inspect", DRIVES, "--quick")
        self.assertEqual(found, {"episodes": 3, "frames": 450, "seconds": 18.0, "whole": True,
                                 "findings": []})

    def test_a_contact_sheet_is_drawn(self):
        sheet = self.scratch / "sheet.png"
        self.pacer("inspect", DRIVES, "--sheet", sheet)
        self.assertEqual(sheet.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_a_broken_file_is_found_by_its_name_and_nothing_is_changed(self):
        out, video = self.damaged()
        before = video.read_bytes()
        said = self.pacer("inspect", out, status=FAILED).stdout
        self.assertIn(video.name, said)
        self.assertIn("--repair", said)
        self.assertEqual(video.read_bytes(), before)

    def test_a_repaired_dataset_is_whole_and_can_be_recorded_on_to_the_same_bytes(self):
        out, _ = self.damaged()
        said = self.pacer("inspect", out, "--repair").stdout
        self.assertIn("2 episodes, 300 frames", said)
        self.assertEqual(len(list((out / ".dropped").rglob("*.mp4"))), 1, "kept aside")
        self.pacer(*collect(out))
        shutil.rmtree(out / ".dropped")
        self.assert_same_trees(DRIVES, out)

    def test_repairing_what_is_whole_changes_nothing(self):
        out = self.scratch / "d"
        shutil.copytree(DRIVES, out)
        self.assertNotIn("mended", self.pacer("inspect", out, "--repair").stdout)
        self.assert_same_trees(DRIVES, out)

    def test_what_does_not_go_with_the_thing_inspected_is_refused(self):
        sheet = self.scratch / "sheet.png"
        for what, option in [(SCENARIO, ["--sheet", sheet]), (MODEL, ["--sheet", sheet]),
                             (MODEL, ["--repair"]), (SCENARIO, ["--quick"])]:
            self.assertIn(option[0], self.refusal("inspect", what, *option, status=BAD_USAGE))
        self.assertFalse(sheet.exists())

    def test_a_model_is_summed_up(self):
        said = self.pacer("inspect", MODEL).stdout
        self.assertIn("for 160 x 120 at 25 Hz", said)
        types = self.json_of("inspect", MODEL)["action_types"]
        self.assertEqual(len(types), 6)
        self.assertGreater(sum(kind["rules"] for kind in types), 0)


if __name__ == "__main__":
    main()
