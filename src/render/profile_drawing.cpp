#include "render/profile_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "render/pixel_ratio.h"
#include "render/wrapped_words.h"

namespace gnathion {
namespace {

using Place = Eigen::Vector2d;  ///< right and up on the paper, mm
using Line = std::vector<Place>;

// Blue and orange stay apart for the common colour-vision deficiencies (Okabe and Ito 2008, "Color
// universal design").
const Eigen::Vector3d before_colour{0.0, 0.32, 0.62};
const Eigen::Vector3d after_colour{0.83, 0.33, 0.0};
const Eigen::Vector3d ink{0.13, 0.17, 0.22};
constexpr double dash_pixels = 9;
constexpr double gap_pixels = 6;

/// The patient's right side: anterior lies to the right.
Place on_paper(const Eigen::Vector3d& lps) {
  return {-lps.y(), lps.z()};
}

Line line_on_paper(const Points& chain) {
  Line line;
  for (Eigen::Index i = 0; i < chain.rows(); ++i) line.push_back(on_paper(chain.row(i)));
  return line;
}

/// The dashes of a line, `dash` long and `gap` apart along it.
std::vector<Line> dashed(const Line& line, double dash, double gap) {
  std::vector<Line> dashes;
  bool drawn = true;
  double left = dash;  // until the pen is lifted or put down
  if (!line.empty()) dashes.push_back({line.front()});
  for (std::size_t i = 1; i < line.size(); ++i) {
    Place at = line[i - 1];
    double length = (line[i] - at).norm();
    while (length > left) {
      at += (line[i] - at) * (left / length);
      length -= left;
      if (drawn) {
        dashes.back().push_back(at);
      } else {
        dashes.push_back({at});
      }
      drawn = !drawn;
      left = drawn ? dash : gap;
    }
    left -= length;
    if (drawn) dashes.back().push_back(line[i]);
  }
  return dashes;
}

vtkSmartPointer<vtkPolyData> poly_lines(const std::vector<Line>& lines) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Line& line : lines) {
    if (line.size() < 2) continue;
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Place& p : line) cells->InsertCellPoint(points->InsertNextPoint(p.x(), p.y(), 0));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

/// Lines on the paper.
struct Pen {
  float width;  // logical pixels
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;

  Pen(const Eigen::Vector3d& colour, float line_width) : width(line_width) {
    mapper->SetInputData(poly_lines({}));
    actor->SetMapper(mapper);
    actor->PickableOff();
    vtkProperty* look = actor->GetProperty();
    look->SetColor(colour.x(), colour.y(), colour.z());
    look->LightingOff();
  }
  /// ratio: of render/pixel_ratio.h.
  void draw(const std::vector<Line>& lines, double ratio) {
    actor->GetProperty()->SetLineWidth(static_cast<float>(ratio) * width);
    mapper->SetInputData(poly_lines(lines));
  }
};

/// Lines in the picture's logical pixels.
struct FixedPen {
  float width;  // likewise
  vtkNew<vtkPolyDataMapper2D> mapper;
  vtkNew<vtkActor2D> actor;

  FixedPen(const Eigen::Vector3d& colour, float line_width) : width(line_width) {
    mapper->SetInputData(poly_lines({}));
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour.x(), colour.y(), colour.z());
  }
  void draw(std::vector<Line> lines, double ratio) {
    for (Line& line : lines) {
      for (Place& place : line) place *= ratio;
    }
    actor->GetProperty()->SetLineWidth(static_cast<float>(ratio) * width);
    mapper->SetInputData(poly_lines(lines));
  }
};

vtkSmartPointer<vtkTextActor> text_of(const std::string& words, bool on_paper) {
  auto text = vtkSmartPointer<vtkTextActor>::New();
  if (on_paper) {
    text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  } else {
    text->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  }
  text->GetTextProperty()->SetColor(ink.x(), ink.y(), ink.z());
  text->GetTextProperty()->SetVerticalJustificationToCentered();
  text->SetInput(words.c_str());
  text->PickableOff();
  return text;
}

