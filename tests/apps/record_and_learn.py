# SPDX-License-Identifier: Apache-2.0
"""Records and learns once what the other tests of whole commands share."""

import shutil

from pacer_command import (DRIVES, MODEL, RECORDED, CommandTest, collect, main, train)


class RecordAndLearn(CommandTest):

    def test_a_dataset_is_recorded_and_a_model_learnt_from_it(self):
        shutil.rmtree(RECORDED, ignore_errors=True)
        RECORDED.mkdir(parents=True)
        said = self.pacer(*collect(DRIVES)).stdout
        self.assertIn("3 episodes (3 new), 450 frames", said)
        self.assertIn("next: pacer train", said)
        said = self.pacer(*train(MODEL)).stdout
        recorded = DRIVES / "meta" / "scenario.yaml"
        self.assertIn(f"next: pacer evaluate {recorded} --policy {MODEL} teacher", said)
        self.pacer("evaluate", recorded, "--policy", MODEL, "--episodes", 1, "--clips", 0)
        self.assertTrue(MODEL.is_file())


if __name__ == "__main__":
    main()
