#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

class vtkRenderer;

namespace gnathion {

/// A landmark as it is marked: where it was picked on either surface, mm, LPS.
struct LandmarkMark {
  enum class Kind { photograph, ct };
  Eigen::Vector3d at;
  Kind kind;
  std::string words;    ///< beside it; empty: none
  bool chosen = false;  ///< the one that is being picked: larger
};

/// RGB, 0..1.
Eigen::Vector3d colour_of(LandmarkMark::Kind kind);

/// Landmarks as dots with their names, and lines between two places of the same one: drawn over
/// everything else and equally large at any distance. One thread, the window's own.
class LandmarkMarks {
 public:
  LandmarkMarks();
  ~LandmarkMarks();
  LandmarkMarks(const LandmarkMarks&) = delete;
  LandmarkMarks& operator=(const LandmarkMarks&) = delete;

  /// The renderer must outlive these marks, or detach() must be called before.
  void attach(vtkRenderer* renderer);
  void detach();

  /// lines: pairs of places of `marks`, by their index.
  void show(const std::vector<LandmarkMark>& marks, const std::vector<std::pair<int, int>>& lines);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
