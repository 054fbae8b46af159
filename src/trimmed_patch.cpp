// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/trimmed_surface.h>

#include "join_rows.h"
#include "sample_curve.h"

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr std::size_t lines_across = 24;  // on which the steps in v are judged
constexpr std::size_t first_steps = 4;
constexpr double point_like = 1e-9;  // extent of a rim, of the patch, that is a point

/// Tessellation of one patch: rows of points at equal parameters v between the two ends.
class Patch_tessellator {
 public:
  Patch_tessellator(const Parametric_patch& patch, const Tessellation_options& options, Triangle_soup& soup, Rims& rims)
      : patch_(patch), options_(options), soup_(soup), rims_(rims) {}

  Diagnosis run(const std::vector<Trim_curve>& curves) {
    std::array<const Trim_curve*, 2> ends{};
    for (const Trim_curve& curve : curves) {
      if (curve.slot < 0 || curve.slot > 1 || ends[static_cast<std::size_t>(curve.slot)] != nullptr)
        return {Status::no_boundary_curve, "a patch has one curve at each of its two ends", {}, {}};
      ends[static_cast<std::size_t>(curve.slot)] = &curve;
    }
    if (curves.empty()) return {Status::no_boundary_curve, "nothing is joined to the patch", {}, {}};
    const std::vector<double> inner = inner_parameters(ends), levels = level_parameters();
    Point_line before = ends[0] != nullptr ? ascending(*ends[0]) : rim(inner, patch_.v0);
    for (std::size_t k = 1; k < levels.size(); ++k) {
      const bool last = k + 1 == levels.size();
      const Point_line next = !last                ? row(inner, levels[k])
                              : ends[1] != nullptr ? ascending(*ends[1])
                                                   : rim(inner, patch_.v1);
      join_rows(before, next, patch_.closed_u, options_.part, soup_);
      before = next;
    }
    return {};
  }

 private:
  [[nodiscard]] Point_3 at(double s, double v) const {
    return patch_.at(patch_.u0 + s * (patch_.u1 - patch_.u0), v).point;
  }

  /// Parameters along the rows: those of a curve if there is one, refined where other rows need it.
  [[nodiscard]] std::vector<double> inner_parameters(const std::array<const Trim_curve*, 2>& ends) const {
    std::vector<double> start = ascending(ends[0] != nullptr ? *ends[0] : *ends[1]).parameters;
    if (patch_.closed_u) start.push_back(start.front() + 1);
    const auto across = [&](double s) {
      Point_row points;
      for (int k = 0; k <= 4; ++k)
        points.push_back(at(s - std::floor(s), patch_.v0 + k / 4.0 * (patch_.v1 - patch_.v0)));
      return points;
    };
    const auto open_end = [&](double s) { return s == 1 && !patch_.closed_u ? across_at_end() : across(s); };
    std::vector<double> inner = refined_parameters(open_end, start, options_.tolerance);
    if (patch_.closed_u) inner.pop_back();
    return inner;
  }
  [[nodiscard]] Point_row across_at_end() const {
    Point_row points;
    for (int k = 0; k <= 4; ++k) points.push_back(at(1, patch_.v0 + k / 4.0 * (patch_.v1 - patch_.v0)));
    return points;
  }

  [[nodiscard]] std::vector<double> level_parameters() const {
    std::vector<double> start;
    for (std::size_t k = 0; k <= first_steps; ++k)
      start.push_back(patch_.v0 + static_cast<double>(k) / first_steps * (patch_.v1 - patch_.v0));
    const auto along = [&](double v) {
      Point_row points;
      for (std::size_t i = 0; i < lines_across; ++i)
        points.push_back(at(static_cast<double>(i) / (patch_.closed_u ? lines_across : lines_across - 1), v));
      return points;
    };
    return refined_parameters(along, start, options_.tolerance);
  }

  [[nodiscard]] Point_line row(const std::vector<double>& parameters, double v) const {
    Point_line line{{}, parameters};
    for (const double s : parameters) line.vertices.push_back(soup_.add(at(s - (s > 1 ? 1 : 0), v)));
    return line;
  }

  /// A row without a curve; one point if it has no extent, and to be capped if it is closed.
  [[nodiscard]] Point_line rim(const std::vector<double>& parameters, double v) const {
    CGAL::Bbox_3 box, size = at(0, patch_.v0).bbox() + at(0.5, patch_.v0).bbox() + at(0, patch_.v1).bbox();
    for (const double s : parameters) box += at(s - (s > 1 ? 1 : 0), v).bbox();
    const auto extent = [](const CGAL::Bbox_3& b) {
      return std::max({b.xmax() - b.xmin(), b.ymax() - b.ymin(), b.zmax() - b.zmin()});
    };
    if (extent(box) <= point_like * extent(size)) return {{soup_.add(at(0, v))}, {0}};
    Point_line line = row(parameters, v);
    if (patch_.closed_u) rims_.push_back(line.vertices);
    return line;
  }

  const Parametric_patch& patch_;
  const Tessellation_options& options_;
  Triangle_soup& soup_;
  Rims& rims_;
};

}  // namespace

Trimmed_surface trimmed_patch(const Parametric_patch& patch) {
  return [patch](const std::vector<Trim_curve>& curves, const Tessellation_options& options, Triangle_soup& soup,
                 Rims& rims) { return Patch_tessellator(patch, options, soup, rims).run(curves); };
}

}  // namespace cgal_blend
