#include "projection/photo.h"

#include <cstring>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/error.h"
#include "scan/picture_size.h"

namespace gnathion {
namespace {

constexpr int kLeast = 64;  // pixels: fewer show no face

cv::Mat decoded(const std::filesystem::path& file) {
  cv::Mat picture;
  try {
    picture = cv::imread(file.string(), cv::IMREAD_COLOR);  // turns as EXIF says
  } catch (const cv::Exception&) {
    picture.release();  // told below like any picture that cannot be read
  }
  return picture;
}

}  // namespace

Photo read_photo(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    throw Error(ErrorKind::input, file.string(), "does not exist", "check the photograph's path");
  }
  check_picture_size(file);
  cv::Mat picture = decoded(file);
  if (picture.empty()) {
    throw Error(ErrorKind::input, file.string(), "cannot be read as a picture",
                "open it in an image program and save it again as JPEG or PNG");
  }
  if (picture.cols < kLeast || picture.rows < kLeast) {
    throw Error(ErrorKind::input, file.string(),
                "is only " + std::to_string(picture.cols) + " x " + std::to_string(picture.rows) +
                    " pixels large",
                "give a photograph in which the face is some hundred pixels high");
  }
  cv::cvtColor(picture, picture, cv::COLOR_BGR2RGB);
  Photo photo{picture.cols, picture.rows, {}};
  photo.rgb.assign(picture.datastart, picture.dataend);
  return photo;
}

std::string png_of(const Photo& photo) {
  // imencode reads only.
  const cv::Mat rgb(photo.height, photo.width, CV_8UC3,
                    const_cast<std::uint8_t*>(photo.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", bgr, bytes, {cv::IMWRITE_PNG_COMPRESSION, 4});
  return {bytes.begin(), bytes.end()};
}

}  // namespace gnathion
