// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "apps/progress.h"

namespace pacer {

/// Shows a run's progress on standard error: one bar (or block of lines) for each thing it does.
class TerminalProgress {
 public:
  /// What RunControl::progress calls; refers to this object.
  [[nodiscard]] std::function<void(std::uint64_t, std::uint64_t, std::string_view)> callback() {
    return [this](std::uint64_t done, std::uint64_t total, std::string_view what) {
      if (what != what_ || done < done_) begin(total, what);
      if (!shown_) return;  // this one is over
      shown_->expect(total);
      shown_->advance(done - done_);
      done_ = done;
      if (done == total) end();
    };
  }

  /// The last thing is done.
  void finish() {
    end();
    what_.clear();
  }

 private:
  void end() {
    if (shown_) shown_->finish();
    shown_.reset();
  }
  void begin(std::uint64_t total, std::string_view what) {
    end();
    what_ = what;
    done_ = 0;
    shown_.emplace(stderr, what_, total);
  }

  std::optional<Progress> shown_;
  std::string what_;
  std::uint64_t done_ = 0;
};

}  // namespace pacer
