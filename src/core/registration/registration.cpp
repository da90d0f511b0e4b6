#include "registration/registration.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>

#include "base/error.h"
#include "registration/automatic_start.h"
#include "registration/parallel.h"
#include "registration/units.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;
using Kind = RegistrationDoubt::Kind;

constexpr double kNear = 15;      // mm
constexpr double kAgrees = 2;     // mm
constexpr double kSmoothing = 6;  // mm, of the photograph's normals
constexpr double kAlmost = 0.8;   // of the best score: nearly as good
// Limits of what is trusted. Right places of the analytic head's scans have a spread below 0.6 mm,
// a share of agreement above 0.5 and a grip above 0.04; wrong ones a spread above 2 mm and a share
// below 0.3 (docs/evidence.md).
constexpr double kMostSpread = 1.5;  // mm
constexpr double kLeastAgreement = 0.4;
constexpr double kLeastMatched = 50;  // cm²
constexpr double kLeastStableNear = 0.6;
constexpr double kLeastGrip = 0.004;
constexpr double kMostMoved = 25;     // mm
constexpr double kMostLandmarks = 5;  // mm, RMS

std::string in_words(double value, int digits = 1) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

[[noreturn]] void refuse(const std::string& subject, const std::string& problem,
                         const std::string& remedy) {
  throw Error(ErrorKind::input, subject, problem, remedy);
}

void check(const TriangleMesh& photograph, const RegistrationOptions& options) {
  if (photograph.triangles.rows() == 0) {
    refuse("photograph", "has no triangle to fit to the skin", "choose another file");
  }
  if (!photograph.vertices.allFinite()) {
    refuse("photograph", "has a coordinate that is no finite number", "repair the file");
  }
  if (!(options.trimmed >= 0 && options.trimmed <= 0.6)) {
    refuse("trimmed share", "is " + in_words(options.trimmed, 2), "choose one from 0 to 0.6");
  }
  if (options.stable.empty()) return;
  if (static_cast<Eigen::Index>(options.stable.size()) != photograph.vertices.rows()) {
    refuse("stable region", "has flags for another number of vertices than the photograph",
           "paint it again");
  }
  if (std::count(options.stable.begin(), options.stable.end(), true) < 50) {
    refuse("stable region", "has fewer than 50 vertices", "paint more of forehead and nose");
  }
}

void check(const Similarity& start) {
  const Eigen::Matrix3d& r = start.rotation;
  if (!(start.scale > 0) || !std::isfinite(start.scale) || !start.translation.allFinite()) {
    refuse("start of the registration", "has a scale that is not above 0, or no finite place",
           "give the millimetres in a unit of the photograph");
  }
  if (!r.allFinite() || !(r * r.transpose()).isIdentity(1e-6) || r.determinant() < 0) {
    refuse("start of the registration", "is mirrored or sheared", "give a rotation");
  }
}

/// A photograph that is being registered.
struct Work {
  const SampledSurface& all;
  const SampledSurface& stable;
  const SkinTarget& skin;
  const RegistrationOptions& options;
  const Progress& progress;
};

/// The sample's first `most` points within kNear of the skin, of those that belong where that is
/// asked; a sample is shuffled.
SurfaceSample near_skin(const SurfaceSample& s, const Similarity& at, const SkinTarget& skin,
                        Eigen::Index most, const std::function<bool(const Vector3d&)>& belongs) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < s.size() && static_cast<Eigen::Index>(rows.size()) < most; ++i) {
    const Vector3d p = at(s.points.row(i));
    if ((!belongs || belongs(p)) && skin.nearest(p, kNear)) rows.push_back(i);
  }
  SurfaceSample part{
      s.points(rows, Eigen::all), s.normals(rows, Eigen::all), {}, s.area, s.spacing};
  for (const Eigen::Index i : rows) part.vertex.push_back(s.vertex[static_cast<std::size_t>(i)]);
  return part;
}

/// Points of the sample that lie on the skin, the nearer the more.
double lying_on(const SurfaceSample& sample, const SurfaceFit& fit, const SkinTarget& skin) {
  constexpr double kKernel = 3;  // mm
  const SurfaceAgreement found = agreement(sample, fit.lps_from_photograph, skin, kKernel + 1);
  const Eigen::ArrayXd away = (found.distance.array() - fit.offset_mm) / kKernel;
  return (1 - away.square()).max(0).sum();
}

