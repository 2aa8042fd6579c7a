// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/model.h"

#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "core/hash.h"
#include "core/output_file.h"
#include "learning/byte_stream.h"
#include "learning/config_text.h"

namespace pacer::affordance {
namespace {

constexpr std::string_view kMagic = "PACERAFF";

void sane(bool condition, const char* what) {
  if (!condition) throw std::runtime_error(what);
}

template <class Number>
void finite(std::span<const Number> values, const char* what) {
  for (const Number value : values) sane(std::isfinite(value), what);
}

void write_actions(const ActionClusters& actions, ByteWriter& out) {
  for (const double value : actions.mean) out.value(value);
  for (const double value : actions.whiten.reshaped()) out.value(value);
  out.value(static_cast<std::uint64_t>(actions.centres.size()));
  for (std::size_t c = 0; c < actions.centres.size(); ++c) {
    out.value(actions.centres[c].x());
    out.value(actions.centres[c].y());
    out.text(actions.names[c]);
  }
}

ActionClusters read_actions(ByteReader& in) {
  ActionClusters actions;
  for (double& value : actions.mean) value = in.value<double>();
  for (double& value : actions.whiten.reshaped()) value = in.value<double>();
  const std::size_t count = in.count(3 * sizeof(double));
  sane(count >= 1 && count <= 255, "action types");
  for (std::size_t c = 0; c < count; ++c) {
    const auto x = in.value<double>();
    const auto y = in.value<double>();
    actions.centres.emplace_back(x, y);
    actions.names.push_back(in.text());
    finite<double>(std::span<const double>(actions.centres.back().data(), 2), "action types");
  }
  sane(actions.mean.allFinite() && actions.whiten.allFinite(), "action whitening");
  return actions;
}

void write_rule(const Rule& rule, const Mapping& mapping, ByteWriter& out) {
  out.value(rule.type);
  out.value(rule.count);
  out.value(rule.holding);
  out.sequence(std::span<const Item>(rule.items));
  out.value(mapping.matches);
  for (const Command& command : {mapping.bias, mapping.residual}) {
    out.value(command.steering);
    out.value(command.throttle);
  }
  for (const Mapping::Input& input : mapping.inputs) {
    out.value(input.mean);
    out.value(input.inverse_sd);
    out.value(input.steering);
    out.value(input.throttle);
  }
}

void read_rule(ByteReader& in, const Model& model, Rule& rule, Mapping& mapping) {
  rule.type = in.value<ActionType>();
  sane(rule.type < model.actions.count(), "a rule's action type");
  rule.count = in.value<std::uint32_t>();
  rule.holding = in.value<std::uint32_t>();
  sane(rule.count > 0 && rule.count <= rule.holding, "a rule's support");
  rule.items = in.sequence<Item>();
  sane(!rule.items.empty() && rule.items.back() < model.frequency.size(), "a rule's items");
  for (std::size_t i = 1; i < rule.items.size(); ++i) {
    sane(rule.items[i - 1] < rule.items[i], "a rule's items");
  }
  mapping.matches = in.value<std::uint32_t>();
  for (Command* command : {&mapping.bias, &mapping.residual}) {
    command->steering = in.value<double>();
    command->throttle = in.value<double>();
    sane(std::isfinite(command->steering) && std::isfinite(command->throttle), "a mapping");
  }
  mapping.inputs.resize(rule.items.size() * kPoseSize);
  for (Mapping::Input& input : mapping.inputs) {
    for (float* value : {&input.mean, &input.inverse_sd, &input.steering, &input.throttle}) {
      *value = in.value<float>();
      sane(std::isfinite(*value), "a mapping");
    }
  }
}

std::string body(const Model& model) {
  ByteWriter out;
  AffordanceConfig config = model.config;
  ConfigTextWriter settings;
  config.fields(settings);
  out.text(settings.text());
  out.value(static_cast<std::int32_t>(model.image_size.width));
  out.value(static_cast<std::int32_t>(model.image_size.height));
  out.value(model.frame_rate_hz);
  out.text(model.scenario);
  out.text(model.fingerprint);
  write_actions(model.actions, out);
  out.sequence(model.vocabulary.descriptors());
  out.sequence(model.vocabulary.scales());
  out.sequence(model.vocabulary.orientations());
  out.sequence(std::span<const std::uint32_t>(model.frequency));
  out.value(model.typical_witnesses);
  out.value(static_cast<std::uint64_t>(model.rules.size()));
  for (std::size_t r = 0; r < model.rules.size(); ++r) {
    write_rule(model.rules[r], model.mappings[r], out);
  }
  return out.bytes();
}

Vocabulary read_vocabulary(ByteReader& in, const WordConfig& config) {
  std::vector<float> descriptors = in.sequence<float>();
  std::vector<float> scales = in.sequence<float>();
  std::vector<float> orientations = in.sequence<float>();
  const auto fits = [](std::size_t size, int unit, int most) {
    return size > 0 && size % static_cast<std::size_t>(unit) == 0 &&
           size <= static_cast<std::size_t>(unit) * static_cast<std::size_t>(most);
  };
  sane(fits(descriptors.size(), kDescriptorSize, config.descriptor), "descriptor words");
  sane(fits(scales.size(), 1, config.scale), "scale words");
  sane(fits(orientations.size(), 1, config.orientation), "orientation words");
  finite<float>(descriptors, "descriptor words");
  finite<float>(scales, "scale words");
  finite<float>(orientations, "orientation words");
  return {std::move(descriptors), std::move(scales), std::move(orientations)};
}

Model read_body(std::string_view bytes) {
  ByteReader in(bytes);
  Model model;
  const std::string settings = in.text();
  model.config.fields(ConfigTextReader(settings));
  model.config.validate();
  model.image_size.width = in.value<std::int32_t>();
  model.image_size.height = in.value<std::int32_t>();
  sane(model.image_size.width > 0 && model.image_size.height > 0, "image size");
  model.frame_rate_hz = in.value<double>();
  sane(std::isfinite(model.frame_rate_hz) && model.frame_rate_hz > 0.0, "frame rate");
  model.scenario = in.text();
  model.fingerprint = in.text();
  model.actions = read_actions(in);
  model.vocabulary = read_vocabulary(in, model.config.words);
  model.frequency = in.sequence<std::uint32_t>();
  sane(model.frequency.size() == static_cast<std::size_t>(ItemLayout(model.vocabulary).count()),
       "item frequencies");
  model.typical_witnesses = in.value<double>();
  constexpr std::size_t kLeastRuleSize = 64;
  const std::size_t rules = in.count(kLeastRuleSize);
  sane(model.typical_witnesses >= 0.0 && model.typical_witnesses <= static_cast<double>(rules),
       "the typical number of witnesses");
  model.rules.resize(rules);
  model.mappings.resize(rules);
  for (std::size_t r = 0; r < rules; ++r) read_rule(in, model, model.rules[r], model.mappings[r]);
  sane(in.rest().empty(), "something follows the rules");
  model.matcher = RuleMatcher(model.rules, model.frequency);
  return model;
}

/// What follows the version.
Model read_sealed(ByteReader& in) {
  const std::string_view rest = in.take(in.count(1));
  const auto sum = in.value<std::uint64_t>();
  sane(in.rest().empty(), "something follows its end");
  sane(sum == fnv1a(rest), "its checksum does not match");
  return read_body(rest);
}

}  // namespace

std::string to_bytes(const Model& model) {
  const std::string rest = body(model);
  ByteWriter out;
  for (const char letter : kMagic) out.value(letter);
  out.value(Model::kVersion);
  out.text(rest);
  out.value(fnv1a(rest));
  return out.bytes();
}

Model from_bytes(std::string_view bytes, std::string_view source) {
  const std::string file(source);
  if (!bytes.starts_with(kMagic)) {
    throw std::runtime_error(file + ": not an affordance model");
  }
  ByteReader in(bytes.substr(kMagic.size()));
  std::uint32_t version = 0;
  try {
    version = in.value<std::uint32_t>();
    if (version == Model::kVersion) return read_sealed(in);
  } catch (const std::exception& error) {
    throw std::runtime_error(file + ": a damaged affordance model: " + error.what() +
                             "; train it again");
  }
  throw std::runtime_error(file + ": a model of version " + std::to_string(version) +
                           ", and this program reads version " + std::to_string(Model::kVersion) +
                           "; train it again");
}

void save(const Model& model, const std::filesystem::path& path) {
  OutputFile file(path);
  file.write(to_bytes(model));
  file.keep();
}

Model load(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.is_open() || in.bad()) {
    throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(),
                            "cannot read the model " + path.string());
  }
  return from_bytes(bytes, path.string());
}

}  // namespace pacer::affordance
