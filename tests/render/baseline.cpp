#include "render/baseline.h"

#include <algorithm>
#include <cstdlib>

#include "base/error.h"

namespace gnathion::test {
namespace {

constexpr double mean_allowed = 0.8;
constexpr double far_pixels_allowed = 0.004;
constexpr int far = 32;

/// Equal is white; the more it differs, the darker.
Picture difference_picture(const Picture& a, const Picture& b) {
  Picture out = a;
  for (size_t i = 0; i < out.rgb.size(); ++i) {
    out.rgb[i] =
        static_cast<std::uint8_t>(255 - std::min(255, 8 * std::abs(int{a.rgb[i]} - int{b.rgb[i]})));
  }
  return out;
}

}  // namespace

PictureDifference difference(const Picture& a, const Picture& b) {
  double sum = 0;
  int far_count = 0;
  for (size_t pixel = 0; pixel < a.rgb.size(); pixel += 3) {
    int largest = 0;
    for (size_t c = 0; c < 3; ++c) {
      const int apart = std::abs(int{a.rgb[pixel + c]} - int{b.rgb[pixel + c]});
      sum += apart;
      largest = std::max(largest, apart);
    }
    if (largest > far) ++far_count;
  }
  const auto channels = static_cast<double>(a.rgb.size());
  return {sum / channels, far_count / (channels / 3)};
}

testing::AssertionResult matches_baseline(const Picture& picture,
                                          const std::filesystem::path& baseline,
                                          const std::filesystem::path& candidates) {
  std::filesystem::create_directories(candidates);
  const auto candidate = candidates / baseline.filename();
  const std::string accept = "; look at " + candidate.string() +
                             " and, if it is right, accept it with: cp '" + candidate.string() +
                             "' '" + baseline.string() + "'";
  Picture stored;
  try {
    stored = read_picture_file(baseline);
  } catch (const Error& error) {
    write_png(picture, candidate);
    return testing::AssertionFailure() << "no baseline: " << error.what() << accept;
  }
  if (stored.width != picture.width || stored.height != picture.height) {
    write_png(picture, candidate);
    return testing::AssertionFailure() << baseline << " has another size" << accept;
  }
  const PictureDifference d = difference(picture, stored);
  if (d.mean <= mean_allowed && d.far_pixels <= far_pixels_allowed) {
    return testing::AssertionSuccess();
  }
  write_png(picture, candidate);
  auto shown = candidate;
  shown.replace_extension(".difference.png");
  write_png(difference_picture(picture, stored), shown);
  return testing::AssertionFailure()
         << baseline << " differs: mean " << d.mean << " (allowed " << mean_allowed << "), "
         << 100 * d.far_pixels << " % of pixels far apart (allowed " << 100 * far_pixels_allowed
         << " %); difference " << shown << accept;
}

testing::AssertionResult matches_baseline(const Picture& picture, const std::string& name) {
  return matches_baseline(
      picture, std::filesystem::path(GNATHION_TESTS_FOLDER) / "baselines" / (name + ".png"),
      GNATHION_PICTURE_CANDIDATES);
}

}  // namespace gnathion::test
