// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace pacer::exemplar {

/// What the colour table can name, in the order of the percept.
enum class Name : std::uint8_t { kRed, kGreen, kNone };
inline constexpr std::size_t kNames = 2;  ///< kRed and kGreen

/// A colour that has a name.
struct NamedColour {
  double red = 0.0, green = 0.0, blue = 0.0;  ///< of the thing itself, in any one unit
  double tint = 0.09;    ///< share by which the light may be warmer, or cooler, than white
  double dimmest = 0.0;  ///< least level of its brightest channel, of the picture's mean level

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("red", red);
    visit("green", green);
    visit("blue", blue);
    visit("tint", tint);
    visit("dimmest", dimmest);
  }
};

/// The table's entries: the rubber of the balloons.
struct ColourTableConfig {
  NamedColour red_balloon{.red = 0.86, .green = 0.07, .blue = 0.08, .dimmest = 0.65};
  NamedColour green_balloon{.red = 0.10, .green = 0.62, .blue = 0.16, .dimmest = 0.36};
  double tolerance = 0.008;  ///< the farthest that shares may be from those of the thing
  double grain = 0.03;       ///< beyond that, over the root of how many pixels they are of
  double dark = 0.8;         ///< beyond that, over the sum of its levels: they are whole numbers
  double mixed = 0.2;        ///< the same of what may also hold pixels of something else

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("red_balloon", red_balloon);
    visit("green_balloon", green_balloon);
    visit("tolerance", tolerance);
    visit("grain", grain);
    visit("dark", dark);
    visit("mixed", mixed);
  }
};

/// Names colours by their shares of red, green and blue, which neither exposure nor shading
/// changes (5.3.2). A thing has a line of them, from cool light to warm.
class ColourTable {
 public:
  /// A thing's shares of red, green and blue from cool light to warm.
  struct Line {
    Eigen::Vector3d start, way;
  };

  explicit ColourTable(const ColourTableConfig& config = {});

  /// Of the mean colour of so many pixels, [0, 255]; black has none. It may be `more` off.
  [[nodiscard]] Name name(const Eigen::Vector3d& colour, double pixels = 1e6,
                          double more = 0.0) const noexcept;
  /// Of a colour to which something else may have been added.
  [[nodiscard]] Name nearest(const Eigen::Vector3d& colour) const noexcept;
  /// How far a colour's shares are from those of what is named so; black is 1 apart.
  [[nodiscard]] double apart(const Eigen::Vector3d& colour, Name name) const noexcept;
  /// Of what is named so.
  [[nodiscard]] const Line& line(Name name) const noexcept {
    return lines_[static_cast<std::size_t>(name)];
  }
  /// NamedColour::dimmest of what is named so.
  [[nodiscard]] double dimmest(Name name) const noexcept;

 private:
  /// What is nearest, where that is within `most` of it.
  [[nodiscard]] Name look_up(const Eigen::Vector3d& colour, double most) const noexcept;

  ColourTableConfig config_;
  std::array<Line, kNames> lines_;
};

}  // namespace pacer::exemplar
