#include "io/case_file.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/files.h"
#include "io/json_reader.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kVersion = 1;

fs::path beside(const fs::path& case_file, const std::string& path) {
  return fs::path(path).is_absolute() ? fs::path(path) : case_file.parent_path() / path;
}

void read_positive(JsonReader& object, const std::string& key, double& value) {
  object.read(key, value);
  if (!std::isfinite(value) || value <= 0) {
    object.refuse(key, "it is not greater than 0", "give a positive number");
  }
}

LpsBox read_box(JsonReader object) {
  LpsBox box{object.required_vector("min"), object.required_vector("max")};
  if (!(box.min.array() < box.max.array()).all()) {
    object.refuse("min", "it is not below \"max\" in every coordinate",
                  "give the box's smallest x, y, z as min and its largest as max, LPS mm");
  }
  object.finish();
  return box;
}

BoundedCut read_cut(JsonReader segment) {
  if (segment.has("box") == segment.has("plate")) {
    segment.refuse("box", "the segment needs exactly one cut, \"box\" or \"plate\"",
                   "give one of them");
  }
  BoundedCut cut;
  if (segment.has("box")) {
    const LpsBox box = read_box(segment.object("box"));
    cut = box_between(box.min, box.max);
  } else {
    JsonReader plate = segment.object("plate");
    PlateCut blade;
    blade.centre = plate.required_vector("centre");
    blade.normal = plate.required_vector("normal");
    blade.in_plane = plate.required_vector("width_direction");
    blade.seed = plate.required_vector("seed");
    read_positive(plate, "half_width_mm", blade.half_width);
    read_positive(plate, "half_height_mm", blade.half_height);
    read_positive(plate, "kerf_mm", blade.kerf);
    if (blade.normal.cross(blade.in_plane).norm() < 1e-9) {
      plate.refuse("width_direction", "it is parallel to the normal or zero",
                   "give a direction within the blade");
    }
    plate.finish();
    cut = blade;
  }
  return cut;
}

