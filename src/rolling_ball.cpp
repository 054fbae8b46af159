// SPDX-License-Identifier: GPL-3.0-or-later
#include "rolling_ball.h"

#include "ball_solver.h"
#include "refusal.h"
#include "spine_guess.h"
#include "spine_loops.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr double widest_gap = 3;  // of the coarsest step: farther apart, positions are not joined
constexpr int deepest_split = 12;
constexpr double most_guesses = 100;  // along a curve: with smaller balls, only where it bends are they closer
constexpr std::size_t fewest_positions = 6;
constexpr std::size_t fewest_open_positions = 2;
constexpr std::size_t most_loops = 64;
constexpr double least_opening = 0.2;  // radii between contacts beyond a round
constexpr double round_bend = 0.5;     // curvature times radius: more belongs to a round

/// Contacts must go forward with the centre, or the profiles of neighbours would cross.
bool goes_forward(const Ball_position& a, const Ball_position& b) {
  if (a.mended || b.mended) return true;  // nearest points may rest, or jump over what the ball does not reach
  const Vec step = b.center - a.center;
  const double least = 0.02 * step.squaredNorm();
  return step.squaredNorm() > 0 && (b.contact[0] - a.contact[0]).dot(step) > least &&
         (b.contact[1] - a.contact[1]).dot(step) > least;
}

double step_length(const Ball_position& a, const Ball_position& b) {
  return std::max(
      {(b.center - a.center).norm(), (b.contact[0] - a.contact[0]).norm(), (b.contact[1] - a.contact[1]).norm()});
}

double chord_error(const Ball_position& a, const Ball_position& b, const Ball_position& middle) {
  return std::max({off_segment(a.center, b.center, middle.center),
                   off_segment(a.contact[0], b.contact[0], middle.contact[0]),
                   off_segment(a.contact[1], b.contact[1], middle.contact[1])});
}

/// A contact on a surface that bends nearly as the ball does: still on the round that is to be sharpened.
std::optional<Vec> contact_on_round(const std::vector<Ball_position>& positions,
                                    const std::array<const Base_surface*, 2>& surfaces, double radius) {
  for (const Ball_position& p : positions) {
    if ((p.contact[0] - p.contact[1]).norm() < least_opening * radius) return p.contact[0];  // in the curve itself
    const std::array<Vec, 2> arm{p.contact[0] - p.center, p.contact[1] - p.center};
    for (int side = 0; side < 2; ++side) {
      const Vec across = arm[0].cross(arm[1]).cross(arm[side]).stableNormalized();
      if (curvature_towards_ball(*surfaces[side], p.foot[side], arm[side], across) * radius > round_bend)
        return p.contact[side];
    }
  }
  return std::nullopt;
}

class Roller {
 public:
  Roller(const Ball_solver& solver, const Sampling& sampling, bool closed = true)
      : solver_(solver), sampling_(sampling), closed_(closed) {}

  /// \param locator of a closed curve, which the ball must go round once
  Ball_path roll(const std::vector<Ball_guess>& guesses, const Curve_locator* locator) {
    blocked_.reset();
    Ball_path path;
    std::vector<Ball_position> positions = solve_all(guesses);
    if (!closed_) drop_strays(positions, guesses);
    if (const auto bad = cut_loops(positions, path.loops)) return *bad;
    drop_backward(positions);
    if (positions.size() < (closed_ ? fewest_positions : fewest_open_positions)) return failed(guesses.front().point);
    if (const auto gap = find_gap(positions)) return failed(*gap);
    if (locator) {
      std::vector<Vec> centers;
      for (const Ball_position& p : positions) centers.push_back(p.center);
      if (turns_along(centers, *locator) != 1) return failed(positions.front().center);
    }
    blocked_.reset();  // bad guesses may run into an edge where the ball does not; between good positions it counts
    for (std::size_t i = 0; i < positions.size(); ++i) {
      path.positions.push_back(positions[i]);
      if (closed_ || i + 1 < positions.size())
        split(positions[i], positions[(i + 1) % positions.size()], 0, path.positions);
    }
    if (blocked_) return failed(*blocked_);
    drop_backward(path.positions);
    if (const auto bad = cut_loops(path.positions, path.loops)) return *bad;
    return path;
  }

 private:
  std::vector<Ball_position> solve_all(const std::vector<Ball_guess>& guesses) {
    std::vector<Ball_position> positions;
    for (const Ball_guess& guess : guesses) {
      Ball_solution solution = solver_.solve(guess);
      if (!solution.position && !positions.empty()) {  // from the neighbour's feet instead
        Ball_guess again = guess;
        again.foot = positions.back().foot;
        const Ball_solution second = solver_.solve(again);
        if (second.position || !solution.blocked) solution = second;
      }
      const double limit = widest_gap * sampling_.coarsest * solver_.radius();
      if (solution.position && (solution.position->center - guess.point).norm() > limit) solution.position.reset();
      if (solution.position)
        positions.push_back(*solution.position);
      else if (solution.blocked && !blocked_)
        blocked_ = solution.blocked;
      else if (!failure_)
        failure_ = guess.point;
    }
    return positions;
  }

