#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.h"
#include "cli/verbs.h"
#include "imaging/ct_import.h"
#include "io/case_file.h"
#include "io/files.h"
#include "io/obj_document.h"
#include "scan/scan_import.h"
#include "tissue/region_shape.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A line a landmark: name, place in the photograph's own frame, place on the CT in LPS mm.
std::vector<LandmarkPair> read_landmarks(const fs::path& file) {
  std::istringstream lines(read_text_file(file));
  std::vector<LandmarkPair> pairs;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
    std::istringstream words(line);
    LandmarkPair pair;
    words >> pair.name;
    for (double& x : pair.photograph) words >> x;
    for (double& x : pair.lps) words >> x;
    std::string rest;
    if (!words || words >> rest) {
      throw Error(ErrorKind::input, file.string() + ", line " + std::to_string(number),
                  "is no landmark",
                  "write: name, x y z in the photograph's frame, x y z on the CT (LPS mm)");
    }
    pairs.push_back(pair);
  }
  return pairs;
}

/// Those that the case has on both surfaces.
std::vector<LandmarkPair> landmarks_of(const PhotographSource& photograph) {
  std::vector<LandmarkPair> pairs;
  for (const auto& [name, at] : photograph.landmarks) {
    if (at.photograph && at.lps) pairs.push_back({name, *at.photograph, *at.lps});
  }
  return pairs;
}

/// Flags of the vertices that a text file lists, counted from 0.
std::vector<bool> read_flags(const fs::path& file, Eigen::Index vertices) {
  std::istringstream words(read_text_file(file));
  std::vector<bool> flags(static_cast<std::size_t>(vertices));
  for (std::string word; words >> word;) {
    std::size_t used = 0;
    long vertex = -1;
    try {
      vertex = std::stol(word, &used);
    } catch (const std::exception&) {
      used = 0;
    }
    if (used != word.size() || vertex < 0 || vertex >= vertices) {
      throw Error(ErrorKind::input, file.string(),
                  "lists \"" + word + "\", which is no vertex of the photograph",
                  "list vertices from 0 to " + std::to_string(vertices - 1));
    }
    flags[static_cast<std::size_t>(vertex)] = true;
  }
  return flags;
}

json to_json(const Similarity& s) {
  json rotation = json::array();
  for (const auto& row : s.rotation.rowwise()) rotation.push_back({row[0], row[1], row[2]});
  return {{"scale", s.scale},
          {"rotation", rotation},
          {"translation_mm", {s.translation[0], s.translation[1], s.translation[2]}}};
}

json to_json(const Registration& r) {
  const RegistrationQuality& q = r.quality;
  json doubts = json::array();
  for (const RegistrationDoubt& doubt : r.doubts) doubts.push_back(doubt.problem);
  return {{"transform", to_json(r.lps_from_photograph)},
          {"distance_mm", {{"rms", q.rms_mm}, {"median", q.median_mm}, {"p95", q.p95_mm}}},
          {"near", q.near},
          {"agrees", q.agrees},
          {"matched_cm2", q.matched_cm2},
          {"spread_mm", q.spread_mm},
          {"offset_mm", q.offset_mm},
          {"grip", q.grip},
          {"iterations", q.iterations},
          {"converged", q.converged},
          {"landmarks_mm", q.landmark_mm},
          {"doubts", doubts}};
}

void print(const Registration& r, std::ostream& out) {
  const RegistrationQuality& q = r.quality;
  out << std::fixed << std::setprecision(4) << "scale: " << r.lps_from_photograph.scale
      << " mm in a unit of the photograph\n"
      << std::setprecision(2) << "distance to the CT's skin: RMS " << q.rms_mm << " mm, median "
      << q.median_mm << " mm, 95th percentile " << q.p95_mm << " mm (of the "
      << std::setprecision(0) << 100 * q.near << " % that lie within 15 mm of it)\n"
      << 100 * q.agrees << " % of these, " << q.matched_cm2 << " cm2, lie within 2 mm\n"
      << std::setprecision(2) << "spread where it decided: " << q.spread_mm << " mm, after "
      << q.iterations << " steps\n";
  for (const auto& [name, mm] : q.landmark_mm) {
    out << "  " << std::left << std::setw(20) << name << std::right << std::setw(7) << mm
        << " mm\n";
  }
  for (const RegistrationDoubt& doubt : r.doubts)
    out << "doubt: " << doubt.problem << "; " << doubt.remedy << '\n';
}

Registration registered(const SurgicalCase& plan, const TriangleMesh& photograph,
                        const RegisterChoices& choices, Progress& progress) {
  RegistrationOptions options;
  options.fit_scale = choices.fit_scale;
  options.mm_per_unit = choices.mm_per_unit;
  if (choices.stable) {
    options.stable = read_flags(*choices.stable, photograph.vertices.rows());
  } else if (!plan.photograph->stable_vertices.empty()) {
    options.stable = selection_of(plan.photograph->stable_vertices, photograph.vertices.rows());
  }
  options.landmarks =
      choices.landmarks ? read_landmarks(*choices.landmarks) : landmarks_of(*plan.photograph);
  std::optional<Similarity> start;
  if (choices.from_case) start = plan.photograph->lps_from_photograph;
  if (choices.landmarks && !choices.from_case) {
    start = (choices.mm_per_unit ? fit_landmarks(options.landmarks, *choices.mm_per_unit)
                                 : fit_landmarks(options.landmarks))
                .lps_from_photograph;
  }
  const CtVolume ct = read_ct(plan.ct.path, plan.ct.series_uid, progress);
  const SkinTarget skin(skin_surface(ct, plan.skin, progress));
  return start ? register_photograph(photograph, skin, *start, options, progress)
               : register_photograph(photograph, skin, options, progress);
}

}  // namespace

void register_verb(const fs::path& case_file, const fs::path& target,
                   const RegisterChoices& choices, std::ostream& out, Progress& progress) {
  SurgicalCase plan = read_case_file(case_file);
  if (!plan.photograph) {
    throw Error(ErrorKind::case_file, case_file.string(), "has no photograph to register",
                "give photograph.obj");
  }
  NewFolder folder(target);
  const ObjDocument document = read_scan(plan.photograph->obj, progress);
  const Registration r = registered(plan, document.mesh().surface, choices, progress);
  print(r, out);
  if (!r.trusted() && !choices.accept_doubts) {
    throw Error(ErrorKind::numeric, "registration", "is doubtful: " + r.doubts.front().problem,
                r.doubts.front().remedy + ", or take it as it is with --accept-doubts");
  }
  plan.photograph->lps_from_photograph = r.lps_from_photograph;
  for (fs::path* path : {&plan.ct.path, &plan.photograph->obj}) *path = fs::absolute(*path);
  write_case_file(plan, folder.path() / "case.json");
  write_text_file(folder.path() / "registration.json", to_json(r).dump(2) + "\n");
  folder.publish();
  out << "wrote\n  " << (target / "case.json").string() << "\n  "
      << (target / "registration.json").string() << '\n';
}

}  // namespace gnathion