Similarity read_transform(JsonReader object) {
  Similarity transform;
  read_positive(object, "scale", transform.scale);
  object.read("rotation", transform.rotation);
  object.read("translation_mm", transform.translation);
  const Eigen::Matrix3d& R = transform.rotation;
  if ((R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > 1e-6 ||
      R.determinant() < 0) {
    object.refuse("rotation", "its rows are not those of a rotation matrix",
                  "give three orthonormal rows with determinant +1; a scale has its own key");
  }
  object.finish();
  return transform;
}

/// Whitespace-separated vertex numbers.
std::vector<int> read_vertices(const fs::path& path, const std::string& key) {
  std::ifstream stream(path);
  if (!stream) {
    throw Error(ErrorKind::input, path.string(), "the file cannot be opened", "check " + key);
  }
  std::vector<int> vertices;
  for (std::string word; stream >> word;) {
    int v = 0;
    const char* end = word.data() + word.size();
    const auto [rest, status] = std::from_chars(word.data(), end, v);
    if (status != std::errc() || rest != end) {
      throw Error(ErrorKind::input, path.string(),
                  "entry " + std::to_string(vertices.size() + 1) + " is no whole number",
                  "give vertex numbers of the face, from 0, separated by spaces or lines");
    }
    vertices.push_back(v);
  }
  if (vertices.empty()) {
    throw Error(ErrorKind::input, path.string(), "the file names no vertex",
                "give vertex numbers of the face, or leave " + key + " out");
  }
  return vertices;
}

/// Names of an enumeration's values, in a case file.
template <typename T>
using Names = std::vector<std::pair<const char*, T>>;

template <typename T>
std::string name_of(const Names<T>& names, T value) {
  const auto found = std::find_if(names.begin(), names.end(),
                                  [value](const auto& name) { return name.second == value; });
  return found->first;
}

const Names<Generator> kGenerators{{"robust", Generator::robust}, {"paper", Generator::paper}};
const Names<LoadModel> kLoads{{"displacement", LoadModel::displacement},
                              {"force", LoadModel::force}};
const Names<TissueKinds> kKinds{{"homogeneous", TissueKinds::homogeneous},
                                {"ct", TissueKinds::from_ct}};
const Names<Elements> kElements{{"auto", Elements::automatic},
                                {"linear", Elements::linear},
                                {"quadratic", Elements::quadratic}};
const Names<Strain> kStrains{
    {"auto", Strain::automatic}, {"small", Strain::small}, {"large", Strain::large}};

template <typename T>
void read_choice(JsonReader& object, const std::string& key, const Names<T>& names, T& value) {
  std::string text = name_of(names, value), known;
  object.read(key, text);
  for (const auto& [name, choice] : names) {
    if (text == name) value = choice;
    known += (known.empty() ? "" : " or ") + std::string(name);
  }
  if (name_of(names, value) != text) {
    object.refuse(key, "\"" + text + "\" is not known", "give " + known);
  }
}

void read_not_negative(JsonReader& object, const std::string& key, double& value) {
  object.read(key, value);
  if (!std::isfinite(value) || value < 0) {
    object.refuse(key, "it is below 0", "give 0 or a positive number");
  }
}

TissueModel read_tissue(JsonReader object, const fs::path& case_file) {
  TissueModel tissue;
  read_choice(object, "generator", kGenerators, tissue.generator);
  read_choice(object, "load", kLoads, tissue.load);
  read_choice(object, "kinds", kKinds, tissue.kinds);
  read_choice(object, "elements", kElements, tissue.elements);
  read_choice(object, "strain", kStrains, tissue.strain);
  if (tissue.load == LoadModel::force) {
    const std::string remedy = "give \"auto\", or \"displacement\" as tissue.load";
    if (tissue.elements == Elements::quadratic) {
      object.refuse("elements", "force transfer has linear elements only", remedy);
    }
    if (tissue.strain == Strain::large) {
      object.refuse("strain", "force transfer has small strain only", remedy);
    }
  }
  read_positive(object, "depth_mm", tissue.depth_mm);
  read_positive(object, "bone_reach_mm", tissue.bone_reach_mm);
  read_positive(object, "tolerance_mm", tissue.tolerance_mm);
  read_not_negative(object, "edge_mm", tissue.edge_mm);
  read_not_negative(object, "layer_edges", tissue.layer_edges);
  read_not_negative(object, "released_mm", tissue.released_mm);
  object.read("slides_on_teeth", tissue.slides_on_teeth);
  if (object.has("sliding_file")) {
    tissue.sliding_vertices = read_vertices(
        beside(case_file, object.required_string("sliding_file")), "tissue.sliding_file");
  }
  object.read("young_MPa", tissue.material.young_MPa);
  object.read("poisson", tissue.material.poisson);
  try {
    validate(tissue.material);
  } catch (const Error& error) {
    const bool is_poisson = error.subject() == "tissue.poisson";
    object.refuse(is_poisson ? "poisson" : "young_MPa", error.problem(), error.remedy());
  }
  object.finish();
  return tissue;
}

constexpr std::array<std::pair<const char*, double JawMotion::*>, 6> kMotionKeys{
    {{"forward_mm", &JawMotion::forward_mm},
     {"up_mm", &JawMotion::up_mm},
     {"left_mm", &JawMotion::left_mm},
     {"pitch_deg", &JawMotion::pitch_deg},
     {"roll_deg", &JawMotion::roll_deg},
     {"yaw_deg", &JawMotion::yaw_deg}}};

void read_motion(JsonReader object, PlannedSegment& segment) {
  for (const auto& [key, member] : kMotionKeys) object.read(key, segment.motion.*member);
  if (object.has("pivot")) segment.pivot = object.required_vector("pivot");
  object.finish();
}

/// Either "segment" and "motion" of the only one, or a list "segments", each with a name and its
/// motion.
std::vector<PlannedSegment> read_segments(JsonReader& root) {
  std::vector<PlannedSegment> segments;
  if (!root.has("segments")) {
    PlannedSegment only;
    JsonReader object = root.required_object("segment");
    only.cut = read_cut(object);
    object.finish();
    read_motion(root.object("motion"), only);
    return {only};
  }
  if (root.has("segment") || root.has("motion")) {
    root.refuse("segments", "the case also has \"segment\" or \"motion\"",
                "give either the list, or the one segment and its motion");
  }
  for (JsonReader& object : root.required_objects("segments")) {
    PlannedSegment segment;
    segment.name = object.required_string("name");
    const bool known = std::any_of(segments.begin(), segments.end(),
                                   [&](const auto& s) { return s.name == segment.name; });
    if (known) object.refuse("name", "another segment has it", "give each segment its own name");
    segment.cut = read_cut(object);
    read_motion(object.object("motion"), segment);
    object.finish();
    segments.push_back(segment);
  }
  return segments;
}

}  // namespace