  /// Mends a spine that crosses itself; returns the refusal if that is not possible or not wanted.
  std::optional<Ball_path> cut_loops(std::vector<Ball_position>& positions, std::size_t& loops) const {
    if (!closed_) return std::nullopt;
    const std::array<const Base_surface*, 2> surfaces{&solver_.surface(0), &solver_.surface(1)};
    const double radius = solver_.radius();
    for (std::size_t round = 0; round < most_loops; ++round) {
      auto crossing = find_crossing(positions, radius);
      if (!crossing) crossing = find_trimmed_loop(positions, surfaces, radius);
      if (!crossing) return std::nullopt;
      std::optional<std::vector<Ball_position>> mended;
      if (sampling_.mend_loops)
        mended = cut_loop(positions, *crossing, surfaces, radius, 2 * sampling_.finest * radius);
      if (!mended) {
        Ball_path path;
        path.diagnosis = refusal(Status::radius_exceeds_curvature, crossing->point);
        return path;
      }
      positions = std::move(*mended);
      ++loops;
    }
    return std::nullopt;
  }

  /// Beyond the ends of a curve guesses may have no solution, or lead astray; what hangs together counts.
  void drop_strays(std::vector<Ball_position>& positions, const std::vector<Ball_guess>& guesses) const {
    if (positions.empty()) return;
    const Vec& middle = guesses[guesses.size() / 2].point;
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < positions.size(); ++i)
      if ((positions[i].center - middle).norm() < (positions[nearest].center - middle).norm()) nearest = i;
    const double limit = widest_gap * sampling_.coarsest * solver_.radius();
    const auto joined = [&](std::size_t i) {
      return (positions[i + 1].center - positions[i].center).norm() <= limit &&
             goes_forward(positions[i], positions[i + 1]);
    };
    std::size_t first = nearest, last = nearest;
    while (first > 0 && joined(first - 1)) --first;
    while (last + 1 < positions.size() && joined(last)) ++last;
    positions = std::vector<Ball_position>(positions.begin() + static_cast<std::ptrdiff_t>(first),
                                           positions.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  }

  void drop_backward(std::vector<Ball_position>& positions) const {
    for (bool changed = true; changed && positions.size() >= fewest_positions;) {
      changed = false;
      std::vector<Ball_position> kept{positions.front()};
      for (std::size_t i = 1; i < positions.size(); ++i) {
        if (goes_forward(kept.back(), positions[i]))
          kept.push_back(positions[i]);
        else
          changed = true;
      }
      while (closed_ && kept.size() >= fewest_positions && !goes_forward(kept.back(), kept.front())) {
        kept.pop_back();
        changed = true;
      }
      positions = std::move(kept);
    }
  }

