#include "app/hidden_canvas.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <algorithm>
#include <vector>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "base/error.h"

namespace gnathion {
namespace {

[[noreturn]] void refuse() {
  throw Error(
      ErrorKind::output, QCoreApplication::translate("HiddenCanvas", "pictures").toStdString(),
      QCoreApplication::translate("HiddenCanvas", "the display gives no second OpenGL 3.2 context")
          .toStdString(),
      QCoreApplication::translate("HiddenCanvas",
                                  "close other programs that draw in 3D and try again")
          .toStdString());
}

}  // namespace

struct HiddenCanvas::Impl {
  QOffscreenSurface surface;
  QOpenGLContext context;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkCallbackCommand> answers;
  std::vector<vtkRenderer*> renderers;

  Impl() {
    const QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
    context.setFormat(format);
    surface.setFormat(format);
    surface.create();
    if (!context.create() || !surface.isValid() || !context.makeCurrent(&surface)) refuse();
    answers->SetClientData(this);
    answers->SetCallback([](vtkObject*, unsigned long event, void* self, void* data) {
      static_cast<Impl*>(self)->answer(event, data);
    });
    for (const unsigned long event :
         {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent}) {
      window->AddObserver(event, answers);
    }
    window->SetReadyForRendering(true);
    window->SetMultiSamples(0);
    window->SetFrameBlitModeToNoBlit();
    window->SetOffScreenRendering(1);
    window->OpenGLInit();
  }

  ~Impl() {
    context.makeCurrent(&surface);
    for (vtkRenderer* renderer : renderers) {
      renderer->ReleaseGraphicsResources(window);
      window->RemoveRenderer(renderer);
    }
    window->Finalize();
    window->RemoveObserver(answers);
    context.doneCurrent();
  }

  /// VTK asks whoever owns the context.
  void answer(unsigned long event, void* data) {
    if (event == vtkCommand::WindowMakeCurrentEvent) context.makeCurrent(&surface);
    if (event == vtkCommand::WindowIsCurrentEvent && data != nullptr) {
      *static_cast<bool*>(data) = QOpenGLContext::currentContext() == &context;
    }
  }
};

HiddenCanvas::HiddenCanvas(int width, int height) : impl_(std::make_unique<Impl>()) {
  impl_->window->SetSize(width, height);
}

HiddenCanvas::~HiddenCanvas() = default;

void HiddenCanvas::add(vtkRenderer* renderer) {
  impl_->renderers.push_back(renderer);
  impl_->window->AddRenderer(renderer);
}

Picture HiddenCanvas::picture() {
  vtkGenericOpenGLRenderWindow* window = impl_->window;
  window->MakeCurrent();
  window->Render();
  const int width = window->GetSize()[0], height = window->GetSize()[1];
  vtkNew<vtkUnsignedCharArray> bytes;
  constexpr int back_buffer = 0;  // off-screen there is no front buffer to read
  window->GetPixelData(0, 0, width - 1, height - 1, back_buffer, bytes, 0);
  Picture picture{width, height, {}};
  const auto row = static_cast<std::size_t>(3 * width);
  picture.rgb.resize(row * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {  // OpenGL's first row is the lowest
    std::copy_n(bytes->GetPointer(0) + row * static_cast<std::size_t>(height - 1 - y), row,
                picture.rgb.data() + row * static_cast<std::size_t>(y));
  }
  impl_->context.doneCurrent();
  return picture;
}

}  // namespace gnathion
