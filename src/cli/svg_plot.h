#pragma once

#include <string>
#include <vector>

/// \file
/// Plots for a page: SVG with a list of what is drawn above it.

namespace contact_shapelets::cli {

/// `text` with the characters that mean something in HTML and SVG replaced.
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

/// Axes with ticks, and what is drawn between them. Later drawings lie above earlier ones; what leaves the
/// axes is cut.
class SvgPlot {
 public:
  /// Axes of `width` by `height` pixels, titles and ticks included. An extent of zero is widened.
  SvgPlot(const PlotAxis& x, const PlotAxis& y, int width, int height);

  /// A line through `points`, `thickness` pixels wide; with a `label`, it is listed above the plot.
  void AddLine(const std::vector<PlotPoint>& points, const std::string& colour, double thickness,
               const std::string& label = "");
  /// A translucent band between two lines of the same x.
  void AddBand(const std::vector<PlotPoint>& upper, const std::vector<PlotPoint>& lower, const std::string& colour,
               const std::string& label = "");
  /// A dot whose `title` shows where the pointer rests on it.
  void AddDot(const PlotPoint& point, const std::string& colour, const std::string& title);
  /// Adds an entry to the list above the plot.
  void AddLegend(const std::string& colour, const std::string& label);

  /// The whole plot as a figure element of HTML.
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
