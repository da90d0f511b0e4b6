#include "io/calculix.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdlib>

#include "base/error.h"
#include "geometry/rigid_motion.h"
#include "support/expect_error.h"
#include "support/face_patch.h"
#include "support/temporary_folder.h"
#include "tissue/st_generator.h"

namespace gnathion {
namespace {

using test::TemporaryFolder;

/// Tissue under two lips, its rim fixed, the inner points of its middle moved by a bone.
struct Problem {
  TetMesh mesh;
  Supports supports;
  Points prescribed;
};

Problem lips_on_bone(double size) {
  const IntermediateMesh region = testing::whole_region(testing::hard_patch(1, 0));
  const SoftTissueMesh tissue =
      st_generator(region, offset_directions(region, 5),
                   Eigen::VectorXd::Constant(region.mesh.vertices.rows(), 5));
  Problem problem{tissue.mesh, Supports(static_cast<std::size_t>(tissue.mesh.vertices.rows())), {}};
  const Points& x = tissue.mesh.vertices;
  const Eigen::RowVector3d middle = x.topRows(tissue.surface_count).colwise().mean();
  for (int v = 0; v < tissue.surface_count; ++v) {
    if (region.rim[v]) {
      problem.supports[v] = problem.supports[tissue.inner(v)] = Support::fixed;
    } else if ((x.row(v) - middle).head<2>().norm() < 12) {
      problem.supports[tissue.inner(v)] = Support::attached;
    }
  }
  const RigidMotion turn{
      Eigen::AngleAxisd(0.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix(),
      Eigen::Vector3d(0.5, -4, 2)};
  problem.prescribed = size * (moved(x, turn) - x);
  return problem;
}

class CalculixAgrees : public ::testing::TestWithParam<double> {};

TEST_P(CalculixAgrees, ToAMillionthOfTheLargestDisplacement) {
  if (std::system("command -v ccx > /dev/null") != 0) {
    GTEST_SKIP() << "CalculiX is not here: apt-get install calculix-ccx";
  }
  const Problem problem = lips_on_bone(GetParam());
  const ElasticMaterial material{0.7, 0.46};
  Progress progress;
  const Points ours = StaticSolver(problem.mesh, material, problem.supports, progress)
                          .solve(problem.prescribed, Points::Zero(problem.prescribed.rows(), 3))
                          .displacements;
  const TemporaryFolder folder;
  write_calculix_deck(problem.mesh, material, problem.supports, problem.prescribed,
                      folder / "patch.inp");
  const std::string command =
      "cd '" + folder.path().string() + "' && OMP_NUM_THREADS=1 ccx patch > ccx.log 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << test::bytes_of(folder / "ccx.log");
  const Points theirs = read_calculix_displacements(folder / "patch.dat", ours.rows());
  const double difference = (ours - theirs).rowwise().norm().maxCoeff();
  EXPECT_LT(difference, 1e-6 * ours.rowwise().norm().maxCoeff());
}

// Small motions too: ccx reads 20 characters of a number, and their exponents are long.
INSTANTIATE_TEST_SUITE_P(Sizes, CalculixAgrees, ::testing::Values(1.0, 1e-6));

TEST(CalculixDeck, HasNoNumberThatCcxWouldCutShort) {
  TetMesh mesh{Points(4, 3), Tets(1, 4)};
  mesh.vertices << -1. / 30000, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  mesh.tets << 0, 1, 2, 3;
  const TemporaryFolder folder;
  const Points prescribed = Points::Constant(4, 3, -1e-7 / 3);
  write_calculix_deck(mesh, {1. / 3, 0.46}, Supports(4, Support::attached), prescribed,
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
