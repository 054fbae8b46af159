// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/geodesic_polar.h>

#include "fill_holes.h"
#include "geodesic_field.h"
#include "polar_chart.h"
#include "refusal.h"
#include "region_mesh.h"
#include "unfold_chart.h"

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

// Edges are at most this share of the radius, so that triangles do not reach far out of the disk.
constexpr double longest_edge = 0.125;
// A source with a weight below this is on the edge or at the vertex: it moves by less than the coordinates' accuracy.
constexpr double least_weight = 1e-13;
// Rounding of a point at the very radius.
constexpr double beyond_radius = 1e-9;
constexpr int most_trials = 8;

bool is_place(const Blend_mesh& mesh, const Face_point& at) {
  if (!at.face.is_valid() || !mesh.is_valid(at.face)) return false;
  const auto& w = at.weights;
  constexpr double rounding = 1e-9;
  return std::all_of(w.begin(), w.end(), [](double x) { return x >= -rounding && x <= 1 + rounding; }) &&
         std::abs(w[0] + w[1] + w[2] - 1) < rounding;
}

std::array<Vec, 3> corners_of(const Blend_mesh& mesh, Face face) {
  const Halfedge h = mesh.halfedge(face);
  const Halfedge g = mesh.next(h);
  return {to_vec(mesh.point(mesh.target(h))), to_vec(mesh.point(mesh.target(g))),
          to_vec(mesh.point(mesh.target(mesh.next(g))))};
}

double squared_longest(const std::array<Vec, 3>& c) {
  return std::max({(c[1] - c[0]).squaredNorm(), (c[2] - c[1]).squaredNorm(), (c[0] - c[2]).squaredNorm()});
}

/// A ball that selects triangles.
struct Ball {
  Vec centre;
  double radius;

  [[nodiscard]] bool meets(const std::array<Vec, 3>& c) const {
    const std::array<double, 3> squared{(c[0] - centre).squaredNorm(), (c[1] - centre).squaredNorm(),
                                        (c[2] - centre).squaredNorm()};
    const double nearest = *std::min_element(squared.begin(), squared.end());
    if (nearest <= radius * radius) return true;
    if (std::sqrt(nearest) > radius + std::sqrt(squared_longest(c))) return false;
    return CGAL::squared_distance(
               to_point(centre), Kernel::Triangle_3(to_point(c[0]), to_point(c[1]), to_point(c[2]))) <= radius * radius;
  }
};

/// Makes a place a vertex of the region and returns it.
std::int32_t insert(Region_mesh& region, const Face_point& source) {
  Region_mesh::Place place = region.in_triangle(source);
  auto& w = place.weights;
  const Vec at = to_vec(position(region.mesh(), source));
  const auto& corner = region.triangles()[place.triangle].corner;
  const int most = static_cast<int>(std::max_element(w.begin(), w.end()) - w.begin());
  const int b = (most + 1) % 3, c = (most + 2) % 3;
  if (w[b] < least_weight && w[c] < least_weight) return corner[most];
  const int least = w[b] < w[c] ? b : c;
  if (w[least] < least_weight) {
    const double first = w[(least + 1) % 3], last = w[(least + 2) % 3];
    return region.divide(place.triangle, least, last / (first + last), at);
  }
  // Inside: between the corner with most weight and the foot on the edge opposite of it.
  const double share = w[c] / (w[b] + w[c]);
  const auto points = region.corners(place.triangle);
  region.divide(place.triangle, most, share, (1 - share) * points[b] + share * points[c]);
  return region.divide(place.triangle, b, w[most], at);
}

}  // namespace

Point_3 position(const Blend_mesh& mesh, const Face_point& at) {
  const auto c = corners_of(mesh, at.face);
  return to_point(at.weights[0] * c[0] + at.weights[1] * c[1] + at.weights[2] * c[2]);
}

struct Geodesic_polar::Impl {
  Impl(const Blend_mesh& mesh, double radius) : region(mesh), radius(radius), safe_radius(0) {}

  void build(const Face_point& source, const Geodesic_polar_options& options);
  std::int32_t select(const Face_point& source, bool fills_holes);
  void judge();

