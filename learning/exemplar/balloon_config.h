// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pacer::exemplar {

/// What tells a balloon from another thing of its colour.
struct BalloonConfig {
  double spread = 0.05;         ///< the farthest that a pixel's shares may be from its blob's
  double noise = 6.0;           ///< grey levels, beyond that, for the noise of dark pixels
  double reach = 1.4;           ///< of such pixels, in ellipses of the blob
  double stained = 0.02;        ///< farther off the colour of a part of one may be
  int least_part = 5;           ///< pixels of a part of one
  double least_area = 24;       ///< pixels
  double least_behind = 20;     ///< pixels, of what looks out behind the other balloon
  double least_fill = 0.6;      ///< of the ellipse with its second moments
  double joint_fill = 0.75;     ///< of two parts, with what may be hidden between them
  double longest = 7.0;         ///< length over width, partly hidden
  double shading = 0.12;        ///< least Moments::shading: what is flat is no balloon
  double tiny_area = 45;        ///< pixels; what is smaller, and whole, is to have
  double tiny_shading = 0.35;   ///< at least this shading
  double wide_shading = 0.55;   ///< the same of what is wider than high
  double behind_shading = 0.1;  ///< the same of a small part behind the other balloon
  double snow_shading = 0.5;    ///< the same of what snow cuts
  double small_area = 100;      ///< pixels; what is smaller is to have
  double small_fill = 0.82;     ///< at least this fill
  double near_area = 1500;      ///< pixels; larger, and cut by the edge, it may look flat
  double rim = 1.35;            ///< ellipses of the other balloon, for what looks out behind it
  double small_step = 0.75;     ///< least share of a small one's outline with another colour beyond
  double clear = 0.9;           ///< of that share and half the shading
  double side_clear = 0.7;      ///< the same of what the picture's side cuts
  double side_shading = 0.0;    ///< least shading of what the picture's side cuts plainly
  double horizon = 0.383;       ///< share of the picture's height
  double highest = 1.7;         ///< of its lengths that its middle may be above that
  double lowest = 0.443;        ///< share of the picture's height that its middle is not below
  double gap = 0.85;            ///< share of a balloon that may be hidden between two parts of it
  double interference = 45.0;   ///< mean difference of neighbours in a row of snow, grey levels

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("spread", spread);
    visit("noise", noise);
    visit("reach", reach);
    visit("stained", stained);
    visit("least_part_px", least_part);
    visit("least_area_px", least_area);
    visit("least_behind_px", least_behind);
    visit("least_fill", least_fill);
    visit("joint_fill", joint_fill);
    visit("longest", longest);
    visit("shading", shading);
    visit("tiny_area_px", tiny_area);
    visit("tiny_shading", tiny_shading);
    visit("wide_shading", wide_shading);
    visit("behind_shading", behind_shading);
    visit("snow_shading", snow_shading);
    visit("small_area_px", small_area);
    visit("small_fill", small_fill);
    visit("near_area_px", near_area);
    visit("rim", rim);
    visit("small_step", small_step);
    visit("clear", clear);
    visit("side_clear", side_clear);
    visit("side_shading", side_shading);
    visit("horizon", horizon);
    visit("highest", highest);
    visit("lowest", lowest);
    visit("gap", gap);
    visit("interference", interference);
  }
};

}  // namespace pacer::exemplar
