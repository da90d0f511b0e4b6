#include "scan/picture_size.h"

#include <gtest/gtest.h>

#include "core/scan/scan_files.h"
#include "support/expect_error.h"

namespace gnathion {
namespace {

using test::picture_bytes;
using test::TemporaryFolder;

TEST(PictureSize, IsReadFromEachFormat) {
  const TemporaryFolder folder;
  for (const std::string ending : {".png", ".jpg", ".bmp", ".tiff"}) {
    const auto size = picture_size(folder.write("a" + ending, picture_bytes(ending, 300)));
    ASSERT_TRUE(size) << ending;
    EXPECT_EQ(size->width, 300U) << ending;
    EXPECT_EQ(size->height, 300U) << ending;
  }
  EXPECT_FALSE(picture_size(folder.write("a.txt", "no picture")));
  EXPECT_FALSE(picture_size(folder / "none.png"));
}

TEST(PictureSize, OfABombIsRefusedWhenTheScanIsRead) {
  const TemporaryFolder folder;
  std::string png = picture_bytes(".png");
  png.replace(16, 8, std::string("\0\0\xff\xff\0\0\xff\xff", 8));
  folder.write("bomb.png", png);
  folder.write("a.mtl", "newmtl a\nmap_Kd bomb.png\n");
  const auto obj = folder.write(
      "a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
  test::expect_error(ErrorKind::input, {"bomb.png", "65535 x 65535"}, [&] { test::read(obj); });
  test::SquareGltf square;
  square.image = png;
  const auto file = folder.write("a.glb", test::glb(square.json(), square.bytes()));
  test::expect_error(ErrorKind::input, {"65535 x 65535"}, [&] { test::read(file); });
}

TEST(PictureSize, OfAnyCutPictureDoesNoHarm) {
  const TemporaryFolder folder;
  for (const std::string ending : {".png", ".jpg", ".bmp", ".tiff"}) {
    const std::string good = picture_bytes(ending, 16);
    for (std::size_t length = 0; length < std::min<std::size_t>(good.size(), 700); ++length) {
      check_picture_size(folder.write("cut" + ending, good.substr(0, length)));
    }
  }
}

}  // namespace
}  // namespace gnathion
