#include "render/colour_map.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace gnathion::test {
namespace {

double linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

Eigen::Vector3d linear(const Eigen::Vector3d& srgb) {
  return {linear(srgb.x()), linear(srgb.y()), linear(srgb.z())};
}

double luminance(const Eigen::Vector3d& srgb) {
  return Eigen::Vector3d(0.2126, 0.7152, 0.0722).dot(linear(srgb));
}

TEST(ColourMap, CoolBelowNeutralInTheMiddleHotAbove) {
  const Eigen::Vector3d cool = diverging_colour(-1), middle = diverging_colour(0),
                        hot = diverging_colour(1);
  EXPECT_GT(cool.z(), cool.x() + 0.4);
  EXPECT_GT(hot.x(), hot.z() + 0.4);
  EXPECT_NEAR(middle.minCoeff(), middle.maxCoeff(), 0.01);
  EXPECT_GT(middle.minCoeff(), 0.8);
  EXPECT_EQ(diverging_colour(-7), cool);
  EXPECT_EQ(diverging_colour(7), hot);
}

TEST(ColourMap, DarkensEvenlyAwayFromZero) {
  for (double x = 0; x < 0.99; x += 0.05) {
    EXPECT_LT(luminance(diverging_colour(x + 0.05)), luminance(diverging_colour(x)));
    EXPECT_LT(luminance(diverging_colour(-x - 0.05)), luminance(diverging_colour(-x)));
    EXPECT_NEAR(luminance(diverging_colour(x)), luminance(diverging_colour(-x)), 0.03);
  }
}

/// Hollow and bulge stay apart for people without red or green cones (matrices in linear RGB:
/// Machado, Oliveira, Fernandes 2009, severity 1).
TEST(ColourMap, SignStaysVisibleWithColourVisionDeficiency) {
  Eigen::Matrix3d no_green, no_red;
  no_green << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
      0.968881;
  no_red << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
      1.051998;
  for (const Eigen::Matrix3d& sight : {no_green, no_red}) {
    for (const double x : {0.25, 0.5, 1.0}) {
      const Eigen::Vector3d cool = sight * linear(diverging_colour(-x));
      const Eigen::Vector3d hot = sight * linear(diverging_colour(x));
      EXPECT_GT((cool - hot).norm(), 0.25 * x);
      EXPECT_GT(cool.z() - hot.z(), 0.2 * x);
    }
  }
}

TEST(ColourMap, RangeIsRound) {
  EXPECT_EQ(round_half_range(Eigen::VectorXd::Zero(5)), 1);
  EXPECT_EQ(round_half_range(Eigen::VectorXd()), 1);
  EXPECT_EQ(round_half_range(Eigen::VectorXd::Constant(5, -7.3)), 8);
  EXPECT_EQ(round_half_range(Eigen::VectorXd::Constant(5, 9)), 10);
  EXPECT_EQ(round_half_range(Eigen::VectorXd::Constant(5, 2)), 2);
  EXPECT_NEAR(round_half_range(Eigen::VectorXd::Constant(5, 0.07)), 0.1, 1e-12);
  EXPECT_NEAR(round_half_range(Eigen::VectorXd::Constant(5, 0.43)), 0.5, 1e-12);
}

TEST(ColourMap, RangeIgnoresFewOutliersTheUnmeasuredAndTheFaceAtRest) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(10000);
  values.head(1000).setConstant(3.9);
  values(7) = 250;
  values(8) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(round_half_range(values), 4);
}

}  // namespace
}  // namespace gnathion::test
