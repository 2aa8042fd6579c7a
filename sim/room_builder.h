// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/random.h"
#include "sim/room.h"
#include "sim/shape.h"
#include "sim/texture.h"

namespace pacer::sim {

/// The colours that a room keeps to.
struct Palette {
  texture::Colour wall, accent, wood, second_wood, fabric, second_fabric, metal;
};

/// A thing in a room, in its own frame: x to its right as it faces you, y towards you, z up from
/// the floor, the origin under its middle. Metres.
struct Piece {
  struct Solid {
    Eigen::Vector3d centre, half;
  };
  std::string name;
  Shape shape;                ///< what is seen
  std::vector<Solid> solids;  ///< what is touched: simple boxes that stand for it
  Eigen::Vector2d half = Eigen::Vector2d::Zero();  ///< of the floor it takes
  double height = 0.0;                             ///< above which a picture can hang

  /// A box that is seen and touched.
  void part(const Eigen::Vector3d& centre, const Eigen::Vector3d& half_sides,
            const BoxSkins& skins);
};

/// Where a piece stands: its origin in the world and the turn of its frame.
struct Place {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double yaw = 0.0;
};

/// What the kinds of room are put together with: walls, furniture along them, light, and one atlas
/// for every picture in the room.
class RoomBuilder {
 public:
  using Maker = std::function<Piece(RoomBuilder&, Random)>;

  RoomBuilder(mjSpec& spec, const RoomConfig& config, std::string kind, const Random& random);

  Palette palette;           ///< for the kind to set first
  double wall_height = 2.5;  ///< metres

  [[nodiscard]] Random random(std::string_view name) const { return random_.fork(name); }
  [[nodiscard]] double clutter() const noexcept { return clutter_; }
  [[nodiscard]] const Eigen::Vector2d& half() const noexcept { return plan_.half_extent; }

  /// The skin called `key`, made by `make(Random)` the first time that it is asked for.
  Skin skin(const std::string& key, const std::function<cv::Mat(Random)>& make,
            double metres = 0.0);
  [[nodiscard]] Skin wood();
  [[nodiscard]] Skin second_wood();
  [[nodiscard]] Skin fabric();
  [[nodiscard]] Skin second_fabric();
  [[nodiscard]] Skin metal();
  [[nodiscard]] Skin dark();
  /// One of `count` variants of a skin; which is drawn.
  Skin one_of(const std::string& key, int count, Random& random,
              const std::function<cv::Mat(Random)>& make);

  /// Floor, walls, ceiling and skirting. Pictures are seamless and repeat every so many metres.
  void shell(const cv::Mat& floor, double floor_metres, const cv::Mat& wall, double wall_metres);
  /// The room's light, before the config's factor: a part from everywhere, a part from above, and
  /// a part through the windows.
  void light(double ambient, double ceiling, double sun);

  void put(Piece piece, const Place& place);
  /// Fills wall `wall` (0: +y, 1: -x, 2: -y, 3: +x) from left to right as one faces it, in the
  /// order of `makers`, skipping what does not fit; `hangings` go on the bare wall above.
  void line_up(int wall, const std::vector<Maker>& makers, const std::vector<Maker>& hangings);
  /// Puts `piece` freely at a spot near `around` that keeps `gap` metres from everything else;
  /// drops it when there is none.
  void island(Piece piece, const Eigen::Vector2d& around, double reach, double gap);
  /// Small things on the floor, close to what stands along the walls.
  void scatter(const std::vector<Maker>& makers, int places);

  /// Adds everything to the model.
  RoomPlan finish();

 private:
  void add_structure();
  [[nodiscard]] Place against(int wall, double along, double depth) const;
  [[nodiscard]] bool is_free(const Footprint& wanted, double gap) const;

  mjSpec& spec_;
  Random random_;
  double clutter_;
  double brightness_;
  double warmth_;
  RoomPlan plan_;
  Atlas atlas_{1536};
  std::map<std::string, Skin> skins_;
  std::vector<std::pair<Piece, Place>> pieces_;
  Shape shadows_;
};

/// The kinds of room; each reads as a list of what is in it.
void furnish_living(RoomBuilder& room);
void furnish_office(RoomBuilder& room);
void furnish_workshop(RoomBuilder& room);

}  // namespace pacer::sim
