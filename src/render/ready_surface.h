#pragma once

#include <memory>
#include <string>
#include <vector>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include "geometry/mesh_types.h"

namespace gnathion {

/// A surface as a graphics card takes it. Nobody changes it once it is made: scenes share it.
struct SurfaceArrays {
  std::vector<int> vertex;  ///< of the face or bone, for each of its own, which are copies of them
  vtkSmartPointer<vtkCellArray> cells;
  vtkSmartPointer<vtkFloatArray> points, normals;        ///< at rest
  vtkSmartPointer<vtkFloatArray> uv;                     ///< null: no texture
  vtkSmartPointer<vtkUnsignedCharArray> vertex_colours;  ///< null: none
};

/// A bone made ready for FaceScene.
struct ReadyBone {
  Points vertices;  ///< n×3, mm, LPS, at rest
  SurfaceArrays whole;
  SurfaceArrays coarse;      ///< no cells: the bone is always drawn whole
  bool is_outward_closed{};  ///< what is seen of it never has its back to the eye
};

/// A face made ready for FaceScene.
struct ReadyFace {
  struct Part {
    SurfaceArrays arrays;
    vtkSmartPointer<vtkImageData> texture;  ///< null: none
    Eigen::Vector3d plain_colour;           ///< RGB, 0..1, where no texture is shown
  };
  TriangleMesh surface;  ///< mm, LPS, at rest
  std::vector<Part> whole;
  std::vector<Part> coarse;        ///< none: the face is always drawn whole; vertex: of coarse_mesh
  std::vector<int> coarse_vertex;  ///< rows of the surface's vertices
  TriangleMesh coarse_mesh;        ///< of these, all parts in one, for normals without seams
  bool is_outward_closed{};
};

/// A tenth of a second for half a million triangles. Pure, for any thread. coarse: fewer triangles
/// over the same vertices for frames while something moves (coarse_triangles() in
/// render/coarse_surface.h); none: always drawn whole. `name` is the subject of messages.
/// Throws Error(input) as check_surface().
std::shared_ptr<const ReadyBone> ready_bone(const TriangleMesh& bone, const std::string& name,
                                            const Triangles& coarse = {});

/// Reads the face's textures, too; large ones take most of the time. Pure but for that, for any
/// thread. vertex_colours: n×3, sRGB 0..1, shown where there is no texture; no rows: none.
/// Throws Error(input) when the mesh cannot be shown (check_face() in render/split_surface.h) or a
/// texture is missing or unreadable (naming that file).
std::shared_ptr<const ReadyFace> ready_face(const TexturedMesh& face, const std::string& name,
                                            const Points& vertex_colours = {});

/// Rows of `source` in the order of `row_of`, as VTK's float tuples, which `target` has as many of.
void copy_rows(const Points& source, const std::vector<int>& row_of, vtkFloatArray* target);

}  // namespace gnathion
