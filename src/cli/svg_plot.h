#pragma once

#include <string>
#include <vector>

/// \file
/// Plots for a page: SVG with a legend above.

namespace contact_shapelets::cli {

/// Returns `text` with the special characters of HTML and SVG escaped.
std::string Escaped(const std::string& text);

/// A point in the units of a plot's axes.
struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
};

/// The extent and the title of an axis.
struct PlotAxis {
  std::string title;
  double least = 0.0;
  double greatest = 1.0;
};

/// Axes with ticks, and drawings between them. Later drawings cover earlier ones. The axes clip all drawings.
class SvgPlot {
 public:
  /// Makes axes of `width` by `height` pixels, with titles and ticks. Widens an extent of zero.
  SvgPlot(const PlotAxis& x, const PlotAxis& y, int width, int height);

  /// Adds a line through `points`, `thickness` pixels wide. A `label` adds it to the legend.
  void AddLine(const std::vector<PlotPoint>& points, const std::string& colour, double thickness,
               const std::string& label = "");
  /// Adds a translucent band between two lines of the same x.
  void AddBand(const std::vector<PlotPoint>& upper, const std::vector<PlotPoint>& lower, const std::string& colour,
               const std::string& label = "");
  /// Adds a dot. Its `title` shows when the pointer rests on it.
  void AddDot(const PlotPoint& point, const std::string& colour, const std::string& title);
  /// Adds an entry to the legend.
  void AddLegend(const std::string& colour, const std::string& label);

  /// Returns the whole plot as a figure element of HTML.
  std::string Text() const;

 private:
  PlotPoint ToPixels(const PlotPoint& point) const;
  std::string PathOf(const std::vector<PlotPoint>& points) const;
  std::string Grid() const;
  std::string Legend() const;

  PlotAxis x_;
  PlotAxis y_;
  int width_;
  int height_;
  std::string drawings_;
  std::vector<std::pair<std::string, std::string>> legend_;  ///< colour and label
};

}  // namespace contact_shapelets::cli
