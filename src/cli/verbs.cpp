#include "cli/verbs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "demo/demo_case.h"
#include "imaging/dicom_series.h"
#include "io/calculix.h"
#include "io/case_file.h"
#include "io/files.h"
#include "io/mesh_files.h"
#include "offscreen/comparison_pictures.h"
#include "prediction/report.h"
#include "render/face_scene.h"
#include "render/segment_colours.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

void print_files(const fs::path& target, std::ostream& out) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(target)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  out << "wrote\n";
  for (const fs::path& file : files) out << "  " << file.string() << '\n';
}

void publish(NewFolder& folder, const fs::path& target, std::ostream& out) {
  folder.publish();
  print_files(target, out);
}

/// What a verb that stops before the prediction has at hand.
struct Step {
  const SurgicalCase& plan;
  const Anatomy& anatomy;
  const fs::path& folder;  ///< where to write
};

/// The plan of a case file for a verb that moves bone.
SurgicalCase read_case_with_segments(const fs::path& case_file) {
  SurgicalCase plan = read_case_file(case_file);
  if (plan.segments.empty()) {
    throw Error(ErrorKind::case_file, case_file.string() + ": segments",
                "the case has no segment yet, so that nothing moves",
                "add one with its cut as in docs/case-file.md, or cut one in the window");
  }
  return plan;
}

/// Builds the plan's anatomy, lets `write` fill a new folder and publishes it.
void write_step(const SurgicalCase& plan, const fs::path& target, std::ostream& out,
                Progress& progress, const std::function<void(const Step&)>& write) {
  NewFolder folder(target);
  const Anatomy anatomy = build_anatomy(plan, progress);
  write({plan, anatomy, folder.path()});
  publish(folder, target, out);
}

/// Puts the face before any motion, and the bones in their poses, into a scene.
void show(const Anatomy& anatomy, const std::vector<RigidMotion>& motions, FaceScene& scene) {
  scene.set_face(anatomy.face.mesh, anatomy.face.document.path().filename().string(),
                 anatomy.face.document.vertex_colours());
  scene.set_bone("skull", anatomy.remainder, skull_look);
  for (std::size_t s = 0; s < anatomy.segments.size(); ++s) {
    const std::string name = "segment " + anatomy.segments[s].name;
    scene.set_bone(name, anatomy.segments[s].mesh, look_of_segment(s));
    scene.set_bone_pose(name, motions[s]);
  }
}

void draw(const Anatomy& anatomy, const Prediction& prediction, const fs::path& folder,
          Progress& progress) {
  const auto stage = progress.stage("pictures");
  FaceScene scene;
  show(anatomy, prediction.motions, scene);
  write_comparison(scene, anatomy.face.mesh.surface.vertices, prediction.face_points,
                   prediction.signed_distance, folder);
}

/// One time of a damped motion.
struct Still {
  int step;
  double time_s;
  Points surface;  ///< displacements of the tissue's surface, mm
};

/// At most 25 stills of a motion whose length is not known before: every 1st, 2nd, 4th … step, as
/// many as fit, and the last.
class Stills {
 public:
  void add(Still still) {
    last_ = still;
    if (still.step % stride_ != 0) return;
    kept_.push_back(std::move(still));
    if (kept_.size() <= kMost) return;
    stride_ *= 2;
    std::erase_if(kept_, [this](const Still& old) { return old.step % stride_ != 0; });
  }
  std::vector<Still> all() const {
    std::vector<Still> stills = kept_;
    if (stills.back().step != last_.step) stills.push_back(last_);
    return stills;
  }

 private:
  static constexpr std::size_t kMost = 24;
  int stride_ = 1;
  std::vector<Still> kept_;
  Still last_;
};

void draw(const Anatomy& anatomy, const FaceModel& model, const std::vector<RigidMotion>& motions,
          const std::vector<Still>& stills, const fs::path& folder, Progress& progress) {
  const auto stage = progress.stage("pictures");
  constexpr int kSide = 640;  // pixels
  FaceScene scene;
  show(anatomy, motions, scene);
  scene.set_face_opacity(0.6);
  scene.look_from(CameraPreset::left, 1);
  OffscreenRenderer renderer;
  for (const Still& still : stills) {
    progress.check();
    scene.set_face_points(model.face_with(still.surface));
    std::ostringstream caption, name;
    caption << std::fixed << std::setprecision(1) << 1000 * still.time_s << " ms";
    name << "frame_" << std::setfill('0') << std::setw(5) << still.step << ".png";
    scene.set_label(caption.str());
    write_png(renderer.render(scene, kSide, kSide), folder / name.str());
  }
}

