#include "bench/frames.h"

#include <cmath>

#include "bench/timing.h"
#include "io/case_file.h"
#include "offscreen/offscreen.h"
#include "prediction/face_model.h"
#include "render/coarse_surface.h"

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

/// A drag to and fro along the patient's axes.
FrameTimes drag(FaceScene& scene, const Anatomy& anatomy, const FaceModel& model) {
  std::vector<double> response, points, render;
  OffscreenRenderer renderer;
  renderer.render(scene, kWidth, kHeight);
  Points face;
  std::vector<RigidMotion> motions(anatomy.segments.size());
  for (int frame = 0; frame < kFrames; ++frame) {
    motions[0].translation << std::sin(0.3 * frame), -0.4 * frame, std::cos(0.2 * frame);
    response.push_back(seconds([&] { model.predict(motions, face); }));
    points.push_back(seconds([&] {
      scene.set_face_points(face);
      scene.set_bone_pose(anatomy.segments[0].name, motions[0]);
    }));
    render.push_back(seconds([&] { renderer.render(scene, kWidth, kHeight); }));
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
  report.say(plan.name + ": its skin as the face, 1280×800, software OpenGL; medians of " +
             std::to_string(kFrames) + " frames.");
  report.table("frames", table);
}

}  // namespace gnathion::bench
