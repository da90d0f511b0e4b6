#include "io/calculix.h"

#include <sstream>
#include <string>

#include "base/error.h"
#include "io/files.h"

namespace gnathion {

void write_calculix_deck(const TetMesh& mesh, const ElasticMaterial& material,
                         const Supports& supports, const Points& prescribed,
                         const std::filesystem::path& deck) {
  // A node of no element would leave ccx's matrix singular; only held ones may be such.
  std::vector<bool> used(supports.size(), false);
  for (const int node : mesh.tets.reshaped()) used[node] = true;
  std::ostringstream out;
  out.precision(13);  // ccx reads numbers of at most 20 characters
  out << "*NODE, NSET=ALL\n";
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    if (!used[i]) continue;
    out << i + 1 << ", " << mesh.vertices(i, 0) << ", " << mesh.vertices(i, 1) << ", "
        << mesh.vertices(i, 2) << '\n';
  }
  out << "*ELEMENT, TYPE=C3D4, ELSET=TISSUE\n";
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    out << t + 1;
    for (const int node : mesh.tets.row(t)) out << ", " << node + 1;
    out << '\n';
  }
  out << "*MATERIAL, NAME=SOFT\n*ELASTIC\n"
      << material.young_MPa << ", " << material.poisson << "\n"
      << "*SOLID SECTION, ELSET=TISSUE, MATERIAL=SOFT\n*STEP\n*STATIC\n*BOUNDARY\n";
  for (std::size_t i = 0; i < supports.size(); ++i) {
    if (!used[i] || supports[i] == Support::free) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const double u =
          supports[i] == Support::fixed ? 0 : prescribed(static_cast<Eigen::Index>(i), axis);
      out << i + 1 << ", " << axis + 1 << ", " << axis + 1 << ", " << u << '\n';
    }
  }
  out << "*NODE PRINT, NSET=ALL\nU\n*END STEP\n";
  write_text_file(deck, out.str());
}

Points read_calculix_displacements(const std::filesystem::path& dat, Eigen::Index node_count) {
  std::istringstream lines(read_text_file(dat));
  Points u = Points::Zero(node_count, 3);
  Eigen::Index found = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Eigen::Index node = 0;
    Eigen::RowVector3d value;
    if (!(words >> node >> value[0] >> value[1] >> value[2])) continue;
    if (node < 1 || node > node_count) break;
    u.row(node - 1) = value;
    ++found;
  }
  if (found == 0) {
    throw Error(ErrorKind::input, dat.string(), "it holds no displacements",
                "look into ccx's own messages");
  }
  return u;
}

}  // namespace gnathion
