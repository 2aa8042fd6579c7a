// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/results_file.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/check.h"
#include "core/output_file.h"

namespace pacer {
namespace {

/// The numbers of a line, none where it holds anything else or not four.
std::optional<std::array<double, 4>> four_numbers(std::string_view line) {
  constexpr std::string_view kBetween = ", \t\r";
  std::array<double, 4> numbers{};
  std::size_t count = 0;
  for (std::size_t at = line.find_first_not_of(kBetween); at != std::string_view::npos;
       at = line.find_first_not_of(kBetween, at)) {
    const std::string_view word = line.substr(at, line.find_first_of(kBetween, at) - at);
    if (count == numbers.size()) return std::nullopt;
    const auto [end, error] =
        std::from_chars(word.data(), word.data() + word.size(), numbers[count++]);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    at += word.size();
  }
  return count == numbers.size() ? std::optional(numbers) : std::nullopt;
}

}  // namespace

std::string results_text(std::size_t first, std::span<const tracking::Track> tracks) {
  std::string text;
  for (std::size_t i = 0; i < first; ++i) text += "NaN,NaN,NaN,NaN\n";
  for (const tracking::Track& track : tracks) {
    const Box& box = track.box;
    if (is_proper(box)) {
      text += fmt::format("{:.8g},{:.8g},{:.8g},{:.8g}\n", box.left() + 1.0, box.top() + 1.0,
                          box.width, box.height);
    } else {
      text += "NaN,NaN,NaN,NaN\n";
    }
  }
  return text;
}

std::vector<std::optional<Box>> read_results(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read");
  std::vector<std::optional<Box>> boxes;
  for (std::string line; std::getline(stream, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto numbers = four_numbers(line);
    if (!numbers) {
      throw std::runtime_error(fmt::format("{}:{}: want x,y,width,height, got {}", file.string(),
                                           boxes.size() + 1, line.substr(0, 80)));
    }
    const auto [left, top, width, height] = *numbers;
    const Box box = Box::of_pixels(left - 1.0, top - 1.0, width, height);
    boxes.push_back(is_proper(box) ? std::optional(box) : std::nullopt);
  }
  return boxes;
}

ResultFiles::ResultFiles(std::filesystem::path out, bool several) : out_(std::move(out)) {
  if (out_.empty()) return;
  std::error_code error;
  const bool there = std::filesystem::exists(out_, error);
  folder_ = several || std::filesystem::is_directory(out_, error);
  if (folder_ && there && !std::filesystem::is_directory(out_, error)) {
    throw UsageError(out_.string() + ": is a file; several results want a folder");
  }
}

std::filesystem::path ResultFiles::place(const std::string& tracker,
                                         const std::string& target) const {
  return folder_ ? out_ / tracker / (target + ".txt") : out_;
}

void ResultFiles::try_one(const std::string& tracker, const std::string& target) const {
  if (!out_.empty()) const OutputFile tried(place(tracker, target));
}

void ResultFiles::write(const TrackingRun& run) const {
  if (out_.empty() || run.tracks.empty()) return;
  OutputFile file(place(run.tracker, run.target));
  file.write(results_text(run.first, run.tracks));
  file.keep();
}

}  // namespace pacer
