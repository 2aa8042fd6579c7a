// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/tracking_story.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "core/check.h"
#include "runs/film.h"
#include "runs/report/palette.h"
#include "runs/report/picture.h"
#include "runs/tracking/picture_chunks.h"
#include "runs/tracking/tracking_film.h"

namespace pacer {
namespace {

/// Calls `see(at, picture)` for every picture that trackers saw, until it returns false. Why they
/// end early is returned; empty: they do not.
template <class See>
std::string see_again(const TrackingComparison& comparison, std::size_t target, const See& see) {
  PictureChunks chunks(comparison.targets.at(target));
  std::size_t at = comparison.targets[target].first;
  for (auto pictures = chunks.next(1); !pictures.empty(); pictures = chunks.next(1)) {
    if (!see(at++, pictures.front())) break;
  }
  return chunks.error();
}

/// The truth's box, then each tracker's, in the sequence's `at`-th picture.
std::vector<std::optional<Box>> boxes_at(const TrackingComparison& comparison, std::size_t target,
                                         std::size_t at) {
  const std::vector<std::optional<Box>>& truth = comparison.targets[target].truth;
  std::vector<std::optional<Box>> boxes = {at < truth.size() ? truth[at] : std::nullopt};
  for (std::size_t tracker = 0; tracker < comparison.trackers.size(); ++tracker) {
    const ScoredRun* const one = comparison.find(target, tracker);
    std::optional<Box> box;
    if (one != nullptr && at >= one->run.first && at - one->run.first < one->run.tracks.size()) {
      box = one->run.tracks[at - one->run.first].box;
    }
    boxes.push_back(box);
  }
  return boxes;
}

/// How many of the target's pictures the run that saw most of them saw.
std::size_t pictures_of(const TrackingComparison& comparison, std::size_t target) {
  std::size_t most = 0;
  for (std::size_t tracker = 0; tracker < comparison.trackers.size(); ++tracker) {
    const ScoredRun* const one = comparison.find(target, tracker);
    if (one != nullptr) most = std::max(most, one->run.pictures);
  }
  return most;
}

/// Losses of a target, by picture; those that are close to each other together.
std::map<std::size_t, std::vector<std::string>> losses_of(const TrackingComparison& comparison,
                                                          std::size_t target) {
  std::map<std::size_t, std::vector<std::string>> by_picture;
  for (std::size_t tracker = 0; tracker < comparison.trackers.size(); ++tracker) {
    const ScoredRun* const one = comparison.find(target, tracker);
    if (one == nullptr || !one->score.lost_at) continue;
    by_picture[one->run.first + *one->score.lost_at].push_back(comparison.trackers[tracker]);
  }
  const std::size_t near = std::max<std::size_t>(1, pictures_of(comparison, target) / 16);
  std::map<std::size_t, std::vector<std::string>> together;
  for (const auto& [at, names] : by_picture) {
    const bool joins = !together.empty() && at - together.rbegin()->first < near;
    std::vector<std::string>& group = joins ? together.rbegin()->second : together[at];
    group.insert(group.end(), names.begin(), names.end());
  }
  return together;
}

}  // namespace

std::vector<BoxStyle> styles_of(const TrackingComparison& comparison) {
  const report::Palette palette(comparison.trackers);
  std::vector<BoxStyle> styles = {truth_style()};
  for (const std::string& name : comparison.trackers) {
    styles.push_back(
        {.name = name,
         .colour = std::string(palette.colour(name)),
         .dashed = std::ranges::find(comparison.peers, name) != comparison.peers.end()});
  }
  return styles;
}

std::vector<KeyPicture> key_pictures(const TrackingComparison& comparison, std::size_t target,
                                     std::size_t most) {
  const std::size_t pictures = pictures_of(comparison, target);
  if (pictures == 0) return {};
  const std::size_t first = comparison.targets[target].first;
  std::map<std::size_t, std::string> chosen = {{first, "start"}, {first + pictures - 1, "end"}};
  for (const auto& [at, names] : losses_of(comparison, target)) {
    if (chosen.size() >= most) break;
    chosen[at] = fmt::format("lost by {}", fmt::join(names, ", "));
  }
  const std::size_t fewest = std::min<std::size_t>({most, 6, pictures});
  while (chosen.size() < fewest) {  // in the middle of the widest gap
    std::size_t left = first;
    std::size_t widest = 0;
    for (auto one = chosen.begin(); std::next(one) != chosen.end(); ++one) {
      const std::size_t gap = std::next(one)->first - one->first;
      if (gap > widest) {
        widest = gap;
        left = one->first;
      }
    }
    if (widest < 2) break;
    chosen.emplace(left + widest / 2, "");
  }
  std::vector<KeyPicture> told;
  for (const auto& [at, about] : chosen) {
    told.push_back({.at = at, .about = about, .jpg = {}});
  }
  return told;
}

TrackingStory tell(const TrackingComparison& comparison, std::size_t target) {
  constexpr double kSide = 440.0;      // pixels, of pictures and film
  constexpr std::size_t kLong = 1500;  // pictures: of longer films some are left out
  constexpr int kQuality = 29;
  TrackingStory story;
  story.pictures = key_pictures(comparison, target);
  const std::size_t stride = 1 + pictures_of(comparison, target) / kLong;
  const TemporaryFile file(".mp4");
  TrackingFilm film(file.path(), film_rate(comparison.targets[target].sequence), kQuality);
  std::optional<TrackingView> view;
  Frame drawn;
  std::size_t count = 0;
  auto key = story.pictures.begin();
  story.error =
      see_again(comparison, target, [&](std::size_t at, const tracking::Picture& picture) {
        if (!view) {
          const ImageSize size{picture.bgr.cols, picture.bgr.rows};
          view.emplace(size, styles_of(comparison),
                       TrackingView::Layout{.scale = kSide / std::max(size.width, size.height),
                                            .legend = false});
        }
        const bool filmed = count++ % stride == 0;
        const bool told = key != story.pictures.end() && key->at == at;
        if (!filmed && !told) return true;
        view->draw(picture.bgr, fmt::format("picture {}", at + 1), boxes_at(comparison, target, at),
                   Annotations{}, drawn);
        if (filmed) film.write(drawn);
        if (told) (key++)->jpg = report::encode_jpeg(drawn);
        return true;
      });
  film.close();
  std::erase_if(story.pictures, [](const KeyPicture& one) { return one.jpg.empty(); });
  if (count > 0) story.mp4 = file.bytes();
  return story;
}

void film_trackers(const TrackingComparison& comparison, std::size_t target,
                   const std::filesystem::path& file, const std::stop_token& stop) {
  TrackingFilm film(file, film_rate(comparison.targets.at(target).sequence));
  std::optional<TrackingView> view;
  Frame drawn;
  see_again(comparison, target, [&](std::size_t at, const tracking::Picture& picture) {
    if (!view) {
      const ImageSize size{picture.bgr.cols, picture.bgr.rows};
      view.emplace(size, styles_of(comparison),
                   TrackingView::Layout{.scale = TrackingView::magnification(size)});
    }
    view->draw(picture.bgr, fmt::format("picture {}", at + 1), boxes_at(comparison, target, at),
               Annotations{}, drawn);
    film.write(drawn);
    return !stop.stop_requested();
  });
  film.close();
}

}  // namespace pacer