Line circle(const Place& centre, double radius) {
  Line line;
  for (int i = 0; i <= 20; ++i) {
    const double turn = i * 3.14159265358979323846 / 10;
    line.push_back(centre + radius * Place(std::cos(turn), std::sin(turn)));
  }
  return line;
}

std::vector<Line> grid_lines(const Place& low, const Place& high, double step) {
  std::vector<Line> lines;
  for (const int axis : {0, 1}) {
    for (double k = std::ceil(low[axis] / step); k * step <= high[axis]; ++k) {
      Place a = low, b = high;
      a[axis] = b[axis] = k * step;
      lines.push_back({a, b});
    }
  }
  return lines;
}

}  // namespace

struct ProfileDrawing::Impl {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkCallbackCommand> before_render;
  double ratio = 1;  ///< pixels a logical one
  Pen fine_grid{{0.90, 0.92, 0.94}, 1}, grid{{0.78, 0.82, 0.86}, 1};
  Pen before{before_colour, 2.5F}, after{after_colour, 2.5F};
  Pen marks_before{before_colour, 1.5F}, marks_after{after_colour, 2};
  FixedPen key_before{before_colour, 2.5F}, key_after{after_colour, 2.5F}, ruler{ink, 2};
  vtkSmartPointer<vtkTextActor> caption = text_of("", false);
  vtkSmartPointer<vtkTextActor> before_word = text_of("", false);
  vtkSmartPointer<vtkTextActor> after_word = text_of("", false);
  vtkSmartPointer<vtkTextActor> scale_word = text_of("", false);
  vtkSmartPointer<vtkTextActor> landmarks_word = text_of("", false);
  std::array<vtkSmartPointer<vtkTextActor>, 4> sides{text_of("P", false), text_of("A", false),
                                                     text_of("H", false), text_of("F", false)};
  std::vector<vtkSmartPointer<vtkTextActor>> names;  ///< of the landmarks
  Profile profile;
  ProfileWords words;
  std::vector<Line> before_lines, after_lines;

