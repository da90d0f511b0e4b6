#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <random>
#include <utility>

#include "bench/hard_cases.h"
#include "geometry/tet_quality.h"
#include "prediction/answer.h"
#include "support/head_scene.h"
#include "support/temporary_folder.h"

namespace gnathion::bench {
namespace {

using test::head_scene;

const RegionChoice kAround{40, {}, false, {}};

FaceModel model_of(const Anatomy& head, const RegionChoice& region = kAround,
                   const TissueModel& tissue = {}) {
  Progress progress;
  return FaceModel(head, region, tissue, progress);
}

/// 5 mm forward, 3 mm down.
RigidMotion chin_forward() {
  RigidMotion motion;
  motion.translation << 0, -5, -3;
  return motion;
}

/// How the vertices of the face move, n×3, mm.
Points moves(const Anatomy& head, const RegionChoice& region = kAround) {
  const RigidMotion motion = chin_forward();
  Points points;
  model_of(head, region).predict({&motion, 1}, points);
  return points - head.face.mesh.surface.vertices;
}

double largest(const Points& u) {
  return u.rowwise().norm().maxCoeff();
}

/// Vertices of the head's face between two distances from a point, mm.
std::vector<int> vertices_between(const Anatomy& head, const Eigen::Vector3d& from, double near,
                                  double far) {
  const Points& x = head.face.mesh.surface.vertices;
  std::vector<int> found;
  for (int v = 0; v < x.rows(); ++v) {
    const double distance = (x.row(v).transpose() - from).norm();
    if (distance >= near && distance < far) found.push_back(v);
  }
  return found;
}

RegionChoice chosen(std::vector<int> vertices) {
  return {0, std::move(vertices), false, {}};
}

/// The three vertices of the triangle over the segment.
std::vector<int> one_triangle(const Anatomy& head) {
  const TriangleMesh& skin = head.face.mesh.surface;
  Eigen::Index nearest = 0;
  (skin.vertices.rowwise() - test::head_chin.transpose()).rowwise().norm().minCoeff(&nearest);
  for (const auto t : skin.triangles.rowwise()) {
    if ((t.array() == static_cast<int>(nearest)).any()) return {t[0], t[1], t[2]};
  }
  return {};
}

/// A region with a hole over the bone, both its rims held: both must stay, what is between moves.
HardOutcome ring() {
  const Anatomy head = head_scene();
  const RegionChoice region = chosen(vertices_between(head, test::head_chin, 7, 45));
  const RigidMotion motion = chin_forward();
  const FaceModel model = model_of(head, region);
  Points points;
  model.predict({&motion, 1}, points);
  const Points u = points - head.face.mesh.surface.vertices;
  double rim = 0;
  const TissueProblem& problem = model.problem();
  for (std::size_t v = 0; v < problem.face_vertices.size(); ++v) {
    if (problem.region.rim[v]) rim = std::max(rim, u.row(problem.face_vertices[v]).norm());
  }
  const long inverted = tet_quality(problem.tissue.mesh).inverted;
  char text[100];
  std::snprintf(text, sizeof text, "rims move %.1g mm, skin %.2f mm, %ld tets inverted", rim,
                largest(u), inverted);
  return {text, rim == 0 && inverted == 0 && largest(u) > 0.5 && largest(u) < 6};
}

Anatomy shifted_head(const Eigen::Vector3d& by) {
  Anatomy head = head_scene();
  const auto shift = [&](TriangleMesh& mesh) { mesh.vertices.rowwise() += by.transpose(); };
  TriangleMesh skin = head.face.mesh.surface;
  shift(skin);
  head.face = test::face_of(skin);
  for (BoneSegment& segment : head.segments) {
    shift(segment.mesh);
    segment.pivot += by;
  }
  shift(head.remainder);
  shift(head.bone);
  return head;
}

/// The head with its face's vertices and triangles in another order, and how the vertices then
/// move, in the order before.
Points moves_of_shuffled_face() {
  Anatomy head = head_scene();
  const TriangleMesh& skin = head.face.mesh.surface;
  std::mt19937 random(3);
  std::vector<int> place(static_cast<std::size_t>(skin.vertices.rows()));
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  std::vector<int> triangles(static_cast<std::size_t>(skin.triangles.rows()));
  std::iota(triangles.begin(), triangles.end(), 0);
  std::shuffle(triangles.begin(), triangles.end(), random);
  TriangleMesh shuffled = skin;
  for (int v = 0; v < skin.vertices.rows(); ++v) {
    shuffled.vertices.row(place[v]) = skin.vertices.row(v);
  }
  for (int f = 0; f < skin.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) shuffled.triangles(triangles[f], k) = place[skin.triangles(f, k)];
  }
  head.face = test::face_of(shuffled);
  return moves(head)(place, Eigen::all);
}

/// Every triangle with three vertices of its own: each point several times.
Points moves_of_split_face() {
  Anatomy head = head_scene();
  const TriangleMesh skin = head.face.mesh.surface;
  TriangleMesh soup{Points(3 * skin.triangles.rows(), 3), Triangles(skin.triangles.rows(), 3)};
  std::vector<int> copy(static_cast<std::size_t>(skin.vertices.rows()));
  for (int f = 0; f < skin.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      soup.vertices.row(3 * f + k) = skin.vertices.row(skin.triangles(f, k));
      soup.triangles(f, k) = 3 * f + k;
    }
  }
  head.face = test::face_of(soup);
  const Triangles& welded = head.face.mesh.surface.triangles;
  for (int f = 0; f < skin.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) copy[skin.triangles(f, k)] = welded(f, k);
  }
  return moves(head)(copy, Eigen::all);
}