/// A few points first, from afar: from as far as the start may be off, and from less far, for then
/// hair and shoulders pull less. The better one counts.
SurfaceFit quick_fit(const Work& work, const Similarity& start) {
  SurfaceFitOptions options;
  options.trimmed = work.options.trimmed;
  options.most_iterations = 40;
  options.settled_mm = 0.02;
  const SurfaceSample few = work.stable.sample_of(1500, kSmoothing / start.scale);
  SurfaceFit best;
  double most = -1;
  for (const double reach : {20.0, 10.0, 6.0}) {
    options.reach_mm = reach;
    SurfaceFit fit = fit_surface(few, start, work.skin, options, work.progress);
    const double lying = lying_on(few, fit, work.skin);
    if (lying <= most) continue;
    most = lying;
    best = std::move(fit);
  }
  return best;
}

/// Then many, from near. `part` chooses among the points by where they come to lie, LPS mm.
SurfaceFit full_fit(const Work& work, const Similarity& start,
                    const std::function<bool(const Vector3d&)>& part = {}) {
  SurfaceFitOptions options;
  options.reach_mm = 8;
  options.trimmed = work.options.trimmed;
  options.fit_scale = work.options.fit_scale;
  options.fit_offset = !work.options.fit_scale;
  const SurfaceSample many = work.stable.sample_of(24000, kSmoothing / start.scale);
  return fit_surface(near_skin(many, start, work.skin, 8000, part), start, work.skin, options,
                     work.progress);
}

