// SPDX-License-Identifier: Apache-2.0
#include "scenarios/yaml_fields.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace pacer {
namespace {

/// Parses the whole of `text`; false when it is anything else than one number of this type.
template <class T>
bool parse(std::string_view text, T& value) {
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stopped == end;
}

/// The shortest decimal that reads back to the same double.
std::string shortest(double value) { return fmt::format("{}", value); }

constexpr double kLargest = 1e9;  // no quantity of a scenario is beyond it

}  // namespace

YamlReader::YamlReader(const YAML::Node& mapping, std::string source, std::string path,
                       Places& places)
    : mapping_(mapping), source_(std::move(source)), path_(std::move(path)), places_(places) {
  if (!mapping_.IsMap())
    fail(mapping_, path_.empty() ? "file" : path_, "expected `key: value` pairs");
}

void YamlReader::finish() const {
  std::set<std::string> met;
  for (const auto& entry : mapping_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "?";
    if (!met.insert(key).second) fail(entry.first, join(key), "is given twice; keep one of them");
    if (known_.contains(key)) continue;
    std::string names;
    for (const std::string& name : known_) names += (names.empty() ? "" : ", ") + name;
    fail(entry.first, join(key), "unknown key; the keys here are " + names);
  }
}

std::string YamlReader::join(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

std::string YamlReader::place(const YAML::Node& node) const {
  const YAML::Mark mark = node.Mark();
  if (mark.is_null() || source_ == "--set") return source_;
  return fmt::format("{}:{}", source_, mark.line + 1);
}

void YamlReader::fail(const YAML::Node& node, const std::string& where,
                      const std::string& what) const {
  throw UsageError(fmt::format("{}: {}: {}", place(node), where, what));
}

void YamlReader::read(const YAML::Node& node, const std::string& where, bool& field) const {
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  if (text != "true" && text != "false") fail(node, where, "expected true or false");
  field = text == "true";
}

void YamlReader::read(const YAML::Node& node, const std::string& where, int& field) const {
  if (!node.IsScalar() || !parse(node.Scalar(), field)) {
    fail(node, where, "expected a whole number");
  }
}

void YamlReader::read(const YAML::Node& node, const std::string& where,
                      std::uint64_t& field) const {
  if (!node.IsScalar() || !parse(node.Scalar(), field)) {
    fail(node, where, "expected a whole number, 0 or more");
  }
}

void YamlReader::read(const YAML::Node& node, const std::string& where, double& field) const {
  double value = 0.0;
  if (!node.IsScalar() || !parse(node.Scalar(), value) || !(std::abs(value) <= kLargest)) {
    fail(node, where, "expected a number, a billion at most");
  }
  field = value;
}

void YamlReader::read(const YAML::Node& node, const std::string& where, std::string& field) const {
  if (!node.IsScalar()) fail(node, where, "expected text");
  field = node.Scalar();
}

void YamlReader::read(const YAML::Node& node, const std::string& where, Seconds& field) const {
  double value = 0.0;
  read(node, where, value);
  field = Seconds{value};
}

void YamlReader::read(const YAML::Node& node, const std::string& where, Pulse& field) const {
  double value = 0.0;
  read(node, where, value);
  if (std::abs(value) > 1e5) fail(node, where, "expected microseconds, such as 1500");
  field = Pulse{static_cast<std::int32_t>(std::lround(value * 4.0))};
}

void YamlReader::read(const YAML::Node& node, const std::string& where, Range& field) const {
  if (node.IsScalar()) {
    read(node, where, field.low);
    field.high = field.low;
    return;
  }
  if (!node.IsSequence() || node.size() != 2)
    fail(node, where, "expected [low, high], or a number");
  read(node[0], where, field.low);
  read(node[1], where, field.high);
}

void YamlReader::read(const YAML::Node& node, const std::string& where,
                      std::vector<double>& field) const {
  if (!node.IsSequence()) fail(node, where, "expected a list of numbers");
  field.clear();
  for (const auto& element : node) read(element, where, field.emplace_back());
}

void YamlReader::read(const YAML::Node& node, const std::string& where,
                      std::vector<std::string>& field) const {
  if (!node.IsSequence()) fail(node, where, "expected a list, such as [one, two]");
  field.clear();
  for (const auto& element : node) read(element, where, field.emplace_back());
}

void YamlWriter::write(bool value) { out_ << (value ? "true" : "false"); }
void YamlWriter::write(int value) { out_ << value; }
void YamlWriter::write(std::uint64_t value) { out_ << std::to_string(value); }
void YamlWriter::write(double value) { out_ << shortest(value); }
void YamlWriter::write(const std::string& value) { out_ << YAML::DoubleQuoted << value; }
void YamlWriter::write(const Seconds& value) { write(value.count()); }
void YamlWriter::write(const Pulse& value) { write(microseconds(value)); }

void YamlWriter::write(const Range& value) {
  out_ << YAML::Flow << YAML::BeginSeq << shortest(value.low) << shortest(value.high)
       << YAML::EndSeq;
}

void YamlWriter::write(const std::vector<double>& value) {
  out_ << YAML::Flow << YAML::BeginSeq;
  for (const double element : value) out_ << shortest(element);
  out_ << YAML::EndSeq;
}

void YamlWriter::write(const std::vector<std::string>& value) {
  out_ << YAML::Flow << YAML::BeginSeq;
  for (const std::string& element : value) out_ << YAML::DoubleQuoted << element;
  out_ << YAML::EndSeq;
}

}  // namespace pacer
