#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <string>

#include "geometry/triangle_mesh.h"
#include "imaging/surfaces.h"
#include "phantom/head_model.h"
#include "phantom/head_phantom.h"
#include "phantom/phantom_ct.h"
#include "phantom/phantom_photograph.h"
#include "phantom/repeatable_random.h"
#include "registration/landmark_fit.h"
#include "support/solids.h"

namespace gnathion::test {

/// The analytic head's skin as the program takes it from its CT, LPS mm.
inline TriangleMesh head_skin(const PhantomOptions& options) {
  Progress progress;
  PhantomVolume volume = make_phantom_volume(HeadModel(), options, progress);
  Eigen::Matrix4d lps_from_ijk = Eigen::Matrix4d::Identity();
  lps_from_ijk.topLeftCorner<3, 3>() = volume.spacing.asDiagonal();
  lps_from_ijk.topRightCorner<3, 1>() = volume.origin;
  const CtVolume ct(volume.size, std::move(volume.hounsfield), lps_from_ijk, "analytic head");
  return skin_surface(ct, {}, progress);
}

/// The analytic head's photograph as triangles, LPS mm.
inline TriangleMesh head_photograph(const PhantomOptions& options) {
  Progress progress;
  const PhantomPhotograph photograph = make_phantom_photograph(HeadModel(), options, progress);
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<Eigen::Index>(photograph.kept.size()), 3);
  for (std::size_t v = 0; v < photograph.kept.size(); ++v) {
    mesh.vertices.row(static_cast<Eigen::Index>(v)) = photograph.grid.row(photograph.kept[v]);
  }
  std::vector<Eigen::RowVector3i> triangles;
  for (const std::vector<int>& face : photograph.faces) {
    for (std::size_t c = 2; c < face.size(); ++c)
      triangles.emplace_back(face[0], face[c - 1], face[c]);
  }
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    mesh.triangles.row(static_cast<Eigen::Index>(f)) = triangles[f];
  }
  return mesh;
}

/// How thick hair stands at a point of the analytic head's skin, mm: a fringe over the forehead,
/// more above and behind.
inline double hair_mm(const Eigen::Vector3d& p) {
  const double above = std::min(1.0, std::max(0.0, (p.z() - 68) / 15));
  const double behind = p.z() > -60 ? std::min(1.0, std::max(0.0, (p.y() - 12) / 15)) : 0;
  const double locks = 6 + 22 * lattice_noise(p.x() / 18, p.y() / 18, p.z() / 18, 7);
  return std::max(above, behind) * locks;
}

/// A scan as a camera booth gives it, LPS mm: the photograph's face under a fringe, hair about the
/// rest of the head, a neck, and the shoulders, of which the CT knows nothing.
inline TriangleMesh dressed_head(const TriangleMesh& photograph, const TriangleMesh& skin) {
  TriangleMesh face = photograph;
  const Points face_normals = vertex_normals(face);
  for (Eigen::Index v = 0; v < face.vertices.rows(); ++v) {
    face.vertices.row(v) += hair_mm(face.vertices.row(v)) * face_normals.row(v);
  }
  std::vector<bool> covered(static_cast<std::size_t>(skin.triangles.rows()));
  for (Eigen::Index f = 0; f < skin.triangles.rows(); ++f) {
    covered[static_cast<std::size_t>(f)] = hair_mm(skin.vertices.row(skin.triangles(f, 0))) > 2 &&
                                           skin.vertices(skin.triangles(f, 0), 1) > -40;
  }
  TriangleMesh hair = sub_mesh(skin, covered).mesh;
  const Points normals = vertex_normals(hair);
  for (Eigen::Index v = 0; v < hair.vertices.rows(); ++v) {
    hair.vertices.row(v) += hair_mm(hair.vertices.row(v)) * normals.row(v);
  }
  TriangleMesh shoulders = sphere({0, 0, 0}, 1, 6);
  for (Eigen::Index v = 0; v < shoulders.vertices.rows(); ++v) {
    const Eigen::Vector3d u = shoulders.vertices.row(v);
    shoulders.vertices.row(v) << 225 * u.x(), 25 + 105 * u.y(), -300 + 140 * u.z();
  }
  std::vector<bool> upper(static_cast<std::size_t>(shoulders.triangles.rows()));
  for (std::size_t f = 0; f < upper.size(); ++f) {
    upper[f] = shoulders.vertices(shoulders.triangles(static_cast<Eigen::Index>(f), 0), 2) > -310;
  }
  return joined(joined(face, hair), sub_mesh(shoulders, upper).mesh);
}

/// A scan whose place is known.
struct KnownScan {
  TriangleMesh mesh;               ///< in its own frame and unit
  Similarity lps_from_photograph;  ///< the truth
};

struct ScanFaults {
  double noise_mm = 0.5;  ///< standard deviation of each coordinate
  double outliers = 0.2;  ///< of the vertices are thrown up to outlier_mm away
  double outlier_mm = 30;
  double away_mm = 100;  ///< each coordinate of its place, at most
  double mm_per_unit = 1;
};

/// A scan (LPS mm) with faults, turned anyhow and put anywhere; the seed decides.
inline KnownScan misplaced(const TriangleMesh& scan, const ScanFaults& faults, unsigned seed) {
  const std::uint64_t key = static_cast<std::uint64_t>(seed) << 32;
  const auto random = [&](std::uint64_t i) { return 2 * uniform(key + i) - 1; };
  KnownScan known{scan, {}};
  for (Eigen::Index v = 0; v < scan.vertices.rows(); ++v) {
    const std::uint64_t at = 1000 + 10 * static_cast<std::uint64_t>(v);
    for (unsigned c = 0; c < 3; ++c) {
      known.mesh.vertices(v, c) += faults.noise_mm * normal(key + at + c);
      if (uniform(key + at + 9) < faults.outliers) {
        known.mesh.vertices(v, c) += faults.outlier_mm * random(at + 3 + c);
      }
    }
  }
  Similarity& s = known.lps_from_photograph;
  s.scale = faults.mm_per_unit;
  s.rotation =
      Eigen::Quaterniond(normal(key + 1), normal(key + 2), normal(key + 3), normal(key + 4))
          .normalized()
          .toRotationMatrix();
  s.translation = faults.away_mm * Eigen::Vector3d(random(5), random(6), random(7));
  known.mesh.vertices =
      ((known.mesh.vertices.rowwise() - s.translation.transpose()) * s.rotation) / s.scale;
  return known;
}

/// The face's landmarks of the analytic head, where they are in the scan and on the CT.
inline std::vector<LandmarkPair> head_landmarks(const Similarity& lps_from_photograph) {
  std::vector<LandmarkPair> pairs;
  const std::map<std::string, Eigen::Vector3d> all = phantom_truth().landmarks;
  for (const char* name : {"nasion_soft", "nose_tip", "subnasale", "stomion", "mouth_corner_left",
                           "mouth_corner_right", "pogonion_soft", "menton_soft"}) {
    const Eigen::Vector3d lps = all.at(name);
    pairs.push_back(
        {name, lps_from_photograph.displacement_to_source(lps - lps_from_photograph.translation),
         lps});
  }
  return pairs;
}

}  // namespace gnathion::test
