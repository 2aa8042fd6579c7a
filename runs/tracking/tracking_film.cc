// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/tracking_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pacer {

const Frame& TrackerDrawing::draw(std::size_t at, const cv::Mat& bgr, const tracking::Track& track,
                                  const Annotations& marks, const std::optional<Box>& truth) {
  if (!marks.patches.empty()) expect_patches();
  if (!view_) {
    const ImageSize size{bgr.cols, bgr.rows};
    std::vector<BoxStyle> styles;
    if (with_truth_) styles.push_back(truth_style());
    styles.push_back({.name = tracker_, .colour = "#FF9F1C"});
    view_.emplace(
        size, std::move(styles),
        TrackingView::Layout{.scale = TrackingView::magnification(size), .patches = patches_});
  }
  const bool lost = track.confidence <= 0.0;
  const std::string state = lost ? "lost" : fmt::format("confidence {:.2f}", track.confidence);
  std::vector<std::optional<Box>> boxes;
  if (with_truth_) boxes.push_back(truth);
  boxes.push_back(lost ? std::nullopt : std::optional(track.box));
  view_->draw(bgr, fmt::format("picture {}   {}", at + 1, state), boxes, marks, drawn_);
  return drawn_;
}

void TrackerDrawing::expect_patches() {
  if (patches_) return;
  patches_ = true;
  view_.reset();
}

TrackingFilm::TrackingFilm(const std::filesystem::path& file, int rate_hz, int quality)
    : file_(file), rate_hz_(rate_hz), quality_(quality) {}

void TrackingFilm::write(const Frame& drawn) {
  if (!encoder_) {
    encoder_.emplace(
        file_.path(), drawn.size, rate_hz_,
        dataset::VideoSettings{
            .preset = "veryfast", .quality = quality_, .key_frame_every = 2 * rate_hz_});
  }
  encoder_->write(drawn);
}

void TrackingFilm::close() {
  if (!encoder_) return;
  encoder_->close();
  file_.keep();
}

TrackerFilm::TrackerFilm(const std::filesystem::path& file, int rate_hz, std::string tracker,
                         std::size_t first, std::vector<std::optional<Box>> truth)
    : film_(file, rate_hz),
      drawing_(std::move(tracker), !truth.empty()),
      at_(first),
      truth_(std::move(truth)) {}

TrackWatch TrackerFilm::watch() {
  return [this](const tracking::Picture& picture, const tracking::Track& track,
                const tracking::Tracker& tracker) {
    const bool first = !std::exchange(seen_, true);
    Shot& shot = first ? start_.emplace() : shot_;
    picture.bgr.copyTo(shot.bgr);
    shot.track = track;
    shot.marks.clear();
    tracker.annotate(shot.marks);
    if (first) return;
    if (start_) {
      if (!shot.marks.patches.empty()) drawing_.expect_patches();
      write(*start_);
      start_.reset();
    }
    write(shot);
  };
}

void TrackerFilm::write(const Shot& shot) {
  const std::optional<Box> truth = at_ < truth_.size() ? truth_[at_] : std::nullopt;
  film_.write(drawing_.draw(at_++, shot.bgr, shot.track, shot.marks, truth));
}

void TrackerFilm::close() {
  if (start_) write(*start_);
  film_.close();
}

int film_rate(const dataset::Sequence& sequence) {
  constexpr double kUsual = 25.0;
  double rate = kUsual;
  if (sequence.pictures.empty()) {
    rate = dataset::VideoDecoder(sequence.path).rate_hz();
    if (!(rate >= 1.0)) rate = kUsual;  // the file does not say
  }
  return static_cast<int>(std::lround(std::min(rate, 1000.0)));
}

}  // namespace pacer