  Impl() {
    renderer->SetBackground(0.985, 0.985, 0.975);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetPosition(0, 0, 100);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetClippingRange(1, 200);
    int layer = 0;
    for (Pen* pen : {&fine_grid, &grid, &before, &after, &marks_before, &marks_after}) {
      pen->actor->SetPosition(0, 0, layer++);  // the later over the earlier
      renderer->AddActor(pen->actor);
    }
    for (FixedPen* pen : {&key_before, &key_after, &ruler}) renderer->AddViewProp(pen->actor);
    for (vtkTextActor* text : fixed_texts()) renderer->AddViewProp(text);
    caption->GetTextProperty()->SetVerticalJustificationToTop();
    before_render->SetClientData(this);
    before_render->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      static_cast<Impl*>(self)->prepare_frame();
    });
    renderer->AddObserver(vtkCommand::StartEvent, before_render);
  }

  ~Impl() { renderer->RemoveObserver(before_render); }

  std::vector<vtkTextActor*> fixed_texts() {
    std::vector<vtkTextActor*> all{caption, before_word, after_word, scale_word, landmarks_word};
    for (const auto& side : sides) all.push_back(side);
    return all;
  }

  /// What depends on how large the paper is seen: the grid's step, the dashes, the dots.
  void prepare_frame() {
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetClippingRange(1, 200);
    // Logical pixels, as fonts have them.
    ratio = pixel_ratio(renderer);
    const int width = std::max(static_cast<int>(renderer->GetSize()[0] / ratio), 1);
    const int height = std::max(static_cast<int>(renderer->GetSize()[1] / ratio), 1);
    const double pixel = 2 * camera->GetParallelScale() / height;  // mm
    const Place centre(camera->GetFocalPoint());
    const Place half(pixel * width / 2, pixel * height / 2);
    double step = 1;
    while (step < 9 * pixel)
      step = std::abs(std::log10(step) - std::round(std::log10(step))) < 0.1 ? 5 * step : 2 * step;
    const double major = step < 5 ? 10 * step : 2 * step;
    fine_grid.draw(grid_lines(centre - half, centre + half, step), ratio);
    grid.draw(grid_lines(centre - half, centre + half, major), ratio);
    draw_faces(pixel);
    draw_key(width, height, pixel, step, major);
  }

  void draw_faces(double pixel) {
    std::vector<Line> dashes;
    for (const Line& line : before_lines) {
      for (Line& dash : dashed(line, dash_pixels * pixel, gap_pixels * pixel)) {
        dashes.push_back(std::move(dash));
      }
    }
    before.draw(dashes, ratio);
    after.draw(after_lines, ratio);
    std::vector<Line> rings, dots;
    for (std::size_t i = 0; i < profile.landmarks.size(); ++i) {
      const ProfileLandmark& landmark = profile.landmarks[i];
      const Place from = on_paper(landmark.before), to = on_paper(landmark.after);
      rings.push_back(circle(from, 4.5 * pixel));
      for (const double radius : {1.0, 2.0, 3.0, 4.0}) dots.push_back(circle(to, radius * pixel));
    }
    place_names(pixel);
    marks_before.draw(rings, ratio);
    marks_after.draw(dots, ratio);
  }

  /// Beside the landmarks, the upper one above, none over another.
  void place_names(double pixel) {
    std::vector<std::size_t> order(names.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return profile.landmarks[a].after.z() > profile.landmarks[b].after.z();
    });
    double below = 1e9;
    for (const std::size_t i : order) {
      const Place from = on_paper(profile.landmarks[i].before);
      const Place to = on_paper(profile.landmarks[i].after);
      const double up = std::min(to.y(), below);
      names[i]->SetPosition(std::max(from.x(), to.x()) + 12 * pixel, up);
      below = up - 1.15 * names[i]->GetTextProperty()->GetFontSize() * pixel;
    }
  }

  void draw_key(int width, int height, double pixel, double step, double major) {
    const int size = std::clamp(height / 34, 12, 20);
    place_caption(width, height, size);
    const double line = 1.7 * size, left = 0.03 * width, low = 0.05 * height + 2 * line;
    draw_samples({left, low}, line);
    draw_ruler({left, low - 1.2 * line}, pixel, step, major);
  }

  /// The words above, at the paper's edges and beside the landmarks, the key's in `size`.
  void place_caption(int width, int height, int size) {
    for (vtkTextActor* text : fixed_texts()) text->GetTextProperty()->SetFontSize(size);
    const int caption_size = std::clamp(std::min(height / 26, width / 30), 12, 24);
    caption->GetTextProperty()->SetFontSize(caption_size);
    // Left of where the nose is.
    caption->SetInput(
        wrapped(words.caption, std::max(static_cast<int>(0.6 * width / (0.52 * caption_size)), 12))
            .c_str());
    caption->SetPosition(ratio * 0.03 * width, ratio * 0.97 * height);
    for (const auto& name : names) name->GetTextProperty()->SetFontSize(std::max(size - 2, 11));
    sides[0]->SetPosition(ratio * 0.012 * width, ratio * 0.5 * height);
    sides[1]->SetPosition(ratio * 0.975 * width, ratio * 0.5 * height);
    sides[2]->SetPosition(ratio * 0.5 * width, ratio * 0.975 * height);
    sides[3]->SetPosition(ratio * 0.5 * width, ratio * 0.025 * height);
  }

  /// How the faces and the landmarks are drawn, in rows `line` pixels high.
  void draw_samples(const Place& at, double line) {
    constexpr double sample = 42, word = sample + 8;
    const double left = at.x(), low = at.y();
    std::vector<Line> before_keys =
        dashed({{left, low + line}, {left + sample, low + line}}, dash_pixels, gap_pixels);
    std::vector<Line> after_keys{{{left, low}, {left + sample, low}}};
    before_word->SetPosition(ratio * (left + word), ratio * (low + line));
    after_word->SetPosition(ratio * (left + word), ratio * low);
    if (!profile.landmarks.empty()) {
      const double row = low + 2 * line;
      before_keys.push_back(circle({left + 0.25 * sample, row}, 4.5));
      for (const double radius : {1.0, 2.0, 3.0, 4.0}) {
        after_keys.push_back(circle({left + 0.75 * sample, row}, radius));
      }
      landmarks_word->SetPosition(ratio * (left + word), ratio * row);
    }
    landmarks_word->SetVisibility(!profile.landmarks.empty());
    key_before.draw(before_keys, ratio);
    key_after.draw(after_keys, ratio);
  }

  void draw_ruler(const Place& at, double pixel, double step, double major) {
    const double left = at.x(), right = left + major / pixel, y = at.y();
    ruler.draw(
        {{{left, y}, {right, y}}, {{left, y - 5}, {left, y + 5}}, {{right, y - 5}, {right, y + 5}}},
        ratio);
    const auto mm = [](double value) {
      return std::to_string(static_cast<int>(std::lround(value))) + " mm";
    };
    scale_word->SetInput((mm(major) + "   (" + words.grid + " " + mm(step) + ")").c_str());
    scale_word->SetPosition(ratio * (right + 8), ratio * y);
  }
};

