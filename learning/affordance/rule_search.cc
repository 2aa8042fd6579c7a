// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/rule_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pacer::affordance {
namespace {

constexpr std::uint32_t kNone = ~0U;
// A percent and what is counted by it come from decimals or quotients, whose doubles are off by a
// few parts in 10^16: that must not cost or give a transaction.
constexpr double kSlack = 1e-12;

}  // namespace

Thresholds::Thresholds(const AprioriConfig& config, std::size_t transactions)
    : confidence(config.confidence_percent / 100.0),
      min_items(static_cast<std::size_t>(config.min_items - 1)),
      max_items(static_cast<std::size_t>(config.max_items - 1)),
      min_stretches(static_cast<std::uint32_t>(config.min_stretches)),
      grow_confident(config.grow_confident) {
  const double wanted = config.support_percent / 100.0 * static_cast<double>(transactions);
  min_count = static_cast<std::uint32_t>(std::max(std::ceil(wanted * (1.0 - kSlack)), 1.0));
}

std::uint32_t Thresholds::others_allowed(std::uint32_t count) const noexcept {
  // count / (count + others) >= confidence
  constexpr double kMost = std::numeric_limits<std::uint32_t>::max();
  const double holding = std::floor(count / confidence * (1.0 + kSlack));
  return static_cast<std::uint32_t>(std::min(holding, kMost)) - count;
}

double support_percent_of(std::uint32_t count, std::size_t transactions) noexcept {
  return std::min(100.0 * count / static_cast<double>(transactions), 100.0);
}

RuleSearch::RuleSearch(const TransactionIndex& index, const Thresholds& thresholds, ActionType type,
                       std::stop_token stop, const KnownRules* known)
    : index_(index),
      limits_(thresholds),
      type_(type),
      stop_(std::move(stop)),
      known_(known),
      own_(index.ranks()),
      nodes_(std::min(thresholds.max_items, index.ranks()) + 1),
      row_of_(index.ranks()),
      in_prefix_(index.ranks()) {
  nodes_[0].ranks.resize(index.ranks());
  std::iota(nodes_[0].ranks.begin(), nodes_[0].ranks.end(), 0U);
}

void RuleSearch::run(const Found& found) {
  found_ = &found;
  own_.clear();
  for (std::uint32_t rank = 0; rank < index_.ranks() && !stop_.stop_requested(); ++rank) {
    grow_item(rank);
  }
}

void RuleSearch::run(std::uint32_t rank, std::uint32_t min_count, const Found& found) {
  found_ = &found;
  own_.clear();
  limits_.min_count = std::max(limits_.min_count, min_count);
  grow_item(rank);
}

// The first item of a prefix: the transactions that hold it are lists yet, not bits.
void RuleSearch::grow_item(std::uint32_t rank) {
  const TransactionIndex::Holders holders = index_.holders(rank, type_);
  const auto count = static_cast<std::uint32_t>(holders.own.size());
  Node& root = nodes_[0];
  if (count < limits_.min_count || !keep_frequent_pairs(rank, holders.own)) return;
  prefix_.clear();
  if (limits_.min_items <= 1) {
    const auto others = static_cast<std::uint32_t>(holders.others());
    if (others <= limits_.others_allowed(count)) {
      report(rank, count, others);
      if (!limits_.grow_confident) return;
    }
  }
  if (limits_.max_items < 2 || root.kept.empty()) return;

  prefix_.push_back(rank);
  in_prefix_[rank] = 1;
  if (limits_.min_items <= 2) {
    count_others_of_pairs(rank);
    report(root);
  }
  if (limits_.max_items > 2 && root.kept.size() >= 2) {
    Node& node = nodes_[1];
    node.ranks = root.kept;
    node.others_ready = false;
    std::fill(row_of_.begin(), row_of_.end(), kNone);
    for (std::uint32_t row = 0; row < node.ranks.size(); ++row) row_of_[node.ranks[row]] = row;
    node.own.reset(node.ranks.size(), holders.own.size());
    set_bits(holders.own, 0, node.own);
    node.stretches.clear();
    if (limits_.min_stretches > 1) {
      for (const std::uint32_t t : holders.own) node.stretches.push_back(index_.stretch(t));
    }
    grow(1);
  }
  in_prefix_[rank] = 0;
}

