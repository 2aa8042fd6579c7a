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
  double tolerance =
      0.025;             ///< the farthest that shares of red, green and blue may be from its own
  double hue = 0.025;    ///< the farthest across the way to white, along which highlights lie
  double dimmest = 0.0;  ///< least level of its brightest channel, of the picture's mean level

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("red", red);
    visit("green", green);
    visit("blue", blue);
    visit("tolerance", tolerance);
    visit("hue", hue);
    visit("dimmest", dimmest);
  }
};

/// The table's entries: the rubber of the balloons.
struct ColourTableConfig {
  NamedColour red_balloon{
      .red = 0.86, .green = 0.07, .blue = 0.08, .tolerance = 0.035, .hue = 0.012, .dimmest = 0.7};
  NamedColour green_balloon{
      .red = 0.10, .green = 0.62, .blue = 0.16, .tolerance = 0.03, .hue = 0.023, .dimmest = 0.42};
  double mixed = 0.2;  ///< the same tolerance for what may also hold pixels of something else

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("red_balloon", red_balloon);
    visit("green_balloon", green_balloon);
    visit("mixed", mixed);
  }
};

/// Names colours by their shares of red, green and blue, which neither exposure nor shading
/// changes: a lookup table over quantised shares (5.3.2).
class ColourTable {
 public:
  explicit ColourTable(const ColourTableConfig& config = {});

  /// Of a colour in any unit; black has none.
  [[nodiscard]] Name name(const Eigen::Vector3d& colour) const noexcept {
    return look_up(names_, colour);
  }
  /// Of a colour to which something else may have been added.
  [[nodiscard]] Name nearest(const Eigen::Vector3d& colour) const noexcept {
    return look_up(nearest_, colour);
  }
  /// Shares of red, green and blue of what is named so.
  [[nodiscard]] const Eigen::Vector3d& shares(Name name) const noexcept {
    return shares_[static_cast<std::size_t>(name)];
  }
  /// NamedColour::dimmest of what is named so.
  [[nodiscard]] double dimmest(Name name) const noexcept {
    return dimmest_[static_cast<std::size_t>(name)];
  }

 private:
  static constexpr int kSteps = 256;  // of a share from 0 to 1
  using Table = std::array<Name, static_cast<std::size_t>(kSteps) * kSteps>;  // by red, green share

  [[nodiscard]] static Name look_up(const Table& table, const Eigen::Vector3d& colour) noexcept;

  std::array<Eigen::Vector3d, kNames> shares_;
  std::array<double, kNames> dimmest_;
  Table names_{}, nearest_{};
};

}  // namespace pacer::exemplar
