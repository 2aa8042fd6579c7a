# SPDX-License-Identifier: Apache-2.0
"""The main job in small: scripts/demo with one short episode of each kind."""

import json
import os
import pathlib
import subprocess

from pacer_command import LEARN_LITTLE, SMALL, CommandTest, main


class Demo(CommandTest):

    def test_a_few_frames_go_from_demonstration_to_report(self):
        out = self.scratch / "demo"
        script = pathlib.Path(os.environ["PACER_SOURCE"]) / "scripts" / "demo"
        done = subprocess.run([script, out, "2", "1", *SMALL, *LEARN_LITTLE], capture_output=True,
                              text=True, timeout=280)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn(f"open {out}/report.html", done.stdout)
        self.assertNotIn("installing", done.stdout)
        scores = json.loads((out / "scores.json").read_text())["policies"]
        self.assertEqual(set(scores), {"learned", "teacher", "neutral", "mean"})
        self.assertIn("</html>", (out / "report.html").read_text())


if __name__ == "__main__":
    main()