// Whether the item is in enough stretches; if so, which more frequent items stay frequent with it.
bool RuleSearch::keep_frequent_pairs(std::uint32_t rank, std::span<const std::uint32_t> own) {
  Node& root = nodes_[0];
  root.own_counts.assign(rank, 0);
  stretch_counts_.assign(rank + std::size_t{1}, 0);
  if (limits_.min_stretches <= 1) {
    add_pairs(rank, own, root.own_counts);
  } else {
    std::vector<std::uint32_t> last(rank + std::size_t{1}, kNone);  // the last holder of each
    const auto add_stretch = [&](std::size_t item, std::uint32_t t) {
      if (last[item] == kNone || index_.stretch(last[item]) != index_.stretch(t)) {
        ++stretch_counts_[item];
      }
      last[item] = t;
    };
    for (const std::uint32_t t : own) {
      for (const Item other : index_.transaction(t)) {
        add_stretch(other, t);
        if (other == rank) break;
        ++root.own_counts[other];
      }
    }
    if (stretch_counts_[rank] < limits_.min_stretches) return false;
  }
  root.kept.clear();
  for (std::uint32_t other = 0; other < rank; ++other) {
    if (root.own_counts[other] >= limits_.min_count && !explained(other) &&
        (limits_.min_stretches <= 1 || stretch_counts_[other] >= limits_.min_stretches)) {
      root.kept.push_back(other);
    }
  }
  return true;
}

// Calls `visit` with each of `transactions` and its items.
template <class Visit>
void RuleSearch::each_transaction(std::span<const std::uint32_t> transactions,
                                  Visit&& visit) const {
  constexpr std::size_t kAhead = 12;  // they lie far apart: this many are fetched ahead
  for (std::size_t i = 0; i < transactions.size(); ++i) {
    if (i + kAhead < transactions.size()) {
      __builtin_prefetch(index_.transaction(transactions[i + kAhead]).data());
    }
    visit(i, index_.transaction(transactions[i]).data());
  }
}

// Counts the items before `rank` in `transactions`, all of which hold it.
void RuleSearch::add_pairs(std::uint32_t rank, std::span<const std::uint32_t> transactions,
                           Ranks& counts) const {
  each_transaction(transactions, [&](std::size_t, const Item* items) {
    for (; *items < rank; ++items) ++counts[*items];
  });
}

// Sets the columns from `column` of `table` for `transactions`, all of which hold prefix_.front().
void RuleSearch::set_bits(std::span<const std::uint32_t> transactions, std::size_t column,
                          BitTable& table) const {
  each_transaction(transactions, [&](std::size_t i, const Item* items) {
    for (; *items < prefix_.front(); ++items) {
      if (row_of_[*items] != kNone) table.set(row_of_[*items], column + i);
    }
  });
}

void RuleSearch::count_others_of_pairs(std::uint32_t rank) {
  Node& root = nodes_[0];
  root.other_counts.assign(rank, 0);
  const auto certain = [&] {
    return std::all_of(root.kept.begin(), root.kept.end(), [&](std::uint32_t other) {
      return root.other_counts[other] > limits_.others_allowed(root.own_counts[other]);
    });
  };
  const TransactionIndex::Holders holders = index_.holders(rank, type_);
  for (std::span<const std::uint32_t> part : {holders.before, holders.after}) {
    for (std::size_t step = 64; !part.empty(); step *= 2) {
      const std::size_t size = std::min(step, part.size());
      add_pairs(rank, part.first(size), root.other_counts);
      if (certain()) return;
      part = part.subspan(size);
    }
  }
}

void RuleSearch::grow(std::size_t depth) {
  Node& node = nodes_[depth];
  const std::size_t size = depth + 2;  // of prefix, row and another row
  for (std::size_t row = 1; row < node.ranks.size(); ++row) {
    if (stop_.stop_requested()) return;
    keep_frequent(node, row);
    if (node.kept.empty()) continue;
    const std::uint32_t rank = node.ranks[row];
    if (!limits_.grow_confident) keep_unexplained(node, rank);
    prefix_.push_back(rank);
    in_prefix_[rank] = 1;
    if (size >= limits_.min_items && !node.kept.empty()) {
      count_others(depth, row, !limits_.grow_confident && size > limits_.min_items);
      report(node);
    }
    if (size < limits_.max_items && node.kept.size() >= 2) {
      Node& child = nodes_[depth + 1];
      child.grown = row;
      child.parent_rows = node.kept;
      child.ranks.clear();
      for (const std::uint32_t kept : node.kept) child.ranks.push_back(node.ranks[kept]);
      child.own.project(node.own, node.kept, node.own_mask);
      child.others_ready = false;
      child.stretches.clear();
      for (std::size_t column = 0; column < node.stretches.size(); ++column) {
        if ((node.own_mask[column / 64] >> (column % 64) & 1) != 0) {
          child.stretches.push_back(node.stretches[column]);
        }
      }
      grow(depth + 1);
    }
    in_prefix_[rank] = 0;
    prefix_.pop_back();
  }
}