void print_summary(const Prediction& prediction, std::ostream& out) {
  out << std::fixed << std::setprecision(2) << "face moves: mean " << prediction.displacement.mean
      << " mm, 95th percentile " << prediction.displacement.p95 << " mm, largest "
      << prediction.displacement.max << " mm (vertices of the region)\n"
      << "model: " << prediction.answer.tissue->tissue.mesh.tets.rows()
      << " tetrahedra, relative residual of the linear solution " << std::scientific
      << std::setprecision(1) << prediction.relative_residual << std::fixed << std::setprecision(2)
      << '\n'
      << "chosen: " << prediction.answer.why << '\n'
      << "the face shown while dragging differs by " << prediction.quick_mm
      << " mm on 95 % of the region\n";
  for (const auto& [name, response] : prediction.landmarks) {
    out << "  " << std::left << std::setw(20) << name << std::right << std::setprecision(2)
        << std::setw(7) << response.displacement.norm() << " mm, " << std::setw(5) << response.ratio
        << " of the bone\n";
  }
  if (prediction.inverted_after > 0) {
    out << "warning: " << prediction.inverted_after
        << " tetrahedra are turned inside out by this motion; it is too large for the model that "
           "the case asks for\n";
  }
}

}  // namespace

void list_series_verb(const fs::path& folder, std::ostream& out, Progress& progress) {
  for (const SeriesSummary& series : list_series(folder, progress)) {
    out << series.uid << "  " << series.modality << "  " << series.slices << " slices  "
        << series.size.x() << " x " << series.size.y() << " pixels of " << series.pixel_spacing.x()
        << " x " << series.pixel_spacing.y() << " mm  " << series.description << '\n';
  }
}

void demo_case_verb(unsigned seed, const fs::path& target, std::ostream& out, Progress& progress) {
  write_demo_case(seed, target, progress);
  print_files(target, out);
}

void check_verb(const fs::path& case_file, std::ostream& out) {
  const PlanHistory history = read_case_history(case_file);
  const SurgicalCase& plan = history.plan();
  out << "case " << (plan.name.empty() ? "(no name)" : plan.name) << '\n'
      << "  face: " << (plan.photograph ? "photograph" : "skin of the CT") << '\n';
  if (plan.segments.empty()) out << "  no segment yet\n";
  for (const PlannedSegment& segment : plan.segments) {
    const JawMotion& m = segment.motion;
    out << "  " << segment.name << ": forward " << m.forward_mm << " mm, up " << m.up_mm
        << " mm, left " << m.left_mm << " mm, pitch " << m.pitch_deg << " deg, roll " << m.roll_deg
        << " deg, yaw " << m.yaw_deg << " deg\n";
  }
  if (history.steps().size() > 1) {
    out << "  step " << history.position() + 1 << " of " << history.steps().size() << ": "
        << history.steps()[history.position()].name << '\n';
  }
  out << "the case file is well formed\n";
}

void surfaces_verb(const fs::path& case_file, const fs::path& target, std::ostream& out,
                   Progress& progress) {
  write_step(read_case_file(case_file), target, out, progress, [](const Step& step) {
    write_ply(step.anatomy.bone, step.folder / "bone.ply");
    const ObjDocument& face = step.anatomy.face.document;
    face.write(step.folder, "face.obj", face.mesh().surface.vertices);
  });
}

void segment_verb(const fs::path& case_file, const fs::path& target, std::ostream& out,
                  Progress& progress) {
  write_step(read_case_with_segments(case_file), target, out, progress, [&out](const Step& step) {
    write_ply(step.anatomy.remainder, step.folder / "remainder.ply");
    const std::vector<BoneSegment>& segments = step.anatomy.segments;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      // A name may hold what a file's name must not.
      const std::string number = segments.size() > 1 ? "-" + std::to_string(s + 1) : "";
      write_ply(segments[s].mesh, step.folder / ("segment" + number + ".ply"));
      out << segments[s].name << ": " << segments[s].volume_mm3 / 1000 << " ml\n";
    }
  });
}

