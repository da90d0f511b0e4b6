#include "bench/scaling.h"

#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "bench/chin_problem.h"
#include "bench/machine.h"
#include "bench/timing.h"
#include "fem/response_basis.h"

namespace gnathion::bench {

TriangleMesh patch_of(long tets, double& size) {
  const double vertices = static_cast<double>(tets) * 2192 / 22841;
  size = std::sqrt(vertices / 2192);
  TriangleMesh mesh =
      testing::flat_disk(static_cast<int>(vertices), static_cast<int>(180 * size), 2.2);
  testing::raise(
      mesh, [size](double x, double y) { return size * testing::lower_face(x / size, y / size); });
  return mesh;
}

namespace {

constexpr std::array<const char*, 4> kStages{"ST Generator", "assembly", "order and factor",
                                             "response basis"};
constexpr std::array<const char*, 4> kMeterNames{"mesh", "assemble stiffness", "factorise",
                                                 "basis"};

/// How a drag frame compares with the memory it runs in.
struct Frame {
  double seconds = 0;
  double bytes = 0;  ///< twelve columns read, the result written
  double part = 0;   ///< of the speed at which as many bytes are read
};

/// One run of the whole pipeline. Numbers only, so that a pipe can carry it.
struct Measured {
  double tets = 0, unknowns = 0, total = 0, peak = 0;
  Frame skin, all_nodes;
  std::array<StageCost, kStages.size()> stages{};
};
constexpr std::size_t kNumbers = sizeof(Measured) / sizeof(double);
static_assert(std::is_trivially_copyable_v<Measured> &&
              sizeof(Measured) == kNumbers * sizeof(double));

Frame frame_of(const ResponseBasis& basis, const RigidMotion& motion) {
  Points u;
  basis.displacements({&motion, 1}, u);
  Frame frame;
  frame.seconds = median_seconds(101, [&] { basis.displacements({&motion, 1}, u); });
  frame.bytes = 13 * sizeof(double) * static_cast<double>(basis.columns().rows());
  frame.part =
      frame.bytes / frame.seconds / read_bandwidth(static_cast<std::size_t>(frame.bytes), 101);
  return frame;
}

Measured run(long tets) {
  double size = 1;
  const TriangleMesh mesh = patch_of(tets, size);
  StageMeter meter;
  ChinProblem p;
  meter.measure("mesh", [&] { p = chin_problem(mesh, size); });
  const StaticSolver solver(p.tissue.mesh, {}, p.supports, meter.progress());
  meter.finish();
  ResponseBasis basis;
  meter.measure("basis", [&] { basis = response_basis(solver, {p.centre}); });
  Measured m;
  m.tets = static_cast<double>(p.tissue.mesh.tets.rows());
  m.unknowns = static_cast<double>(solver.free_part().size());
  for (std::size_t s = 0; s < kStages.size(); ++s) {
    m.stages[s] = meter.cost(kMeterNames[s]);
    m.total += m.stages[s].seconds;
    m.peak = std::max(m.peak, m.stages[s].size_at_peak);
  }
  const RigidMotion motion = chin_motion(p);
  m.skin = frame_of({basis.columns().topRows(3 * p.tissue.surface_count), {p.centre}}, motion);
  m.all_nodes = frame_of(basis, motion);
  return m;
}

/// Medians over several child processes, each number for itself.
Measured measure(long tets) {
  const int runs = tets < 150000 ? 5 : tets < 600000 ? 3 : 1;
  std::array<std::vector<double>, kNumbers> answers;
  for (int i = 0; i < runs; ++i) {
    const std::vector<double> numbers = in_child([&] {
      const Measured m = run(tets);
      std::vector<double> sent(kNumbers);
      std::memcpy(sent.data(), &m, sizeof m);
      return sent;
    });
    for (std::size_t k = 0; k < kNumbers; ++k) answers[k].push_back(numbers.at(k));
  }
  std::array<double, kNumbers> middle;
  for (std::size_t k = 0; k < kNumbers; ++k) middle[k] = median(answers[k]);
  Measured m;
  std::memcpy(static_cast<void*>(&m), middle.data(), sizeof m);
  return m;
}

void print_times(const Report& report, const std::vector<Measured>& all) {
  std::vector<std::string> columns{"tets", "unknowns"};
  for (const char* stage : kStages) columns.push_back(std::string(stage) + ", s");
  columns.insert(columns.end(),
                 {"drag-ready, s", "drag frame of the skin, ms", "GB/s", "of read bandwidth, %",
                  "drag frame of all nodes, ms", "GB/s ", "of read bandwidth, % "});
  Table table(columns);
  for (const Measured& m : all) {
    std::vector<Table::Cell> row{m.tets, m.unknowns};
    for (const StageCost& stage : m.stages) row.emplace_back(stage.seconds);
    row.emplace_back(m.total);
    for (const Frame& frame : {m.skin, m.all_nodes}) {
      row.insert(row.end(),
                 {1e3 * frame.seconds, frame.bytes / frame.seconds / 1e9, 100 * frame.part});
    }
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
  std::vector<Measured> all;
  for (const long tets : {5000L, 10000L, 22841L, 50000L, 100000L, 200000L, 500000L, 1000000L}) {
    if (tets <= largest) all.push_back(measure(tets));
  }
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
  times.push_back(series("drag-ready (all of these)", [](const Measured& m) { return m.total; }));
  memory.push_back(
      series("drag-ready (all of these)", [](const Measured& m) { return m.peak / 1048576; }));
  times[4].colour = memory[4].colour = 6;
  times.push_back(
      series("drag frame of the skin", [](const Measured& m) { return m.skin.seconds; }));
  times[5].colour = 5;
  times[5].marker = Marker::cross;
  report.say(
      "Medians of child processes, one thread. A drag frame's bytes a second are set against "
      "those at which the same process reads as many bytes, from the cache that holds them; "
      "512 MiB it reads at " +
      number(read_bandwidth(std::size_t{1} << 29, 7) / 1e9) + " GB/s.");
  print_times(report, all);
  report.say("Memory: how far each stage raised the process's peak above its size before.");
  print_memory(report, all);
  print_exponents(report, times, memory);
  report.figure("scaling", "Growth with the number of tetrahedra",
                {{"Time", {"tets", true}, {"seconds", true}, times},
                 {"Memory", {"tets", true}, {"MiB, growth of the peak", true}, memory}},
                2);
}

}  // namespace gnathion::bench
