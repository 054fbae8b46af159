// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_side.h"

#include "bridge_curve_check.h"
#include "nearest_face.h"
#include "refusal.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace cgal_blend {

namespace {

constexpr double snap_of_size = 1e-4;      // stations so near to a vertex or an edge are moved there
constexpr double reach = 1 + 1e-4;         // of the coordinates, over the largest distance on the curve
constexpr std::size_t fewest_points = 32;  // of a contact curve
constexpr double knot_spacing = 0.5;       // over the chord of a circle of the contact's size with the tolerance
constexpr int most_halvings = 6;
constexpr std::size_t most_facets = 4096;  // along and around
constexpr int most_repairs = 8;            // of a polyline that does not arrive, by more points

Polar_curve curve_of(const Bridge_end& end) {
  return end.curve || !(end.radius > 0) ? end.curve : circle_curve(end.radius);
}

/// Equal steps, halved until polygon and curve are near enough.
std::vector<double> sample_contact(const Bridge_side& side, const Bridge_options& options) {
  const std::size_t n = options.segments > 0 ? options.segments : fewest_points;
  std::vector<double> parameters;
  const auto halve = [&](auto& self, double from, double to, const Vec& a, const Vec& b, int depth) -> void {
    parameters.push_back(from);
    if (options.segments > 0 || depth == most_halvings) return;
    const double middle = 0.5 * (from + to);
    const Vec m = side.contact(middle);
    if ((m - 0.5 * (a + b)).norm() <= options.chord_tolerance * side.size) return;
    parameters.pop_back();
    self(self, from, middle, a, m, depth + 1);
    self(self, middle, to, m, b, depth + 1);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const double from = static_cast<double>(i) / static_cast<double>(n),
                 to = static_cast<double>(i + 1) / static_cast<double>(n);
    halve(halve, from, to, side.contact(from), side.contact(to), 0);
  }
  return parameters;
}

/// Puts a further parameter halfway before the one with an index.
void divide_before(std::vector<double>& parameters, std::size_t index) {
  const double to = index == 0 ? 1 : parameters[index];
  const double from = parameters[index == 0 ? parameters.size() - 1 : index - 1];
  parameters.insert(index == 0 ? parameters.end() : parameters.begin() + static_cast<std::ptrdiff_t>(index),
                    0.5 * (from + to));
}

/// Parameters of the stations between those of the given points, by length.
std::vector<double> station_parameters(const Surface_path& path, const std::vector<double>& given) {
  const std::size_t n = path.stations.size();
  std::vector<double> result(n, 0);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::size_t next = (i + 1) % given.size();
    const std::size_t first = path.station_of[i];
    const std::size_t steps = (path.station_of[next] + n - first) % n;
    const double to = next == 0 ? given[0] + 1 : given[next];
    std::vector<double> length{0};
    for (std::size_t k = 0; k < steps; ++k)
      length.push_back(length.back() +
                       (path.stations[(first + k + 1) % n].point - path.stations[(first + k) % n].point).norm());
    for (std::size_t k = 0; k < steps; ++k)
      result[(first + k) % n] = given[i] + (to - given[i]) * (length[k] / length.back());
  }
  for (double& s : result) s -= std::floor(s);
  return result;
}

Diagnosis lay_rim(Bridge_side& side, const Bridge_options& options) {
  std::vector<double> parameters = sample_contact(side, options);
  for (int attempt = 0; attempt < most_repairs; ++attempt) {
    std::vector<Surface_point> points;
    for (const double s : parameters) {
      const auto at = side.polar->locate(side.curve(s));
      if (!at) return refusal(Status::region_meets_border, side.contact(s));
      points.push_back({at->face, Eigen::Vector3d(at->weights[0], at->weights[1], at->weights[2])});
    }
    std::size_t stuck = 0;
    auto path = closed_path(*side.surface, points, snap_of_size * side.size, stuck, true);
    if (path && path->stations.size() >= 3) {
      side.parameters = station_parameters(*path, parameters);
      side.rim.surface = side.surface;
      side.rim.path = std::move(*path);
      side.rim.keep_left = false;
      return {};
    }
    divide_before(parameters, path ? 0 : stuck);
  }
  return refusal(Status::curve_crosses_itself, side.contact(0));
}

double mean_edge(const Bridge_side& side) {
  const Blend_mesh& mesh = side.surface->mesh();
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < fewest_points; ++i) {
    const double s = static_cast<double>(i) / fewest_points;
    const Polar_point at = side.curve(s);
    for (const double part : {0.5, 1.0}) {
      const auto place = side.polar->locate({part * at.distance, at.angle});
      if (!place) continue;
      for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(place->face))) {
        sum += (to_vec(mesh.point(mesh.target(h))) - to_vec(mesh.point(mesh.source(h)))).norm();
        ++count;
      }
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : side.size;
}

/// True if there are coordinates all over the region.
bool is_covered(const Bridge_side& side) {
  constexpr int directions = 128, steps = 8;
  for (int i = 0; i < directions; ++i) {
    const Polar_point at = side.curve(static_cast<double>(i) / directions);
    for (int k = 1; k <= steps; ++k)
      if (!side.lifter().lifted(Polar_point{at.distance * k / steps, at.angle})) return false;
  }
  return true;
}

