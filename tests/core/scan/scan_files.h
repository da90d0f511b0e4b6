#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "scan/scan_import.h"
#include "support/temporary_folder.h"

namespace gnathion::test {

/// The bytes of numbers, as this machine and most files have them.
template <typename T>
std::string raw(const std::vector<T>& numbers) {
  std::string bytes(numbers.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

/// A picture of four colours: red and green above, blue and white below.
inline std::string picture_bytes(const std::string& ending, int side = 8) {
  cv::Mat picture(side, side, CV_8UC3);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const bool right = x >= side / 2, low = y >= side / 2;
      picture.at<cv::Vec3b>(y, x) = low ? (right ? cv::Vec3b(255, 255, 255) : cv::Vec3b(255, 0, 0))
                                        : (right ? cv::Vec3b(0, 255, 0) : cv::Vec3b(0, 0, 255));
    }
  }
  std::vector<unsigned char> bytes;
  cv::imencode(ending, picture, bytes);
  return {bytes.begin(), bytes.end()};
}

/// A GLB of this JSON and these bytes.
inline std::string glb(std::string json, std::string bytes) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
  const auto number = [](std::size_t n) { return raw<std::uint32_t>({std::uint32_t(n)}); };
  std::string file = "glTF" + number(2) + number(12 + 8 + json.size() + 8 + bytes.size());
  file += number(json.size()) + "JSON" + json;
  return file + number(bytes.size()) + std::string("BIN\0", 4) + bytes;
}

/// A square of two triangles whose second corner pair is split at a seam: positions 6, of them 4
/// different; texture coordinates, colours (amounts of light), indices; two materials' worth.
struct SquareGltf {
  std::string positions = raw<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0});
  std::string uv = raw<float>({0, 0, 0.5, 0, 0.5, 0.5, 0.5, 0.5, 1, 1, 0.5, 1});
  std::string colours = raw<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0.5, 0.5, 0.5});
  std::string indices = raw<std::uint16_t>({0, 1, 2, 3, 4, 5});
  std::string image = picture_bytes(".png");
  std::string node = R"("mesh":0)";
  std::string image_json = R"("bufferView":4,"mimeType":"image/png")";

  std::string bytes() const { return positions + uv + colours + indices + image; }
  std::string json(const std::string& buffer = "") const {
    const auto view = [](std::size_t at, std::size_t size) {
      return R"({"buffer":0,"byteOffset":)" + std::to_string(at) + R"(,"byteLength":)" +
             std::to_string(size) + "}";
    };
    const std::size_t a = positions.size(), b = a + uv.size(), c = b + colours.size(),
                      d = c + indices.size();
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{)" + node +
           R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1,"COLOR_0":2},)"
           R"("indices":3,"material":0}]}],"materials":[{"name":"skin","pbrMetallicRoughness":)"
           R"({"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],"images":[{)" +
           image_json + R"(}],"buffers":[{)" + buffer + R"("byteLength":)" +
           std::to_string(bytes().size()) + R"(}],"bufferViews":[)" + view(0, a) + "," +
           view(a, b - a) + "," + view(b, c - b) + "," + view(c, d - c) + "," +
           view(d, image.size()) +
           R"(],"accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3",)"
           R"("min":[0,0,0],"max":[1,1,0]},)"
           R"({"bufferView":1,"componentType":5126,"count":6,"type":"VEC2"},)"
           R"({"bufferView":2,"componentType":5126,"count":6,"type":"VEC3"},)"
           R"({"bufferView":3,"componentType":5123,"count":6,"type":"SCALAR"}]})";
  }
};

inline ObjDocument read(const std::filesystem::path& file) {
  Progress progress;
  return read_scan(file, progress);
}

}  // namespace gnathion::test
