#include "io/calculix.h"

#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/files.h"

namespace gnathion {
namespace {

/// A deck in the making. ccx counts from 1. Node i of the mesh is node i+1; beyond the n of the
/// mesh come n nodes that belong to no element: the first entry of node n+1+i is what the normal
/// component of a sliding node i is prescribed to be, or its entries are the differences that are
/// printed; 2n+1 to 3n are the differences' nodes, 3n+1 moves by 1 along x.
class Deck {
 public:
  explicit Deck(const CalculixProblem& problem)
      : p_(problem), count_(problem.elements.nodes.rows()), used_(problem.supports.size(), false) {
    out_.precision(13);  // ccx reads numbers of at most 20 characters
    // A node of no element would leave ccx's matrix singular; only held ones may be such.
    for (const int node : p_.elements.elements.reshaped()) used_[node] = true;
  }

  std::string text() {
    write_nodes();
    write_elements();
    write_materials();
    write_sliding();
    if (p_.compared_with.size() > 0) write_differences();
    write_step();
    return out_.str();
  }

 private:
  void write_nodes();
  void write_elements();
  void write_materials();
  void write_sliding();
  void write_differences();
  void write_step();
  void write_boundary();
  void write_node(Eigen::Index number, const Eigen::RowVector3d& at) {
    out_ << number << ", " << at[0] << ", " << at[1] << ", " << at[2] << '\n';
  }
  Eigen::Index normal_node(Eigen::Index i) const { return count_ + 1 + i; }
  Eigen::Index difference_node(Eigen::Index i) const { return 2 * count_ + 1 + i; }
  Eigen::Index unit_node() const { return 3 * count_ + 1; }
  bool slides(Eigen::Index i) const { return used_[i] && p_.supports[i] == Support::sliding; }

