#include "render/cut_preview.h"

#include <algorithm>
#include <cmath>

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include "geometry/triangle_mesh.h"
#include "render/split_surface.h"
#include "render/vtk_surface.h"

namespace gnathion {
namespace {

vtkSmartPointer<vtkFloatArray> floats(const Points& rows) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(rows.rows());
  std::transform(rows.data(), rows.data() + rows.size(), array->GetPointer(0),
                 [](double x) { return static_cast<float>(x); });
  return array;
}

}  // namespace

struct CutPreviewLayer::Impl {
  struct Shown {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };

  Shown fine, coarse;
  bool has_coarse = false;
  Triangles triangles;
  vtkNew<vtkUnsignedCharArray> colours;  // of the vertices, shared by both
  vtkRenderer* renderer = nullptr;

  Impl() {
    colours->SetNumberOfComponents(3);
    for (Shown* shown : {&fine, &coarse}) {
      shown->mapper->SetInputData(shown->data);
      shown->mapper->SetColorModeToDirectScalars();
      shown->actor->SetMapper(shown->mapper);
      shown->actor->GetProperty()->SetInterpolationToPhong();
      shown->actor->GetProperty()->SetAmbient(0.10);
      shown->actor->GetProperty()->SetDiffuse(0.88);
      shown->actor->GetProperty()->SetSpecular(0.12);
      shown->actor->GetProperty()->SetSpecularPower(25);
    }
    set_quick(false);
  }

  void set_quick(bool quick) {
    fine.actor->SetVisibility(!(quick && has_coarse));
    coarse.actor->SetVisibility(quick && has_coarse);
  }
};

CutPreviewLayer::CutPreviewLayer() : impl_(std::make_unique<Impl>()) {}

CutPreviewLayer::~CutPreviewLayer() {
  detach();
}

void CutPreviewLayer::attach(vtkRenderer* renderer) {
  detach();
  impl_->renderer = renderer;
  renderer->AddActor(impl_->fine.actor);
  renderer->AddActor(impl_->coarse.actor);
}

void CutPreviewLayer::detach() {
  if (!impl_->renderer) return;
  impl_->renderer->RemoveActor(impl_->fine.actor);
  impl_->renderer->RemoveActor(impl_->coarse.actor);
  impl_->renderer = nullptr;
}

bool CutPreviewLayer::is_attached() const {
  return impl_->renderer != nullptr;
}

void CutPreviewLayer::set_bone(const TriangleMesh& bone, const Triangles& coarse) {
  check_surface(bone, "bone");
  if (coarse.rows() > 0) check_surface({bone.vertices, coarse}, "bone");
  impl_->triangles = bone.triangles;
  impl_->has_coarse = coarse.rows() > 0;
  impl_->colours->SetNumberOfTuples(bone.vertices.rows());
  impl_->colours->Fill(255);
  vtkNew<vtkPoints> points;
  points->SetData(floats(bone.vertices));
  const auto normals = floats(vertex_normals(bone));
  const auto fill = [&](Impl::Shown& shown, const Triangles& triangles) {
    shown.data->SetPoints(points);
    shown.data->GetPointData()->SetNormals(normals);
    shown.data->GetPointData()->SetScalars(impl_->colours);
    shown.data->SetPolys(cells_of(triangles));
  };
  fill(impl_->fine, bone.triangles);
  fill(impl_->coarse, coarse);
  impl_->set_quick(false);
}

void CutPreviewLayer::set_parts(const std::vector<std::uint8_t>& part, const Points& colours) {
  std::vector<std::uint8_t> of_vertex(static_cast<std::size_t>(impl_->colours->GetNumberOfTuples()),
                                      0);
  for (Eigen::Index t = 0; t < impl_->triangles.rows(); ++t) {
    for (int k = 0; k < 3; ++k) {
      std::uint8_t& own = of_vertex[static_cast<std::size_t>(impl_->triangles(t, k))];
      own = std::max(own, part[static_cast<std::size_t>(t)]);
    }
  }
  unsigned char* out = impl_->colours->GetPointer(0);
  for (const std::uint8_t own : of_vertex) {
    for (int k = 0; k < 3; ++k)
      *out++ = static_cast<unsigned char>(std::lround(255 * colours(own, k)));
  }
  impl_->colours->Modified();
  impl_->fine.data->Modified();
  impl_->coarse.data->Modified();
}

void CutPreviewLayer::set_quick(bool quick) {
  impl_->set_quick(quick);
}

}  // namespace gnathion
