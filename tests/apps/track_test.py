# SPDX-License-Identifier: Apache-2.0
"""`track` follows targets through sequences, scores, films and reports; and what it refuses."""

import json
import os
import random
import signal
import struct
import subprocess
import zlib

from pacer_command import BAD_USAGE, COMMAND, FAILED, CommandTest, main, run

WIDTH, HEIGHT = 160, 120
PATCH = 36
NO_DISPLAY = {key: value for key, value in os.environ.items()
              if key not in ("DISPLAY", "WAYLAND_DISPLAY")}


def png(rows):
    """A grey PNG file of rows of bytes."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data
                + struct.pack(">I", zlib.crc32(kind + data)))
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head)
            + chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows), 1))
            + chunk(b"IEND", b""))


def blotches(rng, width, height, low, high):
    """A random pattern of soft blotches, so that there is something to follow at every scale."""
    coarse = [[rng.randint(low, high) for _ in range(width // 6 + 2)]
              for _ in range(height // 6 + 2)]
    def at(x, y):
        (i, a), (j, b) = divmod(x, 6), divmod(y, 6)
        top = coarse[j][i] * (6 - a) + coarse[j][i + 1] * a
        bottom = coarse[j + 1][i] * (6 - a) + coarse[j + 1][i + 1] * a
        return (top * (6 - b) + bottom * b) // 36
    return [bytes(at(x, y) for x in range(width)) for y in range(height)]


def place_of(frame):
    """Where the patch's top-left pixel is, counted from 0: to and fro, up and down."""
    across, down = frame % 60, frame % 80
    return 20 + 2 * min(across, 60 - across), 30 + min(down, 80 - down)


def write_sequence(folder, frames):
    """A bright patch that moves over a darker room, in OTB's layout."""
    rng = random.Random(7)
    room = blotches(rng, WIDTH, HEIGHT, 20, 110)
    patch = blotches(rng, PATCH, PATCH, 90, 250)
    (folder / "img").mkdir(parents=True)
    lines = []
    for frame in range(frames):
        x, y = place_of(frame)
        rows = [room[row] if not y <= row < y + PATCH else
                room[row][:x] + patch[row - y] + room[row][x + PATCH:] for row in range(HEIGHT)]
        (folder / "img" / f"{frame + 1:04d}.png").write_bytes(png(rows))
        lines.append(f"{x + 1},{y + 1},{PATCH},{PATCH}\n")
    (folder / "groundtruth_rect.txt").write_text("".join(lines))
    return folder


