#include "render/collision_marks.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "render/in_front.h"
#include "render/pixel_ratio.h"

namespace gnathion {
namespace {

constexpr int dot_size = 5;

vtkSmartPointer<vtkTextActor> text_of(const PlacedWord& word) {
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->SetInput(word.text.c_str());
  text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  text->SetPosition(0, 0);
  text->GetPositionCoordinate()->SetValue(word.place.x(), word.place.y(), word.place.z());
  text->PickableOff();
  vtkTextProperty* letters = text->GetTextProperty();
  letters->SetFontSize(15);
  letters->BoldOn();
  letters->SetColor(0.72, 0.05, 0.05);
  letters->SetBackgroundColor(1, 1, 1);
  letters->SetBackgroundOpacity(0.8);
  letters->SetJustificationToLeft();
  letters->SetVerticalJustificationToBottom();
  return text;
}

}  // namespace

struct CollisionMarks::Impl {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkActor> dots;
  std::vector<vtkSmartPointer<vtkTextActor>> texts;
  vtkRenderer* renderer = nullptr;

  Impl() {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    dots->SetMapper(mapper);
    dots->PickableOff();
    dots->VisibilityOff();
    dots->GetProperty()->SetColor(0.86, 0.05, 0.05);
    dots->GetProperty()->SetPointSize(dot_size);
    dots->GetProperty()->LightingOff();
    allow_in_front(dots);
  }

  void remove_texts() {
    if (renderer != nullptr) {
      for (const auto& text : texts) renderer->RemoveActor2D(text);
    }
    texts.clear();
  }
};

CollisionMarks::CollisionMarks() : impl_(std::make_unique<Impl>()) {}

CollisionMarks::~CollisionMarks() {
  detach();
}

void CollisionMarks::attach(vtkRenderer* renderer) {
  detach();
  impl_->renderer = renderer;
  impl_->dots->GetProperty()->SetPointSize(static_cast<float>(dot_size * pixel_ratio(renderer)));
  renderer->AddActor(impl_->dots);
}

void CollisionMarks::detach() {
  impl_->remove_texts();
  if (impl_->renderer != nullptr) impl_->renderer->RemoveActor(impl_->dots);
  impl_->renderer = nullptr;
}

void CollisionMarks::show(const Points& places, const std::vector<PlacedWord>& words) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    points->InsertNextPoint(places(i, 0), places(i, 1), places(i, 2));
    vertices->InsertNextCell(1);
    vertices->InsertCellPoint(i);
  }
  impl_->data->SetPoints(points);
  impl_->data->SetVerts(vertices);
  impl_->dots->SetVisibility(places.rows() > 0);
  impl_->remove_texts();
  if (impl_->renderer == nullptr) return;
  for (const PlacedWord& word : words) {
    impl_->texts.push_back(text_of(word));
    impl_->renderer->AddActor2D(impl_->texts.back());
  }
}

}  // namespace gnathion