/// What follows once the curve is known to be sound and there are coordinates.
void finish_side(Bridge_side& side, const Bridge_options& options) {
  side.diagnosis = side.polar->diagnosis();
  if (!side.diagnosis.ok()) return;
  if (!is_covered(side)) {
    side.diagnosis.status = Status::radius_exceeds_cut_locus;
    return;
  }
  // Nearer than facets, knots tell nothing more; nor do they far below the length of chords within the tolerance.
  side.step = std::max(mean_edge(side), knot_spacing * std::sqrt(8 * options.chord_tolerance) * side.size);
  side.diagnosis = lay_rim(side, options);
}

Bridge_side begin_side(const Base_surface& surface, const Bridge_end& end, bool round_point) {
  Bridge_side side;
  side.surface = &surface;
  side.curve = curve_of(end);
  const Curve_check check = check_curve(side.curve, round_point);
  side.diagnosis = check.diagnosis;
  side.size = check.largest;
  if (!side.diagnosis.ok() && !side.diagnosis.point && round_point) side.diagnosis.point = end.spot;
  return side;
}

}  // namespace

Vec Bridge_side::contact(double s) const {
  const Polar_point end = curve(s);
  for (const double part : {1.0, 1 - 1e-6, 1 - 1e-3, 0.9})  // coordinates may have a gap at their border
    if (const auto at = polar->locate({part * end.distance, end.angle})) return to_vec(position(surface->mesh(), *at));
  return to_vec(polar->point({0, end.angle}));
}

Vec Bridge_side::near_contact(double s, double x, const Vec& place) const {
  const Polar_point end = curve(s);
  const auto from = lifter().lifted(end), to = lifter().lifted(Polar_point{x * end.distance, end.angle});
  return from && to ? Vec(place + *to - *from) : place;
}

double Bridge_side::tangency_deg() const {
  constexpr int samples = 64;
  constexpr double step = 1e-3;  // of the parameter, for the tangent of the contact curve
  double largest = 0;
  for (int i = 0; i < samples; ++i) {
    const double s = (i + 0.5) / samples;
    const auto at = polar->locate(curve(s));
    if (!at) continue;
    const Vec along = contact(s + step) - contact(s - step), inward = ray(s).derivative(1);
    const Vec normal = surface->normal({at->face, Eigen::Vector3d(at->weights[0], at->weights[1], at->weights[2])});
    const double angle = angle_between(along.cross(inward), normal);
    largest = std::max(largest, std::min(angle, pi - angle));
  }
  return largest * 180 / pi;
}

Bridge_side make_side(const Base_surface& surface, const Bridge_end& end, const Bridge_options& options) {
  Bridge_side side = begin_side(surface, end, true);
  if (!side.diagnosis.ok()) return side;
  const Nearest_face nearest = nearest_face(surface.mesh(), end.spot);
  if (nearest.distance > spot_tolerance * nearest.diagonal) {
    std::ostringstream text;
    text << "the nearest point of the mesh is " << nearest.distance << " away";
    side.diagnosis = {Status::spot_off_surface, text.str(), end.spot, {}};
    return side;
  }
  const Surface_point at = surface.locate(nearest.face, to_vec(end.spot));
  side.polar =
      std::make_unique<Geodesic_polar>(surface.mesh(), Face_point{at.face, {at.bary[0], at.bary[1], at.bary[2]}},
                                       reach * side.size, Geodesic_polar_options{end.zero_direction});
  finish_side(side, options);
  return side;
}

Bridge_side make_side(const Base_surface& surface, const std::vector<Face_point>& source, const Bridge_end& end,
                      const Bridge_options& options) {
  Bridge_side side = begin_side(surface, end, false);
  if (!side.diagnosis.ok()) return side;
  // Along a curve and away from it to the left is the other way round than outward and counter-clockwise round a point.
  side.curve = [along = side.curve](double s) { return along(1 - s); };
  side.polar = std::make_unique<Geodesic_polar>(surface.mesh(), source, reach * side.size);
  finish_side(side, options);
  return side;
}

Diagnosis check_options(const std::array<Bridge_end, 2>& ends, const Bridge_options& options) {
  const auto bad = [](const std::string& what) { return Diagnosis{Status::invalid_parameter, what, {}, {}}; };
  for (const Bridge_end& end : ends) {
    if (!(end.lambda >= 0 && end.lambda < 1)) return bad("lambda must lie in [0, 1)");
    if (!std::isfinite(end.spot.x() + end.spot.y() + end.spot.z())) return bad("the spot must be finite");
    if (!end.curve && !(end.radius > 0 && std::isfinite(end.radius))) return bad("the radius must be greater than 0");
    if (end.zero_direction && !(end.zero_direction->squared_length() > 0))
      return bad("the zero direction must not be 0");
  }
  if (!(options.mu > 0 && options.mu < 1)) return bad("mu must lie in (0, 1)");
  if (options.order < 1 || options.order > 3) return bad("the order must be 1, 2 or 3");
  if (!std::isfinite(options.twist_deg)) return bad("the twist must be finite");
  if (!(options.chord_tolerance >= 1e-5 && options.chord_tolerance <= 0.1))
    return bad("the chord tolerance must lie between 1e-5 and 0.1");
  if (options.segments != 0 && (options.segments < 3 || options.segments > most_facets))
    return bad("there must be 3 to 4096 segments");
  if (options.rows != 0 && (options.rows < 2 || options.rows > most_facets)) return bad("there must be 2 to 4096 rows");
  if (!(options.smooth_angle > 0 && options.smooth_angle < 180))
    return bad("the smooth angle must lie between 0 and 180 degrees");
  return {};
}

}  // namespace cgal_blend
