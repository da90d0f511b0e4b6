#pragma once

#include <cmath>
#include <cstdint>

/// Random numbers as pure functions of a key: the same on every run, in any order, on any number
/// of threads. (The distributions of <random> differ between standard libraries.)
namespace gnathion {

/// splitmix64's mixing of one 64-bit word.
inline std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// Uniform in [0, 1).
inline double uniform(std::uint64_t key) {
  return static_cast<double>(mixed(key) >> 11) * 0x1.0p-53;
}

/// Standard normal, by Box and Muller's formula.
inline double normal(std::uint64_t key) {
  const std::uint64_t word = mixed(key);
  const double u = static_cast<double>((word >> 32) + 1) * 0x1.0p-32;  // (0, 1]
  const double v = static_cast<double>(word & 0xffffffffULL) * 0x1.0p-32;
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * M_PI * v);
}

/// Smooth noise in [0, 1] over space; one cell of its lattice is the unit of x, y and z.
double lattice_noise(double x, double y, double z, std::uint64_t seed);

}  // namespace gnathion
