#include "bench/registration.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>

#include "bench/timing.h"
#include "imaging/ct_import.h"
#include "io/case_file.h"
#include "io/files.h"
#include "io/obj_document.h"
#include "registration/registration.h"
#include "support/scan_scene.h"

namespace gnathion::bench {
namespace {

using Eigen::Vector3d;

constexpr double kRight = 1;  // mm at the worst landmark: a place that counts as right

/// The analytic head's skin as its CT gives it, and scans of it, LPS mm.
struct Head {
  TriangleMesh skin = test::head_skin({});
  TriangleMesh photograph = test::head_photograph({});
  TriangleMesh dressed = test::dressed_head(photograph, skin);
  SkinTarget target{skin};
};

/// What came of one start.
struct Outcome {
  Registration found;
  double seconds = 0;
  std::vector<double> errors;  ///< mm, at the landmarks

  double worst() const { return *std::max_element(errors.begin(), errors.end()); }
  bool right() const { return worst() <= kRight; }
};

Outcome outcome_of(const Head& head, const test::KnownScan& scan,
                   const RegistrationOptions& options = {},
                   const std::optional<Similarity>& start = {}) {
  Outcome outcome;
  outcome.seconds = seconds([&] {
    Progress progress;
    outcome.found = start ? register_photograph(scan.mesh, head.target, *start, options, progress)
                          : register_photograph(scan.mesh, head.target, options, progress);
  });
  for (const auto& [name, mm] : landmark_residuals(test::head_landmarks(scan.lps_from_photograph),
                                                   outcome.found.lps_from_photograph)) {
    outcome.errors.push_back(mm);
  }
  return outcome;
}

double mean(const std::vector<double>& values) {
  if (values.empty()) return std::nan("");
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double share(std::vector<double> values, double part) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

/// Outcomes of one kind of scan as a row; returns how many failures were silent.
int add_summary(Table& table, const std::string& what, const std::vector<Outcome>& outcomes) {
  int right = 0, false_alarms = 0, announced = 0, silent = 0;
  std::vector<double> errors, times;
  for (const Outcome& outcome : outcomes) {
    const bool trusted = outcome.found.trusted();
    right += trusted && outcome.right();
    false_alarms += !trusted && outcome.right();
    announced += !trusted && !outcome.right();
    silent += trusted && !outcome.right();
    times.push_back(outcome.seconds);
    if (trusted) errors.insert(errors.end(), outcome.errors.begin(), outcome.errors.end());
  }
  table.add({what, double(outcomes.size()), double(right), double(false_alarms), double(announced),
             double(silent), mean(errors), share(errors, 0.95), share(errors, 1), median(times),
             share(times, 1)});
  return silent;
}

Table summary_table() {
  return Table({"scan", "starts", "right", "right but doubted", "failures announced",
                "failures silent", "error at landmarks, mean, mm", "95th percentile, mm",
                "largest, mm", "seconds, median", "seconds, largest"});
}

constexpr std::array<double, 3> kUnits{1, 10, 1000};

std::vector<Outcome> outcomes_of(const Head& head, const TriangleMesh& scan,
                                 test::ScanFaults faults, int starts, unsigned seed) {
  std::vector<Outcome> outcomes;
  for (int i = 0; i < starts; ++i) {
    faults.mm_per_unit = kUnits[static_cast<std::size_t>(i) % kUnits.size()];
    outcomes.push_back(
        outcome_of(head, test::misplaced(scan, faults, seed + static_cast<unsigned>(i))));
  }
  return outcomes;
}

/// The starts one by one, for whoever wants to see the strays.
void write_starts(const Report& report, const std::vector<Outcome>& outcomes) {
  Table table({"start", "mm a unit", "error at landmarks, mean, mm", "largest, mm", "spread, mm",
               "agrees, %", "grip", "doubts", "seconds"});
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const Outcome& o = outcomes[i];
    const RegistrationQuality& q = o.found.quality;
    table.add({double(i), o.found.lps_from_photograph.scale, mean(o.errors), o.worst(), q.spread_mm,
               100 * q.agrees, q.grip, double(o.found.doubts.size()), o.seconds});
  }
  write_text_file(report.folder() / "registration-starts.csv", table.csv());
}

/// The lower face as after a change of expression: jaw down, lips forward.
TriangleMesh another_expression(TriangleMesh scan) {
  for (Eigen::Index v = 0; v < scan.vertices.rows(); ++v) {
    const Vector3d p = scan.vertices.row(v);
    if (p.z() < -110 || p.y() > 0) continue;
    const double low = std::clamp((-25 - p.z()) / 30, 0.0, 1.0);
    scan.vertices(v, 1) -= 2 * low;
    scan.vertices(v, 2) -= 7 * low;
  }
  return scan;
}

template <typename Keep>
TriangleMesh part_of(const TriangleMesh& mesh, Keep keep) {
  std::vector<bool> kept;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    kept.push_back(keep(Vector3d(mesh.vertices.row(mesh.triangles(f, 0)))));
  }
  return sub_mesh(mesh, kept).mesh;
}

/// Starts by hand: the truth, turned and moved.
std::vector<Outcome> from_landmarks(const Head& head, int starts, double picked_mm) {
  std::vector<Outcome> outcomes;
  for (int i = 0; i < starts; ++i) {
    const auto seed = static_cast<unsigned>(7000 + i);
    test::ScanFaults faults;
    faults.mm_per_unit = kUnits[static_cast<std::size_t>(i) % kUnits.size()];
    const test::KnownScan scan = test::misplaced(head.dressed, faults, seed);
    std::vector<LandmarkPair> pairs = test::head_landmarks(scan.lps_from_photograph);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      for (std::size_t c = 0; c < 3; ++c) {
        pairs[p].lps[static_cast<Eigen::Index>(c)] +=
            picked_mm * normal((std::uint64_t{seed} << 32) + 10 * p + c);
      }
    }
    const Similarity start = fit_landmarks(pairs, faults.mm_per_unit).lps_from_photograph;
    outcomes.push_back(outcome_of(head, scan, {}, start));
  }
  return outcomes;
}