/// The head with a triangle of three points on one line over the segment, and how its other
/// vertices move.
Points moves_with_collinear_points() {
  Anatomy head = head_scene();
  TriangleMesh skin = head.face.mesh.surface;
  const Eigen::Index n = skin.vertices.rows(), m = skin.triangles.rows();
  const std::vector<int> corners = one_triangle(head);
  Eigen::Index at = 0;
  for (Eigen::Index f = 0; f < m; ++f) {
    if (skin.triangles(f, 0) == corners[0] && skin.triangles(f, 1) == corners[1]) at = f;
  }
  const Eigen::RowVector3i t = skin.triangles.row(at);
  const int middle = static_cast<int>(n);
  skin.vertices.conservativeResize(n + 1, 3);
  skin.vertices.row(n) = (skin.vertices.row(t[0]) + skin.vertices.row(t[1])) / 2;
  skin.triangles.conservativeResize(m + 2, 3);
  skin.triangles.row(at) << t[0], middle, t[2];
  skin.triangles.row(m) << middle, t[1], t[2];
  skin.triangles.row(m + 1) << t[0], t[1], middle;
  head.face = test::face_of(skin);
  return moves(head).topRows(n);
}

void read_face_with(const std::string& coordinate) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "face.obj";
  std::ofstream(file) << "v 0 0 0\nv 100 0 " << coordinate << "\nv 0 100 0\nf 1 2 3\n";
  ObjDocument::read(file);
}

void add_regions(std::vector<HardCase>& all) {
  using enum ErrorKind;
  all.push_back(refused("region of one triangle", anatomy, "region", "nothing would move", [] {
    const Anatomy head = head_scene();
    model_of(head, chosen(one_triangle(head)));
  }));
  all.push_back({"ring-shaped region, its hole over the bone",
                 "rims move 0, skin between 0.5 and 6 mm, no tet inverted", ring});
  all.push_back(refused("region in two pieces", anatomy, "region", "2 pieces", [] {
    const Anatomy head = head_scene();
    std::vector<int> both = vertices_between(head, test::head_chin, 0, 25);
    for (const int v : vertices_between(head, {0, 80, 0}, 0, 25)) both.push_back(v);
    model_of(head, chosen(both));
  }));
  all.push_back(refused("region without a rim", anatomy, "region", "no rim", [] {
    const Anatomy head = head_scene();
    model_of(head, chosen(vertices_between(head, {0, 0, 0}, 0, 1000)));
  }));
  all.push_back(refused("no driven point: region at the back of the head", anatomy, "region",
                        "nothing would move", [] {
                          const Anatomy head = head_scene();
                          model_of(head, chosen(vertices_between(head, {0, 80, 0}, 0, 30)));
                        }));
  all.push_back(refused("mesh edges of 60 mm on a region of 80 mm", anatomy, "region",
                        "triangles are left", [] {
                          TissueModel tissue;
                          tissue.edge_mm = 60;
                          model_of(head_scene(), kAround, tissue);
                        }));
}

void add_points(std::vector<HardCase>& all) {
  all.push_back(refused("a NaN in the photograph", ErrorKind::input, "face.obj",
                        "not a finite number", [] { read_face_with("nan"); }));
  all.push_back(refused("1e400 in the photograph", ErrorKind::input, "face.obj",
                        "not a finite number", [] { read_face_with("1e400"); }));
  all.push_back(bounded("every point of the face as often as it has triangles",
                        "distance to the answer without", 1e-9, "mm",
                        [] { return largest(moves_of_split_face() - moves(head_scene())); }));
  all.push_back(
      bounded("a triangle of three points on a line", "distance to the answer without", 0.1, "mm",
              [] { return largest(moves_with_collinear_points() - moves(head_scene())); }));
  all.push_back(bounded(
      "head 1e6 mm from the origin", "distance to the answer at the origin", 0.02, "mm", [] {
        return largest(moves(shifted_head({1e6, -1e6, 1e6})) - moves(head_scene()));
      }));
  all.push_back(bounded("order of the face's vertices and triangles shuffled",
                        "distance to the answer in order", 0.01, "mm",
                        [] { return largest(moves_of_shuffled_face() - moves(head_scene())); }));
  all.push_back(
      bounded("motion of 1e-9 mm of the whole model", "distance to 1e-9 of 1 mm", 1e-15, "mm", [] {
        const FaceModel model = model_of(head_scene());
        RigidMotion one, tiny;
        one.translation << 0, -1, 0;
        tiny.translation = 1e-9 * one.translation;
        return largest(model.tissue_displacements({&tiny, 1}) -
                       1e-9 * model.tissue_displacements({&one, 1}));
      }));
}

}  // namespace

std::vector<HardCase> hard_scenes() {
  std::vector<HardCase> all;
  add_regions(all);
  add_points(all);
  return all;
}

}  // namespace gnathion::bench
