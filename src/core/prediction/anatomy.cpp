#include "prediction/anatomy.h"

#include <future>
#include <iomanip>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "geometry/triangle_mesh.h"
#include "imaging/ct_import.h"
#include "io/files.h"

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

Face photograph_face(const PhotographSource& source) {
  Face face{{}, ObjDocument::read(source.obj), source.lps_from_photograph, true};
  face.mesh = face.document.mesh();
  face.mesh.surface.vertices = moved(face.mesh.surface.vertices, face.lps_from_file);
  check_size(face.mesh.surface.vertices, source.obj);
  return face;
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

/// Cuts the segments one after the other, each from what the ones before have left.
void cut_segments(const std::vector<PlannedSegment>& planned, Anatomy& anatomy,
                  Progress& progress) {
  anatomy.remainder = anatomy.bone;
  for (const PlannedSegment& plan : planned) {
    SegmentResult cut = cut_segment(anatomy.remainder, plan.cut, {}, progress);
    const Eigen::Vector3d pivot = plan.pivot.value_or(centre_of_volume(cut.segment));
    anatomy.segments.push_back({plan.name, std::move(cut.segment), cut.volume_mm3, pivot});
    anatomy.remainder = std::move(cut.remainder);
  }
}

}  // namespace

Anatomy build_anatomy(const SurgicalCase& plan, Progress& progress, const KnownAnatomy*) {
  // The photograph first: it is read in a moment, and a mistake in it should not cost a CT.
  std::optional<Face> face;
  if (plan.photograph) {
    const auto stage = progress.stage("read photograph");
    face = photograph_face(*plan.photograph);
  }
  const auto ct =
      std::make_shared<const CtVolume>(read_ct(plan.ct.path, plan.ct.series_uid, progress));
  std::future<std::string> hash =
      std::async(std::launch::async, [&] { return sha256_of(plan.ct.path); });
  // Skin and bone do not depend on each other. The future's destructor waits for its thread.
  std::future<TriangleMesh> skin;
  if (!face) {
    skin = std::async(std::launch::async, [&] { return skin_surface(*ct, plan.skin, progress); });
  }
  Anatomy anatomy{ct, bone_surface(*ct, plan.bone, progress), {}, {}, {}, {}};
  cut_segments(plan.segments, anatomy, progress);
  anatomy.face = face ? std::move(*face) : skin_face(skin.get());
  anatomy.ct_sha256 = hash.get();
  return anatomy;
}

}  // namespace gnathion