SurgicalCase read_case_file(const fs::path& path) {
  JsonReader root = JsonReader::file(path.string());
  double version = 0;
  root.read("gnathion_case", version);
  if (version != kVersion) {
    root.refuse("gnathion_case", "it is not " + std::to_string(kVersion),
                "write \"gnathion_case\": 1; this program reads no other version");
  }
  SurgicalCase plan;
  root.read("name", plan.name);

  JsonReader ct = root.required_object("ct");
  plan.ct.path = beside(path, ct.required_string("path"));
  if (ct.has("series_uid")) plan.ct.series_uid = ct.required_string("series_uid");
  if (ct.has("crop")) plan.bone.crop = plan.skin.crop = read_box(ct.object("crop"));
  ct.read("remove_support", plan.skin.remove_support);
  plan.bone.remove_support = plan.skin.remove_support;
  ct.finish();

  JsonReader bone = root.object("bone");
  bone.read("hu", plan.bone.hu);
  read_positive(bone, "smallest_piece_mm3", plan.bone.minimum_component_volume);
  bone.finish();
  JsonReader skin = root.object("skin");
  skin.read("hu", plan.skin.hu);
  read_positive(skin, "edge_mm", plan.skin.edge_mm);
  skin.finish();

  plan.segments = read_segments(root);
  if (root.has("photograph")) {
    JsonReader photograph = root.object("photograph");
    PhotographSource source;
    source.obj = beside(path, photograph.required_string("obj"));
    source.lps_from_photograph = read_transform(photograph.object("transform"));
    photograph.finish();
    plan.photograph = source;
  }
  JsonReader region = root.object("region");
  read_positive(region, "reach_mm", plan.region.reach_mm);
  if (region.has("vertices_file")) {
    plan.region.vertices = read_vertices(beside(path, region.required_string("vertices_file")),
                                         "region.vertices_file");
  }
  region.finish();
  plan.tissue = read_tissue(root.object("tissue"), path);
  JsonReader landmarks = root.object("landmarks");
  for (const std::string& name : landmarks.keys()) {
    plan.landmarks[name] = landmarks.required_vector(name);
  }
  root.finish();
  return plan;
}

