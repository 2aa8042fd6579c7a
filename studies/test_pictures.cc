// SPDX-License-Identifier: Apache-2.0
#include "studies/test_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string_view>

#include "core/check.h"
#include "dataset/reader.h"
#include "runs/report/picture.h"
#include "studies/materials.h"

namespace pacer {
namespace {

namespace fs = std::filesystem;

bool is_picture(const fs::directory_entry& entry) {
  static constexpr std::array<std::string_view, 6> kExtensions = {".jpg", ".jpeg", ".png",
                                                                  ".bmp", ".ppm",  ".pgm"};
  std::string extension = entry.path().extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  std::error_code ignored;
  return std::ranges::find(kExtensions, extension) != kExtensions.end() &&
         entry.is_regular_file(ignored);
}

std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> found;
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (is_picture(entry)) found.push_back(entry.path());
    }
  } catch (const fs::filesystem_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", error.path1().string(), error.code().message()));
  }
  std::ranges::sort(found);
  return found;
}

cv::Mat1b read_grey(const fs::path& file) {
  cv::Mat1b grey;
  try {
    grey = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
  } catch (const cv::Exception&) {  // of a size that OpenCV will not make room for
    grey.release();
  }
  if (grey.empty()) throw std::runtime_error(file.string() + ": cannot be read as a picture");
  const int longest = std::max(grey.cols, grey.rows);
  if (longest > TestPictures::kLongestSide) {
    const double scale = static_cast<double>(TestPictures::kLongestSide) / longest;
    cv::Mat1b smaller;
    cv::resize(grey, smaller,
               {std::max(1, cvRound(scale * grey.cols)), std::max(1, cvRound(scale * grey.rows))},
               0.0, 0.0, cv::INTER_AREA);
    grey = smaller;
  }
  if (std::min(grey.cols, grey.rows) < TestPictures::kShortestSide) {
    throw std::runtime_error(
        fmt::format("{}: {} x {} pixels is too small to move about in; {} a side are needed",
                    file.string(), grey.cols, grey.rows, TestPictures::kShortestSide));
  }
  return grey;
}

/// The last frame of each of `episodes` brief drives.
void add_room_frames(const Materials& materials, Purpose purpose, std::size_t episodes,
                     TestPictures& pictures) {
  const dataset::Dataset drives(materials.recording(purpose, episodes));
  for (std::size_t episode = 0; episode < episodes; ++episode) {
    dataset::EpisodeReader reader(drives, episode, {});
    Frame last;
    while (const dataset::RecordedStep* step = reader.next()) last = *step->frame;
    const cv::Mat rgb(last.size.height, last.size.width, CV_8UC3, last.rgb.data());
    cv::Mat1b grey;
    cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
    pictures.grey.push_back(grey);
    pictures.names.push_back(fmt::format(
        "{} room {}", purpose == Purpose::kCollect ? "demonstrated" : "unseen", episode + 1));
  }
}

TestPictures room_pictures(const StudyContext& context) {
  StudyContext brief = context;
  brief.scenario.simulated.duration = Seconds{0.2};
  brief.scenario.simulated.camera.link.corrupted = 0.0;  // snow is nothing to converge on
  const Materials materials(brief);
  TestPictures pictures;
  for (const Purpose purpose : {Purpose::kCollect, Purpose::kStudy}) {
    add_room_frames(materials, purpose, TestPictures::kMost / 2, pictures);
  }
  pictures.about = fmt::format("The pictures are {} frames of {} simulated rooms.",
                               pictures.grey.size(), pictures.grey.size());
  return pictures;
}

}  // namespace

TestPictures read_test_pictures(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw UsageError(folder.string() + ": there is no such folder of pictures");
  }
  const std::vector<fs::path> all = pictures_in(folder);
  if (all.empty()) {
    throw UsageError(folder.string() + ": no pictures in it (jpg, png, bmp, ppm or pgm)");
  }
  TestPictures pictures;
  const std::size_t chosen = std::min(all.size(), TestPictures::kMost);
  for (std::size_t i = 0; i < chosen; ++i) {
    const fs::path& file = all[i * all.size() / chosen];
    pictures.grey.push_back(read_grey(file));
    pictures.names.push_back(fs::relative(file, folder).string());
  }
  pictures.about =
      fmt::format("The pictures are {} of the {} in {}.", chosen, all.size(), folder.string());
  return pictures;
}

TestPictures test_pictures(const StudyContext& context) {
  return context.images ? read_test_pictures(*context.images) : room_pictures(context);
}

void show(const TestPictures& pictures, report::Page& page) {
  std::vector<report::Tiled> tiles;
  for (std::size_t i = 0; i < pictures.grey.size(); ++i) {
    cv::Mat3b rgb;
    cv::cvtColor(pictures.grey[i], rgb, cv::COLOR_GRAY2RGB);
    Frame frame;
    frame.size = {.width = rgb.cols, .height = rgb.rows};
    frame.rgb.assign(rgb.datastart, rgb.dataend);
    tiles.push_back({.frame = std::move(frame), .caption = pictures.names[i]});
  }
  constexpr int kColumns = 5;
  const std::vector<std::uint8_t> sheet =
      report::encode_jpeg(report::contact_sheet(tiles, kColumns, {.width = 240, .height = 180}));
  page.section("Pictures").figure({.bytes = sheet, .caption = pictures.about});
}

}  // namespace pacer
