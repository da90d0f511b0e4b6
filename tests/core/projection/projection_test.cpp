#include "projection/projection.h"

#include <gtest/gtest.h>

#include <numeric>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "io/obj_document.h"
#include "projection/photo_marks.h"
#include "support/expect_error.h"
#include "support/photo_scene.h"
#include "support/scan_scene.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::expect_error;

/// The analytic head, coarse, and a camera before it.
struct Scene {
  SkinSight skin;
  FacePaint paint{HeadModel(), 1};
  PhotoCamera front = test::camera_from(4, 3, 2, 1200, 70, 640);
  PhotoCamera left = test::camera_from(86, 0, -3, 1500, 85, 640);

  Scene() : skin(coarse_skin()) {}
  static TriangleMesh coarse_skin() {
    PhantomOptions options;
    options.pixel_mm = options.slice_step_mm = 2.5;
    return test::head_skin(options);
  }
};

const Scene& scene() {
  static const Scene the_scene;
  return the_scene;
}

CameraFit fitted(const PhotoCamera& camera, const std::vector<PhotoLandmark>& landmarks,
                 const CameraOptions& options = {}) {
  return fit_camera(landmarks, test::width_of(camera), test::height_of(camera), scene().skin,
                    options);
}

std::vector<PhotoLandmark> exact(const PhotoCamera& camera) {
  return test::picked(camera, scene().skin, 0, 0, 1);
}

double share(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values.at(static_cast<std::size_t>(part * static_cast<double>(values.size() - 1)));
}

void expect_refused(const std::vector<std::string>& parts,
                    const std::vector<PhotoLandmark>& landmarks,
                    const CameraOptions& options = {}) {
  expect_error(ErrorKind::input, parts, [&] { fitted(scene().front, landmarks, options); });
}

TEST(PhotoCamera, IsFoundExactlyWhenItsFocalLengthIsKnown) {
  for (const PhotoCamera& camera : {scene().front, scene().left}) {
    const double focal_35mm =
        camera.focal * 43.2666 / std::hypot(test::width_of(camera), test::height_of(camera));
    const CameraFit fit = fitted(camera, exact(camera), {focal_35mm});
    EXPECT_LT(fit.rms_pixels, 1e-5);
    EXPECT_LT((fit.camera.eye() - camera.eye()).norm(), 0.01);
    EXPECT_NEAR(fit.focal_35mm, focal_35mm, 1e-3);
    EXPECT_LT(share(test::displacements(camera, fit.camera, scene().skin), 0.99), 1e-3);
  }
}

TEST(PhotoCamera, IsFoundToAMillimetreOnTheSkinWhenItIsNot) {
  for (const PhotoCamera& camera : {scene().front, scene().left}) {
    const CameraFit fit = fitted(camera, exact(camera));
    EXPECT_LT(fit.rms_mm, 0.3);
    EXPECT_LT(share(test::displacements(camera, fit.camera, scene().skin), 0.95), 1.5);
  }
}

TEST(PhotoCamera, ResidualsAndUncertaintyGrowWithThePicksErrors) {
  const auto few = fitted(scene().front, test::picked(scene().front, scene().skin, 0.5, 0, 3));
  const auto many = fitted(scene().front, test::picked(scene().front, scene().skin, 4, 0, 3));
  EXPECT_GT(many.rms_pixels, 3 * few.rms_pixels);
  EXPECT_GT(many.uncertainty_mm, few.uncertainty_mm);
  EXPECT_EQ(few.residuals.size(), exact(scene().front).size());
  const double usual = share(test::displacements(scene().front, many.camera, scene().skin), 0.5);
  EXPECT_LT(usual, 2 * many.uncertainty_mm);
  EXPECT_GT(usual, 0.1 * many.uncertainty_mm);
}

TEST(PhotoCamera, TooFewLandmarksAreRefused) {
  std::vector<PhotoLandmark> landmarks = exact(scene().front);
  landmarks.resize(5);
  expect_refused({"landmarks", "are 5", "at least 6"}, landmarks);
  landmarks.resize(4);
  expect_refused({"are 4", "at least 5"}, landmarks, {70});
  expect_refused({"focal_35mm"}, exact(scene().front), {3});
}