class Track(CommandTest):

    FRAMES = 50

    def setUp(self):
        super().setUp()
        self.sequence = write_sequence(self.scratch / "sequences" / "Patch", self.FRAMES)
        self.truth = self.sequence / "groundtruth_rect.txt"

    def boxes(self, file):
        return [[float(word) for word in line.split(",")]
                for line in file.read_text().splitlines()]

    def test_it_follows_a_sequence_and_says_how_well(self):
        out = self.scratch / "results.txt"
        found = self.json_of("track", self.sequence, "--out", out)
        self.assertEqual(list(found["trackers"]), [found["default_tracker"]])
        scores = found["trackers"][found["default_tracker"]]["Patch"]
        self.assertEqual(scores["frames"], self.FRAMES)
        self.assertEqual(scores["scored"], self.FRAMES)
        self.assertEqual(scores["frames_held"], self.FRAMES)
        self.assertEqual(scores["failures"], 0)
        self.assertEqual(scores["precision"], 1)
        self.assertGreater(scores["success"], 0.7)
        self.assertGreater(scores["fps"], 0)
        self.assertIsNone(scores["error"])
        boxes = self.boxes(out)
        self.assertEqual(len(boxes), self.FRAMES)
        for frame, (x, y, width, height) in enumerate(boxes):
            wanted = [place + 1 + PATCH / 2 for place in place_of(frame)]
            self.assertAlmostEqual(x + width / 2, wanted[0], delta=8)
            self.assertAlmostEqual(y + height / 2, wanted[1], delta=8)

    def test_the_same_seed_gives_the_same_bytes(self):
        def bytes_of(*options):
            out = self.scratch / "results.txt"
            self.pacer("track", self.sequence, "--out", out, "--video", self.scratch / "film.mp4",
                       *options)
            return out.read_bytes(), (self.scratch / "film.mp4").read_bytes()
        self.assertEqual(bytes_of("--seed", 5), bytes_of("--seed", 5))

    def test_a_typed_box_is_read_as_the_truth_is(self):
        files = [self.scratch / "truth.txt", self.scratch / "typed.txt"]
        self.pacer("track", self.sequence, "--out", files[0])
        self.pacer("track", self.sequence, "--out", files[1], "--box",
                   self.truth.read_text().splitlines()[0])
        self.assertEqual(files[0].read_bytes(), files[1].read_bytes())
        self.assertEqual(self.boxes(files[0])[0], [21, 31, PATCH, PATCH])

    def test_results_can_be_the_truth_of_a_sequence(self):
        self.pacer("track", self.sequence, "--out", self.scratch / "results.txt")
        self.truth.write_bytes((self.scratch / "results.txt").read_bytes())
        found = self.json_of("track", self.sequence)
        scores = found["trackers"][found["default_tracker"]]["Patch"]
        self.assertGreater(scores["success"], 0.95)

    def test_trackers_are_compared_over_a_folder_of_sequences(self):
        write_sequence(self.scratch / "sequences" / "Short", 20)
        page = self.scratch / "report.html"
        command = ["track", self.scratch / "sequences", "--tracker", "MOSSE", "KCF"]
        found = self.json_of(*command, "--out", self.scratch / "one", "--jobs", 1)
        said = self.pacer(*command, "--out", self.scratch / "two", "--jobs", 2, "--report", page)
        self.assertIn("| MOSSE", said.stdout)
        self.assertEqual(list(found["trackers"]), ["MOSSE", "KCF"])
        for scores in found["trackers"].values():
            self.assertEqual(list(scores), ["Patch", "Short"])
        self.assert_same_trees(self.scratch / "one", self.scratch / "two")
        self.assertEqual(len(self.boxes(self.scratch / "one" / "KCF" / "Short.txt")), 20)
        html = page.read_text()
        for part in ["MOSSE [", "KCF [", 'id="patch"', 'id="short"', "data:video/mp4"]:
            self.assertIn(part, html)

    def test_every_tracker_there_is_runs(self):
        known = self.pacer("track", "--help").stdout.split("Trackers:")[1]
        write_sequence(self.scratch / "few" / "Patch", 8)
        found = self.json_of("track", self.scratch / "few", "--tracker", "all")
        self.assertIn("KCF", found["trackers"])
        for name, scores in found["trackers"].items():
            self.assertIn(f"\n  {name} ", known)
            self.assertIsNone(scores["Patch"]["error"], name)

    def test_a_video_is_followed_from_a_typed_box(self):
        film = self.scratch / "film.mp4"
        self.pacer("track", self.sequence, "--video", film)
        out = self.scratch / "results.txt"
        said = self.pacer("track", film, "--box", "60,60,60,60", "--out", out).stdout
        self.assertIn(f"{self.FRAMES} pictures", said)
        self.assertNotIn("success", said, "nothing is known of it")
        self.assertEqual(len(self.boxes(out)), self.FRAMES)
        line = self.refusal("track", film, status=BAD_USAGE)
        self.assertIn(str(film), line)
        self.assertIn("--box", line)

    def test_several_trackers_are_filmed_together(self):
        film = self.scratch / "film.mp4"
        self.pacer("track", self.sequence, "--tracker", "MOSSE", "KCF", "--video", film)
        self.assertEqual(film.read_bytes()[4:8], b"ftyp")
        write_sequence(self.scratch / "sequences" / "Other", 3)
        self.assertIn("--video", self.refusal("track", self.scratch / "sequences", "--video", film,
                                              status=BAD_USAGE))

    def test_robustness_is_measured_when_asked_for(self):
        found = self.json_of("track", self.sequence, "--tracker", "MOSSE", "--robustness")
        scores = found["trackers"]["MOSSE"]["Patch"]
        for kind in ["tre", "sre"]:
            self.assertTrue(0 < scores[kind]["success"] < 1)

    def test_what_is_annotated_in_part_is_scored_in_part(self):
        lines = self.truth.read_text().splitlines()
        lines[:10] = ["NaN,NaN,NaN,NaN"] * 10
        self.truth.write_text("\n".join(lines))
        out = self.scratch / "results.txt"
        found = self.json_of("track", self.sequence, "--out", out)
        scores = found["trackers"][found["default_tracker"]]["Patch"]
        self.assertEqual(scores["scored"], self.FRAMES - 10)
        lines = out.read_text().splitlines()
        self.assertEqual(len(lines), self.FRAMES)
        self.assertEqual(lines[:10], ["NaN,NaN,NaN,NaN"] * 10)
        self.assertEqual(lines[10], self.truth.read_text().splitlines()[10])

    def test_a_box_with_nothing_in_it_is_refused(self):
        for box in ["500,500,20,20", "-90,5,20,20", "5,5,0.5,20"]:
            line = self.refusal("track", self.sequence, "--box", box, status=BAD_USAGE)
            self.assertIn("--box", line)
            self.assertIn("160 x 120", line)
        for box in ["nan,1,2,3", "1,2,3", "1,2,-3,4", "here", "1,2,inf,4", ""]:
            self.refusal("track", self.sequence, "--box", box, status=BAD_USAGE)

    def test_boxes_that_leave_the_picture_or_are_tiny_or_huge_are_followed(self):
        for box in ["-10,-10,40,40", "150,110,60,60", "80,60,1,1", "-50,-50,400,400"]:
            self.pacer("track", self.sequence, "--box", box)

    def test_an_unknown_tracker_is_named_with_those_there_are(self):
        line = self.refusal("track", self.sequence, "--tracker", "KFC", status=BAD_USAGE)
        self.assertIn("KFC", line)
        self.assertIn("KCF", line)
        self.assertIn("twice", self.refusal("track", self.sequence, "--tracker", "KCF", "KCF",
                                            status=BAD_USAGE))

    def test_what_is_no_sequence_is_named(self):
        empty = self.scratch / "empty"
        empty.mkdir()
        for where in [empty, self.scratch / "missing"]:
            self.assertIn(str(where), self.refusal("track", where, status=BAD_USAGE))
        without = self.scratch / "without"
        without.mkdir()
        (without / "groundtruth_rect.txt").write_text("1,1,5,5\n")
        done = run("track", without)
        self.assertIn(done.returncode, [FAILED, BAD_USAGE])
        self.assertIn(str(without), done.stderr.splitlines()[-1])

    def test_two_sequences_of_one_name_are_told_apart_by_nobody(self):
        other = write_sequence(self.scratch / "elsewhere" / "Patch", 3)
        self.assertIn("Patch", self.refusal("track", self.sequence, other, status=BAD_USAGE))

    def damaged(self, content):
        """Tracks with the 21st picture replaced; the refusal, and how many boxes were kept."""
        (self.sequence / "img" / "0021.png").write_bytes(content)
        out = self.scratch / "results.txt"
        out.unlink(missing_ok=True)
        line = self.refusal("track", self.sequence, "--out", out, status=FAILED)
        return line, len(self.boxes(out))

    def test_a_picture_that_cannot_be_read_ends_it_and_the_rest_is_kept(self):
        whole = (self.sequence / "img" / "0021.png").read_bytes()
        for content in [b"", b"no picture", whole[:100]]:
            line, kept = self.damaged(content)
            self.assertIn("0021.png", line)
            self.assertEqual(kept, 20)

    def test_a_picture_of_another_size_ends_it_and_the_rest_is_kept(self):
        line, kept = self.damaged(png([bytes(64)] * 48))
        self.assertIn("picture 21 is 64 x 48", line)
        self.assertEqual(kept, 20)

    def test_without_a_display_it_says_what_to_do(self):
        for command in [["track", "camera:0"], ["track", self.sequence, "--draw"]]:
            line = self.refusal(*command, status=FAILED, env=NO_DISPLAY)
            self.assertIn("DISPLAY", line)
            self.assertIn("--box", line)

    def test_a_display_that_is_not_there_is_no_crash(self):
        line = self.refusal("track", self.sequence, "--draw", status=FAILED,
                            env={**NO_DISPLAY, "DISPLAY": ":987"})
        self.assertIn("DISPLAY", line)

    def test_a_camera_that_is_not_there_is_named(self):
        line = self.refusal("track", "camera:987", "--box", "1,1,9,9", "--out",
                            self.scratch / "r.txt", status=FAILED, env=NO_DISPLAY)
        self.assertIn("987", line)
        self.assertIn("camera:x", self.refusal("track", "camera:x", status=BAD_USAGE))

    def test_no_result_takes_the_place_of_what_is_read(self):
        for option in ["--out", "--report", "--json"]:
            line = self.refusal("track", self.sequence, option, self.truth, status=BAD_USAGE)
            self.assertIn("name another file", line)
        self.assertIn("ends in .mp4", self.refusal("track", self.sequence, "--video", self.truth,
                                                   status=BAD_USAGE))
        file = self.scratch / "file"
        file.write_text("")
        self.assertIn("folder", self.refusal("track", self.sequence, "--tracker", "KCF", "MOSSE",
                                             "--out", file, status=BAD_USAGE))
        self.assertIn("--set", self.refusal("track", self.sequence, "--set", "seed=3",
                                            status=BAD_USAGE))

    def test_ctrl_c_keeps_what_was_tracked(self):
        write_sequence(self.scratch / "long" / "Patch", 400)
        out = self.scratch / "results.txt"
        child = subprocess.Popen(
            [COMMAND, "track", str(self.scratch / "long" / "Patch"), "--tracker", "TLD", "--out",
             str(out), "--json", str(self.scratch / "r.json")],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        child.stderr.readline()  # it is under way
        child.send_signal(signal.SIGINT)
        _, said = child.communicate(timeout=60)
        self.assertEqual(child.returncode, FAILED, said)
        self.assertIn("interrupted", said)
        kept = len(self.boxes(out))
        self.assertTrue(0 < kept < 400, kept)
        scores = json.loads((self.scratch / "r.json").read_text())["trackers"]["TLD"]["Patch"]
        self.assertEqual(scores["frames"], kept)


if __name__ == "__main__":
    main()
