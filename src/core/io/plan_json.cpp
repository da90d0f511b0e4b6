#include "io/plan_json.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.h"
#include "io/vertex_text.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kVersion = 1;

fs::path beside(const fs::path& case_file, const std::string& path) {
  if (path == "." && case_file.has_parent_path()) return case_file.parent_path();
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

bool is_rotation(const Eigen::Matrix3d& R) {
  return (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= 1e-6 &&
         R.determinant() > 0;
}

/// Either "min" and "max" of a box along the patient's axes, or "centre", "half_extents_mm" and
/// "axes".
BoxCut read_box_cut(JsonReader object) {
  if (!object.has("centre") && !object.has("axes") && !object.has("half_extents_mm")) {
    const LpsBox box = read_box(object);
    return box_between(box.min, box.max);
  }
  BoxCut box;
  box.centre = object.required_vector("centre");
  box.half_extents = object.required_vector("half_extents_mm");
  if (!(box.half_extents.array() > 0).all()) {
    object.refuse("half_extents_mm", "they are not all greater than 0",
                  "give half the box's lengths along its three axes, mm");
  }
  Eigen::Matrix3d directions = box.axes.transpose();
  object.read("axes", directions);
  if (!is_rotation(directions)) {
    object.refuse("axes",
                  "they are not unit vectors at right angles, the third the cross product "
                  "of the first two",
                  "give the directions of the box's three edges, or leave them out for the "
                  "patient's axes");
  }
  box.axes = directions.transpose();
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
    cut = read_box_cut(segment.object("box"));
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
  if (!is_rotation(transform.rotation)) {
    object.refuse("rotation", "its rows are not those of a rotation matrix",
                  "give three orthonormal rows with determinant +1; a scale has its own key");
  }
  object.finish();
  return transform;
}

/// Whitespace-separated vertex numbers.
std::vector<int> vertices_in_file(const fs::path& path, const std::string& key) {
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

/// The vertices that `key` gives, or the file under `file_key`; none when both are absent.
std::vector<int> read_vertices(JsonReader& object, const std::string& key,
                               const std::string& file_key, const fs::path& case_file) {
  if (object.has(file_key)) {
    if (object.has(key)) {
      object.refuse(key, "\"" + file_key + "\" gives vertices, too", "give one of the two");
    }
    return vertices_in_file(beside(case_file, object.required_string(file_key)),
                            object.subject(file_key));
  }
  std::string text;
  object.read(key, text);
  const std::optional<std::vector<int>> vertices = vertices_of_text(text);
  if (!vertices || (vertices->empty() && object.has(key))) {
    object.refuse(key, "it is no list of vertices",
                  "give numbers from 0 and ranges of them in one text, as in \"12-480 500\"");
  }
  return *vertices;
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
  tissue.sliding_vertices = read_vertices(object, "sliding_vertices", "sliding_file", case_file);
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

/// A list "segments", each with a name and its motion; or "segment" and "motion" of the only one;
/// or neither: no segment yet.
std::vector<PlannedSegment> read_segments(JsonReader& root) {
  std::vector<PlannedSegment> segments;
  if (root.has("segments") && (root.has("segment") || root.has("motion"))) {
    root.refuse("segments", "the case also has \"segment\" or \"motion\"",
                "give either the list, or the one segment and its motion");
  }
  if (root.has("segment")) {
    PlannedSegment only;
    JsonReader object = root.object("segment");
    only.cut = read_cut(object);
    object.finish();
    read_motion(root.object("motion"), only);
    return {only};
  }
  if (root.has("motion")) {
    root.refuse("motion", "there is no segment that it could move",
                "add \"segment\" with its cut, or remove the motion");
  }
  for (JsonReader& object : root.objects("segments")) {
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

void read_version(JsonReader& root) {
  double version = 0;
  root.read("gnathion_case", version);
  if (version != kVersion) {
    root.refuse("gnathion_case", "it is not " + std::to_string(kVersion),
                "write \"gnathion_case\": 1; this program reads no other version");
  }
}

/// The places of one landmark on either surface.
PickedPlace read_picked(JsonReader object) {
  PickedPlace picked;
  if (object.has("scan")) picked.photograph = object.required_vector("scan");
  if (object.has("ct")) picked.lps = object.required_vector("ct");
  object.finish();
  if (!picked.photograph && !picked.lps) {
    object.refuse("scan", "the landmark has a place on neither surface",
                  "give \"scan\", \"ct\" or both, or remove the landmark");
  }
  return picked;
}

PhotographSource read_photograph(JsonReader object, const fs::path& case_file) {
  PhotographSource photograph;
  photograph.obj = beside(case_file, object.required_string("obj"));
  photograph.lps_from_photograph = read_transform(object.object("transform"));
  JsonReader landmarks = object.object("landmarks");
  for (const std::string& name : landmarks.keys()) {
    photograph.landmarks[name] = read_picked(landmarks.required_object(name));
  }
  landmarks.finish();
  std::string text;
  object.read("stable_vertices", text);
  const std::optional<std::vector<int>> stable = vertices_of_text(text);
  if (!stable || (stable->empty() && object.has("stable_vertices"))) {
    object.refuse("stable_vertices", "it is no list of vertices",
                  "give numbers from 0 and ranges of them in one text, as in \"12-480 500\"");
  }
  photograph.stable_vertices = *stable;
  object.finish();
  return photograph;
}

HingeAxis read_hinge(JsonReader object) {
  HingeAxis hinge{object.required_vector("right"), object.required_vector("left")};
  object.finish();
  if (hinge.left.x() - hinge.right.x() < least_hinge_mm) {
    object.refuse("left", "it does not lie at least 20 mm to the patient's left of the right one",
                  "give the centres of both condyles in LPS: the left one has the larger x");
  }
  return hinge;
}

/// "ct", "bone" and "skin". What ct says of crop and support holds for both surfaces, unless theirs
/// say otherwise.
void read_surfaces(JsonReader& root, const fs::path& case_file, SurgicalCase& plan) {
  JsonReader ct = root.required_object("ct");
  plan.ct.path = beside(case_file, ct.required_string("path"));
  if (ct.has("series_uid")) plan.ct.series_uid = ct.required_string("series_uid");
  if (ct.has("crop")) plan.bone.crop = plan.skin.crop = read_box(ct.object("crop"));
  ct.read("remove_support", plan.skin.remove_support);
  plan.bone.remove_support = plan.skin.remove_support;
  ct.finish();

  JsonReader bone = root.object("bone");
  bone.read("hu", plan.bone.hu);
  read_positive(bone, "smallest_piece_mm3", plan.bone.minimum_component_volume);
  bone.read("remove_support", plan.bone.remove_support);
  if (bone.has("crop")) plan.bone.crop = read_box(bone.object("crop"));
  bone.finish();
  JsonReader skin = root.object("skin");
  skin.read("hu", plan.skin.hu);
  read_positive(skin, "edge_mm", plan.skin.edge_mm);
  read_not_negative(skin, "opening_radius_mm", plan.skin.opening_radius_mm);
  read_not_negative(skin, "closing_radius_mm", plan.skin.closing_radius_mm);
  skin.read("remove_support", plan.skin.remove_support);
  if (skin.has("crop")) plan.skin.crop = read_box(skin.object("crop"));
  skin.finish();
}

}  // namespace

SurgicalCase read_plan(JsonReader& root, const fs::path& case_file) {
  SurgicalCase plan;
  read_version(root);
  root.read("name", plan.name);
  read_surfaces(root, case_file, plan);
  plan.segments = read_segments(root);
  if (root.has("photograph")) {
    plan.photograph = read_photograph(root.object("photograph"), case_file);
  }
  JsonReader region = root.object("region");
  read_positive(region, "reach_mm", plan.region.reach_mm);
  plan.region.vertices = read_vertices(region, "vertices", "vertices_file", case_file);
  region.read("erased", plan.region.erased);
  region.read("lip_line", plan.region.lip_line);
  if (plan.region.lip_line.size() == 1) {
    region.refuse("lip_line", "it is one point", "give at least two, from corner to corner");
  }
  region.finish();
  plan.tissue = read_tissue(root.object("tissue"), case_file);
  JsonReader landmarks = root.object("landmarks");
  for (const std::string& name : landmarks.keys()) {
    plan.landmarks[name] = landmarks.required_vector(name);
  }
  if (root.has("hinge")) plan.hinge = read_hinge(root.object("hinge"));
  root.finish();
  return plan;
}

namespace {

json vector_json(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

json rows_json(const Eigen::Matrix3d& matrix) {
  json rows = json::array();
  for (int row = 0; row < 3; ++row) rows.push_back(vector_json(matrix.row(row).transpose()));
  return rows;
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

/// By its corners where they give the box back to the bit.
json box_cut_json(const BoxCut& box) {
  const LpsBox corners{box.centre - box.half_extents, box.centre + box.half_extents};
  if (box_between(corners.min, corners.max) == box) return box_json(corners);
  json object = {{"centre", vector_json(box.centre)},
                 {"half_extents_mm", vector_json(box.half_extents)}};
  if (box.axes == Eigen::Matrix3d::Identity()) return object;
  Eigen::Matrix3d directions = box.axes.transpose();
  if (directions.determinant() < 0) directions.row(2) *= -1;  // the same box
  object["axes"] = rows_json(directions);
  return object;
}

json cut_json(const BoundedCut& cut) {
  if (const auto* box = std::get_if<BoxCut>(&cut)) return {{"box", box_cut_json(*box)}};
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
  return {{"scale", transform.scale},
          {"rotation", rows_json(transform.rotation)},
          {"translation_mm", vector_json(transform.translation)}};
}

json photograph_json(const PhotographSource& photograph, const fs::path& case_file) {
  json object = {{"obj", path_json(photograph.obj, case_file)},
                 {"transform", transform_json(photograph.lps_from_photograph)}};
  for (const auto& [name, picked] : photograph.landmarks) {
    json& landmark = object["landmarks"][name];
    if (picked.photograph) landmark["scan"] = vector_json(*picked.photograph);
    if (picked.lps) landmark["ct"] = vector_json(*picked.lps);
  }
  return object;
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
  root["segments"] = json::array();
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

/// "ct", "bone" and "skin". What both surfaces have in common stands in ct.
void add_surfaces(const SurgicalCase& plan, const fs::path& case_file, json& root) {
  json ct = {{"path", path_json(plan.ct.path, case_file)}};
  json bone = {{"hu", plan.bone.hu}, {"smallest_piece_mm3", plan.bone.minimum_component_volume}};
  json skin = {{"hu", plan.skin.hu},
               {"edge_mm", plan.skin.edge_mm},
               {"opening_radius_mm", plan.skin.opening_radius_mm},
               {"closing_radius_mm", plan.skin.closing_radius_mm}};
  if (plan.ct.series_uid) ct["series_uid"] = *plan.ct.series_uid;
  if (plan.bone.remove_support == plan.skin.remove_support) {
    ct["remove_support"] = plan.skin.remove_support;
  } else {
    bone["remove_support"] = plan.bone.remove_support;
    skin["remove_support"] = plan.skin.remove_support;
  }
  if (plan.bone.crop == plan.skin.crop) {
    if (plan.skin.crop) ct["crop"] = box_json(*plan.skin.crop);
  } else {
    if (plan.bone.crop) bone["crop"] = box_json(*plan.bone.crop);
    if (plan.skin.crop) skin["crop"] = box_json(*plan.skin.crop);
  }
  root["ct"] = ct;
  root["bone"] = bone;
  root["skin"] = skin;
}

}  // namespace

json plan_json(const SurgicalCase& plan, const fs::path& case_file) {
  json root = {{"gnathion_case", kVersion}, {"name", plan.name}};
  add_surfaces(plan, case_file, root);
  add_segments(plan.segments, root);
  if (plan.photograph) root["photograph"] = photograph_json(*plan.photograph, case_file);
  root["region"] = {{"reach_mm", plan.region.reach_mm}};
  if (plan.region.erased) root["region"]["erased"] = true;
  for (const Eigen::Vector3d& point : plan.region.lip_line) {
    root["region"]["lip_line"].push_back(vector_json(point));
  }
  root["tissue"] = tissue_json(plan.tissue);
  if (plan.hinge) {
    root["hinge"] = {{"right", vector_json(plan.hinge->right)},
                     {"left", vector_json(plan.hinge->left)}};
  }
  root["landmarks"] = json::object();
  for (const auto& [name, place] : plan.landmarks) root["landmarks"][name] = vector_json(place);
  return root;
}

}  // namespace gnathion
