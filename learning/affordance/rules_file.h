// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string_view>

#include "learning/affordance/apriori.h"
#include "learning/affordance/transaction.h"

namespace pacer::affordance {

/// Transactions as text, one a line: `TYPE ITEM ITEM ...`, decimal numbers between blanks, TYPE at
/// most 255, ITEM at most 65535. Items may come in any order and more than once; blank lines are
/// passed over; a line of a type alone is a transaction without items. Each transaction is a
/// stretch of its own. item_count and type_count are one more than the largest number found.
///
/// The file need not be ours: what is wrong with it throws UsageError with `FILE:LINE`. Takes
/// memory in proportion to the file, and never holds the text.
[[nodiscard]] TransactionDatabase read_transactions(const std::filesystem::path& file);
/// The same from a stream; `name` is what errors call it.
[[nodiscard]] TransactionDatabase read_transactions(std::istream& in, std::string_view name);

/// Rules as text, one a line: `TYPE ITEM ... COUNT CONFIDENCE`, sorted by type, then by items as
/// numbers. COUNT is the transactions that hold the items and the type; CONFIDENCE a fraction of
/// one, rounded to six decimals. The file appears whole or not at all. Throws std::runtime_error
/// with the file's name if it cannot be written.
void write_rules(const std::filesystem::path& file, std::span<const Rule> rules);
void write_rules(std::ostream& out, std::span<const Rule> rules);

}  // namespace pacer::affordance
