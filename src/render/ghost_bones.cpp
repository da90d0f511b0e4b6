#include "render/ghost_bones.h"

#include <vector>

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

#include "geometry/triangle_mesh.h"
#include "render/in_front.h"
#include "render/vtk_surface.h"

namespace gnathion {
namespace {

void copy_rows(const Points& from, vtkFloatArray* to) {
  to->SetNumberOfComponents(3);
  to->SetNumberOfTuples(from.rows());
  float* out = to->GetPointer(0);
  for (Eigen::Index i = 0; i < from.size(); ++i) out[i] = static_cast<float>(from.data()[i]);
}

/// The vertices that the triangles use.
TriangleMesh used_part(const Points& vertices, const Triangles& triangles) {
  return sub_mesh({vertices, triangles},
                  std::vector<bool>(static_cast<std::size_t>(triangles.rows()), true))
      .mesh;
}

}  // namespace

struct GhostBones::Impl {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkActor> actor;
  vtkRenderer* renderer = nullptr;

  Impl() {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    actor->SetMapper(mapper);
    actor->PickableOff();
    actor->VisibilityOff();
    actor->GetProperty()->SetColor(0.36, 0.16, 0.52);
    actor->GetProperty()->SetOpacity(0.5);
    actor->GetProperty()->LightingOn();
    actor->GetProperty()->BackfaceCullingOn();
    allow_in_front(actor);
    // As glass: seen along its surface it hides, seen straight on it does not.
    actor->GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Light::Impl", true,
        "//VTK::Light::Impl\n"
        "  float across = 1.0 - abs(normalize(normalVCVSOutput).z);\n"
        "  gl_FragData[0].a = 0.05 + 0.65 * across * across * across;\n",
        false);
  }
};

GhostBones::GhostBones() : impl_(std::make_unique<Impl>()) {}

GhostBones::~GhostBones() {
  detach();
}

void GhostBones::attach(vtkRenderer* renderer) {
  detach();
  impl_->renderer = renderer;
  renderer->AddActor(impl_->actor);
}

void GhostBones::detach() {
  if (impl_->renderer != nullptr) impl_->renderer->RemoveActor(impl_->actor);
  impl_->renderer = nullptr;
}

void GhostBones::set_bone(const Points& vertices, const Triangles& triangles) {
  const TriangleMesh bone = used_part(vertices, triangles);
  vtkNew<vtkFloatArray> places, normals;
  copy_rows(bone.vertices, places);
  copy_rows(vertex_normals(bone), normals);
  vtkNew<vtkPoints> points;
  points->SetData(places);
  impl_->data->SetPoints(points);
  impl_->data->GetPointData()->SetNormals(normals);
  impl_->data->SetPolys(cells_of(bone.triangles));
}

void GhostBones::set_visible(bool visible) {
  impl_->actor->SetVisibility(visible);
}

bool GhostBones::is_visible() const {
  return impl_->actor->GetVisibility() != 0;
}

void GhostBones::set_in_front(bool in_front) {
  gnathion::set_in_front(impl_->actor, in_front);
}

}  // namespace gnathion
