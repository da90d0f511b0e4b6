#include "offscreen/offscreen.h"

#include <algorithm>
#include <string>

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "base/error.h"
#include "offscreen/osmesa_window.h"

namespace gnathion {
namespace {

constexpr int largest_side = 8192;  // pixels

Picture pixels_of(OsmesaWindow* window, int width, int height) {
  vtkNew<vtkUnsignedCharArray> bytes;
  constexpr int back_buffer = 0;  // off-screen there is no front buffer to read
  window->GetPixelData(0, 0, width - 1, height - 1, back_buffer, bytes, 0);
  Picture picture{width, height,
                  std::vector<std::uint8_t>(3 * static_cast<size_t>(width) * height)};
  const auto row = static_cast<size_t>(3 * width);
  for (int y = 0; y < height; ++y) {  // OpenGL's first row is the lowest
    std::copy_n(bytes->GetPointer(0) + row * static_cast<size_t>(height - 1 - y), row,
                picture.rgb.data() + row * static_cast<size_t>(y));
  }
  return picture;
}

/// The scene's renderer is in the window for as long as this lives, and leaves nothing behind that
/// belongs to the window's OpenGL context.
class Visit {
 public:
  Visit(OsmesaWindow* window, vtkRenderer* renderer) : window_(window), renderer_(renderer) {
    window_->AddRenderer(renderer_);
  }
  ~Visit() {
    window_->MakeCurrent();
    renderer_->ReleaseGraphicsResources(window_);
    window_->RemoveRenderer(renderer_);
  }
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;

 private:
  OsmesaWindow* window_;
  vtkRenderer* renderer_;
};

}  // namespace

struct OffscreenRenderer::Impl {
  vtkNew<OsmesaWindow> window;
};

OffscreenRenderer::OffscreenRenderer() : impl_(std::make_unique<Impl>()) {
  if (!impl_->window->has_context()) {
    throw Error(ErrorKind::output, "pictures", "OSMesa gives no OpenGL 3.3 context",
                "install the package libosmesa6 (Mesa 22 or newer)");
  }
  impl_->window->SetMultiSamples(4);
}

OffscreenRenderer::~OffscreenRenderer() = default;

Picture OffscreenRenderer::render(FaceScene& scene, int width, int height) {
  if (width < 1 || height < 1 || width > largest_side || height > largest_side) {
    throw Error(ErrorKind::output, "pictures",
                "cannot draw " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
                "ask for 1 to " + std::to_string(largest_side) + " pixels each way");
  }
  OsmesaWindow* window = impl_->window;
  window->SetSize(width, height);
  const Visit visit(window, scene.renderer());
  window->Render();
  return pixels_of(window, width, height);
}

Picture render_picture(FaceScene& scene, CameraPreset view, int width, int height) {
  OffscreenRenderer renderer;
  scene.look_from(view, static_cast<double>(width) / std::max(height, 1));
  return renderer.render(scene, width, height);
}

void write_png(FaceScene& scene, CameraPreset view, int width, int height,
               const std::filesystem::path& path) {
  write_png(render_picture(scene, view, width, height), path);
}

}  // namespace gnathion
