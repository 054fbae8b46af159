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

  std::vector<double> sample(std::size_t count) {
    const std::size_t spans = std::max<std::size_t>(arc_.is_closed ? count : count - 1, arc_.is_closed ? 3 : 1);
    Sample from = at(0);
    for (std::size_t k = 1; k <= spans; ++k) {
      const Sample to = at(k == spans ? 1 : static_cast<double>(k) / static_cast<double>(spans));
      parameters_.push_back(from.s);
      refine(from, to, most_halvings);
      from = to;
    }
    if (!arc_.is_closed) parameters_.push_back(1);
    return std::move(parameters_);
  }

 private:
  [[nodiscard]] Sample at(double s) const {
    const Curve_point p = arc_.at(s);
    if (p.derivative.squared_length() > 0) return {s, p.point, p.derivative};
    return {s, p.point, arc_.at(s < 0.5 ? s + beside_cusp : s - beside_cusp).derivative};
  }

  // The tangents at both ends and at the middle decide, so that a bend to and fro is not passed over.
  void refine(const Sample& from, const Sample& to, int halvings) {
    const Vector_3 chord = to.point - from.point;
    const double tiny = smallest_chord * std::max(size(from.point), size(to.point));
    const Sample middle = at((from.s + to.s) / 2);
    const bool is_tiny = chord.squared_length() <= tiny * tiny && (middle.point - from.point).squared_length() <= tiny * tiny;
    if (halvings == 0 || is_tiny) return;
    if (is_along(from.tangent, chord) && is_along(middle.tangent, chord) && is_along(to.tangent, chord)) return;
    refine(from, middle, halvings - 1);
    parameters_.push_back(middle.s);
    refine(middle, to, halvings - 1);
  }

  const internal::Curve_arc& arc_;
  std::vector<double> parameters_;
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
  return Sampler(*arc_).sample(std::max<std::size_t>(count, 2));
}

std::vector<Intersection_curve::Point_3> Intersection_curve::sample(std::size_t count) const {
  std::vector<Point_3> points;
  for (const double s : sample_parameters(count)) points.push_back(at(s).point);
  return points;
}

}  // namespace cgal_blend
