#include "bench/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace gnathion::bench {
namespace {

// Pixels.
constexpr double kPlotWidth = 520, kPlotHeight = 380;
constexpr double kLeft = 74, kRight = 20, kTop = 34, kBottom = 56;
constexpr double kFont = 13, kLegendRow = 22;

constexpr std::array<const char*, 8> kPalette{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                              "#E69F00", "#56B4E9", "#4D4D4D", "#8A6D00"};

const char* colour_of(const Series& series) {
  return kPalette[static_cast<std::size_t>(series.colour) % kPalette.size()];
}

/// About how wide a text is: half its size a letter and a bit.
double width_of(const std::string& text, double size) {
  const auto letters =
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return 0.56 * size * static_cast<double>(letters);
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else {
      safe += c;
    }
  }
  return safe;
}

/// Draws into one SVG text.
class Canvas {
 public:
  Canvas(double width, double height) {
    out_.precision(6);
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\""
         << height << "\" viewBox=\"0 0 " << width << ' ' << height
         << "\" font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\">\n"
         << "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  }
  void line(double x1, double y1, double x2, double y2, const char* colour, double width) {
    out_ << "<line x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2 << "\" y2=\"" << y2
         << "\" stroke=\"" << colour << "\" stroke-width=\"" << width << "\"/>\n";
  }
  void path(const std::string& d, const std::string& style) {
    out_ << "<path d=\"" << d << "\" " << style << "/>\n";
  }
  /// anchor: start, middle or end; turn: degrees about the place.
  void text(double x, double y, const std::string& words, const char* anchor, double size,
            const char* extra = "", double turn = 0) {
    out_ << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor
         << "\" font-size=\"" << size << "\" fill=\"#222222\" " << extra;
    if (turn != 0) out_ << " transform=\"rotate(" << turn << ' ' << x << ' ' << y << ")\"";
    out_ << '>' << escaped(words) << "</text>\n";
  }
  void marker(Marker shape, double x, double y, const char* colour);
  void begin_clip(const std::string& name, double x, double y, double width, double height) {
    out_ << "<clipPath id=\"" << name << "\"><rect x=\"" << x << "\" y=\"" << y << "\" width=\""
         << width << "\" height=\"" << height << "\"/></clipPath>\n<g clip-path=\"url(#" << name
         << ")\">\n";
  }
  void end_clip() { out_ << "</g>\n"; }
  std::string finish() {
    out_ << "</svg>\n";
    return out_.str();
  }

 private:
  std::ostringstream out_;
};

void Canvas::marker(Marker shape, double x, double y, const char* colour) {
  const double r = 5;
  if (shape == Marker::circle) {
    out_ << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"" << r << "\" fill=\"" << colour
         << "\" stroke=\"#ffffff\"/>\n";
    return;
  }
  std::vector<std::array<double, 2>> corners;
  switch (shape) {
    case Marker::square:
      corners = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
      break;
    case Marker::triangle:
      corners = {{0, -1.2}, {1.15, 0.9}, {-1.15, 0.9}};
      break;
    case Marker::diamond:
      corners = {{0, -1.35}, {1.2, 0}, {0, 1.35}, {-1.2, 0}};
      break;
    case Marker::cross:
      corners = {{-.4, -1.2}, {.4, -1.2}, {.4, -.4}, {1.2, -.4}, {1.2, .4},   {.4, .4},
                 {.4, 1.2},   {-.4, 1.2}, {-.4, .4}, {-1.2, .4}, {-1.2, -.4}, {-.4, -.4}};
      break;
    default:
      for (int k = 0; k < 10; ++k) {
        const double angle = k * std::acos(-1.0) / 5, size = k % 2 == 0 ? 1.9 : 0.8;
        corners.push_back({size * std::sin(angle), -size * std::cos(angle)});
      }
  }
  out_ << "<polygon points=\"";
  for (const auto& [dx, dy] : corners) out_ << x + r * dx << ',' << y + r * dy << ' ';
  out_ << "\" fill=\"" << colour << "\" stroke=\"#ffffff\"/>\n";
}

/// An axis with its limits and its length in pixels.
struct Scale {
  bool logarithmic = false;
  double low = 0, high = 1;  ///< logarithms to base 10 where logarithmic
  double begin = 0, end = 1;

  bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
  double at(double value) const {
    const double v = logarithmic ? std::log10(value) : value;
    return begin + (v - low) / (high - low) * (end - begin);
  }
};

Scale scale_of(const Axis& axis, const std::vector<double>& values, double begin, double end,
               bool from_zero) {
  Scale scale{axis.logarithmic, std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity(), begin, end};
  const auto place = [&](double v) { return axis.logarithmic ? std::log10(v) : v; };
  for (const double value : values) {
    if (!scale.shows(value)) continue;
    scale.low = std::min(scale.low, place(value));
    scale.high = std::max(scale.high, place(value));
  }
  if (scale.low > scale.high) throw std::logic_error("a plot of nothing: " + axis.label);
  const double margin = scale.high > scale.low ? 0.06 * (scale.high - scale.low) : 0.5;
  scale.high += margin;
  scale.low = from_zero ? std::min(0.0, scale.low) : scale.low - margin;
  if (axis.low) scale.low = place(*axis.low);
  if (axis.high) scale.high = place(*axis.high);
  return scale;
}

struct Tick {
  double value;
  std::string label;  ///< empty: a fine line only
};

std::string raised(int power) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = power < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(power))) {
    text += digits[static_cast<std::size_t>(c - '0')];
  }
  return text;
}

/// A digit times a power of ten.
std::string decade_label(int digit, int power) {
  if (power < -3 || power > 3) {
    return (digit == 1 ? "" : std::to_string(digit) + "·") + raised(power);
  }
  char text[32];
  std::snprintf(text, sizeof text, "%g", digit * std::pow(10, power));
  return text;
}

std::string tick_label(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value == 0 ? 0.0 : value);  // not -0
  return text;
}

std::vector<Tick> ticks_of(const Scale& scale) {
  std::vector<Tick> ticks;
  const double span = scale.high - scale.low;
  if (scale.logarithmic) {
    for (int p = static_cast<int>(std::floor(scale.low)); p <= scale.high; ++p) {
      for (int m = 1; m < 10; ++m) {
        const double v = m * std::pow(10, p);
        if (std::log10(v) < scale.low - 1e-9 || std::log10(v) > scale.high + 1e-9) continue;
        const bool is_named = m == 1 || (span < 2.2 && (m == 2 || m == 5));
        ticks.push_back({v, is_named ? decade_label(m, p) : ""});
      }
    }
    return ticks;
  }
  double step = std::pow(10, std::floor(std::log10(span / 5)));
  for (const double factor : {2.0, 2.5, 2.0}) {
    if (span / step > 8) step *= factor;
  }
  for (double k = std::ceil(scale.low / step - 1e-9); k * step <= scale.high + 1e-9 * span; ++k) {
    ticks.push_back({k * step, tick_label(k * step)});
  }
  return ticks;
}

struct Box {
  double left, top, right, bottom;
  double overlap(const Box& other) const {
    return std::max(0.0, std::min(right, other.right) - std::max(left, other.left)) *
           std::max(0.0, std::min(bottom, other.bottom) - std::max(top, other.top));
  }
};

/// One plot with its upper left corner at a place of the canvas.
class Drawing {
 public:
  Drawing(Canvas& canvas, const Plot& plot, double x, double y, int index)
      : canvas_(canvas),
        plot_(plot),
        name_("plot" + std::to_string(index)),
        area_{x + kLeft, y + kTop, x + kPlotWidth - kRight, y + kPlotHeight - kBottom} {
    std::vector<double> xs, ys;
    bool from_zero = false;
    for (const Series& s : plot.series) {
      xs.insert(xs.end(), s.x.begin(), s.x.end());
      ys.insert(ys.end(), s.y.begin(), s.y.end());
      from_zero = from_zero || s.kind == Series::Kind::bins;
    }
    x_ = scale_of(plot.x, xs, area_.left, area_.right, false);
    y_ = scale_of(plot.y, ys, area_.bottom, area_.top, from_zero);
  }

  void draw() {
    draw_axes();
    canvas_.begin_clip(name_, area_.left, area_.top, area_.right - area_.left,
                       area_.bottom - area_.top);
    for (const Series& s : plot_.series) draw_path(s);
    for (const Series& s : plot_.series) draw_markers(s);
    canvas_.end_clip();
    for (const Series& s : plot_.series) draw_labels(s);
  }

 private:
  void draw_axes();
  void draw_path(const Series& s);
  void draw_markers(const Series& s);
  void draw_labels(const Series& s);
  bool shows(const Series& s, std::size_t i) const { return x_.shows(s.x[i]) && y_.shows(s.y[i]); }

  Canvas& canvas_;
  const Plot& plot_;
  std::string name_;
  Box area_;
  Scale x_, y_;
  std::vector<Box> taken_;  ///< by markers and labels
};

