#include "render/compare_scene.h"

#include <algorithm>

#include <vtkActor2D.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "render/pixel_ratio.h"

namespace gnathion {
namespace {

constexpr double nearest_edge = 0.03;  // of the divider, so that it can be grasped

/// The part of the picture between two fractions of its width, seen as if the camera filled all of
/// it: a lens shifted by as much as the part's middle is off the picture's.
void take_part(vtkRenderer* renderer, double left, double right) {
  renderer->SetViewport(left, 0, right, 1);
  renderer->GetActiveCamera()->SetWindowCenter((left + right - 1) / (right - left), 0);
}

/// The part as a picture of its own.
void take_whole_picture(vtkRenderer* renderer, double left, double right) {
  renderer->SetViewport(left, 0, right, 1);
  renderer->GetActiveCamera()->SetWindowCenter(0, 0);
}

/// The line between the two halves of a wipe, with a grip in its middle.
struct Divider {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper2D> mapper;
  vtkNew<vtkActor2D> actor;

  Divider() {
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(1, 1, 1);
    actor->PickableOff();
  }

  void place(double fraction, int width, int height, double pixel_ratio) {
    actor->GetProperty()->SetLineWidth(static_cast<float>(2 * pixel_ratio));
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines, triangles;
    const double x = fraction * width, y = 0.5 * height;
    const auto point = [&](double dx, double dy) {
      return points->InsertNextPoint(x + dx, y + dy, 0);
    };
    const vtkIdType line[] = {point(0, -y), point(0, y)};
    lines->InsertNextCell(2, line);
    for (const double side : {-1.0, 1.0}) {
      const double r = pixel_ratio;
      const vtkIdType arrow[] = {point(side * 4 * r, -11 * r), point(side * 16 * r, 0),
                                 point(side * 4 * r, 11 * r)};
      triangles->InsertNextCell(3, arrow);
    }
    data->SetPoints(points);
    data->SetLines(lines);
    data->SetPolys(triangles);
  }
};

}  // namespace

struct CompareScene::Impl {
  FaceScene& predicted;
  FaceScene before;
  ProfileDrawing profile;
  vtkNew<vtkRenderer> overlay;  ///< lines and words over both
  Divider divider;
  vtkNew<vtkTextActor> blend_words;
  vtkNew<vtkCallbackCommand> before_frame;
  vtkNew<vtkCallbackCommand> overlay_frame;
  vtkRenderWindow* window = nullptr;
  CompareMode mode = CompareMode::predicted;
  double wipe = 0.5;
  double blend = 0.5;

  explicit Impl(FaceScene& shown) : predicted(shown) {
    set_up_overlay();
    vtkRenderer* renderer = before.renderer();
    vtkNew<vtkCamera> own;
    renderer->SetActiveCamera(own);
    // The mouse turns the predicted scene's camera, wherever it is.
    for (vtkRenderer* passive : {renderer, overlay.Get()}) passive->InteractiveOff();
    before_frame->SetClientData(this);
    before_frame->SetCallback(
        [](vtkObject*, unsigned long, void* self, void*) { static_cast<Impl*>(self)->follow(); });
    constexpr float before_the_scenes_own = 1;
    renderer->AddObserver(vtkCommand::StartEvent, before_frame, before_the_scenes_own);
  }

  ~Impl() {
    before.renderer()->RemoveObserver(before_frame);
    overlay->RemoveObserver(overlay_frame);
  }