namespace {

json vector_json(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

json box_json(const LpsBox& box) {
  return {{"min", vector_json(box.min)}, {"max", vector_json(box.max)}};
}

std::string path_json(const fs::path& target, const fs::path& case_file) {
  const fs::path folder = fs::absolute(case_file).parent_path().lexically_normal();
  const fs::path relative = fs::absolute(target).lexically_normal().lexically_relative(folder);
  const bool within = !relative.empty() && *relative.begin() != "..";
  return within ? relative.string() : fs::absolute(target).lexically_normal().string();
}

json cut_json(const BoundedCut& cut) {
  if (const auto* box = std::get_if<BoxCut>(&cut)) {
    if (!box->axes.isIdentity(1e-12)) {
      throw Error(ErrorKind::case_file, "segment.box",
                  "its axes are turned, which a case file has no key for",
                  "use a box along the patient's axes, or a plate");
    }
    return {{"box", box_json({box->centre - box->half_extents, box->centre + box->half_extents})}};
  }
  const auto& plate = std::get<PlateCut>(cut);
  return {{"plate",
           {{"centre", vector_json(plate.centre)},
            {"normal", vector_json(plate.normal)},
            {"width_direction", vector_json(plate.in_plane)},
            {"seed", vector_json(plate.seed)},
            {"half_width_mm", plate.half_width},
            {"half_height_mm", plate.half_height},
            {"kerf_mm", plate.kerf}}}};
}

json transform_json(const Similarity& transform) {
  json rows = json::array();
  for (int row = 0; row < 3; ++row) {
    rows.push_back(vector_json(transform.rotation.row(row).transpose()));
  }
  return {{"scale", transform.scale},
          {"rotation", rows},
          {"translation_mm", vector_json(transform.translation)}};
}

json motion_json(const PlannedSegment& segment) {
  json motion = json::object();
  for (const auto& [key, member] : kMotionKeys) motion[key] = segment.motion.*member;
  if (segment.pivot) motion["pivot"] = vector_json(*segment.pivot);
  return motion;
}

void add_segments(const std::vector<PlannedSegment>& segments, json& root) {
  if (segments.size() == 1 && segments[0].name == PlannedSegment{}.name) {
    root["segment"] = cut_json(segments[0].cut);
    root["motion"] = motion_json(segments[0]);
    return;
  }
  for (const PlannedSegment& segment : segments) {
    json object = cut_json(segment.cut);
    object["name"] = segment.name;
    object["motion"] = motion_json(segment);
    root["segments"].push_back(object);
  }
}

json tissue_json(const TissueModel& tissue) {
  return {{"generator", name_of(kGenerators, tissue.generator)},
          {"depth_mm", tissue.depth_mm},
          {"bone_reach_mm", tissue.bone_reach_mm},
          {"edge_mm", tissue.edge_mm},
          {"layer_edges", tissue.layer_edges},
          {"released_mm", tissue.released_mm},
          {"slides_on_teeth", tissue.slides_on_teeth},
          {"young_MPa", tissue.material.young_MPa},
          {"poisson", tissue.material.poisson},
          {"kinds", name_of(kKinds, tissue.kinds)},
          {"load", name_of(kLoads, tissue.load)},
          {"elements", name_of(kElements, tissue.elements)},
          {"strain", name_of(kStrains, tissue.strain)},
          {"tolerance_mm", tissue.tolerance_mm}};
}

/// Writes vertex numbers beside the case file; returns the name of the file.
std::string write_vertices(const std::vector<int>& vertices, const fs::path& case_file,
                           const char* extension) {
  const fs::path file = fs::path(case_file).replace_extension(extension);
  std::string numbers;
  for (const int v : vertices) numbers += std::to_string(v) + "\n";
  write_text_file(file, numbers);
  return file.filename().string();
}

}  // namespace

PlanHistory read_case_history(const fs::path& path) {
  return {"Open", read_case_file(path)};
}

void write_case_history(const PlanHistory& history, const fs::path& path) {
  write_case_file(history.plan(), path);
}

void write_case_file(const SurgicalCase& plan, const fs::path& path) {
  json root{{"gnathion_case", kVersion}, {"name", plan.name}};
  root["ct"] = {{"path", path_json(plan.ct.path, path)},
                {"remove_support", plan.skin.remove_support}};
  if (plan.ct.series_uid) root["ct"]["series_uid"] = *plan.ct.series_uid;
  if (plan.skin.crop) root["ct"]["crop"] = box_json(*plan.skin.crop);
  root["bone"] = {{"hu", plan.bone.hu}, {"smallest_piece_mm3", plan.bone.minimum_component_volume}};
  root["skin"] = {{"hu", plan.skin.hu}, {"edge_mm", plan.skin.edge_mm}};
  add_segments(plan.segments, root);
  if (plan.photograph) {
    root["photograph"] = {{"obj", path_json(plan.photograph->obj, path)},
                          {"transform", transform_json(plan.photograph->lps_from_photograph)}};
  }
  root["region"] = {{"reach_mm", plan.region.reach_mm}};
  if (!plan.region.vertices.empty()) {
    root["region"]["vertices_file"] = write_vertices(plan.region.vertices, path, ".region.txt");
  }
  root["tissue"] = tissue_json(plan.tissue);
  if (!plan.tissue.sliding_vertices.empty()) {
    root["tissue"]["sliding_file"] =
        write_vertices(plan.tissue.sliding_vertices, path, ".sliding.txt");
  }
  root["landmarks"] = json::object();
  for (const auto& [name, place] : plan.landmarks) root["landmarks"][name] = vector_json(place);
  std::string text;
  try {
    text = root.dump(2) + "\n";
  } catch (const json::exception&) {
    throw Error(ErrorKind::output, path.string(), "a name in the case is not UTF-8",
                "rename the folder or file that the case names");
  }
  write_text_file(path, text);
}

}  // namespace gnathion
