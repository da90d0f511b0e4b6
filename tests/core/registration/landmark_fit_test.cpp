#include "registration/landmark_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "support/expect_error.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;
using test::expect_error;

Similarity known(double scale) {
  Similarity s;
  s.scale = scale;
  s.rotation = Eigen::AngleAxisd(2.4, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  s.translation = {40, -300, 410};
  return s;
}

/// Landmarks of a face, exact under the transform.
std::vector<LandmarkPair> face_pairs(const Similarity& s) {
  std::vector<LandmarkPair> pairs;
  for (const auto& [name, lps] : {std::pair{"nasion", Vector3d(0, -100, 30)},
                                  {"nose tip", Vector3d(0, -125, -13)},
                                  {"left mouth corner", Vector3d(25, -94, -42)},
                                  {"right mouth corner", Vector3d(-26, -93, -42)},
                                  {"pogonion", Vector3d(1, -105, -73)}}) {
    pairs.push_back({name, s.displacement_to_source(lps - s.translation), lps});
  }
  return pairs;
}

void expect_same(const Similarity& a, const Similarity& b) {
  EXPECT_NEAR(a.scale / b.scale, 1, 1e-10);
  EXPECT_TRUE(a.rotation.isApprox(b.rotation, 1e-9)) << a.rotation;
  EXPECT_TRUE(a.translation.isApprox(b.translation, 1e-9)) << a.translation.transpose();
}

TEST(LandmarkFit, FindsTheTransformInAnyUnit) {
  for (const double scale : {1.0, 10.0, 1000.0, 58.0494}) {
    const LandmarkFit fit = fit_landmarks(face_pairs(known(scale)));
    expect_same(fit.lps_from_photograph, known(scale));
    EXPECT_LT(fit.rms_mm, 1e-8);
  }
}

TEST(LandmarkFit, KeepsAScaleThatIsGiven) {
  const std::vector<LandmarkPair> pairs = face_pairs(known(10));
  expect_same(fit_landmarks(pairs, 10).lps_from_photograph, known(10));
  const LandmarkFit larger = fit_landmarks(pairs, 11);
  EXPECT_EQ(larger.lps_from_photograph.scale, 11);
  EXPECT_GT(larger.rms_mm, 1);
}

TEST(LandmarkFit, TellsTheResidualOfEachLandmark) {
  std::vector<LandmarkPair> pairs = face_pairs(known(1));
  pairs[4].lps.z() += 8;
  const LandmarkFit fit = fit_landmarks(pairs, 1);
  double squares = 0;
  for (const LandmarkPair& pair : pairs) {
    const double mm = (fit.lps_from_photograph(pair.photograph) - pair.lps).norm();
    EXPECT_NEAR(fit.residual_mm.at(pair.name), mm, 1e-12);
    EXPECT_LE(mm, fit.residual_mm.at("pogonion"));
    squares += mm * mm;
  }
  EXPECT_NEAR(fit.rms_mm, std::sqrt(squares / 5), 1e-12);
}

TEST(LandmarkFit, IsTheBestNearby) {
  std::vector<LandmarkPair> pairs = face_pairs(known(1));
  double phase = 0;
  for (LandmarkPair& pair : pairs) {
    phase += 1;
    pair.lps += 3 * Vector3d(std::sin(7 * phase), std::cos(5 * phase), std::sin(3 * phase));
  }
  const LandmarkFit fit = fit_landmarks(pairs);
  const auto squares = [&](const Similarity& s) {
    double sum = 0;
    for (const auto& [name, mm] : landmark_residuals(pairs, s)) sum += mm * mm;
    return sum;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Similarity moved = fit.lps_from_photograph;
      moved.translation[axis] += 0.01 * sign;
      EXPECT_GT(squares(moved), squares(fit.lps_from_photograph));
      Similarity turned = fit.lps_from_photograph;
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(1e-4 * sign, Vector3d::Unit(axis)).toRotationMatrix();
      turned.rotation = turn * turned.rotation;
      turned.translation = turn * turned.translation;
      EXPECT_GT(squares(turned), squares(fit.lps_from_photograph));
    }
  }
}

TEST(LandmarkFit, TakesThreeInAPlane) {
  std::vector<LandmarkPair> pairs = face_pairs(known(1000));
  pairs.erase(pairs.begin() + 3, pairs.end());
  const LandmarkFit fit = fit_landmarks(pairs);
  expect_same(fit.lps_from_photograph, known(1000));
  EXPECT_NEAR(fit.lps_from_photograph.rotation.determinant(), 1, 1e-12);
}

TEST(LandmarkFit, RefusesTwo) {
  std::vector<LandmarkPair> pairs = face_pairs(known(1));
  pairs.resize(2);
  expect_error(ErrorKind::input, {"landmarks", "2", "three"}, [&] { fit_landmarks(pairs); });
}

TEST(LandmarkFit, RefusesALine) {
  std::vector<LandmarkPair> pairs = face_pairs(known(1));
  pairs.resize(3);
  pairs[2].lps = (pairs[0].lps + pairs[1].lps) / 2 + Vector3d(0.2, 0, 0);
  expect_error(ErrorKind::input, {"landmarks", "line on the CT", "side"},
               [&] { fit_landmarks(pairs); });
  pairs = face_pairs(known(1));
  pairs.resize(3);
  pairs[2].photograph = 2 * pairs[0].photograph - pairs[1].photograph;
  expect_error(ErrorKind::input, {"line in the photograph"}, [&] { fit_landmarks(pairs, 1); });
}

TEST(LandmarkFit, RefusesOnePlaceTwice) {
  std::vector<LandmarkPair> pairs = face_pairs(known(1));
  pairs[1].photograph = pairs[0].photograph;
  expect_error(ErrorKind::input, {"landmark nose tip", "nasion", "in the photograph"},
               [&] { fit_landmarks(pairs); });
  pairs = face_pairs(known(1));
  pairs[1].lps = pairs[0].lps;
  expect_error(ErrorKind::input, {"landmark nose tip", "nasion", "on the CT"},
               [&] { fit_landmarks(pairs); });
  pairs = face_pairs(known(1));
  pairs[1].name = pairs[0].name;
  expect_error(ErrorKind::input, {"landmark nasion", "twice"}, [&] { fit_landmarks(pairs); });
}

TEST(LandmarkFit, RefusesNoNumberAndNoScale) {
  std::vector<LandmarkPair> pairs = face_pairs(known(1));
  expect_error(ErrorKind::input, {"scale", "above 0"}, [&] { fit_landmarks(pairs, 0); });
  expect_error(ErrorKind::input, {"scale", "mirror"}, [&] { fit_landmarks(pairs, -1); });
  pairs[2].lps.x() = std::numeric_limits<double>::quiet_NaN();
  expect_error(ErrorKind::input, {"landmark left mouth corner", "finite"},
               [&] { fit_landmarks(pairs); });
}

TEST(LandmarkFit, RefusesAMirroredFace) {
  std::vector<LandmarkPair> pairs = face_pairs(known(1));
  for (LandmarkPair& pair : pairs) pair.photograph.x() *= -1;
  expect_error(ErrorKind::input, {"mirror image", "left and a right"},
               [&] { fit_landmarks(pairs); });
}

}  // namespace
}  // namespace gnathion
