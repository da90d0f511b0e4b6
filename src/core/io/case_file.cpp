#include "io/case_file.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/error.h"
#include "io/files.h"
#include "io/json_reader.h"
#include "io/plan_json.h"
#include "io/vertex_text.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// A step tells how it differs from its neighbour on the side of the present plan, which stands
// whole in the file. So a path that is mended there by hand is mended in all steps.

// --- reading ------------------------------------------------------------------------------------

/// A plan with its lists of vertices apart from the rest.
struct Parts {
  JsonReader rest;
  std::vector<int> region, sliding, stable;
};

std::vector<int> stable_vertices(const SurgicalCase& plan) {
  return plan.photograph ? plan.photograph->stable_vertices : std::vector<int>();
}

std::vector<int> read_list(JsonReader& object, const std::string& key) {
  std::string text;
  object.read(key, text);
  std::optional<std::vector<int>> list = vertices_of_text(text);
  if (!list) {
    object.refuse(key, "it is no list of vertices",
                  "remove \"history\" from the case file: the plan itself is whole");
  }
  return std::move(*list);
}

void read_list_change(JsonReader& step, const std::string& key, std::vector<int>& list) {
  if (!step.has(key)) return;
  JsonReader object = step.object(key);
  if (object.has("vertices")) {
    list = read_list(object, "vertices");
  } else {
    const VertexChange change{read_list(object, "added"), read_list(object, "removed")};
    std::optional<std::vector<int>> changed = with_change(list, change);
    if (!changed) {
      step.refuse(key, "its change does not fit the vertices of the step beside it",
                  "remove \"history\" from the case file: the plan itself is whole");
    }
    list = std::move(*changed);
  }
  object.finish();
}

/// The plan of a step; `parts` are those of its neighbour, and this step's afterwards.
SurgicalCase read_step(JsonReader& step, const std::string& place, const fs::path& case_file,
                       Parts& parts) {
  parts.rest = parts.rest.changed_by(step.object("changes"), place);
  read_list_change(step, "region", parts.region);
  read_list_change(step, "sliding", parts.sliding);
  read_list_change(step, "stable", parts.stable);
  step.finish();
  JsonReader rest = parts.rest;
  SurgicalCase plan = read_plan(rest, case_file);
  if (!plan.region.vertices.empty() || !plan.tissue.sliding_vertices.empty() ||
      !stable_vertices(plan).empty()) {
    step.refuse("changes", "it gives vertices",
                "give those under the step's keys \"region\", \"sliding\" and \"stable\"");
  }
  plan.region.vertices = parts.region;
  plan.tissue.sliding_vertices = parts.sliding;
  if (plan.photograph) {
    plan.photograph->stable_vertices = parts.stable;
  } else if (!parts.stable.empty()) {
    step.refuse("stable", "it gives vertices of a photograph, and the step has none",
                "remove \"history\" from the case file: the plan itself is whole");
  }
  return plan;
}

std::size_t read_position(JsonReader& history, std::size_t count) {
  double position = -1;
  history.read("position", position);
  if (!(position >= 0) || position >= static_cast<double>(count) ||
      position != std::floor(position)) {
    history.refuse("position",
                   "it is the number of none of the " + std::to_string(count) + " steps",
                   "give the step of the present plan, counted from 0, or remove \"history\" "
                   "from the case file");
  }
  return static_cast<std::size_t>(position);
}

std::string read_name(JsonReader& step) {
  std::string name;
  if (!step.has("name")) step.refuse("name", "it is missing", "say what the step did");
  step.read("name", name);
  return name;
}

PlanHistory read_steps(JsonReader history, const SurgicalCase& present, const JsonReader& rest,
                       const fs::path& case_file) {
  std::vector<JsonReader> objects = history.objects("steps");
  const std::size_t position = read_position(history, objects.size());
  history.finish();
  std::vector<PlanStep> steps(objects.size());
  const Parts parts{rest, present.region.vertices, present.tissue.sliding_vertices,
                    stable_vertices(present)};
  const auto read = [&](std::size_t s, Parts& beside) {
    steps[s].name = read_name(objects[s]);
    const std::string place = "history.steps[" + std::to_string(s) + "].changes";
    steps[s].plan =
        std::make_shared<const SurgicalCase>(read_step(objects[s], place, case_file, beside));
  };
  steps[position].name = read_name(objects[position]);
  steps[position].plan = std::make_shared<const SurgicalCase>(present);
  objects[position].finish();
  Parts before = parts, after = parts;
  for (std::size_t s = position; s-- > 0;) read(s, before);
  for (std::size_t s = position + 1; s < steps.size(); ++s) read(s, after);
  return {std::move(steps), position};
}

// --- writing ------------------------------------------------------------------------------------

