#include "bench/photographs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/error.h"
#include "bench/timing.h"
#include "io/obj_document.h"
#include "offscreen/offscreen.h"
#include "projection/projection.h"
#include "support/photo_scene.h"
#include "support/scan_scene.h"
#include "support/temporary_folder.h"

namespace gnathion::bench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kHeight = 2000;  // pixels of a photograph
constexpr int kStarts = 20;    // of random errors

/// How well landmarks are picked.
struct Care {
  std::string name;
  double pixels;   ///< standard deviation in the picture, each way
  double skin_mm;  ///< on the skin, each way; 4 pixels are a millimetre of the face
};

const std::vector<Care>& cares() {
  static const std::vector<Care> all{{"exactly", 0, 0},
                                     {"to 1 pixel", 1, 0},
                                     {"to 2 pixels", 2, 0},
                                     {"by hand: 1 mm on either", 4, 1}};
  return all;
}

struct Pose {
  std::string name;
  PhotoCamera camera;
  test::Light light;
};

/// The analytic head's skin as its CT gives it, and three photographs of it.
struct Studio {
  SkinSight skin{test::head_skin({})};
  FacePaint paint{HeadModel(), 1};
  std::vector<Pose> poses{
      {"front", test::camera_from(3, 4, 1, 1100, 70, kHeight), {{1, 1, 1}}},
      {"left profile", test::camera_from(87, 1, -2, 1400, 85, kHeight), {{0.85, 0.92, 1.05}}},
      {"right profile", test::camera_from(-86, -2, 2, 900, 50, kHeight), {{1.06, 1, 0.9}}}};
  std::vector<std::shared_ptr<const Photo>> photos;

  /// shade: of test::Light; each photograph has its lamp above its camera.
  explicit Studio(double shade) {
    for (Pose& pose : poses) {
      pose.light.shade = shade;
      pose.light.from = pose.camera.eye().normalized() + Vector3d(0, 0, 0.4);
      photos.push_back(
          std::make_shared<const Photo>(test::photograph(pose.camera, skin, paint, pose.light)));
    }
  }
};

