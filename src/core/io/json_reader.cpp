#include "io/json_reader.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/error.h"
#include "io/files.h"

namespace gnathion {

using nlohmann::json;

struct JsonReader::Implementation {
  std::string file;
  std::string path;                      ///< of this object, with a trailing dot; empty: the root
  std::shared_ptr<const json> document;  ///< that holds the object
  const json* value = nullptr;           ///< the object
  std::set<std::string> asked;

  const json* find(const std::string& key) {
    asked.insert(key);
    const auto place = value->find(key);
    return place == value->end() ? nullptr : &*place;
  }

  /// An object within this one, or an empty one.
  std::shared_ptr<Implementation> child(const std::string& place, const json* object) const {
    auto inner = std::make_shared<Implementation>();
    inner->file = file;
    inner->path = path + place + ".";
    inner->document = object != nullptr ? document : std::make_shared<const json>(json::object());
    inner->value = object != nullptr ? object : inner->document.get();
    return inner;
  }

  /// The same place with another content.
  std::shared_ptr<Implementation> with(json content) const {
    auto other = std::make_shared<Implementation>();
    other->file = file;
    other->path = path;
    other->document = std::make_shared<const json>(std::move(content));
    other->value = other->document.get();
    return other;
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
  const Implementation nothing{path, "", nullptr, nullptr, {}};
  json content;
  try {
    content = json::parse(text, unique_keys(path));
  } catch (const json::exception& error) {  // also a number too large for a double
    throw Error(ErrorKind::case_file, path, error.what(), "mend the JSON at this place");
  }
  if (!content.is_object()) {
    throw Error(ErrorKind::case_file, path, "it is not a JSON object",
                "start it with { as in docs/case-file.md");
  }
  return JsonReader(nothing.with(std::move(content)));
}

std::string JsonReader::subject(const std::string& key) const {
  return implementation_->file + ": " + implementation_->path + key;
}

void JsonReader::refuse(const std::string& key, const std::string& problem,
                        const std::string& remedy) const {
  throw Error(ErrorKind::case_file, subject(key), problem, remedy);
}

bool JsonReader::has(const std::string& key) const {
  return implementation_->value->contains(key);
}

JsonReader JsonReader::object(const std::string& key) {
  const json* found = implementation_->find(key);
  if (found != nullptr && !found->is_object()) {
    refuse(key, "it is no object", "give an object { … }");
  }
  return JsonReader(implementation_->child(key, found));
}

JsonReader JsonReader::required_object(const std::string& key) {
  if (!has(key)) refuse(key, "it is missing", "add it as in docs/case-file.md");
  return object(key);
}

std::vector<JsonReader> JsonReader::objects(const std::string& key) {
  const json* found = implementation_->find(key);
  if (found == nullptr) return {};
  if (!found->is_array()) refuse(key, "it is no list of objects", "give [{ … }, { … }]");
  std::vector<JsonReader> objects;
  for (std::size_t i = 0; i < found->size(); ++i) {
    const std::string place = key + "[" + std::to_string(i) + "]";
    const json& object = (*found)[i];
    if (!object.is_object()) refuse(place, "it is no object", "give an object { … }");
    objects.push_back(JsonReader(implementation_->child(place, &object)));
  }
  return objects;
}

namespace {

/// A copy of `object` without the keys that lie below `prefix` at these paths; what is left out is
/// not copied first.
json copy_without(const json& object, const std::string& prefix,
                  const std::vector<std::string>& paths) {
  json copy = json::object();
  for (const auto& [key, value] : object.items()) {
    const std::string path = prefix + key;
    if (std::find(paths.begin(), paths.end(), path) != paths.end()) continue;
    copy[key] = value.is_object() ? copy_without(value, path + ".", paths) : value;
  }
  return copy;
}

}  // namespace

JsonReader JsonReader::without(const std::vector<std::string>& paths) const {
  return JsonReader(implementation_->with(copy_without(*implementation_->value, "", paths)));
}

JsonReader JsonReader::changed_by(const JsonReader& changes, const std::string& place) const {
  json content = *implementation_->value;
  content.merge_patch(*changes.implementation_->value);
  auto changed = implementation_->with(std::move(content));
  changed->path = place + ".";
  return JsonReader(changed);
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

namespace {

bool is_vector(const json& value) {
  return value.is_array() && value.size() == 3 &&
         std::all_of(value.begin(), value.end(), [](const json& x) { return x.is_number(); });
}

Eigen::Vector3d vector_of(const json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

}  // namespace

void JsonReader::read(const std::string& key, Eigen::Vector3d& value) {
  const json* found = implementation_->find(key);
  if (found == nullptr) return;
  if (!is_vector(*found)) refuse(key, "it is not three numbers", "give [x, y, z]");
  value = vector_of(*found);
}

void JsonReader::read(const std::string& key, std::vector<Eigen::Vector3d>& value) {
  const json* found = implementation_->find(key);
  if (found == nullptr) return;
  if (!found->is_array() || !std::all_of(found->begin(), found->end(), is_vector)) {
    refuse(key, "it is not a list of points", "give [[x, y, z], [x, y, z], …]");
  }
  value.clear();
  for (const json& point : *found) value.push_back(vector_of(point));
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

Eigen::Vector2d JsonReader::required_pixel(const std::string& key) {
  const json* found = implementation_->find(key);
  const bool good = found != nullptr && found->is_array() && found->size() == 2 &&
                    (*found)[0].is_number() && (*found)[1].is_number();
  if (!good) refuse(key, "it is not two numbers", "give [x, y] in pixels, right and down");
  return {(*found)[0].get<double>(), (*found)[1].get<double>()};
}

std::vector<std::string> JsonReader::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : implementation_->value->items()) names.push_back(key);
  return names;
}

void JsonReader::finish() const {
  for (const auto& [key, value] : implementation_->value->items()) {
    if (implementation_->asked.contains(key)) continue;
    std::string known;
    for (const std::string& name : implementation_->asked)
      known += (known.empty() ? "" : ", ") + name;
    refuse(key, "this key is not known",
           "remove it or correct its spelling (known here: " + known + ")");
  }
}

}  // namespace gnathion
