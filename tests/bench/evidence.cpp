// Prints the figures of docs/evidence.md as Markdown tables: `./run evidence`.
//   gnathion-evidence [CASE.json …]    the cases, e.g. the embedded one and the real CT
//   gnathion-evidence --lips CASE.json …    only what cutting the lips apart changes
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "bench/calculix_run.h"
#include "bench/chin_problem.h"
#include "bench/ray_trees.h"
#include "bench/timing.h"
#include "fem/response_basis.h"
#include "geometry/tet_quality.h"
#include "io/case_file.h"
#include "prediction/report.h"
#include "support/face_patch.h"
#include "tissue/bone_map.h"
#include "tissue/lip_line.h"
#include "tissue/st_generator.h"

namespace {

using namespace gnathion;
namespace fs = std::filesystem;
using bench::median;
using bench::median_seconds;
using bench::seconds;
using testing::whole_region;

std::string ms(double s) {
  char text[32];
  std::snprintf(text, sizeof text, s < 1e-3 ? "%.3f" : s < 0.1 ? "%.1f" : "%.0f", s * 1e3);
  return text;
}

void heading(const std::string& text) {
  std::cout << "\n### " << text << "\n\n";
}

void print_element_counts() {
  heading("Element counts (paper, Table 1)");
  std::cout << "| patch | V | F | tets, paper's mode | tets, robust mode | paper |\n"
               "|---|---|---|---|---|---|\n";
  const auto row = [](const char* name, const TriangleMesh& mesh, int expected) {
    const IntermediateMesh region = whole_region(mesh);
    const Eigen::VectorXd depth = Eigen::VectorXd::Constant(mesh.vertices.rows(), 5);
    std::cout << "| " << name << " | " << mesh.vertices.rows() << " | " << mesh.triangles.rows()
              << " | " << st_generator_paper(region, 5).mesh.tets.rows() << " | "
              << st_generator(region, offset_directions(region, 5), depth).mesh.tets.rows() << " | "
              << expected << " |\n";
  };
  row("p1", testing::patch_p1(), 22841);
  row("p2", testing::patch_p2(), 50911);
}

void print_hard_patches() {
  heading("Inverted tets on hard patches (edge 2.2 mm, depth 5 mm, 12 of each kind)");
  std::cout
      << "| kind | paper's mode: clean patches | inverted tets | robust mode: clean patches | "
         "inverted tets | mean depth kept |\n|---|---|---|---|---|---|\n";
  const char* names[] = {"nose", "lips", "groove", "random"};
  for (int kind = 0; kind < 4; ++kind) {
    int clean_paper = 0, clean_robust = 0;
    long inverted_paper = 0, inverted_robust = 0, tets = 0;
    double depth = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
      const IntermediateMesh region = whole_region(testing::hard_patch(kind, seed));
      const TetQuality paper = tet_quality(st_generator_paper(region, 5).mesh);
      const SoftTissueMesh tissue =
          st_generator(region, offset_directions(region, 5),
                       Eigen::VectorXd::Constant(region.mesh.vertices.rows(), 5));
      const TetQuality robust = tet_quality(tissue.mesh);
      clean_paper += paper.inverted == 0;
      clean_robust += robust.inverted == 0;
      inverted_paper += paper.inverted;
      inverted_robust += robust.inverted;
      tets += paper.count;
      depth += tissue.depth.mean() / 12;
    }
    std::cout << "| " << names[kind] << " | " << clean_paper << " of 12 | "
              << 100.0 * double(inverted_paper) / double(tets) << " % | " << clean_robust
              << " of 12 | " << inverted_robust << " | " << depth << " of 5 mm |\n";
  }
}

struct PatchTimes {
  double st, assemble, factor, solve, total, basis, frame, ccx;
  double basis_error, ccx_error;
};

PatchTimes measure_patch(const TriangleMesh& mesh) {
  const bench::ChinProblem p = bench::chin_problem(mesh);
  const Points& x = p.tissue.mesh.vertices;
  const Points none = Points::Zero(x.rows(), 3);
  const RigidMotion motion = bench::chin_motion(p);
  const Points prescribed = moved(x, motion) - x;
  PatchTimes t{};
  t.ccx = t.ccx_error = std::nan("");
  t.st = median_seconds(15, [&] { st_generator(p.region, p.directions, p.depth); });
  std::vector<double> assemble, factor, solve, total;
  StaticSolution direct;
  for (int run = 0; run < 5; ++run) {
    Progress progress;
    total.push_back(seconds([&] {
      const StaticSolver solver(p.tissue.mesh, {}, p.supports, progress);
      solve.push_back(seconds([&] { direct = solver.solve(prescribed, none); }));
    }));
    for (const StageTime& stage : progress.stage_times()) {
      (stage.name == "factorise" ? factor : assemble).push_back(stage.seconds);
    }
  }
  t.assemble = median(assemble);
  t.factor = median(factor);
  t.solve = median(solve);
  t.total = median(total);
  Progress progress;
  const StaticSolver solver(p.tissue.mesh, {}, p.supports, progress);
  ResponseBasis basis;
  t.basis = median_seconds(3, [&] { basis = response_basis(solver, {p.centre}); });
  const ResponseBasis surface(basis.columns().topRows(3 * p.tissue.surface_count), {p.centre});
  Points u;
  surface.displacements({&motion, 1}, u);
  t.frame = median_seconds(2001, [&] { surface.displacements({&motion, 1}, u); });
  basis.displacements({&motion, 1}, u);
  t.basis_error = (u - direct.displacements).norm() / direct.displacements.norm();
  if (const auto ccx = bench::run_calculix({p.tissue.mesh, {}, p.supports, prescribed})) {
    t.ccx = ccx->cost.wall;
    t.ccx_error = (ccx->displacements - direct.displacements).cwiseAbs().maxCoeff() /
                  direct.displacements.cwiseAbs().maxCoeff();
  }
  return t;
}

