#include "demo/demo_case.h"

#include "io/case_file.h"
#include "io/files.h"
#include "phantom/head_phantom.h"

namespace gnathion {

void write_demo_case(unsigned seed, const std::filesystem::path& target, Progress& progress) {
  NewFolder folder(target);
  PhantomOptions options;
  options.seed = seed;
  const auto stage = progress.stage("default case");
  const PhantomTruth truth = write_phantom_case(folder.path(), options, progress);
  SurgicalCase plan;
  plan.name = "embedded default case";
  plan.ct.path = folder.path() / "ct";
  plan.photograph =
      PhotographSource{folder.path() / "photograph" / "face.obj", truth.lps_from_photograph};
  plan.segments.resize(1);
  plan.segments[0].cut = box_between(truth.mandible_box_min, truth.mandible_box_max);
  plan.segments[0].motion.forward_mm = 6;
  for (const char* name :
       {"pogonion_soft", "menton_soft", "mentolabial_fold", "lower_lip", "stomion", "upper_lip",
        "mouth_corner_left", "mouth_corner_right", "subnasale", "nose_tip"}) {
    plan.landmarks[name] = truth.landmarks.at(name);
  }
  write_case_file(plan, folder.path() / "case.json");
  folder.publish();
}

}  // namespace gnathion
