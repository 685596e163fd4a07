#include "cli/svg_plot.h"

#include <algorithm>
#include <cmath>

#include "cli/text.h"

namespace contact_shapelets::cli {
namespace {

constexpr int kLeft = 58;
constexpr int kRight = 12;
constexpr int kTop = 8;
constexpr int kBottom = 42;

/// Returns the distance between about `count` ticks: 1, 2 or 5 times a power of ten.
double TickStep(double extent, int count) {
  const double raw = extent / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (raw <= factor * power) return factor * power;
  }
  return 10.0 * power;
}

std::vector<double> Ticks(const PlotAxis& axis, double step) {
  std::vector<double> ticks;
  for (double index = std::ceil(axis.least / step - 1e-9); index * step <= axis.greatest + 1e-9 * step; ++index) {
    ticks.push_back(index * step);
  }
  return ticks;
}

std::string TickText(double value, double step) {
  const double decimals = -std::floor(std::log10(step) + 1e-9);
  return Number(std::abs(value) < 1e-9 * step ? 0.0 : value, static_cast<int>(std::clamp(decimals, 0.0, 6.0)));
}

std::string Pixel(double value) { return Number(value, 1); }

std::string LineElement(PlotPoint from, PlotPoint to, const std::string& css) {
  return "<line class=\"" + css + "\" x1=\"" + Pixel(from.x) + "\" y1=\"" + Pixel(from.y) + "\" x2=\"" + Pixel(to.x) +
         "\" y2=\"" + Pixel(to.y) + "\"/>\n";
}

std::string TextElement(PlotPoint at, const std::string& anchor, const std::string& text,
                        const std::string& more = "") {
  return "<text x=\"" + Pixel(at.x) + "\" y=\"" + Pixel(at.y) + "\" text-anchor=\"" + anchor + "\"" + more + ">" +
         Escaped(text) + "</text>\n";
}

PlotAxis Widened(PlotAxis axis) {
  if (!(axis.greatest > axis.least)) axis.greatest = axis.least + 1.0;
  return axis;
}

}  // namespace

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

SvgPlot::SvgPlot(const PlotAxis& x, const PlotAxis& y, int width, int height)
    : x_(Widened(x)), y_(Widened(y)), width_(width), height_(height) {}

PlotPoint SvgPlot::ToPixels(const PlotPoint& point) const {
  const double across = (point.x - x_.least) / (x_.greatest - x_.least);
  const double up = (point.y - y_.least) / (y_.greatest - y_.least);
  return {kLeft + across * (width_ - kLeft - kRight), height_ - kBottom - up * (height_ - kTop - kBottom)};
}

std::string SvgPlot::PathOf(const std::vector<PlotPoint>& points) const {
  std::string path;
  for (const PlotPoint& point : points) {
    const PlotPoint pixel = ToPixels(point);
    path += (path.empty() ? "" : " ") + Pixel(pixel.x) + "," + Pixel(pixel.y);
  }
  return path;
}

void SvgPlot::AddLine(const std::vector<PlotPoint>& points, const std::string& colour, double thickness,
                      const std::string& label) {
  drawings_ += "<polyline fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" + Pixel(thickness) +
               "\" stroke-linejoin=\"round\" points=\"" + PathOf(points) + "\"/>\n";
  if (!label.empty()) AddLegend(colour, label);
}

void SvgPlot::AddBand(const std::vector<PlotPoint>& upper, const std::vector<PlotPoint>& lower,
                      const std::string& colour, const std::string& label) {
  std::vector<PlotPoint> outline = upper;
  outline.insert(outline.end(), lower.rbegin(), lower.rend());
  drawings_ += "<polygon fill=\"" + colour + "\" fill-opacity=\"0.22\" points=\"" + PathOf(outline) + "\"/>\n";
  if (!label.empty()) AddLegend(colour, label);
}

void SvgPlot::AddDot(const PlotPoint& point, const std::string& colour, const std::string& title) {
  const PlotPoint pixel = ToPixels(point);
  drawings_ += "<circle cx=\"" + Pixel(pixel.x) + "\" cy=\"" + Pixel(pixel.y) + "\" r=\"3.5\" fill=\"" + colour +
               "\"><title>" + Escaped(title) + "</title></circle>\n";
}

void SvgPlot::AddLegend(const std::string& colour, const std::string& label) { legend_.emplace_back(colour, label); }

std::string SvgPlot::Grid() const {
  std::string grid;
  const double x_step = TickStep(x_.greatest - x_.least, 8);
  for (const double tick : Ticks(x_, x_step)) {
    const PlotPoint foot = ToPixels({tick, y_.least});
    grid += LineElement(foot, {foot.x, foot.y + 4.0}, "axis");
    grid += TextElement({foot.x, foot.y + 16.0}, "middle", TickText(tick, x_step));
  }
  const double y_step = TickStep(y_.greatest - y_.least, 5);
  for (const double tick : Ticks(y_, y_step)) {
    const PlotPoint left = ToPixels({x_.least, tick});
    grid += LineElement(left, ToPixels({x_.greatest, tick}), "grid");
    grid += TextElement({left.x - 6.0, left.y + 4.0}, "end", TickText(tick, y_step));
  }
  grid += LineElement(ToPixels({x_.least, y_.least}), ToPixels({x_.greatest, y_.least}), "axis");
  grid += TextElement({0.5 * (kLeft + width_ - kRight), height_ - 6.0}, "middle", x_.title);
  const std::string middle = Pixel(0.5 * (kTop + height_ - kBottom));
  return grid + TextElement({14.0, 0.5 * (kTop + height_ - kBottom)}, "middle", y_.title,
                            " transform=\"rotate(-90 14 " + middle + ")\"");
}

std::string SvgPlot::Legend() const {
  std::string legend;
  for (const auto& [colour, label] : legend_) {
    legend += "<span><i style=\"background:" + colour + "\"></i>" + Escaped(label) + "</span>\n";
  }
  return "<figcaption>" + legend + "</figcaption>\n";
}

std::string SvgPlot::Text() const {
  const std::string size = std::to_string(width_) + " " + std::to_string(height_);
  const std::string frame = "x=\"" + std::to_string(kLeft) + "\" y=\"" + std::to_string(kTop) + "\" width=\"" +
                            std::to_string(width_ - kLeft - kRight) + "\" height=\"" +
                            std::to_string(height_ - kTop - kBottom) + "\"";
  // A nested svg element clips drawings at the axes. A clip path would need an identifier that is unique in the page.
  return "<figure>\n" + Legend() + "<svg viewBox=\"0 0 " + size + "\" width=\"" + std::to_string(width_) +
         "\" height=\"" + std::to_string(height_) + "\" role=\"img\">\n" + Grid() + "<svg " + frame + " viewBox=\"" +
         std::to_string(kLeft) + " " + std::to_string(kTop) + " " + std::to_string(width_ - kLeft - kRight) + " " +
         std::to_string(height_ - kTop - kBottom) + "\">\n" + drawings_ + "</svg>\n</svg>\n</figure>\n";
}

}  // namespace contact_shapelets::cli
