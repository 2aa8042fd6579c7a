// SPDX-License-Identifier: Apache-2.0
// Opens the sample page in a headless browser, as a reader would, with no network.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>
#include <string>

#include "tests/runs/report/sample_page.h"

namespace pacer::report {
namespace {

namespace fs = std::filesystem;
using testing::kSampleCharts;
using testing::kSampleVideos;

std::optional<fs::path> find_browser() {
  const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nobody sets it
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
      if (access((fs::path(folder) / name).c_str(), X_OK) == 0) return fs::path(folder) / name;
    }
  }
  return std::nullopt;
}

/// Reports into the document what a page of its own accord would hide: errors, loads, and whether
/// videos decode. It is added to the tested copy only.
constexpr std::string_view kProbe = R"(<script>
  const root = document.documentElement;
  const problem = (what) => { root.dataset.problems = (root.dataset.problems || '') + what + '; '; };
  addEventListener('error', (event) => problem(event.message || event.target.tagName), true);
  addEventListener('unhandledrejection', (event) => problem(event.reason));
  addEventListener('securitypolicyviolation', (event) => problem('blocked ' + event.blockedURI));
  console.error = console.warn = (...words) => problem(words.join(' '));
  addEventListener('loadedmetadata', (event) => { event.target.dataset.plays = 'yes'; }, true);
  addEventListener('load', () => {
    document.querySelectorAll('details').forEach((details) => { details.open = true; });
    setTimeout(() => {
      root.dataset.wide = document.documentElement.scrollWidth > innerWidth;
      root.dataset.probed = 'yes';
    }, 3000);
  });
</script>)";

class BrowserTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!find_browser()) return;
    folder_ = fs::path(::testing::TempDir()) / fmt::format("pacer-report-{}", getpid());
    fs::create_directories(folder_);
    const std::string page = testing::sample_page(folder_);
    const std::string head = "<meta charset=\"utf-8\">";
    std::string probed = page;
    probed.insert(probed.find(head) + head.size(), kProbe);
    std::ofstream(folder_ / "page.html", std::ios::binary) << page;
    std::ofstream(folder_ / "probed.html", std::ios::binary) << probed;
    dom_ = run("--dump-dom --virtual-time-budget=20000", "probed.html");
    if (const char* keep = std::getenv("PACER_KEEP_PAGE")) {  // NOLINT(concurrency-mt-unsafe)
      fs::copy_file(folder_ / "page.html", keep, fs::copy_options::overwrite_existing);
    }
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  void SetUp() override {
    if (!find_browser()) {
      GTEST_SKIP() << "NO BROWSER FOUND (chromium, chromium-browser, google-chrome): that reports "
                      "open in one is NOT tested";
    }
    ASSERT_NE(dom_.find("data-probed=\"yes\""), std::string::npos) << "the page did not load";
  }

  static std::string run(const std::string& mode, const std::string& page) {
    const std::string command = fmt::format(
        "'{}' --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync "
        "--disable-dev-shm-usage --window-size=1280,1600 --user-data-dir='{}' {} 'file://{}' "
        "2>/dev/null",
        find_browser()->string(), (folder_ / "profile").string(), mode, (folder_ / page).string());
    std::FILE* pipe = popen(command.c_str(), "r");
    std::string out;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) out += static_cast<char>(c);
    const int status = pclose(pipe);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << command;
    return out;
  }

  static int occurrences(const std::string& pattern) {
    const std::regex expression(pattern);
    return static_cast<int>(
        std::distance(std::sregex_iterator(dom_.begin(), dom_.end(), expression), {}));
  }

  static inline fs::path folder_;
  static inline std::string dom_;
};

TEST_F(BrowserTest, EveryChartIsDrawn) {
  EXPECT_EQ(occurrences("<figure class=\"chart\" data-state=\"drawn\">"), kSampleCharts);
  EXPECT_EQ(occurrences("<svg [^>]*class=\"marks\""), kSampleCharts);
}

TEST_F(BrowserTest, NothingGoesWrong) {
  std::smatch found;
  EXPECT_FALSE(std::regex_search(dom_, found, std::regex("data-problems=\"([^\"]*)\"")))
      << found.str(1);
  EXPECT_EQ(dom_.find("data-state=\"failed\""), std::string::npos);
}

TEST_F(BrowserTest, VideosDecode) { EXPECT_EQ(occurrences("data-plays=\"yes\""), kSampleVideos); }

TEST_F(BrowserTest, ThePageFitsTheWindow) {
  EXPECT_NE(dom_.find("data-wide=\"false\""), std::string::npos);
}

TEST_F(BrowserTest, NothingComesFromElsewhere) {
  std::ifstream stream(folder_ / "page.html", std::ios::binary);
  const std::string page(std::istreambuf_iterator<char>(stream), {});
  for (const char* load :
       {"src=\"http", "src='http", "src=http", "href=\"http", "href='http", "href=http", "src=\"//",
        "href=\"//", "url(http", "@import", "<link", "<iframe", "<base"}) {
    EXPECT_EQ(page.find(load), std::string::npos) << load;
  }
}

TEST_F(BrowserTest, APictureOfItCanBeTaken) {
  const fs::path picture = folder_ / "page.png";
  (void)run(fmt::format("--virtual-time-budget=8000 --screenshot='{}'", picture.string()),
            "page.html");
  EXPECT_GT(fs::file_size(picture), 50'000U) << "an empty page makes a small picture";
}

}  // namespace
}  // namespace pacer::report
