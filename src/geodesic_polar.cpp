// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/geodesic_polar.h>

#include "curve_field.h"
#include "geodesic_field.h"
#include "polar_chart.h"
#include "refusal.h"
#include "region_mesh.h"
#include "select_region.h"
#include "source_curve.h"
#include "unfold_chart.h"

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

// Rounding of a point at the very radius.
constexpr double beyond_radius = 1e-9;
constexpr int most_trials = 8;
// Bands that are thinner than this share of their length are not looked for: they take as many triangles as it is long.
constexpr double thinnest_band = 1e-3;

double length_of(const Blend_mesh& mesh, const std::vector<Face_point>& curve) {
  double sum = 0;
  for (std::size_t i = 0; i < curve.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(position(mesh, curve[i]), position(mesh, curve[(i + 1) % curve.size()])));
  return sum;
}

bool is_place(const Blend_mesh& mesh, const Face_point& at) {
  if (!at.face.is_valid() || !mesh.is_valid(at.face)) return false;
  const auto& w = at.weights;
  constexpr double rounding = 1e-9;
  return std::all_of(w.begin(), w.end(), [](double x) { return x >= -rounding && x <= 1 + rounding; }) &&
         std::abs(w[0] + w[1] + w[2] - 1) < rounding;
}

}  // namespace

Point_3 position(const Blend_mesh& mesh, const Face_point& at) {
  Vec sum = Vec::Zero();
  Halfedge h = mesh.halfedge(at.face);
  for (const double weight : at.weights) {
    sum += weight * to_vec(mesh.point(mesh.target(h)));
    h = mesh.next(h);
  }
  return to_point(sum);
}

struct Geodesic_polar::Impl {
  Impl(const Blend_mesh& mesh, double radius) : region(mesh), radius(radius) {}

  void build(const Face_point& source, const Geodesic_polar_options& options);
  void build(const std::vector<Curve_point>& source, const Geodesic_polar_options& options);
  void lay_out(Chart_kind kind);
  void judge();

  Region_mesh region;
  std::optional<Geodesic_field> field;
  std::optional<Polar_chart> chart;
  Diagnosis diagnosis;
  double radius, safe_radius = 0, limit = 0;
};

void Geodesic_polar::Impl::build(const Face_point& source, const Geodesic_polar_options& options) {
  const Near_polyline near_source({to_vec(position(region.mesh(), source))});
  const Selection selection = select_region(region, source.face, near_source, radius, options.fill_holes);
  limit = selection.limit;
  const std::int32_t vertex = insert_place(region, source);
  region.refine(selection.first_long, selection.length, [&](const auto& c) { return near_source(c, limit); });
  const auto& first = region.triangles()[region.star(vertex).front()];
  if (first.beyond[(Region_mesh::slot_of(first, vertex) + 2) % 3] == Region_mesh::border) {
    diagnosis = refusal(Status::region_meets_border, region.points()[vertex]);
    return;
  }
  const Vector_3 zero = options.zero_direction.value_or(Vector_3(0, 0, 0));
  field = one_ring(region, vertex, {zero.x(), zero.y(), zero.z()});
  propagate(region, limit, *field);
  lay_out(Chart_kind::disk);
}

void Geodesic_polar::Impl::build(const std::vector<Curve_point>& source, const Geodesic_polar_options& options) {
  std::vector<Vec> points;
  for (const Curve_point& p : source) points.push_back(to_vec(position(region.mesh(), p.at)));
  const Near_polyline near_source(points);
  const Selection selection = select_region(region, source.front().step, near_source, radius, options.fill_holes);
  limit = selection.limit;
  std::int32_t first = -1;
  diagnosis = cut_along(region, source, first);
  if (!diagnosis.ok()) return;
  region.refine(0, selection.length, [&](const auto& c) { return near_source(c, limit); });
  field = curve_field(region, cut_vertices(region, first), selection.length, limit);
  lay_out(Chart_kind::band);
}

void Geodesic_polar::Impl::lay_out(Chart_kind kind) {
  chart.emplace(region, *field, kind, radius, limit);
  if (!chart->is_one_to_one()) {
    const double fold = chart->bound().fold;
    const Geodesic_field straight = *field;
    unfold_chart(region, kind, thin_height(kind, radius), limit, *field);
    chart.emplace(region, *field, kind, radius, limit);
    if (chart->bound().fold <= fold) {
      *field = straight;
      chart.emplace(region, *field, kind, radius, limit);
    }
  }
  judge();
}

