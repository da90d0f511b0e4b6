#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

class vtkRenderer;

namespace gnathion {

/// One or two marked places and the line between them, with words beside it: drawn over everything
/// else and equally wide at any distance.
class MeasureMarks {
 public:
  MeasureMarks();
  ~MeasureMarks();
  MeasureMarks(const MeasureMarks&) = delete;
  MeasureMarks& operator=(const MeasureMarks&) = delete;

  /// The renderer must outlive these marks, or detach() must be called before.
  void attach(vtkRenderer* renderer);
  void detach();

  /// places: none, one or two, mm, LPS. words: beside the middle of the line, empty: none.
  void show(const std::vector<Eigen::Vector3d>& places, const std::string& words);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
