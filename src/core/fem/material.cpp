#include "fem/material.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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

void validate(const TissueMaterials& materials, std::ptrdiff_t tet_count) {
  for (const ElasticMaterial& kind : materials.kinds) validate(kind);
  const bool fits = materials.of_tet.empty() || std::ssize(materials.of_tet) == tet_count;
  const bool known = std::all_of(materials.of_tet.begin(), materials.of_tet.end(),
                                 [&](unsigned char kind) { return kind < materials.kinds.size(); });
  if (!materials.kinds.empty() && fits && known) return;
  throw Error(ErrorKind::numeric, "tissue materials", "they do not fit the mesh",
              "report this case: it is a fault of the program");
}

}  // namespace gnathion
