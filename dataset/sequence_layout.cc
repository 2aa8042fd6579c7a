// SPDX-License-Identifier: Apache-2.0
#include "dataset/sequence_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "dataset/files.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostProperties = 1U << 16U;  // bytes
constexpr const char* kProperties = "sequence";

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

/// Files named `prefix`, the target's name, ".txt": 2 before 10.
std::vector<TruthFile> truth_of_targets(const fs::path& folder, std::string_view prefix) {
  constexpr std::string_view kEnd = ".txt";
  std::vector<TruthFile> found;
  for (const fs::path& path : list_files(folder)) {
    const std::string file = path.filename().string();
    if (file.size() <= prefix.size() + kEnd.size() || !file.starts_with(prefix) ||
        !file.ends_with(kEnd)) {
      continue;
    }
    found.push_back({file.substr(prefix.size(), file.size() - prefix.size() - kEnd.size()), path});
  }
  std::ranges::stable_sort(found, {}, [](const TruthFile& each) { return each.target.size(); });
  return found;
}

bool is_got10k(const fs::path& folder) {
  constexpr std::array kBeside = {"absence.label", "cover.label", "meta_info.ini"};
  return std::ranges::any_of(kBeside, [&](const char* name) { return is_file(folder / name); }) ||
         sequence_name(folder).starts_with("GOT-10k_");
}

/// A VOT `sequence` file: key=value, a line each.
std::map<std::string, std::string> read_properties(const fs::path& path) {
  const std::string text = read_text(path, kMostProperties);
  std::map<std::string, std::string> properties;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty()) continue;
    const std::size_t equals = line.find('=');
    const bool clean = std::ranges::none_of(line, [](char c) { return c >= 0 && c < ' '; });
    if (equals == std::string::npos || !clean) {
      throw std::runtime_error(
          fmt::format("{}:{}: no key=value; a line is as channels.color=color/%08d.jpg",
                      path.string(), number + 1));
    }
    properties[line.substr(0, equals)] = line.substr(equals + 1);
  }
  return properties;
}

/// The pictures of a pattern like color/%08d.jpg, or of a folder. It comes from a file that is not
/// trusted, and must not lead out of the sequence.
std::vector<NumberedPicture> pictures_of(const fs::path& folder, std::string pattern) {
  const auto fail = [&](const char* why) {
    throw std::runtime_error(
        fmt::format("{}: '{}' {}", (folder / kProperties).string(), pattern, why));
  };
  std::ranges::replace(pattern, '\\', '/');
  const fs::path inside = fs::path(pattern).lexically_normal();
  if (inside.is_absolute() || (!inside.empty() && *inside.begin() == "..")) {
    fail("leads out of the sequence's folder; name a place in it");
  }
  const std::string name = inside.filename().string();
  const std::size_t percent = name.find('%');
  if (percent == std::string::npos) {
    if (!is_folder(folder / inside)) fail("is no folder; a pattern is as color/%08d.jpg");
    return list_pictures(folder / inside);
  }
  const std::size_t end = name.find_first_not_of("0123456789", percent + 1);
  if (end == std::string::npos || name[end] != 'd' || name.find('%', end) != std::string::npos) {
    fail("is no pattern of pictures; one is as color/%08d.jpg");
  }
  return list_pictures(folder / inside.parent_path(), name.substr(0, percent),
                       name.substr(end + 1));
}

}  // namespace

std::string sequence_name(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

std::optional<TruthFiles> find_truth(const fs::path& folder) {
  using enum SequenceLayout;
  if (is_file(folder / "groundtruth_rect.txt")) {
    return TruthFiles{kOtb, {{"", folder / "groundtruth_rect.txt"}}};
  }
  if (auto several = truth_of_targets(folder, "groundtruth_rect."); !several.empty()) {
    return TruthFiles{kOtb, std::move(several)};
  }
  if (is_file(folder / "groundtruth.txt")) {
    const bool vot = is_file(folder / kProperties) || !is_got10k(folder);
    return TruthFiles{vot ? kVot : kGot10k, {{"", folder / "groundtruth.txt"}}};
  }
  if (is_file(folder / kProperties)) {
    if (auto several = truth_of_targets(folder, "groundtruth_"); !several.empty()) {
      return TruthFiles{kVot, std::move(several)};
    }
  }
  if (is_file(folder / "gt.txt")) return TruthFiles{kTld, {{"", folder / "gt.txt"}}};
  return std::nullopt;
}

bool looks_like_sequence(const fs::path& folder) {
  return find_truth(folder).has_value() || is_folder(folder / "img") ||
         is_folder(folder / "color") || is_file(folder / kProperties);
}

std::vector<NumberedPicture> find_pictures(const fs::path& folder, SequenceLayout layout) {
  if (layout == SequenceLayout::kVot && is_file(folder / kProperties)) {
    const auto properties = read_properties(folder / kProperties);
    for (const char* channel : {"channels.color", "channels.depth", "channels.ir"}) {
      if (const auto found = properties.find(channel); found != properties.end()) {
        return pictures_of(folder, found->second);
      }
    }
  }
  const fs::path inner = folder / (layout == SequenceLayout::kVot ? "color" : "img");
  return list_pictures(is_folder(inner) ? inner : folder);
}

std::optional<fs::path> find_video(const fs::path& folder) {
  constexpr std::array<std::string_view, 9> kExtensions = {".avi", ".mp4",  ".mpg", ".mpeg", ".mov",
                                                           ".mkv", ".webm", ".m4v", ".wmv"};
  std::optional<fs::path> found;
  for (const fs::path& file : list_files(folder)) {
    if (std::ranges::find(kExtensions, file.extension().string()) == kExtensions.end()) continue;
    if (found) {
      throw std::runtime_error(fmt::format("{}: two videos, {} and {}; keep the one annotated",
                                           folder.string(), found->filename().string(),
                                           file.filename().string()));
    }
    found = file;
  }
  return found;
}

}  // namespace pacer::dataset
