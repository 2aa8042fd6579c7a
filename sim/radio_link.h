// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/frame.h"
#include "core/random.h"
#include "sim/visibility.h"

namespace pacer::sim {

/// The wireless camera's analogue link: how often it suffers, and how.
struct RadioLinkConfig {
  double corrupted = 0.01;    ///< share of frames, in the long run
  double burst_frames = 2.5;  ///< mean length of a burst, at least: longer where most frames suffer
  double whole = 0.3;         ///< share of the corrupted frames that are lost altogether
  double torn = 0.4;          ///< share of the others where the rows below the band slip
  double least_band = 0.08;   ///< share of the rows that a band covers,
  double most_band = 0.5;     ///< drawn between these

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("corrupted", corrupted);
    visit("burst_frames", burst_frames);
    visit("whole", whole);
    visit("torn", torn);
    visit("least_band", least_band);
    visit("most_band", most_band);
  }
};

/// Interference in bursts: a chain of two states, quiet and disturbed, one step a frame (Gilbert's
/// model). A disturbed frame is snow, in a band of rows or as a whole; below a band it may have
/// lost the sync and slipped sideways.
class RadioLink {
 public:
  RadioLink(const RadioLinkConfig& config, ImageSize size, const Random& random);

  /// Sends one frame through the link. Returns the rows that arrived spoilt (snow or slipped),
  /// none in a good frame; lives until the next call.
  [[nodiscard]] std::span<const RowBand> transmit(Frame& frame);

 private:
  void snow(Frame& frame, const RowBand& band);
  void slip(Frame& frame, const RowBand& band);

  RadioLinkConfig config_;
  ImageSize size_;
  Random random_;
  bool disturbed_ = false;
  std::vector<RowBand> bands_;
  std::vector<std::uint8_t> row_;
};

}  // namespace pacer::sim
