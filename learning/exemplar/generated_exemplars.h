// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/random.h"
#include "learning/exemplar/exemplars.h"

namespace pacer::exemplar {

/// Exemplars of driving to the red balloon, without pictures: two balloons lie anywhere before a
/// pinhole camera of 320 x 240, each in view or not, whatever the other does. A percept is the red
/// and then the green one's area, centroid x and y, three second moments and R, G, B, with noise;
/// nine zeros for one that is out of view. The action (turn, drive) depends on the red one alone.
struct GeneratedExemplars {
  int exemplars = 304;
  double bearing_deg = 40.0;  ///< a balloon lies at most so far to either side
  double view_deg = 62.0;     ///< the camera's horizontal field of view
  double nearest_m = 0.5;
  double farthest_m = 5.0;
  double radius_m = 0.15;
  double highest_m = 0.5;      ///< its centre lies at most so far above the camera or below
  double pixel_noise = 0.5;    ///< sd of a centroid's x and y
  double shape_noise = 0.02;   ///< relative sd of the area and of each second moment
  double light = 0.1;          ///< relative sd of the light on a balloon: R, G and B alike
  double colour_noise = 1.5;   ///< sd of each of R, G and B, of 255: means of many pixels
  double turn_scatter = 0.07;  ///< a person's, in fractions of full turn (-1 to 1)
  double drive_scatter = 0.05;

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("exemplars", exemplars);
    visit("bearing_deg", bearing_deg);
    visit("view_deg", view_deg);
    visit("nearest_m", nearest_m);
    visit("farthest_m", farthest_m);
    visit("radius_m", radius_m);
    visit("highest_m", highest_m);
    visit("pixel_noise", pixel_noise);
    visit("shape_noise", shape_noise);
    visit("light", light);
    visit("colour_noise", colour_noise);
    visit("turn_scatter", turn_scatter);
    visit("drive_scatter", drive_scatter);
  }
};

/// The same `random`, the same exemplars. Throws std::invalid_argument.
[[nodiscard]] Exemplars generate_exemplars(const GeneratedExemplars& config, Random random);

}  // namespace pacer::exemplar