void Geodesic_polar::Impl::judge() {
  const auto& bound = chart->bound();
  safe_radius = std::min({radius, bound.fold, bound.border});
  if (safe_radius >= radius) {
    chart->index();
    return;
  }
  const bool folds = bound.fold <= bound.border;
  const Vec& at = region.points()[folds ? bound.fold_at : bound.border_at];
  diagnosis = refusal(folds ? Status::radius_exceeds_cut_locus : Status::region_meets_border, at);
}

namespace {

/// The largest of ever smaller radii with which the coordinates work; 0: none was found.
template <class Safe_radius>
double verified_radius(double radius, double least, const Safe_radius& safe_radius) {
  for (int trial = 0; trial < most_trials && radius > least; ++trial) {
    const double found = safe_radius(radius);
    if (found >= radius) return radius;
    radius = found;
  }
  return 0;
}

/// Builds coordinates, and if they do not reach so far, tells how far they would.
/// \param least radius to be tried
template <class Impl, class Source>
void build_or_bound(Impl& impl, const Source& source, const Geodesic_polar_options& options, double least) {
  impl.build(source, options);
  if (impl.diagnosis.ok()) return;
  impl.safe_radius = verified_radius(impl.safe_radius, least, [&](double smaller) {
    Impl trial(impl.region.mesh(), smaller);
    trial.build(source, options);
    return trial.safe_radius;
  });
  if (impl.safe_radius > 0) impl.diagnosis.max_radius = impl.safe_radius;
}

}  // namespace

Geodesic_polar::Geodesic_polar(const Blend_mesh& mesh, const Face_point& source, double radius,
                               const Geodesic_polar_options& options) {
  const auto impl = std::make_shared<Impl>(mesh, radius);
  impl_ = impl;
  if (radius > 0 && std::isfinite(radius) && is_place(mesh, source))
    build_or_bound(*impl, source, options, 0);
  else
    impl->diagnosis.status = Status::invalid_parameter;
}

Geodesic_polar::Geodesic_polar(const Blend_mesh& mesh, const std::vector<Face_point>& source, double radius,
                               const Geodesic_polar_options& options) {
  const auto impl = std::make_shared<Impl>(mesh, radius);
  impl_ = impl;
  const bool sound = radius > 0 && std::isfinite(radius) && source.size() >= 2 &&
                     std::all_of(source.begin(), source.end(), [&](const auto& at) { return is_place(mesh, at); });
  const auto curve = sound ? complete_curve(mesh, source) : std::nullopt;
  if (curve)
    build_or_bound(*impl, *curve, options, thinnest_band * length_of(mesh, source));
  else
    impl->diagnosis.status = Status::invalid_parameter;
}

const Diagnosis& Geodesic_polar::diagnosis() const { return impl_->diagnosis; }

bool Geodesic_polar::covers(Vertex v) const {
  const std::int32_t local = impl_->region.local(v);
  return local >= 0 && impl_->field && impl_->field->at[local].distance <= impl_->limit;
}

Polar_point Geodesic_polar::operator()(Vertex v) const {
  CGAL_precondition(covers(v));
  const auto& value = impl_->field->at[impl_->region.local(v)];
  return {value.distance, value.angle};
}

double Geodesic_polar::safe_radius() const { return impl_->safe_radius; }

double Geodesic_polar::radius() const { return impl_->radius; }

const Blend_mesh& Geodesic_polar::mesh() const { return impl_->region.mesh(); }

std::optional<Face_point> Geodesic_polar::locate(const Polar_point& at) const {
  CGAL_precondition(diagnosis().ok());
  if (!(std::abs(at.distance) <= impl_->radius * (1 + beyond_radius))) return std::nullopt;
  const auto place = impl_->chart->locate(at);
  if (!place || impl_->region.face(place->triangle) == Blend_mesh::null_face()) return std::nullopt;
  return impl_->region.in_face(*place);
}

Point_3 Geodesic_polar::point(const Polar_point& at) const {
  CGAL_precondition(diagnosis().ok());
  const auto place = impl_->chart->locate(at);
  CGAL_precondition(place.has_value());
  const auto c = impl_->region.corners(place->triangle);
  return to_point(place->weights[0] * c[0] + place->weights[1] * c[1] + place->weights[2] * c[2]);
}

std::optional<Polar_point> Geodesic_polar::coordinates(const Face_point& at) const {
  CGAL_precondition(diagnosis().ok());
  const Region_mesh::Place place = impl_->region.in_triangle(at);
  if (!impl_->chart->covers(place.triangle)) return std::nullopt;
  return impl_->chart->at(place);
}

}  // namespace cgal_blend
