// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/model.h"

#include <Eigen/LU>
#include <algorithm>

#include "learning/byte_stream.h"
#include "learning/config_text.h"

namespace pacer::exemplar {
namespace {

/// Whether pictures can be of this size, by far.
bool drawable(const ImageSize& size) {
  constexpr int kLongest = 16384;  // pixels
  constexpr int kNarrowest = 16;   // of one side over the other
  const auto [narrow, wide] = std::minmax(size.width, size.height);
  return narrow > 0 && wide <= kLongest && wide / narrow <= kNarrowest;
}

/// Whether its inverse weighs changes of actions: it is symmetric, and its eigenvalues are neither
/// near 0 nor beyond measure.
bool usable_drift(const Eigen::Matrix2d& drift) {
  constexpr double kMost = 1e6;  // stick^2; what was learnt lies between its floor and 4
  return drift.allFinite() && drift(0, 1) == drift(1, 0) && drift.trace() > 0.0 &&
         drift.trace() <= kMost && drift.determinant() >= drift.trace() / kMost;
}

std::string body(const Model& model) {
  ByteWriter out;
  ExemplarConfig config = model.config;
  ConfigTextWriter settings;
  config.fields(settings);
  out.text(settings.text());
  out.value(static_cast<std::int32_t>(model.image_size.width));
  out.value(static_cast<std::int32_t>(model.image_size.height));
  out.text(model.scenario);
  out.text(model.fingerprint);
  for (const double value : model.drift.reshaped()) out.value(value);
  const Exemplars& exemplars = model.hierarchy.exemplars();
  out.sequence(exemplars.percepts());
  out.sequence(exemplars.actions());
  return out.bytes();
}

Model read_body(std::string_view bytes) {
  ByteReader in(bytes);
  const std::string settings = in.text();
  ExemplarConfig config;
  config.fields(ConfigTextReader(settings));
  config.validate();
  ImageSize size;
  size.width = in.value<std::int32_t>();
  size.height = in.value<std::int32_t>();
  sane(drawable(size), "image size");
  std::string scenario = in.text();
  std::string fingerprint = in.text();
  Eigen::Matrix2d drift;
  for (double& value : drift.reshaped()) value = in.value<double>();
  sane(usable_drift(drift), "the actions' drift");
  std::vector<double> percepts = in.sequence<double>();
  std::vector<double> actions = in.sequence<double>();
  sane(in.rest().empty(), "something follows the exemplars");
  return {.config = config,
          .image_size = size,
          .scenario = std::move(scenario),
          .fingerprint = std::move(fingerprint),
          .drift = drift,
          .hierarchy = Hierarchy(
              Exemplars(kPerceptSize, kActionSize, std::move(percepts), std::move(actions)),
              config.hierarchy)};
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

}  // namespace pacer::exemplar
