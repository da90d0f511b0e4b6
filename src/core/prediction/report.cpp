#include "prediction/report.h"

#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "geometry/tet_quality.h"
#include "io/files.h"

namespace gnathion {
namespace {

using nlohmann::json;

json statistics_json(const DistanceStatistics& s) {
  return {{"count", s.count}, {"mean", s.mean}, {"p90", s.p90}, {"p95", s.p95}, {"max", s.max}};
}

json sizes_json(const Anatomy& anatomy, const TissueProblem& problem) {
  return {{"bone_triangles", anatomy.bone.triangles.rows()},
          {"face_vertices", anatomy.face.mesh.surface.vertices.rows()},
          {"face_triangles", anatomy.face.mesh.surface.triangles.rows()},
          {"region_vertices", problem.region.mesh.vertices.rows()},
          {"region_triangles", problem.region.mesh.triangles.rows()},
          {"region_mean_edge_mm", mean_edge_length(problem.region.mesh)},
          {"region_vertices_doubled_between_lips", problem.slit.size()},
          {"face_vertices_off_remesh_mm_p95", problem.remeshed_mm},
          {"region_vertices_smoothed_at_folds", problem.unfolded_count},
          {"region_smoothed_at_folds_by_mm", problem.unfolded_mm},
          {"rim_to_segment_mm", problem.rim_to_segment},
          {"bone_links", problem.links.size()},
          {"tissue_nodes", problem.tissue.mesh.vertices.rows()},
          {"tets", problem.tissue.mesh.tets.rows()},
          {"free_nodes", FreePart(problem.supports).nodes().size()},
          {"nodes_on_segment", problem.attached_count},
          {"nodes_on_other_bone", problem.on_skull_count},
          {"nodes_sliding_on_bone", problem.sliding_count},
          {"nodes_released_at_the_cut", problem.released_count},
          {"forced_points", problem.forced.size()}};
}

json quality_json(const SoftTissueMesh& tissue) {
  const TetQuality q = tet_quality(tissue.mesh);
  return {{"inverted", q.inverted},
          {"volume_mm3", q.total_volume},
          {"smallest_tet_mm3", q.smallest_volume},
          {"smallest_dihedral_deg", q.smallest_dihedral},
          {"largest_dihedral_deg", q.largest_dihedral},
          {"median_aspect", q.median_aspect},
          {"largest_aspect", q.largest_aspect},
          {"thickness_mm",
           {{"min", tissue.depth.minCoeff()},
            {"mean", tissue.depth.mean()},
            {"max", tissue.depth.maxCoeff()}}},
          {"layers_max", [&] {
             int most = 1;
             for (int v = 0; v < tissue.surface_count; ++v) most = std::max(most, tissue.layers(v));
             return most;
           }()}};
}

json model_json(const TissueModel& tissue, const TissueProblem& problem, const Answer& answer) {
  json model{{"strain", answer.large_strain ? "large, neo-Hookean" : "small, Hooke"},
             {"elements",
              answer.order == ElementOrder::linear ? "linear tetrahedra" : "quadratic tetrahedra"},
             {"chosen_because", answer.why},
             {"tolerance_mm", tissue.tolerance_mm},
             {"generator", tissue.generator == Generator::paper ? "paper" : "robust"},
             {"load", tissue.load == LoadModel::force ? "force transfer" : "displacement transfer"},
             {"kinds", tissue.kinds == TissueKinds::from_ct ? "from the CT" : "homogeneous"},
             {"depth_mm", tissue.depth_mm},
             {"bone_reach_mm", tissue.bone_reach_mm},
             {"released_mm", tissue.released_mm},
             {"slides_on_teeth", tissue.slides_on_teeth}};
  if (answer.large_strain) {
    const NeoHookeanSolution& work = answer.neo_hookean;
    model["neo_hookean"] = {{"relative_residual", work.relative_residual},
                            {"load_steps", work.load_steps},
                            {"anderson_iterations", work.anderson_iterations},
                            {"newton_iterations", work.newton_iterations},
                            {"smallest_volume_ratio", work.most_compressed.volume_ratio}};
  }
  if (tissue.kinds == TissueKinds::homogeneous) {
    model["young_MPa"] = tissue.material.young_MPa;
    model["poisson"] = tissue.material.poisson;
  } else {
    for (const auto& [name, kind] : {std::pair{"fat_mm3", TissueKind::fat},
                                     {"muscle_mm3", TissueKind::muscle},
                                     {"skin_mm3", TissueKind::skin}}) {
      model["tissue_from_ct"][name] = problem.share[static_cast<std::size_t>(kind)].volume_mm3;
    }
  }
  return model;
}

/// Of force transfer the error of the elements is not estimated.
json error_json(const FaceError& error, LoadModel load) {
  const bool estimated = load == LoadModel::displacement;
  return {{"elements",
           estimated ? statistics_json(distance_statistics(error.discretisation)) : json(nullptr)},
          {"small_strain", statistics_json(distance_statistics(error.linearisation))},
          {"both", statistics_json(error.total)}};
}

json segments_json(const SurgicalCase& plan, const Anatomy& anatomy) {
  json segments = json::array();
  for (std::size_t s = 0; s < anatomy.segments.size(); ++s) {
    const JawMotion& m = plan.segments[s].motion;
    const BoneSegment& segment = anatomy.segments[s];
    segments.push_back({{"name", segment.name},
                        {"volume_mm3", segment.volume_mm3},
                        {"triangles", segment.mesh.triangles.rows()},
                        {"forward_mm", m.forward_mm},
                        {"up_mm", m.up_mm},
                        {"left_mm", m.left_mm},
                        {"pitch_deg", m.pitch_deg},
                        {"roll_deg", m.roll_deg},
                        {"yaw_deg", m.yaw_deg},
                        {"pivot_lps_mm", {segment.pivot[0], segment.pivot[1], segment.pivot[2]}}});
  }
  return segments;
}

json landmarks_json(const Prediction& prediction) {
  json landmarks = json::object();
  for (const auto& [name, r] : prediction.landmarks) {
    landmarks[name] = {
        {"moved_left_mm", r.displacement[0]}, {"moved_forward_mm", -r.displacement[1]},
        {"moved_up_mm", r.displacement[2]},   {"bone_mm", r.bone_mm},
        {"ratio_to_bone", r.ratio},           {"landmark_to_skin_mm", r.skin_gap}};
  }
  return landmarks;
}

json inputs_json(const Anatomy& anatomy) {
  json inputs{{"ct_sha256", anatomy.ct_sha256}};
  if (!anatomy.face.is_photograph) return inputs;
  inputs["photograph_sha256"] = json::array();
  for (const auto& file : anatomy.face.document.files()) {
    inputs["photograph_sha256"].push_back(sha256_of(file));
  }
  return inputs;
}

}  // namespace

Prediction make_prediction(const SurgicalCase& plan, const Anatomy& anatomy, const FaceModel& model,
                           Progress& progress) {
  const auto stage = progress.stage("predict and check");
  const TriangleMesh& face = anatomy.face.mesh.surface;
  Prediction prediction;
  prediction.motions = planned_motions(plan, anatomy);
  const StaticSolution direct = model.solve(prediction.motions);
  prediction.relative_residual = direct.relative_residual;
  const Points from_basis = model.tissue_displacements(prediction.motions);
  const Points solved = model.order() == ElementOrder::quadratic
                            ? model.solve_quadratic(prediction.motions, progress)
                            : direct.displacements;
  const double size = solved.norm();
  if (size > 0) prediction.basis_error = (from_basis - solved).norm() / size;
  prediction.answer =
      choose_answer(anatomy, plan.region, plan.tissue, model, prediction.motions, progress);
  prediction.face_points = prediction.answer.face_points;
  Points quick;
  model.predict(prediction.motions, quick);
  const Points u = prediction.face_points - face.vertices;
  if (!prediction.answer.large_strain) {
    TetMesh deformed = prediction.answer.tissue->tissue.mesh;
    deformed.vertices += prediction.answer.displacements;
    prediction.inverted_after = (tet_volumes(deformed).array() <= 0).count();
  }

  const std::vector<int>& moving = model.moving_vertices();
  prediction.quick_mm =
      distance_statistics((quick - prediction.face_points)(moving, Eigen::all).rowwise().norm())
          .p95;
  prediction.displacement = distance_statistics(u(moving, Eigen::all).rowwise().norm());
  prediction.signed_distance = Eigen::VectorXd::Zero(face.vertices.rows());
  prediction.signed_distance(moving) =
      signed_distances(prediction.face_points(moving, Eigen::all), face);
  prediction.landmarks = FaceLandmarks(plan.landmarks, face, anatomy.segments)
                             .responses(prediction.face_points, prediction.motions);
  prediction.stage_times = progress.stage_times();
  return prediction;
}

std::string report_json(const SurgicalCase& plan, const Anatomy& anatomy,
                        const Prediction& prediction) {
  json times = json::array();
  for (const StageTime& time : prediction.stage_times) {
    times.push_back({{"stage", time.name}, {"seconds", time.seconds}});
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const json report{
      {"gnathion_report", 1},
      {"program",
       {{"name", "gnathion"},
        {"version", GNATHION_VERSION},
        {"vtk", GNATHION_VTK_VERSION},
        {"solver", default_spd_backend() == SpdBackend::cholmod ? "CHOLMOD" : "Eigen"}}},
      {"frame", "LPS, mm; the predicted OBJ is in the photograph's own frame and unit"},
      {"use", "research only; not a medical device"},
      {"inputs", inputs_json(anatomy)},
      {"face", anatomy.face.is_photograph ? "photograph" : "skin of the CT"},
      {"segments", segments_json(plan, anatomy)},
      {"model", model_json(plan.tissue, *prediction.answer.tissue, prediction.answer)},
      {"estimated_error_mm", error_json(prediction.answer.error, plan.tissue.load)},
      {"estimated_error_while_dragging_mm",
       error_json(prediction.answer.quick_error, plan.tissue.load)},
      {"face_while_dragging_differs_by_mm", prediction.quick_mm},
      {"sizes", sizes_json(anatomy, *prediction.answer.tissue)},
      {"element_quality", quality_json(prediction.answer.tissue->tissue)},
      {"displacement_mm", statistics_json(prediction.displacement)},
      {"signed_distance_mm",
       {{"min", prediction.signed_distance.minCoeff()},
        {"max", prediction.signed_distance.maxCoeff()}}},
      {"landmarks", landmarks_json(prediction)},
      {"relative_residual", prediction.relative_residual},
      {"basis_against_direct_solve", prediction.basis_error},
      {"tets_inverted_by_the_motion", prediction.inverted_after},
      {"seconds", times},
      {"peak_memory_MiB", usage.ru_maxrss / 1024}};
  return report.dump(2) + "\n";
}

}  // namespace gnathion
