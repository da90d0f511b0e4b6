#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

#include "cli/verbs.h"
#include "io/files.h"
#include "scan/scan_export.h"
#include "scan/scan_frame.h"
#include "scan/scan_import.h"
#include "scan/scan_problems.h"
#include "scan/scan_repairs.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

const char* in_a_word(Confidence confidence) {
  switch (confidence) {
    case Confidence::high:
      return "surely";
    case Confidence::fair:
      return "probably";
    case Confidence::low:
      return "perhaps";
  }
  return "";
}

/// Which of the scan's axes a row of the rotation takes.
std::string axis_in(const Eigen::RowVector3d& row) {
  int axis = 0;
  row.cwiseAbs().maxCoeff(&axis);
  return std::string(row[axis] < 0 ? "-" : "+") + "xyz"[axis];
}

void print_frame(const TriangleMesh& surface, std::ostream& out) {
  const Eigen::RowVector3d size =
      surface.vertices.colwise().maxCoeff() - surface.vertices.colwise().minCoeff();
  out << "size: " << size.x() << " x " << size.y() << " x " << size.z() << " units of the file\n";
  for (const ProposedUnit& unit : proposed_units(surface.vertices)) {
    out << "unit: " << in_a_word(unit.confidence) << ' '
        << (unit.name.empty() ? "none of the usual" : unit.name) << ", scale " << unit.mm_per_unit
        << ": " << unit.reason << '\n';
  }
  const ProposedAxes axes = scan_axes(surface);
  out << "axes: " << in_a_word(axes.confidence) << " left " << axis_in(axes.lps_from_scan.row(0))
      << ", back " << axis_in(axes.lps_from_scan.row(1)) << ", up "
      << axis_in(axes.lps_from_scan.row(2)) << ": " << axes.reason << '\n';
}

void print(const ObjDocument& document, std::ostream& out, Progress& progress) {
  const TexturedMesh& mesh = document.mesh();
  out << document.path().string() << '\n';
  const ScanProblems problems = scan_problems(mesh.surface, progress);
  const std::vector<std::string> lines = in_words(problems, mesh.surface, "units of the file");
  out << lines.front() << (document.vertex_colours().rows() > 0 ? ", coloured vertices" : "")
      << '\n';
  for (const Material& material : mesh.materials) {
    out << "material: " << material.name
        << (material.texture.empty() ? "" : ", picture " + material.texture.filename().string())
        << '\n';
  }
  print_frame(mesh.surface, out);
  for (std::size_t i = 1; i < lines.size(); ++i) out << "found: " << lines[i] << '\n';
}

/// The repairs that were asked for, each said.
ObjDocument repaired(const ObjDocument& document, const ScanRepairChoices& choices,
                     std::ostream& out) {
  RawScan scan = raw_scan(document);
  const auto take = [&](RepairedScan step) {
    out << "repaired: " << step.said << '\n';
    scan = std::move(step.scan);
  };
  if (choices.merge_duplicates) take(without_duplicate_vertices(scan));
  if (choices.drop_degenerate) take(without_degenerate_triangles(scan));
  if (choices.islands_below) take(without_islands_below(scan, *choices.islands_below));
  if (choices.orient) take(oriented(scan));
  if (choices.fill_holes) take(with_holes_filled(scan, *choices.fill_holes));
  if (choices.drop_unreferenced) take(without_unreferenced_vertices(scan));
  return ObjDocument::of_scan(document.path(), scan);
}

}  // namespace

bool ScanRepairChoices::any() const {
  return merge_duplicates || drop_degenerate || drop_unreferenced || orient || islands_below ||
         fill_holes;
}

void scan_verb(const fs::path& file, const std::optional<fs::path>& target,
               const std::string& format, const ScanRepairChoices& choices, std::ostream& out,
               Progress& progress) {
  ObjDocument document = read_scan(file, progress);
  print(document, out, progress);
  if (!target) return;
  if (choices.any()) document = repaired(document, choices, out);
  NewFolder folder(*target);
  const std::string name = file.stem().string() + "." + format;
  write_scan(document, document.mesh().surface.vertices, folder.path(), name);
  folder.publish();
  out << "wrote\n  " << (*target / name).string() << '\n';
}

}  // namespace gnathion