int report_starts(const Report& report, const Head& head) {
  Table table = summary_table();
  const std::vector<Outcome> all = outcomes_of(head, head.dressed, {}, 100, 1000);
  write_starts(report, all);
  int silent = add_summary(table, "noise, outliers, hair, shoulders", all);
  silent +=
      add_summary(table, "face alone, no fault",
                  outcomes_of(head, head.photograph, {.noise_mm = 0, .outliers = 0}, 20, 2000));
  silent += add_summary(table, "all faults, another expression",
                        outcomes_of(head, another_expression(head.dressed), {}, 20, 3000));
  silent +=
      add_summary(table, "all faults, noise 1 mm, 35 % outliers",
                  outcomes_of(head, head.dressed, {.noise_mm = 1, .outliers = 0.35}, 20, 4000));
  const TriangleMesh half = part_of(head.dressed, [](const Vector3d& p) { return p.x() > -12; });
  silent += add_summary(table, "all faults, left half only", outcomes_of(head, half, {}, 20, 5000));
  silent += add_summary(table, "all faults, from landmarks picked to 3 mm (each coordinate)",
                        from_landmarks(head, 20, 3));
  report.table("registration", table);
  return silent;
}

/// Scans that have no place on the skin, or none that shape could tell: every one must be doubted.
int report_traps(const Report& report, const Head& head) {
  Table table({"scan", "starts", "announced", "silent"});
  int all_silent = 0;
  const auto add = [&](const std::string& what, const TriangleMesh& scan) {
    constexpr int kStarts = 5;
    int announced = 0, silent = 0;
    for (const Outcome& o : outcomes_of(head, scan, {}, kStarts, 6000)) {
      announced += !o.found.trusted();
      silent += o.found.trusted() && !o.right();
    }
    table.add({what, double(kStarts), double(announced), double(silent)});
    all_silent += silent;
  };
  const auto behind = [](const Vector3d& p) { return p.y() > 0 && p.z() > -100; };
  add("back of the head, hair only", part_of(head.dressed, behind));
  add("shoulders only", part_of(head.dressed, [](const Vector3d& p) { return p.z() < -130; }));
  add("forehead only", part_of(head.photograph, [](const Vector3d& p) { return p.z() > 42; }));
  add("left cheek only",
      part_of(head.photograph, [](const Vector3d& p) { return p.x() > 35 && p.z() < 0; }));
  add("a ball", test::sphere({0, 0, 0}, 95, 6));
  add("a box", test::box({0, 0, 0}, {90, 100, 120}, 40));
  TriangleMesh wide = head.dressed;
  wide.vertices.col(0) *= 1.25;
  add("a face a quarter wider", wide);
  TriangleMesh inside_out = head.dressed;
  inside_out.triangles.col(1).swap(inside_out.triangles.col(2));
  add("all triangles face inward", inside_out);
  report.table("registration-traps", table);
  return all_silent;
}

