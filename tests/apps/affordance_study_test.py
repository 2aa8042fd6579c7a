# SPDX-License-Identifier: Apache-2.0
"""Studies of the demonstrations (Figures 6.5, 6.6, 6.8), on few and small pictures."""

from pacer_command import LEARN_LITTLE, SCENARIO, CommandTest, main, settings

# Five minutes as ever, at a fifth of the pictures.
FEW = settings(simulated__camera__frame_rate_hz=5, simulated__camera__width_px=160,
               simulated__camera__height_px=120)


class AffordanceStudy(CommandTest):

    def study(self, name):
        out = self.scratch / name
        result = self.json_of("study", name, "--scenario", SCENARIO, "--cache",
                              self.scratch / "cache", "--out", out, *FEW, *LEARN_LITTLE)
        named = {claim["name"] for claim in result["claims"]}
        self.assertTrue(named and named <= set(result["figures"]), named)
        self.assertIn("vega", (out / f"{name}.html").read_text())
        return result["figures"]

    def test_demonstrations_and_their_actions_are_described_from_one_recording(self):
        figures = self.study("demonstrations")
        self.assertEqual((figures["episodes"], figures["frames"]), (5, 1500))
        self.assertGreater(figures["steering_correlation"], 0.8)
        self.assertLess(figures["not_in_view"], 0.2)

        recorded = sorted(path.name for path in (self.scratch / "cache").iterdir())
        figures = self.study("action-clusters")
        kept = sorted(path.name for path in (self.scratch / "cache").iterdir())
        self.assertEqual([name for name in kept if name.startswith("drives")], recorded)
        types = figures["action_types"]
        self.assertEqual((len(types), figures["frames"]), (6, 1500))
        self.assertAlmostEqual(sum(kind["share"] for kind in types.values()), 1.0)
        self.assertLess(figures["whitening_error"], 1e-6)
        for name, kind in types.items():
            if "left" in name:
                self.assertGreater(kind["steering"], 0.0)
            if "right" in name:
                self.assertLess(kind["steering"], 0.0)


if __name__ == "__main__":
    main()
