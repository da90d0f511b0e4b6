#pragma once

#include <gtest/gtest.h>
#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "offscreen/offscreen.h"
#include "render/painted_head.h"

namespace gnathion::test {

/// A painted head in a scene, and a folder that goes when the test ends. No test of this program
/// may need an X server: DISPLAY names one that does not exist, which would end the process.
class SceneTest : public testing::Test {
 protected:
  SceneTest() {
    ::setenv("DISPLAY", ":60999", 1);
    std::filesystem::create_directories(folder);
    head = painted_head(folder);
  }
  ~SceneTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }

  Picture front() { return render_picture(scene, CameraPreset::front, 320, 320); }

  /// Mean column of the pixels that `is_mark` accepts, or −1.
  template <typename Predicate>
  static double mean_column(const Picture& picture, Predicate is_mark) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        if (!is_mark(picture.at(x, y))) continue;
        sum += x;
        ++count;
      }
    }
    return count ? sum / count : -1;
  }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("gnathion_scene_" + std::to_string(::getpid()));
  TexturedMesh head;
  FaceScene scene;
};

}  // namespace gnathion::test
