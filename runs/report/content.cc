// SPDX-License-Identifier: Apache-2.0
#include "runs/report/content.h"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <string_view>

#include "core/check.h"
#include "runs/report/escape.h"

namespace pacer::report {
namespace {

using Bytes = std::span<const std::uint8_t>;

bool holds_at(Bytes bytes, std::size_t offset, std::string_view magic) {
  if (bytes.size() < offset + magic.size()) return false;
  for (std::size_t i = 0; i < magic.size(); ++i) {
    if (bytes[offset + i] != static_cast<unsigned char>(magic[i])) return false;
  }
  return true;
}

std::string data_uri(std::string_view type, Bytes bytes) {
  return fmt::format("data:{};base64,{}", type, base64(bytes));
}

std::string picture_uri(Bytes bytes) {
  if (holds_at(bytes, 0, "\x89PNG\r\n\x1A\n")) return data_uri("image/png", bytes);
  if (holds_at(bytes, 0, "\xFF\xD8\xFF")) return data_uri("image/jpeg", bytes);
  throw std::invalid_argument("figure: neither a PNG nor a JPEG file");
}

std::string captioned(std::string_view kind, const std::string& inner, const Text& caption) {
  const std::string words =
      caption.empty() ? "" : "<figcaption>" + caption.html() + "</figcaption>";
  return fmt::format("<figure class=\"{}\">{}{}</figure>\n", kind, inner, words);
}

std::string element(const Figure& figure) {
  return captioned("picture",
                   fmt::format("<img src=\"{}\" alt=\"{}\">", picture_uri(figure.bytes),
                               escape_html(figure.caption.plain())),
                   figure.caption);
}

std::string element(const Video& video) {
  require(holds_at(video.bytes, 4, "ftyp"), "video: not an MP4 file");
  const std::string poster =
      video.poster.empty() ? "" : " poster=\"" + picture_uri(video.poster) + "\"";
  return captioned("video",
                   fmt::format("<video controls muted loop playsinline preload=\"metadata\"{} "
                               "src=\"{}\"></video>",
                               poster, data_uri("video/mp4", video.bytes)),
                   video.caption);
}

/// No part of a chart may name a file or an address: its data is inline.
void require_inline(const nlohmann::json& spec) {
  if (spec.is_object()) {
    require(!spec.contains("url") && !spec.contains("href"),
            "chart: data must be inline, without url or href");
  }
  // Rows of data are values, whatever their keys are called; they are not looked through.
  for (const auto& [key, value] : spec.items()) {
    if (value.is_structured() && key != "values") require_inline(value);
  }
}

std::string element(const Chart& chart) {
  require(chart.spec.is_object(), "chart: the specification must be an object");
  require_inline(chart.spec);
  return captioned("chart",
                   fmt::format("<div class=\"plot\"></div>"
                               "<script type=\"application/json\">{}</script>",
                               escape_json(chart.spec)),
                   chart.caption);
}

template <class Element>
std::string grid(std::span<const Element> elements, std::string_view kind) {
  std::string out = fmt::format("<div class=\"grid {}\">", kind);
  for (const Element& one : elements) out += element(one);
  return out + "</div>\n";
}

}  // namespace

Content& Content::heading(const Text& text) {
  html_ += "<h3>" + text.html() + "</h3>\n";
  return *this;
}

Content& Content::paragraph(const Text& text) {
  html_ += "<p>" + text.html() + "</p>\n";
  return *this;
}

Content& Content::list(std::span<const Text> items) {
  html_ += "<ul>";
  for (const Text& item : items) html_ += "<li>" + item.html() + "</li>";
  html_ += "</ul>\n";
  return *this;
}

Content& Content::note(const Text& text, Verdict verdict) {
  html_ += fmt::format("<p class=\"note {}\">{}</p>\n", css_class(verdict), text.html());
  return *this;
}

Content& Content::code(std::string_view text) {
  html_ += "<pre><code>" + escape_html(text) + "</code></pre>\n";
  return *this;
}

Content& Content::facts(std::span<const Fact> facts) {
  html_ += "<dl class=\"facts\">";
  for (const Fact& fact : facts) {
    html_ +=
        fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", escape_html(fact.name), fact.value.html());
  }
  html_ += "</dl>\n";
  return *this;
}

Content& Content::tiles(std::span<const Tile> tiles) {
  html_ += "<div class=\"tiles\">";
  for (const Tile& tile : tiles) {
    html_ += fmt::format(
        "<div class=\"tile {}\"><span>{}</span><strong>{}</strong><small>{}</small></div>",
        css_class(tile.verdict), escape_html(tile.label), escape_html(tile.value),
        escape_html(tile.detail));
  }
  html_ += "</div>\n";
  return *this;
}

Content& Content::table(const Table& table) {
  html_ += report::html(table);
  return *this;
}

Content& Content::figure(const Figure& figure) {
  html_ += element(figure);
  return *this;
}

Content& Content::gallery(std::span<const Figure> figures) {
  html_ += grid(figures, "pictures");
  return *this;
}

Content& Content::video(const Video& video) {
  html_ += element(video);
  return *this;
}

Content& Content::videos(std::span<const Video> videos) {
  html_ += grid(videos, "pictures");
  return *this;
}

Content& Content::chart(const Chart& chart) {
  html_ += element(chart);
  has_charts_ = true;
  return *this;
}

Content& Content::charts(std::span<const Chart> charts) {
  html_ += grid(charts, "charts");
  has_charts_ = has_charts_ || !charts.empty();
  return *this;
}

Content& Content::details(const Text& summary, const Content& inner, bool open) {
  html_ += fmt::format("<details{}><summary>{}</summary><div>{}</div></details>\n",
                       open ? " open" : "", summary.html(), inner.html());
  has_charts_ = has_charts_ || inner.has_charts();
  return *this;
}

}  // namespace pacer::report
