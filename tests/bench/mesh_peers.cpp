#include "bench/mesh_peers.h"

#include <array>
#include <utility>

#include "bench/tetgen.h"
#include "bench/timing.h"
#include "geometry/tet_quality.h"
#include "geometry/triangle_mesh.h"
#include "io/case_file.h"
#include "prediction/tissue_problem.h"
#include "support/face_patch.h"
#include "tissue/st_generator.h"

namespace gnathion::bench {
namespace {

constexpr int kTetgenLimit = 120;  // s

/// One mesh of some tissue.
struct Candidate {
  std::string scene, generator;
  TetMesh mesh;
  double seconds = 0;
  std::string failure;
  int colour = 0;
};

/// The three measures of the paper's Fig. 5.
struct Shape {
  Series aspect, face, dihedral;
};

template <class Matrix>
std::vector<double> as_vector(const Matrix& values) {
  return {values.data(), values.data() + values.size()};
}

Shape shape_of(const Candidate& c) {
  return {histogram(c.generator, as_vector(aspect_ratios(c.mesh)), 1, 13, 48, c.colour),
          histogram(c.generator, as_vector(face_angles(c.mesh)), 0, 180, 60, c.colour),
          histogram(c.generator, as_vector(dihedral_angles(c.mesh)), 0, 180, 60, c.colour)};
}

/// TetGen on the boundary of the same tissue: with the skin's triangles kept, and free to split
/// them.
void add_tetgen(const std::string& scene, const TetMesh& tissue, std::vector<Candidate>& all) {
  const TriangleMesh surface = boundary_surface(tissue);
  int colour = 3;
  for (const auto& [switches, name] : {std::pair{"pqY", "TetGen -pqY (surface kept)"},
                                       std::pair{"pq", "TetGen -pq (surface split)"}}) {
    TetgenResult result = run_tetgen(surface, switches, kTetgenLimit);
    all.push_back({scene, name, std::move(result.mesh), result.seconds, result.failure, colour});
    colour = 1;
  }
}

std::vector<Candidate> of_patch(const std::string& scene, const TriangleMesh& skin, double depth) {
  const IntermediateMesh region = testing::whole_region(skin);
  const Eigen::VectorXd depths = Eigen::VectorXd::Constant(skin.vertices.rows(), depth);
  std::vector<Candidate> all;
  const auto add = [&](const std::string& name, int colour, const auto& generate) {
    SoftTissueMesh tissue;
    const double time = median_seconds(5, [&] { tissue = generate(); });
    all.push_back({scene, name, std::move(tissue.mesh), time, {}, colour});
  };
  add("ST, the paper's", 4, [&] { return st_generator_paper(region, depth); });
  add("ST, one layer", 5,
      [&] { return st_generator(region, offset_directions(region, depth), depths); });
  RobustGeneratorOptions layered;
  layered.layers = {};
  add("ST, layers", 0,
      [&] { return st_generator(region, offset_directions(region, depth), depths, layered); });
  const TetMesh tissue = all[1].mesh;
  add_tetgen(scene, tissue, all);
  return all;
}

std::vector<Candidate> of_case(const std::string& path) {
  SurgicalCase plan = read_case_file(path);
  Progress progress;
  const Anatomy anatomy = build_anatomy(plan, progress);
  std::vector<Candidate> all;
  for (const auto& [name, layer_edges, colour] :
       {std::tuple{"ST, one layer", 0.0, 5}, std::tuple{"ST, layers", 1.0, 0}}) {
    plan.tissue.layer_edges = layer_edges;
    Progress stages;
    SoftTissueMesh tissue = build_tissue(anatomy, plan.region, plan.tissue, stages).tissue;
    double time = 0;
    for (const StageTime& stage : stages.stage_times()) {
      if (stage.name.find("mesh") != std::string::npos) time += stage.seconds;
    }
    all.push_back(
        {plan.name.substr(0, plan.name.find(',')), name, std::move(tissue.mesh), time, {}, colour});
  }
  const TetMesh tissue = all[0].mesh;
  add_tetgen(plan.name, tissue, all);
  return all;
}

std::vector<Table::Cell> row_of(const Candidate& c) {
  if (!c.failure.empty()) {
    std::vector<Table::Cell> row{c.scene, c.generator, c.failure, c.seconds};
    row.insert(row.end(), 7, std::string());
    return row;
  }
  const TetQuality quality = tet_quality(c.mesh);
  const Shape shape = shape_of(c);
  return {c.scene,
          c.generator,
          static_cast<double>(quality.count),
          c.seconds,
          static_cast<double>(c.mesh.vertices.rows()),
          static_cast<double>(quality.inverted),
          peak(shape.dihedral),
          peak(shape.face),
          peak(shape.aspect),
          quality.median_aspect,
          quality.smallest_dihedral};
}

/// A row of three plots a scene.
void add_plots(const std::vector<Candidate>& all, std::vector<Plot>& plots) {
  std::array<Plot, 3> row{Plot{all[0].scene, {"aspect ratio (1: regular)"}, {"% of tets"}},
                          Plot{all[0].scene, {"face angle, degrees"}, {"% of angles"}},
                          Plot{all[0].scene, {"dihedral angle, degrees"}, {"% of angles"}}};
  for (const Candidate& c : all) {
    if (!c.failure.empty()) continue;
    Shape shape = shape_of(c);
    row[0].series.push_back(std::move(shape.aspect));
    row[1].series.push_back(std::move(shape.face));
    row[2].series.push_back(std::move(shape.dihedral));
  }
  plots.insert(plots.end(), row.begin(), row.end());
}

}  // namespace

void report_mesh_peers(const Report& report, const std::vector<std::string>& cases) {
  report.heading("ST Generator beside TetGen (the paper's Fig. 5)");
  report.say(
      "The same tissue: TetGen fills the closed boundary of the one-layer mesh. Its time is of the "
      "whole program, which reads and writes text. Peaks are the middles of the fullest bins: 3 "
      "degrees, 0.25 of aspect ratio (longest edge over shortest height, 1 for a regular tet).");
  std::vector<std::vector<Candidate>> scenes{of_patch("p1, 1.5 mm thick", testing::patch_p1(), 1.5),
                                             of_patch("p1, 5 mm thick", testing::patch_p1(), 5),
                                             of_patch("p2, 5 mm thick", testing::patch_p2(), 5)};
  for (const std::string& path : cases) scenes.push_back(of_case(path));
  Table table({"tissue", "generator", "tets", "seconds", "nodes", "inverted", "dihedral peak, °",
               "face angle peak, °", "aspect peak", "median aspect", "smallest dihedral, °"});
  std::vector<Plot> plots;
  for (const auto& all : scenes) {
    for (const Candidate& c : all) table.add(row_of(c));
    add_plots(all, plots);
  }
  report.table("mesh-peers", table);
  report.figure("mesh-peers", "Shape of tetrahedra: ST Generator and TetGen", plots, 3);
}

}  // namespace gnathion::bench