/// The merge patch (RFC 7386) that makes `to` of `from`. Neither holds a null.
json merge_patch_between(const json& from, const json& to) {
  json patch = json::object();
  for (const auto& [key, value] : from.items()) {
    if (!to.contains(key)) patch[key] = nullptr;
  }
  for (const auto& [key, value] : to.items()) {
    const auto old = from.find(key);
    if (old != from.end() && *old == value) continue;
    const bool merged = old != from.end() && old->is_object() && value.is_object();
    patch[key] = merged ? merge_patch_between(*old, value) : value;
  }
  return patch;
}

/// A list by how it differs from another, or whole where that names fewer vertices.
json list_change_json(const std::vector<int>& from, const std::vector<int>& to) {
  const std::optional<VertexChange> change = vertex_change(from, to);
  if (!change || change->added.size() + change->removed.size() >= to.size()) {
    return {{"vertices", vertex_text(to)}};
  }
  json object = json::object();
  if (!change->added.empty()) object["added"] = vertex_text(change->added);
  if (!change->removed.empty()) object["removed"] = vertex_text(change->removed);
  return object;
}

struct PlanAndJson {
  const SurgicalCase& plan;
  const json& object;
};

json step_json(const std::string& name, const PlanAndJson& from, const PlanAndJson& to) {
  json step = {{"name", name}};
  json changes = merge_patch_between(from.object, to.object);
  if (!changes.empty()) step["changes"] = std::move(changes);
  const auto add = [&](const char* key, const std::vector<int>& old, const std::vector<int>& now) {
    if (old != now) step[key] = list_change_json(old, now);
  };
  add("region", from.plan.region.vertices, to.plan.region.vertices);
  add("sliding", from.plan.tissue.sliding_vertices, to.plan.tissue.sliding_vertices);
  add("stable", stable_vertices(from.plan), stable_vertices(to.plan));
  return step;
}

/// One step a line: a history may have thousands.
std::string history_text(const PlanHistory& history, const fs::path& path) {
  const std::vector<PlanStep>& steps = history.steps();
  std::vector<json> objects;
  for (const PlanStep& step : steps) objects.push_back(plan_json(*step.plan, path));
  const auto both = [&](std::size_t s) { return PlanAndJson{*steps[s].plan, objects[s]}; };
  std::string text =
      "{\n    \"position\": " + std::to_string(history.position()) + ",\n    \"steps\": [";
  for (std::size_t s = 0; s < steps.size(); ++s) {
    json step = {{"name", steps[s].name}};
    if (s < history.position()) step = step_json(steps[s].name, both(s + 1), both(s));
    if (s > history.position()) step = step_json(steps[s].name, both(s - 1), both(s));
    text += (s == 0 ? "\n      " : ",\n      ") + step.dump();
  }
  return text + "\n    ]\n  }";
}

/// The whole plan, without the closing brace.
std::string open_plan_text(const SurgicalCase& plan, const fs::path& path) {
  json root = plan_json(plan, path);
  const auto add = [&](const char* part, const char* key, const std::vector<int>& vertices) {
    if (!vertices.empty()) root[part][key] = vertex_text(vertices);
  };
  add("region", "vertices", plan.region.vertices);
  add("tissue", "sliding_vertices", plan.tissue.sliding_vertices);
  add("photograph", "stable_vertices", stable_vertices(plan));
  std::string text = root.dump(2);
  text.resize(text.size() - 2);  // "\n}"
  return text;
}

/// What `text` returns. \throws Error(output) where the JSON library refuses a name.
template <typename Text>
std::string in_utf8(const fs::path& path, const Text& text) {
  try {
    return text();
  } catch (const json::exception&) {
    throw Error(ErrorKind::output, path.string(), "a name in the case is not UTF-8",
                "rename the folder or file that the case names");
  }
}

}  // namespace

SurgicalCase read_case_file(const fs::path& path) {
  JsonReader root = JsonReader::file(path.string());
  root.object("history");
  return read_plan(root, path);
}

PlanHistory read_case_history(const fs::path& path) {
  JsonReader root = JsonReader::file(path.string());
  const JsonReader history = root.object("history");
  SurgicalCase present = read_plan(root, path);
  if (!root.has("history")) return {"Open", std::move(present)};
  const JsonReader rest =
      root.without({"history", "region.vertices", "region.vertices_file", "tissue.sliding_vertices",
                    "tissue.sliding_file", "photograph.stable_vertices"});
  return read_steps(history, present, rest, path);
}

void write_case_history(const PlanHistory& history, const fs::path& path) {
  replace_text_file(path, in_utf8(path, [&] {
                      return open_plan_text(history.plan(), path) +
                             ",\n  \"history\": " + history_text(history, path) + "\n}\n";
                    }));
}

void write_case_file(const SurgicalCase& plan, const fs::path& path) {
  replace_text_file(path, in_utf8(path, [&] { return open_plan_text(plan, path) + "\n}\n"; }));
}

}  // namespace gnathion
