# SPDX-License-Identifier: Apache-2.0
"""What the world does wrong is answered by one line that says what, where and what to do."""

import os
import resource
import shutil
import signal
import unittest

from pacer_command import (BAD_USAGE, DRIVES, FAILED, MODEL, SCENARIO, SMALL, CommandTest, collect,
                           main, settings, train)

OTHER_SIZE = settings(simulated__duration_s=2, simulated__camera__width_px=128,
                      simulated__camera__height_px=96)


def little_room():
    """In the child: no file may grow beyond 20 kB, as on a disk that is nearly full."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))


class BadInput(CommandTest):

    def drive(self, policy, *rest):
        return ["drive", SCENARIO, *SMALL, "--policy", policy, *rest]

    def test_a_truncated_model_is_refused(self):
        whole = MODEL.read_bytes()
        model = self.scratch / "cut.model"
        for size in [0, 3, 40, len(whole) // 2, len(whole) - 1]:
            model.write_bytes(whole[:size])
            for command in [self.drive(model), ["inspect", model]]:
                self.assertIn(str(model), self.refusal(*command, status=FAILED))

    def test_a_model_with_a_flipped_bit_is_refused(self):
        damaged = bytearray(MODEL.read_bytes())
        damaged[len(damaged) // 2] ^= 4
        model = self.scratch / "flipped.model"
        model.write_bytes(damaged)
        self.assertIn(str(model), self.refusal("inspect", model, status=FAILED))

    def test_what_is_no_model_is_refused(self):
        self.assertIn(SCENARIO, self.refusal(*self.drive(SCENARIO), status=FAILED))

    def test_a_model_for_another_camera_is_refused(self):
        line = self.refusal("drive", SCENARIO, *OTHER_SIZE, "--policy", MODEL, status=FAILED)
        self.assertIn("160 x 120", line)
        self.assertIn("128 x 96", line)

    def test_a_dataset_of_another_camera_or_rate_is_left_as_it_is(self):
        out = self.scratch / "d"
        shutil.copytree(DRIVES, out)
        for other in [settings(simulated__camera__width_px=128),
                      settings(simulated__camera__frame_rate_hz=20)]:
            self.assertIn(str(out), self.refusal(*collect(out, episodes=4), *other,
                                                 status=BAD_USAGE))
        self.assert_same_trees(DRIVES, out)

    def test_a_folder_of_something_else_is_left_as_it_is(self):
        out = self.scratch / "letters"
        out.mkdir()
        (out / "letter.txt").write_text("dear")
        self.refusal(*collect(out), status=BAD_USAGE)
        self.assertEqual([path.name for path in out.iterdir()], ["letter.txt"])

    def test_learning_from_what_is_no_dataset_is_refused(self):
        empty = self.scratch / "empty"
        empty.mkdir()
        for dataset in [empty, self.scratch / "missing"]:
            line = self.refusal(*train(self.scratch / "m", dataset), status=BAD_USAGE)
            self.assertIn(str(dataset), line)

    def test_learning_from_a_damaged_dataset_is_refused_and_leaves_no_model(self):
        dataset = self.scratch / "d"
        shutil.copytree(DRIVES, dataset)
        video = next(dataset.glob("videos/**/*.mp4"))
        video.write_bytes(video.read_bytes()[:2000])
        line = self.refusal(*train(self.scratch / "m", dataset), status=FAILED)
        self.assertIn(video.name, line)
        self.assertEqual(list(self.scratch.glob("m*")), [])

    def test_a_folder_that_cannot_be_made_is_named(self):
        file = self.scratch / "file"
        file.write_text("not a folder")
        self.assertIn(str(file), self.refusal(*collect(file / "drives"), status=FAILED))

    def test_a_file_that_cannot_be_written_is_named_before_the_work(self):
        file = self.scratch / "file"
        file.write_text("not a folder")
        for command in [train(file / "m"), train(""), train(self.scratch),
                        self.drive("neutral", "--video", file / "drive.mp4"),
                        self.drive("neutral", "--json", file / "drive.json"),
                        self.drive("neutral", "--json", "")]:
            self.assertIn("cannot be written", self.refusal(*command, status=BAD_USAGE))

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_a_folder_that_may_not_be_written_is_named(self):
        self.scratch.chmod(0o500)
        self.addCleanup(self.scratch.chmod, 0o700)
        for status, command in [(FAILED, collect(self.scratch / "drives")),
                                (BAD_USAGE, train(self.scratch / "m"))]:
            self.assertIn(str(self.scratch), self.refusal(*command, status=status))

    def test_a_disk_that_fills_up_while_recording_loses_nothing_that_was_there(self):
        out = self.scratch / "d"
        self.pacer(*collect(out, episodes=1))
        line = self.refusal(*collect(out), status=FAILED, preexec_fn=little_room)
        self.assertIn(str(out), line)
        self.pacer("inspect", out)
        self.pacer(*collect(out))
        self.assert_same_trees(DRIVES, out)

    def test_a_disk_that_fills_up_while_a_model_is_written_leaves_the_old_one(self):
        model = self.scratch / "m"
        shutil.copy(MODEL, model)
        self.refusal(*train(model), status=FAILED, preexec_fn=little_room)
        self.assertEqual(model.read_bytes(), MODEL.read_bytes())
        self.assertEqual([path.name for path in self.scratch.iterdir()], ["m"])

    def test_a_disk_that_fills_up_under_a_report_leaves_the_old_one(self):
        report = self.scratch / "report.html"
        report.write_text("the old one")
        self.refusal("evaluate", SCENARIO, *SMALL, "--policy", "neutral", "--episodes", 1,
                     "--clips", 0, "--out", report, status=FAILED, preexec_fn=little_room)
        self.assertEqual(report.read_text(), "the old one")
        self.assertEqual([path.name for path in self.scratch.iterdir()], ["report.html"])

    def test_no_result_takes_the_place_of_what_is_read_or_of_another(self):
        drives = self.scratch / "d"
        shutil.copytree(DRIVES, drives)
        both = self.scratch / "both.mp4"
        for command in [train(drives / "meta/info.json", drives),
                        ["inspect", drives, "--json", drives / "meta/stats.json"],
                        ["inspect", MODEL, "--json", MODEL],
                        self.drive("neutral", "--video", both, "--json", both)]:
            self.assertIn("name another file", self.refusal(*command, status=BAD_USAGE))
        self.assert_same_trees(DRIVES, drives)

    def test_a_film_is_an_mp4(self):
        self.assertIn("ends in .mp4", self.refusal(
            *self.drive("neutral", "--video", self.scratch / "film.avi"), status=BAD_USAGE))
        self.assertEqual(list(self.scratch.iterdir()), [])

    def test_a_picture_is_a_png(self):
        self.assertIn("ends in .png", self.refusal(
            "inspect", DRIVES, "--sheet", self.scratch / "sheet.jpg", status=BAD_USAGE))
        self.assertEqual(list(self.scratch.iterdir()), [])

    def test_where_nothing_can_be_written_is_told_before_the_work(self):
        for command in [self.drive("neutral", "--video", "/proc/x.mp4"),
                        ["inspect", MODEL, "--json", "/proc/x.json"],
                        ["inspect", DRIVES, "--sheet", "/proc/x.png"]]:
            self.assertIn("name a file that can be written",
                          self.refusal(*command, status=BAD_USAGE))
        self.assertIn("name a place that can be written", self.refusal(
            *collect("/proc/drives"), status=FAILED))

    def test_a_lost_scenario_is_to_be_put_back(self):
        dataset = self.scratch / "d"
        shutil.copytree(DRIVES, dataset)
        (dataset / "meta/scenario.yaml").unlink()
        line = self.refusal(*train(self.scratch / "m", dataset), status=FAILED)
        self.assertIn("put it back, or record anew", line)
        self.assertNotIn("--repair", line)

    def test_an_info_without_its_values_is_named_in_plain_words(self):
        dataset = self.scratch / "d"
        shutil.copytree(DRIVES, dataset)
        (dataset / "meta/info.json").write_text("{}")
        line = self.refusal(*train(self.scratch / "m", dataset), status=FAILED)
        self.assertNotIn("exception", line)
        self.assertIn("put the file back, or record anew", line)
        said = self.pacer("inspect", dataset, status=FAILED).stdout
        self.assertEqual(said.count("info.json"), 1, said)

    def test_a_fault_names_its_file_once(self):
        for pattern in ["videos/**/*.mp4", "data/**/*.parquet"]:
            dataset = self.scratch / pattern[:4]
            shutil.copytree(DRIVES, dataset)
            file = next(dataset.glob(pattern))
            file.write_bytes(file.read_bytes()[:2000])
            line = self.refusal(*train(self.scratch / "m", dataset), status=FAILED)
            self.assertEqual(line.count(file.name), 1, line)
            self.assertNotIn(".;", line)

    def test_a_recorded_car_is_neither_taught_nor_scored(self):
        replay = settings(car="replayed", replayed__dataset=DRIVES)
        out = self.scratch / "d"
        self.assertIn("car", self.refusal(*collect(out), *replay, status=BAD_USAGE))
        self.assertIn("car", self.refusal("evaluate", SCENARIO, *SMALL, *replay, "--policy",
                                          "neutral", status=BAD_USAGE))
        self.assertNotIn("score", self.json_of(*self.drive("neutral"), *replay))

    def test_numbers_that_do_not_fit_are_refused(self):
        for option in [["--seed", -1], ["--seed", "9" * 30], ["--episode", -1]]:
            self.assertIn("whole number", self.refusal(*self.drive("neutral"), *option,
                                                       status=BAD_USAGE))

    def test_a_full_device_is_named(self):
        link = self.scratch / "full.mp4"
        link.symlink_to("/dev/full")
        for command in [["inspect", DRIVES, "--quick", "--json", link],
                        ["evaluate", SCENARIO, *SMALL, "--policy", "neutral", "--episodes", 1,
                         "--clips", 0, "--out", link],
                        self.drive("neutral", "--video", link)]:
            self.assertIn(str(link), self.refusal(*command, status=FAILED))
            self.assertTrue(link.is_symlink())

    def test_learning_from_swapped_videos_is_refused(self):
        dataset = self.scratch / "d"
        shutil.copytree(DRIVES, dataset)
        one, other = sorted(dataset.glob("videos/**/*.mp4"))[:2]
        one.rename(self.scratch / "aside")
        other.rename(one)
        (self.scratch / "aside").rename(other)
        self.assertIn("hash", self.refusal(*train(self.scratch / "m", dataset), status=FAILED))

    def test_a_model_for_another_frame_rate_is_refused(self):
        line = self.refusal(*self.drive(MODEL, "--set", "simulated.camera.frame_rate_hz=20"),
                            status=BAD_USAGE)
        self.assertIn("20", line)

    def test_a_machine_without_opengl_is_told_so(self):
        line = self.refusal(*self.drive("neutral"), status=FAILED,
                            env={**os.environ, "MUJOCO_EGL_DEVICE_ID": "999"})
        self.assertIn("MUJOCO_EGL_DEVICE_ID", line)


if __name__ == "__main__":
    main()
