#include "fem/material.h"

#include <cmath>
#include <string>

#include "base/error.h"

namespace gnathion {

void validate(const ElasticMaterial& material) {
  if (!std::isfinite(material.young_MPa) || material.young_MPa <= 0) {
    throw Error(ErrorKind::case_file, "tissue.young_MPa",
                "Young's modulus is " + std::to_string(material.young_MPa) + " MPa",
                "give a number greater than 0 (soft tissue: about 1)");
  }
  if (!std::isfinite(material.poisson) || material.poisson < 0 || material.poisson >= 0.5) {
    throw Error(ErrorKind::case_file, "tissue.poisson",
                "Poisson's ratio is " + std::to_string(material.poisson),
                "give a number from 0 to below 0.5 (soft tissue: 0.46)");
  }
}

}  // namespace gnathion
