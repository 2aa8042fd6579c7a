// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pacer::report {

/// Which colour stands for which policy (or class), the same in every chart, table and video of a
/// page. Paul Tol's "bright" and "vibrant" colours: told apart by colour-blind readers, on white
/// and on black. The policies every report knows keep theirs on every page: `teacher` is green,
/// `neutral` grey, `mean` purple. The others take blue, red, cyan, yellow, orange, teal, and, less
/// easily told from them, violet, brown, pink in the order of `names`, then again.
class Palette {
 public:
  Palette() = default;
  explicit Palette(std::span<const std::string> names);
  /// For the values of a quantity in ascending order: from blue to red.
  [[nodiscard]] static Palette graded(std::span<const std::string> names);

  /// `#rrggbb`; for a name that the palette was not made with, grey.
  [[nodiscard]] std::string_view colour(std::string_view name) const noexcept;

 private:
  struct Entry {
    std::string name;
    std::string colour;
  };
  std::vector<Entry> entries_;
};

}  // namespace pacer::report
