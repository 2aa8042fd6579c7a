// SPDX-License-Identifier: Apache-2.0
#include "sim/texture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/check.h"
#include "sim/texture_detail.h"

namespace pacer::sim::texture {

using detail::below;
using detail::filled;
using detail::motif;
using detail::speckle;
using detail::wrapped;

Colour shade(const Colour& colour, double amount) {
  Colour out;
  for (int i = 0; i < 3; ++i) {
    out[i] = amount > 0.0 ? colour[i] + amount * (255.0 - colour[i]) : colour[i] * (1.0 + amount);
  }
  return out;
}

Colour vary(const Colour& colour, double deviation, Random& random) {
  const double tone = random.normal(0.0, deviation);
  Colour out;
  for (int i = 0; i < 3; ++i) {
    out[i] = std::clamp(colour[i] + tone + random.normal(0.0, 0.35 * deviation), 0.0, 255.0);
  }
  return out;
}

Colour hsv(double hue, double saturation, double value) {
  const auto channel = [&](double n) {
    const double k = std::fmod(n + hue / 60.0, 6.0);
    return 255.0 * (value - value * saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

cv::Mat noise(cv::Size size, int cells_x, int cells_y, Random& random) {
  cv::Mat grid(cells_y, cells_x, CV_32F);
  for (int y = 0; y < cells_y; ++y) {
    for (int x = 0; x < cells_x; ++x) {
      grid.at<float>(y, x) = static_cast<float>(random.uniform(-1.0, 1.0));
    }
  }
  // The grid is wrapped around before it is enlarged: opposite edges then meet.
  constexpr int kBorder = 3;
  cv::Mat ringed;
  cv::copyMakeBorder(grid, ringed, kBorder, kBorder, kBorder, kBorder, cv::BORDER_WRAP);
  const int scale_x = (size.width + cells_x - 1) / cells_x;
  const int scale_y = (size.height + cells_y - 1) / cells_y;
  cv::Mat large;
  cv::resize(ringed, large, cv::Size(ringed.cols * scale_x, ringed.rows * scale_y), 0.0, 0.0,
             cv::INTER_LINEAR);
  const cv::Mat middle =
      large(cv::Rect(kBorder * scale_x, kBorder * scale_y, cells_x * scale_x, cells_y * scale_y));
  if (middle.size() == size) return middle.clone();
  cv::Mat out;
  cv::resize(middle, out, size, 0.0, 0.0, cv::INTER_LINEAR);
  return out;
}

void modulate(cv::Mat& picture, const cv::Mat& field, double amount) {
  check(picture.size() == field.size(), "a field covers the picture it modulates");
  for (int y = 0; y < picture.rows; ++y) {
    auto* const row = picture.ptr<cv::Vec3b>(y);
    const auto* const steps = field.ptr<float>(y);
    for (int x = 0; x < picture.cols; ++x) {
      const int step = static_cast<int>(static_cast<double>(steps[x]) * amount);
      for (int c = 0; c < 3; ++c) row[x][c] = cv::saturate_cast<uchar>(row[x][c] + step);
    }
  }
}

cv::Mat plain(cv::Size size, const Colour& colour, double grain, Random random) {
  cv::Mat picture = filled(size, colour);
  modulate(picture, noise(size, 5, 5, random), 1.2 * grain);
  speckle(picture, 0.6 * grain, random);
  return picture;
}

cv::Mat wood(cv::Size size, const Colour& colour, Random random) {
  cv::Mat picture = filled(size, colour);
  modulate(picture, noise(size, 2, std::max(4, size.height / 10), random), 26.0);
  modulate(picture, noise(size, 6, std::max(4, size.height / 3), random), 20.0);
  modulate(picture, noise(size, 5, 3, random), 12.0);
  const int knots = 1 + size.width * size.height / 24000;
  for (int i = 0; i < knots; ++i) {
    const cv::Point at(below(random, size.width), below(random, size.height));
    const int radius = 2 + below(random, 4);
    for (int ring = 3; ring >= 0; --ring) {
      cv::ellipse(picture, at, {radius * (1 + ring), radius + ring * 2}, 0.0, 0, 360,
                  shade(colour, -0.5 + 0.1 * ring), ring == 0 ? cv::FILLED : 1, cv::LINE_AA);
    }
  }
  return picture;
}

cv::Mat fabric(cv::Size size, const Colour& colour, const Colour& accent, Random random) {
  cv::Mat picture = filled(size, colour);
  const int kind = below(random, 3);
  const int pitch = size.width / (5 + below(random, 4));
  for (int i = 0; i * pitch < size.width; ++i) {
    if (kind == 0) break;
    cv::rectangle(picture, cv::Rect(i * pitch, 0, pitch / 3, size.height), shade(accent, 0.1),
                  cv::FILLED);
    if (kind == 2) {
      cv::rectangle(picture, cv::Rect(0, i * pitch, size.width, pitch / 4), shade(accent, -0.25),
                    cv::FILLED);
    }
  }
  if (kind == 0) {
    for (int i = 0; i < 60; ++i) {
      const cv::Point at(below(random, size.width), below(random, size.height));
      const int radius = size.width / 36 + below(random, size.width / 28);
      wrapped(size, [&](cv::Point by) {
        motif(picture, at + by, radius, 1, accent, shade(accent, 0.6));
      });
    }
  }
  modulate(picture, noise(size, size.width / 4, 8, random), 12.0);
  modulate(picture, noise(size, 8, size.height / 4, random), 12.0);
  modulate(picture, noise(size, 5, 5, random), 14.0);
  return picture;
}

cv::Mat metal(cv::Size size, const Colour& colour, Random random) {
  cv::Mat picture = filled(size, colour);
  modulate(picture, noise(size, 3, size.height / 2, random), 8.0);
  modulate(picture, noise(size, 4, 4, random), 14.0);
  for (int i = 0; i < 26; ++i) {
    const cv::Point at(below(random, size.width), below(random, size.height));
    const cv::Point to = at + cv::Point(below(random, 50) - 25, below(random, 16) - 8);
    cv::line(picture, at, to, shade(colour, random.uniform(-0.4, 0.5)), 1, cv::LINE_AA);
  }
  for (int i = 0; i < 8; ++i) {
    const cv::Point at(below(random, size.width), below(random, size.height));
    cv::circle(picture, at, 1 + below(random, 3), shade(colour, -0.5), cv::FILLED, cv::LINE_AA);
  }
  return picture;
}

mjsMaterial& add_material(mjSpec& spec, const std::string& name, const cv::Mat& picture,
                          double repeat_x, double repeat_y) {
  check(picture.type() == CV_8UC3 && picture.isContinuous(), "a texture is packed 8-bit RGB");
  mjsTexture* const added = mjs_addTexture(&spec, nullptr);
  check(mjs_setName(added->element, name.c_str()) == 0, "texture names are used once");
  added->type = mjTEXTURE_2D;
  added->colorspace = mjCOLORSPACE_LINEAR;
  added->width = picture.cols;
  added->height = picture.rows;
  added->nchannel = 3;
  mjs_setBuffer(added->data, picture.data, static_cast<int>(picture.total() * 3));
  mjsMaterial* const material = mjs_addMaterial(&spec, nullptr);
  mjs_setName(material->element, name.c_str());
  mjs_setInStringVec(material->textures, mjTEXROLE_RGB, name.c_str());
  material->specular = 0.0F;
  material->shininess = 0.0F;
  if (repeat_x > 0.0) {
    material->texuniform = 1;
    material->texrepeat[0] = static_cast<float>(repeat_x);
    material->texrepeat[1] = static_cast<float>(repeat_y);
  }
  return *material;
}

}  // namespace pacer::sim::texture
