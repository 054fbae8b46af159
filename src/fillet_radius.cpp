// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_radius.h"

#include "refusal.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace cgal_blend {

namespace {

/// A curve of a blend: its branch, how far along it each halfedge begins, as fractions, and its radius.
class Curve {
 public:
  Curve(const Blend_mesh& mesh, Branch<Blend_mesh> branch) : mesh_(mesh), branch_(std::move(branch)) {
    for (const Halfedge h : branch_.halfedges) {
      begins_.push_back(length_);
      length_ += length_of(h);
    }
    begins_.push_back(length_);
    for (double& begin : begins_) begin /= length_;
  }

  [[nodiscard]] const std::vector<Halfedge>& halfedges() const { return branch_.halfedges; }
  [[nodiscard]] bool closed() const { return branch_.closed(); }

  /// Fraction at which a vertex lies, or nothing: of an open curve only its ends count.
  [[nodiscard]] std::optional<double> fraction_at(Vertex v) const {
    const auto is_there = [&](Halfedge h) { return mesh_.source(h) == v; };
    const auto found = std::find_if(halfedges().begin(), halfedges().end(), is_there);
    if (found == halfedges().begin()) return 0;
    if (!closed() && mesh_.target(halfedges().back()) == v) return 1;
    if (!closed() || found == halfedges().end()) return std::nullopt;
    return begins_[static_cast<std::size_t>(found - halfedges().begin())];
  }

  /// The part of a law of the curve that belongs to a branch along it, whose first edge is edge i of the curve.
  [[nodiscard]] Radius_law part(const Radius_law& law, const Branch<Blend_mesh>& branch, std::size_t i) const {
    if (branch.halfedges == halfedges()) return law;
    double length = 0;
    for (const Halfedge h : branch.halfedges) length += length_of(h);
    const bool forward = branch.halfedges.front() == branch_.halfedges[i];
    const double from = begins_[forward ? i : i + 1], share = length / length_;
    return law.restricted(from, forward ? from + share : from - share);
  }

 private:
  [[nodiscard]] double length_of(Halfedge h) const {
    return std::sqrt(CGAL::squared_distance(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h))));
  }

  const Blend_mesh& mesh_;
  Branch<Blend_mesh> branch_;
  std::vector<double> begins_;
  double length_ = 0;
};

Diagnosis wrong_at(const Blend_mesh& mesh, Vertex v, const char* what) {
  Diagnosis diagnosis = refusal(Status::invalid_parameter, to_vec(mesh.point(v)));
  diagnosis.detail = what;
  return diagnosis;
}

}  // namespace

Radius_law radius_law_of(const Edge_blend& blend, const Fillet_options& options) {
  if (blend.law) return *blend.law;
  if (blend.radius != 0 || !options.law) return blend.radius != 0 ? blend.radius : options.radius;
  return *options.law;
}

Branch_laws laws_along(const Blend_mesh& mesh, const Curve_network<Blend_mesh>& network, const Edge_blend& blend,
                       const Fillet_options& options) {
  const Radius_law law = radius_law_of(blend, options);
  Branch_laws result;
  result.diagnosis = law.check();
  if (!result.diagnosis.ok()) return result;
  std::vector<Curve> curves;
  std::vector<Radius_law> laws;  // of the curves
  std::unordered_map<Edge, std::pair<std::size_t, std::size_t>> places;
  bool start_is_found = !blend.start;
  Curve_network<Blend_mesh> whole = make_curve_network(mesh, blend.edges);
  for (Branch<Blend_mesh>& branch : whole.branches) {
    const Curve& curve = curves.emplace_back(mesh, std::move(branch));
    for (std::size_t i = 0; i < curve.halfedges().size(); ++i)
      places.emplace(mesh.edge(curve.halfedges()[i]), std::pair(curves.size() - 1, i));
    const std::optional<double> found = blend.start ? curve.fraction_at(*blend.start) : std::nullopt;
    const double start = found.value_or(0);
    start_is_found = start_is_found || found;
    if (curve.closed() && !law.is_periodic()) {
      const Vertex at = found ? *blend.start : mesh.source(curve.halfedges().front());
      result.diagnosis = wrong_at(mesh, at, "on a closed curve the radius must end as it begins");
      return result;
    }
    if (curve.closed())
      laws.push_back(law.with_period().shifted(-start));
    else
      laws.push_back(start > 0 ? law.reversed() : law);
  }
  if (!start_is_found) {
    result.diagnosis =
        wrong_at(mesh, *blend.start, "the radius must start at an end of an open curve or on a closed one");
    return result;
  }
  for (const Branch<Blend_mesh>& branch : network.branches) {
    const auto [c, i] = places.at(mesh.edge(branch.halfedges.front()));
    result.laws.push_back(curves[c].part(laws[c], branch, i));
  }
  return result;
}

}  // namespace cgal_blend
