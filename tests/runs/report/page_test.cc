// SPDX-License-Identifier: Apache-2.0
#include "runs/report/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "runs/report/charts.h"
#include "runs/report/picture.h"

namespace pacer::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string kHostile = "</script></title><script>alert('x')</script><img src=x onerror=y>";

std::size_t occurrences(std::string_view text, std::string_view what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string_view::npos;
       at = text.find(what, at + what.size())) {
    ++count;
  }
  return count;
}

Chart small_chart(const std::string& name) {
  const std::vector<Series> series = {{.name = name, .x = {0, 1}, .y = {2, 3}}};
  return {.spec = line_chart(series, {.title = name}, {.title = name}, Palette()), .caption = name};
}

std::vector<std::uint8_t> bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

TEST(Page, HostileTextIsShownWhereverItStands) {
  Page page(kHostile, kHostile);
  Page plain("title", "subtitle");
  for (auto* one : {&page, &plain}) {
    const std::string text = one == &page ? kHostile : "text";
    const std::vector<Fact> facts = {{text, text}};
    const std::vector<Tile> tiles = {{.label = text, .value = text, .detail = text}};
    const std::vector<Text> items = {text};
    one->lead().facts(facts).tiles(tiles).list(items).note(text);
    one->section(text)
        .heading(text)
        .paragraph(text)
        .code(text)
        .chart(small_chart(text))
        .details(text, Content().paragraph(text));
  }
  const std::string html = page.html();
  for (const char* markup : {"<script", "</script", "<img", "</title"}) {
    EXPECT_EQ(occurrences(html, markup), occurrences(plain.html(), markup)) << markup;
  }
}

TEST(Page, CarriesTheChartScriptsOnceAndOnlyForCharts) {
  Page page("page");
  page.section("words").paragraph("no chart");
  EXPECT_EQ(occurrences(page.html(), "vegaEmbed=t("), 0U);
  EXPECT_LT(page.html().size(), 40'000U);
  page.section("a").chart(small_chart("a"));
  page.section("b").details("more", Content().chart(small_chart("b")));
  EXPECT_EQ(occurrences(page.html(), "vegaEmbed=t("), 1U);
}

TEST(Page, AChartInDetailsBringsItsScripts) {
  Page page("page");
  page.section("b").details("more", Content().chart(small_chart("b")));
  EXPECT_EQ(occurrences(page.html(), "vegaEmbed=t("), 1U);
}

TEST(Page, ForbidsTheBrowserToLoadAnything) {
  EXPECT_THAT(Page("page").html(), HasSubstr("default-src 'none'"));
}

TEST(Page, PicturesAreInsideIt) {
  const Frame frame{.size = {2, 1}, .rgb = {255, 0, 0, 0, 0, 255}};
  Page page("page");
  page.section("pictures")
      .figure({.bytes = encode_png(frame), .caption = "red \"and\" blue"})
      .figure({.bytes = encode_jpeg(frame)});
  const std::string html = page.html();
  EXPECT_THAT(html, HasSubstr("<img src=\"data:image/png;base64,iVBORw0KGgo"));
  EXPECT_THAT(html, HasSubstr("<img src=\"data:image/jpeg;base64,/9j/"));
  EXPECT_THAT(html, HasSubstr("alt=\"red &quot;and&quot; blue\""));
}

TEST(Page, VideosPlayOnRequestWithoutSound) {
  const auto video = bytes_of(std::string("\0\0\0\x18", 4) + "ftypisom....");
  Content content;
  content.video({.bytes = video});
  EXPECT_THAT(content.html(), HasSubstr("<video controls muted loop playsinline"));
  EXPECT_THAT(content.html(), HasSubstr("src=\"data:video/mp4;base64,AAAAGGZ0eXBpc29t"));
}

TEST(Page, RejectsMediaOfAnotherKind) {
  const auto text = bytes_of("<svg onload=alert(1)>");
  EXPECT_THROW(Content().figure({.bytes = text}), std::invalid_argument);
  EXPECT_THROW(Content().video({.bytes = text}), std::invalid_argument);
  EXPECT_THROW(Content().figure({.bytes = {}}), std::invalid_argument);
}

TEST(Page, RejectsChartsThatLoadSomething) {
  Chart chart = small_chart("a");
  chart.spec["data"] = {{"url", "data.csv"}};
  EXPECT_THROW(Content().chart(chart), std::invalid_argument);
  EXPECT_THROW(Content().chart({.spec = "text"}), std::invalid_argument);
}

TEST(Page, SectionsHaveIdsOfTheirOwn) {
  Page page("page");
  page.section("Hits & misses");
  page.section("Hits, misses!");
  page.section("\xE8\xAF\x95");
  EXPECT_THAT(page.html(), HasSubstr("id=\"hits-misses\""));
  EXPECT_THAT(page.html(), HasSubstr("id=\"hits-misses-2\""));
  EXPECT_THAT(page.html(), HasSubstr("href=\"#section\""));
  EXPECT_THROW(page.section("x", "hits-misses"), std::invalid_argument);
  EXPECT_THROW(page.section("x", "a\"b"), std::invalid_argument);
}

class PageFile : public ::testing::Test {
 protected:
  PageFile()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                ::testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::remove_all(folder_);
  }
  ~PageFile() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

TEST_F(PageFile, IsWrittenWholeWithItsFolders) {
  const Page page("page");
  page.write(folder_ / "out" / "report.html");
  std::ifstream stream(folder_ / "out" / "report.html", std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), page.html());
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "report.html.partial"));
}

TEST_F(PageFile, ThatCannotBeWrittenIsNamed) {
  std::filesystem::create_directories(folder_);
  std::ofstream(folder_ / "file") << "in the way";
  try {
    Page("page").write(folder_ / "file" / "report.html");
    FAIL() << "wrote into a file as if it were a folder";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("report.html"));
  }
}

TEST_F(PageFile, OnAFullDiskIsAnErrorAndLeavesNothing) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  std::filesystem::create_directories(folder_);
  std::filesystem::create_symlink("/dev/full", folder_ / "report.html");
  EXPECT_THROW(Page("page").write(folder_ / "report.html"), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "report.html"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

}  // namespace
}  // namespace pacer::report
