#include "prediction/anatomy.h"

#include <algorithm>
#include <future>
#include <iomanip>
#include <optional>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "bone/cut_preview.h"
#include "geometry/triangle_mesh.h"
#include "imaging/ct_import.h"
#include "io/files.h"
#include "scan/scan_import.h"

namespace gnathion {
namespace {

Face skin_face(const TriangleMesh& skin) {
  Face face{{}, ObjDocument::of_surface(skin, "skin of the CT"), {}, false};
  face.mesh = face.document.mesh();
  return face;
}

/// A scan in metres or centimetres would otherwise be a speck inside the head.
void check_size(const Points& lps, const std::filesystem::path& file) {
  constexpr double kLeast = 60, kMost = 1500;  // mm; a scan may go down to the waist
  const double size = (lps.colwise().maxCoeff() - lps.colwise().minCoeff()).maxCoeff();
  if (size >= kLeast && size <= kMost) return;
  std::ostringstream across;
  across << std::setprecision(3) << size;
  throw Error(ErrorKind::input, file.string(),
              "with the case's transform it is " + across.str() + " mm across, which is no face",
              "give photograph.transform.scale: the millimetres in a unit of the file (1000 for "
              "a scan in metres)");
}

}  // namespace

Points Face::file_vertices(const Points& points) const {
  Points vertices = document.mesh().surface.vertices;
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
    const Eigen::RowVector3d u = points.row(v) - mesh.surface.vertices.row(v);
    if (u.isZero(0)) continue;
    vertices.row(v) += lps_from_file.displacement_to_source(u.transpose()).transpose();
  }
  return vertices;
}

namespace {

Face placed_face(ObjDocument document, const PhotographSource& source) {
  Face face{{}, std::move(document), source.lps_from_photograph, true};
  face.mesh = face.document.mesh();
  face.mesh.surface.vertices = moved(face.mesh.surface.vertices, face.lps_from_file);
  check_size(face.mesh.surface.vertices, source.obj);
  return face;
}

}  // namespace

Face photograph_face(const PhotographSource& source, Progress& progress) {
  return placed_face(read_scan(source.obj, progress), source);
}

std::vector<Eigen::Vector3d> Anatomy::pivots() const {
  std::vector<Eigen::Vector3d> points;
  for (const BoneSegment& segment : segments) points.push_back(segment.pivot);
  return points;
}

std::vector<RigidMotion> planned_motions(const SurgicalCase& plan, const Anatomy& anatomy) {
  std::vector<RigidMotion> motions;
  for (std::size_t s = 0; s < anatomy.segments.size(); ++s) {
    motions.push_back(rigid_motion(plan.segments[s].motion, anatomy.segments[s].pivot));
  }
  return motions;
}

