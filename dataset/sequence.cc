// SPDX-License-Identifier: Apache-2.0
#include "dataset/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/check.h"
#include "dataset/files.h"
#include "dataset/sequence_annotation.h"
#include "dataset/sequence_layout.h"
#include "dataset/video.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBoxes = 10 * kMostPictures;  // of all targets
constexpr const char* kTruths =
    "groundtruth_rect.txt (OTB), groundtruth.txt (VOT, GOT-10k) or gt.txt (TLD)";

/// A sequence of OTB's whose annotation begins at a later picture than the folder does. (Those of
/// its others that are shorter than the pictures, Diving, Football1, Freeman3 and Freeman4, begin
/// at the first; and the pictures of BlurCar1, 3 and 4 begin where their annotations do.)
struct LateStart {
  std::string_view name;
  std::size_t lines;
  std::int64_t first;  // the number of the first annotated picture
};
constexpr std::array kLateStarts = {LateStart{"David", 471, 300}};

/// The index of the picture that the annotation's first line is of.
std::size_t first_annotated(const Sequence& sequence, const std::vector<NumberedPicture>& pictures,
                            std::size_t lines) {
  if (sequence.layout != SequenceLayout::kOtb) return 0;
  const auto late = std::ranges::find_if(kLateStarts, [&](const LateStart& each) {
    return each.name == sequence.name && each.lines == lines;
  });
  if (late == kLateStarts.end()) return 0;
  const auto first = std::ranges::find(pictures, late->first, &NumberedPicture::number);
  const auto index = static_cast<std::size_t>(first - pictures.begin());
  return index + lines <= pictures.size() ? index : 0;
}

/// Gives each picture its box: line i is of picture i from the first annotated one on.
std::vector<std::optional<Box>> spread(std::vector<std::optional<Box>> lines,
                                       const std::vector<NumberedPicture>& pictures,
                                       std::size_t first, const fs::path& file) {
  if (lines.size() == pictures.size()) return lines;
  const auto gap = std::ranges::adjacent_find(
      pictures, [](const auto& a, const auto& b) { return b.number != a.number + 1; });
  const auto annotated = static_cast<std::ptrdiff_t>(first + lines.size());
  if (gap != pictures.end() && gap + 1 - pictures.begin() < annotated) {
    throw std::runtime_error(
        fmt::format("{}: {} lines for {} pictures, of which one is missing after {}; put it back",
                    file.string(), lines.size(), pictures.size(), gap->path.string()));
  }
  if (lines.size() > pictures.size()) {
    throw std::runtime_error(
        fmt::format("{}:{}: a line for a picture that is not there: {} lines, "
                    "{} pictures; add the pictures or take lines away",
                    file.string(), pictures.size() + 1, lines.size(), pictures.size()));
  }
  std::vector<std::optional<Box>> boxes(pictures.size());
  std::ranges::move(lines, boxes.begin() + static_cast<std::ptrdiff_t>(first));
  return boxes;
}

/// Takes the boxes away where GOT-10k's label says that the target is absent.
void apply_absence(const fs::path& file, std::vector<std::optional<Box>>& boxes) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return;
  const std::vector<bool> absent = parse_absence(read_text(file), file.string());
  if (absent.size() > boxes.size()) {
    throw std::runtime_error(
        fmt::format("{}:{}: a line for a picture that is not there; the sequence has {}",
                    file.string(), boxes.size() + 1, boxes.size()));
  }
  for (std::size_t i = 0; i < absent.size(); ++i) {
    if (absent[i]) boxes[i].reset();
  }
}

