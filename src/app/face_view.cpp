#include "app/face_view.h"

#include <QMouseEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cstring>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "app/camera_mouse.h"
#include "render/segment_colours.h"

namespace gnathion {
namespace {

/// 20 mm before the skin, in the height of the segment's most forward part.
Eigen::Vector3d handle_home(const LoadedCase& loaded, const BoneSegment& segment) {
  const Points& bone = segment.mesh.vertices;
  const double front = bone.col(1).minCoeff();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (Eigen::Index v = 0; v < bone.rows(); ++v) {
    if (bone(v, 1) > front + 10) continue;
    sum += bone.row(v).transpose();
    ++count;
  }
  Eigen::Vector3d home = sum / count;
  double skin = front;
  const Points& face = loaded.anatomy->face.mesh.surface.vertices;
  if (loaded.model) {
    for (const int v : loaded.model->moving_vertices()) skin = std::min(skin, face(v, 1));
  }
  home.y() = skin - 20;
  return home;
}

}  // namespace

FaceView::FaceView(QWidget* parent) : QWidget(parent), canvas_(new QVTKOpenGLNativeWidget(this)) {
  canvas_->setObjectName("face_canvas");
  canvas_->setFocusPolicy(Qt::StrongFocus);
  canvas_->setMouseTracking(true);
  canvas_->installEventFilter(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(canvas_);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);  // costs a software renderer more than twice the time
  canvas_->setRenderWindow(window);
  window->AddRenderer(scene_.renderer());
  scene_.renderer()->UseFXAAOn();
  set_up_camera_mouse();
  handle_.on_taken([this] { set_quick(true); });
  handle_.on_moved([this](const Eigen::Vector3d& translation) {
    // The grip draws the frame itself when this returns.
    dragging_ = true;
    set_quick(true);
    emit segment_dragged(translation);
  });
  handle_.on_turned([this](int axis, double degrees) {
    dragging_ = true;
    set_quick(true);
    emit segment_turned(axis, degrees);
  });
  handle_.on_released([this](const Eigen::Vector3d&) {
    dragging_ = false;
    set_quick(false);
    emit drag_ended();
    render_soon();
  });
  render_timer_.setSingleShot(true);
  connect(&render_timer_, &QTimer::timeout, this, [this] { canvas_->renderWindow()->Render(); });
  // Whoever draws a frame, as a grip does that is dragged: what was asked for is in it.
  vtkNew<vtkCallbackCommand> begins;
  begins->SetClientData(&render_timer_);
  begins->SetCallback(
      [](vtkObject*, unsigned long, void* timer, void*) { static_cast<QTimer*>(timer)->stop(); });
  window->AddObserver(vtkCommand::StartEvent, begins);
}

FaceView::~FaceView() {
  handle_.detach();
  delete canvas_;  // while the scene lives: its graphics resources go with their context
}

QWidget* FaceView::canvas() const {
  return canvas_;
}

void FaceView::set_up_camera_mouse() {
  camera_mouse_ = new CameraMouse(interactor(), scene_.renderer(), this);
  connect(camera_mouse_, &CameraMouse::moving, this, [this](bool moves) {
    set_quick(moves);
    if (!moves) render_soon();
  });
  connect(camera_mouse_, &CameraMouse::moved, this, &FaceView::render_soon);
}

vtkRenderWindowInteractor* FaceView::interactor() const {
  return canvas_->renderWindow()->GetInteractor();
}

/// The grips are there when there is a segment, and when neither a tool nor a film wants the mouse.
void FaceView::update_handle() {
  handle_.set_visible(!segments_.empty() && !before_ && tool_ == nullptr);
}

void FaceView::set_tool(ViewTool* tool) {
  if (tool == tool_) return;
  if (tool_ != nullptr) tool_->left();
  tool_ = tool;
  tool_drags_ = false;
  update_handle();
  render_soon();
}

ViewPoint FaceView::view_point(QPoint pixel, Qt::KeyboardModifiers modifiers) const {
  vtkRenderer* renderer = scene_.renderer();
  const double ratio = canvas_->devicePixelRatioF();
  const auto world = [&](double depth) {
    renderer->SetDisplayPoint(ratio * (pixel.x() + 0.5),
                              ratio * (canvas_->height() - pixel.y() - 0.5), depth);
    renderer->DisplayToWorld();
    const double* p = renderer->GetWorldPoint();
    return Eigen::Vector3d(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
  };
  const Eigen::Vector3d eye = world(0);
  return {pixel, eye, (world(1) - eye).normalized(), modifiers};
}

std::optional<Eigen::Vector3d> FaceView::place_at(QPoint pixel) const {
  if (handle_.is_held() || !canvas_->rect().contains(pixel)) return {};
  vtkRenderer* renderer = scene_.renderer();
  const double ratio = canvas_->devicePixelRatioF();
  const double x = ratio * (pixel.x() + 0.5), y = ratio * (canvas_->height() - pixel.y() - 0.5);
  const double depth = renderer->GetZ(static_cast<int>(x), static_cast<int>(y));
  constexpr double behind_the_marks = 0.011;  // nearer is what render/in_front.h draws
  if (depth <= behind_the_marks || depth >= 1) return {};
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  const double* p = renderer->GetWorldPoint();
  return Eigen::Vector3d(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
}

bool FaceView::eventFilter(QObject* watched, QEvent* event) {
  if (tool_ == nullptr || watched != canvas_) return QWidget::eventFilter(watched, event);
  const auto at = [&] {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    return view_point(mouse->pos(), mouse->modifiers());
  };
  const auto is_left = [&] { return static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton; };
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      if (!is_left()) return false;
      tool_drags_ = tool_->pressed(at());
      return tool_drags_;
    case QEvent::MouseMove:
      if (tool_drags_) {
        tool_->dragged(at());
      } else if (static_cast<QMouseEvent*>(event)->buttons() == Qt::NoButton) {
        tool_->hovered(at());
      }
      return tool_drags_;
    case QEvent::MouseButtonRelease:
      if (!tool_drags_ || !is_left()) return false;
      tool_drags_ = false;
      tool_->released(at());
      return true;
    case QEvent::Leave:
      tool_->left();
      return false;
    default:
      return QWidget::eventFilter(watched, event);
  }
}

void FaceView::set_quick(bool quick) {
  scene_.set_coarse(quick);
  scene_.renderer()->SetUseFXAA(!quick);
}

void FaceView::show_case(const LoadedCase& loaded) {
  // A stroke of the brush changes neither face nor bones: they stay on the graphics card.
  if (loaded.anatomy != shown_anatomy_) show_anatomy(loaded);
  handle_homes_.clear();
  for (const BoneSegment& segment : loaded.anatomy->segments) {
    handle_homes_.push_back(handle_home(loaded, segment));
  }
  film_face_.resize(0, 3);
  change_.resize(0);
  change_outdated_ = true;
  dragging_ = false;  // attaching anew takes the grips out of a hand that holds one
  set_quick(false);
  if (!handle_homes_.empty()) handle_.set_home(handle_homes_.front());
  handle_.attach(canvas_->renderWindow()->GetInteractor(), scene_.renderer());
  update_handle();
  show_change();
  emit case_shown();
}

void FaceView::show_anatomy(const LoadedCase& loaded) {
  const ReadyAnatomy& ready = *loaded.ready;
  scene_.set_face(ready.face);
  rest_ = loaded.anatomy->face.mesh.surface.vertices;
  scene_.remove_bones();
  scene_.set_bone("skull", ready.skull, skull_look);
  segments_.clear();
  for (std::size_t s = 0; s < loaded.anatomy->segments.size(); ++s) {
    segments_.push_back("segment " + loaded.anatomy->segments[s].name);
    scene_.set_bone(segments_[s], ready.segments[s], look_of_segment(s));
  }
  set_bone_visible(bone_visible_);
  shown_anatomy_ = loaded.anatomy;
}

void FaceView::set_active_segment(std::size_t segment) {
  handle_.set_home(handle_homes_[segment]);
  render_soon();
}

void FaceView::show_response(const Response& response, const Eigen::Vector3d& translation) {
  response_ = response;
  // While it is dragged the grip knows better: setting it would lose motions below the step that
  // the numbers are rounded to.
  if (!dragging_) handle_.set_translation(translation);
  show_points();
}

void FaceView::set_caption(const QString& caption) {
  if (caption == caption_) return;
  caption_ = caption;
  show_caption();
  if (!dragging_) render_soon();
}

void FaceView::show_film(const Points& face, const QString& caption) {
  const bool begins = !is_film();
  film_face_ = face;
  film_caption_ = caption;
  if (begins) {
    set_quick(true);
    show_change();
  }
  show_points();
}

void FaceView::end_film() {
  if (!is_film()) return;
  film_face_.resize(0, 3);
  set_quick(false);
  show_points();
  show_change();
}

const Points& FaceView::face_points() const {
  if (before_ || response_.face.rows() != rest_.rows()) return rest_;
  return is_film() ? film_face_ : response_.face;
}

void FaceView::show_points() {
  if (!scene_.has_face() || response_.face.rows() != rest_.rows()) return;
  scene_.set_face_points(face_points());
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    scene_.set_bone_pose(segments_[s], before_ ? RigidMotion{} : response_.poses[s]);
  }
  update_handle();
  show_caption();
  emit face_points_changed();
  if (!dragging_) render_soon();
}

void FaceView::show_caption() {
  QString text = before_ ? tr("Before") : is_film() ? film_caption_ : caption_;
  if (colour_map_ && !before_ && !is_film() && change_outdated_) {
    text += "\n" + tr("colours follow when the motion rests");
  }
  shown_caption_ = text;
  scene_.set_label(text.toStdString());
}

void FaceView::set_change(const Eigen::VectorXd& signed_mm) {
  change_ = signed_mm;
  change_outdated_ = false;
  show_change();
}

void FaceView::mark_change_outdated() {
  change_outdated_ = true;
  show_caption();
}

void FaceView::show_change() {
  if (colour_map_ && !before_ && !is_film() && change_.size() == rest_.rows() &&
      scene_.has_face()) {
    scene_.show_colour_map(change_, change_range_, tr("mm").toStdString());
  } else {
    scene_.hide_colour_map();
  }
  show_caption();
  render_soon();
}

double FaceView::aspect_ratio() const {
  // A comparison may leave the scene a part of the picture.
  const double* part = scene_.renderer()->GetViewport();
  const double whole =
      scene_.renderer()->GetActiveCamera()->GetWindowCenter()[0] == 0 ? part[2] - part[0] : 1;
  return whole * std::max(canvas_->width(), 1) / std::max(canvas_->height(), 1);
}

void FaceView::look_from(CameraPreset view) {
  scene_.look_from(view, aspect_ratio());
  render_soon();
}

void FaceView::set_face_opacity(double opacity) {
  face_opacity_ = opacity;
  scene_.set_face_opacity(opacity);
  emit look_changed();
  render_soon();
}

void FaceView::set_face_textured(bool textured) {
  scene_.set_face_textured(textured);
  render_soon();
}

void FaceView::set_bone_visible(bool visible) {
  bone_visible_ = visible;
  for (const std::string& name : scene_.bone_names()) scene_.set_bone_visible(name, visible);
  render_soon();
}

void FaceView::set_colour_map_visible(bool visible) {
  if (visible == colour_map_) return;
  colour_map_ = visible;
  show_change();
  emit colour_map_switched(visible);
}

void FaceView::set_change_range(double half_range_mm) {
  change_range_ = half_range_mm;
  show_change();
}

void FaceView::set_before_visible(bool visible) {
  // Grips that vanish from the hand that holds one never hear of its letting go.
  if (dragging_) canvas_->renderWindow()->GetInteractor()->LeftButtonReleaseEvent();
  before_ = visible;
  show_points();
  show_change();
  emit look_changed();
}

void FaceView::render_soon() {
  if (!isVisible() || render_timer_.isActive()) return;
  // A grip that is dragged draws frame after frame: the next one takes along what is asked for
  // here.
  constexpr int next_frame_ms = 100;
  render_timer_.start(dragging_ ? next_frame_ms : 0);
}

/// In a frame of the window's own that is never shown.
void FaceView::draw_larger(int scale, Picture& picture) {
  vtkRenderWindow* window = canvas_->renderWindow();
  const int width = window->GetSize()[0], height = window->GetSize()[1], dpi = window->GetDPI();
  picture.width = scale * width;
  picture.height = scale * height;
  window->SetSize(picture.width, picture.height);
  window->SetDPI(scale * dpi);  // words grow with the picture
  window->Render();
  vtkNew<vtkUnsignedCharArray> bytes;
  constexpr int back_buffer = 0;
  window->GetPixelData(0, 0, picture.width - 1, picture.height - 1, back_buffer, bytes, 0);
  const auto row = static_cast<std::size_t>(3 * picture.width);
  picture.rgb.resize(row * static_cast<std::size_t>(picture.height));
  for (int y = 0; y < picture.height; ++y) {  // OpenGL's first row is the lowest
    std::memcpy(&picture.rgb[row * static_cast<std::size_t>(y)],
                bytes->GetPointer(0) + row * static_cast<std::size_t>(picture.height - 1 - y), row);
  }
  window->SetSize(width, height);
  window->SetDPI(dpi);
}

Picture FaceView::picture(int scale) {
  handle_.set_visible(false);
  if (scale > 1) {
    Picture large;
    draw_larger(scale, large);
    update_handle();
    canvas_->renderWindow()->Render();
    return large;
  }
  canvas_->renderWindow()->Render();
  const QImage image = canvas_->grabFramebuffer().convertToFormat(QImage::Format_RGB888);
  update_handle();
  render_soon();
  Picture picture{image.width(), image.height(), {}};
  const auto row_bytes = static_cast<std::size_t>(3 * image.width());
  picture.rgb.resize(row_bytes * static_cast<std::size_t>(image.height()));
  for (int y = 0; y < image.height(); ++y) {
    std::memcpy(&picture.rgb[row_bytes * static_cast<std::size_t>(y)], image.constScanLine(y),
                row_bytes);
  }
  return picture;
}

}  // namespace gnathion