void region_verb(const fs::path& case_file, const fs::path& target, std::ostream& out,
                 Progress& progress) {
  write_step(read_case_with_segments(case_file), target, out, progress,
             [&progress](const Step& step) {
               const TissueProblem problem =
                   build_tissue(step.anatomy, step.plan.region, step.plan.tissue, progress);
               write_ply(problem.region.mesh, step.folder / "region.ply");
               std::ostringstream vertices;
               for (const int v : problem.face_vertices) vertices << v << '\n';
               write_text_file(step.folder / "region.txt", vertices.str());
             });
}

void mesh_verb(const fs::path& case_file, const fs::path& target, std::ostream& out,
               Progress& progress) {
  write_step(read_case_with_segments(case_file), target, out, progress, [&](const Step& step) {
    const TissueModel& model = step.plan.tissue;
    const TissueProblem problem = build_tissue(step.anatomy, step.plan.region, model, progress);
    const TetMesh& mesh = problem.tissue.mesh;
    write_vtu(mesh, {}, step.folder / "tissue.vtu");
    if (model.load == LoadModel::displacement) {
      const Points prescribed = bone_displacements(mesh.vertices, problem.supports,
                                                   planned_motions(step.plan, step.anatomy));
      write_calculix_deck({mesh, problem.materials, problem.supports, prescribed},
                          step.folder / "tissue.inp");
    }
    out << mesh.tets.rows() << " tetrahedra\n";
  });
}

void predict_verb(const fs::path& case_file, const fs::path& target, bool pictures,
                  std::ostream& out, Progress& progress) {
  const SurgicalCase plan = read_case_with_segments(case_file);
  NewFolder folder(target);
  const Anatomy anatomy = build_anatomy(plan, progress);
  const FaceModel model(anatomy, plan.region, plan.tissue, progress);
  const Prediction prediction = make_prediction(plan, anatomy, model, progress);
  if (pictures) draw(anatomy, prediction, folder.path(), progress);
  {
    const auto stage = progress.stage("export");
    anatomy.face.document.write(folder.path(), "predicted.obj",
                                anatomy.face.file_vertices(prediction.face_points));
    write_vtu(prediction.answer.tissue->tissue.mesh, prediction.answer.displacements,
              folder.path() / "tissue.vtu");
  }
  write_text_file(folder.path() / "report.json", report_json(plan, anatomy, prediction));
  print_summary(prediction, out);
  publish(folder, target, out);
}

void settle_verb(const fs::path& case_file, const fs::path& target, const SettlingOptions& options,
                 bool pictures, std::ostream& out, Progress& progress) {
  write_step(read_case_with_segments(case_file), target, out, progress, [&](const Step& step) {
    TissueModel tissue = step.plan.tissue;
    tissue.elements = Elements::linear;  // what the damped motion lives on
    const FaceModel model(step.anatomy, step.plan.region, tissue, progress);
    const std::vector<RigidMotion> motions = planned_motions(step.plan, step.anatomy);
    const int surface = model.problem().tissue.surface_count;
    std::ostringstream csv;
    csv << "time_s,mean_mm,max_mm,energy_Nmm\n" << std::setprecision(9);
    Stills stills;
    const auto each = [&](const SettlingFrame& frame) {
      csv << frame.time_s << ',' << frame.distance.mean << ',' << frame.distance.max << ','
          << frame.energy_Nmm << '\n';
      if (pictures) {
        stills.add({frame.step, frame.time_s, frame.displacements.topRows(surface)});
      }
    };
    const Settling end = settle(model, motions, options, each, progress);
    write_text_file(step.folder / "settling.csv", csv.str());
    if (pictures) draw(step.anatomy, model, motions, stills.all(), step.folder, progress);
    out << (end.settled ? "settled to " : "not settled to ") << options.tolerance_mm
        << " mm of the static solution of the linear model after " << end.steps << " steps, "
        << 1000 * end.time_s << " ms\n";
  });
}

}  // namespace gnathion
