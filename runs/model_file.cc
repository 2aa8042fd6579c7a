// SPDX-License-Identifier: Apache-2.0
#include "runs/model_file.h"

#include <array>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace pacer {

AnyModel load_model(const std::filesystem::path& file) {
  std::array<char, exemplar::Model::kMagic.size()> first{};
  std::ifstream(file, std::ios::binary).read(first.data(), first.size());
  if (std::string_view(first.data(), first.size()) == exemplar::Model::kMagic) {
    return std::make_shared<const exemplar::Model>(exemplar::load(file));
  }
  if (!std::string_view(first.data(), first.size()).starts_with("PACER")) {
    throw std::runtime_error(file.string() + ": not a model; `pacer train` makes one");
  }
  return std::make_shared<const affordance::Model>(affordance::load(file));
}

}  // namespace pacer