TEST(PhotoCamera, LandmarksThatDoNotHoldItAreRefused) {
  const PhotoCamera& camera = scene().front;
  std::vector<PhotoLandmark> line, plane;
  for (int i = 0; i < 7; ++i) {
    const Vector3d on_line(0, -100, 10.0 * i), on_plane(15.0 * (i % 3), -100, 12.0 * (i / 3));
    line.push_back({"l" + std::to_string(i), on_line, camera.pixel(on_line)});
    plane.push_back({"p" + std::to_string(i), on_plane, camera.pixel(on_plane)});
  }
  expect_refused({"line"}, line);
  expect_refused({"plane", "nose"}, plane);
}

TEST(PhotoCamera, BadLandmarksAreNamed) {
  const auto with = [](const auto& change) {
    std::vector<PhotoLandmark> landmarks = exact(scene().front);
    change(landmarks);
    return landmarks;
  };
  expect_refused({"nose_tip", "finite"}, with([](auto& all) {
                   for (auto& l : all) {
                     if (l.name == "nose_tip") l.pixel.x() = std::nan("");
                   }
                 }));
  expect_refused({"given twice"}, with([](auto& all) { all[1].name = all[0].name; }));
  expect_refused({"outside the picture"}, with([](auto& all) { all[2].pixel.y() = 700; }));
  expect_refused({"one place"}, with([](auto& all) { all[2].pixel = all[3].pixel; }));
  expect_refused({"do not fit", "nose_tip"}, with([](auto& all) {
                   for (auto& l : all) {
                     if (l.name == "nose_tip") l.pixel.x() += 90;
                   }
                 }));
}

std::vector<PhotoLandmark> exchanged(std::vector<PhotoLandmark> landmarks) {
  const auto places = test::picked_places();
  for (PhotoLandmark& l : landmarks) {
    for (const auto& [from, to] : {std::pair("_left", "_right"), std::pair("_right", "_left")}) {
      const std::size_t at = l.name.find(from);
      if (at == std::string::npos) continue;
      l.name.replace(at, std::string::npos, to);
      l.lps = places.at(l.name);
      break;
    }
  }
  return landmarks;
}

TEST(PhotoCamera, ExchangedSidesAndMirroredPicturesAreRefused) {
  for (const PhotoCamera& camera : {scene().front, scene().left}) {
    expect_error(ErrorKind::input, {"mirror image", "exchange"},
                 [&] { fitted(camera, exchanged(exact(camera))); });
    std::vector<PhotoLandmark> flipped = exact(camera);
    for (PhotoLandmark& l : flipped) l.pixel.x() = test::width_of(camera) - 1 - l.pixel.x();
    expect_error(ErrorKind::input, {"mirror image"}, [&] { fitted(camera, flipped); });
  }
}

/// An EXIF orientation as cameras write it: APP1 right after the start of the JPEG.
std::vector<std::uint8_t> turned_jpeg(const cv::Mat& picture, std::uint8_t orientation) {
  std::vector<std::uint8_t> jpeg;
  cv::imencode(".jpg", picture, jpeg);
  const std::vector<std::uint8_t> exif{
      0xff, 0xe1, 0,    34, 'E', 'x', 'i', 'f', 0, 0,  // APP1
      'I',  'I',  0x2a, 0,  8,   0,   0,   0,          // TIFF, little endian
      1,    0,    0x12, 1,  3,   0,   1,   0,   0, 0, orientation, 0, 0, 0, 0, 0, 0, 0};
  jpeg.insert(jpeg.begin() + 2, exif.begin(), exif.end());
  return jpeg;
}

TEST(Photo, IsUprightAsItsExifSays) {
  const test::TemporaryFolder folder;
  cv::Mat picture(80, 120, CV_8UC3, cv::Scalar(255, 255, 255));
  picture(cv::Rect(0, 0, 40, 30)) = cv::Scalar(0, 0, 255);  // red, upper left as stored
  const auto bytes = turned_jpeg(picture, 6);               // to be turned clockwise
  const Photo photo = read_photo(folder.write("a.jpg", {bytes.begin(), bytes.end()}));
  EXPECT_EQ(photo.width, 80);
  EXPECT_EQ(photo.height, 120);
  const std::uint8_t* corner = &photo.rgb[3 * (5 * 80 + 75)];  // upper right as shown
  EXPECT_GT(corner[0], 240);
  EXPECT_LT(corner[1], 15);
  EXPECT_GT(photo.rgb[1], 240);
}

