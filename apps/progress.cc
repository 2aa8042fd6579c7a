// SPDX-License-Identifier: Apache-2.0
#include "apps/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

namespace pacer {
namespace {

constexpr Seconds kBarPeriod{0.1};
constexpr Seconds kLinePeriod{30.0};
constexpr Seconds kShortest{0.05};  // time that tells a rate

Seconds steady_now() { return std::chrono::steady_clock::now().time_since_epoch(); }

bool is_terminal(std::FILE* out) {
  const char* kind = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): nobody sets it
  const bool dumb = kind != nullptr && std::string_view(kind) == "dumb";
  return !dumb && isatty(fileno(out)) == 1;
}

std::size_t columns_of(std::FILE* out) {
  winsize size{};
  if (ioctl(fileno(out), TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

/// "7 s", "3:05", "1:02:03".
std::string duration(Seconds time) {
  const double seconds = std::clamp(std::round(time.count()), 0.0, 3.6e8);
  const auto whole = static_cast<long>(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

/// Three figures, as "12.3/s" or "4.5 s each" for what takes longer than a second.
std::string rate_text(double per_second) {
  if (per_second >= 100.0) return fmt::format("{:.0f}/s", per_second);
  if (per_second >= 1.0) return fmt::format("{:.1f}/s", per_second);
  return duration(Seconds{1.0 / per_second}) + " each";
}

}  // namespace

Progress::Progress(std::FILE* out, std::string label, std::uint64_t total, ProgressStyle style,
                   Clock clock)
    : out_(out),
      label_(std::move(label)),
      on_terminal_(style == ProgressStyle::kBar ||
                   (style == ProgressStyle::kAuto && is_terminal(out))),
      clock_(clock ? std::move(clock) : Clock(steady_now)),
      start_(clock_()),
      total_(total),
      last_shown_(start_) {}

Progress::~Progress() {
  const std::scoped_lock lock(mutex_);
  if (bar_drawn_ && !finished_) {
    std::fputc('\n', out_);
    std::fflush(out_);
  }
}

void Progress::advance(std::uint64_t count) {
  const std::scoped_lock lock(mutex_);
  if (finished_) return;
  done_ += count;
  const Seconds now = clock_();
  if (on_terminal_) {
    if (!bar_drawn_ || now - last_shown_ >= kBarPeriod) show(now, false);
    return;
  }
  const std::uint64_t tenths = total_ == 0 ? 0 : done_ * 10 / total_;
  const bool further = tenths > tenths_shown_ && done_ < total_;  // the end is `finish`'s to tell
  if (further || now - last_shown_ >= kLinePeriod) {
    tenths_shown_ = tenths;
    show(now, false);
  }
}

void Progress::resume_from(std::uint64_t count) {
  const std::scoped_lock lock(mutex_);
  if (finished_) return;
  done_ += count;
  resumed_ += count;
  if (total_ != 0) tenths_shown_ = done_ * 10 / total_;
}

void Progress::expect(std::uint64_t total) {
  const std::scoped_lock lock(mutex_);
  if (!finished_) total_ = total;
}

void Progress::note(std::string_view line) {
  const std::scoped_lock lock(mutex_);
  const bool over_bar = bar_drawn_ && !finished_;
  if (over_bar) std::fputs("\r\x1b[K", out_);
  std::fwrite(line.data(), 1, line.size(), out_);
  std::fputc('\n', out_);
  if (over_bar) show(clock_(), false);
  std::fflush(out_);
}

void Progress::finish() {
  const std::scoped_lock lock(mutex_);
  if (finished_) return;
  show(clock_(), true);
  finished_ = true;
}

std::string Progress::status(Seconds now) const {
  const Seconds elapsed = now - start_;
  const double fresh = static_cast<double>(done_ - resumed_);
  std::string text = total_ == 0 ? fmt::format("{}", done_) : fmt::format("{}/{}", done_, total_);
  if (fresh <= 0.0 || elapsed < kShortest) return text;
  const double rate = fresh / elapsed.count();
  text += "  " + rate_text(rate);
  if (total_ > done_) {
    text += "  " + duration(Seconds{static_cast<double>(total_ - done_) / rate}) + " left";
  }
  return text;
}

std::string Progress::bar(Seconds now) const {
  // Never as wide as the terminal: a full line would wrap and could not be drawn over.
  const std::size_t columns = std::max<std::size_t>(columns_of(out_), 20) - 1;
  const std::string tail = status(now);
  if (total_ == 0) return fmt::format("{}  {}", label_, tail).substr(0, columns);
  const double share = std::min(1.0, static_cast<double>(done_) / static_cast<double>(total_));
  const std::string head = fmt::format("{} {:3.0f} % ", label_, std::floor(100.0 * share));
  const std::size_t used = head.size() + tail.size() + 4;
  if (used + 5 > columns) return (head + tail).substr(0, columns);
  const std::size_t width = std::min<std::size_t>(columns - used, 30);
  const auto full = static_cast<std::size_t>(std::floor(share * static_cast<double>(width)));
  return head + "[" + std::string(full, '#') + std::string(width - full, '-') + "]  " + tail;
}

void Progress::show(Seconds now, bool last) {
  last_shown_ = now;
  const Seconds elapsed = now - start_;
  std::string text;
  if (on_terminal_) {
    text = "\r" +
           (last ? fmt::format("{}: {} in {}", label_, done_, duration(elapsed)) : bar(now)) +
           "\x1b[K" + (last ? "\n" : "");
    bar_drawn_ = true;
  } else if (last) {
    text = fmt::format("{}: {} in {}\n", label_, done_, duration(elapsed));
  } else {
    text = fmt::format("{}: {}\n", label_, status(now));
  }
  std::fputs(text.c_str(), out_);
  std::fflush(out_);
}

}  // namespace pacer
