#include "scan_stream/scan_stream.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace gnathion {
namespace {

RawScan small_scan() {
  RawScan scan;
  scan.surface.vertices = Points::Random(4, 3);
  scan.surface.triangles = (Triangles(2, 3) << 0, 1, 2, 0, 2, 3).finished();
  scan.colours = Points::Constant(4, 3, 0.5);
  scan.texture_coordinates.setRandom(3, 2);
  scan.corner_texture = (Triangles(2, 3) << 0, 1, 2, -1, -1, -1).finished();
  scan.material = {0, -1};
  scan.materials = {{"skin", {1, 0.5, 0.25}, 0}};
  scan.textures = {{"a b.png", true, std::string("\0\1\2", 3)}};
  scan.notices = {"something is not kept"};
  return scan;
}

TEST(ScanStream, GivesBackWhatWasWritten) {
  const RawScan scan = small_scan();
  const auto result = scan_of_bytes(scan_bytes(scan), "a.glb");
  const RawScan& back = std::get<RawScan>(result);
  EXPECT_EQ(back.surface.vertices, scan.surface.vertices);
  EXPECT_EQ(back.surface.triangles, scan.surface.triangles);
  EXPECT_EQ(back.colours, scan.colours);
  EXPECT_EQ(back.texture_coordinates, scan.texture_coordinates);
  EXPECT_EQ(back.corner_texture, scan.corner_texture);
  EXPECT_EQ(back.material, scan.material);
  EXPECT_EQ(back.materials[0].diffuse, scan.materials[0].diffuse);
  EXPECT_EQ(back.textures[0].bytes, scan.textures[0].bytes);
  EXPECT_EQ(back.notices, scan.notices);
  const auto failure = scan_of_bytes(scan_bytes(ScanFailure{"a", "b", "c"}), "a.glb");
  EXPECT_EQ(std::get<ScanFailure>(failure).remedy, "c");
}

TEST(ScanStream, CutAnywhereIsRefused) {
  const std::string bytes = scan_bytes(small_scan());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_THROW(scan_of_bytes(bytes.substr(0, length), "a.glb"), Error) << length;
  }
  EXPECT_THROW(scan_of_bytes(bytes + "x", "a.glb"), Error);
}

TEST(ScanStream, WithAnyByteChangedIsReadOrRefusedButNeverOutOfRange) {
  const std::string good = scan_bytes(small_scan());
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const char change : {'\x01', '\x80', '\xff'}) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ change);
      try {
        const auto result = scan_of_bytes(bad, "a.glb");
        if (const auto* scan = std::get_if<RawScan>(&result)) {
          EXPECT_TRUE(scan->surface.vertices.allFinite());
          EXPECT_LT(scan->surface.triangles.maxCoeff(), scan->surface.vertices.rows());
        }
      } catch (const Error&) {
      }
    }
  }
}

TEST(ScanStream, PromisingTooMuchIsRefusedBeforeRoomIsMade) {
  std::string bytes = scan_bytes(small_scan());
  bytes.replace(9, 8, std::string("\xff\xff\xff\xff\xff\xff\xff\x0f", 8));
  test::expect_error(ErrorKind::input, {"a.glb", "ends too early"},
                     [&] { scan_of_bytes(bytes, "a.glb"); });
}

}  // namespace
}  // namespace gnathion
