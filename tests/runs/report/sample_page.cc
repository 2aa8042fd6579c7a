// SPDX-License-Identifier: Apache-2.0
#include "tests/runs/report/sample_page.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <stdexcept>
#include <vector>

#include "core/random.h"
#include "runs/report/charts.h"
#include "runs/report/draw.h"
#include "runs/report/page.h"
#include "runs/report/picture.h"

namespace pacer::report::testing {
namespace {

using Bytes = std::vector<std::uint8_t>;

const std::string kHostile = "</script><b>learned</b>'){datum}";

/// A corridor, a crate and its shadow: something to draw on.
Frame scene(double phase) {
  constexpr int kWidth = 320;
  constexpr int kHeight = 240;
  cv::Mat image(kHeight, kWidth, CV_8UC3, cv::Scalar(176, 168, 150));
  cv::rectangle(image, {0, 130}, {kWidth, kHeight}, cv::Scalar(128, 104, 78), cv::FILLED);
  for (int i = -8; i < 9; ++i) {
    cv::line(image, {160 + i * 14, 130}, {160 + i * 90, 240}, cv::Scalar(104, 82, 60), 1,
             cv::LINE_AA);
  }
  const int x = 140 + static_cast<int>(60.0 * std::sin(phase));
  cv::ellipse(image, {x + 22, 172}, {44, 9}, 0, 0, 360, cv::Scalar(70, 56, 44), cv::FILLED,
              cv::LINE_AA);
  cv::rectangle(image, {x, 118}, {x + 44, 168}, cv::Scalar(182, 52, 44), cv::FILLED);
  cv::rectangle(image, {x + 6, 126}, {x + 38, 142}, cv::Scalar(240, 236, 220), cv::FILLED);
  Frame frame{.size = {kWidth, kHeight}, .rgb = {}};
  frame.rgb.assign(image.datastart, image.dataend);
  return frame;
}

Annotations marks(double phase, Random& random) {
  const auto x = static_cast<float>(140.0 + 60.0 * std::sin(phase));
  Annotations out;
  for (int i = 0; i < 40; ++i) {
    const auto at = [&random](double low, double high) {
      return static_cast<float>(random.uniform(low, high));
    };
    const bool on_lead = i % 3 == 0;
    out.points.push_back({.at = on_lead ? PixelPoint{x + at(2, 42), at(120, 166)}
                                        : PixelPoint{at(0, 320), at(0, 240)},
                          .radius = at(1, 6),
                          .tone = on_lead ? Tone::kMatched : Tone::kIgnored});
  }
  out.boxes.push_back({.low = {x - 4, 114}, .high = {x + 48, 172}, .tone = Tone::kTarget});
  out.lines.push_back({.from = {160, 239}, .to = {x + 22, 143}, .tone = Tone::kNeutral});
  out.label = phase > 0.0 ? "fast-left, 12 rules" : "straight, 7 rules";
  return out;
}

Frame drawn(double phase, const std::string& caption, Random& random) {
  const double steering = -std::sin(phase);
  const Hud hud{.sent = {steering, 0.34},
                .wanted = Command{steering * 1.1, 0.4},
                .teacher = Command{steering * 0.8, 0.3},
                .caption = caption};
  Frame into;
  draw(scene(phase), marks(phase, random), hud, into);
  return into;
}

Bytes video(const std::filesystem::path& file, double phase, Random& random) {
  const ImageSize size = drawn_size({320, 240});
  cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('a', 'v', 'c', '1'),
                         25.0, {size.width, size.height});
  if (!writer.isOpened()) throw std::runtime_error("OpenCV has no H.264 encoder here");
  for (int i = 0; i < 50; ++i) {
    const double time = i / 25.0;
    const Frame frame =
        drawn(phase + time, fmt::format("learned, episode 3, {:.1f} s", time), random);
    cv::Mat rgb(size.height, size.width, CV_8UC3, const_cast<std::uint8_t*>(frame.rgb.data()));
    cv::Mat bgr;
    cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
    writer.write(bgr);
  }
  writer.release();
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<double> draws(Random& random, int count, double mean, double deviation) {
  std::vector<double> out(static_cast<std::size_t>(count));
  for (double& value : out) value = random.normal(mean, deviation);
  return out;
}

void add_scores(Page& page, const Palette& palette, Random& random) {
  const auto name = [&palette](const std::string& policy) {
    return Text::swatch(palette.colour(policy)) + Text(policy);
  };
  const std::vector<Tile> tiles = {
      {.label = "Episodes followed, learned",
       .value = "86 %",
       .detail = "74 to 93, 50 episodes",
       .verdict = Verdict::kHolds},
      {.label = "Of the teacher's",
       .value = "0.88",
       .detail = "claimed: at least 0.80",
       .verdict = Verdict::kHolds},
      {.label = "Response time, 99 %",
       .value = "43 ms",
       .detail = "claimed: under 40 ms",
       .verdict = Verdict::kShort},
      {.label = "Demonstration", .value = "5 min", .detail = "7,500 frames, 5 rooms"}};
  page.lead().tiles(tiles);
  const std::vector<Fact> facts = {{"Scenario", Text::code("following")},
                                   {"Seed", "42"},
                                   {"Rooms", "office (unseen)"},
                                   {"Version", "0.1.0"},
                                   {"Renderer", "llvmpipe"}};
  const Table table{
      .columns = {{.heading = "Policy"},
                  {.heading = "Followed",
                   .unit = "%",
                   .decimals = 0,
                   .scale = 100.0,
                   .better = Better::kHigher},
                  {.heading = "In view",
                   .unit = "% of time",
                   .decimals = 1,
                   .scale = 100.0,
                   .better = Better::kHigher},
                  {.heading = "Distance error", .unit = "m", .better = Better::kLower},
                  {.heading = "Collisions", .better = Better::kLower},
                  {.heading = "Response p99", .unit = "ms", .decimals = 1}},
      .rows = {{.cells = {name("teacher"), fraction(49, 50), mean(draws(random, 50, .98, .01)),
                          mean(draws(random, 50, .21, .05)), 0, std::nan("")},
                .competes = false},
               {.cells = {name("learned"), fraction(43, 50), mean(draws(random, 50, .93, .05)),
                          mean(draws(random, 50, .34, .12)), 2, 31.4}},
               {.cells = {name(kHostile), fraction(31, 50), mean(draws(random, 50, .81, .1)),
                          mean(draws(random, 50, .47, .2)), 5, 12.9}},
               {.cells = {name("mean"), fraction(0, 50), mean(draws(random, 50, .12, .05)),
                          mean(draws(random, 50, 2.4, .6)), 41, 0.0}},
               {.cells = {name("neutral"), fraction(0, 50), mean(draws(random, 50, .08, .03)),
                          mean(draws(random, 50, 4.1, .6)), 0, 0.0}}},
      .caption =
          "Means over episodes with 95 % intervals; arrows show which way is better. The "
          "teacher is the reference and does not compete."};
  const std::vector<Text> reading = {
      "Followed: 60 s without a collision, the lead never out of view for more than 2 s.",
      Text("The data behind it is in ") + Text::link("scores.json", "scores.json") +
          Text(", and the pictures are ") + Text::link("further down", "#pictures") + Text(".")};
  page.section("Scores")
      .facts(facts)
      .table(table)
      .list(reading)
      .note("43 ms is over the bound of 40 ms at the 99th percentile.", Verdict::kShort)
      .note("The teacher follows in 98 % of episodes: the task is sound.", Verdict::kHolds);
  page.section("Claims").table(
      {.columns = {{.heading = "Claim"},
                   {.heading = "Thesis", .decimals = 3},
                   {.heading = "Measured", .decimals = 3},
                   {.heading = "Verdict"}},
       .rows = {{.cells = {"p99 of the response, ms", 38.0, 43.0, Verdict::kShort}},
                {.cells = {"mean hit ratio", 0.87, 0.91, Verdict::kHolds}},
                {.cells = {"bench, real car", 0.87, Cell(), Verdict::kOpen}}}});
}

void add_charts(Page& page, const Palette& palette, Random& random) {
  Series teacher{.name = "teacher", .x = {}, .y = {}, .dashed = true};
  Series learned{.name = "learned", .x = {}, .y = {}};
  for (int i = 0; i < 750; ++i) {
    const double time = i / 25.0;
    const double value = 0.7 * std::sin(0.5 * time) + 0.2 * std::sin(1.7 * time);
    teacher.x.push_back(time);
    teacher.y.push_back(value);
    learned.x.push_back(time);
    learned.y.push_back(i > 400 && i < 430 ? std::nan("") : value + random.normal(0.0, 0.06));
  }
  const std::array signals = {teacher, learned};
  page.section("Action signals")
      .paragraph("What the policy asked for against what the teacher would have done.")
      .chart({line_chart(signals, {.title = "time", .unit = "s"},
                         {.title = "steering", .unit = "of full lock", .limits = Range{-1, 1}},
                         palette),
              "Steering in one unseen episode."});

  Series share{.name = "learned", .x = {}, .y = {}};
  for (int i = 1; i < 20; ++i) {
    share.x.push_back(15.0 * i);
    share.y.push_back(0.9 - 0.8 * std::exp(-0.2 * i));
    share.low.push_back(share.y.back() - 0.3 / std::sqrt(i));
    share.high.push_back(share.y.back() + 0.2 / std::sqrt(i));
  }
  const std::array<Series, 1> shares = {share};
  const std::array<double, 1> bound = {0.8};
  std::vector<Cloud> clouds;
  int group = 0;
  for (const char* one : {"fast-left", "left", "straight", "right", "fast-right", "stop"}) {
    const double middle = 0.35 * (group++ - 2);
    clouds.push_back({one, draws(random, 150, middle, 0.09), draws(random, 150, 0.4, 0.08)});
  }
  std::vector<std::string> classes;
  for (const Cloud& cloud : clouds) classes.push_back(cloud.name);
  const std::array<Sample, 4> errors = {Sample{"teacher", draws(random, 50, 0.2, 0.05)},
                                        Sample{"learned", draws(random, 50, 0.34, .1)},
                                        Sample{kHostile, draws(random, 50, 0.5, 0.2)},
                                        Sample{"mean", draws(random, 50, 1.4, 0.3)}};
  std::vector<Bar> bars;
  for (const char* type : {"left", "straight", "right"}) {
    bars.push_back({type, "learned", fraction(40 + random.below(10), 50)});
    bars.push_back({type, kHostile, fraction(30 + random.below(10), 50)});
    bars.push_back({type, "mean", fraction(random.below(10), 50)});
  }
  const std::array<Bar, 3> single = {Bar{"all", "teacher", fraction(49, 50)},
                                     Bar{"all", "learned", fraction(43, 50)},
                                     Bar{"all", "mean", fraction(1, 50)}};
  HeatMap confusion{.rows = classes, .columns = classes, .values = {}};
  for (std::size_t r = 0; r < 6; ++r) {
    for (std::size_t c = 0; c < 6; ++c) {
      confusion.values.push_back(
          r == 5 && c == 0 ? std::nan("") : (r == c ? 0.85 : 0.03) + 0.01 * static_cast<double>(c));
    }
  }
  const Axis metres{.title = "distance error", .unit = "m", .from_zero = true};
  const std::vector<Chart> charts = {
      {line_chart(shares, {.title = "demonstration", .unit = "s"},
                  {.title = "followed", .limits = Range{0, 1}}, palette, {}, bound),
       "With a 95 % band, and the bound as a dashed line."},
      {scatter_chart(clouds, {.title = "steering"}, {.title = "throttle"}, Palette(classes)),
       "Action clusters."},
      {distribution_chart(errors, metres, palette), "Each point is an episode."},
      {histogram(errors, metres, 24, palette, {.height_px = 200}), "The same as shares."},
      {bar_chart(bars, {.title = "hit ratio"}, palette),
       "Hits by action type, with 95 % intervals."},
      {bar_chart(single, {.title = "followed"}, palette), "One bar a policy."}};
  page.section("Charts").charts(charts).chart(
      {heat_map(confusion, "wanted", "done", "share"), "Which action was done for which."});
  Content inner;
  inner.paragraph("Drawn when opened.")
      .chart({line_chart(shares, {.title = "x"}, {.title = "y"}, palette), {}});
  inner.code("car: simulated\nseed: 42\n# </script><script>alert(1)</script>\nlead:\n  stops: 2\n");
  page.section("Scenario").details("The whole scenario, as it was run", inner);
}

void add_pictures(Page& page, const std::filesystem::path& scratch, Random& random) {
  Content& section = page.section("Pictures");
  const Bytes poster = encode_jpeg(drawn(0.5, "learned, episode 3, 0.0 s", random));
  const Bytes left = video(scratch / "left.mp4", 0.5, random);
  const Bytes right = video(scratch / "right.mp4", -1.5, random);
  const std::array<Video, 2> videos = {
      Video{.bytes = left, .caption = "Followed: learned, episode 3, 60 s.", .poster = poster},
      Video{.bytes = right, .caption = "Lost the lead: learned, episode 9."}};
  section.videos(videos);
  std::vector<Tiled> tiles;
  for (int i = 0; i < 8; ++i) {
    Frame picture;
    draw(scene(0.4 * i - 1.5), marks(0.4 * i - 1.5, random), picture, 1);
    tiles.push_back({.frame = picture, .caption = fmt::format("episode {}, {:.1f} s", i, 1.3 * i)});
  }
  const Bytes sheet = encode_png(contact_sheet(tiles, 4));
  section.figure({.bytes = sheet, .caption = "Mined configurations on frames, a contact sheet."});
}

}  // namespace

std::string sample_page(const std::filesystem::path& scratch) {
  Random random(2);
  const std::array<std::string, 3> names = {"learned", kHostile, "tracker"};
  const Palette palette(names);
  Page page("Following an unseen lead",
            "50 unseen episodes a policy, in a kind of room that no "
            "demonstration used");
  add_scores(page, palette, random);
  add_charts(page, palette, random);
  add_pictures(page, scratch, random);
  return page.html();
}

}  // namespace pacer::report::testing
