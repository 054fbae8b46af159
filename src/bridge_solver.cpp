// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include "bodies_cross.h"
#include "bridge_assembly.h"
#include "stopwatch.h"

#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <utility>

namespace cgal_blend {

namespace {

constexpr std::size_t twist_samples = 256;

std::vector<Vec> sampled(const Bridge_side& side) {
  std::vector<Vec> points;
  for (std::size_t i = 0; i < twist_samples; ++i)
    points.push_back(side.contact(static_cast<double>(i) / twist_samples));
  return points;
}

}  // namespace

struct Bridge_solver::Impl {
  Impl(const Blend_mesh& input, const std::array<Bridge_end, 2>& given, const Bridge_options& options)
      : filled(filled_if(input, options)),
        mesh(filled ? filled->mesh : input),
        ends(given),
        options(options),
        surface(mesh, surface_options(options)) {
    const Stopwatch watch;
    diagnosis = check_options(ends, options);
    if (diagnosis.ok() && filled) diagnosis = filled->diagnosis;
    if (diagnosis.ok() && filled) unchecked::move_spots_to_fillings(*filled, ends);
    for (std::size_t k = 0; k < 2 && diagnosis.ok(); ++k) {
      sides[k] = make_side(surface, ends[k], options);
      diagnosis = sides[k].diagnosis;
      if (!diagnosis.ok()) diagnosis.detail = (k == 0 ? "first end" : "second end") + detail_of(diagnosis);
    }
    if (diagnosis.ok()) {
      shape = {{ends[0].lambda, ends[1].lambda}, options.mu, options.order};
      const bool joined = !options.least_twist || (ends[0].zero_direction && ends[1].zero_direction);
      matched = joined ? 0 : least_twist(sampled(sides[0]), sampled(sides[1]));
      make_grid();
    }
    parametrize = watch.milliseconds();
  }

  static std::optional<Filled_mesh> filled_if(const Blend_mesh& mesh, const Bridge_options& options) {
    if (!options.fill_holes || CGAL::is_closed(mesh)) return std::nullopt;
    return fill_mesh(mesh);
  }

  static Base_surface::Options surface_options(const Bridge_options& options) {
    Base_surface::Options result;
    result.smooth_angle = options.smooth_angle;
    return result;
  }

  static std::string detail_of(const Diagnosis& diagnosis) {
    return diagnosis.detail.empty() ? "" : ": " + diagnosis.detail;
  }

  [[nodiscard]] double turn() const { return matched + options.twist_deg / 360; }

  void make_grid() { grid.emplace(std::array<const Bridge_side*, 2>{&sides[0], &sides[1]}, turn(), shape, options); }

  [[nodiscard]] Bridge_report report() const {
    Bridge_report result;
    result.segments = grid->s().size();
    result.rows = grid->t().size() - 1;
    result.turn_deg = 360 * (turn() - std::floor(turn()));
    result.tangency_deg = std::max(sides[0].tangency_deg(), sides[1].tangency_deg());
    result.lambda = shape.lambda;
    result.safe_radius = {sides[0].polar->safe_radius(), sides[1].polar->safe_radius()};
    return result;
  }

  std::optional<Filled_mesh> filled;  // if the input has holes
  const Blend_mesh& mesh;
  std::array<Bridge_end, 2> ends;
  Bridge_options options;
  Base_surface surface;
  Diagnosis diagnosis;
  std::array<Bridge_side, 2> sides;
  Bridge_shape shape;
  double matched = 0;  // turn of least twist
  std::optional<Bridge_grid> grid;
  std::optional<Bridge_cut> cut;  // when it is first needed
  double parametrize = 0;         // milliseconds
};

Bridge_solver::Bridge_solver(const Blend_mesh& mesh, const std::array<Bridge_end, 2>& ends,
                             const Bridge_options& options)
    : impl_(std::make_unique<Impl>(mesh, ends, options)) {}
Bridge_solver::~Bridge_solver() = default;
Bridge_solver::Bridge_solver(Bridge_solver&&) noexcept = default;
Bridge_solver& Bridge_solver::operator=(Bridge_solver&&) noexcept = default;

const Diagnosis& Bridge_solver::diagnosis() const { return impl_->diagnosis; }
const std::array<double, 2>& Bridge_solver::lambda() const { return impl_->shape.lambda; }
const std::vector<Point_3>& Bridge_solver::points() const { return impl_->grid->points(); }
std::size_t Bridge_solver::segments() const { return impl_->grid->s().size(); }
std::size_t Bridge_solver::rows() const { return impl_->grid->t().size() - 1; }

bool Bridge_solver::set_lambda(int end, double lambda) {
  if (end < 0 || end > 1 || !(lambda >= 0 && lambda < 1)) return false;
  impl_->shape.lambda[static_cast<std::size_t>(end)] = lambda;
  impl_->grid->evaluate(impl_->shape);
  return true;
}

bool Bridge_solver::set_mu(double mu) {
  if (!(mu > 0 && mu < 1)) return false;
  impl_->shape.mu = mu;
  impl_->grid->evaluate(impl_->shape);
  return true;
}

bool Bridge_solver::set_order(int order) {
  if (order < 1 || order > 3) return false;
  impl_->shape.order = order;
  impl_->grid->evaluate(impl_->shape);
  return true;
}

bool Bridge_solver::set_twist(double degrees) {
  if (!std::isfinite(degrees)) return false;
  impl_->options.twist_deg = degrees;
  impl_->grid->turn_to(impl_->turn(), impl_->shape);
  return true;
}

Point_3 Bridge_solver::point(double s, double t) const {
  return to_point(impl_->grid->column(s).point(t, impl_->shape));
}

Drag Bridge_solver::drag(double s, double t, const Point_3& target) {
  const Bridge_column column = impl_->grid->column(s);
  Drag result;
  result.lambda = nearest_lambdas(column, t, impl_->shape, to_vec(target));
  impl_->shape.lambda = result.lambda;
  result.residual = (column.point(t, impl_->shape) - to_vec(target)).norm();
  result.reached = result.residual <= drag_tolerance * impl_->grid->size();
  impl_->grid->evaluate(impl_->shape);
  return result;
}

Bridge_outcome Bridge_solver::build(Blend_mesh& out) const {
  Bridge_outcome outcome;
  out.clear();
  if (!impl_->diagnosis.ok()) {
    outcome.diagnosis = impl_->diagnosis;
    return outcome;
  }
  const Stopwatch watch;
  if (!impl_->cut) impl_->cut = cut_spots(impl_->mesh, {&impl_->sides[0], &impl_->sides[1]});
  if (impl_->cut->diagnosis.ok())
    outcome = sew({&impl_->mesh, {}, {}, bodies_may_cross(impl_->mesh)}, *impl_->cut,
                  take_mesh(*impl_->cut, impl_->mesh), {&*impl_->grid}, out);
  else
    outcome.diagnosis = impl_->cut->diagnosis;
  if (outcome.ok() && impl_->filled)
    if (Diagnosis left = unchecked::check_fillings(*impl_->filled, outcome.origins, {impl_->ends[0], impl_->ends[1]});
        !left.ok()) {
      outcome = {};
      outcome.diagnosis = std::move(left);
      out.clear();
    }
  outcome.bridges.push_back(impl_->report());
  outcome.bridges.back().diagnosis = outcome.diagnosis;
  outcome.times.trim = watch.milliseconds() - outcome.times.validate;
  outcome.times.parametrize = impl_->parametrize;
  return outcome;
}

}  // namespace cgal_blend
