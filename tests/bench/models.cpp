#include "bench/models.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "bench/calculix_run.h"
#include "bench/patch_scene.h"
#include "bench/timing.h"
#include "io/case_file.h"
#include "io/files.h"
#include "prediction/answer.h"

namespace gnathion::bench {
namespace {

/// A mesh that a reference is computed on: the length of edges, mm (1: shorter than a patch's own,
/// which are kept), and of layers, in edges.
struct Fineness {
  double edge, layers;
};

/// A face to predict, and how.
struct Scene {
  std::string name, file;  ///< file: of the kept reference
  Fineness fine, other;    ///< the reference's mesh, and one that tells how sure it is
  Anatomy anatomy;
  RegionChoice region;
  TissueModel tissue;
  std::vector<RigidMotion> motions;
};

std::vector<RigidMotion> forward(double mm) {
  std::vector<RigidMotion> motions(1);
  motions[0].translation << 0, 0, mm;  // a patch looks along z
  return motions;
}

Scene patch_scene(const std::string& name, const TriangleMesh& skin, double mm,
                  const Fineness& fine, const Fineness& other) {
  Scene scene{name + ", chin " + number(mm, 2) + " mm forward",
              "reference-" + name,
              fine,
              other,
              patch_anatomy(skin),
              {},
              {},
              {}};
  scene.region = whole_patch(scene.anatomy);
  scene.motions = forward(mm);
  return scene;
}

Scene case_scene(const std::string& path) {
  const SurgicalCase plan = read_case_file(path);
  Progress progress;
  Scene scene{plan.name,
              "reference-" + std::filesystem::path(path).stem().string(),
              {2, 0},
              {2, 2},
              build_anatomy(plan, progress),
              plan.region,
              plan.tissue,
              {}};
  scene.motions = planned_motions(plan, scene.anatomy);
  return scene;
}

/// One point of the plot.
struct Sample {
  std::string mesh, model;
  double tets = 0, first = 0, frame = 0;  ///< s to the first answer, s a pose
  DistanceStatistics error = {};          ///< against the reference, mm
  double estimate = std::nan("");         ///< the program's own, 95 %, mm
  std::string failure = {};
};

/// Vertices that are compared, and where they go.
struct Reference {
  std::vector<int> vertices;
  Points displacements;  ///< a row each, mm
};

DistanceStatistics error_of(const Scene& scene, const Reference& reference, const Points& face) {
  const Points u = face - scene.anatomy.face.mesh.surface.vertices;
  return distance_statistics(
      (u(reference.vertices, Eigen::all) - reference.displacements).rowwise().norm());
}

FaceModel model_of(const Scene& scene, const TissueModel& tissue) {
  Progress progress;
  return FaceModel(scene.anatomy, scene.region, tissue, progress);
}

Points large_strain_face(const FaceModel& model, const StaticSolver& solver,
                         const std::vector<RigidMotion>& motions) {
  const Points& nodes = solver.elements().nodes;
  NeoHookeanOptions options;
  options.tolerance = 1e-4;  // as the program asks for
  Progress progress;
  const NeoHookeanSolution large =
      NeoHookeanSolver(solver).solve(bone_path(nodes, solver.supports(), motions),
                                     Points::Zero(nodes.rows(), 3), progress, options);
  return model.face_with(large.displacements.topRows(model.problem().tissue.mesh.vertices.rows()));
}

/// What is measured on one scene.
class Trial {
 public:
  Trial(const Scene& scene, const Reference& reference) : scene_(scene), reference_(reference) {}

  /// A model that the response basis answers.
  void add_dragged(Sample sample, const std::function<FaceModel()>& make) {
    attempt(std::move(sample), [&](Sample& s) {
      std::optional<FaceModel> model;
      Points face;
      s.first = seconds([&] {
        model.emplace(make());
        model->predict(scene_.motions, face);
      });
      s.tets = static_cast<double>(model->problem().tissue.mesh.tets.rows());
      s.frame = median_seconds(51, [&] { model->predict(scene_.motions, face); });
      s.error = error_of(scene_, reference_, face);
    });
  }

  /// A model that is solved anew for every pose, `ready` seconds after the region was chosen.
  void add_solved(Sample sample, const FaceModel& model, double ready,
                  const std::function<const StaticSolver&()>& solver) {
    attempt(std::move(sample), [&](Sample& s) {
      const StaticSolver* of = nullptr;
      ready += seconds([&] { of = &solver(); });
      Points face;
      s.frame = seconds([&] { face = large_strain_face(model, *of, scene_.motions); });
      s.first = ready + s.frame;
      s.tets = static_cast<double>(of->elements().elements.rows());
      s.error = error_of(scene_, reference_, face);
    });
  }

