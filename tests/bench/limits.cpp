#include "bench/limits.h"

#include "bench/hard_cases.h"
#include "bench/timing.h"

namespace gnathion::bench {

int report_hard_cases(const Report& report) {
  report.heading("Hard cases");
  Table table({"case", "must", "did", "holds", "seconds"});
  int failed = 0, count = 0;
  for (const HardCase& hard : hard_cases()) {
    HardOutcome outcome;
    const double time = seconds([&] { outcome = outcome_of(hard); });
    table.add({hard.what, hard.must, outcome.did, outcome.held ? "yes" : "**NO**", time});
    failed += !outcome.held;
    ++count;
  }
  report.table("hard-cases", table);
  report.say(std::to_string(count - failed) + " of " + std::to_string(count) + " hold.");
  return failed;
}

}  // namespace gnathion::bench
