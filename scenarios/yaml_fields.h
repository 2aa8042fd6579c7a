// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/check.h"
#include "core/range.h"
#include "core/units.h"

namespace pacer {

/// Calls `visit(key, field)` for each field of `config`, which lists them in `fields(visitor)`.
/// A struct of structs is a tree; YamlReader, YamlWriter and FieldChecker below walk it.
template <class Config, class Visitor>
concept HasFields = requires(Config config, Visitor visit) {
  config.fields(visit);
};

/// Where each value that was given stands: its path, and "file:line" or "--set".
using Places = std::map<std::string, std::string, std::less<>>;

/// Reads one mapping into a config. Keys that are absent leave their field alone; a key that no
/// field claims, or a value of the wrong kind, is a UsageError "file:line: path: what is wrong".
class YamlReader {
 public:
  /// `source` is the file's name, or "--set"; `path` is the mapping's own, "" for the whole file.
  /// `places`, which must outlive it, learns where values stand.
  YamlReader(const YAML::Node& mapping, std::string source, std::string path, Places& places);

  template <class T>
  void operator()(const char* key, T& field) {
    known_.emplace(key);
    const YAML::Node node = mapping_[key];
    if (!node.IsDefined()) return;
    const std::string where = join(key);
    if constexpr (HasFields<T, YamlReader&>) {
      YamlReader nested(node, source_, where, places_);
      field.fields(nested);
      nested.finish();
    } else {
      read(node, where, field);
      places_[where] = place(node);
    }
  }

  /// Throws for the first key that no field claimed.
  void finish() const;

 private:
  [[nodiscard]] std::string place(const YAML::Node& node) const;
  [[nodiscard]] std::string join(std::string_view key) const;
  [[noreturn]] void fail(const YAML::Node& node, const std::string& where,
                         const std::string& what) const;
  void read(const YAML::Node& node, const std::string& where, bool& field) const;
  void read(const YAML::Node& node, const std::string& where, int& field) const;
  void read(const YAML::Node& node, const std::string& where, std::uint64_t& field) const;
  void read(const YAML::Node& node, const std::string& where, double& field) const;
  void read(const YAML::Node& node, const std::string& where, std::string& field) const;
  void read(const YAML::Node& node, const std::string& where, Seconds& field) const;
  void read(const YAML::Node& node, const std::string& where, Pulse& field) const;
  void read(const YAML::Node& node, const std::string& where, Range& field) const;
  void read(const YAML::Node& node, const std::string& where, std::vector<double>& field) const;
  void read(const YAML::Node& node, const std::string& where,
            std::vector<std::string>& field) const;

  YAML::Node mapping_;
  std::string source_;
  std::string path_;
  Places& places_;
  std::set<std::string, std::less<>> known_;
};

/// Writes every field, defaults included, as YAML that reads back to the same values.
class YamlWriter {
 public:
  explicit YamlWriter(YAML::Emitter& out) : out_(out) {}

  template <class T>
  void operator()(const char* key, T& field) {
    out_ << YAML::Key << key << YAML::Value;
    if constexpr (HasFields<T, YamlWriter&>) {
      out_ << YAML::BeginMap;
      field.fields(*this);
      out_ << YAML::EndMap;
    } else {
      write(field);
    }
  }

 private:
  void write(bool value);
  void write(int value);
  void write(std::uint64_t value);
  void write(double value);
  void write(const std::string& value);
  void write(const Seconds& value);
  void write(const Pulse& value);
  void write(const Range& value);
  void write(const std::vector<double>& value);
  void write(const std::vector<std::string>& value);

  YAML::Emitter& out_;
};

/// Calls `validate()` of every config in the tree, deepest first, and puts the value's place and
/// the config's path in front of what it throws: "follow.yaml:7: simulated.camera.frame_rate_hz:
/// must be positive", a UsageError.
class FieldChecker {
 public:
  /// `source` stands for the place of what was not given; `places` must outlive the checker.
  FieldChecker(std::string source, std::string path, const Places& places)
      : source_(std::move(source)), path_(std::move(path)), places_(places) {}

  template <class T>
  void operator()(const char* key, T& field) {
    if constexpr (HasFields<T, FieldChecker&>) {
      const FieldChecker nested(source_, path_.empty() ? key : path_ + "." + key, places_);
      nested.check_all(field);
    }
  }

  template <class T>
  void check_all(T& config) const {
    FieldChecker each(source_, path_, places_);
    config.fields(each);
    if constexpr (requires { config.validate(); }) {
      try {
        config.validate();
      } catch (const std::invalid_argument& error) {
        const std::string what = (path_.empty() ? "" : path_ + ".") + error.what();
        const auto given = places_.find(what.substr(0, what.find_first_of(":,")));
        throw UsageError((given == places_.end() ? source_ : given->second) + ": " + what);
      }
    }
  }

 private:
  std::string source_;
  std::string path_;
  const Places& places_;
};

}  // namespace pacer