void RuleSearch::keep_frequent(Node& node, std::size_t row) {
  node.own.copy_row(row, node.own_mask);
  node.own_counts.assign(padded_rows(row), 0);
  node.own.add_shared(node.own_mask, 0, node.own.words(), row, node.own_counts);
  node.own.select_rows(node.own_counts, limits_.min_count, row, node.kept);
  if (limits_.min_stretches > 1) {
    std::erase_if(node.kept, [&](std::uint32_t other) { return !enough_stretches(node, other); });
  }
}

bool RuleSearch::enough_stretches(const Node& node, std::size_t row) const {
  std::uint32_t stretches = 0;
  std::uint32_t last = 0;
  for (std::size_t w = 0; w < node.own_mask.size(); ++w) {
    for (BitTable::Word left = node.own_mask[w] & node.own.word(row, w); left != 0;
         left &= left - 1) {
      const std::uint32_t stretch =
          node.stretches[w * 64 + static_cast<std::size_t>(std::countr_zero(left))];
      if (stretches != 0 && stretch == last) continue;
      last = stretch;
      if (++stretches == limits_.min_stretches) return true;
    }
  }
  return false;
}

// Drops what, with the prefix and `rank`, holds a rule that is not grown.
void RuleSearch::keep_unexplained(Node& node, std::uint32_t rank) {
  std::erase_if(node.kept, [&](std::uint32_t row) { return explained(rank, node.ranks[row]); });
}

bool RuleSearch::explained(std::uint32_t rank) const {
  return own_.alone(rank) || (known_ != nullptr && known_->alone(rank));
}

bool RuleSearch::explained(std::uint32_t previous, std::uint32_t last) const {
  return own_.end_in(previous, last, in_prefix_) ||
         (known_ != nullptr && known_->end_in(previous, last, in_prefix_));
}

// Counts the other types' transactions of each kept set, until it is certain that there are too
// many. With `drop_useless`, drops the rows that exclude none of those that hold the prefix: any
// set that they are in is as confident without them.
void RuleSearch::count_others(std::size_t depth, std::size_t row, bool drop_useless) {
  need_others(depth);
  Node& node = nodes_[depth];
  node.others.copy_row(row, node.others_mask);
  node.other_counts.assign(padded_rows(row), 0);
  std::uint32_t seen = 0;
  const std::size_t words = node.others_mask.size();
  std::size_t step = 4;
  for (std::size_t first = 0; first < words; step *= 2) {
    const std::size_t last = std::min(first + step, words);
    node.others.add_shared(node.others_mask, first, last, row, node.other_counts);
    for (; first < last; ++first) {
      seen += static_cast<std::uint32_t>(std::popcount(node.others_mask[first]));
    }
    const bool certain = std::all_of(node.kept.begin(), node.kept.end(), [&](std::uint32_t other) {
      return node.other_counts[other] > limits_.others_allowed(node.own_counts[other]) &&
             (!drop_useless || node.other_counts[other] < seen);
    });
    if (certain) return;
  }
  if (drop_useless) {
    std::erase_if(node.kept, [&](std::uint32_t other) { return node.other_counts[other] == seen; });
  }
}

void RuleSearch::need_others(std::size_t depth) {
  Node& node = nodes_[depth];
  if (node.others_ready) return;
  node.others_ready = true;
  if (depth > 1) {
    need_others(depth - 1);
    Node& parent = nodes_[depth - 1];
    parent.others.copy_row(node.grown, parent.others_mask);
    node.others.project(parent.others, node.parent_rows, parent.others_mask);
    return;
  }
  const TransactionIndex::Holders holders = index_.holders(prefix_.front(), type_);
  node.others.reset(node.ranks.size(), holders.others());
  set_bits(holders.before, 0, node.others);
  set_bits(holders.after, holders.before.size(), node.others);
}

// Reports the rules among `kept`; drops them if rules are not to be grown.
void RuleSearch::report(Node& node) {
  std::erase_if(node.kept, [&](std::uint32_t row) {
    const std::uint32_t count = node.own_counts[row];
    if (count < limits_.min_count) return true;  // raised since
    const std::uint32_t others = node.other_counts[row];
    if (others > limits_.others_allowed(count)) return false;
    report(node.ranks[row], count, others);
    return !limits_.grow_confident;
  });
}

// Reports the prefix with `rank`.
void RuleSearch::report(std::uint32_t rank, std::uint32_t count, std::uint32_t others) {
  rule_ = prefix_;
  rule_.push_back(rank);
  limits_.min_count = std::max(limits_.min_count, (*found_)(rule_, count, count + others));
  if (!limits_.grow_confident) own_.add(rule_);
}

}  // namespace pacer::affordance
