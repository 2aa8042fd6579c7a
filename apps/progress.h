// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

#include "core/units.h"

namespace pacer {

/// How a Progress shows itself.
enum class ProgressStyle : std::uint8_t {
  kAuto,   ///< a bar where the stream is a terminal, else lines
  kBar,    ///< one line, drawn over at most ten times a second
  kLines,  ///< a line each tenth of the way and at least one a half minute: for logs
};

/// Tells a person how far a long job is: share, count, rate and time left.
///
///     Progress progress(stderr, "episodes", 50);
///     for (...) { ...; progress.advance(); }
///     progress.finish();
///
/// Any thread may call any method. Nothing is shown before the first call to `advance` or `note`,
/// and failures to write are ignored: progress never ends a job.
class Progress {
 public:
  using Clock = std::function<Seconds()>;

  /// `total` 0: not known, only counted. `out` is borrowed. `clock` never goes backwards; without
  /// one it is the steady clock.
  Progress(std::FILE* out, std::string label, std::uint64_t total,
           ProgressStyle style = ProgressStyle::kAuto, Clock clock = {});
  /// Ends the line where it is, as when an exception or Ctrl-C cuts the job short.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `count` more are done.
  void advance(std::uint64_t count = 1);
  /// `count` were done by an earlier run that is resumed now: they count, but not for the rate.
  void resume_from(std::uint64_t count);
  /// It is known better how many there are.
  void expect(std::uint64_t total);
  /// A line of its own, above the bar.
  void note(std::string_view line);
  /// Shows the end state and the time it took. Later calls change nothing.
  void finish();

 private:
  [[nodiscard]] std::string status(Seconds now) const;
  [[nodiscard]] std::string bar(Seconds now) const;
  void show(Seconds now, bool last);

  std::FILE* out_;
  const std::string label_;
  const bool on_terminal_;
  const Clock clock_;
  const Seconds start_;

  std::mutex mutex_;  // guards what follows, and the order of writes
  std::uint64_t total_;
  std::uint64_t done_ = 0;
  std::uint64_t resumed_ = 0;
  Seconds last_shown_;
  std::uint64_t tenths_shown_ = 0;
  bool bar_drawn_ = false;
  bool finished_ = false;
};

}  // namespace pacer
