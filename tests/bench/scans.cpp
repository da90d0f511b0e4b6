#include "bench/scans.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <string>

#include "bench/timing.h"
#include "scan/scan_export.h"
#include "scan/scan_import.h"
#include "scan/scan_problems.h"
#include "scan_stream/scan_stream.h"
#include "support/temporary_folder.h"

#include "bench/machine.h"

namespace gnathion::bench {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// A bulging sheet of side² quads, halved, textured from edge to edge and coloured, with split
/// vertices and texture coordinates along the middle column.
RawScan sheet(int side, const std::string& picture) {
  RawScan scan;
  const int columns = side + 2, middle = side / 2;
  const int count = (side + 1) * columns;
  scan.surface.vertices.resize(count, 3);
  scan.colours.resize(count, 3);
  scan.texture_coordinates.resize(count, 2);
  for (int i = 0; i <= side; ++i) {
    for (int j = 0; j < columns; ++j) {
      const double x = double(j <= middle ? j : j - 1) / side, y = double(i) / side;
      const int row = i * columns + j;
      scan.surface.vertices.row(row) << 200 * x, 250 * y, 60 * std::sin(3 * x) * std::sin(3 * y);
      scan.colours.row(row) << x, y, 0.5;
      scan.texture_coordinates.row(row) << (j <= middle ? 0.5 * x : 0.5 + 0.5 * x), y;
    }
  }
  std::vector<int> corners;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j <= side; ++j) {
      if (j == middle) continue;  // between a vertex and its copy
      const int a = i * columns + j, b = a + 1, c = b + columns, d = a + columns;
      corners.insert(corners.end(), {a, b, c, a, c, d});
    }
  }
  const auto triangles = static_cast<Eigen::Index>(corners.size() / 3);
  scan.surface.triangles = Eigen::Map<const Triangles>(corners.data(), triangles, 3);
  scan.corner_texture = scan.surface.triangles;
  scan.material.assign(std::size_t(triangles), 0);
  for (std::size_t f = scan.material.size() / 2; f < scan.material.size(); ++f)
    scan.material[f] = 1;
  scan.materials = {{"upper", Eigen::Vector3d::Ones(), 0}, {"lower", {0.5, 0.25, 0.125}, -1}};
  scan.textures = {{picture, false, ""}};
  return scan;
}

fs::path picture_in(const TemporaryFolder& folder, int side) {
  cv::Mat picture(side, side, CV_8UC3);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      picture.at<cv::Vec3b>(y, x) = {std::uint8_t(x * 255 / side), std::uint8_t(y * 255 / side),
                                     std::uint8_t(128 + 40 * std::sin(0.1 * x))};
    }
  }
  cv::imwrite((folder / "skin.jpg").string(), picture);
  return folder / "skin.jpg";
}

std::string yes(bool kept) {
  return kept ? "yes" : "–";
}

std::string kept_row(double error) {
  return error == 0 ? "exact" : error < 1e-4 ? "single precision" : "–";
}

void report_matrix(const Report& report) {
  Table table({"format", "coordinates", "order of vertices", "seams", "vertex colours", "materials",
               "pictures"});
  const TemporaryFolder folder;
  const fs::path picture = picture_in(folder, 64);
  const ObjDocument before = ObjDocument::of_scan(folder / "in.obj", sheet(10, "skin.jpg"));
  const TexturedMesh& a = before.mesh();
  for (const char* format : {"obj", "glb", "ply"}) {
    const std::string name = std::string("out.") + format;
    const TemporaryFolder out;
    write_scan(before, a.surface.vertices, out.path(), name);
    Progress progress;
    const ObjDocument after = read_scan(out / name, progress);
    const TexturedMesh& b = after.mesh();
    double error = 0, seams = 0;
    for (Eigen::Index i = 0; i < a.surface.triangles.size(); ++i) {
      const int v = a.surface.triangles.data()[i], w = b.surface.triangles.data()[i];
      const int t = a.corner_texture.data()[i], u = b.corner_texture.data()[i];
      error = std::max(error, (a.surface.vertices.row(v) - b.surface.vertices.row(w)).norm());
      seams = std::max(
          seams, u < 0 ? 1 : (a.texture_coordinates.row(t) - b.texture_coordinates.row(u)).norm());
    }
    double colours = 1;
    if (after.vertex_colours().rows() > 0) {
      colours = 0;
      for (Eigen::Index i = 0; i < a.surface.triangles.size(); ++i) {
        colours = std::max(colours, (before.vertex_colours().row(a.surface.triangles.data()[i]) -
                                     after.vertex_colours().row(b.surface.triangles.data()[i]))
                                        .cwiseAbs()
                                        .maxCoeff());
      }
    }
    table.add({format, kept_row(error),
               yes(a.surface.vertices.rows() == b.surface.vertices.rows() && error < 1e-4),
               kept_row(seams), colours <= 0.5 / 255 + 1e-9 ? "yes, to 8 bits or better" : "–",
               yes(a.materials.size() == b.materials.size()),
               yes(!b.materials.empty() &&
                   test::bytes_of(b.materials[0].texture) == test::bytes_of(picture))});
  }
  report.say("What is the same after writing and reading it back, corner by corner:");
  report.table("scan-formats", table);
}

void report_cost(const Report& report) {
  constexpr int kSide = 500, kPixels = 8192;
  const TemporaryFolder folder;
  const fs::path picture = picture_in(folder, kPixels);
  const double decode = seconds([&] { cv::imread(picture.string(), cv::IMREAD_COLOR); });
  const ObjDocument scan = ObjDocument::of_scan(folder / "in.obj", sheet(kSide, "skin.jpg"));
  Table table({"format", "file, MB", "read, s", "memory here, MB", "look at it, s", "write, s"});
  for (const char* format : {"obj", "glb", "ply"}) {
    const std::vector<double> costs = in_child([&] {
      const std::string name = std::string("out.") + format;
      const TemporaryFolder out;
      const double write =
          seconds([&] { write_scan(scan, scan.mesh().surface.vertices, out.path(), name); });
      StageMeter meter;
      std::optional<ObjDocument> read;
      meter.measure("read", [&] {
        Progress progress;
        read = read_scan(out / name, progress);
      });
      const double look = seconds([&] {
        Progress progress;
        scan_problems(read->mesh().surface, progress);
      });
      const StageCost& cost = meter.cost("read");
      return std::vector<double>{double(fs::file_size(out / name)) / 1e6, cost.seconds,
                                 cost.growth / 1e6, look, write};
    });
    table.add({format, costs[0], costs[1], costs[2], costs[3], costs[4]});
  }
  report.say(std::to_string(scan.mesh().surface.triangles.rows()) +
             " triangles, two materials, vertex colours, a JPEG of 8192 x 8192 pixels, which is "
             "decoded in " +
             number(decode) + " s when it is shown:");
  report.table("scan-cost", table);
}

}  // namespace

void report_scans(const Report& report) {
  report.heading("Face scans");
  report_matrix(report);
  report_cost(report);
}

}  // namespace gnathion::bench