void read_targets(const TruthFiles& truth, const std::vector<NumberedPicture>& pictures,
                  Sequence& sequence) {
  const bool several = truth.files.size() > 1;
  if (truth.files.size() * std::max<std::size_t>(pictures.size(), 1) > kMostBoxes) {
    throw std::runtime_error(fmt::format("{}: {} targets in {} pictures are more than can be held",
                                         sequence.path.string(), truth.files.size(),
                                         pictures.size()));
  }
  for (const TruthFile& file : truth.files) {
    auto lines = parse_boxes(read_text(file.path), truth.layout, file.path.string());
    if (lines.empty()) {
      if (several) continue;  // OTB's Human4 has an empty one
      throw std::runtime_error(fmt::format("{}: is empty; write a box a line", file.path.string()));
    }
    if (!pictures.empty()) {
      const std::size_t first = first_annotated(sequence, pictures, lines.size());
      lines = spread(std::move(lines), pictures, first, file.path);
    }
    if (truth.layout == SequenceLayout::kGot10k) {
      apply_absence(file.path.parent_path() / "absence.label", lines);
    }
    sequence.targets.push_back({file.target, std::move(lines)});
  }
  if (sequence.targets.empty()) {
    throw std::runtime_error(fmt::format("{}: its annotations are empty", sequence.path.string()));
  }
  if (sequence.targets.size() == 1) sequence.targets.front().name.clear();
}

UsageError not_annotated(const fs::path& folder) {
  if (find_pictures(folder, SequenceLayout::kOtb).empty()) {
    return UsageError(
        fmt::format("{}: neither pictures nor annotations; put pictures ({}) and {} in it",
                    folder.string(), kPictureKinds, kTruths));
  }
  return UsageError(fmt::format("{}: not annotated, so no sequence; add {}, a box a line",
                                folder.string(), kTruths));
}

Sequence open_folder(const fs::path& folder) {
  const std::optional<TruthFiles> truth = find_truth(folder);
  Sequence sequence;
  sequence.name = sequence_name(folder);
  sequence.path = folder;
  if (truth) sequence.layout = truth->layout;
  const std::vector<NumberedPicture> pictures = find_pictures(folder, sequence.layout);
  if (!truth) {
    if (pictures.empty()) throw not_annotated(folder);
  } else if (pictures.empty()) {
    const auto video =
        truth->layout == SequenceLayout::kTld ? find_video(folder) : std::optional<fs::path>();
    if (!video) {
      throw std::runtime_error(fmt::format(
          "{}: no pictures; put them beside {} or into a folder img or color, named by "
          "number ({})",
          folder.string(), truth->files.front().path.filename().string(), kPictureKinds));
    }
    sequence.path = *video;
    static_cast<void>(VideoDecoder(*video));  // can be read
  }
  for (const NumberedPicture& picture : pictures) sequence.pictures.push_back(picture.path);
  if (truth) read_targets(*truth, pictures, sequence);
  return sequence;
}

Sequence open_video(const fs::path& file) {
  static_cast<void>(VideoDecoder(file));  // can be read
  Sequence sequence;
  sequence.name = sequence_name(file);
  sequence.path = file;
  sequence.layout = SequenceLayout::kVideo;
  return sequence;
}

}  // namespace

Sequence Sequence::open(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return open_folder(path);
  if (fs::is_regular_file(status)) return open_video(path);
  throw UsageError(fmt::format("{}: {}; name a sequence's folder or a video", path.string(),
                               fs::exists(status) ? "neither a folder nor a plain file"
                                                  : "there is no such folder or file"));
}

std::vector<Sequence> find_sequences(const fs::path& folder) {
  std::vector<Sequence> sequences;
  std::error_code error;
  if (!fs::is_directory(folder, error) || looks_like_sequence(folder)) {
    sequences.push_back(Sequence::open(folder));
    return sequences;
  }
  std::vector<fs::path> inner;
  for (fs::directory_iterator each(folder, error); !error && each != fs::directory_iterator();
       each.increment(error)) {
    const bool hidden = each->path().filename().string().starts_with('.');
    std::error_code ignored;
    if (!hidden && each->is_directory(ignored)) inner.push_back(each->path());
  }
  if (error) {
    throw std::runtime_error(
        fmt::format("{}: cannot be listed: {}", folder.string(), error.message()));
  }
  std::ranges::sort(inner);
  for (const fs::path& path : inner) {
    if (!looks_like_sequence(path)) continue;
    sequences.push_back(Sequence::open(path));
    if (sequences.back().targets.empty()) throw not_annotated(path);
  }
  if (sequences.empty() && !find_pictures(folder, SequenceLayout::kOtb).empty()) {
    sequences.push_back(Sequence::open(folder));
  }
  if (sequences.empty()) {
    throw UsageError(
        fmt::format("{}: no sequences; each is a folder with {} in it", folder.string(), kTruths));
  }
  return sequences;
}

}  // namespace pacer::dataset
