#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bone/osteotomy.h"
#include "fem/material.h"
#include "imaging/surfaces.h"
#include "plan/jaw_motion.h"

namespace gnathion {

struct CtSource {
  std::filesystem::path path;             ///< folder of a DICOM series, or a volume file
  std::optional<std::string> series_uid;  ///< which series of the folder
};

struct PhotographSource {
  std::filesystem::path obj;
  Similarity lps_from_photograph;  ///< from the file's frame and unit to LPS mm
};

struct RegionChoice {
  double reach_mm = 35;       ///< of the suggested region: distance from the segment
  std::vector<int> vertices;  ///< of the face, from 0; not empty: these instead
};

enum class Generator { robust, paper };
enum class LoadModel {
  displacement,  ///< points on the segment follow it
  force,         ///< the paper's force transfer (eq. 4)
};

struct TissueModel {
  Generator generator = Generator::robust;
  double depth_mm = 8;        ///< d of the ST Generator; robust: where no bone is near
  double bone_reach_mm = 20;  ///< threshold of the bone map
  /// Bone nearer than this to the bone across the cut does not hold the tissue: there the surgeon
  /// lifts it off, and lips rest on teeth without being attached to them.
  double released_mm = 10;
  ElasticMaterial material;
  LoadModel load = LoadModel::displacement;
};

/// Everything that a prediction is made from: the content of a case file. Paths are absolute or
/// relative to the working directory.
struct SurgicalCase {
  std::string name;  ///< of the plan, not of the patient
  CtSource ct;
  BoneSurfaceOptions bone;
  SkinSurfaceOptions skin;
  BoundedCut cut;
  std::optional<PhotographSource> photograph;  ///< none: the CT's skin is the face
  RegionChoice region;
  TissueModel tissue;
  JawMotion motion;
  std::optional<Eigen::Vector3d> pivot;  ///< LPS mm; none: the segment's centre of volume
  std::map<std::string, Eigen::Vector3d> landmarks;  ///< on the face, LPS mm
};

}  // namespace gnathion