TEST(Photo, GreyDeepAndTransparentPicturesBecomeEightBitColours) {
  const test::TemporaryFolder folder;
  cv::imwrite((folder / "grey.png").string(), cv::Mat(70, 90, CV_16U, cv::Scalar(0x8000)));
  cv::imwrite((folder / "clear.png").string(), cv::Mat(70, 90, CV_8UC4, cv::Scalar(1, 2, 3, 4)));
  const Photo grey = read_photo(folder / "grey.png"), clear = read_photo(folder / "clear.png");
  EXPECT_EQ(grey.rgb.size(), 3U * 70 * 90);
  EXPECT_NEAR(grey.rgb[0], 128, 1);
  EXPECT_EQ(clear.rgb[0], 3);
}

TEST(Photo, WhatIsNoPhotographIsRefusedByName) {
  const test::TemporaryFolder folder;
  expect_error(ErrorKind::input, {"none.jpg", "does not exist"},
               [&] { read_photo(folder / "none.jpg"); });
  const auto text = folder.write("text.jpg", "no picture");
  expect_error(ErrorKind::input, {"text.jpg", "cannot be read"}, [&] { read_photo(text); });
  const std::string claim("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\1\0\0\0\1\0\0\x08\2\0\0\0", 29);
  const auto huge = folder.write("huge.png", claim);
  expect_error(ErrorKind::input, {"huge.png", "65536"}, [&] { read_photo(huge); });
  cv::imwrite((folder / "tiny.png").string(), cv::Mat(20, 20, CV_8UC3, cv::Scalar(1, 2, 3)));
  expect_error(ErrorKind::input, {"tiny.png", "20 x 20"}, [&] { read_photo(folder / "tiny.png"); });
}

TEST(SkinCharts, LayEachWantedTriangleOutWithoutOverlap) {
  const TriangleMesh& skin = scene().skin.mesh();
  std::vector<bool> wanted(static_cast<std::size_t>(skin.triangles.rows()));
  for (std::size_t f = 0; f < wanted.size(); ++f) {
    wanted[f] = skin.vertices(skin.triangles(static_cast<Eigen::Index>(f), 0), 1) < 40;
  }
  Progress progress;
  const SkinCharts charts = lay_out(skin, wanted, {0.5, 3}, progress);
  EXPECT_EQ(charts.mm_per_pixel, 0.5);
  std::vector<int> taken(static_cast<std::size_t>(charts.width * charts.height));
  double least = 1e9;
  for (Eigen::Index f = 0; f < skin.triangles.rows(); ++f) {
    ASSERT_EQ(charts.corners(f, 0) >= 0, wanted[static_cast<std::size_t>(f)]);
    if (charts.corners(f, 0) < 0) continue;
    std::array<Vector2d, 3> corner;
    std::array<Vector3d, 3> place;
    for (int k = 0; k < 3; ++k) {
      corner[static_cast<std::size_t>(k)] = charts.places.row(charts.corners(f, k));
      place[static_cast<std::size_t>(k)] = skin.vertices.row(skin.triangles(f, k));
    }
    const Vector2d a = corner[1] - corner[0], b = corner[2] - corner[0];
    const double flat = std::abs(a.x() * b.y() - a.y() * b.x());
    const double real = (place[1] - place[0]).cross(place[2] - place[0]).norm();
    least = std::min(least, flat * 0.25 / real);
    for_each_pixel(corner, charts.width, charts.height, [&](int x, int y, const Vector3d& w) {
      if (w.minCoeff() > 1e-6) ++taken[static_cast<std::size_t>(y * charts.width + x)];
    });
  }
  EXPECT_LE(*std::max_element(taken.begin(), taken.end()), 1);
  EXPECT_GT(least, 0.44);  // as SkinCharts::mm_per_pixel says
  EXPECT_LT(charts.pieces.size(), 400U);
}

TEST(SkinCharts, BecomeCoarserWhereThePictureWouldBeTooLarge) {
  const TriangleMesh& skin = scene().skin.mesh();
  Progress progress;
  const std::vector<bool> all(static_cast<std::size_t>(skin.triangles.rows()), true);
  const SkinCharts charts = lay_out(skin, all, {0.1, 1, 700}, progress);
  EXPECT_LE(std::max(charts.width, charts.height), 700);
  EXPECT_GT(charts.mm_per_pixel, 0.4);
  EXPECT_LT(charts.mm_per_pixel, 2);
}

std::shared_ptr<const Photo> taken(const PhotoCamera& camera, const test::Light& light = {}) {
  return std::make_shared<const Photo>(
      test::photograph(camera, scene().skin, scene().paint, light));
}

std::vector<MarkedPhoto> three_photos() {
  const Scene& s = scene();
  const PhotoCamera right = test::camera_from(-88, 2, 0, 1400, 85, 640);
  return {{"front.jpg", taken(s.front), exact(s.front), {}},
          {"left.jpg", taken(s.left, {{0.8, 0.9, 1.1}}), exact(s.left), {}},
          {"right.jpg", taken(right, {{1.1, 1, 0.85}}), exact(right), {}}};
}

