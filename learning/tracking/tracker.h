// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/annotation.h"
#include "core/box.h"
#include "core/frame.h"
#include "learning/tracking/picture.h"

namespace pacer::tracking {

/// Where the target is. Losing it is an outcome, not an error.
struct Track {
  Box box;                  ///< where it is, or was last seen
  double confidence = 0.0;  ///< [0, 1]; 0 means lost
};

/// Follows one target from picture to picture. One tracker a target; they share nothing.
///
/// The same pictures, box and seed give the same tracks.
class Tracker {
 public:
  virtual ~Tracker() = default;

  /// Begins anew on `target`, whatever came before. The box may leave the picture in part, be a
  /// pixel wide, or be larger than the picture. Throws std::invalid_argument when it is not proper,
  /// a side is shorter than a pixel or longer than 1e8, no pixel of the picture lies in it, or
  /// (other people's trackers alone) the library cannot take what lies in it.
  void start(const Picture& picture, const Box& target);

  /// Where the target is in the next picture. Throws std::logic_error before start(), and
  /// std::invalid_argument for a picture of another size than the first.
  [[nodiscard]] Track update(const Picture& picture);

  /// Adds what the last picture was seen as: predictors, aspects. For drawing; nothing by default.
  virtual void annotate(Annotations& annotations) const;

 private:
  virtual void begin(const Picture& picture, const Box& target) = 0;
  [[nodiscard]] virtual Track follow(const Picture& picture) = 0;

  ImageSize size_;
};

/// A tracker that can be chosen by name.
struct TrackerKind {
  std::string name;   ///< as in the thesis's tables, e.g. "LP-SMAT"
  std::string about;  ///< one line
  std::unique_ptr<Tracker> (*make)(std::uint64_t seed);
};

/// Our own: the thesis's and the one beyond them, which is the default and comes first.
[[nodiscard]] const std::vector<TrackerKind>& trackers();

}  // namespace pacer::tracking
