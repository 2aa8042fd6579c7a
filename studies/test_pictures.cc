// SPDX-License-Identifier: Apache-2.0
#include "studies/test_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "core/check.h"
#include "dataset/picture_file.h"
#include "dataset/picture_list.h"
#include "dataset/reader.h"
#include "learning/tracking/picture.h"
#include "runs/report/picture.h"
#include "studies/materials.h"

namespace pacer {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> found;
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (dataset::is_picture(entry.path()) && entry.is_regular_file()) {
        found.push_back(entry.path());
      }
    }
  } catch (const fs::filesystem_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", error.path1().string(), error.code().message()));
  }
  std::ranges::sort(found);
  return found;
}

/// `text` as JSON can hold it.
std::string as_utf8(const std::string& text) {
  using nlohmann::json;
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace));
}

cv::Mat1b read_grey(const fs::path& file) {
  cv::Mat image;
  dataset::read_picture(file, image);
  tracking::Picture picture;
  tracking::to_picture(image, picture);
  cv::Mat1b grey = picture.grey;
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
  pictures.about = fmt::format("One frame of each of {} simulated rooms, the radio link whole.",
                               pictures.grey.size());
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
    throw UsageError(folder.string() + ": no pictures in it (" + dataset::kPictureKinds + ")");
  }
  TestPictures pictures;
  const std::size_t chosen = std::min(all.size(), TestPictures::kMost);
  for (std::size_t i = 0; i < chosen; ++i) {
    const fs::path& file = all[i * all.size() / chosen];
    pictures.grey.push_back(read_grey(file));
    pictures.names.push_back(as_utf8(fs::relative(file, folder).string()));
  }
  pictures.about = fmt::format("{} of the {} pictures in {}, evenly chosen.", chosen, all.size(),
                               folder.string());
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
  report::Content names;
  names.list(std::vector<report::Text>(pictures.names.begin(), pictures.names.end()));
  page.section("Pictures")
      .figure({.bytes = sheet, .caption = pictures.about})
      .details("Their names", names);
}

}  // namespace pacer
