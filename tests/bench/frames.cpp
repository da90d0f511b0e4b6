#include "bench/frames.h"

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <cmath>

#include "bench/timing.h"
#include "io/case_file.h"
#include "offscreen/osmesa_window.h"
#include "prediction/face_model.h"
#include "render/coarse_surface.h"
#include "render/face_scene.h"

namespace gnathion::bench {
namespace {

constexpr int kWidth = 1280, kHeight = 800, kFrames = 25;

/// The medians of the parts of a frame, s.
struct FrameTimes {
  double response = 0, points = 0, render = 0;
};

void fill(FaceScene& scene, const Anatomy& anatomy) {
  scene.set_face(anatomy.face.mesh);
  scene.set_bone("skull", anatomy.remainder, skull_look,
                 coarse_triangles(anatomy.remainder, kQuickSkull));
  for (const BoneSegment& segment : anatomy.segments) {
    scene.set_bone(segment.name, segment.mesh, segment_look,
                   coarse_triangles(segment.mesh, kQuickSegment));
  }
  scene.look_from(CameraPreset::three_quarter, double(kWidth) / kHeight);
}

/// As the window draws: without multisampling, and the scene stays on the graphics card.
class Window {
 public:
  explicit Window(FaceScene& scene) : scene_(scene) {
    window_->SetMultiSamples(0);
    window_->SetSize(kWidth, kHeight);
    window_->AddRenderer(scene.renderer());
  }
  ~Window() {
    window_->MakeCurrent();
    scene_.renderer()->ReleaseGraphicsResources(window_);
    window_->RemoveRenderer(scene_.renderer());
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Until the pixels can be read, so that nothing of the frame is left to be done.
  void draw() {
    window_->Render();
    constexpr int back_buffer = 0;
    window_->GetPixelData(0, 0, kWidth - 1, kHeight - 1, back_buffer, pixels_, 0);
  }

 private:
  FaceScene& scene_;
  vtkNew<OsmesaWindow> window_;
  vtkNew<vtkUnsignedCharArray> pixels_;
};

/// A drag to and fro along the patient's axes.
FrameTimes drag(FaceScene& scene, const Anatomy& anatomy, const FaceModel& model) {
  std::vector<double> response, points, render;
  Window window(scene);
  window.draw();
  Points face;
  std::vector<RigidMotion> motions(anatomy.segments.size());
  for (int frame = 0; frame < kFrames; ++frame) {
    motions[0].translation << std::sin(0.3 * frame), -0.4 * frame, std::cos(0.2 * frame);
    response.push_back(seconds([&] { model.predict(motions, face); }));
    points.push_back(seconds([&] {
      scene.set_face_points(face);
      scene.set_bone_pose(anatomy.segments[0].name, motions[0]);
    }));
    render.push_back(seconds([&] { window.draw(); }));
  }
  return {median(response), median(points), median(render)};
}

}  // namespace

void report_frames(const Report& report, const std::vector<std::string>& cases) {
  report.heading("A frame of a drag");
  if (cases.empty()) {
    report.say("Left out: no case was given.");
    return;
  }
  constexpr double kEdge = 1.8;  // mm: a skin of some 100 000 triangles
  SurgicalCase plan = read_case_file(cases.back());
  plan.photograph.reset();
  plan.skin.edge_mm = kEdge;
  Progress progress;
  const Anatomy anatomy = build_anatomy(plan, progress);
  const FaceModel model(anatomy, plan.region, plan.tissue, progress);
  FaceScene scene;
  fill(scene, anatomy);
  Table table({"drawn", "face triangles", "bone triangles", "response and map, ms",
               "normals and copies, ms", "upload and render, ms", "frames a second"});
  const auto face = static_cast<double>(anatomy.face.mesh.surface.triangles.rows());
  const auto bone = static_cast<double>(anatomy.bone.triangles.rows());
  for (const bool coarse : {false, true}) {
    scene.set_coarse(coarse);
    const FrameTimes times = drag(scene, anatomy, model);
    table.add({coarse ? std::string("coarse, as the window drags") : std::string("whole"), face,
               bone, 1e3 * times.response, 1e3 * times.points, 1e3 * times.render,
               1 / (times.response + times.points + times.render)});
  }
  report.say(plan.name +
             ": its skin as the face, 1280×800, software OpenGL without a window; medians of " +
             std::to_string(kFrames) + " frames.");
  report.table("frames", table);
}

}  // namespace gnathion::bench
