#include "bench/ray_trees.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkModifiedBSPTree.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "geometry/bsp_tree.h"

namespace gnathion::bench {
namespace {

class OurTree : public RayTree {
 public:
  std::string name() const override { return "gnathion BspTree"; }
  void build(const TriangleMesh& mesh) override { tree_ = std::make_unique<BspTree>(mesh); }
  Hits ask(const std::vector<Ray>& rays, double reach) const override {
    Hits hits;
    for (const Ray& ray : rays) {
      const auto hit = tree_->first_hit(ray.origin, ray.direction, reach);
      hits.triangle.push_back(hit ? hit->triangle : -1);
      hits.distance.push_back(hit ? hit->distance : 0);
    }
    return hits;
  }

 private:
  std::unique_ptr<BspTree> tree_;
};

class VtkTree : public RayTree {
 public:
  std::string name() const override { return "vtkModifiedBSPTree"; }
  void build(const TriangleMesh& mesh) override {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
      points->InsertNextPoint(mesh.vertices.row(i).data());
    }
    vtkNew<vtkCellArray> cells;
    for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
      cells->InsertNextCell(3);
      for (const int v : mesh.triangles.row(f)) cells->InsertCellPoint(v);
    }
    surface_->SetPoints(points);
    surface_->SetPolys(cells);
    tree_->SetDataSet(surface_);
    tree_->BuildLocator();
    ask({{{0, 0, 1e3}, {0, 0, 1}}}, 1);  // it is built when it is first asked
  }
  Hits ask(const std::vector<Ray>& rays, double reach) const override {
    Hits hits;
    vtkNew<vtkGenericCell> cell;
    for (const Ray& ray : rays) {
      const Eigen::Vector3d end = ray.origin + reach * ray.direction;
      double t = 0;
      std::array<double, 3> x{}, parametric{};
      int sub = 0;
      vtkIdType id = -1;
      // Tolerance 0 loses rays aimed at vertices and edges (docs/evidence.md).
      const bool hit = tree_->IntersectWithLine(ray.origin.data(), end.data(), 1e-9, t, x.data(),
                                                parametric.data(), sub, id, cell) != 0;
      hits.triangle.push_back(hit ? static_cast<int>(id) : -1);
      hits.distance.push_back(hit ? t * reach : 0);
    }
    return hits;
  }

 private:
  vtkNew<vtkPolyData> surface_;
  vtkNew<vtkModifiedBSPTree> tree_;
};

class CgalTree : public RayTree {
 public:
  std::string name() const override { return "CGAL AABB tree"; }
  void build(const TriangleMesh& mesh) override {
    const auto point = [&](int v) {
      return Kernel::Point_3(mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2));
    };
    for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
      triangles_.emplace_back(point(mesh.triangles(f, 0)), point(mesh.triangles(f, 1)),
                              point(mesh.triangles(f, 2)));
    }
    tree_.insert(triangles_.begin(), triangles_.end());
    tree_.build();
  }
  Hits ask(const std::vector<Ray>& rays, double reach) const override {
    Hits hits;
    for (const Ray& ray : rays) {
      const Kernel::Point_3 o(ray.origin[0], ray.origin[1], ray.origin[2]);
      const Kernel::Vector_3 d(ray.direction[0], ray.direction[1], ray.direction[2]);
      const auto hit = tree_.first_intersection(Kernel::Ray_3(o, d));
      int triangle = -1;
      double distance = 0;
      if (hit) {
        const auto* p = boost::get<Kernel::Point_3>(&hit->first);
        if (p != nullptr) distance = std::sqrt(CGAL::squared_distance(o, *p));
        if (p != nullptr && distance <= reach) {
          triangle = static_cast<int>(hit->second - triangles_.begin());
        }
      }
      hits.triangle.push_back(triangle);
      hits.distance.push_back(triangle == -1 ? 0 : distance);
    }
    return hits;
  }

 private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Triangles3 = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles3::const_iterator>;
  Triangles3 triangles_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

}  // namespace

std::vector<std::unique_ptr<RayTree>> ray_trees() {
  std::vector<std::unique_ptr<RayTree>> trees;
  trees.push_back(std::make_unique<OurTree>());
  trees.push_back(std::make_unique<VtkTree>());
  trees.push_back(std::make_unique<CgalTree>());
  return trees;
}

}  // namespace gnathion::bench