  void attempt(Sample sample, const std::function<void(Sample&)>& measure) {
    try {
      measure(sample);
    } catch (const Error& error) {
      sample.failure = error.what();
    }
    samples.push_back(std::move(sample));
  }

  std::vector<Sample> samples;

 private:
  const Scene& scene_;
  const Reference& reference_;
};

constexpr const char* kPaper = "the paper's: one layer, fixed depth, force";
constexpr const char* kAuto = "Auto";
const std::array<const char*, 4> kModels{"linear", "linear, quadratic elements", "neo-Hookean",
                                         "neo-Hookean, quadratic elements"};

/// The paper's model, at the greatest depth of 8, 4, 2, 1 mm at which its generator inverts
/// nothing.
void add_paper(const Scene& scene, Trial& trial) {
  TissueModel paper = scene.tissue;
  paper.generator = Generator::paper;
  paper.load = LoadModel::force;
  paper.elements = Elements::linear;
  paper.strain = Strain::small;
  for (const double depth : {8.0, 4.0, 2.0, 1.0}) {
    paper.depth_mm = depth;
    trial.add_dragged({number(depth, 1) + " mm deep", kPaper},
                      [&] { return model_of(scene, paper); });
    if (trial.samples.back().failure.empty()) return;
  }
}

void add_auto(const Scene& scene, const Reference& reference, Trial& trial) {
  trial.attempt({"", kAuto}, [&](Sample& s) {
    Answer answer;
    std::optional<FaceModel> quick;
    Progress progress;
    const double ready = seconds([&] { quick.emplace(model_of(scene, scene.tissue)); });
    // Its error is that of the answer, not of the frames that a drag shows before.
    s.frame = seconds([&] {
      answer =
          choose_answer(scene.anatomy, scene.region, scene.tissue, *quick, scene.motions, progress);
    });
    s.first = ready + s.frame;
    s.mesh = answer.why;
    s.tets = static_cast<double>(answer.tissue->tissue.mesh.tets.rows());
    s.error = error_of(scene, reference, answer.face_points);
    s.estimate = answer.error.total.p95;
  });
}

/// Every model on one mesh.
void add_models(const Scene& scene, double edge, double layers, Trial& trial) {
  TissueModel tissue = scene.tissue;
  tissue.edge_mm = edge;
  tissue.layer_edges = layers;
  tissue.elements = Elements::linear;
  const std::string mesh =
      "edges " + number(edge, 1) + " mm, " +
      (layers == 0 ? std::string("one layer") : "layers of " + number(layers, 1) + " edges");
  trial.add_dragged({mesh, kModels[0]}, [&] { return model_of(scene, tissue); });
  if (!trial.samples.back().failure.empty()) return;
  const double ready = trial.samples.back().first;
  const FaceModel model = model_of(scene, tissue);
  Progress progress;
  trial.add_dragged({mesh, kModels[1]}, [&] { return model.on_quadratic_elements(progress); });
  trial.samples.back().first += ready;
  trial.add_solved({mesh, kModels[2]}, model, ready,
                   [&]() -> const StaticSolver& { return model.solver(); });
  constexpr Eigen::Index kMostTets = 25000;  // above, half a minute a pose and more
  if (model.problem().tissue.mesh.tets.rows() > kMostTets) return;
  trial.add_solved({mesh, kModels[3]}, model, ready,
                   [&]() -> const StaticSolver& { return model.quadratic_solver(progress); });
}

Reference on_region(const Scene& scene, const FaceModel& model, const Points& face) {
  const std::vector<int>& moving = model.moving_vertices();
  return {moving, (face - scene.anatomy.face.mesh.surface.vertices)(moving, Eigen::all)};
}

/// On quadratic elements; a patch keeps its own edges. Minutes.
Reference reference_of(const Scene& scene, const Fineness& mesh, Strain strain) {
  TissueModel tissue = scene.tissue;
  tissue.edge_mm = mesh.edge;
  tissue.layer_edges = mesh.layers;
  tissue.elements = Elements::linear;
  const FaceModel model = model_of(scene, tissue);
  Progress progress;
  return on_region(scene, model,
                   strain == Strain::large
                       ? large_strain_face(model, model.quadratic_solver(progress), scene.motions)
                       : model.face_with(model.solve_quadratic(scene.motions, progress)));
}

Reference kept_reference(const Report& report, const Scene& scene) {
  const auto path = report.folder() / (scene.file + ".csv");
  std::ifstream file(path);
  if (!file) {
    throw Error(ErrorKind::input, path.string(), "the reference of " + scene.name + " is missing",
                "make it: ./run bench reference");
  }
  Reference reference;
  std::vector<Eigen::RowVector3d> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    int vertex = 0;
    Eigen::RowVector3d u;
    words >> vertex >> u[0] >> u[1] >> u[2];
    reference.vertices.push_back(vertex);
    rows.push_back(u);
  }
  reference.displacements.resize(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    reference.displacements.row(static_cast<Eigen::Index>(i)) = rows[i];
  }
  return reference;
}

Series series_of(const std::vector<Sample>& samples, const std::string& model, int colour,
                 Marker marker, double Sample::*x) {
  Series series{.name = model, .colour = colour, .marker = marker};
  for (const Sample& s : samples) {
    if (s.model != model || !s.failure.empty()) continue;
    series.x.push_back(s.*x);
    series.y.push_back(s.error.mean);
  }
  return series;
}

Plot plot_of(const std::string& title, const std::vector<Sample>& samples, double Sample::*x,
             const std::string& label) {
  Plot plot{title, {label, true}, {"mean error of the face, mm", true}};
  const std::array markers{Marker::circle, Marker::square, Marker::triangle, Marker::cross};
  std::vector<double> all_x, all_y;
  for (const Sample& s : samples) {
    if (!s.failure.empty()) continue;
    all_x.push_back(s.*x);
    all_y.push_back(s.error.mean);
  }
  Series front = pareto_front("Pareto front", all_x, all_y);
  front.colour = 7;
  front.dashed = true;
  plot.series.push_back(front);
  for (std::size_t k = 0; k < kModels.size(); ++k) {
    plot.series.push_back(series_of(samples, kModels[k], static_cast<int>(k), markers[k], x));
  }
  plot.series.push_back(series_of(samples, kPaper, 4, Marker::diamond, x));
  plot.series.push_back(series_of(samples, kAuto, 5, Marker::star, x));
  return plot;
}

void add_rows(const Scene& scene, const std::vector<Sample>& samples, Table& table) {
  for (const Sample& s : samples) {
    if (!s.failure.empty()) {
      table.add({scene.name, s.model, s.failure, std::string(), std::string(), std::string(),
                 std::string(), std::string(), std::string(), std::string()});
      continue;
    }
    table.add({scene.name, s.model, s.mesh, s.tets, s.first, s.frame * 1e3, s.error.mean,
               s.error.p95, s.error.max, s.estimate});
  }
}

std::vector<Sample> measured(const Report& report, const Scene& scene) {
  const Reference reference = kept_reference(report, scene);
  Trial trial(scene, reference);
  add_paper(scene, trial);
  for (const double edge : {4.0, 3.0, 2.0}) {
    for (const double layers : {0.0, 2.0, 1.0}) add_models(scene, edge, layers, trial);
  }
  add_auto(scene, reference, trial);
  return std::move(trial.samples);
}

Scene p1_scene() {
  return patch_scene("p1", testing::patch_p1(), 5, {1, 0.5}, {1, 1});
}

std::vector<std::function<Scene()>> scenes_of(const std::vector<std::string>& cases) {
  std::vector<std::function<Scene()>> scenes{
      p1_scene, [] {
        // At 5 mm one of its quadratic elements is pressed flat, and the motion is refused.
        return patch_scene("p2", testing::patch_p2(), 4.5, {1, 0}, {1, 2});
      }};
  for (const std::string& path : cases) scenes.emplace_back([path] { return case_scene(path); });
  return scenes;
}

std::string words(const Fineness& mesh) {
  return (mesh.edge == 1 ? std::string("own edges") : "edges " + number(mesh.edge, 0) + " mm") +
         ", " +
         (mesh.layers == 0 ? std::string("one layer")
                           : "layers of " + number(mesh.layers, 1) + " edges");
}

/// Computes and keeps a scene's reference, and adds to `sure` how much another mesh changes it; on
/// that the linear model stands for both, since large strain does not follow on every mesh.
void add_reference(const Report& report, const Scene& scene, Table& sure) {
  Reference reference;
  const double time = seconds([&] { reference = reference_of(scene, scene.fine, Strain::large); });
  Table table({"vertex", "x, mm", "y, mm", "z, mm"});
  for (std::size_t i = 0; i < reference.vertices.size(); ++i) {
    const auto u = reference.displacements.row(static_cast<Eigen::Index>(i));
    const auto rounded = [](double mm) { return std::round(1e4 * mm) / 1e4; };
    table.add(
        {static_cast<double>(reference.vertices[i]), rounded(u[0]), rounded(u[1]), rounded(u[2])});
  }
  write_text_file(report.folder() / (scene.file + ".csv"), table.csv());
  const Points change = reference_of(scene, scene.fine, Strain::small).displacements -
                        reference_of(scene, scene.other, Strain::small).displacements;
  const DistanceStatistics difference = distance_statistics(change.rowwise().norm());
  sure.add({scene.name, words(scene.fine), words(scene.other), difference.mean, difference.p95,
            difference.max, time});
}

/// The scene by CalculiX, NLGEOM on quadratic elements, and by ours on the same mesh. ccx's are
/// integrated in full, ours have λ on the mean dilatation: they meet as the mesh gets finer.
void add_by_calculix(const Scene& scene, const Fineness& mesh, const Reference& reference,
                     Table& table) {
  TissueModel tissue = scene.tissue;
  tissue.edge_mm = mesh.edge;
  tissue.layer_edges = mesh.layers;
  tissue.elements = Elements::linear;
  const FaceModel model = model_of(scene, tissue);
  Progress progress;
  const StaticSolver& solver = model.quadratic_solver(progress);
  CalculixProblem problem{
      solver.elements(), solver.materials(), solver.supports(),
      bone_displacements(solver.elements().nodes, solver.supports(), scene.motions)};
  problem.neo_hookean = true;
  const std::optional<CalculixRun> run = run_calculix(problem);
  if (!run) return;
  const Points theirs =
      model.face_with(run->displacements.topRows(model.problem().tissue.mesh.vertices.rows()));
  const Points ours = large_strain_face(model, solver, scene.motions);
  const DistanceStatistics apart = error_of(scene, on_region(scene, model, ours), theirs);
  table.add({scene.name, words(mesh), static_cast<double>(solver.elements().elements.rows()),
             error_of(scene, reference, theirs).mean, error_of(scene, reference, theirs).p95,
             error_of(scene, reference, ours).mean, error_of(scene, reference, ours).p95,
             apart.mean, apart.p95, run->cost.wall});
}

}  // namespace

