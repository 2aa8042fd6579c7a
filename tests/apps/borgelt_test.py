# SPDX-License-Identifier: Apache-2.0
"""`pacer study apriori --transactions` against Borgelt's Apriori, which the thesis mined with.

Exits with 77, which is a skip, where this Python has no pyfim (`pip install pyfim`):
PACER_PYFIM_PYTHON names one that has, when the build is configured.
"""

import math
import random
import sys

try:
    import fim
except ImportError as missing:
    print(f"SKIPPED: rules were not compared with Borgelt's, for pyfim is not here ({missing})")
    sys.exit(77)

from pacer_command import SCENARIO, CommandTest, main

TYPES, ITEMS, TRANSACTIONS = 6, 120, 10000
SUPPORT = math.ceil(0.0002 * TRANSACTIONS)  # 0.02 %, the thesis's


def transactions(seed):
    """Random items, and in a third of them half of a pattern of their type."""
    chance = random.Random(seed)
    patterns = [[chance.sample(range(ITEMS), 12) for _ in range(4)] for _ in range(TYPES)]
    for _ in range(TRANSACTIONS):
        action = chance.randrange(TYPES)
        items = set(chance.sample(range(ITEMS), chance.randint(2, 14)))
        if chance.random() < 0.3:
            items |= {item for item in chance.choice(patterns[action]) if chance.random() < 0.5}
        yield action, sorted(items)


def borgelts(database):
    """{(type, items): (count, holding)}, three to ten items counting the type."""
    heads = {f"action {action}": action for action in range(TYPES)}
    found = fim.arules([[f"action {action}", *items] for action, items in database],
                       supp=-SUPPORT, conf=98.0, zmin=3, zmax=10, report="ab", mode="o",
                       appear={None: "a", **dict.fromkeys(heads, "c")})
    return {(heads[head], tuple(sorted(body))): (count, holding)
            for head, body, count, holding in found if 100 * count >= 99 * holding}


class Borgelt(CommandTest):

    def test_finds_the_rules_that_borgelts_program_finds(self):
        for seed in (1, 2):
            database = list(transactions(seed))
            file = self.scratch / "transactions.txt"
            file.write_text("".join(f"{action} {' '.join(map(str, items))}\n"
                                    for action, items in database))
            self.pacer("study", "apriori", "--scenario", SCENARIO, "--transactions", file, "--out",
                       self.scratch)
            ours = {}
            for line in (self.scratch / "rules.txt").read_text().splitlines():
                action, *items, count, confidence = line.split()
                ours[int(action), tuple(map(int, items))] = (int(count), confidence)
            theirs = {rule: (count, f"{count / holding:.6f}")
                      for rule, (count, holding) in borgelts(database).items()}
            self.assertGreater(len(theirs), 1000)
            self.assertEqual(ours.keys(), theirs.keys())
            self.assertEqual(ours, theirs)


if __name__ == "__main__":
    main()