ProfileDrawing::ProfileDrawing() : impl_(std::make_unique<Impl>()) {
  set_words({});
}

ProfileDrawing::~ProfileDrawing() = default;

vtkRenderer* ProfileDrawing::renderer() const {
  return impl_->renderer;
}

void ProfileDrawing::show(const Profile& profile) {
  impl_->profile = profile;
  impl_->before_lines.clear();
  impl_->after_lines.clear();
  for (const Points& chain : profile.before) impl_->before_lines.push_back(line_on_paper(chain));
  for (const Points& chain : profile.after) impl_->after_lines.push_back(line_on_paper(chain));
  for (const auto& name : impl_->names) impl_->renderer->RemoveViewProp(name);
  impl_->names.clear();
  for (const ProfileLandmark& landmark : profile.landmarks) {
    impl_->names.push_back(text_of(landmark.name, true));
    impl_->renderer->AddViewProp(impl_->names.back());
  }
}

void ProfileDrawing::set_words(const ProfileWords& words) {
  impl_->words = words;
  impl_->before_word->SetInput(words.before.c_str());
  impl_->after_word->SetInput(words.after.c_str());
  impl_->landmarks_word->SetInput(words.landmarks.c_str());
}

void ProfileDrawing::frame(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                           double aspect_ratio) {
  const Place middle = on_paper((low + high) / 2);
  constexpr double filled = 0.8;
  const double half_height = (high.z() - low.z()) / 2;
  const double half_width = (high.y() - low.y()) / 2;
  vtkCamera* camera = impl_->renderer->GetActiveCamera();
  camera->SetFocalPoint(middle.x(), middle.y(), 0);
  camera->SetPosition(middle.x(), middle.y(), 100);
  camera->SetParallelScale(std::max({half_height, half_width / aspect_ratio, 1.0}) / filled);
}

void ProfileDrawing::pan(double right, double up) {
  vtkCamera* camera = impl_->renderer->GetActiveCamera();
  const double height = 2 * camera->GetParallelScale();
  const Place centre = Place(camera->GetFocalPoint()) - height * Place(right, up);
  camera->SetFocalPoint(centre.x(), centre.y(), 0);
  camera->SetPosition(centre.x(), centre.y(), 100);
}

}  // namespace gnathion