double percentile(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

RegistrationQuality quality_of(const Work& work, const SurfaceFit& fit) {
  const Similarity& s = fit.lps_from_photograph;
  RegistrationQuality q;
  q.spread_mm = fit.spread_mm;
  q.offset_mm = fit.offset_mm;
  q.grip = fit.grip;
  q.iterations = fit.iterations;
  q.converged = fit.converged;
  q.landmark_mm = landmark_residuals(work.options.landmarks, s);
  const SurfaceSample sample = work.stable.sample_of(5000, kSmoothing / s.scale);
  const SurfaceAgreement found = agreement(sample, s, work.skin, kNear);
  if (found.row.empty()) return q;
  const auto count = static_cast<double>(found.row.size());
  q.near = count / static_cast<double>(sample.size());
  const auto close = ((found.distance.array() - fit.offset_mm).abs() < kAgrees).count();
  q.agrees = static_cast<double>(close) / count;
  q.matched_cm2 = static_cast<double>(close) * sample.area * s.scale * s.scale / 100;
  q.rms_mm = std::sqrt(found.distance.squaredNorm() / count);
  const Eigen::VectorXd sizes = found.distance.cwiseAbs();
  std::vector<double> values(sizes.begin(), sizes.end());
  q.median_mm = percentile(values, 0.5);
  q.p95_mm = percentile(values, 0.95);
  return q;
}

void doubt_overlap(const Work& work, Registration& r) {
  const RegistrationQuality& q = r.quality;
  const bool painted = !work.options.stable.empty();
  const auto doubt = [&](const std::string& text) {
    r.doubts.push_back({Kind::too_little, text, "pick landmarks, or check the photograph's unit"});
  };
  if (painted && q.near < kLeastStableNear) {
    doubt("only " + in_words(100 * q.near, 0) + " % of the stable region lies near the CT's skin");
  } else if (!painted && q.matched_cm2 < kLeastMatched) {
    doubt("only " + in_words(q.matched_cm2, 0) + " cm² of the photograph lie on the CT's skin");
  } else if (q.agrees < kLeastAgreement) {
    doubt("only " + in_words(100 * q.agrees, 0) +
          " % of the photograph near the CT's skin lies on it");
  }
}

void doubt_fit(Registration& r) {
  const RegistrationQuality& q = r.quality;
  if (!q.converged) {
    r.doubts.push_back(
        {Kind::not_converged,
         "the fit has not come to rest after " + std::to_string(q.iterations) + " steps",
         "begin nearer, from landmarks"});
  }
  if (q.spread_mm > kMostSpread) {
    r.doubts.push_back({Kind::too_far,
                        "the surfaces lie " + in_words(q.spread_mm) +
                            " mm apart where they fit best: another person, another "
                            "expression or another scale",
                        "look at the colour map"});
  }
  if (q.grip < kLeastGrip) {
    r.doubts.push_back({Kind::slides,
                        "the part that decides is as smooth as a ball and could slide",
                        "paint more "
                        "of the nose and the brows as stable, or pick landmarks"});
  }
}

void doubt_landmarks(Registration& r) {
  double squares = 0;
  for (const auto& [name, mm] : r.quality.landmark_mm) squares += mm * mm;
  if (r.quality.landmark_mm.empty()) return;
  const double rms = std::sqrt(squares / static_cast<double>(r.quality.landmark_mm.size()));
  if (rms <= kMostLandmarks) return;
  r.doubts.push_back(
      {Kind::landmarks_differ,
       "the landmarks are " + in_words(rms) + " mm apart (RMS) where the surfaces fit",
       "look for one that was picked "
       "elsewhere, or begin from the landmarks"});
}

/// The upper face where the fit has put it: from the nose's tip to above the brows.
SurfaceFit upper_fit(const Work& work, const SurfaceFit& whole) {
  const Vector3d nose = work.skin.forward().front().at;
  return full_fit(work, whole.lps_from_photograph, [&](const Vector3d& p) {
    return p.z() > nose.z() - 5 && p.z() < nose.z() + 110 && p.y() < nose.y() + 90;
  });
}

/// How far the two transforms part on the face, mm.
double apart_on_face(const Work& work, const Similarity& a, const Similarity& b) {
  if (work.skin.forward().empty()) return 0;
  const Vector3d nose = work.skin.forward().front().at;
  const Vector3d own = a.displacement_to_source(nose - a.translation);
  const Vector3d chin = a.displacement_to_source(nose - a.translation - Vector3d(0, -15, 60));
  return std::max((a(own) - b(own)).norm(), (a(chin) - b(chin)).norm());
}

/// The full fit and what there is to be doubted of it.
Registration registration_from(const Work& work, const Similarity& start) {
  constexpr double kMostApart = 1;  // mm
  SurfaceFit fit = full_fit(work, start);
  double apart = 0;
  if (work.options.stable.empty() && fit.converged && !work.skin.forward().empty()) {
    SurfaceFit upper = upper_fit(work, fit);
    apart = apart_on_face(work, fit.lps_from_photograph, upper.lps_from_photograph);
    if (apart > kMostApart && upper.converged) fit = std::move(upper);
  }
  Registration r{fit.lps_from_photograph, quality_of(work, fit), {}};
  doubt_overlap(work, r);
  doubt_fit(r);
  if (apart > kMostApart) {
    r.doubts.push_back({Kind::parts_differ,
                        "upper and lower face do not fit together (" + in_words(apart) +
                            " mm), as with another expression",
                        "look whether forehead and nose fit, and paint them as stable"});
  }
  doubt_landmarks(r);
  return r;
}

/// A candidate after its quick fit.
struct Candidate {
  SurfaceFit fit;
  double covered = 0;  ///< SkinTarget::covered_face
};

/// The best places in one unit, best first. Places are found and judged by the whole photograph: a
/// stable region alone is too plain for that.
std::vector<Candidate> candidates_in(const Work& work, double mm_per_unit) {
  constexpr std::size_t kMost = 5;
  const Work whole{work.all, work.all, work.skin, work.options, work.progress};
  const std::vector<PossibleStart> starts =
      automatic_starts(work.all, mm_per_unit, work.skin, {}, kMost, work.progress);
  const SurfaceSample sample = work.all.sample_of(3000, kSmoothing / mm_per_unit);
  std::vector<Candidate> candidates(starts.size());
  for_each_in_parallel(starts.size(), [&](std::size_t i) {
    candidates[i].fit = quick_fit(whole, starts[i].lps_from_photograph);
    candidates[i].covered =
        work.skin.covered_face(sample, candidates[i].fit.lps_from_photograph, 3);
  });
  return candidates;
}

/// The scale, in steps of a tenth, in which the photograph covers most of the face.
double searched_scale(const Work& work, const Points& vertices) {
  constexpr double kLeast = 130, kMost = 1000;  // mm along the longest side
  const double size = robust_size(vertices);
  double best = kLeast / size, most = 0;
  for (double scale = best; scale * size <= kMost; scale *= 1.1) {
    const SurfaceSample sample = work.all.sample(6 / scale, kSmoothing / scale);
    for (const PossibleStart& start :
         automatic_starts(work.all, scale, work.skin, {12, 30}, 3, work.progress)) {
      const double covered = work.skin.covered_face(sample, start.lps_from_photograph, 4);
      if (covered <= most) continue;
      most = covered;
      best = scale;
    }
  }
  return best;
}

bool elsewhere(const Similarity& a, const Similarity& b, const Vector3d& at) {
  const double angle = Eigen::AngleAxisd(a.rotation * b.rotation.transpose()).angle();
  return (a(at) - b(at)).norm() > 10 || angle > 10 * M_PI / 180;
}

/// The best candidate, registered; doubted when another place comes near it.
Registration best_of(const Work& work, std::vector<Candidate> candidates, const Vector3d& middle) {
  if (candidates.empty()) {
    Registration none;
    none.doubts.push_back({Kind::nothing_found,
                           "nothing of the photograph's shape is like the CT's face",
                           "pick landmarks"});
    return none;
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.covered > b.covered; });
  const Candidate& best = candidates.front();
  Registration r = registration_from(work, best.fit.lps_from_photograph);
  const bool other = std::any_of(candidates.begin() + 1, candidates.end(), [&](const Candidate& c) {
    return c.covered > kAlmost * best.covered &&
           elsewhere(c.fit.lps_from_photograph, best.fit.lps_from_photograph, middle);
  });
  if (other) {
    r.doubts.push_back({Kind::ambiguous, "it fits elsewhere nearly as well",
                        "pick landmarks to say where it belongs"});
  }
  return r;
}

}  // namespace

