#pragma once

#include <filesystem>
#include <memory>

#include "render/face_scene.h"
#include "render/picture.h"

namespace gnathion {

/// Draws scenes in memory with software OpenGL (OSMesa): no display, no graphics card, the same
/// pixels on every run. Making one costs some 0.1 s, so take several pictures with one. A scene
/// that is in a window at the same time must not be drawn here.
class OffscreenRenderer {
 public:
  /// Throws Error(output) when OSMesa cannot give an OpenGL 3.3 context.
  OffscreenRenderer();
  ~OffscreenRenderer();
  OffscreenRenderer(const OffscreenRenderer&) = delete;
  OffscreenRenderer& operator=(const OffscreenRenderer&) = delete;

  /// The scene through its present camera. width, height: pixels, 1..8192.
  /// Throws Error(output) when the size is out of range.
  Picture render(FaceScene& scene, int width, int height);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One picture of a scene from a preset, which stays the scene's camera. Errors as
/// OffscreenRenderer.
Picture render_picture(FaceScene& scene, CameraPreset view, int width, int height);

/// The same into a PNG file. Throws Error(output), also when the file cannot be written.
void write_png(FaceScene& scene, CameraPreset view, int width, int height,
               const std::filesystem::path& path);

}  // namespace gnathion
