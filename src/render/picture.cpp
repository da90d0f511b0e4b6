#include "render/picture.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/error.h"

namespace gnathion {

void write_png(const Picture& picture, const std::filesystem::path& path) {
  const cv::Mat rgb(picture.height, picture.width, CV_8UC3,
                    const_cast<std::uint8_t*>(picture.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  std::vector<std::uint8_t> png;
  cv::imencode(".png", bgr, png, {cv::IMWRITE_PNG_COMPRESSION, 5});
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  file.close();
  if (!file) {
    throw Error(
        ErrorKind::output, path.string(), "the picture cannot be written",
        "choose a folder that exists and may be written, and see that the disk is not full");
  }
}

Picture read_picture_file(const std::filesystem::path& path) {
  cv::Mat bgr;
  if (std::filesystem::is_regular_file(path)) {
    bgr = cv::imread(path.string(), cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  }
  if (bgr.empty()) {
    throw Error(ErrorKind::input, path.string(), "missing, or no picture",
                "give a PNG or JPEG file");
  }
  Picture picture{bgr.cols, bgr.rows, std::vector<std::uint8_t>(3 * bgr.total())};
  cv::Mat rgb(bgr.rows, bgr.cols, CV_8UC3, picture.rgb.data());
  cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
  return picture;
}

Picture tiled(const std::vector<std::vector<Picture>>& rows, int gap) {
  if (rows.empty() || rows.front().empty()) throw std::invalid_argument("tiled: no pictures");
  const int w = rows.front().front().width, h = rows.front().front().height;
  const int columns = static_cast<int>(rows.front().size());
  Picture whole;
  whole.width = columns * w + (columns - 1) * gap;
  whole.height = static_cast<int>(rows.size()) * (h + gap) - gap;
  whole.rgb.assign(static_cast<size_t>(whole.width) * whole.height * 3, 255);
  for (size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].size() != rows.front().size()) throw std::invalid_argument("tiled: ragged rows");
    for (size_t c = 0; c < rows[r].size(); ++c) {
      const Picture& tile = rows[r][c];
      if (tile.width != w || tile.height != h) throw std::invalid_argument("tiled: sizes differ");
      for (int y = 0; y < h; ++y) {
        const auto x0 = static_cast<int>(c) * (w + gap);
        const auto y0 = static_cast<int>(r) * (h + gap) + y;
        std::copy_n(tile.at(0, y), 3 * w,
                    &whole.rgb[static_cast<size_t>(3 * (y0 * whole.width + x0))]);
      }
    }
  }
  return whole;
}

}  // namespace gnathion
