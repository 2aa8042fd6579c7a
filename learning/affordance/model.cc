// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/model.h"

#include <Eigen/LU>
#include <cmath>

#include "learning/byte_stream.h"
#include "learning/config_text.h"

namespace pacer::affordance {
namespace {

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
  sane(std::abs(actions.whiten.determinant()) > 1e-6, "action whitening");  // it is inverted
  return actions;
}

void write_rule(const Rule& rule, const Mapping& mapping, ByteWriter& out) {
  out.value(rule.type);
  out.value(rule.count);
  out.value(rule.holding);
  out.sequence(std::span<const Item>(rule.items));
  out.value(mapping.matches);
  for (const Command& command : {mapping.bias, mapping.held_out}) {
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
  for (Command* command : {&mapping.bias, &mapping.held_out}) {
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
  out.value(model.frames_learnt);
  out.value(model.frames_matched);
  write_actions(model.actions, out);
  for (const DescriptorWords& kind : model.vocabulary.kinds()) {
    if (kind.binary()) {
      out.sequence(kind.bits());
    } else {
      out.sequence(kind.centres());
    }
  }
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

/// Whether a codebook of `size` numbers, `unit` a word, has a word and not too many.
bool fits(std::size_t size, int unit, int most) {
  return size > 0 && size % static_cast<std::size_t>(unit) == 0 &&
         size <= static_cast<std::size_t>(unit) * static_cast<std::size_t>(most);
}

DescriptorWords read_descriptor_words(ByteReader& in, const std::string& kind, int most) {
  if (is_binary(*feature_kind(kind))) {
    std::vector<std::uint8_t> bits = in.sequence<std::uint8_t>();
    sane(fits(bits.size(), kDescriptorSize, most), "descriptor words");
    return DescriptorWords(std::move(bits));
  }
  std::vector<float> centres = in.sequence<float>();
  sane(fits(centres.size(), kDescriptorSize, most), "descriptor words");
  finite<float>(centres, "descriptor words");
  return DescriptorWords(std::move(centres));
}

/// `config` is valid.
Vocabulary read_vocabulary(ByteReader& in, const AffordanceConfig& config) {
  std::vector<DescriptorWords> kinds;
  for (const std::string& kind : config.features.kinds) {
    kinds.push_back(read_descriptor_words(in, kind, config.words.descriptor));
  }
  std::vector<float> scales = in.sequence<float>();
  std::vector<float> orientations = in.sequence<float>();
  sane(fits(scales.size(), 1, config.words.scale), "scale words");
  sane(fits(orientations.size(), 1, config.words.orientation), "orientation words");
  finite<float>(scales, "scale words");
  finite<float>(orientations, "orientation words");
  return {std::move(kinds), std::move(scales), std::move(orientations)};
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
  model.frames_learnt = in.value<std::uint64_t>();
  model.frames_matched = in.value<std::uint64_t>();
  sane(model.frames_matched <= model.frames_learnt, "matched pictures");
  model.actions = read_actions(in);
  model.vocabulary = read_vocabulary(in, model.config);
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

}  // namespace

std::string to_bytes(const Model& model) { return sealed(Model::kFile, body(model)); }

Model from_bytes(std::string_view bytes, std::string_view source) {
  return unsealed(Model::kFile, bytes, source, read_body);
}

void save(const Model& model, const std::filesystem::path& path) {
  write_model_file(to_bytes(model), path);
}

Model load(const std::filesystem::path& path) {
  return from_bytes(read_model_file(path), path.string());
}

}  // namespace pacer::affordance
