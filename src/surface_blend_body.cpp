// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/surface_blend_body.h>

#include "mesh_checks.h"
#include "soup_to_mesh.h"
#include "surface_blend_tessellation.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace cgal_blend {

namespace {

constexpr int box_samples = 32;

double diagonal_of_curves(const std::vector<Body_blend>& blends) {
  CGAL::Bbox_3 box;
  for (const Body_blend& b : blends)
    for (int i = 0; i <= box_samples; ++i)
      for (int side = 0; side < 2; ++side)
        box += b.blend.curve(side).at(static_cast<double>(i) / box_samples).point.bbox();
  return std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin()) +
                   CGAL::square(box.zmax() - box.zmin()));
}

/// Builds the soup of a body; parts are numbered surfaces first, then blends, then one for all caps.
class Body_builder {
 public:
  Body_builder(const std::vector<Trimmed_surface>& surfaces, const std::vector<Body_blend>& blends,
               const Blend_body_options& options)
      : surfaces_(surfaces), blends_(blends), options_(options) {}

  Diagnosis build() {
    if (!(options_.chord_tolerance >= 1e-6 && options_.chord_tolerance <= 0.1))
      return {Status::invalid_parameter, "the chord tolerance must lie between 1e-6 and 0.1", {}, {}};
    if (blends_.empty()) return {Status::no_boundary_curve, "there is no blend", {}, {}};
    const double tolerance = options_.chord_tolerance * diagonal_of_curves(blends_);
    std::vector<std::vector<Trim_curve>> curves(surfaces_.size());
    for (std::size_t b = 0; b < blends_.size(); ++b) {
      const auto ends = tessellate(blends_[b].blend, {tolerance, static_cast<int>(surfaces_.size() + b)}, soup_);
      for (std::size_t side = 0; side < 2; ++side) {
        if (blends_[b].surfaces[side] >= surfaces_.size())
          return {Status::invalid_parameter, "a blend joins a surface that is not there", {}, {}};
        curves[blends_[b].surfaces[side]].push_back(ends[side]);
        curves[blends_[b].surfaces[side]].back().slot = blends_[b].slots[side];
      }
    }
    Rims rims;
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
      if (Diagnosis bad = surfaces_[i](curves[i], {tolerance, static_cast<int>(i)}, soup_, rims); !bad.ok()) {
        bad.detail = "surface " + std::to_string(i + 1) + (bad.detail.empty() ? "" : ": ") + bad.detail;
        return bad;
      }
    return finish(rims);
  }

  [[nodiscard]] const Triangle_soup& soup() const { return soup_; }
  [[nodiscard]] int cap_part() const { return static_cast<int>(surfaces_.size() + blends_.size()); }

 private:
  Diagnosis finish(const Rims& rims) {
    for (const Point_3& p : soup_.points)  // formulas need not be finite everywhere
      if (!std::isfinite(p.x() + p.y() + p.z()))
        return {Status::input_not_finite, "a surface leaves the finite", {}, {}};
    if (options_.capped && !(options_.thickness > 0))
      for (const auto& rim : rims)
        if (!fill(rim, cap_part(), soup_))
          return {
              Status::surface_not_bounded, "an end is not planar, so it cannot be capped", soup_.points[rim[0]], {}};
    if (!orient(soup_)) return {Status::result_invalid, "parts do not fit together", {}, {}};
    if (options_.thickness > 0) thicken(options_.thickness, cap_part(), soup_);
    return {};
  }

  const std::vector<Trimmed_surface>& surfaces_;
  const std::vector<Body_blend>& blends_;
  const Blend_body_options& options_;
  Triangle_soup soup_;
};

Face_label label_of(int part, std::size_t surfaces, std::size_t blends) {
  const std::size_t number = static_cast<std::size_t>(part);
  if (number < surfaces) return {Face_label::Kind::surface, number};
  if (number < surfaces + blends) return {Face_label::Kind::blend, number - surfaces};
  return {Face_label::Kind::cap, 0};
}

std::string words(const Face_label& label) {
  return label.kind == Face_label::Kind::cap ? "a cap" : name(label.kind) + (" " + std::to_string(label.index + 1));
}

/// Names the two parts that cut each other, if any do.
Diagnosis collision(const Blend_body& body) {
  const auto pairs = internal::intersecting_pairs(body.mesh);
  if (pairs.empty()) return {};
  const auto& [f, g] = pairs.front();
  const Face_label &a = body.labels[f], &b = body.labels[g];
  const bool same = a.kind == b.kind && a.index == b.index;
  return {Status::blend_collides,
          same ? words(a) + " cuts through itself" : words(a) + " and " + words(b) + " cut each other",
          internal::meeting_point(body.mesh, pairs.front()),
          {}};
}

}  // namespace

const char* name(Face_label::Kind kind) noexcept {
  switch (kind) {
    case Face_label::Kind::surface: return "surface";
    case Face_label::Kind::blend: return "blend";
    case Face_label::Kind::cap: return "cap";
  }
  return "";
}

Blend_body make_blend_body(const std::vector<Trimmed_surface>& surfaces, const std::vector<Body_blend>& blends,
                           const Blend_body_options& options) {
  Blend_body body;
  Body_builder builder(surfaces, blends, options);
  if (body.diagnosis = builder.build(); !body.ok()) return body;
  Triangle_soup soup = builder.soup();
  auto mesh = to_mesh(soup);
  if (mesh && CGAL::is_closed(*mesh)) {
    body.closed = true;
    if (signed_volume(soup) < 0) {
      reverse(soup);
      mesh = to_mesh(soup);
    }
  }
  if (!mesh) {
    body.diagnosis = {Status::result_invalid, "parts do not fit together", {}, {}};
    return body;
  }
  body.mesh = std::move(*mesh);
  for (const int part : soup.parts) body.labels.push_back(label_of(part, surfaces.size(), blends.size()));
  if (body.diagnosis = collision(body); !body.ok()) return body;
  if (body.closed) {
    body.validity = validate(body.mesh);
    body.diagnosis = body.validity.diagnosis;
    if (!body.ok()) body.diagnosis.status = Status::result_invalid;
  }
  return body;
}

}  // namespace cgal_blend
