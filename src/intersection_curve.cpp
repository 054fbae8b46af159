// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/quadric_intersection.h>

#include "curve_arc.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cgal_blend {

namespace {

using Point_3 = Curve_point::Point_3;
using Vector_3 = Curve_point::Vector_3;

// Chords meet at less than 25 degrees if each is within this angle of the tangents at its ends.
const double cosine_of_chord = std::cos(11 * 3.14159265358979323846 / 180);
constexpr double smallest_chord = 1e-13;  // of the coordinates
constexpr double beside_cusp = 1e-7;      // of the parameter: where a tangent is taken if there is none at an end
constexpr int most_halvings = 60;

struct Sample {
  double s;
  Point_3 point;
  Vector_3 tangent;
};

double size(const Point_3& p) { return std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}); }

bool is_along(const Vector_3& tangent, const Vector_3& chord) {
  const double product = tangent * chord;
  return product >= cosine_of_chord * std::sqrt(tangent.squared_length() * chord.squared_length());
}

class Sampler {
 public:
  explicit Sampler(const internal::Curve_arc& arc) : arc_(arc) {}

  // The last sample is that at 1, also on closed curves.
  std::vector<Sample> sample(std::size_t count) {
    const std::size_t spans = std::max<std::size_t>(arc_.is_closed ? count : count - 1, arc_.is_closed ? 3 : 1);
    samples_.push_back(at(0));
    for (std::size_t k = 1; k <= spans; ++k) {
      const Sample from = samples_.back(),
                   to = at(k == spans ? 1 : static_cast<double>(k) / static_cast<double>(spans));
      refine(from, to, most_halvings);
      samples_.push_back(to);
    }
    drop_coincident();
    while (samples_.size() <= spans && divide_long_chords()) {
    }
    return std::move(samples_);
  }

 private:
  [[nodiscard]] Sample at(double s) const {
    const Curve_point p = arc_.at(s);
    if (p.derivative.squared_length() > 0) return {s, p.point, p.derivative};
    return {s, p.point, arc_.at(s < 0.5 ? s + beside_cusp : s - beside_cusp).derivative};
  }

  [[nodiscard]] static bool coincide(const Sample& x, const Sample& y) {
    const double tiny = smallest_chord * std::max(size(x.point), size(y.point));
    return CGAL::squared_distance(x.point, y.point) <= tiny * tiny;
  }

  // The tangents at both ends and at the middle decide, so that a bend to and fro is not passed over.
  void refine(const Sample& from, const Sample& to, int halvings) {
    const Vector_3 chord = to.point - from.point;
    const Sample middle = at((from.s + to.s) / 2);
    if (halvings == 0 || (coincide(from, to) && coincide(from, middle))) return;
    if (is_along(from.tangent, chord) && is_along(middle.tangent, chord) && is_along(to.tangent, chord)) return;
    refine(from, middle, halvings - 1);
    samples_.push_back(middle);
    refine(middle, to, halvings - 1);
  }

  // Samples of a uniform parameter may be closer than rounding tells apart. The ends stay.
  void drop_coincident() {
    std::vector<Sample> kept{samples_.front()};
    for (std::size_t k = 1; k + 1 < samples_.size(); ++k)
      if (!coincide(kept.back(), samples_[k])) kept.push_back(samples_[k]);
    while (kept.size() > 1 && coincide(kept.back(), samples_.back())) kept.pop_back();
    kept.push_back(samples_.back());
    samples_ = std::move(kept);
  }

  // Halves the longest chords, down to half their length; false if there is nothing to halve.
  bool divide_long_chords() {
    const auto length = [&](std::size_t k) {
      return std::sqrt(CGAL::squared_distance(samples_[k].point, samples_[k + 1].point));
    };
    double longest = 0;
    for (std::size_t k = 0; k + 1 < samples_.size(); ++k) longest = std::max(longest, length(k));
    std::vector<Sample> divided;
    for (std::size_t k = 0; k + 1 < samples_.size(); ++k) {
      divided.push_back(samples_[k]);
      if (length(k) < longest / 2) continue;
      const Sample middle = at((samples_[k].s + samples_[k + 1].s) / 2);
      if (!coincide(samples_[k], middle) && !coincide(middle, samples_[k + 1])) divided.push_back(middle);
    }
    divided.push_back(samples_.back());
    const bool has_grown = divided.size() > samples_.size();
    samples_ = std::move(divided);
    return has_grown;
  }

  const internal::Curve_arc& arc_;
  std::vector<Sample> samples_;
};

}  // namespace

Intersection_curve::Intersection_curve(std::shared_ptr<const internal::Curve_arc> arc) : arc_(std::move(arc)) {}

bool Intersection_curve::is_closed() const { return arc_->is_closed; }
bool Intersection_curve::is_isolated() const { return !arc_->curve; }
int Intersection_curve::degree() const { return arc_->degree; }
int Intersection_curve::multiplicity() const { return arc_->multiplicity; }
Curve_point Intersection_curve::at(double s) const { return arc_->at(s); }

std::vector<double> Intersection_curve::sample_parameters(std::size_t count) const {
  if (is_isolated()) return {0};
  std::vector<double> parameters;
  for (const Sample& sample : Sampler(*arc_).sample(std::max<std::size_t>(count, 2))) parameters.push_back(sample.s);
  if (is_closed()) parameters.pop_back();
  return parameters;
}

std::vector<Intersection_curve::Point_3> Intersection_curve::sample(std::size_t count) const {
  if (is_isolated()) return {arc_->isolated_point};
  std::vector<Point_3> points;
  for (const Sample& sample : Sampler(*arc_).sample(std::max<std::size_t>(count, 2))) points.push_back(sample.point);
  if (is_closed()) points.pop_back();
  return points;
}

}  // namespace cgal_blend