const ProjectedPhotographs& projected() {
  static const ProjectedPhotographs the_projected = [] {
    Progress progress;
    PaintOptions options;
    options.mm_per_pixel = 0.6;
    return project_photographs(three_photos(), scene().skin, options, progress);
  }();
  return the_projected;
}

/// sRGB 0..1 of the painted skin at a triangle's middle.
Vector3d painted_colour(const PaintedSkin& painted, Eigen::Index f) {
  Vector2d at = painted.charts.plain;
  if (painted.charts.corners(f, 0) >= 0) {
    at.setZero();
    for (const int row : painted.charts.corners.row(f)) at += painted.charts.places.row(row) / 3;
  }
  const auto x = static_cast<std::size_t>(std::lround(at.x())),
             y = static_cast<std::size_t>(std::lround(at.y()));
  const std::uint8_t* c =
      &painted.picture.rgb[3 * (y * static_cast<std::size_t>(painted.picture.width) + x)];
  return Vector3d(c[0], c[1], c[2]) / 255;
}

Vector3d middle_of(Eigen::Index f) {
  const TriangleMesh& skin = scene().skin.mesh();
  return (skin.vertices.row(skin.triangles(f, 0)) + skin.vertices.row(skin.triangles(f, 1)) +
          skin.vertices.row(skin.triangles(f, 2))) /
         3;
}

TEST(Projection, GivesTheSkinItsColours) {
  const PaintedSkin& painted = projected().painted;
  std::vector<double> errors;
  for (Eigen::Index f = 0; f < scene().skin.mesh().triangles.rows(); ++f) {
    const Vector3d at = middle_of(f);
    const bool face = at.y() < -20 && at.z() > -95 && at.z() < 60;
    if (!face) continue;
    errors.push_back((painted_colour(painted, f) - scene().paint.colour(at)).cwiseAbs().mean());
  }
  EXPECT_GT(errors.size(), 5000U);
  EXPECT_LT(share(errors, 0.5), 0.03);
  EXPECT_LT(share(errors, 0.95), 0.12);
}

TEST(Projection, MatchesThePhotographsColoursToTheFirst) {
  const PaintedSkin& painted = projected().painted;
  EXPECT_LT((painted.photos[0].gain - Vector3d(1, 1, 1)).norm(), 1e-3);
  EXPECT_LT((painted.photos[1].gain - Vector3d(1 / 0.8, 1 / 0.9, 1 / 1.1)).cwiseAbs().maxCoeff(),
            0.05);
  EXPECT_LT((painted.photos[2].gain - Vector3d(1 / 1.1, 1, 1 / 0.85)).cwiseAbs().maxCoeff(), 0.05);
  EXPECT_LT(painted.disagreement, 0.03);
}

TEST(Projection, SaysWhatIsSeenAndLeavesTheRestPlain) {
  const PaintedSkin& painted = projected().painted;
  EXPECT_GT(painted.seen_cm2, painted.photos[0].seen_cm2);
  EXPECT_LT(painted.seen_cm2,
            painted.photos[0].seen_cm2 + painted.photos[1].seen_cm2 + painted.photos[2].seen_cm2);
  EXPECT_GT(painted.inpainted_cm2, 0);
  EXPECT_LT(painted.seen_cm2 + painted.inpainted_cm2, painted.skin_cm2);
  int plain = 0;
  for (Eigen::Index f = 0; f < scene().skin.mesh().triangles.rows(); ++f) {
    if (painted.charts.corners(f, 0) >= 0) continue;
    ++plain;
    EXPECT_LT((painted_colour(painted, f) - painted.plain).cwiseAbs().maxCoeff(), 0.01);
  }
  EXPECT_GT(plain, 1000);
}

TEST(Projection, DoesNotPaintThroughTheSkin) {
  const Scene& s = scene();
  Progress progress;
  const std::vector<MarkedPhoto> photos{{"front.jpg", taken(s.front), exact(s.front), {}}};
  PaintOptions options;
  options.mm_per_pixel = 1;
  options.inpaint_mm = 5;
  const PaintedSkin painted = project_photographs(photos, s.skin, options, progress).painted;
  for (Eigen::Index f = 0; f < s.skin.mesh().triangles.rows(); ++f) {
    if (middle_of(f).y() <= 30) continue;
    EXPECT_LT(painted.charts.corners(f, 0), 0);
  }
  EXPECT_EQ(painted.photos[0].seen_cm2, painted.seen_cm2);
  EXPECT_EQ(painted.disagreement, 0);
}

