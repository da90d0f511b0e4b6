#include "bench/calculix_run.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "bench/timing.h"

namespace gnathion::bench {
namespace {

double processor_seconds(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto in_seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return in_seconds(usage.ru_utime) + in_seconds(usage.ru_stime);
}

Cost cost_of(int who, const std::function<void()>& work) {
  const double before = processor_seconds(who);
  Cost cost;
  cost.wall = seconds(work);
  cost.processor = processor_seconds(who) - before;
  return cost;
}

}  // namespace

Cost cost_of(const std::function<void()>& work) {
  return cost_of(RUSAGE_SELF, work);
}

std::optional<CalculixRun> run_calculix(const CalculixProblem& problem) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("gnathion-bench-ccx-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  write_calculix_deck(problem, folder / "patch.inp");
  const std::string command =
      "cd '" + folder.string() + "' && OMP_NUM_THREADS=1 ccx patch > ccx.log 2>&1";
  int status = 0;
  CalculixRun run;
  run.cost = cost_of(RUSAGE_CHILDREN, [&] { status = std::system(command.c_str()); });
  if (status == 0) {
    run.displacements =
        read_calculix_displacements(folder / "patch.dat", problem.elements.nodes.rows());
  }
  std::filesystem::remove_all(folder);
  return status == 0 ? std::optional(run) : std::nullopt;
}

}  // namespace gnathion::bench
