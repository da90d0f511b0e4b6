#include "render/compare_scene.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "base/error.h"
#include "offscreen/osmesa_window.h"
#include "render/baseline.h"
#include "render/movie_file.h"
#include "render/scene_fixture.h"
#include "render/wrapped_words.h"

namespace gnathion::test {
namespace {

class CompareSceneTest : public SceneTest {
 protected:
  CompareSceneTest() : compare(scene) {
    scene.set_face(head);
    Points moved = head.surface.vertices;
    for (Eigen::Index v = 0; v < moved.rows(); ++v) {
      if (moved(v, 1) < -40 && moved(v, 2) < -30) moved(v, 1) -= 12;  // the chin forward
    }
    after = moved;
    scene.set_face_points(after);
    window->SetMultiSamples(0);
    window->SetSize(360, 300);
    window->AddRenderer(scene.renderer());
    compare.attach(window);
    compare.before().set_face(head);
    compare.before().set_label("Before");
    scene.set_label("Predicted");
    scene.look_from(CameraPreset::left, 1.2);
  }
  ~CompareSceneTest() override {
    compare.detach();
    window->MakeCurrent();
    scene.renderer()->ReleaseGraphicsResources(window);
    window->RemoveRenderer(scene.renderer());
  }

  Picture drawn() {
    window->Render();
    vtkNew<vtkUnsignedCharArray> bytes;
    window->GetPixelData(0, 0, 359, 299, 0, bytes, 0);
    Picture picture{360, 300, std::vector<std::uint8_t>(std::size_t{3} * 360 * 300)};
    for (int y = 0; y < 300; ++y) {
      std::memcpy(&picture.rgb[static_cast<std::size_t>(3 * 360 * y)],
                  bytes->GetPointer(3 * 360 * (299 - y)), std::size_t{3} * 360);
    }
    return picture;
  }

  /// Pixels that differ between columns, without the words above and below.
  static int differing(const Picture& a, const Picture& b, int from, int to) {
    int count = 0;
    for (int y = 60; y < 270; ++y) {
      for (int x = from; x < to; ++x) {
        count += std::abs(a.at(x, y)[0] - b.at(x, y)[0]) > 12 ? 1 : 0;
      }
    }
    return count;
  }

  vtkNew<OsmesaWindow> window;
  CompareScene compare;
  Points after;
};

TEST_F(CompareSceneTest, WipeShowsEachFaceInItsPlace) {
  const Picture predicted = drawn();
  scene.set_face_points(head.surface.vertices);
  const Picture before = drawn();
  scene.set_face_points(after);
  compare.set_mode(CompareMode::wipe);
  for (const double wipe : {0.3, 0.6}) {
    compare.set_wipe(wipe);
    const Picture picture = drawn();
    const int divider = static_cast<int>(wipe * 360);
    EXPECT_LT(differing(picture, before, 0, divider - 20), 30) << wipe;
    EXPECT_LT(differing(picture, predicted, divider + 20, 360), 30) << wipe;
  }
  EXPECT_GT(differing(before, predicted, 0, 360), 300);
  compare.set_wipe(0.45);
  EXPECT_TRUE(matches_baseline(drawn(), "wipe"));
}

TEST_F(CompareSceneTest, DetachGivesThePictureBack) {
  const Picture predicted = drawn();
  compare.set_mode(CompareMode::side_by_side);
  EXPECT_GT(differing(predicted, drawn(), 0, 360), 1000);
  compare.detach();
  EXPECT_EQ(drawn(), predicted);
}

TEST_F(CompareSceneTest, FullBlendIsTheFaceBefore) {
  scene.set_face_points(head.surface.vertices);
  const Picture before = drawn();
  scene.set_face_points(after);
  compare.set_mode(CompareMode::blend);
  compare.set_blend(0.5);
  EXPECT_GT(differing(before, drawn(), 0, 360), 100);
  compare.set_blend(1);
  EXPECT_LT(differing(before, drawn(), 0, 360), 30);
}

TEST_F(CompareSceneTest, ProfileIsDrawn) {
  compare.set_mode(CompareMode::profile);
  Points before(3, 3), moved(3, 3);
  before << 0, -60, 40, 0, -90, 0, 0, -60, -40;
  moved << 0, -60, 40, 0, -98, 0, 0, -60, -40;
  compare.profile().show({{before}, {moved}, {{"Tip", before.row(1), moved.row(1)}}});
  compare.profile().set_words({"A profile"});
  compare.profile().frame({0, -110, -60}, {0, -30, 60}, 1.2);
  EXPECT_TRUE(matches_baseline(drawn(), "profile"));
}

TEST_F(CompareSceneTest, SideBySideJoinsPlacesOfBothHalves) {
  compare.set_mode(CompareMode::side_by_side);
  EXPECT_TRUE(compare.shows_before(0.2));
  EXPECT_FALSE(compare.shows_before(0.7));
  EXPECT_DOUBLE_EQ(compare.in_predicted(0.2), 0.7);
  EXPECT_DOUBLE_EQ(compare.in_predicted(0.7), 0.7);
}

TEST(MovieFile, IsReadBackByItsOwnLists) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("gnathion_" + std::to_string(::getpid()) + ".avi");
  const Picture grey{16, 8, std::vector<std::uint8_t>(16 * 8 * 3, 90)};
  {
    MovieFile dropped(file, 16, 8, 24);
    dropped.add(grey);
  }
  EXPECT_FALSE(std::filesystem::exists(file));
  MovieFile film(file, 16, 8, 24);
  for (int i = 0; i < 3; ++i) film.add(grey);
  EXPECT_THROW(film.add(Picture{8, 8, std::vector<std::uint8_t>(8 * 8 * 3)}),
               std::invalid_argument);
  film.finish();
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, &bytes[at], 4);
    return value;
  };
  EXPECT_EQ(number(4) + 8, bytes.size());
  EXPECT_EQ(number(48), 3U);  // pictures, in the main header
  const std::size_t movi = bytes.find("movi"), index = bytes.find("idx1");
  ASSERT_NE(index, std::string::npos);
  EXPECT_EQ(number(movi - 4) + movi, index);
  EXPECT_EQ(number(index + 4), 3 * 16U);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t place = movi + number(index + 8 + 16 * i + 8);
    EXPECT_EQ(bytes.substr(place, 4), "00dc");
    EXPECT_EQ(bytes.substr(place + 8, 2), "\xff\xd8");  // a JPEG begins
  }
  std::filesystem::remove(file);
  EXPECT_THROW(MovieFile("no/such/folder/film.avi", 16, 8, 24), Error);
}

TEST(Wrapped, BreaksAtBlanks) {
  EXPECT_EQ(wrapped("one two three", 7), "one two\nthree");
  EXPECT_EQ(wrapped("a\nbb cc", 20), "a\nbb cc");
  EXPECT_EQ(wrapped("unbreakable", 3), "unbreakable");
  EXPECT_EQ(wrapped("übung übung", 11), "übung übung");
}

}  // namespace
}  // namespace gnathion::test
