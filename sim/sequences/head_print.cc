// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "sim/sequences/head.h"

// What is painted on a head.
namespace pacer::sim {
namespace {

using Eigen::Vector2d;
using texture::Colour;
using texture::shade;

/// Blends `ink` into a picture, in metres of the face: y to its left, z up.
class FaceBrush {
 public:
  FaceBrush(const Head& head, cv::Mat& picture) : head_(head), picture_(picture) {}

  /// A closed outline, filled; soft by `soft` metres.
  void patch(const std::vector<Vector2d>& outline, const Colour& ink, double amount,
             double soft = 0.0) {
    const Stroke stroke = place(outline, 1.0, soft);
    cv::fillPoly(stroke.mask, std::vector<std::vector<cv::Point>>{stroke.way}, 255, cv::LINE_AA,
                 kShift);
    blend(stroke, ink, amount);
  }
  void ellipse(const Vector2d& middle, double half_y, double half_z, const Colour& ink,
               double amount, double soft = 0.0) {
    std::vector<Vector2d> outline;
    for (int i = 0; i < 36; ++i) {
      const double angle = 0.1745329 * i;
      outline.emplace_back(middle.x() + half_y * std::cos(angle),
                           middle.y() + half_z * std::sin(angle));
    }
    patch(outline, ink, amount, soft);
  }
  void line(const std::vector<Vector2d>& way, double width, const Colour& ink, double amount,
            double soft = 0.0) {
    const int wide = std::max(1, static_cast<int>(std::lround(width * texels())));
    const Stroke stroke = place(way, wide, soft);
    cv::polylines(stroke.mask, std::vector<std::vector<cv::Point>>{stroke.way}, false, 255, wide,
                  cv::LINE_AA, kShift);
    blend(stroke, ink, amount);
  }

 private:
  static constexpr int kShift = 4;  // fractional bits of a point on the picture

  [[nodiscard]] double texels() const {  // a metre, at the middle of the face
    return (head_.on_picture(0.0, -0.01) - head_.on_picture(0.0, 0.01)).y() * picture_.rows / 0.02;
  }
  /// A part of the picture that a stroke reaches, and the stroke in it.
  struct Stroke {
    cv::Rect part;
    cv::Mat mask;
    std::vector<cv::Point> way;  // 1/2^kShift texels
    double deviation;            // of its soft edge, texels
  };

  [[nodiscard]] Stroke place(const std::vector<Vector2d>& way, double width, double soft) const {
    Stroke stroke;
    stroke.deviation = soft * texels();
    std::vector<cv::Point2f> points;
    for (const Vector2d& point : way) {
      const Vector2d at = head_.on_picture(point.x(), point.y());
      points.emplace_back(static_cast<float>(at.x() * picture_.cols),
                          static_cast<float>(at.y() * picture_.rows));
    }
    const int margin = static_cast<int>(std::ceil(3.0 * stroke.deviation + width)) + 1;
    const cv::Rect tight = cv::boundingRect(points);
    stroke.part = cv::Rect(tight.x - margin, tight.y - margin, tight.width + 2 * margin,
                           tight.height + 2 * margin) &
                  cv::Rect({0, 0}, picture_.size());
    stroke.mask = cv::Mat::zeros(stroke.part.size(), CV_8U);
    for (const cv::Point2f& point : points) {
      const auto fixed = [](float texel, int origin) {
        return static_cast<int>(std::lround((texel - static_cast<float>(origin)) * (1 << kShift)));
      };
      stroke.way.emplace_back(fixed(point.x, stroke.part.x), fixed(point.y, stroke.part.y));
    }
    return stroke;
  }
  void blend(const Stroke& stroke, const Colour& ink, double amount) {
    cv::Mat mask = stroke.mask;
    if (stroke.deviation > 0.3) cv::GaussianBlur(mask, mask, {0, 0}, stroke.deviation);
    for (int y = 0; y < mask.rows; ++y) {
      const auto* const shares = mask.ptr<uchar>(y);
      auto* const row = picture_.ptr<cv::Vec3b>(stroke.part.y + y) + stroke.part.x;
      for (int x = 0; x < mask.cols; ++x) {
        if (shares[x] == 0) continue;
        const double share = amount * shares[x] / 255.0;
        for (int c = 0; c < 3; ++c) {
          row[x][c] = cv::saturate_cast<uchar>((1.0 - share) * row[x][c] + share * ink[c]);
        }
      }
    }
  }

