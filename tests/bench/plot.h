#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gnathion::bench {

enum class Marker { circle, square, triangle, diamond, cross, star };

struct Axis {
  std::string label;  ///< with its unit
  bool logarithmic = false;
  std::optional<double> low = {}, high = {};  ///< what is shown; from the data where not given
};

/// One set of points. In a figure, series of one name share a place in its legend.
struct Series {
  enum class Kind {
    points,
    line,    ///< through the points, with their markers
    curve,   ///< through the points, without markers
    stairs,  ///< horizontal first, then vertical: a Pareto front
    bins,    ///< a histogram: y[i] from x[i] to x[i+1], so x has one more
  };
  std::string name;  ///< without one it is not in the legend
  Kind kind = Kind::points;
  std::vector<double> x = {}, y = {};
  std::vector<std::string> labels = {};  ///< beside the points: none, or one each
  int colour = 0;                        ///< of the palette (Okabe and Ito 2008), from 0 on
  Marker marker = Marker::circle;
  bool dashed = false;
};

/// How the values spread: a bins series in per cent of all, between low and high. Values outside
/// count as parts of the whole but are in no bin.
Series histogram(const std::string& name, const std::vector<double>& values, double low,
                 double high, int bins, int colour);

/// Where a bins series is highest: the middle of that bin.
double peak(const Series& bins);

/// Of points to be small in x and in y: those that no other beats in both, as a stairs series in
/// order of x.
Series pareto_front(const std::string& name, const std::vector<double>& x,
                    const std::vector<double>& y);

/// The slope of the straight line through log y over log x by least squares: the exponent p of
/// y ~ x^p. NaN for fewer than two points above 0.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

struct Plot {
  std::string title;
  Axis x, y;
  std::vector<Series> series = {};
};

/// A figure as a scalable vector graphic: its plots side by side, `columns` in a row, under one
/// legend. Points that an axis cannot show (not finite, or not above 0 on a logarithmic one) are
/// left out. Throws std::logic_error when a plot has nothing to show.
std::string svg(const std::string& title, const std::vector<Plot>& plots, int columns);

}  // namespace gnathion::bench