double mean(const std::vector<double>& values) {
  if (values.empty()) return std::nan("");
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double share(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

CameraFit fitted(const Studio& studio, const Pose& pose,
                 const std::vector<PhotoLandmark>& landmarks) {
  return fit_camera(landmarks, test::width_of(pose.camera), test::height_of(pose.camera),
                    studio.skin);
}

void report_cameras(const Report& report, const Studio& studio) {
  Table table({"photograph", "landmarks picked", "landmarks", "residual, pixels RMS",
               "residual, mm RMS", "eye off, mm", "focal length off, %", "texture off, mm: median",
               "95th percentile", "said: sure to, mm", "refused", "milliseconds"});
  for (const Pose& pose : studio.poses) {
    for (const Care& care : cares()) {
      std::vector<double> pixels, mm, eye, focal, median_off, p95_off, said, time;
      double count = 0;
      int refused = 0;
      for (unsigned seed = 0; seed < (care.pixels > 0 ? kStarts : 1); ++seed) {
        const auto landmarks =
            test::picked(pose.camera, studio.skin, care.pixels, care.skin_mm, 100 + seed);
        count = static_cast<double>(landmarks.size());
        try {
          CameraFit fit;
          time.push_back(1000 * seconds([&] { fit = fitted(studio, pose, landmarks); }));
          const auto off = test::displacements(pose.camera, fit.camera, studio.skin);
          pixels.push_back(fit.rms_pixels);
          mm.push_back(fit.rms_mm);
          eye.push_back((fit.camera.eye() - pose.camera.eye()).norm());
          focal.push_back(100 * std::abs(fit.camera.focal / pose.camera.focal - 1));
          median_off.push_back(share(off, 0.5));
          p95_off.push_back(share(off, 0.95));
          said.push_back(fit.uncertainty_mm);
        } catch (const Error&) {
          ++refused;
        }
      }
      table.add({pose.name, care.name, count, mean(pixels), mean(mm), mean(eye), mean(focal),
                 mean(median_off), mean(p95_off), mean(said), double(refused), mean(time)});
    }
  }
  report.table("photographs-cameras", table);
}

/// Of the face, ear to ear and chin to hairline: mean difference of a channel, 0..255, between the
/// painted skin and the truth in the front photograph's light.
std::vector<double> colour_errors(const Studio& studio, const PaintedSkin& painted) {
  const TriangleMesh& mesh = studio.skin.mesh();
  std::vector<double> errors;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Vector3d at =
        (mesh.vertices.row(mesh.triangles(f, 0)) + mesh.vertices.row(mesh.triangles(f, 1)) +
         mesh.vertices.row(mesh.triangles(f, 2))) /
        3;
    if (at.y() > -15 || at.z() < -95 || at.z() > 65 || painted.charts.corners(f, 0) < 0) continue;
    Vector2d pixel = Vector2d::Zero();
    for (const int row : painted.charts.corners.row(f)) pixel += painted.charts.places.row(row) / 3;
    const auto x = static_cast<std::size_t>(std::lround(pixel.x())),
               y = static_cast<std::size_t>(std::lround(pixel.y()));
    const std::uint8_t* c =
        &painted.picture.rgb[3 * (y * static_cast<std::size_t>(painted.picture.width) + x)];
    errors.push_back(
        (Vector3d(c[0], c[1], c[2]) - 255 * studio.paint.colour(at)).cwiseAbs().mean());
  }
  return errors;
}

std::vector<MarkedPhoto> marked(const Studio& studio, const Care& care, std::size_t photos) {
  std::vector<MarkedPhoto> all;
  for (std::size_t i = 0; i < photos; ++i) {
    const Pose& pose = studio.poses[i];
    all.push_back({pose.name,
                   studio.photos[i],
                   test::picked(pose.camera, studio.skin, care.pixels, care.skin_mm, 7),
                   {}});
  }
  return all;
}

Picture shown(const TexturedMesh& face, CameraPreset view) {
  FaceScene scene;
  scene.set_face(face);
  scene.look_from(view, 0.75);
  return OffscreenRenderer().render(scene, 450, 600);
}

/// The painted head from three sides.
void draw(const Report& report, const Studio& studio, const PaintedSkin& painted) {
  const test::TemporaryFolder folder;
  write_projection({std::vector<CameraFit>(painted.photos.size()), painted}, studio.skin.mesh(),
                   folder.path());
  const TexturedMesh face = ObjDocument::read(folder / "photograph.obj").mesh();
  write_png(tiled({{shown(face, CameraPreset::front), shown(face, CameraPreset::three_quarter),
                    shown(face, CameraPreset::left)}}),
            report.folder() / "photographs.png");
}

void add_painting(Table& table, const Studio& studio, const std::string& light, const Care& care,
                  std::size_t photos, const Report& report) {
  ProjectedPhotographs projected;
  Progress progress;
  const double time = seconds([&] {
    projected = project_photographs(marked(studio, care, photos), studio.skin, {}, progress);
  });
  const PaintedSkin& painted = projected.painted;
  const auto errors = colour_errors(studio, painted);
  table.add({photos == 1 ? "front" : "front and profiles", light, care.name,
             100 * painted.seen_cm2 / painted.skin_cm2,
             100 * painted.inpainted_cm2 / painted.skin_cm2, 255 * painted.disagreement,
             share(errors, 0.5), share(errors, 0.95),
             std::to_string(painted.charts.width) + " x " + std::to_string(painted.charts.height),
             painted.charts.mm_per_pixel, double(painted.charts.pieces.size()), time});
  if (photos == 3 && care.skin_mm > 0) draw(report, studio, painted);
}

void report_painting(const Report& report, const Studio& studio) {
  Table table({"photographs", "light", "landmarks picked", "seen, % of the head's skin",
               "made up, %", "photographs differ by, of 255", "colour off, of 255: median",
               "95th percentile", "picture, pixels", "mm a pixel", "pieces", "seconds"});
  add_painting(table, studio, "even", cares().front(), 1, report);
  for (const Care& care : cares()) add_painting(table, studio, "even", care, 3, report);
  add_painting(table, Studio(0.3), "a lamp each", cares().front(), 3, report);
  report.table("photographs-painting", table);
}

}  // namespace

void report_photographs(const Report& report) {
  report.heading("Ordinary photographs");
  report.say("Three photographs of the analytic head, 1500 x 2000 pixels, from known cameras; " +
             std::to_string(kStarts) + " sets of picked landmarks each, means of them.");
  const Studio studio(0);
  report_cameras(report, studio);
  report_painting(report, studio);
}

}  // namespace gnathion::bench