/// Every triangle cut into four.
TriangleMesh subdivided(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> middle;
  std::vector<Eigen::RowVector3d> added;
  const auto between = [&](int a, int b) {
    const auto [place, is_new] = middle.try_emplace(
        std::minmax(a, b), static_cast<int>(mesh.vertices.rows() + std::ssize(added)));
    if (is_new) added.emplace_back((mesh.vertices.row(a) + mesh.vertices.row(b)) / 2);
    return place->second;
  };
  TriangleMesh fine{{}, Triangles(4 * mesh.triangles.rows(), 3)};
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const int a = mesh.triangles(f, 0), b = mesh.triangles(f, 1), c = mesh.triangles(f, 2);
    const int ab = between(a, b), bc = between(b, c), ca = between(c, a);
    fine.triangles.middleRows<4>(4 * f) << a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca;
  }
  fine.vertices.resize(mesh.vertices.rows() + std::ssize(added), 3);
  fine.vertices.topRows(mesh.vertices.rows()) = mesh.vertices;
  for (std::size_t i = 0; i < added.size(); ++i) {
    fine.vertices.row(mesh.vertices.rows() + static_cast<Eigen::Index>(i)) = added[i];
  }
  return fine;
}

void report_time(const Report& report, const Head& head) {
  Table table({"triangles", "seconds, automatic", "seconds, from landmarks", "largest error, mm"});
  const TriangleMesh dense =
      test::dressed_head(test::head_photograph({.photograph_edge_mm = 1.4}), head.skin);
  for (const TriangleMesh& scan : {head.dressed, subdivided(dense)}) {
    const test::KnownScan known = test::misplaced(scan, {}, 8000);
    const Outcome automatic = outcome_of(head, known);
    const Outcome refined = outcome_of(head, known, {}, known.lps_from_photograph);
    table.add({double(scan.triangles.rows()), automatic.seconds, refined.seconds,
               std::max(automatic.worst(), refined.worst())});
  }
  report.table("registration-time", table);
}

/// The photograph of a case, its CT's skin, and landmarks known on both.
struct RealScan {
  TriangleMesh photograph;
  Similarity known;
  SkinTarget skin;
  std::vector<LandmarkPair> pairs;        ///< picked on the scan and on the CT
  std::vector<LandmarkPair> where_known;  ///< picked on the scan, and where the case puts them
};

RealScan real_scan(const SurgicalCase& plan, const std::map<std::string, Vector3d>& on_ct) {
  Progress progress;
  const CtVolume ct = read_ct(plan.ct.path, plan.ct.series_uid, progress);
  RealScan scan{ObjDocument::read(plan.photograph->obj).mesh().surface,
                plan.photograph->lps_from_photograph,
                SkinTarget(skin_surface(ct, plan.skin, progress)),
                {},
                {}};
  for (const auto& [name, lps] : plan.landmarks) {
    const Vector3d own = scan.known.displacement_to_source(lps - scan.known.translation);
    scan.where_known.push_back({name, own, lps});
    if (on_ct.contains(name)) scan.pairs.push_back({name, own, on_ct.at(name)});
  }
  return scan;
}

double mean_of(const std::map<std::string, double>& values) {
  std::vector<double> numbers;
  for (const auto& [name, value] : values) numbers.push_back(value);
  return mean(numbers);
}