  Region_mesh region;
  std::optional<Geodesic_field> field;
  std::optional<Polar_chart> chart;
  Diagnosis diagnosis;
  double radius, safe_radius, length = 0, limit = 0;
};

/// Takes the triangles that geodesics up to the limit can meet: straight lines are not longer than geodesics.
std::int32_t Geodesic_polar::Impl::select(const Face_point& source, bool fills_holes) {
  const Blend_mesh& mesh = region.mesh();
  Ball ball{to_vec(position(mesh, source)), radius};
  double squared = squared_longest(corners_of(mesh, source.face));
  region.grow(source.face, [&](Face f) {
    const auto c = corners_of(mesh, f);
    if (!ball.meets(c)) return false;
    squared = std::max(squared, squared_longest(c));
    return true;
  });
  // Triangles that meet the disk end within one length of it, and those around them within two.
  const bool all_short = std::sqrt(squared) <= longest_edge * radius;
  length = all_short ? std::sqrt(squared) : longest_edge * radius;
  limit = radius + 2 * length;
  ball.radius = limit;
  const auto count = static_cast<std::int32_t>(region.triangles().size());
  const auto grow = [&] { region.grow(source.face, [&](Face f) { return ball.meets(corners_of(mesh, f)); }); };
  grow();
  while (fills_holes && fill_holes(region, [&](const auto& c) { return ball.meets(c); })) grow();
  return all_short ? count : 0;
}

void Geodesic_polar::Impl::build(const Face_point& source, const Geodesic_polar_options& options) {
  const std::int32_t first_long = select(source, options.fill_holes);
  const std::int32_t vertex = insert(region, source);
  const Ball ball{region.points()[vertex], limit};
  region.refine(first_long, length, [&](const auto& c) { return ball.meets(c); });
  const Vec zero = options.zero_direction
                       ? Vec(options.zero_direction->x(), options.zero_direction->y(), options.zero_direction->z())
                       : Vec(Vec::Zero());
  const auto star = region.star(vertex);
  const auto& first = region.triangles()[star.front()];
  if (first.beyond[(Region_mesh::slot_of(first, vertex) + 2) % 3] == Region_mesh::border) {
    diagnosis = refusal(Status::region_meets_border, region.points()[vertex]);
    return;
  }
  field = one_ring(region, vertex, zero);
  propagate(region, limit, *field);
  chart.emplace(region, *field, radius, limit);
  if (!chart->is_one_to_one()) {
    const double fold = chart->bound().fold;
    const Geodesic_field straight = *field;
    unfold_chart(region, limit, *field);
    chart.emplace(region, *field, radius, limit);
    if (chart->bound().fold <= fold) {
      *field = straight;
      chart.emplace(region, *field, radius, limit);
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
template <class Build>
double verified_radius(double radius, const Build& build) {
  for (int trial = 0; trial < most_trials && radius > 0; ++trial) {
    const double found = build(radius);
    if (found >= radius) return radius;
    radius = found;
  }
  return 0;
}

}  // namespace

Geodesic_polar::Geodesic_polar(const Blend_mesh& mesh, const Face_point& source, double radius,
                               const Geodesic_polar_options& options) {
  const auto impl = std::make_shared<Impl>(mesh, radius);
  impl_ = impl;
  if (!(radius > 0) || !std::isfinite(radius) || !is_place(mesh, source)) {
    impl->diagnosis.status = Status::invalid_parameter;
    return;
  }
  impl->build(source, options);
  if (impl->diagnosis.ok()) return;
  impl->safe_radius = verified_radius(impl->safe_radius, [&](double smaller) {
    Impl trial(mesh, smaller);
    trial.build(source, options);
    return trial.safe_radius;
  });
  if (impl->safe_radius > 0) impl->diagnosis.max_radius = impl->safe_radius;
}

Geodesic_polar::Geodesic_polar(const Blend_mesh& mesh, const std::vector<Face_point>&, double radius,
                               const Geodesic_polar_options&) {
  const auto impl = std::make_shared<Impl>(mesh, radius);
  impl_ = impl;
  impl->diagnosis.status = Status::not_supported;
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
