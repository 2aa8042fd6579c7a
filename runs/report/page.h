// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <filesystem>
#include <string>

#include "runs/report/content.h"

namespace pacer::report {

/// A page of results in one HTML file: pictures, videos, data and scripts are inside it, and its
/// own policy forbids the browser to load anything else.
///
///     Page page("Following", "20 unseen episodes a policy");
///     page.lead().tiles(tiles);
///     page.section("Scores").table(scores).chart({line_chart(...), "Distance to the lead"});
///     page.write("out/report.html");
class Page {
 public:
  explicit Page(std::string title, Text subtitle = {});

  /// What stands above the first section.
  [[nodiscard]] Content& lead() noexcept { return lead_; }
  /// A new section at the end, named in the page's contents; the reference stays valid. It can be
  /// linked to as `#id`; ids are made from headings where none is given. Throws
  /// std::invalid_argument for an id that is taken or has other than letters, digits and `-`.
  Content& section(std::string heading, std::string id = {});

  [[nodiscard]] std::string html() const;
  /// Writes the page whole or not at all. Throws std::runtime_error naming the file.
  void write(const std::filesystem::path& file) const;

 private:
  struct Section {
    std::string heading;
    std::string id;
    Content content;
  };

  [[nodiscard]] bool taken(const std::string& id) const;

  std::string title_;
  Text subtitle_;
  Content lead_;
  std::deque<Section> sections_;
};

}  // namespace pacer::report