RegistrationQuality registration_quality(const TriangleMesh& photograph, const SkinTarget& skin,
                                         const Similarity& lps_from_photograph,
                                         const RegistrationOptions& options) {
  check(photograph, options);
  check(lps_from_photograph);
  const SampledSurface stable(photograph, options.stable);
  const Progress progress;
  SurfaceFit fit;
  fit.lps_from_photograph = lps_from_photograph;
  const SurfaceSample sample = stable.sample_of(5000, kSmoothing / lps_from_photograph.scale);
  const SurfaceAgreement found = agreement(sample, lps_from_photograph, skin, kNear);
  std::vector<double> values(found.distance.begin(), found.distance.end());
  if (!values.empty()) fit.offset_mm = percentile(values, 0.5);
  for (double& value : values) value = std::abs(value - fit.offset_mm);
  if (!values.empty()) fit.spread_mm = 1.4826 * percentile(values, 0.5);
  return quality_of({stable, stable, skin, options, progress}, fit);
}

Registration register_photograph(const TriangleMesh& photograph, const SkinTarget& skin,
                                 const Similarity& start, const RegistrationOptions& options,
                                 Progress& progress) {
  check(photograph, options);
  check(start);
  const auto stage = progress.stage("register photograph");
  const SampledSurface stable(photograph, options.stable);
  const Work work{stable, stable, skin, options, progress};
  Registration r = registration_from(work, quick_fit(work, start).lps_from_photograph);
  const double moved = apart_on_face(work, start, r.lps_from_photograph);
  if (moved > kMostMoved) {
    r.doubts.push_back({Kind::moved_far,
                        "the fit has moved the face " + in_words(moved) + " mm from its start",
                        "look whether it slid, or let it be found from shape alone"});
  }
  return r;
}

Registration register_photograph(const TriangleMesh& photograph, const SkinTarget& skin,
                                 const RegistrationOptions& options, Progress& progress) {
  check(photograph, options);
  if (options.mm_per_unit) check({.scale = *options.mm_per_unit});
  const auto stage = progress.stage("find the photograph's place");
  const SampledSurface all(photograph);
  std::optional<SampledSurface> painted;
  if (!options.stable.empty()) painted.emplace(photograph, options.stable);
  RegistrationOptions chosen = options;
  std::vector<double> scales;
  for (const ProposedUnit& unit : proposed_units(photograph.vertices)) {
    if (unit.confidence > Confidence::low) scales.push_back(unit.mm_per_unit);
  }
  if (options.mm_per_unit) scales = {*options.mm_per_unit};
  const bool known = !scales.empty();
  chosen.fit_scale = options.fit_scale || !known;
  const Work work{all, painted ? *painted : all, skin, chosen, progress};
  if (!known) scales = {searched_scale(work, photograph.vertices)};
  std::vector<Candidate> candidates;
  for (const double scale : scales) {
    const std::vector<Candidate> some = candidates_in(work, scale);
    candidates.insert(candidates.end(), some.begin(), some.end());
  }
  Registration r = best_of(work, std::move(candidates), photograph.vertices.colwise().mean());
  if (!known) {
    r.doubts.push_back(
        {Kind::unit_unknown,
         "the photograph is in no usual unit: " + in_words(r.lps_from_photograph.scale, 2) +
             " mm a unit were estimated from its shape",
         "measure it, or give the scale"});
  }
  return r;
}

}  // namespace gnathion
