// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/live_view.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <opencv2/highgui.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <utility>

#include "runs/tracking/picture_chunks.h"
#include "runs/tracking/tracking_film.h"

namespace pacer {
namespace {

constexpr const char* kWindow = "pacer track: Esc or q ends, r draws a box";
constexpr int kEscape = 27;

bool is_set(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets it
  return value != nullptr && *value != '\0';
}

/// Whether a window opens, tried in a process of its own: the toolkit aborts when it cannot reach
/// the display that the environment names.
bool window_opens() {
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(STDOUT_FILENO);
    ::close(STDERR_FILENO);
    try {
      cv::namedWindow("pacer");
    } catch (const std::exception&) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  int status = 1;
  return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

std::optional<Box> select(const cv::Mat3b& bgr) {
  const cv::Rect drawn = cv::selectROI(kWindow, bgr, false);
  if (drawn.empty()) return std::nullopt;
  return Box::of_pixels(drawn.x, drawn.y, drawn.width, drawn.height);
}

bool is_closed() { return cv::getWindowProperty(kWindow, cv::WND_PROP_VISIBLE) < 1.0; }

void show(const Frame& drawn) {
  // OpenCV has no view of constant pixels; nobody writes through this one.
  const cv::Mat rgb(drawn.size.height, drawn.size.width, CV_8UC3,
                    const_cast<std::uint8_t*>(drawn.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  cv::imshow(kWindow, bgr);
}

/// Adds a track of `picture`, from `tracker` started on `box` where there is one to start on.
void follow(tracking::Tracker& tracker, const tracking::Picture& picture,
            const std::optional<Box>& box, TrackingRun& run) {
  const auto now = std::chrono::steady_clock::now;
  const auto began = now();
  if (box) {
    tracker.start(picture, *box);
    run.tracks.push_back({.box = *box, .confidence = 1.0});
  } else {
    run.tracks.push_back(tracker.update(picture));
  }
  (box ? run.start_s : run.update_s) += std::chrono::duration<double>(now() - began).count();
}

}  // namespace

void require_display() {
  const bool named = is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
  if (!named || !window_opens()) {
    throw std::runtime_error(std::string("a window needs a display, and ") +
                             (named ? "the one that DISPLAY or WAYLAND_DISPLAY names cannot be used"
                                    : "neither DISPLAY nor WAYLAND_DISPLAY is set") +
                             ": run it on a desktop (or through ssh -X), or give --box x,y,w,h "
                             "(and, for a camera, --video FILE)");
  }
}

std::optional<Box> draw_box(const cv::Mat& image) {
  require_display();
  tracking::Picture picture;
  tracking::to_picture(image, picture);
  const std::optional<Box> box = select(picture.bgr);
  cv::destroyWindow(kWindow);
  return box;
}

TrackingRun track_live(const tracking::TrackerKind& kind, dataset::PictureSource& pictures,
                       std::optional<Box> box, std::uint64_t seed, const TrackWatch& watch,
                       const std::stop_token& stop) {
  require_display();
  TrackingRun run;
  run.tracker = kind.name;
  const std::unique_ptr<tracking::Tracker> tracker = kind.make(seed);
  TrackerDrawing drawing(kind.name, false);
  Annotations marks;
  PictureChunks chunks(pictures);
  cv::namedWindow(kWindow);
  for (int key = 0; !stop.stop_requested() && key != kEscape && key != 'q';) {
    const std::span<const tracking::Picture> next = chunks.next(1);
    if (next.empty()) break;
    const tracking::Picture& picture = next.front();
    if (key == 'r') {
      if (const auto drawn = select(picture.bgr)) box = drawn;
    }
    if (!box && run.tracks.empty()) {
      ++run.first;
      cv::imshow(kWindow, picture.bgr);
    } else {
      try {
        follow(*tracker, picture, std::exchange(box, std::nullopt), run);
      } catch (const std::exception& failure) {
        run.tracker_error = failure.what();
        break;
      }
      const std::size_t at = run.first + run.pictures++;
      marks.clear();
      tracker->annotate(marks);
      show(drawing.draw(at, picture.bgr, run.tracks.back(), marks));
      if (watch) watch(picture, run.tracks.back(), *tracker);
    }
    key = cv::waitKey(1) & 0xFF;
    if (is_closed()) break;
  }
  cv::destroyAllWindows();
  run.sequence_error = chunks.error();
  run.whole = !stop.stop_requested();
  return run;
}

}  // namespace pacer
