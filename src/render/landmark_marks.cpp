#include "render/landmark_marks.h"

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
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "render/pixel_ratio.h"

namespace gnathion {
namespace {

/// Points and lines given in the patient's frame, drawn in the picture's plane.
struct Layer {
  float size;  // logical pixels
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper2D> mapper;
  vtkNew<vtkActor2D> actor;

  Layer(const Eigen::Vector3d& colour, float logical_pixels) : size(logical_pixels) {
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

vtkSmartPointer<vtkTextActor> text_of(const LandmarkMark& mark) {
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  text->GetPositionCoordinate()->SetValue(mark.at.x(), mark.at.y(), mark.at.z());
  text->SetInput(("    " + mark.words).c_str());  // room for the dot
  vtkTextProperty* look = text->GetTextProperty();
  look->SetFontSize(13);
  look->SetBold(mark.chosen);
  look->SetColor(dark.x(), dark.y(), dark.z());
  look->SetBackgroundColor(1, 1, 1);
  look->SetBackgroundOpacity(0.65);
  look->SetVerticalJustificationToCentered();
  text->PickableOff();
  return text;
}

}  // namespace

Eigen::Vector3d colour_of(LandmarkMark::Kind kind) {
  return kind == LandmarkMark::Kind::photograph ? Eigen::Vector3d(0.95, 0.55, 0.10)
                                                : Eigen::Vector3d(0.15, 0.60, 0.90);
}

struct LandmarkMarks::Impl {
  Layer lines{bright, 2.5F};
  // A dark edge around a bright core is seen on light and on dark skin.
  Layer chosen{bright, 16}, edges{dark, 12};
  Layer photograph{colour_of(LandmarkMark::Kind::photograph), 8};
  Layer ct{colour_of(LandmarkMark::Kind::ct), 8};
  std::vector<vtkSmartPointer<vtkTextActor>> texts;
  vtkRenderer* renderer = nullptr;

  std::array<Layer*, 5> layers() { return {&lines, &chosen, &edges, &photograph, &ct}; }

  /// What is added later is drawn over what came before: dots over the words' background.
  void add() {
    for (const auto& text : texts) renderer->AddViewProp(text);
    for (Layer* layer : layers()) renderer->AddViewProp(layer->actor);
  }
  void remove() {
    for (Layer* layer : layers()) renderer->RemoveViewProp(layer->actor);
    for (const auto& text : texts) renderer->RemoveViewProp(text);
  }
};

LandmarkMarks::LandmarkMarks() : impl_(std::make_unique<Impl>()) {}

LandmarkMarks::~LandmarkMarks() {
  detach();
}

void LandmarkMarks::attach(vtkRenderer* renderer) {
  detach();
  impl_->renderer = renderer;
  for (Layer* layer : impl_->layers()) layer->set_size(pixel_ratio(renderer));
  impl_->add();
}

void LandmarkMarks::detach() {
  if (impl_->renderer == nullptr) return;
  impl_->remove();
  impl_->renderer = nullptr;
}

void LandmarkMarks::show(const std::vector<LandmarkMark>& marks,
                         const std::vector<std::pair<int, int>>& lines) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> all, chosen, photograph, ct, segments;
  if (impl_->renderer != nullptr) impl_->remove();
  impl_->texts.clear();
  for (const LandmarkMark& mark : marks) {
    const vtkIdType id = points->InsertNextPoint(mark.at.data());
    all->InsertNextCell(1, &id);
    (mark.kind == LandmarkMark::Kind::photograph ? photograph : ct)->InsertNextCell(1, &id);
    if (mark.chosen) chosen->InsertNextCell(1, &id);
    if (!mark.words.empty()) impl_->texts.push_back(text_of(mark));
  }
  for (const auto& [a, b] : lines) {
    const std::array<vtkIdType, 2> ends{a, b};
    segments->InsertNextCell(2, ends.data());
  }
  for (Layer* layer : impl_->layers()) layer->data->SetPoints(points);
  impl_->lines.data->SetLines(segments);
  impl_->chosen.data->SetVerts(chosen);
  impl_->edges.data->SetVerts(all);
  impl_->photograph.data->SetVerts(photograph);
  impl_->ct.data->SetVerts(ct);
  if (impl_->renderer != nullptr) impl_->add();
}

}  // namespace gnathion
