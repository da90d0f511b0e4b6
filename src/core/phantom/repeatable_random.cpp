#include "phantom/repeatable_random.h"

namespace gnathion {

double lattice_noise(double x, double y, double z, std::uint64_t seed) {
  const double c[3] = {x, y, z};
  std::int64_t cell[3];
  double t[3];
  for (int a = 0; a < 3; ++a) {
    const double f = std::floor(c[a]);
    cell[a] = static_cast<std::int64_t>(f);
    t[a] = c[a] - f;
    t[a] = t[a] * t[a] * (3 - 2 * t[a]);
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    std::uint64_t key = seed * 0x632be59bd9b4e019ULL;
    double weight = 1;
    for (int a = 0; a < 3; ++a) {
      const int up = (corner >> a) & 1;
      key = mixed(key ^ static_cast<std::uint64_t>(cell[a] + up));
      weight *= up ? t[a] : 1 - t[a];
    }
    sum += weight * uniform(key);
  }
  return sum;
}

}  // namespace gnathion
