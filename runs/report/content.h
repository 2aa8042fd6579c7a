// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "runs/report/table.h"
#include "runs/report/text.h"

namespace pacer::report {

/// A picture on a page. `bytes` are a whole PNG or JPEG file, copied when it is added.
struct Figure {
  std::span<const std::uint8_t> bytes;
  Text caption = {};
};

/// A video on a page. `bytes` are a whole MP4 file (H.264, yuv420p: what every browser plays),
/// copied when it is added; `poster`, if any, is the picture shown before it plays.
struct Video {
  std::span<const std::uint8_t> bytes;
  Text caption = {};
  std::span<const std::uint8_t> poster = {};
};

/// A chart on a page: a Vega-Lite 4 specification with its data inline (charts.h builds them).
struct Chart {
  nlohmann::json spec;
  Text caption = {};
};

/// A headline number: what is read first.
struct Tile {
  std::string label;
  std::string value;   ///< e.g. "86 %"
  std::string detail;  ///< e.g. "74 to 93, 50 episodes"
  Verdict verdict = Verdict::kOpen;
};

/// A name and what it is: seed, version, scenario.
struct Fact {
  std::string name;
  Text value;
};

/// What stands under one heading, from top to bottom. Each call adds one element and returns the
/// content, so that calls chain. Texts are escaped as they come in.
class Content {
 public:
  Content& heading(const Text& text);
  Content& paragraph(const Text& text);
  Content& list(std::span<const Text> items);
  /// A paragraph set apart, in the colour of its verdict.
  Content& note(const Text& text, Verdict verdict = Verdict::kOpen);
  /// Text as it is, line by line: a scenario, a command.
  Content& code(std::string_view text);
  Content& facts(std::span<const Fact> facts);
  Content& tiles(std::span<const Tile> tiles);
  Content& table(const Table& table);
  /// Throws std::invalid_argument for bytes that are neither PNG nor JPEG.
  Content& figure(const Figure& figure);
  Content& gallery(std::span<const Figure> figures);  ///< side by side
  /// Throws std::invalid_argument for bytes that are no MP4.
  Content& video(const Video& video);
  Content& videos(std::span<const Video> videos);  ///< side by side
  /// Throws std::invalid_argument for a chart that would load something from elsewhere.
  Content& chart(const Chart& chart);
  Content& charts(std::span<const Chart> charts);  ///< side by side
  /// `inner` behind a line that opens it.
  Content& details(const Text& summary, const Content& inner, bool open = false);

  [[nodiscard]] const std::string& html() const noexcept { return html_; }
  [[nodiscard]] bool has_charts() const noexcept { return has_charts_; }

 private:
  std::string html_;
  bool has_charts_ = false;
};

}  // namespace pacer::report