namespace {

/// What a known anatomy has in common with a plan. Each pointer is null where nothing is known.
struct Common {
  const Anatomy* ct = nullptr;
  const Anatomy* bone = nullptr;
  const Face* skin = nullptr;        ///< as the face
  const Face* photograph = nullptr;  ///< of the same file, wherever it was placed
  std::size_t cuts = 0;              ///< the first ones
};

/// How many of the plan's first cuts are those of the known segments.
std::size_t common_cuts(const SurgicalCase& plan, const KnownAnatomy& known) {
  const std::vector<BoneSegment>& segments = known.anatomy.segments;
  if (known.anatomy.left_by_cut.size() + 1 < segments.size()) return 0;
  const std::size_t most = std::min(plan.segments.size(), segments.size());
  std::size_t count = 0;
  while (count < most && plan.segments[count].cut == known.plan.segments[count].cut) ++count;
  return count;
}

Common common_with(const SurgicalCase& plan, const KnownAnatomy* known) {
  Common common;
  if (known == nullptr) return common;
  const Face& face = known->anatomy.face;
  const bool same_ct = known->anatomy.ct != nullptr && known->plan.ct == plan.ct;
  if (same_ct) common.ct = &known->anatomy;
  if (same_ct && known->plan.bone == plan.bone) {
    common.bone = &known->anatomy;
    common.cuts = common_cuts(plan, *known);
  }
  if (same_ct && known->plan.skin == plan.skin && !face.is_photograph) common.skin = &face;
  if (face.is_photograph && plan.photograph && known->plan.photograph &&
      known->plan.photograph->obj == plan.photograph->obj) {
    common.photograph = &face;
  }
  return common;
}

Face photograph_of(const PhotographSource& source, const Face* known, Progress& progress) {
  if (known != nullptr) {
    return known->lps_from_file == source.lps_from_photograph
               ? *known
               : placed_face(known->document, source);
  }
  const auto stage = progress.stage("read photograph");
  return photograph_face(source, progress);
}

void add_segment(const PlannedSegment& plan, TriangleMesh mesh, double volume_mm3,
                 Anatomy& anatomy) {
  const Eigen::Vector3d pivot = plan.pivot ? *plan.pivot : centre_of_volume(mesh);
  anatomy.segments.push_back({plan.name, std::move(mesh), volume_mm3, pivot});
}

/// The first `count` cuts as they are known, names and pivots from the plan.
void take_segments(const std::vector<PlannedSegment>& planned, const Anatomy& known,
                   std::size_t count, Anatomy& anatomy) {
  for (std::size_t s = 0; s < count; ++s) {
    add_segment(planned[s], known.segments[s].mesh, known.segments[s].volume_mm3, anatomy);
    if (s > 0) anatomy.left_by_cut.push_back(known.left_by_cut[s - 1]);
  }
  if (count == 0) {
    anatomy.remainder = anatomy.bone;
  } else {
    anatomy.remainder =
        count == known.segments.size() ? known.remainder : *known.left_by_cut[count - 1];
  }
}

/// What the preview of a cut refuses is refused wherever it is made.
void require_allowed(const PlannedSegment& planned, const TriangleMesh& bone) {
  const std::optional<Error> refusal = CutPreviewer(bone).preview(planned.cut).refusal;
  if (!refusal) return;
  throw Error(refusal->kind(), planned.name, refusal->problem(), refusal->remedy());
}

/// Cuts the segments that the anatomy has not yet one after the other, each from what the ones
/// before have left.
void cut_segments(const std::vector<PlannedSegment>& planned, Anatomy& anatomy,
                  Progress& progress) {
  for (std::size_t s = anatomy.segments.size(); s < planned.size(); ++s) {
    require_allowed(planned[s], anatomy.remainder);
    SegmentResult cut = cut_segment(anatomy.remainder, planned[s].cut, {}, progress);
    if (s > 0) {
      anatomy.left_by_cut.push_back(
          std::make_shared<const TriangleMesh>(std::move(anatomy.remainder)));
    }
    add_segment(planned[s], std::move(cut.segment), cut.volume_mm3, anatomy);
    anatomy.remainder = std::move(cut.remainder);
  }
}

}  // namespace

Anatomy build_anatomy(const SurgicalCase& plan, Progress& progress, const KnownAnatomy* known) {
  progress.check();
  const Common common = common_with(plan, known);
  // The photograph first: it is read in a moment, and a mistake in it should not cost a CT.
  std::optional<Face> face;
  if (plan.photograph) face = photograph_of(*plan.photograph, common.photograph, progress);
  if (!plan.photograph && common.skin != nullptr) face = *common.skin;
  const auto ct =
      common.ct != nullptr
          ? common.ct->ct
          : std::make_shared<const CtVolume>(read_ct(plan.ct.path, plan.ct.series_uid, progress));
  // Hash, skin and bone do not depend on each other. A future's destructor waits for its thread.
  std::future<std::string> hash;
  if (common.ct == nullptr) {
    hash = std::async(std::launch::async, [&] { return sha256_of(plan.ct.path); });
  }
  std::future<TriangleMesh> skin;
  if (!face) {
    skin = std::async(std::launch::async, [&] { return skin_surface(*ct, plan.skin, progress); });
  }
  Anatomy anatomy;
  anatomy.ct = ct;
  anatomy.bone =
      common.bone != nullptr ? common.bone->bone : bone_surface(*ct, plan.bone, progress);
  if (common.bone != nullptr) {
    take_segments(plan.segments, *common.bone, common.cuts, anatomy);
  } else {
    anatomy.remainder = anatomy.bone;
  }
  cut_segments(plan.segments, anatomy, progress);
  anatomy.face = face ? std::move(*face) : skin_face(skin.get());
  anatomy.ct_sha256 = common.ct != nullptr ? common.ct->ct_sha256 : hash.get();
  return anatomy;
}

}  // namespace gnathion
