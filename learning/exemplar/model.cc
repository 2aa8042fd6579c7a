// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/model.h"

#include <Eigen/LU>

#include "learning/byte_stream.h"
#include "learning/config_text.h"

namespace pacer::exemplar {
namespace {

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
  sane(size.width > 0 && size.height > 0, "image size");
  std::string scenario = in.text();
  std::string fingerprint = in.text();
  Eigen::Matrix2d drift;
  for (double& value : drift.reshaped()) value = in.value<double>();
  sane(drift.allFinite() && drift.determinant() > 0.0 && drift.trace() > 0.0, "the actions' drift");
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
