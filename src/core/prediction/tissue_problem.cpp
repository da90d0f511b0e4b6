#include "prediction/tissue_problem.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include "base/error.h"
#include "geometry/tet_quality.h"
#include "tissue/bone_normals.h"
#include "tissue/teeth.h"

namespace gnathion {
namespace {

/// The bones of an anatomy, to be asked for nearest points and hits.
struct Bones {
  std::vector<BspTree> segments;
  BspTree skull;
  BspTree all_segments;

  const BspTree& tree(int bone) const { return bone == Support::kUnmoved ? skull : segments[bone]; }
  /// mm from x to the nearest bone other than this one, at most `reach`.
  double distance_to_another(int bone, const Eigen::Vector3d& x, double reach) const {
    for (int other = Support::kUnmoved; other < static_cast<int>(segments.size()); ++other) {
      if (other == bone) continue;
      if (const auto nearest = tree(other).nearest(x, reach)) reach = nearest->distance;
    }
    return reach;
  }
};

TriangleMesh joined_segments(const Anatomy& anatomy) {
  TriangleMesh all;
  for (const BoneSegment& segment : anatomy.segments) {
    const Eigen::Index n = all.vertices.rows(), m = all.triangles.rows();
    all.vertices.conservativeResize(n + segment.mesh.vertices.rows(), 3);
    all.vertices.bottomRows(segment.mesh.vertices.rows()) = segment.mesh.vertices;
    all.triangles.conservativeResize(m + segment.mesh.triangles.rows(), 3);
    all.triangles.bottomRows(segment.mesh.triangles.rows()) =
        segment.mesh.triangles.array() + static_cast<int>(n);
  }
  return all;
}

Bones search_trees(const Anatomy& anatomy, Progress& progress) {
  const auto stage = progress.stage("search trees");
  Bones bones{{}, BspTree(anatomy.remainder), BspTree(joined_segments(anatomy))};
  for (const BoneSegment& segment : anatomy.segments) bones.segments.emplace_back(segment.mesh);
  return bones;
}

IntermediateMesh choose_region(const TriangleMesh& face, const RegionChoice& choice,
                               const BspTree& segments) {
  if (choice.vertices.empty() && choice.erased) {
    throw Error(ErrorKind::anatomy, "region", "all of it was erased",
                "paint the part of the face that may move, or take the suggested one");
  }
  return choice.vertices.empty() ? suggest_region(face, segments, choice.reach_mm)
                                 : region_of_vertices(face, choice.vertices);
}

/// mm: an inner vertex this near to a bone rests on it.
constexpr double kOnBone = 1;

/// M: the bone on which the inner vertex of each vertex of the region rests, or kNoBone.
std::vector<int> resting_on(const TissueModel& model, const Bones& bones,
                            const TissueProblem& problem) {
  std::vector<int> bone = problem.bone_below;
  for (int v = 0; v < problem.tissue.surface_count; ++v) {
    if (problem.region.held[v] || model.load == LoadModel::force) bone[v] = kNoBone;
    // Tissue that had to be made thinner, or that only a ray from the bone's edge meets, may not
    // reach the bone. The paper's generator does not try to.
    if (bone[v] == kNoBone || model.generator == Generator::paper) continue;
    const Eigen::Vector3d x = problem.tissue.mesh.vertices.row(problem.tissue.inner(v));
    if (!bones.tree(bone[v]).nearest(x, kOnBone)) bone[v] = kNoBone;
  }
  return bone;
}

/// M: whether the user marked the tissue below each vertex of the region as sliding.
std::vector<bool> marked_sliding(const TissueModel& model, const TissueProblem& problem) {
  std::vector<bool> marked(static_cast<std::size_t>(problem.tissue.surface_count), false);
  for (const int v : model.sliding_vertices) {
    if (v < 0 || v >= problem.surface_map.rows()) {
      throw Error(ErrorKind::case_file, "tissue.sliding_vertices",
                  "vertex " + std::to_string(v) + " is not one of the face's " +
                      std::to_string(problem.surface_map.rows()),
                  "give vertex numbers of the face, from 0");
    }
    double most = 0;
    for (SurfaceMap::InnerIterator weight(problem.surface_map, v); weight; ++weight) {
      most = std::max(most, weight.value());
    }
    // One on the line between the lips belongs to both sides alike.
    for (SurfaceMap::InnerIterator weight(problem.surface_map, v); weight; ++weight) {
      if (weight.value() == most) marked[weight.col()] = true;
    }
  }
  return marked;
}

/// M: whether the tissue that rests on bone slides over it, by the user's marks and the teeth.
std::vector<bool> sliding_vertices(const Anatomy& anatomy, const TissueModel& model,
                                   const std::vector<int>& bone, const TissueProblem& problem,
                                   Progress& progress) {
  std::vector<bool> slides = marked_sliding(model, problem);
  if (!model.slides_on_teeth || !anatomy.ct || model.load == LoadModel::force) return slides;
  const Crowns crowns = find_crowns(*anatomy.ct);
  if (crowns.piece_count == 0 && model.sliding_vertices.empty()) {
    progress.notice(
        "no teeth as dense as enamel or metal are in the CT, so no tissue slides on teeth; mark it "
        "with tissue.sliding_vertices where it should");
  }
  const SoftTissueMesh& tissue = problem.tissue;
  const std::vector<BoneCover> cover = bone_cover(
      crowns, tissue.mesh.vertices.middleRows(tissue.surface_count, tissue.surface_count));
  for (std::size_t v = 0; v < slides.size(); ++v) {
    if (bone[v] != kNoBone && cover[v] != BoneCover::periosteum) slides[v] = true;
  }
  return slides;
}

/// The bone's normals at the inner vertices that slide over it. M×3, zero for the others.
Points sliding_normals(const Anatomy& anatomy, const Bones& bones, const std::vector<int>& bone,
                       const std::vector<bool>& slides, const SoftTissueMesh& tissue) {
  Points normals = Points::Zero(tissue.surface_count, 3);
  for (int b = Support::kUnmoved; b < static_cast<int>(bones.segments.size()); ++b) {
    std::vector<int> here;
    for (int v = 0; v < tissue.surface_count; ++v) {
      if (slides[v] && bone[v] == b) here.push_back(v);
    }
    Points places(here.size(), 3);
    for (std::size_t i = 0; i < here.size(); ++i) {
      places.row(static_cast<Eigen::Index>(i)) = tissue.mesh.vertices.row(tissue.inner(here[i]));
    }
    const TriangleMesh& surface =
        b == Support::kUnmoved ? anatomy.remainder : anatomy.segments[b].mesh;
    const Points found = smooth_normals(surface, bones.tree(b), places);
    for (std::size_t i = 0; i < here.size(); ++i) {
      normals.row(here[i]) = found.row(static_cast<Eigen::Index>(i));
    }
  }
  return normals;
}

/// M: mm from the inner vertex of each vertex that rests on bone to bone other than that, at most
/// `reach`.
std::vector<double> distances_to_another(const Bones& bones, const std::vector<int>& bone,
                                         const SoftTissueMesh& tissue, double reach) {
  std::vector<double> distances(bone.size(), reach);
  for (int v = 0; v < tissue.surface_count; ++v) {
    if (bone[v] == kNoBone) continue;
    const Eigen::Vector3d x = tissue.mesh.vertices.row(tissue.inner(v));
    distances[v] = bones.distance_to_another(bone[v], x, reach);
  }
  return distances;
}

/// mm next to other bone within which each segment lets its tissue go: what the model says, or
/// less where that would leave a small segment next to nothing to move the face by.
std::vector<double> released_margins(const TissueModel& model, const Anatomy& anatomy,
                                     const std::vector<int>& bone,
                                     const std::vector<double>& to_another, Progress& progress) {
  constexpr double kMost = 2.0 / 3;  // of how far what rests on the segment lies from other bone
  std::vector<double> margins;
  for (int b = 0; b < static_cast<int>(anatomy.segments.size()); ++b) {
    double farthest = 0;
    for (std::size_t v = 0; v < bone.size(); ++v) {
      if (bone[v] == b) farthest = std::max(farthest, to_another[v]);
    }
    margins.push_back(std::min(model.released_mm, kMost * farthest));
    if (farthest > 0 && margins.back() < model.released_mm) {
      std::ostringstream mm;
      mm.precision(2);
      mm << margins.back() << " mm";
      progress.notice("tissue on \"" + anatomy.segments[b].name + "\" is let go within " +
                      mm.str() + " of other bone only (tissue.released_mm): it is small");
    }
  }
  return margins;
}

/// Rim fixed; inner vertices held, moved or slid over by the bone they rest on (displacement
/// transfer), unless it is next to bone on the other side of a cut; with force transfer only the
/// rim is held, as in the paper.
void set_supports(const Anatomy& anatomy, const TissueModel& model, const Bones& bones,
                  TissueProblem& problem, Progress& progress) {
  const SoftTissueMesh& tissue = problem.tissue;
  problem.supports.assign(static_cast<std::size_t>(tissue.mesh.vertices.rows()), Support::free);
  const std::vector<int> bone = resting_on(model, bones, problem);
  const std::vector<bool> slides = sliding_vertices(anatomy, model, bone, problem, progress);
  const Points normals = sliding_normals(anatomy, bones, bone, slides, tissue);
  const std::vector<double> to_another =
      distances_to_another(bones, bone, tissue, 1.5 * model.released_mm);
  const std::vector<double> margins = released_margins(model, anatomy, bone, to_another, progress);
  for (int v = 0; v < tissue.surface_count; ++v) {
    Support& inner = problem.supports[tissue.inner(v)];
    if (problem.region.held[v]) {
      // The whole column: the face does not move at the rim, nor what is below it.
      for (int level = 0; level <= tissue.layers(v); ++level) {
        problem.supports[tissue.column_node(v, level)] = Support::fixed;
      }
    }
    if (bone[v] == kNoBone) continue;
    if (slides[v]) {
      inner = Support::slides(normals.row(v), bone[v]);
      ++problem.sliding_count;
    } else if (to_another[v] <
               (bone[v] == Support::kUnmoved ? model.released_mm : margins[bone[v]])) {
      ++problem.released_count;
    } else if (bone[v] == Support::kUnmoved) {
      inner = Support::fixed;
      ++problem.on_skull_count;
    } else {
      inner = Support(Support::attached, bone[v]);
      ++problem.attached_count;
    }
  }
}

void require_driven(LoadModel load, const TissueProblem& problem) {
  const bool by_bone =
      std::any_of(problem.supports.begin(), problem.supports.end(), [](const Support& support) {
        const bool tied = support == Support::attached || support == Support::sliding;
        return tied && support.body != Support::kUnmoved;
      });
  if (load == LoadModel::displacement ? by_bone : !problem.forced.empty()) return;
  throw Error(ErrorKind::anatomy, "region",
              "no bone of a segment lies under it, so nothing would move the face",
              "choose a region over the segment, or raise tissue.bone_reach_mm");
}

void require_clean(const SoftTissueMesh& tissue) {
  const TetQuality quality = tet_quality(tissue.mesh);
  if (quality.inverted == 0) return;
  throw Error(ErrorKind::anatomy, "tissue.generator",
              "the paper's generator inverts " + std::to_string(quality.inverted) + " of " +
                  std::to_string(quality.count) + " tetrahedra on this region",
              "use the generator \"robust\", or a smaller tissue.depth_mm");
}

/// Surface vertices that a link meets, without those on the rim, ascending.
std::vector<int> forced_points(const TissueProblem& problem) {
  std::vector<int> forced;
  for (const BoneLink& link : problem.links) {
    for (const int v : problem.region.mesh.triangles.row(link.triangle)) {
      if (!problem.region.held[v]) forced.push_back(v);
    }
  }
  std::sort(forced.begin(), forced.end());
  forced.erase(std::unique(forced.begin(), forced.end()), forced.end());
  return forced;
}

/// Meshes the tissue and finds the bone below it. A region with folds deeper than the default depth
/// needs directions smoothed over more than that: each further try doubles the smoothing.
void mesh_tissue(const Bones& bones, const TissueModel& model, TissueProblem& problem,
                 Progress& progress) {
  BoneBelowOptions options;
  options.threshold = model.bone_reach_mm;
  options.default_depth = model.depth_mm;
  constexpr int kTries = 3;
  double length = model.depth_mm;
  for (int attempt = 1;; ++attempt, length *= std::sqrt(2.0)) {
    Points directions;
    BoneBelow below;
    {
      const auto stage = progress.stage("bone below the face");
      directions = parted_directions(problem.slit, offset_directions(problem.region, length));
      below = bone_below(problem.region, directions, bones.segments, bones.skull, problem.links,
                         options);
    }
    const auto stage = progress.stage("ST Generator");
    problem.bone_below = std::move(below.bone);
    if (model.generator == Generator::paper) {
      problem.tissue = st_generator_paper(problem.region, model.depth_mm);
      require_clean(problem.tissue);
      return;
    }
    try {
      RobustGeneratorOptions shape;
      if (model.layer_edges > 0) {
        shape.layers = LayerOptions{};
        shape.layers.thickness_in_edges = model.layer_edges;
      }
      problem.tissue = st_generator(problem.region, directions, below.depth, shape);
    } catch (const Error&) {
      if (attempt == kTries) throw;
      continue;
    }
    return;
  }
}

/// mm: a fixed rim nearer to the moving bone than this holds the face back where it should move.
constexpr double kNearRim = 15;

double rim_distance(const IntermediateMesh& region, const BspTree& segment) {
  double least = 1e3;
  for (std::size_t v = 0; v < region.held.size(); ++v) {
    if (!region.held[v]) continue;
    const auto nearest =
        segment.nearest(region.mesh.vertices.row(static_cast<Eigen::Index>(v)), least);
    if (nearest) least = nearest->distance;
  }
  return least;
}

/// Remeshes the region for the robust generator. `path`: of the lip line's vertices, if it has any;
/// where the region is a remesh they are moved onto the line.
void remesh(const TriangleMesh& face, const RegionChoice& choice, const TissueModel& model,
            std::vector<int>& path, TissueProblem& problem) {
  constexpr double kFineEnough = 3;  // mm: docs/evidence.md has the error of other edges
  const IntermediateMesh& dense = problem.region;
  CoarseRegion coarse =
      coarse_region(dense, face.vertices, model.edge_mm > 0 ? model.edge_mm : kFineEnough);
  if (!choice.lip_line.empty()) path = lip_path(coarse.region, choice.lip_line);
  if (!path.empty() && coarse.region.face_vertex.empty()) {
    coarse.region = drawn_to_line(coarse.region, BspTree(dense.mesh), path, choice.lip_line);
    coarse.surface_map = barycentric_map(dense, coarse.region, face.vertices);
  }
  Unfolding unfolding = unfold(coarse.region);
  problem.region = std::move(unfolding.region);
  problem.surface_map.swap(coarse.surface_map);
  problem.remeshed_mm = coarse.distance.p95;
  problem.unfolded_count = unfolding.moved_count;
  problem.unfolded_mm = unfolding.largest_move;
}

/// Chooses, remeshes and slits the region.
void set_region(const Anatomy& anatomy, const RegionChoice& choice, const TissueModel& model,
                const Bones& bones, TissueProblem& problem, Progress& progress) {
  const auto stage = progress.stage("region");
  const TriangleMesh& face = anatomy.face.mesh.surface;
  problem.region = choose_region(face, choice, bones.all_segments);
  problem.face_vertices = problem.region.face_vertex;
  std::vector<int> path;
  if (model.generator == Generator::paper) {
    problem.surface_map = index_map(problem.region, face.vertices);
    if (!choice.lip_line.empty()) path = lip_path(problem.region, choice.lip_line);
  } else {
    remesh(face, choice, model, path, problem);
  }
  if (!path.empty()) {
    LipSlit slit = slit_along(problem.region, problem.surface_map, path);
    problem.region = std::move(slit.region);
    problem.surface_map.swap(slit.surface_map);
    problem.slit = std::move(slit.vertices);
  }
  problem.rim_to_segment = rim_distance(problem.region, bones.all_segments);
  if (problem.rim_to_segment < kNearRim) {
    progress.notice("the fixed rim of the region comes within " +
                    std::to_string(std::lround(problem.rim_to_segment)) +
                    " mm of the moving bone, so the face is held back there; a larger region or "
                    "a photograph that reaches farther would be better");
  }
}

void set_links(const Anatomy& anatomy, const TissueModel& model, const Bones& bones,
               TissueProblem& problem, Progress& progress) {
  const auto stage = progress.stage("bone map");
  const BspTree skin(problem.region.mesh);
  for (std::size_t s = 0; s < bones.segments.size(); ++s) {
    const std::vector<BoneLink> links =
        bone_map(anatomy.segments[s].mesh, bones.segments[s], problem.region, skin,
                 model.bone_reach_mm, static_cast<int>(s));
    problem.links.insert(problem.links.end(), links.begin(), links.end());
  }
  problem.forced = forced_points(problem);
}

void set_materials(const Anatomy& anatomy, const TissueModel& model, TissueProblem& problem,
                   Progress& progress) {
  problem.materials = model.material;
  if (model.kinds == TissueKinds::homogeneous) return;
  const auto stage = progress.stage("tissue from the CT");
  const Eigen::VectorXd depths =
      depths_below(problem.tissue.mesh.vertices, BspTree(problem.region.mesh));
  TissueFromCt found = tissue_from_ct(*anatomy.ct, problem.tissue.mesh, depths);
  problem.materials = std::move(found.materials);
  problem.share = found.share;
  constexpr double kMany = 0.05;
  const auto tets = static_cast<double>(problem.tissue.mesh.tets.rows());
  if (static_cast<double>(found.unclear) > kMany * tets) {
    progress.notice(std::to_string(std::lround(100 * static_cast<double>(found.unclear) / tets)) +
                    " % of the tissue is neither skin, fat nor muscle in the CT and was counted as "
                    "muscle; check that photograph and CT fit together");
  }
}

}  // namespace

TissueProblem build_tissue(const Anatomy& anatomy, const RegionChoice& choice,
                           const TissueModel& model, Progress& progress) {
  TissueProblem problem;
  const Bones bones = search_trees(anatomy, progress);
  set_region(anatomy, choice, model, bones, problem, progress);
  set_links(anatomy, model, bones, problem, progress);
  mesh_tissue(bones, model, problem, progress);
  set_materials(anatomy, model, problem, progress);
  {
    const auto stage = progress.stage("supports");
    set_supports(anatomy, model, bones, problem, progress);
  }
  require_driven(model.load, problem);
  return problem;
}

}  // namespace gnathion