  void set_up_overlay() {
    overlay->AddViewProp(divider.actor);
    overlay->AddViewProp(blend_words);
    overlay->SetLayer(2);
    blend_words->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    blend_words->SetPosition(0.5, 0.09);  // above the scale bar
    blend_words->GetTextProperty()->SetJustificationToCentered();
    blend_words->GetTextProperty()->SetColor(0.13, 0.17, 0.22);
    blend_words->SetInput("");
    overlay_frame->SetClientData(this);
    overlay_frame->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      auto* impl = static_cast<Impl*>(self);
      const int* size = impl->overlay->GetSize();
      const double ratio = pixel_ratio(impl->overlay);
      impl->divider.place(impl->wipe, size[0], size[1], ratio);
      const int font = std::clamp(static_cast<int>(size[1] / ratio / 30), 13, 20);
      impl->blend_words->GetTextProperty()->SetFontSize(font);
    });
    overlay->AddObserver(vtkCommand::StartEvent, overlay_frame);
  }

  /// Camera and look of the predicted scene, before every frame of the one before.
  void follow() {
    vtkCamera* camera = before.renderer()->GetActiveCamera();
    camera->DeepCopy(predicted.renderer()->GetActiveCamera());
    camera->Modified();  // copying does not say so, and the frame would be the last camera's
    place_before();
    if (before.is_face_textured() != predicted.is_face_textured()) {
      before.set_face_textured(predicted.is_face_textured());
    }
    if (before.is_coarse() != predicted.is_coarse()) before.set_coarse(predicted.is_coarse());
    const bool opaque = mode != CompareMode::blend || predicted.renderer()->GetDraw() == 0;
    for (const std::string& bone : before.bone_names()) {
      const bool shown = opaque && predicted.is_bone_visible(bone);
      if (before.is_bone_visible(bone) != shown) before.set_bone_visible(bone, shown);
    }
  }

  void place_before() {
    vtkRenderer* renderer = before.renderer();
    if (mode == CompareMode::wipe) take_part(renderer, 0, wipe);
    if (mode == CompareMode::side_by_side) take_whole_picture(renderer, 0, 0.5);
    if (mode == CompareMode::blend) take_whole_picture(renderer, 0, 1);
  }

  void place_predicted() {
    vtkRenderer* renderer = predicted.renderer();
    if (mode == CompareMode::wipe) {
      take_part(renderer, wipe, 1);
    } else {
      take_whole_picture(renderer, mode == CompareMode::side_by_side ? 0.5 : 0, 1);
    }
  }

  void apply() {
    if (window == nullptr) return;
    const bool veil = mode == CompareMode::blend;
    // A veil that hides everything is the face before alone, also where the other sticks out.
    const bool opaque = veil && blend > 0.995;
    vtkRenderer* renderer = before.renderer();
    renderer->SetLayer(veil && !opaque ? 1 : 0);
    renderer->SetDraw(mode == CompareMode::side_by_side || mode == CompareMode::wipe || veil);
    before.set_face_opacity(veil ? blend : 1);
    before.set_orientation_letters(!veil);
    predicted.renderer()->SetDraw(mode != CompareMode::profile && !opaque);
    profile.renderer()->SetDraw(mode == CompareMode::profile);
    profile.renderer()->SetInteractive(mode == CompareMode::profile);
    overlay->SetDraw(mode == CompareMode::wipe || veil);
    divider.actor->SetVisibility(mode == CompareMode::wipe);
    blend_words->SetVisibility(veil);
    place_before();
    place_predicted();
  }
};

CompareScene::CompareScene(FaceScene& predicted) : impl_(std::make_unique<Impl>(predicted)) {}

CompareScene::~CompareScene() {
  detach();
}

void CompareScene::attach(vtkRenderWindow* window) {
  detach();
  impl_->window = window;
  window->SetNumberOfLayers(std::max(window->GetNumberOfLayers(), 3));
  for (vtkRenderer* renderer :
       {impl_->before.renderer(), impl_->profile.renderer(), impl_->overlay.Get()}) {
    renderer->DrawOff();
    window->AddRenderer(renderer);
  }
  impl_->apply();
}

void CompareScene::detach() {
  if (!is_attached()) return;
  impl_->mode = CompareMode::predicted;
  impl_->apply();
  for (vtkRenderer* renderer :
       {impl_->before.renderer(), impl_->profile.renderer(), impl_->overlay.Get()}) {
    renderer->ReleaseGraphicsResources(impl_->window);
    impl_->window->RemoveRenderer(renderer);
  }
  impl_->window = nullptr;
}

bool CompareScene::is_attached() const {
  return impl_->window != nullptr;
}

void CompareScene::set_mode(CompareMode mode) {
  impl_->mode = mode;
  impl_->apply();
}

CompareMode CompareScene::mode() const {
  return impl_->mode;
}

void CompareScene::set_wipe(double fraction) {
  impl_->wipe = std::clamp(fraction, nearest_edge, 1 - nearest_edge);
  impl_->apply();
}

double CompareScene::wipe() const {
  return impl_->wipe;
}

void CompareScene::set_blend(double share_of_before) {
  impl_->blend = std::clamp(share_of_before, 0.0, 1.0);
  impl_->apply();
}

void CompareScene::set_blend_words(const std::string& words) {
  impl_->blend_words->SetInput(words.c_str());
}

FaceScene& CompareScene::before() {
  return impl_->before;
}

ProfileDrawing& CompareScene::profile() {
  return impl_->profile;
}

bool CompareScene::shows_before(double x) const {
  return (mode() == CompareMode::side_by_side && x < 0.5) ||
         (mode() == CompareMode::wipe && x < wipe());
}

double CompareScene::in_predicted(double x) const {
  return mode() == CompareMode::side_by_side && x < 0.5 ? x + 0.5 : x;
}

}  // namespace gnathion
