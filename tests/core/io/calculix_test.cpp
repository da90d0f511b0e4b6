#include "io/calculix.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdlib>
#include <tuple>

#include "base/error.h"
#include "fem/neo_hookean_solver.h"
#include "geometry/rigid_motion.h"
#include "support/expect_error.h"
#include "support/face_patch.h"
#include "support/temporary_folder.h"
#include "tissue/st_generator.h"

namespace gnathion {
namespace {

using test::TemporaryFolder;

enum class Held { tied, sliding };

/// Tissue under two lips, its rim fixed, the inner points of its middle moved by a bone, to which
/// they are tied or on which they slide.
CalculixProblem lips_on_bone(double size, ElementOrder order, Held held) {
  const IntermediateMesh region = testing::whole_region(testing::hard_patch(1, 0));
  const SoftTissueMesh tissue =
      st_generator(region, offset_directions(region, 5),
                   Eigen::VectorXd::Constant(region.mesh.vertices.rows(), 5));
  const Points& x = tissue.mesh.vertices;
  const Points normals = vertex_normals(region.mesh);
  Supports supports(static_cast<std::size_t>(x.rows()));
  const Eigen::RowVector3d middle = x.topRows(tissue.surface_count).colwise().mean();
  for (int v = 0; v < tissue.surface_count; ++v) {
    if (region.rim[v]) {
      supports[v] = supports[tissue.inner(v)] = Support::fixed;
    } else if ((x.row(v) - middle).head<2>().norm() < 12) {
      const bool slides = held == Held::sliding && x(v, 1) > middle[1];
      supports[tissue.inner(v)] =
          slides ? Support::slides(normals.row(v).transpose(), 0) : Support(Support::attached);
    }
  }
  CalculixProblem problem{ElementMesh(tissue.mesh, order), {}, {}, {}};
  problem.supports = supports_of_nodes(problem.elements, supports);
  std::vector<unsigned char> kind_of_tet;
  for (Eigen::Index t = 0; t < tissue.mesh.tets.rows(); ++t) {
    kind_of_tet.push_back(x(tissue.mesh.tets(t, 0), 0) > middle[0]);
  }
  // Our quadratic elements are C3D10 only without λ, which sees their mean dilatation.
  problem.materials = order == ElementOrder::linear
                          ? TissueMaterials({{0.7, 0.46}, {0.2, 0.49}}, kind_of_tet)
                          : TissueMaterials({{0.7, 0}, {0.2, 0}}, kind_of_tet);
  const RigidMotion turn{
      Eigen::AngleAxisd(0.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix(),
      Eigen::Vector3d(0.5, -4, 2)};
  const std::array motions{turn};
  problem.prescribed = size * bone_displacements(problem.elements.nodes, problem.supports, motions);
  return problem;
}

bool has_calculix() {
  return std::system("command -v ccx > /dev/null") == 0;
}

/// What ccx prints for the problem.
Points answer_of_calculix(const CalculixProblem& problem) {
  const TemporaryFolder folder;
  write_calculix_deck(problem, folder / "patch.inp");
  const std::string command =
      "cd '" + folder.path().string() + "' && OMP_NUM_THREADS=1 ccx patch > ccx.log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << test::bytes_of(folder / "ccx.log");
  return read_calculix_displacements(folder / "patch.dat", problem.elements.nodes.rows());
}

Points our_answer(const CalculixProblem& problem) {
  Progress progress;
  return StaticSolver(problem.elements, problem.materials, problem.supports, progress)
      .solve(problem.prescribed, Points::Zero(problem.prescribed.rows(), 3))
      .displacements;
}

using Case = std::tuple<double, ElementOrder, Held>;
class CalculixAgrees : public ::testing::TestWithParam<Case> {};

// Two tissues, one nearly incompressible; small motions too: ccx reads 20 characters of a number,
// and their exponents are long.
TEST_P(CalculixAgrees, ToRounding) {
  if (!has_calculix()) GTEST_SKIP() << "CalculiX is not here: apt-get install calculix-ccx";
  const auto [size, order, held] = GetParam();
  CalculixProblem problem = lips_on_bone(size, order, held);
  const Points ours = our_answer(problem);
  problem.compared_with = ours;
  const double difference = answer_of_calculix(problem).rowwise().norm().maxCoeff();
  EXPECT_LT(difference, 1e-10 * ours.rowwise().norm().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(Problems, CalculixAgrees,
                         ::testing::Values(Case(1, ElementOrder::linear, Held::tied),
                                           Case(1e-6, ElementOrder::linear, Held::tied),
                                           Case(1, ElementOrder::linear, Held::sliding),
                                           Case(1, ElementOrder::quadratic, Held::tied),
                                           Case(1, ElementOrder::quadratic, Held::sliding)));

class CalculixAgreesOnLargeStrain : public ::testing::TestWithParam<Case> {};

TEST_P(CalculixAgreesOnLargeStrain, ToATenBillionth) {
  if (!has_calculix()) GTEST_SKIP() << "CalculiX is not here: apt-get install calculix-ccx";
  const auto [size, order, held] = GetParam();
  CalculixProblem problem = lips_on_bone(size, order, held);
  // Stiff, since ccx is content with a residual of 1e-8 N whatever is asked of it.
  problem.materials = {{{7e4, 0.46}, {2e4, 0.4}}, problem.materials.of_tet};
  problem.neo_hookean = true;
  Progress progress;
  const StaticSolver linear(problem.elements, problem.materials, problem.supports, progress);
  const Points start = Points::Zero(problem.prescribed.rows(), 3);
  NeoHookeanOptions exact;
  exact.tolerance = 1e-11;
  const Points ours =
      NeoHookeanSolver(linear)
          .solve([&](double t) -> Points { return t * problem.prescribed; }, start, progress, exact)
          .displacements;
  problem.compared_with = ours;
  const double largest = ours.rowwise().norm().maxCoeff();
  EXPECT_LT(answer_of_calculix(problem).rowwise().norm().maxCoeff(), 1e-10 * largest);
  const double nonlinear = (our_answer(problem) - ours).rowwise().norm().maxCoeff();
  EXPECT_GT(nonlinear, 0.01 * largest);  // or the test would say nothing
}

INSTANTIATE_TEST_SUITE_P(Problems, CalculixAgreesOnLargeStrain,
                         ::testing::Values(Case(1, ElementOrder::linear, Held::tied),
                                           Case(1, ElementOrder::linear, Held::sliding),
                                           Case(2, ElementOrder::linear, Held::tied)));

TEST(Calculix, PrintsTheDisplacementsWhereNothingIsCompared) {
  if (!has_calculix()) GTEST_SKIP() << "CalculiX is not here: apt-get install calculix-ccx";
  const CalculixProblem problem = lips_on_bone(1, ElementOrder::linear, Held::tied);
  const Points ours = our_answer(problem);
  const double difference = (answer_of_calculix(problem) - ours).rowwise().norm().maxCoeff();
  EXPECT_LT(difference, 1e-6 * ours.rowwise().norm().maxCoeff());
  EXPECT_GT(difference, 0);  // of seven digits
}

TEST(Calculix, PrintsWhatIsLeftOfAWrongAnswer) {
  if (!has_calculix()) GTEST_SKIP() << "CalculiX is not here: apt-get install calculix-ccx";
  CalculixProblem problem = lips_on_bone(1, ElementOrder::linear, Held::sliding);
  const Points ours = our_answer(problem);
  problem.compared_with = (1 - 1e-6) * ours;
  const Points left = answer_of_calculix(problem);
  EXPECT_LT((left - 1e-6 * ours).rowwise().norm().maxCoeff(),
            1e-11 * ours.rowwise().norm().maxCoeff());
}

TEST(CalculixDeck, HasNoNumberThatCcxWouldCutShort) {
  TetMesh mesh{Points(4, 3), Tets(1, 4)};
  mesh.vertices << -1. / 30000, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  mesh.tets << 0, 1, 2, 3;
  const TemporaryFolder folder;
  const Points prescribed = Points::Constant(4, 3, -1e-7 / 3);
  write_calculix_deck({mesh, ElasticMaterial{1. / 3, 0.46}, Supports(4, Support::attached),
                       prescribed, false, prescribed / 7},
                      folder / "one.inp");
  const std::string deck = test::bytes_of(folder / "one.inp");
  EXPECT_NE(deck.find("-3.33333333333"), std::string::npos);
  for (std::size_t begin = 0; begin < deck.size();) {
    std::size_t end = deck.find_first_of(",\n ", begin);
    if (end == std::string::npos) end = deck.size();
    const std::string word = deck.substr(begin, end - begin);
    if (word.find_first_not_of("0123456789+-.e") == std::string::npos) {
      EXPECT_LE(word.size(), 20U) << word;
    }
    begin = end + 1;
  }
}

TEST(CalculixResult, RefusesAFileWithoutDisplacements) {
  const TemporaryFolder folder;
  test::expect_error(ErrorKind::input, {"none.dat"},
                     [&] { read_calculix_displacements(folder / "none.dat", 3); });
  folder.write("bad.dat", "\n nothing was solved\n");
  test::expect_error(ErrorKind::input, {"bad.dat", "no displacements"},
                     [&] { read_calculix_displacements(folder / "bad.dat", 3); });
}

TEST(CalculixResult, NodesThatTheDeckDoesNotHaveAreStill) {
  const TemporaryFolder folder;
  folder.write("a.dat",
               "\n displacements (vx,vy,vz) for set ALL and time  0.1000000E+01\n\n"
               "         1  1.000000E+00 -2.500000E-03  0.000000E+00\n"
               "         3  4.000000E+00  5.000000E+00  6.000000E+00\n");
  Points expected = Points::Zero(3, 3);
  expected.row(0) << 1, -0.0025, 0;
  expected.row(2) << 4, 5, 6;
  EXPECT_EQ(read_calculix_displacements(folder / "a.dat", 3), expected);
}

}  // namespace
}  // namespace gnathion