void print_patch_times() {
  heading("Time per stage on patches of the paper's sizes (milliseconds, medians)");
  const PatchTimes a = measure_patch(testing::patch_p1()), b = measure_patch(testing::patch_p2());
  std::cout << "| stage | p1 | p2 | prototype p1 / p2 | goal |\n|---|---|---|---|---|\n";
  const auto row = [&](const char* name, double PatchTimes::*m, const char* prototype,
                       const char* goal) {
    std::cout << "| " << name << " | " << ms(a.*m) << " | " << ms(b.*m) << " | " << prototype
              << " | " << goal << " |\n";
  };
  row("ST Generator, robust", &PatchTimes::st, "1.3 / 2.3", "5");
  row("assembly", &PatchTimes::assemble, "30 / 70", "");
  row("ordering + factor", &PatchTimes::factor, "80 / 210 (factor alone)", "");
  row("one solve, checked", &PatchTimes::solve, "6 / 16 (unchecked)", "");
  row("mesh → displacement", &PatchTimes::total, "250 / 580", "300 / 700");
  row("response basis (12 solves)", &PatchTimes::basis, "", "");
  row("drag frame, surface vertices", &PatchTimes::frame, "0.009 / 0.056", "0.020 / 0.100");
  row("CalculiX, whole program", &PatchTimes::ccx, "750 / 1900", "");
  std::cout << "\nCalculiX / mesh → displacement: " << a.ccx / a.total << " (p1), "
            << b.ccx / b.total << " (p2).\n"
            << "Largest difference from CalculiX relative to the largest displacement: "
            << a.ccx_error << " (p1), " << b.ccx_error << " (p2).\n"
            << "Response basis against direct solve, relative: " << a.basis_error << " (p1), "
            << b.basis_error << " (p2).\n";
}

/// Rays of a bone map: from a surface 5 mm below the patch, along its normals.
void print_ray_trees() {
  heading("Trees for the bone map");
  const TriangleMesh skin = testing::patch_p2();
  const Points normals = vertex_normals(skin);
  std::vector<bench::Ray> rays;
  for (Eigen::Index v = 0; v < skin.vertices.rows(); ++v) {
    const Eigen::Vector3d n = normals.row(v);
    // Also slightly turned rays, which do not aim at vertices.
    for (const double tilt : {0.0, 0.03, -0.07, 0.11}) {
      const Eigen::Vector3d direction = (n + tilt * Eigen::Vector3d(0.6, 0.8, 0)).normalized();
      rays.push_back({skin.vertices.row(v).transpose() - 5 * n, direction});
    }
  }
  std::cout
      << rays.size() << " rays, a quarter of them aimed exactly at vertices, against "
      << skin.triangles.rows() << " triangles. Hits differ when one tree finds none or "
      << "another distance by more than 1e-6 mm.\n\n"
      << "| tree | build, ms | rays/s | aimed at vertices: lost | other rays: differ from ours "
         "|\n|---|---|---|---|---|\n";
  bench::Hits reference;
  for (const auto& tree : bench::ray_trees()) {
    const double build = seconds([&] { tree->build(skin); });
    bench::Hits hits;
    const double ask = median_seconds(3, [&] { hits = tree->ask(rays, 20); });
    if (reference.triangle.empty()) reference = hits;
    long lost = 0, different = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (i % 4 == 0) {
        lost += hits.triangle[i] == -1;
      } else {
        different += (hits.triangle[i] == -1) != (reference.triangle[i] == -1) ||
                     std::abs(hits.distance[i] - reference.distance[i]) > 1e-6;
      }
    }
    std::cout << "| " << tree->name() << " | " << ms(build) << " | "
              << static_cast<long>(static_cast<double>(rays.size()) / ask) << " | " << lost << " | "
              << different << " |\n";
  }
}