void report_models(const Report& report, const std::vector<std::string>& cases) {
  report.heading("Speed against error");
  report.say(
      "First answer: from the chosen region to a face. A pose: a drag frame, or the whole solution "
      "where each pose is solved anew. Reference: neo-Hookean on quadratic elements, kept; its "
      "mesh "
      "and how sure it is: reference-sure.csv.");
  Table table({"scene", "model", "mesh", "tets", "first answer, s", "a pose, ms", "mean, mm",
               "95 %, mm", "max, mm", "estimated 95 %, mm"});
  std::vector<Plot> plots;
  for (const auto& make : scenes_of(cases)) {
    const Scene scene = make();
    std::vector<Sample> samples;
    try {
      samples = measured(report, scene);
    } catch (const Error& missing) {
      report.say("Left out: " + std::string(missing.what()));
      continue;
    }
    add_rows(scene, samples, table);
    plots.push_back(plot_of(scene.name, samples, &Sample::first, "seconds to the first answer"));
    plots.push_back(plot_of(scene.name, samples, &Sample::frame, "seconds a pose"));
  }
  report.table("models", table);
  if (!plots.empty()) report.figure("models", "Speed against error", plots, 2);
}

void report_reference(const Report& report, const std::vector<std::string>& cases) {
  report.heading("References");
  Table sure({"scene", "mesh", "against", "mean, mm", "95 %, mm", "max, mm", "seconds"});
  for (const auto& make : scenes_of(cases)) {
    const Scene scene = make();
    try {
      add_reference(report, scene, sure);
    } catch (const Error& failure) {
      report.say("No reference for " + scene.name + ": " + failure.what());
    }
  }
  report.table("reference-sure", sure);
}

void report_calculix_reference(const Report& report) {
  report.heading("The reference of p1 by CalculiX");
  const Scene scene = p1_scene();
  const Reference reference = kept_reference(report, scene);
  Table table({"scene", "mesh", "tets", "CalculiX to the reference: mean, mm", "95 %, mm",
               "ours to the reference: mean, mm", "95 %, mm", "CalculiX to ours: mean, mm",
               "95 %, mm", "CalculiX, s"});
  for (const Fineness& mesh : {Fineness{4, 0}, Fineness{1, 0}}) {
    add_by_calculix(scene, mesh, reference, table);
  }
  report.table("reference-calculix", table);
}

}  // namespace gnathion::bench
