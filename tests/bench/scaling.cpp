#include "bench/scaling.h"

#include <array>
#include <cmath>

#include "bench/chin_problem.h"
#include "bench/machine.h"
#include "bench/timing.h"
#include "fem/response_basis.h"

namespace gnathion::bench {
namespace {

constexpr std::array<const char*, 4> kStages{"ST Generator", "assembly", "order and factor",
                                             "response basis"};
constexpr std::array<const char*, 4> kMeterNames{"mesh", "assemble stiffness", "factorise",
                                                 "basis"};

/// A lower face of p1's edge length and about so many tets; larger ones are larger faces, so that
/// elements keep their shape. `size`: as a multiple of the lower face's own.
TriangleMesh patch_of(long tets, double& size) {
  const double vertices = static_cast<double>(tets) * 2192 / 22841;
  size = std::sqrt(vertices / 2192);
  TriangleMesh mesh =
      testing::flat_disk(static_cast<int>(vertices), static_cast<int>(180 * size), 2.2);
  testing::raise(
      mesh, [size](double x, double y) { return size * testing::lower_face(x / size, y / size); });
  return mesh;
}

struct Measured {
  double tets = 0, unknowns = 0, total = 0, peak = 0, frame = 0, frame_bytes = 0, whole_frame = 0,
         whole_frame_bytes = 0;
  std::array<StageCost, kStages.size()> stages{};
};

/// One run of the whole pipeline in this process, as numbers that a pipe carries.
std::vector<double> run(long tets) {
  double size = 1;
  const TriangleMesh mesh = patch_of(tets, size);
  StageMeter meter;
  ChinProblem p;
  meter.measure("mesh", [&] { p = chin_problem(mesh, size); });
  const StaticSolver solver(p.tissue.mesh, {}, p.supports, meter.progress());
  meter.finish();
  ResponseBasis basis;
  meter.measure("basis", [&] { basis = response_basis(solver, {p.centre}); });
  const ResponseBasis surface(basis.columns().topRows(3 * p.tissue.surface_count), {p.centre});
  const RigidMotion motion = chin_motion(p);
  Points u;
  surface.displacements({&motion, 1}, u);
  const double frame = median_seconds(301, [&] { surface.displacements({&motion, 1}, u); });
  const double whole = median_seconds(101, [&] { basis.displacements({&motion, 1}, u); });
  const auto bytes = [](const ResponseBasis& b) {  // twelve columns read, the result written
    return 13 * sizeof(double) * static_cast<double>(b.columns().rows());
  };
  std::vector<double> numbers{static_cast<double>(p.tissue.mesh.tets.rows()),
                              static_cast<double>(solver.free_part().size()),
                              frame,
                              bytes(surface),
                              whole,
                              bytes(basis)};
  double peak = 0;
  for (const char* name : kMeterNames) {
    const StageCost cost = meter.cost(name);
    numbers.push_back(cost.seconds);
    numbers.push_back(cost.growth);
    peak = std::max(peak, cost.size_at_peak);
  }
  numbers.push_back(peak);
  return numbers;
}

/// Medians over several child processes.
Measured measure(long tets) {
  const int runs = tets < 150000 ? 5 : tets < 600000 ? 3 : 1;
  std::vector<std::vector<double>> answers;
  for (int i = 0; i < runs; ++i) answers.push_back(in_child([&] { return run(tets); }));
  const auto middle = [&](std::size_t at) {
    std::vector<double> values;
    for (const auto& answer : answers) values.push_back(answer[at]);
    return median(values);
  };
  Measured m{.tets = middle(0),
             .unknowns = middle(1),
             .frame = middle(2),
             .frame_bytes = middle(3),
             .whole_frame = middle(4),
             .whole_frame_bytes = middle(5)};
  for (std::size_t s = 0; s < kStages.size(); ++s) {
    m.stages[s] = {middle(6 + 2 * s), middle(7 + 2 * s), 0};
    m.total += m.stages[s].seconds;
  }
  m.peak = middle(6 + 2 * kStages.size());
  return m;
}

void print_times(const Report& report, const std::vector<Measured>& all, double bandwidth) {
  std::vector<std::string> columns{"tets", "unknowns"};
  for (const char* stage : kStages) columns.push_back(std::string(stage) + ", s");
  columns.insert(columns.end(), {"drag-ready, s", "drag frame of the skin, ms", "GB/s",
                                 "drag frame of all nodes, ms", "GB/s", "of read bandwidth, %"});
  Table table(columns);
  for (const Measured& m : all) {
    std::vector<Table::Cell> row{m.tets, m.unknowns};
    for (const StageCost& stage : m.stages) row.emplace_back(stage.seconds);
    const double whole_speed = m.whole_frame_bytes / m.whole_frame;
    row.insert(row.end(), {m.total, 1e3 * m.frame, m.frame_bytes / m.frame / 1e9,
                           1e3 * m.whole_frame, whole_speed / 1e9, 100 * whole_speed / bandwidth});
    table.add(row);
  }
  report.table("scaling-time", table);
}

void print_memory(const Report& report, const std::vector<Measured>& all) {
  std::vector<std::string> columns{"tets"};
  for (const char* stage : kStages) columns.push_back(std::string(stage) + ", MiB");
  columns.insert(columns.end(), {"peak of the process, MiB", "peak, bytes a tet"});
  Table table(columns);
  for (const Measured& m : all) {
    std::vector<Table::Cell> row{m.tets};
    for (const StageCost& stage : m.stages) row.emplace_back(stage.growth / 1048576);
    row.insert(row.end(), {m.peak / 1048576, m.peak / m.tets});
    table.add(row);
  }
  report.table("scaling-memory", table);
}

void print_exponents(const Report& report, const std::vector<Series>& times,
                     const std::vector<Series>& memory) {
  Table table({"stage", "time ~ tets^p, p", "memory ~ tets^p, p"});
  for (std::size_t s = 0; s < times.size(); ++s) {
    const bool has_memory = s < memory.size();
    table.add({times[s].name, fitted_exponent(times[s].x, times[s].y),
               has_memory ? fitted_exponent(memory[s].x, memory[s].y) : std::nan("")});
  }
  report.table("scaling-exponents", table);
}

}  // namespace

void report_scaling(const Report& report, long largest) {
  report.heading("Scaling: one layer, 5 mm thick, edges of 2.2 mm, ever larger faces");
  double bandwidth = read_bandwidth();
  std::vector<Measured> all;
  for (const long tets : {5000L, 10000L, 22841L, 50000L, 100000L, 200000L, 500000L, 1000000L}) {
    if (tets <= largest) all.push_back(measure(tets));
  }
  bandwidth = std::max(bandwidth, read_bandwidth());
  std::vector<Series> times, memory;
  const auto series = [&](const std::string& name, auto value) {
    Series s{.name = name, .kind = Series::Kind::line};
    for (const Measured& m : all) {
      s.x.push_back(m.tets);
      s.y.push_back(value(m));
    }
    return s;
  };
  const std::array markers{Marker::circle, Marker::square, Marker::triangle, Marker::diamond};
  for (std::size_t k = 0; k < kStages.size(); ++k) {
    times.push_back(series(kStages[k], [k](const Measured& m) { return m.stages[k].seconds; }));
    memory.push_back(
        series(kStages[k], [k](const Measured& m) { return m.stages[k].growth / 1048576; }));
    times[k].colour = memory[k].colour = static_cast<int>(k);
    times[k].marker = memory[k].marker = markers[k];
  }
  times.push_back(series("drag-ready (all)", [](const Measured& m) { return m.total; }));
  memory.push_back(series("drag-ready (all)", [](const Measured& m) { return m.peak / 1048576; }));
  times[4].colour = memory[4].colour = 6;
  times.push_back(series("drag frame", [](const Measured& m) { return m.frame; }));
  times[5].colour = 5;
  times[5].marker = Marker::cross;
  report.say(
      "Medians of child processes of one thread. Read bandwidth of this machine in the same "
      "run: " +
      number(bandwidth / 1e9) + " GB/s; a basis that fits into the caches is read faster.");
  print_times(report, all, bandwidth);
  report.say("Memory: how far each stage raised the process's peak above its size before.");
  print_memory(report, all);
  print_exponents(report, times, memory);
  report.figure("scaling", "Growth with the number of tetrahedra",
                {{"Time", {"tets", true}, {"seconds", true}, times},
                 {"Memory", {"tets", true}, {"MiB, growth of the peak", true}, memory}},
                2);
}

}  // namespace gnathion::bench