  std::optional<Vec> find_gap(const std::vector<Ball_position>& positions) const {
    const double across = (positions.front().center - positions[positions.size() / 2].center).norm();
    const double step = sampling_.coarsest * solver_.radius();
    const double limit = closed_ ? std::min(widest_gap * step, std::max(step, across / 2)) : widest_gap * step;
    for (std::size_t i = 0; i + (closed_ ? 0 : 1) < positions.size(); ++i) {
      const Ball_position& a = positions[i];
      const Ball_position& b = positions[(i + 1) % positions.size()];
      if ((b.center - a.center).norm() > limit) return (a.center + b.center) / 2;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_fine(const Ball_position& a, const Ball_position& b, const Ball_position& middle) const {
    const double length = step_length(a, b), error = chord_error(a, b, middle);
    if (sampling_.samples == 0 && length > sampling_.coarsest * solver_.radius()) return false;
    if (sampling_.chord_ratio > 0) return error <= sampling_.chord_ratio * length;
    return sampling_.samples > 0 || error <= sampling_.tolerance * solver_.radius();
  }

  void split(const Ball_position& a, const Ball_position& b, int depth, std::vector<Ball_position>& out) {
    const double radius = solver_.radius();
    const double length = step_length(a, b);
    if (a.mended || b.mended || depth >= deepest_split || length < 2 * sampling_.finest * radius) return;
    // Where the radius varies the spine is slanted against the planes in which the law holds.
    const Vec across = solver_.is_constant() ? Vec(b.center - a.center) : Vec(a.across + b.across);
    const double ahead = b.fraction < a.fraction ? b.fraction + 1 : b.fraction;  // once round
    const Ball_guess guess{(a.center + b.center) / 2, across.normalized(), a.foot, (a.fraction + ahead) / 2};
    Ball_solution solution = solver_.solve(guess);
    if (!solution.position) {
      const std::optional<Vec> blocked = solution.blocked;
      solution = solver_.solve({guess.point, guess.direction, b.foot, guess.fraction});
      if (!solution.position && !solution.blocked) solution.blocked = blocked;
    }
    if (!solution.position) {
      if (solution.blocked) blocked_ = solution.blocked;
      return;
    }
    if (length < 2 * sampling_.spacing * radius) return;
    const Ball_position middle = *solution.position;
    if (!goes_forward(a, middle) || !goes_forward(middle, b)) return;
    if (step_length(a, middle) > 2 * length || step_length(middle, b) > 2 * length) return;
    if (is_fine(a, b, middle)) return;
    split(a, middle, depth + 1, out);
    out.push_back(middle);
    split(middle, b, depth + 1, out);
  }

  Ball_path failed(const Vec& at) const {
    Ball_path path;
    path.diagnosis = blocked_ ? refusal(Status::radius_exceeds_face, *blocked_)
                              : refusal(Status::no_rolling_ball, failure_.value_or(at));
    return path;
  }

  const Ball_solver& solver_;
  const Sampling& sampling_;
  bool closed_;
  std::optional<Vec> blocked_, failure_;
};

double mean_step(const std::vector<Ball_guess>& guesses) {
  double length = 0;
  for (std::size_t i = 0; i < guesses.size(); ++i)
    length += (guesses[(i + 1) % guesses.size()].point - guesses[i].point).norm();
  return length / static_cast<double>(guesses.size());
}

/// The longest step on a curve that is so long against the ball that there would be too many.
double coarsest_on(const Blend_curve& curve, double coarsest, double radius) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) length += (curve.points[i + 1] - curve.points[i]).norm();
  return std::max(coarsest, length / (most_guesses * radius));
}

/// Loops of an open spine are not mended, but found by the folds of the blend.
Ball_path roll_open(const Ball_solver& solver, const Blend_curve& curve, const Sampling& sampling) {
  const double radius = solver.radius();
  const std::vector<Ball_guess> guesses =
      guess_from_wedges(solver, curve, {sampling.coarsest * radius, sampling.samples, curve.overhang});
  Sampling steps = sampling;
  if (sampling.samples > 0) steps.coarsest = mean_step(guesses) / radius;
  return Roller(solver, steps, false).roll(guesses, nullptr);
}

}  // namespace

double curvature_towards_ball(const Base_surface& surface, const Surface_point& foot, const Vec& arm,
                              const Vec& along) {
  const double towards = surface.normal(foot).dot(arm) < 0 ? -1 : 1;  // a convex surface bends towards a ball inside it
  return towards * surface.normal_curvature(foot, along);
}

Sampling sampling(double chord_tolerance) {
  const double facet = 2 * std::sin(std::acos(1 - chord_tolerance));
  return {chord_tolerance, facet, std::min(6 * facet, std::max(1.0, 2 * facet)), facet};
}

Ball_path roll_ball(const std::array<const Base_surface*, 2>& surfaces, const Blend_curve& curve, Curve_kind kind,
                    const Radius_law& law, const Sampling& wanted) {
  const Ball_solver solver(surfaces, law, curve.convex);
  const double radius = law.largest();
  Sampling sampling = wanted;
  sampling.coarsest = coarsest_on(curve, wanted.coarsest, radius);
  if (!curve.closed) return roll_open(solver, curve, sampling);
  const Curve_locator locator(curve.points);
  const Guess_spacing spacing{sampling.coarsest * radius, sampling.samples};
  const auto roll = [&](const std::vector<Ball_guess>& guesses) {
    Sampling steps = sampling;
    if (sampling.samples > 0) steps.coarsest = mean_step(guesses) / radius;
    return Roller(solver, steps).roll(guesses, &locator);
  };
  if (kind == Curve_kind::round) {
    Ball_path path = roll(guess_beyond_round(solver, curve, spacing));
    if (path.diagnosis.ok())
      if (const auto at = contact_on_round(path.positions, surfaces, radius)) {
        path.diagnosis = refusal(Status::no_rolling_ball, *at);
        path.diagnosis.detail = "the radius is too small to reach beyond the round";
      }
    return path;
  }
  std::vector<Ball_guess> guesses;
  if (law.is_constant()) guesses = guess_from_offsets(solver, curve, locator, spacing);
  if (!guesses.empty()) {
    Ball_path path = roll(guesses);
    if (path.diagnosis.ok()) return path;
  }
  return roll(guess_from_wedges(solver, curve, spacing));
}

}  // namespace cgal_blend
