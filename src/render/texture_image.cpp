#include "render/texture_image.h"

#include <algorithm>
#include <vector>

#include <vtkImageData.h>
#include <vtkTexture.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/error.h"

namespace gnathion {
namespace {

constexpr int largest_side = 8192;  // pixels

cv::Mat read_picture(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) {
    throw Error(ErrorKind::input, path.string(), "the texture image does not exist",
                "put the image beside the .mtl file that names it, or correct map_Kd there");
  }
  cv::Mat picture;
  try {
    picture = cv::imread(path.string(), cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    picture.release();  // too many pixels, or a codec gave up: told below like any unreadable file
  }
  if (picture.empty()) {
    throw Error(ErrorKind::input, path.string(), "the texture image cannot be read",
                "open it in an image program and save it again as JPEG or PNG");
  }
  return picture;
}

void shrink_to_limit(cv::Mat& picture) {
  const int side = std::max(picture.cols, picture.rows);
  if (side <= largest_side) return;
  const double scale = static_cast<double>(largest_side) / side;
  cv::Mat smaller;
  cv::resize(picture, smaller, cv::Size(), scale, scale, cv::INTER_AREA);
  picture = smaller;
}

/// VTK's first row is the lowest one and its order is RGB.
vtkSmartPointer<vtkImageData> to_vtk(const cv::Mat& bgr) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(bgr.cols, bgr.rows, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  cv::Mat view(bgr.rows, bgr.cols, CV_8UC3, image->GetScalarPointer());
  cv::flip(bgr, view, 0);
  cv::cvtColor(view, view, cv::COLOR_BGR2RGB);
  return image;
}

}  // namespace

vtkSmartPointer<vtkImageData> read_texture(const std::filesystem::path& path) {
  cv::Mat picture = read_picture(path);
  shrink_to_limit(picture);
  return to_vtk(picture);
}

vtkSmartPointer<vtkTexture> texture_of(vtkImageData* image) {
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputDataObject(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  // With mipmaps VTK asks for fourfold anisotropic filtering, which stalls software OpenGL for
  // half a minute in the first frame.
  texture->SetMaximumAnisotropicFiltering(1);
  return texture;
}

}  // namespace gnathion