/// Forehead and bridge of the nose, by where the case puts the scan.
std::vector<bool> stable_region(const RealScan& scan, const Vector3d& nose_tip) {
  std::vector<bool> flags;
  const Points lps = moved(scan.photograph.vertices, scan.known);
  for (const auto& row : lps.rowwise()) {
    const Vector3d p = row.transpose() - nose_tip;
    flags.push_back(p.y() < 75 && std::abs(p.x()) < 60 && p.z() > 20 && p.z() < 110 &&
                    (p.z() > 55 || std::abs(p.x()) < 22));
  }
  return flags;
}

void add_real(Table& table, const std::string& what, const RealScan& scan, const Registration& r) {
  const RegistrationQuality& q = r.quality;
  std::string doubts;
  for (const RegistrationDoubt& doubt : r.doubts) {
    doubts += (doubts.empty() ? "" : "; ") + doubt.problem;
  }
  table.add({what, r.lps_from_photograph.scale, q.rms_mm, q.median_mm, q.p95_mm, 100 * q.near,
             mean_of(landmark_residuals(scan.pairs, r.lps_from_photograph)),
             mean_of(landmark_residuals(scan.where_known, r.lps_from_photograph)), doubts});
}

void report_real(const Report& report, const std::string& name, const RealScan& scan) {
  Table table({"placed by", "mm a unit", "RMS, mm", "median, mm", "95th percentile, mm",
               "near the skin, %", "landmarks to those of the CT, mean, mm",
               "landmarks to where the case has them, mean, mm", "doubts"});
  Progress progress;
  RegistrationOptions options;
  options.landmarks = scan.pairs;
  const auto fixed = [&](const std::string& what, const Similarity& s) {
    add_real(table, what, scan,
             {s, registration_quality(scan.photograph, scan.skin, s, options), {}});
  };
  const auto fitted = [&](const std::string& what, const Similarity& start) {
    add_real(table, what, scan,
             register_photograph(scan.photograph, scan.skin, start, options, progress));
  };
  fixed("the case", scan.known);
  if (scan.pairs.size() >= 3) {
    const Similarity picked = fit_landmarks(scan.pairs).lps_from_photograph;
    fixed("landmarks, with scale", picked);
    fitted("landmarks, then surface", picked);
    options.fit_scale = true;
    fitted("landmarks, then surface with scale", picked);
    options.fit_scale = false;
    if (scan.known.scale != 1) {
      fitted("landmarks at 50 mm a unit, then surface",
             fit_landmarks(scan.pairs, 50).lps_from_photograph);
    }
    options.stable = stable_region(scan, scan.where_known.front().lps);
    for (const LandmarkPair& pair : scan.where_known) {
      if (pair.name == "nose_tip") options.stable = stable_region(scan, pair.lps);
    }
    fitted("landmarks, then forehead and bridge of the nose", picked);
    options.stable.clear();
  }
  double time = 0;
  Registration automatic;
  time = seconds(
      [&] { automatic = register_photograph(scan.photograph, scan.skin, options, progress); });
  add_real(table, "shape alone (" + number(time, 2) + " s)", scan, automatic);
  report.table(name, table);
}

void report_cases(const Report& report, const std::vector<std::string>& cases) {
  for (const std::string& path : cases) {
    const SurgicalCase plan = read_case_file(path);
    if (!plan.photograph) continue;
    std::map<std::string, Vector3d> on_ct;
    for (const std::string& other :
         cases) {  // the same CT without a photograph: marked on its skin
      const SurgicalCase bare = read_case_file(other);
      if (!bare.photograph && bare.ct == plan.ct) on_ct = bare.landmarks;
    }
    report.say(plan.name);
    const bool real = !on_ct.empty();
    if (!real) on_ct = plan.landmarks;  // a synthetic head: its photograph is of the same head
    report_real(report, real ? "registration-real" : "registration-demo", real_scan(plan, on_ct));
  }
}

}  // namespace

int report_registration(const Report& report, const std::vector<std::string>& cases) {
  report.heading("Registration");
  const Head head;
  int silent = report_starts(report, head);
  silent += report_traps(report, head);
  report_time(report, head);
  report_cases(report, cases);
  return silent;
}

}  // namespace gnathion::bench
