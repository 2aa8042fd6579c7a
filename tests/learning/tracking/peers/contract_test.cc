// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/peers.h"
#include "tests/contract/tracker_contract.h"

namespace pacer::testing {

INSTANTIATE_TEST_SUITE_P(Peers, TrackerContract, ::testing::ValuesIn(tracking::peers()),
                         tracker_name);

}  // namespace pacer::testing
