#include "render/measure_marks.h"

#include <array>

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "render/pixel_ratio.h"

namespace gnathion {
namespace {

/// Points and lines given in the patient's frame, drawn in the picture's plane.
struct Mark {
  float size;  // logical pixels
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper2D> mapper;
  vtkNew<vtkActor2D> actor;

  Mark(const Eigen::Vector3d& colour, float logical_pixels) : size(logical_pixels) {
    vtkNew<vtkCoordinate> world;
    world->SetCoordinateSystemToWorld();
    mapper->SetInputData(data);
    mapper->SetTransformCoordinate(world);
    actor->SetMapper(mapper);
    actor->PickableOff();
    actor->GetProperty()->SetColor(colour.x(), colour.y(), colour.z());
    set_size(1);
  }

  void set_size(double pixel_ratio) {
    actor->GetProperty()->SetPointSize(static_cast<float>(pixel_ratio) * size);
    actor->GetProperty()->SetLineWidth(static_cast<float>(pixel_ratio) * size);
  }
};

const Eigen::Vector3d dark{0.05, 0.05, 0.08};
const Eigen::Vector3d bright{1.0, 0.93, 0.35};

}  // namespace

struct MeasureMarks::Impl {
  // A dark edge around a bright core is seen on light and on dark skin.
  Mark line_edge{dark, 5}, line{bright, 2.5F};
  Mark dots_edge{dark, 11}, dots{bright, 7};
  vtkNew<vtkTextActor> text;
  vtkRenderer* renderer = nullptr;

  Impl() {
    text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    vtkTextProperty* look = text->GetTextProperty();
    look->SetFontSize(15);
    look->SetBold(1);
    look->SetColor(0.05, 0.05, 0.08);
    look->SetBackgroundColor(1, 1, 1);
    look->SetBackgroundOpacity(0.8);
    look->SetVerticalJustificationToBottom();
    text->PickableOff();
    text->VisibilityOff();
    text->SetInput("");
  }

  std::array<vtkActor2D*, 5> actors() {
    return {line_edge.actor, line.actor, dots_edge.actor, dots.actor, text};
  }
};

MeasureMarks::MeasureMarks() : impl_(std::make_unique<Impl>()) {}

MeasureMarks::~MeasureMarks() {
  detach();
}

void MeasureMarks::attach(vtkRenderer* renderer) {
  detach();
  impl_->renderer = renderer;
  for (Mark* mark : {&impl_->line_edge, &impl_->line, &impl_->dots_edge, &impl_->dots}) {
    mark->set_size(pixel_ratio(renderer));
  }
  for (vtkActor2D* actor : impl_->actors()) renderer->AddViewProp(actor);
}

void MeasureMarks::detach() {
  if (impl_->renderer == nullptr) return;
  for (vtkActor2D* actor : impl_->actors()) impl_->renderer->RemoveViewProp(actor);
  impl_->renderer = nullptr;
}

void MeasureMarks::show(const std::vector<Eigen::Vector3d>& places, const std::string& words) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> dots, lines;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& place : places) {
    const vtkIdType id = points->InsertNextPoint(place.data());
    dots->InsertNextCell(1, &id);
    middle += place / static_cast<double>(places.size());
  }
  if (places.size() == 2) {
    const std::array<vtkIdType, 2> ends{0, 1};
    lines->InsertNextCell(2, ends.data());
  }
  for (Mark* mark : {&impl_->line_edge, &impl_->line}) {
    mark->data->SetPoints(points);
    mark->data->SetLines(lines);
  }
  for (Mark* mark : {&impl_->dots_edge, &impl_->dots}) {
    mark->data->SetPoints(points);
    mark->data->SetVerts(dots);
  }
  impl_->text->GetPositionCoordinate()->SetValue(middle.data());
  impl_->text->SetInput(words.c_str());
  impl_->text->SetVisibility(!places.empty() && !words.empty());
}

}  // namespace gnathion
