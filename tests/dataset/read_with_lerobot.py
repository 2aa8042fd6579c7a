# SPDX-License-Identifier: Apache-2.0
"""Loads a dataset with lerobot itself, as somebody who trains on it would.

read_with_lerobot.py RECORDER

RECORDER FOLDER N records N episodes into FOLDER. Exits with 77, which is a skip, where this Python
has no lerobot: PACER_LEROBOT_PYTHON names one that has, when the build is configured.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

os.environ["HF_HUB_OFFLINE"] = "1"
try:
    import torch
    from lerobot.datasets.lerobot_dataset import LeRobotDataset
except ImportError as missing:
    print(f"SKIPPED: lerobot is not installed here ({missing})")
    sys.exit(77)

CAMERA = "observation.images.front"


def check(condition, what):
    if not condition:
        sys.exit(f"broken: {what}")


with tempfile.TemporaryDirectory() as scratch:
    root = pathlib.Path(scratch) / "drives"
    subprocess.run([sys.argv[1], root, "3"], check=True)
    dataset = LeRobotDataset("local/drives", root=root, video_backend="pyav")
    check(dataset.num_episodes == 3, "three episodes")
    step = 1.0 / dataset.fps
    for index in (0, 1, len(dataset) - 1):
        check(int(dataset[index]["index"]) == index, "steps are numbered through")
        check(0.0 <= float(dataset[index][CAMERA].min()), "pictures are shares of full brightness")
    windows = {"action": [0.0, step, 2 * step], CAMERA: [-step, 0.0]}
    batches = torch.utils.data.DataLoader(
        LeRobotDataset("local/drives", root=root, video_backend="pyav", delta_timestamps=windows),
        batch_size=4)
    batch = next(iter(batches))
    check(tuple(batch["action"].shape) == (4, 3, 2), "actions come in windows")
    check(batch[CAMERA].shape[:3] == (4, 2, 3), "and so do pictures")
    for name in ("action", "observation.state", CAMERA):
        check(name in dataset.meta.stats, f"statistics of {name} are there to normalise with")
print("lerobot reads it")
