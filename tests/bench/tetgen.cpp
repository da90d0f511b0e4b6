#include "bench/tetgen.h"

#include <sys/wait.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>

#include "bench/timing.h"
#include "geometry/triangle_mesh.h"
#include "io/files.h"
#include "support/temporary_folder.h"

namespace gnathion::bench {
namespace {

std::string smesh_of(const TriangleMesh& surface) {
  std::ostringstream out;
  out.precision(17);
  out << surface.vertices.rows() << " 3 0 0\n";
  for (Eigen::Index i = 0; i < surface.vertices.rows(); ++i) {
    out << i << ' ' << surface.vertices(i, 0) << ' ' << surface.vertices(i, 1) << ' '
        << surface.vertices(i, 2) << '\n';
  }
  out << surface.triangles.rows() << " 0\n";
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    out << "3 " << surface.triangles(f, 0) << ' ' << surface.triangles(f, 1) << ' '
        << surface.triangles(f, 2) << '\n';
  }
  out << "0\n0\n";
  return out.str();
}

/// The table of a .node or .ele file: its first number counts rows, each begins with its index.
template <class Table>
Table read_table(const std::filesystem::path& file) {
  std::istringstream in(read_text_file(file));
  Eigen::Index rows = 0;
  std::string rest_of_line;
  if (!(in >> rows)) throw std::runtime_error(file.string() + ": no table");
  std::getline(in, rest_of_line);
  Table table(rows, Table::ColsAtCompileTime);
  for (Eigen::Index i = 0; i < rows; ++i) {
    Eigen::Index index = 0;
    in >> index;
    for (Eigen::Index k = 0; k < table.cols(); ++k) in >> table(i, k);
    if (!in || index != i) throw std::runtime_error(file.string() + ": broken table");
    std::getline(in, rest_of_line);
  }
  return table;
}

/// Corners in the order that gives a positive volume here.
void orient(TetMesh& mesh) {
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    const auto x = [&](int k) { return Eigen::Vector3d(mesh.vertices.row(mesh.tets(t, k))); };
    if ((x(1) - x(0)).cross(x(2) - x(0)).dot(x(3) - x(0)) < 0) {
      std::swap(mesh.tets(t, 0), mesh.tets(t, 1));
    }
  }
}

}  // namespace

TriangleMesh boundary_surface(const TetMesh& mesh) {
  constexpr std::array<std::array<int, 3>, 4> faces{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  std::map<std::array<int, 3>, std::array<int, 3>> single;
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    for (const auto& face : faces) {
      const std::array<int, 3> outward{mesh.tets(t, face[0]), mesh.tets(t, face[1]),
                                       mesh.tets(t, face[2])};
      std::array<int, 3> key = outward;
      std::sort(key.begin(), key.end());
      const auto [place, is_new] = single.try_emplace(key, outward);
      if (!is_new) single.erase(place);
    }
  }
  TriangleMesh surface{mesh.vertices, Triangles(static_cast<Eigen::Index>(single.size()), 3)};
  Eigen::Index f = 0;
  for (const auto& [key, t] : single) surface.triangles.row(f++) << t[0], t[1], t[2];
  return sub_mesh(surface, std::vector<bool>(single.size(), true)).mesh;
}

TetgenResult run_tetgen(const TriangleMesh& closed_surface, const std::string& switches,
                        int limit_seconds) {
  const test::TemporaryFolder folder;
  folder.write("tissue.smesh", smesh_of(closed_surface));
  const std::string command = "cd '" + folder.path().string() + "' && timeout " +
                              std::to_string(limit_seconds) + " tetgen -" + switches +
                              "zQ tissue.smesh > log 2>&1";
  TetgenResult result;
  int status = 0;
  result.seconds = seconds([&] { status = std::system(command.c_str()); });
  if (WEXITSTATUS(status) == 124) {
    result.failure = "not done after " + std::to_string(limit_seconds) + " s";
  } else if (status != 0 || !std::filesystem::exists(folder / "tissue.1.ele")) {
    std::string log = test::bytes_of(folder / "log");
    std::replace(log.begin(), log.end(), '\n', ' ');
    result.failure = "failed: " + log.substr(0, 120);
  } else {
    result.mesh = {read_table<Points>(folder / "tissue.1.node"),
                   read_table<Tets>(folder / "tissue.1.ele")};
    orient(result.mesh);
  }
  return result;
}

}  // namespace gnathion::bench
