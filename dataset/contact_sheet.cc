// SPDX-License-Identifier: Apache-2.0
#include "dataset/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/check.h"
#include "dataset/video.h"

namespace pacer::dataset {
namespace {

constexpr int kMargin = 12;
constexpr int kGap = 4;
constexpr int kTitleHeight = 26;
constexpr int kChartHeight = 72;
constexpr int kRowGap = 16;

const cv::Scalar kPaper(250, 250, 250);
const cv::Scalar kInk(40, 40, 40);
const cv::Scalar kGrid(220, 220, 220);
const cv::Scalar kSteering(180, 96, 24);   // blue
const cv::Scalar kThrottle(36, 110, 214);  // orange

/// `count` of the numbers 0 to `of` - 1, evenly spaced, both ends among them.
std::vector<std::int64_t> evenly(std::int64_t count, std::int64_t of) {
  std::vector<std::int64_t> chosen;
  count = std::min(count, of);
  for (std::int64_t i = 0; i < count; ++i) {
    chosen.push_back(count == 1 ? 0 : i * (of - 1) / (count - 1));
  }
  return chosen;
}

void write_text(cv::Mat& sheet, const std::string& text, cv::Point at, const cv::Scalar& colour) {
  cv::putText(sheet, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.45, colour, 1, cv::LINE_AA);
}

void draw_frames(cv::Mat& sheet, const Dataset& dataset, std::size_t episode,
                 const ContactSheetOptions& options, cv::Rect first) {
  const EpisodeEntry& entry = dataset.episodes()[episode];
  VideoDecoder video(dataset.video_file(episode));
  Frame frame;
  for (const std::int64_t index : evenly(options.frames, entry.length)) {
    const double time = entry.video_from + static_cast<double>(index) / dataset.info().rate_hz;
    video.seek(Seconds{time});
    if (!video.next(frame)) {
      throw std::runtime_error(
          fmt::format("{}: ends before frame {}", dataset.video_file(episode).string(), index));
    }
    const cv::Mat rgb(frame.size.height, frame.size.width, CV_8UC3, frame.rgb.data());
    cv::Mat small;
    cv::resize(rgb, small, first.size(), 0.0, 0.0, cv::INTER_AREA);
    cv::cvtColor(small, sheet(first), cv::COLOR_RGB2BGR);
    first.x += first.width + kGap;
  }
}

void draw_chart(cv::Mat& sheet, const Dataset& dataset, std::size_t episode, cv::Rect area) {
  const auto height_of = [&](double value) {
    return area.y + (1.0 - std::clamp(value, -1.0, 1.0)) / 2.0 * (area.height - 1);
  };
  cv::rectangle(sheet, area, cv::Scalar::all(255), cv::FILLED);
  const int middle = static_cast<int>(height_of(0.0));
  cv::line(sheet, {area.x, middle}, {area.x + area.width - 1, middle}, kGrid);
  cv::rectangle(sheet, area, kGrid);

  constexpr int kFraction = 4;  // bits of a pixel, for smooth lines
  std::array<std::vector<cv::Point>, 2> curves;
  EpisodeReader reader(dataset, episode, {std::string(kAction)}, EpisodeReader::Frames::kLeave);
  const double last =
      std::max<double>(static_cast<double>(dataset.episodes()[episode].length) - 1, 1);
  for (double index = 0.0; const RecordedStep* step = reader.next(); index += 1.0) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      curves[i].emplace_back(
          cv::saturate_cast<int>((area.x + index / last * (area.width - 1)) * (1 << kFraction)),
          cv::saturate_cast<int>(height_of(step->values[i]) * (1 << kFraction)));
    }
  }
  cv::polylines(sheet, curves[0], false, kSteering, 1, cv::LINE_AA, kFraction);
  cv::polylines(sheet, curves[1], false, kThrottle, 1, cv::LINE_AA, kFraction);
}

}  // namespace

void ContactSheetOptions::validate() const {
  require(frames >= 1 && frames <= 100, "frames: must lie in [1, 100]");
  require(most_episodes >= 1 && most_episodes <= 1000, "most_episodes: must lie in [1, 1000]");
  require(width >= 320 && width <= 16384, "width: must lie in [320, 16384]");
}

cv::Mat contact_sheet(const Dataset& dataset, const ContactSheetOptions& options) {
  options.validate();
  if (dataset.features({std::string(kAction)}).front().width != 2) {
    throw UsageError(dataset.root().string() + ": its action is not steering and throttle");
  }
  const ImageSize size = dataset.info().image_size;
  const int inner = options.width - 2 * kMargin;
  const int frame_width = std::max(8, (inner - (options.frames - 1) * kGap) / options.frames);
  const int frame_height = std::max(8, frame_width * size.height / size.width);
  const int row = kTitleHeight + frame_height + kGap + kChartHeight + kRowGap;
  const auto total = static_cast<std::int64_t>(dataset.episodes().size());
  const auto chosen = evenly(options.most_episodes, total);
  const int rows = static_cast<int>(chosen.size());
  cv::Mat sheet(std::max(rows * row, kTitleHeight) + kMargin, options.width, CV_8UC3, kPaper);
  if (chosen.empty()) write_text(sheet, "no episodes", {kMargin, kTitleHeight - 8}, kInk);
  int top = 0;
  for (const std::int64_t number : chosen) {
    const auto episode = static_cast<std::size_t>(number);
    const std::int64_t length = dataset.episodes()[episode].length;
    write_text(sheet,
               fmt::format("episode {}{}   {} frames   {:.1f} s", number,
                           rows < total ? fmt::format(" of 0 to {}", total - 1) : "", length,
                           static_cast<double>(length) / dataset.info().rate_hz),
               {kMargin, top + kTitleHeight - 8}, kInk);
    const int legend = options.width - kMargin - 150;
    write_text(sheet, "steering", {legend, top + kTitleHeight - 8}, kSteering);
    write_text(sheet, "throttle", {legend + 80, top + kTitleHeight - 8}, kThrottle);
    draw_frames(sheet, dataset, episode, options,
                {kMargin, top + kTitleHeight, frame_width, frame_height});
    draw_chart(sheet, dataset, episode,
               {kMargin, top + kTitleHeight + frame_height + kGap, inner, kChartHeight});
    top += row;
  }
  return sheet;
}

}  // namespace pacer::dataset
