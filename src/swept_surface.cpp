// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/trimmed_surface.h>

#include "join_rows.h"
#include "sample_curve.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cgal_blend {

namespace {

constexpr int first_levels = 4, most_levels = 256, steps_per_level = 4, newton_steps = 12;
constexpr double flattest = 1e-6;  // sine of the angle between surface and level plane at which a line is lost

/// Walks on the surface along the lines on which a linear function changes fastest.
class Ascent {
 public:
  Ascent(const Implicit_function& surface, const Vector_3& direction) : surface_(surface), a_(direction) {}

  /// Goes to the level where a . x = `level`; nothing if the surface turns parallel to the levels, or ends.
  [[nodiscard]] std::optional<Point_3> go(Point_3 p, double level) const {
    for (int step = 0; step < steps_per_level; ++step) {
      const double rise = (level - a_ * (p - CGAL::ORIGIN)) / (steps_per_level - step);
      const Vector_3 g = surface_.gradient(p);
      const Vector_3 up = a_ - (a_ * g / g.squared_length()) * g;
      if (!(up.squared_length() > flattest * flattest * a_.squared_length())) return std::nullopt;
      const auto next = project(p + rise / (a_ * up) * up);
      if (!next) return std::nullopt;
      p = *next;
    }
    return p;
  }

 private:
  /// Newton's method within the level.
  [[nodiscard]] std::optional<Point_3> project(Point_3 p) const {
    for (int step = 0; step < newton_steps; ++step) {
      const Vector_3 g = surface_.gradient(p);
      const Vector_3 within = g - (a_ * g / a_.squared_length()) * a_;
      const double value = surface_.value(p), slope = g * within;
      if (value == 0) return p;
      if (!(slope > flattest * flattest * g.squared_length())) return std::nullopt;
      const Vector_3 correction = value / slope * within;
      p = p - correction;
      const double size = std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z()), 1e-300});
      if (correction.squared_length() < 1e-30 * size * size) return p;
    }
    return std::nullopt;
  }

  const Implicit_function& surface_;
  Vector_3 a_;
};

class Sweep {
 public:
  Sweep(const Implicit_function& surface, const Far_plane& far, const Tessellation_options& options,
        Triangle_soup& soup, Rims& rims)
      : a_(CGAL::to_double(far[0]), CGAL::to_double(far[1]), CGAL::to_double(far[2])),
        end_(-CGAL::to_double(far[3])),
        ascent_(surface, a_),
        options_(options),
        soup_(soup),
        rims_(rims) {}

  Diagnosis run(const std::vector<Trim_curve>& curves) {
    if (curves.size() != 1) return {Status::not_supported, "a swept surface has one boundary curve", {}, {}};
    if (a_ == CGAL::NULL_VECTOR) return {Status::invalid_parameter, "a far plane has no normal", {}, {}};
    const Trim_curve& curve = curves[0];
    // All lines have to leave the curve towards the kept side.
    for (std::size_t i = 0; i < curve.vertices.size(); ++i) {
      const Point_3& p = soup_.points[curve.vertices[i]];
      if (!(a_ * curve.outward[i] * (end_ - a_ * (p - CGAL::ORIGIN)) < 0))
        return {Status::surface_not_bounded, "the far plane is not on the kept side of the curve", p, {}};
    }
    int levels = first_levels;
    while (true) {
      const auto lines = trace(curve, levels);
      if (!lines) return {Status::surface_not_bounded, "the surface turns away from the far plane", lost_, {}};
      if (levels >= most_levels || are_good(*lines)) return write(curve, *lines);
      levels *= 2;
    }
  }

 private:
  using Lines = std::vector<std::vector<Point_3>>;  // per vertex of the curve, from it to the plane

  std::optional<Lines> trace(const Trim_curve& curve, int levels) {
    Lines lines;
    for (const std::size_t v : curve.vertices) {
      const Point_3 start = soup_.points[v];
      const double from = a_ * (start - CGAL::ORIGIN);
      std::vector<Point_3> line{start};
      for (int k = 1; k <= levels; ++k) {
        const auto next = ascent_.go(line.back(), from + (end_ - from) * k / levels);
        if (!next) {
          lost_ = line.back();
          return std::nullopt;
        }
        line.push_back(*next);
      }
      lines.push_back(std::move(line));
    }
    return lines;
  }

  /// Every second point is taken for the middle of a chord twice as long as those that are used.
  [[nodiscard]] bool are_good(const Lines& lines) const {
    for (const auto& line : lines)
      for (std::size_t k = 1; k + 1 < line.size(); ++k)
        if (!is_chord_good({line[k - 1]}, {line[k]}, {line[k + 1]}, 4 * options_.tolerance)) return false;
    return true;
  }

  Diagnosis write(const Trim_curve& curve, const Lines& lines) {
    std::vector<double> parameters;
    for (std::size_t i = 0; i < lines.size(); ++i) parameters.push_back(static_cast<double>(i) / lines.size());
    Point_line before{curve.vertices, parameters};
    for (std::size_t k = 1; k < lines[0].size(); ++k) {
      Point_line next{{}, parameters};
      for (const auto& line : lines) next.vertices.push_back(soup_.add(line[k]));
      join_rows(before, next, curve.closed, options_.part, soup_);
      before = std::move(next);
    }
    if (curve.closed) rims_.push_back(before.vertices);
    return {};
  }

  Vector_3 a_;
  double end_;
  Ascent ascent_;
  const Tessellation_options& options_;
  Triangle_soup& soup_;
  Rims& rims_;
  std::optional<Point_3> lost_;
};

}  // namespace

Trimmed_surface swept_surface(const Implicit_function& surface, const Far_plane& far) {
  return [surface, far](const std::vector<Trim_curve>& curves, const Tessellation_options& options, Triangle_soup& soup,
                        Rims& rims) { return Sweep(surface, far, options, soup, rims).run(curves); };
}

}  // namespace cgal_blend
