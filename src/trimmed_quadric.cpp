// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/quadric_intersection.h>
#include <cgal_blend/trimmed_surface.h>

#include "quadric_chart.h"
#include "region_triangulation.h"
#include "sample_curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace cgal_blend {

namespace {

constexpr std::size_t far_spans = 16;
constexpr double largest_normal_turn = 0.5;  // radians between facet and surface
constexpr double shortest_edge = 0.1;        // of the tolerance: edges are not made shorter

Diagnosis refuse(Status status, const std::string& detail, const std::optional<Point_3>& place = {}) {
  return {status, detail, place, {}};
}

/// Twice the area vector of a polygon.
Vector_3 area_vector(const Trim_curve& curve, const Triangle_soup& soup) {
  Vector_3 sum(0, 0, 0);
  const Point_3 origin = soup.points[curve.vertices[0]];
  for (std::size_t i = 1; i + 1 < curve.vertices.size(); ++i)
    sum =
        sum + CGAL::cross_product(soup.points[curve.vertices[i]] - origin, soup.points[curve.vertices[i + 1]] - origin);
  return sum;
}

/// Tessellation of one part of one quadric.
class Quadric_tessellator {
 public:
  using Point_2 = Kernel::Point_2;

  Quadric_tessellator(const Quadric_3& quadric, const std::vector<Far_plane>& far, const Tessellation_options& options,
                      Triangle_soup& soup, Rims& rims)
      : quadric_(quadric), far_(far), options_(options), soup_(soup), rims_(rims) {}

  Diagnosis run(const std::vector<Trim_curve>& curves) {
    if (Diagnosis bad = make_chart(curves); !bad.ok()) return bad;
    if (Diagnosis bad = add_polygons(curves); !bad.ok()) return bad;
    if (chart_->origin() == Quadric_chart::Origin::apex &&
        !region_.add_point(Point_2(0, 0), soup_.add(chart_->centre())))
      return refuse(Status::singular_boundary, "the curve runs through the apex", chart_->centre());
    for (std::size_t i = 0; i < curves.size(); ++i) region_.mark(i, !is_kept_on_left(curves[i]));
    // The point that stands for infinity must be outside: nothing may run there.
    if (!region_.is_bounded() ||
        (chart_->origin() == Quadric_chart::Origin::infinity && region_.contains(Point_2(0, 0))))
      return refuse(Status::surface_not_bounded, "no far plane ends it");
    refine();
    write(curves.size());
    return {};
  }

 private:
  Diagnosis make_chart(const std::vector<Trim_curve>& curves) {
    if (curves.empty()) return refuse(Status::no_boundary_curve, "the quadric has none");
    for (const Trim_curve& curve : curves)
      if (!curve.closed) return refuse(Status::not_supported, "an open curve on a quadric needs a swept surface");
    Vector_3 away = area_vector(curves[0], soup_), outward(0, 0, 0);
    for (const Vector_3& v : curves[0].outward) outward = outward + v;
    // Of a polygon that runs half round it, the outward vectors add up to the pole on the side that is cut off.
    const Point_3 p = soup_.points[curves[0].vertices[0]];
    if (away * outward < 0) away = -away;
    chart_ = Quadric_chart::make(quadric_, p, away);
    if (!chart_)
      return refuse(Status::not_supported, std::string("this part cannot be kept of ") + describe(quadric_.type()));
    return {};
  }

  Diagnosis add_polygons(const std::vector<Trim_curve>& curves) {
    for (const Trim_curve& curve : curves) {
      std::vector<Point_2> polygon;
      for (const std::size_t v : curve.vertices) polygon.push_back(chart_->to_plane(soup_.points[v]));
      if (!region_.add_polygon(polygon, curve.vertices))
        return refuse(Status::blends_overlap, "boundary curves on one surface meet", soup_.points[curve.vertices[0]]);
    }
    for (const Far_plane& plane : far_)
      if (Diagnosis bad = add_far_plane(plane); !bad.ok()) return bad;
    return {};
  }

  Diagnosis add_far_plane(const Far_plane& plane) {
    try {
      return add_section(plane);
    } catch (const std::range_error& error) {
      return refuse(Status::not_supported, std::string("a far plane is too nearly degenerate: ") + error.what());
    }
  }

