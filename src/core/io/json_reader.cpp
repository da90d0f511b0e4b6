#include "io/json_reader.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/error.h"
#include "io/files.h"

namespace gnathion {

using nlohmann::json;

struct JsonReader::Implementation {
  std::string file;
  std::string path;  ///< of this object, with a trailing dot; empty for the root
  json value;
  std::set<std::string> asked;

  const json* find(const std::string& key) {
    asked.insert(key);
    const auto place = value.find(key);
    return place == value.end() ? nullptr : &*place;
  }
};

namespace {

/// Refuses an object with the same key twice, of which the parser would take the last.
json::parser_callback_t unique_keys(const std::string& file) {
  return [file, open = std::vector<std::set<std::string>>()](int, json::parse_event_t event,
                                                             const json& parsed) mutable {
    if (event == json::parse_event_t::object_start) open.emplace_back();
    if (event == json::parse_event_t::object_end) open.pop_back();
    if (event == json::parse_event_t::key &&
        !open.back().insert(parsed.get<std::string>()).second) {
      throw Error(ErrorKind::case_file, file + ": " + parsed.get<std::string>(),
                  "this key is given twice in one object", "remove one of them");
    }
    return true;
  };
}

}  // namespace

JsonReader::JsonReader(std::shared_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

JsonReader JsonReader::file(const std::string& path) {
  const std::string text = read_text_file(path);
  auto implementation = std::make_shared<Implementation>();
  implementation->file = path;
  try {
    implementation->value = json::parse(text, unique_keys(path));
  } catch (const json::exception& error) {  // also a number too large for a double
    throw Error(ErrorKind::case_file, path, error.what(), "mend the JSON at this place");
  }
  if (!implementation->value.is_object()) {
    throw Error(ErrorKind::case_file, path, "it is not a JSON object",
                "start it with { as in docs/case-file.md");
  }
  return JsonReader(implementation);
}

std::string JsonReader::subject(const std::string& key) const {
  return implementation_->file + ": " + implementation_->path + key;
}

void JsonReader::refuse(const std::string& key, const std::string& problem,
                        const std::string& remedy) const {
  throw Error(ErrorKind::case_file, subject(key), problem, remedy);
}

bool JsonReader::has(const std::string& key) const {
  return implementation_->value.contains(key);
}

JsonReader JsonReader::object(const std::string& key) {
  const json* found = implementation_->find(key);
  auto child = std::make_shared<Implementation>();
  child->file = implementation_->file;
  child->path = implementation_->path + key + ".";
  child->value = json::object();
  if (found != nullptr) {
    if (!found->is_object()) refuse(key, "it is no object", "give an object { … }");
    child->value = *found;
  }
  return JsonReader(child);
}

JsonReader JsonReader::required_object(const std::string& key) {
  if (!has(key)) refuse(key, "it is missing", "add it as in docs/case-file.md");
  return object(key);
}

std::vector<JsonReader> JsonReader::required_objects(const std::string& key) {
  const json* found = implementation_->find(key);
  if (found == nullptr || !found->is_array() || found->empty()) {
    refuse(key, "it is no list of objects", "give [{ … }, { … }]");
  }
  std::vector<JsonReader> objects;
  for (std::size_t i = 0; i < found->size(); ++i) {
    const std::string place = key + "[" + std::to_string(i) + "]";
    if (!(*found)[i].is_object()) refuse(place, "it is no object", "give an object { … }");
    auto child = std::make_shared<Implementation>();
    child->file = implementation_->file;
    child->path = implementation_->path + place + ".";
    child->value = (*found)[i];
    objects.push_back(JsonReader(child));
  }
  return objects;
}

void JsonReader::read(const std::string& key, double& value) {
  const json* found = implementation_->find(key);
  if (found == nullptr) return;
  if (!found->is_number()) {
    refuse(key, "it is " + std::string(found->type_name()) + ", not a number",
           "give a number without quotes");
  }
  value = found->get<double>();
}

void JsonReader::read(const std::string& key, std::string& value) {
  const json* found = implementation_->find(key);
  if (found == nullptr) return;
  if (!found->is_string()) {
    refuse(key, "it is " + std::string(found->type_name()) + ", not a text",
           "give a text in quotes");
  }
  value = found->get<std::string>();
}

void JsonReader::read(const std::string& key, bool& value) {
  const json* found = implementation_->find(key);
  if (found == nullptr) return;
  if (!found->is_boolean()) {
    refuse(key, "it is " + std::string(found->type_name()) + ", not true or false",
           "give true or false");
  }
  value = found->get<bool>();
}

void JsonReader::read(const std::string& key, Eigen::Vector3d& value) {
  const json* found = implementation_->find(key);
  if (found == nullptr) return;
  bool good = found->is_array() && found->size() == 3;
  for (std::size_t i = 0; good && i < 3; ++i) good = (*found)[i].is_number();
  if (!good) refuse(key, "it is not three numbers", "give [x, y, z]");
  for (int i = 0; i < 3; ++i) value[i] = (*found)[static_cast<std::size_t>(i)].get<double>();
}

void JsonReader::read(const std::string& key, Eigen::Matrix3d& value) {
  const json* found = implementation_->find(key);
  if (found == nullptr) return;
  bool good = found->is_array() && found->size() == 3;
  for (std::size_t row = 0; good && row < 3; ++row) {
    good = (*found)[row].is_array() && (*found)[row].size() == 3;
    for (std::size_t i = 0; good && i < 3; ++i) good = (*found)[row][i].is_number();
  }
  if (!good) refuse(key, "it is not three rows of three numbers", "give [[…], […], […]]");
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 3; ++i) {
      value(row, i) = (*found)[static_cast<std::size_t>(row)][static_cast<std::size_t>(i)];
    }
  }
}

std::string JsonReader::required_string(const std::string& key) {
  if (!has(key)) refuse(key, "it is missing", "add it as in docs/case-file.md");
  std::string value;
  read(key, value);
  if (value.empty()) refuse(key, "it is empty", "give a text that names something");
  return value;
}

Eigen::Vector3d JsonReader::required_vector(const std::string& key) {
  if (!has(key)) refuse(key, "it is missing", "add it as [x, y, z] in mm, LPS");
  Eigen::Vector3d value;
  read(key, value);
  return value;
}

std::vector<std::string> JsonReader::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : implementation_->value.items()) names.push_back(key);
  return names;
}

void JsonReader::finish() const {
  for (const auto& [key, value] : implementation_->value.items()) {
    if (implementation_->asked.contains(key)) continue;
    std::string known;
    for (const std::string& name : implementation_->asked)
      known += (known.empty() ? "" : ", ") + name;
    refuse(key, "this key is not known",
           "remove it or correct its spelling (known here: " + known + ")");
  }
}

}  // namespace gnathion