/// The words before the last commas, as many as a panel is wide.
std::string fitting(std::string title) {
  constexpr std::size_t kMostLetters = 56;
  while (title.size() > kMostLetters && title.find(", ") != std::string::npos) {
    title.erase(title.rfind(", "));
  }
  return title;
}

void Drawing::draw_axes() {
  for (const Tick& tick : ticks_of(x_)) {
    const double x = x_.at(tick.value);
    canvas_.line(x, area_.top, x, area_.bottom, tick.label.empty() ? "#f1f1f1" : "#dcdcdc", 1);
    canvas_.text(x, area_.bottom + 18, tick.label, "middle", kFont - 1);
  }
  for (const Tick& tick : ticks_of(y_)) {
    const double y = y_.at(tick.value);
    canvas_.line(area_.left, y, area_.right, y, tick.label.empty() ? "#f1f1f1" : "#dcdcdc", 1);
    canvas_.text(area_.left - 7, y + 4, tick.label, "end", kFont - 1);
  }
  canvas_.line(area_.left, area_.bottom, area_.right, area_.bottom, "#555555", 1.2);
  canvas_.line(area_.left, area_.top, area_.left, area_.bottom, "#555555", 1.2);
  const double middle = (area_.left + area_.right) / 2;
  canvas_.text(middle, area_.top - 10, fitting(plot_.title), "middle", kFont + 1,
               "font-weight=\"bold\"");
  canvas_.text(middle, area_.bottom + 42, plot_.x.label, "middle", kFont);
  canvas_.text(area_.left - 56, (area_.top + area_.bottom) / 2, plot_.y.label, "middle", kFont, "",
               -90);
}

void Drawing::draw_path(const Series& s) {
  if (s.kind == Series::Kind::points) return;
  std::ostringstream d;
  double before = 0;
  bool is_first = true;
  for (std::size_t i = 0; i < s.y.size(); ++i) {
    if (!shows(s, i)) continue;
    const double x = x_.at(s.x[i]), y = y_.at(s.y[i]);
    if (s.kind == Series::Kind::bins) {
      if (is_first) d << 'M' << x << ' ' << y_.begin;
      d << 'V' << y << 'H' << x_.at(s.x[i + 1]);
    } else if (s.kind == Series::Kind::stairs && !is_first) {
      d << 'L' << x << ' ' << before << 'L' << x << ' ' << y;
    } else {
      d << (is_first ? 'M' : 'L') << x << ' ' << y;
    }
    before = y;
    is_first = false;
  }
  if (s.kind == Series::Kind::bins) d << 'V' << y_.begin;
  const std::string colour = colour_of(s);
  const std::string fill = s.kind == Series::Kind::bins ? colour + "\" fill-opacity=\"0.1" : "none";
  canvas_.path(d.str(), "fill=\"" + fill + "\" stroke=\"" + colour +
                            "\" stroke-width=\"2\" stroke-linejoin=\"round\"" +
                            (s.dashed ? " stroke-dasharray=\"6 5\"" : ""));
}

void Drawing::draw_markers(const Series& s) {
  if (s.kind != Series::Kind::points && s.kind != Series::Kind::line) return;
  for (std::size_t i = 0; i < s.y.size(); ++i) {
    if (!shows(s, i)) continue;
    const double x = x_.at(s.x[i]), y = y_.at(s.y[i]);
    canvas_.marker(s.marker, x, y, colour_of(s));
    taken_.push_back({x - 5, y - 5, x + 5, y + 5});
  }
}

/// Each label where it covers least of what is there: right of its point, else left, above, below.
void Drawing::draw_labels(const Series& s) {
  const double size = kFont - 2;
  for (std::size_t i = 0; i < s.labels.size(); ++i) {
    if (s.labels[i].empty() || !shows(s, i)) continue;
    const double x = x_.at(s.x[i]), y = y_.at(s.y[i]), w = width_of(s.labels[i], size);
    Box best{};
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [dx, dy] : std::array<std::array<double, 2>, 8>{{{9, -size / 2},
                                                                      {-9 - w, -size / 2},
                                                                      {-w / 2, -9 - size},
                                                                      {-w / 2, 9},
                                                                      {6, -7 - size},
                                                                      {6, 7},
                                                                      {-6 - w, -7 - size},
                                                                      {-6 - w, 7}}}) {
      const Box box{x + dx, y + dy, x + dx + w, y + dy + size};
      const double inside = box.overlap(area_);
      double cost = 4 * ((box.right - box.left) * (box.bottom - box.top) - inside);
      for (const Box& other : taken_) cost += box.overlap(other);
      if (cost < least - 1e-9) {
        least = cost;
        best = box;
      }
    }
    taken_.push_back(best);
    canvas_.text(best.left, best.bottom - 1, s.labels[i], "start", size,
                 "stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"");
  }
}