  const CalculixProblem& p_;
  Eigen::Index count_;
  std::vector<bool> used_;
  std::ostringstream out_;
};

void Deck::write_nodes() {
  const Points& x = p_.elements.nodes;
  out_ << "*NODE, NSET=ALL\n";
  for (Eigen::Index i = 0; i < count_; ++i) {
    if (used_[i]) write_node(i + 1, x.row(i));
  }
  out_ << "*NODE, NSET=PRESCRIBED\n";
  for (Eigen::Index i = 0; i < count_; ++i) {
    if (slides(i)) write_node(normal_node(i), x.row(i));
  }
  if (p_.compared_with.size() == 0) return;
  write_node(unit_node(), x.row(0));
  out_ << "*NODE, NSET=DIFFERENCES\n";
  for (Eigen::Index i = 0; i < count_; ++i) {
    if (used_[i]) write_node(difference_node(i), x.row(i));
  }
}

void Deck::write_elements() {
  const ElementNodes& elements = p_.elements.elements;
  const char* type = elements.cols() == 4 ? "C3D4" : "C3D10";
  for (std::size_t kind = 0; kind < p_.materials.kinds.size(); ++kind) {
    bool is_first = true;
    for (Eigen::Index t = 0; t < elements.rows(); ++t) {
      if (&p_.materials[t] != &p_.materials.kinds[kind]) continue;
      if (is_first) out_ << "*ELEMENT, TYPE=" << type << ", ELSET=TISSUE" << kind << '\n';
      is_first = false;
      out_ << t + 1;
      for (const int node : elements.row(t)) out_ << ", " << node + 1;
      out_ << '\n';
    }
  }
}

void Deck::write_materials() {
  for (std::size_t kind = 0; kind < p_.materials.kinds.size(); ++kind) {
    const ElasticMaterial& material = p_.materials.kinds[kind];
    out_ << "*MATERIAL, NAME=SOFT" << kind << '\n';
    if (p_.neo_hookean) {
      out_ << "*HYPERELASTIC, NEO HOOKE\n"
           << material.shear_modulus() / 2 << ", " << 2 / material.bulk_modulus() << '\n';
    } else {
      out_ << "*ELASTIC\n" << material.young_MPa << ", " << material.poisson << '\n';
    }
    out_ << "*SOLID SECTION, ELSET=TISSUE" << kind << ", MATERIAL=SOFT" << kind << '\n';
  }
}

/// n·u − u_prescribed = 0. ccx eliminates the first term, which is therefore the largest.
void Deck::write_sliding() {
  for (Eigen::Index i = 0; i < count_; ++i) {
    if (!slides(i)) continue;
    const Eigen::Vector3d& n = p_.supports[i].normal;
    Eigen::Index first = 0;
    n.cwiseAbs().maxCoeff(&first);
    std::ostringstream terms;
    terms.precision(13);
    int count = 1;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Eigen::Index axis = (first + k) % 3;
      if (n[axis] == 0) continue;
      terms << i + 1 << ", " << axis + 1 << ", " << n[axis] << ", ";
      ++count;
    }
    out_ << "*EQUATION\n" << count << '\n' << terms.str() << normal_node(i) << ", 1, -1.\n";
  }
}

/// d − u + u_compared · 1 = 0, where d is what is printed and 1 the displacement of one node.
void Deck::write_differences() {
  for (Eigen::Index i = 0; i < count_; ++i) {
    if (!used_[i]) continue;
    for (int axis = 0; axis < 3; ++axis) {
      out_ << "*EQUATION\n3\n"
           << difference_node(i) << ", " << axis + 1 << ", 1., " << i + 1 << ", " << axis + 1
           << ", -1., " << unit_node() << ", 1, " << p_.compared_with(i, axis) << '\n';
    }
  }
}

void Deck::write_boundary() {
  out_ << "*BOUNDARY\n";
  for (Eigen::Index i = 0; i < count_; ++i) {
    const Support& support = p_.supports[i];
    if (!used_[i] || support == Support::free) continue;
    if (support == Support::sliding) {
      out_ << normal_node(i) << ", 1, 1, " << support.normal.dot(p_.prescribed.row(i)) << '\n';
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double u = support == Support::fixed ? 0 : p_.prescribed(i, axis);
      out_ << i + 1 << ", " << axis + 1 << ", " << axis + 1 << ", " << u << '\n';
    }
  }
  if (p_.compared_with.size() > 0) out_ << unit_node() << ", 1, 1, 1.\n";
}

void Deck::write_step() {
  if (p_.neo_hookean) {
    out_ << "*STEP, NLGEOM, INC=1000\n*STATIC\n0.1, 1., 1e-4, 0.25\n"
         << "*CONTROLS, PARAMETERS=FIELD\n1e-9, 1e-9, 0., 0., 1e-9, 1e-9, 1e-3, 1e-12\n";
  } else {
    out_ << "*STEP\n*STATIC\n";
  }
  write_boundary();
  const char* printed = p_.compared_with.size() > 0 ? "DIFFERENCES" : "ALL";
  out_ << "*NODE PRINT, NSET=" << printed << ", FREQUENCY=1000\nU\n*END STEP\n";
}

}  // namespace

void write_calculix_deck(const CalculixProblem& problem, const std::filesystem::path& deck) {
  write_text_file(deck, Deck(problem).text());
}

Points read_calculix_displacements(const std::filesystem::path& dat, Eigen::Index node_count) {
  std::istringstream lines(read_text_file(dat));
  Points u = Points::Zero(node_count, 3);
  Eigen::Index found = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    Eigen::Index number = 0;
    Eigen::RowVector3d value;
    if (!(words >> number >> value[0] >> value[1] >> value[2])) continue;
    const bool is_difference = number > 2 * node_count;
    const Eigen::Index node = number - 1 - (is_difference ? 2 * node_count : 0);
    if (node < 0 || node >= node_count) {
      throw Error(ErrorKind::input, dat.string(),
                  "it names node " + std::to_string(number) + ", which the mesh does not have",
                  "run ccx again on the deck of this mesh");
    }
    u.row(node) = value;
    ++found;
  }
  if (found == 0) {
    throw Error(ErrorKind::input, dat.string(), "it holds no displacements",
                "look into ccx's own messages");
  }
  return u;
}

}  // namespace gnathion
