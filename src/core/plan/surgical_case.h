#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bone/osteotomy.h"
#include "fem/material.h"
#include "imaging/surfaces.h"
#include "plan/hinge.h"
#include "plan/jaw_motion.h"

namespace gnathion {

struct CtSource {
  std::filesystem::path path;             ///< folder of a DICOM series, or a volume file
  std::optional<std::string> series_uid;  ///< which series of the folder

  bool operator==(const CtSource&) const = default;
};

/// A place of the face as the user picked it, to tell where the photograph belongs: on either
/// surface, or on both.
struct PickedPlace {
  std::optional<Eigen::Vector3d> photograph;  ///< in its own frame and unit
  std::optional<Eigen::Vector3d> lps;         ///< on the CT's skin, mm

  bool operator==(const PickedPlace&) const = default;
};

struct PhotographSource {
  std::filesystem::path obj;       ///< the scan, OBJ or any other format (scan/scan_import.h)
  Similarity lps_from_photograph;  ///< from the file's frame and unit to LPS mm
  /// By name. Like `stable_vertices` they find its place and change no prediction.
  std::map<std::string, PickedPlace> landmarks = {};
  /// Those of its vertices that decide a fit; empty: forehead and bridge of the nose, proposed.
  std::vector<int> stable_vertices = {};

  bool operator==(const PhotographSource&) const = default;
};

struct RegionChoice {
  double reach_mm = 35;       ///< of the suggested region: distance from the segment
  std::vector<int> vertices;  ///< of the face, from 0; not empty: these instead
  bool erased = false;        ///< neither: all of it was erased and nothing is chosen yet
  /// Between the lips on the face, LPS mm, from corner to corner: the region is cut open along it.
  /// Empty: it is not.
  std::vector<Eigen::Vector3d> lip_line;

  bool operator==(const RegionChoice&) const = default;
};

enum class Generator { robust, paper };
enum class LoadModel {
  displacement,  ///< points on the segment follow it
  force,         ///< the paper's force transfer (eq. 4)
};

/// What the tissue is made of.
enum class TissueKinds {
  homogeneous,  ///< TissueModel::material everywhere
  from_ct,      ///< skin, fat and muscle by the CT's Hounsfield units
};
/// The elements of the prediction.
enum class Elements {
  automatic,  ///< linear ones where they keep the tolerance
  linear,
  quadratic,
};
/// The law of the tissue.
enum class Strain {
  automatic,  ///< small where that keeps the tolerance
  small,      ///< Hooke's law, Cauchy strain: linear in the motion
  large,      ///< neo-Hookean
};

struct TissueModel {
  Generator generator = Generator::robust;
  double depth_mm = 8;        ///< d of the ST Generator; robust: where no bone is near
  double bone_reach_mm = 20;  ///< threshold of the bone map
  /// Of the mesh that deforms, mm. 0: chosen; a face finer than that is remeshed to it.
  double edge_mm = 0;
  /// Of a layer of elements, in edges of the surface above it. 0: one layer, however thick.
  double layer_edges = 0;
  /// Bone nearer than this to other bone, across a cut or of the other jaw, does not hold tissue
  /// that would not slide: there the surgeon lifts it off.
  double released_mm = 10;
  /// Whether tissue over teeth and gums slides on them instead of following them.
  bool slides_on_teeth = true;
  std::vector<int> sliding_vertices;  ///< of the face: below these it slides, too, on any bone
  ElasticMaterial material;
  TissueKinds kinds = TissueKinds::homogeneous;
  LoadModel load = LoadModel::displacement;
  Elements elements = Elements::automatic;
  Strain strain = Strain::automatic;
  double tolerance_mm = 0.5;  ///< of the face, 95 % of it, for what is automatic

  bool operator==(const TissueModel&) const = default;
};

/// A piece of bone that is cut off and moved.
struct PlannedSegment {
  std::string name = "segment";  ///< unique in the case
  BoundedCut cut;                ///< of what the segments before it have left
  JawMotion motion;
  std::optional<Eigen::Vector3d> pivot;  ///< LPS mm; none: the segment's centre of volume

  bool operator==(const PlannedSegment&) const = default;
};

/// Everything that a prediction is made from: the content of a case file. Paths are absolute or
/// relative to the working directory.
struct SurgicalCase {
  std::string name;  ///< of the plan, not of the patient
  CtSource ct;
  BoneSurfaceOptions bone;
  SkinSurfaceOptions skin;
  std::vector<PlannedSegment> segments;        ///< none yet: nothing moves
  std::optional<PhotographSource> photograph;  ///< none: the CT's skin is the face
  RegionChoice region;
  TissueModel tissue;
  std::map<std::string, Eigen::Vector3d> landmarks;  ///< on the face, LPS mm
  std::optional<HingeAxis> hinge;  ///< as the user gave it; none: found on the bone

  bool operator==(const SurgicalCase&) const = default;
};

}  // namespace gnathion