struct LegendEntry {
  const Series* series;
  double x, y;
};

/// The first series of each name, set in rows of a width.
std::vector<LegendEntry> legend_of(const std::vector<Plot>& plots, double width, double top) {
  std::vector<LegendEntry> entries;
  double x = kLeft, y = top;
  for (const Plot& plot : plots) {
    for (const Series& s : plot.series) {
      if (s.name.empty() || std::any_of(entries.begin(), entries.end(), [&](const LegendEntry& e) {
            return e.series->name == s.name;
          })) {
        continue;
      }
      const double w = 34 + width_of(s.name, kFont) + 22;
      if (x > kLeft && x + w > width) {
        x = kLeft;
        y += kLegendRow;
      }
      entries.push_back({&s, x, y});
      x += w;
    }
  }
  return entries;
}

void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries) {
  for (const auto& [series, x, y] : entries) {
    const Series& s = *series;
    if (s.kind != Series::Kind::points) {
      std::ostringstream d;
      d << 'M' << x << ' ' << y << 'H' << x + 28;
      canvas.path(d.str(), std::string("fill=\"none\" stroke=\"") + colour_of(s) +
                               "\" stroke-width=\"" + (s.kind == Series::Kind::bins ? "6" : "2") +
                               "\"" + (s.dashed ? " stroke-dasharray=\"6 5\"" : ""));
    }
    if (s.kind == Series::Kind::points || s.kind == Series::Kind::line) {
      canvas.marker(s.marker, x + 14, y, colour_of(s));
    }
    canvas.text(x + 34, y + 4.5, s.name, "start", kFont);
  }
}

}  // namespace

Series histogram(const std::string& name, const std::vector<double>& values, double low,
                 double high, int bins, int colour) {
  Series series{.name = name, .kind = Series::Kind::bins, .colour = colour};
  const double width = (high - low) / bins;
  for (int b = 0; b <= bins; ++b) series.x.push_back(low + b * width);
  series.y.assign(static_cast<std::size_t>(bins), 0);
  for (const double value : values) {
    if (!(value >= low && value < high)) continue;
    const auto bin = std::min(bins - 1, static_cast<int>((value - low) / width));
    series.y[static_cast<std::size_t>(bin)] += 100 / static_cast<double>(values.size());
  }
  return series;
}

double peak(const Series& bins) {
  const auto b = std::max_element(bins.y.begin(), bins.y.end()) - bins.y.begin();
  const auto i = static_cast<std::size_t>(b);
  return (bins.x[i] + bins.x[i + 1]) / 2;
}

Series pareto_front(const std::string& name, const std::vector<double>& x,
                    const std::vector<double>& y) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return x[a] < x[b] || (x[a] == x[b] && y[a] < y[b]);
  });
  Series front{.name = name, .kind = Series::Kind::stairs, .colour = 6};
  front.dashed = true;
  for (const std::size_t i : order) {
    if (!front.y.empty() && y[i] >= front.y.back()) continue;
    front.x.push_back(x[i]);
    front.y.push_back(y[i]);
  }
  return front;
}

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > 0 && y[i] > 0)) continue;
    const double a = std::log(x[i]), b = std::log(y[i]);
    n += 1;
    sx += a;
    sy += b;
    sxx += a * a;
    sxy += a * b;
  }
  if (n < 2) return std::numeric_limits<double>::quiet_NaN();
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::string svg(const std::string& title, const std::vector<Plot>& plots, int columns) {
  const int rows = (static_cast<int>(plots.size()) + columns - 1) / columns;
  const double width = kPlotWidth * columns;
  const auto legend = legend_of(plots, width, 58);
  const double head = legend.empty() ? 44 : legend.back().y + 24;
  Canvas canvas(width, head + rows * kPlotHeight + 6);
  canvas.text(width / 2, 30, title, "middle", kFont + 4, "font-weight=\"bold\"");
  draw_legend(canvas, legend);
  for (int i = 0; i < static_cast<int>(plots.size()); ++i) {
    Drawing(canvas, plots[static_cast<std::size_t>(i)], kPlotWidth * (i % columns),
            head + kPlotHeight * (i / columns), i)
        .draw();
  }
  return canvas.finish();
}

}  // namespace gnathion::bench
