#include "render/segment_colours.h"

#include <array>

namespace gnathion {

BoneLook look_of_segment(std::size_t segment) {
  static const std::array<Eigen::Vector3d, 8> colours{{segment_look.colour,
                                                       {0.93, 0.66, 0.20},
                                                       {0.55, 0.45, 0.78},
                                                       {0.38, 0.66, 0.38},
                                                       {0.84, 0.56, 0.72},
                                                       {0.25, 0.45, 0.75},
                                                       {0.80, 0.78, 0.36},
                                                       {0.55, 0.42, 0.33}}};
  return {colours[segment % colours.size()], 1};
}

}  // namespace gnathion
