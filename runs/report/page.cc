// SPDX-License-Identifier: Apache-2.0
#include "runs/report/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/check.h"
#include "core/output_file.h"
#include "embedded/page_parts.h"
#include "embedded/vega.h"
#include "runs/report/escape.h"

namespace pacer::report {
namespace {

constexpr std::string_view kPolicy =
    "default-src 'none'; img-src data:; media-src data:; style-src 'unsafe-inline'; "
    "script-src 'unsafe-inline' 'unsafe-eval'; base-uri 'none'; form-action 'none'";

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

std::string id_from(std::string_view heading) {
  std::string id;
  for (const char c : heading) {
    if (is_word(c)) {
      id += static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
    } else if (!id.empty() && id.back() != '-') {
      id += '-';
    }
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  return id.empty() ? "section" : id;
}

std::string script(std::string_view code) { return fmt::format("<script>{}</script>\n", code); }

}  // namespace

Page::Page(std::string title, Text subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

bool Page::taken(const std::string& id) const {
  return std::any_of(sections_.begin(), sections_.end(),
                     [&id](const Section& section) { return section.id == id; });
}

Content& Page::section(std::string heading, std::string id) {
  if (id.empty()) {
    const std::string base = id_from(heading);
    id = base;
    for (int n = 2; taken(id); ++n) id = fmt::format("{}-{}", base, n);
  }
  require(std::all_of(id.begin(), id.end(), [](char c) { return is_word(c) || c == '-'; }),
          "section: an id has letters, digits and - only, not " + id);
  require(!taken(id), "section: the id is taken: " + id);
  sections_.push_back({.heading = std::move(heading), .id = std::move(id), .content = {}});
  return sections_.back().content;
}

std::string Page::html() const {
  std::string out = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<title>{}</title>\n<style>\n{}</style></head>\n<body>\n",
      kPolicy, escape_html(title_), embedded::page_parts("page.css"));
  out += fmt::format("<header><h1>{}</h1>", escape_html(title_));
  if (!subtitle_.empty()) out += "<p>" + subtitle_.html() + "</p>";
  out += "</header>\n";
  if (sections_.size() > 1) {
    out += "<nav aria-label=\"Contents\"><ol>";
    for (const Section& section : sections_) {
      out +=
          fmt::format("<li><a href=\"#{}\">{}</a></li>", section.id, escape_html(section.heading));
    }
    out += "</ol></nav>\n";
  }
  out += "<main>\n" + lead_.html();
  bool has_charts = lead_.has_charts();
  for (const Section& section : sections_) {
    out +=
        fmt::format("<section id=\"{}\"><h2>{}</h2>\n", section.id, escape_html(section.heading));
    out += section.content.html();
    out += "</section>\n";
    has_charts = has_charts || section.content.has_charts();
  }
  out += "</main>\n";
  if (has_charts) {
    out +=
        "<!-- Vega, Vega-Lite, Vega-Embed: BSD 3-Clause License, Copyright (c) 2015-2021 "
        "University of Washington Interactive Data Lab and contributors -->\n";
    for (const std::string_view file :
         {"vega-5.21.0.js", "vega-lite-4.17.0.js", "vega-embed-6.20.0.js"}) {
      out += script(embedded::vega(file));
    }
  }
  out += script(embedded::page_parts("page.js"));
  out += "</body></html>\n";
  return out;
}

void Page::write(const std::filesystem::path& file) const {
  OutputFile output(file);
  output.write(html());
  output.keep();
}

}  // namespace pacer::report
