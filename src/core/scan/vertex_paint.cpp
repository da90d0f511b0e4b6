#include "scan/vertex_paint.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "base/error.h"

namespace gnathion {
namespace {

/// The stored pixels: texture coordinates refer to them, whatever EXIF says of turning.
cv::Mat picture_of(const std::filesystem::path& file) {
  cv::Mat picture;
  try {
    picture = cv::imread(file.string(), cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    picture.release();  // told below like any picture that cannot be read
  }
  if (picture.empty()) {
    throw Error(ErrorKind::input, file.string(), "the texture image cannot be read",
                "open it in an image program and save it again as JPEG or PNG");
  }
  return picture;
}

/// The nearest pixel of a picture that repeats itself beyond 0..1. v up.
Eigen::RowVector3d colour_at(const cv::Mat& picture, const Eigen::RowVector2d& uv) {
  const auto pixel = [](double x, int size) {
    const double within = x - std::floor(x);
    return std::clamp(static_cast<int>(within * size), 0, size - 1);
  };
  const auto bgr =
      picture.at<cv::Vec3b>(pixel(1 - uv.y(), picture.rows), pixel(uv.x(), picture.cols));
  return Eigen::RowVector3d(bgr[2], bgr[1], bgr[0]) / 255;
}

}  // namespace

Points vertex_paint(const ObjDocument& document) {
  if (document.vertex_colours().rows() > 0) return document.vertex_colours();
  const TexturedMesh& mesh = document.mesh();
  std::vector<cv::Mat> pictures;
  for (const Material& material : mesh.materials) {
    pictures.push_back(material.texture.empty() ? cv::Mat() : picture_of(material.texture));
  }
  Points paint = Points::Constant(mesh.surface.vertices.rows(), 3, Material().diffuse.x());
  std::vector<bool> painted(static_cast<std::size_t>(paint.rows()), false);
  for (Eigen::Index f = 0; f < mesh.surface.triangles.rows(); ++f) {
    const int material = mesh.triangle_material[static_cast<std::size_t>(f)];
    if (material < 0) continue;
    const auto m = static_cast<std::size_t>(material);
    for (int k = 0; k < 3; ++k) {
      const int v = mesh.surface.triangles(f, k), uv = mesh.corner_texture(f, k);
      if (painted[v]) continue;
      painted[v] = true;
      paint.row(v) = pictures[m].empty() || uv < 0
                         ? mesh.materials[m].diffuse.transpose()
                         : colour_at(pictures[m], mesh.texture_coordinates.row(uv));
    }
  }
  return paint;
}

}  // namespace gnathion