TEST(Projection, IsAPhotographLikeAnyOther) {
  const test::TemporaryFolder folder;
  write_projection(projected(), scene().skin.mesh(), folder.path());
  const ObjDocument document = ObjDocument::read(folder / "photograph.obj");
  const TexturedMesh& mesh = document.mesh();
  EXPECT_TRUE(mesh.surface.vertices == scene().skin.mesh().vertices);
  EXPECT_TRUE(mesh.surface.triangles == scene().skin.mesh().triangles);
  EXPECT_GE(mesh.corner_texture.minCoeff(), 0);
  EXPECT_GT(mesh.texture_coordinates.minCoeff(), 0);
  EXPECT_LT(mesh.texture_coordinates.maxCoeff(), 1);
  EXPECT_EQ(mesh.materials.at(0).texture, folder / "photograph.png");
  const std::string json = test::bytes_of(folder / "projection.json");
  EXPECT_NE(json.find("uncertainty_mm"), std::string::npos);
  EXPECT_EQ(json.find("left.jpg"), std::string::npos);  // a file's name may be a patient's
}

TEST(Projection, CarriesNothingButPixelsOver) {
  const std::string png = png_of(projected().painted.picture);
  std::set<std::string> chunks;
  for (std::size_t at = 8; at + 8 <= png.size();) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(png[at + i]); };
    const std::size_t length = byte(0) << 24U | byte(1) << 16U | byte(2) << 8U | byte(3);
    chunks.insert(png.substr(at + 4, 4));
    at += length + 12;
  }
  EXPECT_EQ(chunks, (std::set<std::string>{"IHDR", "IDAT", "IEND"}));
}

TEST(Projection, TakesThePhotographsPlaceInThePlan) {
  SurgicalCase plan;
  plan.region.vertices = {1, 2};
  const SurgicalCase of_skin = with_projection(plan, "folder");
  EXPECT_EQ(of_skin.photograph->obj, "folder/photograph.obj");
  EXPECT_TRUE(of_skin.photograph->lps_from_photograph == Similarity{});
  EXPECT_EQ(of_skin.region.vertices, plan.region.vertices);
  plan.photograph = PhotographSource{"other.obj", {}};
  EXPECT_TRUE(with_projection(plan, "folder").region.vertices.empty());
}

TEST(Projection, NamesThePhotographThatIsWrong) {
  Progress progress;
  std::vector<MarkedPhoto> photos = three_photos();
  photos[1].landmarks.resize(3);
  expect_error(ErrorKind::input, {"left.jpg", "are 3"},
               [&] { project_photographs(photos, scene().skin, {}, progress); });
  expect_error(ErrorKind::input, {"none is given"},
               [&] { project_photographs({}, scene().skin, {}, progress); });
  progress.cancel();
  expect_error(ErrorKind::cancelled, {},
               [&] { project_photographs(three_photos(), scene().skin, {}, progress); });
}

TEST(PhotoMarks, AreReadStrictly) {
  const test::TemporaryFolder folder;
  const auto good = folder.write(
      "good.json",
      R"({"landmarks": {"nose_tip": [10, 20.5], "nasion": [1, 2]}, "focal_35mm": 50})");
  const PhotoMarks marks = read_photo_marks(good);
  EXPECT_EQ(marks.pixels.at("nose_tip"), Vector2d(10, 20.5));
  EXPECT_EQ(marks.camera.focal_35mm, 50);
  const auto wrong = folder.write("wrong.json", R"({"landmarks": {"nose_tip": [10]}})");
  expect_error(ErrorKind::case_file, {"wrong.json: landmarks.nose_tip", "two numbers"},
               [&] { read_photo_marks(wrong); });
  const auto unknown = folder.write("unknown.json", R"({"landmarks": {}, "zoom": 2})");
  expect_error(ErrorKind::case_file, {"zoom"}, [&] { read_photo_marks(unknown); });
  expect_error(ErrorKind::input, {"good.json", "nasion", "--landmarks"}, [&] {
    paired(marks, {{"nose_tip", Vector3d(1, 2, 3)}}, good.string());
  });
  const auto skin =
      folder.write("skin.json", R"({"other": 1, "landmarks": {"nasion": [1, 2, 3]}})");
  EXPECT_EQ(read_skin_landmarks(skin).at("nasion"), Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace gnathion
