// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/exemplars.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/check.h"

namespace pacer::exemplar {
namespace {

bool usable(double value) { return std::abs(value) <= kGreatest; }  // NaN is not

void require_usable(std::span<const double> values, std::size_t width, const std::string& what,
                    std::size_t first) {
  const auto bad = std::ranges::find_if_not(values, usable);
  if (bad == values.end()) return;
  const auto place = static_cast<std::size_t>(bad - values.begin());
  throw std::invalid_argument("exemplar " + std::to_string(first + place / width) + ": " + what +
                              " " + std::to_string(place % width) +
                              " is no number, or one beyond 1e100");
}

}  // namespace

Exemplars::Exemplars(std::size_t percept_size, std::size_t action_size,
                     std::vector<double> percepts, std::vector<double> actions)
    : percept_size_(percept_size),
      action_size_(action_size),
      percepts_(std::move(percepts)),
      actions_(std::move(actions)) {
  require(percept_size_ > 0, "exemplars: a percept needs at least one number");
  require(action_size_ > 0, "exemplars: an action needs at least one number");
  require(percepts_.size() % percept_size_ == 0, "exemplars: " + std::to_string(percepts_.size()) +
                                                     " numbers are no whole percepts of " +
                                                     std::to_string(percept_size_));
  require(actions_.size() % action_size_ == 0, "exemplars: " + std::to_string(actions_.size()) +
                                                   " numbers are no whole actions of " +
                                                   std::to_string(action_size_));
  const std::size_t percepts_given = percepts_.size() / percept_size_;
  require(percepts_given == size(), "exemplars: " + std::to_string(percepts_given) +
                                        " percepts but " + std::to_string(size()) + " actions");
  require(size() > 0, "exemplars: none given, and at least one is needed");
  require_usable(percepts_, percept_size_, "percept value", 0);
  require_usable(actions_, action_size_, "action value", 0);
}

void Exemplars::add(std::span<const double> percept, std::span<const double> action) {
  require_percept(percept, percept_size_);
  require(action.size() == action_size_, "an action of " + std::to_string(action.size()) +
                                             " numbers, where the exemplars' have " +
                                             std::to_string(action_size_));
  require_usable(action, action_size_, "action value", size());
  percepts_.insert(percepts_.end(), percept.begin(), percept.end());
  actions_.insert(actions_.end(), action.begin(), action.end());
}

Exemplars Exemplars::subset(std::span<const std::size_t> which) const {
  std::vector<double> percepts;
  std::vector<double> actions;
  percepts.reserve(which.size() * percept_size_);
  actions.reserve(which.size() * action_size_);
  for (const std::size_t n : which) {
    percepts.insert(percepts.end(), percept(n).begin(), percept(n).end());
    actions.insert(actions.end(), action(n).begin(), action(n).end());
  }
  return {percept_size_, action_size_, std::move(percepts), std::move(actions)};
}

void require_percept(std::span<const double> percept, std::size_t size) {
  require(percept.size() == size, "a percept of " + std::to_string(percept.size()) +
                                      " numbers, where the exemplars' have " +
                                      std::to_string(size));
  const auto bad = std::ranges::find_if_not(percept, usable);
  require(bad == percept.end(), "a percept's value " + std::to_string(bad - percept.begin()) +
                                    " is no number, or one beyond 1e100");
}

}  // namespace pacer::exemplar
