// SPDX-License-Identifier: Apache-2.0
#include "tests/contract/tracker_contract.h"

namespace pacer::testing {
namespace {

INSTANTIATE_TEST_SUITE_P(OurOwn, TrackerContract, ::testing::ValuesIn(tracking::trackers()),
                         tracker_name);

}  // namespace
}  // namespace pacer::testing