  const Head& head_;
  cv::Mat& picture_;
};

void paint_skin(FaceBrush& brush, const HeadLook& look, Random random) {
  const Colour red(190, 90, 80);
  const Colour dark = shade(look.skin, -0.45);
  for (const double side : {-1.0, 1.0}) {
    brush.ellipse({side * 0.046, -0.025}, 0.016, 0.014, red, 0.28, 0.008);  // cheeks
    brush.ellipse({side * 0.032, 0.016}, 0.017, 0.012, dark, 0.40, 0.005);  // sockets
    brush.line({{side * 0.016, -0.028}, {side * 0.024, -0.040}, {side * 0.031, -0.054}}, 0.0022,
               dark, 0.45, 0.0015);  // beside the mouth
    brush.line({{side * 0.007, 0.018}, {side * 0.009, -0.010}, {side * 0.0135, -0.024}}, 0.003,
               dark, 0.30, 0.0025);  // the nose's sides
  }
  brush.ellipse({0.0, -0.037}, 0.013, 0.003, dark, 0.6, 0.002);                 // under the nose
  brush.ellipse({0.0, -0.083}, 0.016, 0.003, dark, 0.45, 0.003);                // under the lip
  brush.ellipse({0.0, 0.0}, 0.003, 0.022, shade(look.skin, 0.5), 0.35, 0.002);  // the nose's back
  brush.ellipse({0.0, 0.045}, 0.034, 0.009, shade(look.skin, 0.4), 0.25, 0.006);
  for (int i = 0; i < 3; ++i) {  // lines of the forehead
    const double z = 0.042 + 0.007 * i;
    brush.line({{-0.034, z - 0.002}, {-0.012, z}, {0.014, z + 0.001}, {0.036, z - 0.002}}, 0.0011,
               dark, 0.28, 0.0006);
  }
  for (int i = 0; i < 40; ++i) {  // moles and freckles
    brush.ellipse({random.normal(0.0, 0.034), random.normal(-0.02, 0.03)},
                  random.uniform(0.0005, 0.0011), random.uniform(0.0005, 0.0011), dark, 0.5);
  }
  if (look.stubble) {
    brush.patch({{-0.054, -0.03},
                 {-0.036, -0.044},
                 {-0.02, -0.046},
                 {0.02, -0.046},
                 {0.036, -0.044},
                 {0.054, -0.03},
                 {0.045, -0.085},
                 {0.02, -0.111},
                 {-0.02, -0.111},
                 {-0.045, -0.085}},
                shade(look.hair, 0.12), 0.42, 0.004);
  }
}

void paint_eye(FaceBrush& brush, const HeadLook& look, double side, bool closed) {
  const double y = side * 0.0315;
  const double z = 0.012;
  const Colour lash(28, 20, 18);
  const std::vector<Vector2d> upper = {{y - 0.0155, z - 0.001},
                                       {y - 0.009, z + 0.0062},
                                       {y, z + 0.0082},
                                       {y + 0.009, z + 0.0062},
                                       {y + 0.0155, z - 0.001}};
  if (closed) {
    brush.ellipse({y, z + 0.001}, 0.0155, 0.0075, shade(look.skin, -0.12), 0.9, 0.001);
    brush.line({{y - 0.0155, z - 0.001},
                {y - 0.007, z - 0.0045},
                {y + 0.007, z - 0.0045},
                {y + 0.0155, z - 0.001}},
               0.0022, lash, 0.9, 0.0004);
  } else {
    std::vector<Vector2d> opening = upper;
    opening.insert(opening.end(), {{y + 0.007, z - 0.0052}, {y - 0.007, z - 0.0052}});
    brush.patch(opening, {228, 224, 220}, 1.0);
    brush.ellipse({y, z + 0.001}, 0.0062, 0.0066, shade(look.iris, -0.3), 1.0);
    brush.ellipse({y, z + 0.001}, 0.0046, 0.0050, look.iris, 1.0);
    brush.ellipse({y, z + 0.001}, 0.0026, 0.0028, {14, 12, 14}, 1.0);
    brush.ellipse({y + 0.0022, z + 0.0036}, 0.0013, 0.0013, {255, 255, 255}, 1.0);
    brush.line(upper, 0.0024, lash, 0.9, 0.0004);
    brush.line({{y - 0.012, z - 0.0045}, {y, z - 0.0062}, {y + 0.012, z - 0.0045}}, 0.001, lash,
               0.45, 0.0004);
  }
  brush.line({{y - 0.014, z + 0.0065}, {y, z + 0.0125}, {y + 0.014, z + 0.0065}}, 0.0012,
             shade(look.skin, -0.5), 0.5, 0.0006);
  const auto brow = [&](double along, double up) {
    return Vector2d(side * (0.012 + 0.036 * along),
                    0.0275 + up + 0.007 * std::sin(2.2 * along) - 0.004 * along);
  };
  for (int i = 0; i < 12; ++i) {
    const double along = i / 12.0;
    brush.line({brow(along, -0.0022 + 0.0012 * along), brow(along + 0.1, 0.0022)}, 0.0024,
               shade(look.hair, -0.15), 0.8, 0.0004);
  }
}

void paint_mouth(FaceBrush& brush, Expression expression) {
  const Colour lip(168, 84, 80);
  const Colour dark(70, 26, 26);
  const double z = -0.063;
  const bool smiles = expression == Expression::kSmile;
  const bool talks = expression == Expression::kTalk;
  const double wide = smiles ? 0.031 : talks ? 0.019 : 0.024;
  const double up = smiles ? 0.007 : 0.0;  // of the corners
  const double gap = talks ? 0.008 : smiles ? 0.005 : 0.0;
  const std::vector<Vector2d> whole = {
      {-wide, z + up},         {-0.5 * wide, z + 0.0058 + 0.4 * up},
      {-0.004, z + 0.0075},    {0.0, z + 0.006},
      {0.004, z + 0.0075},     {0.5 * wide, z + 0.0058 + 0.4 * up},
      {wide, z + up},          {0.55 * wide, z - 0.0085 - gap},
      {0.0, z - 0.0105 - gap}, {-0.55 * wide, z - 0.0085 - gap}};
  brush.patch(whole, lip, 0.85, 0.0006);
  brush.ellipse({0.0, z - 0.006 - gap}, 0.45 * wide, 0.0018, {214, 142, 134}, 0.6, 0.001);
  const std::vector<Vector2d> inner = {{-wide, z + up},
                                       {-0.4 * wide, z + 0.0016 + 0.3 * up},
                                       {0.4 * wide, z + 0.0016 + 0.3 * up},
                                       {wide, z + up},
                                       {0.45 * wide, z - 0.0004 - 1.5 * gap},
                                       {-0.45 * wide, z - 0.0004 - 1.5 * gap}};
  if (gap > 0.0) {
    brush.patch(inner, dark, 1.0, 0.0004);
    brush.patch({{-0.65 * wide, z + 0.45 * up},
                 {0.65 * wide, z + 0.45 * up},
                 {0.5 * wide, z - 0.7 * gap},
                 {-0.5 * wide, z - 0.7 * gap}},
                {236, 230, 220}, talks ? 0.6 : 0.95, 0.0005);  // teeth
  } else {
    brush.line({{-wide, z + 0.0005},
                {-0.4 * wide, z + 0.001},
                {0.0, z - 0.0004},
                {0.4 * wide, z + 0.001},
                {wide, z + 0.0005}},
               0.0018, dark, 0.9, 0.0004);
  }
}

/// Strands from the crown outwards wherever hair grows.
void paint_hair(cv::Mat& picture, const Head& head, Random random) {
  cv::Mat hair = texture::plain(picture.size(), head.look().hair, 9.0, random.fork("ground"));
  for (int i = 0; i < 1500; ++i) {
    const int x = static_cast<int>(random.below(static_cast<std::uint64_t>(picture.cols)));
    const int y = static_cast<int>(random.uniform(0.0, 0.8 * picture.rows));
    const int length = static_cast<int>(random.uniform(0.03, 0.12) * picture.rows);
    const int lean = static_cast<int>(random.uniform(-0.25, 0.25) * length);
    cv::line(hair, {x, y}, {x + lean, y + length},
             shade(head.look().hair,
                   random.chance(0.45) ? random.uniform(0.05, 0.35) : random.uniform(-0.5, -0.1)),
             1, cv::LINE_AA);
  }
  for (int y = 0; y < picture.rows; ++y) {
    auto* const row = picture.ptr<cv::Vec3b>(y);
    for (int x = 0; x < picture.cols; ++x) {
      const double share = head.hair_at((x + 0.5) / picture.cols, (y + 0.5) / picture.rows, 0.005);
      if (share <= 0.0) continue;
      const auto& strand = hair.at<cv::Vec3b>(y, x);
      for (int c = 0; c < 3; ++c) {
        row[x][c] = cv::saturate_cast<uchar>((1.0 - share) * row[x][c] + share * strand[c]);
      }
    }
  }
}

}  // namespace

cv::Mat head_print(const Head& head, Expression expression, cv::Size size, Random random) {
  const HeadLook& look = head.look();
  cv::Mat picture = texture::plain(size, look.skin, 5.0, random.fork("skin"));
  Random blotches = random.fork("blotches");
  texture::modulate(picture, texture::noise(size, 40, 30, blotches), 6.0);
  FaceBrush brush(head, picture);
  paint_skin(brush, look, random.fork("marks"));
  for (const double side : {-1.0, 1.0}) {
    paint_eye(brush, look, side, expression == Expression::kBlink);
  }
  for (const double side : {-1.0, 1.0}) {
    brush.ellipse({side * 0.0075, -0.0335}, 0.0038, 0.0022, {60, 28, 24}, 0.85, 0.0006);
  }
  paint_mouth(brush, expression);
  paint_hair(picture, head, random.fork("hair"));
  return picture;
}

}  // namespace pacer::sim
