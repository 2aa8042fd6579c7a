// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/bit_table.h"

#include <algorithm>
#include <bit>

namespace pacer::affordance {

void BitTable::reset(std::size_t rows, std::size_t columns) {
  rows_ = rows;
  columns_ = columns;
  stride_ = padded_rows(rows);
  bits_.assign(words() * stride_, 0);
}

void BitTable::copy_row(std::size_t row, std::vector<Word>& to) const {
  to.resize(words());
  for (std::size_t w = 0; w < to.size(); ++w) to[w] = word(row, w);
}

void BitTable::add_shared(std::span<const Word> mask, std::size_t first, std::size_t last,
                          std::size_t rows, std::vector<std::uint32_t>& counts) const {
  loops_->add_shared(mask.data() + first, bits_.data() + first * stride_, stride_, last - first,
                     padded_rows(rows), counts.data());
}

void BitTable::select_rows(const std::vector<std::uint32_t>& counts, std::uint32_t least,
                           std::size_t rows, std::vector<std::uint32_t>& to) const {
  const std::size_t padded = padded_rows(rows);
  if (to.size() < padded) to.resize(padded);
  to.resize(loops_->select(counts.data(), padded, least, to.data()));
  while (!to.empty() && to.back() >= rows) to.pop_back();  // counted along with the block
}

void BitTable::project(const BitTable& from, std::span<const std::uint32_t> rows,
                       std::span<const Word> mask) {
  std::size_t columns = 0;
  for (const Word word : mask) columns += static_cast<std::size_t>(std::popcount(word));
  reset(rows.size(), columns);
  std::size_t at = 0;
  for (std::size_t w = 0; w < mask.size(); ++w) {
    if (mask[w] == 0) continue;
    const Compression how(mask[w]);
    const int count = std::popcount(mask[w]);
    const int filled = static_cast<int>(at % 64);
    Word* const to = bits_.data() + at / 64 * stride_;
    Word* const next = filled + count > 64 ? to + stride_ : nullptr;
    loops_->append(how, from.bits_.data() + w * from.stride_, rows.data(), rows.size(), filled, to,
                   next);
    at += static_cast<std::size_t>(count);
  }
}

}  // namespace pacer::affordance