  Diagnosis add_section(const Far_plane& plane) {
    const auto is_zero = [](const Quadric_3::Rational& x) { return x == 0; };
    if (std::all_of(plane.begin(), plane.begin() + 3, is_zero))
      return refuse(Status::invalid_parameter, "a far plane has no normal");
    const Quadric_intersection section = intersect(quadric_, plane);
    if (section.status == Intersection_status::surface)
      return refuse(Status::not_supported, "a far plane lies on the surface");
    for (const Intersection_curve& curve : section.components) {
      if (curve.is_isolated() || !chart_->is_on_component(curve.at(0.25).point)) continue;
      if (!curve.is_closed())
        return refuse(Status::not_supported, "a far plane must cut the surface in a closed curve");
      if (Diagnosis bad = add_far_curve(curve); !bad.ok()) return bad;
    }
    return {};
  }

  Diagnosis add_far_curve(const Intersection_curve& curve) {
    std::vector<double> start;
    for (std::size_t i = 0; i <= far_spans; ++i) start.push_back(static_cast<double>(i) / far_spans);
    const auto at = [&](double s) { return Point_row{curve.at(s == 1 ? 0 : s).point}; };
    std::vector<double> parameters = refined_parameters(at, start, options_.tolerance);
    parameters.pop_back();
    std::vector<std::size_t> ids;
    std::vector<Point_2> polygon;
    for (const double s : parameters) {
      ids.push_back(soup_.add(curve.at(s).point));
      polygon.push_back(chart_->to_plane(soup_.points.back()));
    }
    if (!region_.add_polygon(polygon, ids))
      return refuse(Status::blend_collides, "a far plane meets the boundary curve or another far plane",
                    curve.at(0).point);
    far_polygons_.push_back(ids);
    return {};
  }

  /// The majority of the curve's places, each a little step against the outward vector.
  [[nodiscard]] bool is_kept_on_left(const Trim_curve& curve) const {
    int votes = 0;
    const std::size_t n = curve.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point_3 &p = soup_.points[curve.vertices[i]], &next = soup_.points[curve.vertices[(i + 1) % n]];
      const double step = 0.01 * std::sqrt(CGAL::squared_distance(p, next) / curve.outward[i].squared_length());
      const Point_2 inside = chart_->to_plane(p - step * curve.outward[i]);
      votes += CGAL::orientation(chart_->to_plane(p), chart_->to_plane(next), inside);
    }
    return votes > 0;
  }

  /// True for triangles that are too far from the surface or turned away from it.
  [[nodiscard]] bool is_bad(const Region_triangulation::Triangle& t) const {
    const Point_3 &a = soup_.points[t[0]], &b = soup_.points[t[1]], &c = soup_.points[t[2]];
    const double longest =
        std::max({CGAL::squared_distance(a, b), CGAL::squared_distance(b, c), CGAL::squared_distance(c, a)});
    if (longest < 100 * shortest_edge * shortest_edge * options_.tolerance * options_.tolerance) return false;
    const Vector_3 normal = CGAL::cross_product(b - a, c - a);
    const double area = std::sqrt(normal.squared_length());
    if (!(area > 0)) return true;
    const auto strays = [&](double u, double v) {
      const Point_3 flat = a + u * (b - a) + v * (c - a);
      const Vector_3 g = quadric_.gradient(flat);
      const double slope = std::sqrt(g.squared_length());
      // First-order distance of the facet to the surface, and the angle between them.
      return std::abs(quadric_.value(flat)) > options_.tolerance * slope ||
             std::abs(g * normal) < std::cos(largest_normal_turn) * slope * area;
    };
    return strays(1. / 3, 1. / 3) || strays(0.5, 0) || strays(0, 0.5) || strays(0.5, 0.5);
  }

  void refine() {
    region_.refine([this](const Region_triangulation::Triangle& t) { return is_bad(t); },
                   [this](const Point_2& p) { return soup_.add(chart_->to_surface(p)); });
  }

  void write(std::size_t curves) {
    for (const auto& t : region_.triangles()) {
      soup_.triangles.push_back(t);
      soup_.parts.push_back(options_.part);
    }
    for (std::size_t i = 0; i < far_polygons_.size(); ++i)
      if (region_.ends_at(curves + i)) rims_.push_back(far_polygons_[i]);
  }

  const Quadric_3& quadric_;
  const std::vector<Far_plane>& far_;
  const Tessellation_options& options_;
  Triangle_soup& soup_;
  Rims& rims_;
  std::optional<Quadric_chart> chart_;
  Region_triangulation region_;
  std::vector<std::vector<std::size_t>> far_polygons_;
};

}  // namespace

Trimmed_surface trimmed_quadric(const Quadric_3& quadric, const std::vector<Far_plane>& far) {
  return [quadric, far](const std::vector<Trim_curve>& curves, const Tessellation_options& options, Triangle_soup& soup,
                        Rims& rims) { return Quadric_tessellator(quadric, far, options, soup, rims).run(curves); };
}

}  // namespace cgal_blend