/// How far landmarks follow the bone with the lips as one sheet and cut apart along the case's lip
/// line, or along the proposed one.
void print_lips(const std::string& path) {
  const SurgicalCase plan = read_case_file(path);
  heading("Lips: " + plan.name);
  Progress progress;
  const Anatomy anatomy = build_anatomy(plan, progress);
  SurgicalCase parted = plan;
  if (parted.region.lip_line.empty()) {
    const LipLineProposal proposal = propose_lip_line(anatomy.face.mesh.surface, plan.landmarks);
    parted.region.lip_line = proposal.line;
    for (const std::string& doubt : proposal.doubts) std::cout << "doubt: " << doubt << "\n\n";
  }
  SurgicalCase joined = plan;
  joined.region.lip_line.clear();
  std::map<std::string, std::string> rows;
  for (const SurgicalCase* variant : {&joined, &parted}) {
    for (const bool answer : {false, true}) {
      SurgicalCase asked = *variant;
      if (!answer) {
        asked.tissue.elements = Elements::linear;
        asked.tissue.strain = Strain::small;
      }
      Progress quiet;
      const FaceModel model(anatomy, asked.region, asked.tissue, quiet);
      const Prediction prediction = make_prediction(asked, anatomy, model, quiet);
      std::cout << (variant == &joined ? "joined" : "parted")
                << (answer ? ", answer: " : ", linear: ") << model.problem().slit.size()
                << " vertices doubled, " << tet_quality(model.problem().tissue.mesh).inverted
                << " of " << model.problem().tissue.mesh.tets.rows() << " tets inverted, "
                << prediction.inverted_after << " by the motion\n";
      for (const auto& [name, response] : prediction.landmarks) {
        char text[16];
        std::snprintf(text, sizeof text, " %.2f |", response.ratio);
        rows[name] += text;
      }
    }
  }
  std::cout
      << "\n| landmark | linear, joined | answer, joined | linear, parted | answer, parted |\n"
         "|---|---|---|---|---|\n";
  for (const auto& [name, row] : rows) std::cout << "| " << name << " |" << row << "\n";
}

void print_case(const std::string& path) {
  SurgicalCase plan = read_case_file(path);
  heading("Case: " + plan.name);
  Progress progress;
  const Anatomy anatomy = build_anatomy(plan, progress);
  const FaceModel model(anatomy, plan.region, plan.tissue, progress);
  const Prediction prediction = make_prediction(plan, anatomy, model, progress);
  const TetQuality quality = tet_quality(model.problem().tissue.mesh);
  std::cout << quality.count << " tets, inverted " << quality.inverted << "; smallest dihedral "
            << quality.smallest_dihedral << "°, median aspect " << quality.median_aspect
            << "; segment " << anatomy.segments.front().volume_mm3 / 1000 << " ml; residual "
            << prediction.relative_residual << "; basis against direct solve "
            << prediction.basis_error << "; tets inverted by the motion "
            << prediction.inverted_after << ".\n\n| stage | seconds |\n|---|---|\n";
  for (const StageTime& stage : progress.stage_times()) {
    std::cout << "| " << stage.name << " | " << stage.seconds << " |\n";
  }
  Points face;
  const double frame = median_seconds(501, [&] { model.predict(prediction.motions, face); });
  std::cout << "| one drag frame, all " << face.rows() << " face vertices | " << frame << " |\n";
  if (plan.landmarks.empty()) return;
  std::cout
      << "\nMotion along the bone's, over the bone's, by the linear model as it is dragged, for "
         "the released margin (tissue.released_mm) of, and by the answer\n\n| landmark | 0 mm | "
         "5 mm | 10 mm | 15 mm | 10 mm, nothing slides | answer |\n|---|---|---|---|---|---|---|\n";
  std::map<std::string, std::string> rows;
  const auto add_column = [&](const std::map<std::string, LandmarkResponse>& landmarks) {
    for (const auto& [name, response] : landmarks) {
      char text[16];
      std::snprintf(text, sizeof text, " %.2f |", response.ratio);
      rows[name] += text;
    }
  };
  TissueModel quick = plan.tissue;
  quick.elements = Elements::linear;
  quick.strain = Strain::small;
  const auto add_quick = [&](double released, bool slides) {
    SurgicalCase variant = plan;
    variant.tissue = quick;
    variant.tissue.released_mm = released;
    variant.tissue.slides_on_teeth = slides;
    Progress quiet;
    const FaceModel face_model(anatomy, variant.region, variant.tissue, quiet);
    add_column(make_prediction(variant, anatomy, face_model, quiet).landmarks);
  };
  for (const double released : {0.0, 5.0, 10.0, 15.0}) add_quick(released, true);
  add_quick(10, false);
  add_column(prediction.landmarks);
  for (const auto& [name, row] : rows) std::cout << "| " << name << " |" << row << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::cout.precision(3);
    if (argc > 1 && std::string(argv[1]) == "--lips") {
      for (int i = 2; i < argc; ++i) print_lips(argv[i]);
      return 0;
    }
    print_element_counts();
    print_hard_patches();
    print_patch_times();
    print_ray_trees();
    for (int i = 1; i < argc; ++i) print_case(argv[i]);
    for (int i = 1; i < argc; ++i) print_lips(argv[i]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "gnathion-evidence: " << error.what() << '\n';
    return 1;
  }
}
