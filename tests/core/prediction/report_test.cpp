#include "prediction/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/head_scene.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;
using nlohmann::json;

/// A prediction on the head of balls, its segment 5 mm to the front.
class Report : public ::testing::Test {
 protected:
  Report() : head_(test::head_scene()) {
    plan_.name = "Mustermann Erika";
    plan_.ct.path = folder_.write("abc.mha", "abc");
    plan_.region.reach_mm = 40;
    plan_.segments.resize(1);
    plan_.segments[0].motion.forward_mm = 5;
    plan_.landmarks = {{"chin", test::head_chin + Vector3d(0, -2, 0)},
                       {"over cheek bone", 80 * test::head_cheek_bone.normalized()},
                       {"nape", Vector3d(0, 80, 0)}};
    model_ = std::make_unique<FaceModel>(head_, plan_.region, plan_.tissue, progress_);
    prediction_ = make_prediction(plan_, head_, *model_, progress_);
  }
  const test::TemporaryFolder folder_;
  const Anatomy head_;
  SurgicalCase plan_;
  Progress progress_;
  std::unique_ptr<FaceModel> model_;
  Prediction prediction_;
};

TEST_F(Report, LandmarksSayHowTheFaceFollowsTheBone) {
  const LandmarkResponse& chin = prediction_.landmarks.at("chin");
  EXPECT_NEAR(chin.skin_gap, 2, 0.05);
  EXPECT_NEAR(chin.bone_mm, 5, 1e-12);
  EXPECT_GT(chin.ratio, 0.7);
  EXPECT_LT(chin.ratio, 1.1);
  EXPECT_NEAR(chin.ratio, -chin.displacement.y() / 5, 1e-12);
  const LandmarkResponse& cheek = prediction_.landmarks.at("over cheek bone");
  EXPECT_LT(cheek.ratio, 0.5 * chin.ratio) << "fixed bone does not hold its skin";
  EXPECT_EQ(prediction_.landmarks.at("nape").ratio, 0);
  EXPECT_EQ(prediction_.landmarks.at("nape").displacement, Vector3d::Zero());
}

TEST_F(Report, WithoutMotionNothingMovesAndNoRatioIsSaid) {
  plan_.segments[0].motion = {};
  const Prediction still = make_prediction(plan_, head_, *model_, progress_);
  EXPECT_EQ(still.face_points, head_.face.mesh.surface.vertices);
  EXPECT_EQ(still.displacement.max, 0);
  EXPECT_EQ(still.signed_distance.cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(still.basis_error, 0);
  for (const auto& [name, response] : still.landmarks) EXPECT_EQ(response.ratio, 0) << name;
}

TEST_F(Report, ChecksThePredictionByADirectSolve) {
  EXPECT_LT(prediction_.relative_residual, 1e-10);
  EXPECT_LT(prediction_.basis_error, 1e-12);
  EXPECT_GT(prediction_.basis_error, 0) << "the basis was compared with itself";
}

TEST_F(Report, APushedOutFaceBulges) {
  EXPECT_GT(prediction_.signed_distance.maxCoeff(), 3);
  EXPECT_LT(prediction_.signed_distance.maxCoeff(), 5.5);
  EXPECT_GT(prediction_.signed_distance.minCoeff(), -1.5);
  EXPECT_EQ(prediction_.signed_distance.size(), head_.face.mesh.surface.vertices.rows());
}

TEST_F(Report, TellsSizesHashesAndVersionsButNoPathAndNoName) {
  Anatomy head = head_;
  head.ct_sha256 = "ba7816bf";
  const std::string text = report_json(plan_, head, prediction_);
  const json report = json::parse(text);
  for (const char* key : {"gnathion_report", "program", "frame", "use", "inputs", "face",
                          "segments", "model", "estimated_error_mm", "sizes", "element_quality",
                          "displacement_mm", "signed_distance_mm", "landmarks", "relative_residual",
                          "basis_against_direct_solve", "seconds", "peak_memory_MiB"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  EXPECT_EQ(report["inputs"]["ct_sha256"], "ba7816bf");
  EXPECT_EQ(report["segments"][0]["forward_mm"], 5);
  EXPECT_EQ(report["sizes"]["tets"], model_->problem().tissue.mesh.tets.rows());
  EXPECT_EQ(report["sizes"]["region_vertices_doubled_between_lips"], 0);
  EXPECT_EQ(report["element_quality"]["inverted"], 0);
  EXPECT_GT(report["landmarks"]["chin"]["moved_forward_mm"], 3);
  EXPECT_GT(report["peak_memory_MiB"], 10);
  EXPECT_FALSE(report["seconds"].empty());
  EXPECT_FALSE(report["program"]["version"].get<std::string>().empty());
  EXPECT_EQ(text.find(folder_.path().string()), std::string::npos);
  EXPECT_EQ(text.find("Mustermann"), std::string::npos);
}

TEST_F(Report, TellsHowManyVerticesTheLipSlitDoubles) {
  // From side to side over the middle of the skin in front of the segment.
  for (const double x : {-12.0, -6.0, 0.0, 6.0, 12.0}) {
    plan_.region.lip_line.push_back(test::head_chin + Vector3d(x, 0, 0));
  }
  const FaceModel slit(head_, plan_.region, plan_.tissue, progress_);
  const Prediction prediction = make_prediction(plan_, head_, slit, progress_);
  const json report = json::parse(report_json(plan_, head_, prediction));
  const auto doubled = report["sizes"]["region_vertices_doubled_between_lips"].get<std::size_t>();
  EXPECT_EQ(doubled, prediction.answer.tissue->slit.size());
  EXPECT_GE(doubled, 3U);
}

}  // namespace
}  // namespace gnathion
