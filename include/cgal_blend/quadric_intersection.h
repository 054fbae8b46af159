// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_QUADRIC_INTERSECTION_H
#define CGAL_BLEND_QUADRIC_INTERSECTION_H

#include <cgal_blend/quadric.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace cgal_blend {

/// Place on an intersection curve.
struct Curve_point {
  using Point_3 = Quadric_3::Point_3;
  using Vector_3 = Quadric_3::Vector_3;

  Point_3 point;
  Vector_3 derivative;          ///< d point / d s, length units; 0 at cusps and isolated points
  Vector_3 normal_a, normal_b;  ///< unit normals of both surfaces, along their gradients; 0 where a gradient vanishes
};

namespace internal {
struct Curve_arc;
}

/// One component of an intersection, by value: a closed loop, an arc, or an isolated point. Arcs end where the box ends,
/// or in a cusp; through nodes and other places where branches cross, each branch runs on smoothly.
class Intersection_curve {
 public:
  using Point_3 = Quadric_3::Point_3;

  explicit Intersection_curve(std::shared_ptr<const internal::Curve_arc> arc);

  /// True if the point at 1 is that at 0, with the same tangent.
  [[nodiscard]] bool is_closed() const;
  [[nodiscard]] bool is_isolated() const;
  /// Returns the degree of the irreducible curve that the component belongs to, 1 to 4; 0 for isolated points.
  [[nodiscard]] int degree() const;
  /// Returns how often the curve counts: 2 where the surfaces touch all along it, 4 where even more so.
  [[nodiscard]] int multiplicity() const;

  /// Evaluates the component. Both |F| / |grad F| at the point are of the size of rounding its coordinates.
  /// \param s from 0 to 1
  [[nodiscard]] Curve_point at(double s) const;

  /// Returns ascending parameters from 0 to 1 (below 1 on closed components), at least `count`; chords between their
  /// points turn by less than 25 degrees. Of isolated points: 0 alone.
  /// Where a bend is too small for the rounding of coordinates, 1e-13 of their size, it is passed over.
  [[nodiscard]] std::vector<double> sample_parameters(std::size_t count) const;

  /// Returns the points at these parameters; the first one of closed components is not repeated.
  [[nodiscard]] std::vector<Point_3> sample(std::size_t count) const;

 private:
  std::shared_ptr<const internal::Curve_arc> arc_;
};

struct Intersection_options {
  double box = 1000;  ///< unbounded arcs are cut where max(|x|, |y|, |z|) is this for the last time; > 0, length units
};

enum class Intersection_status {
  ok,
  empty,   ///< no common real point
  surface  ///< a surface is common; components are what else there is
};

/// Returns "ok", "empty" or "surface".
[[nodiscard]] const char* name(Intersection_status status) noexcept;

/// What two quadrics have in common, in real affine space.
struct Quadric_intersection {
  Intersection_status status = Intersection_status::ok;
  /// In words: "smooth quartic: two closed loops", "twisted cubic and line: ...", "two conics crossing in two points: ..."
  std::string type;
  /// Segre symbol of the pencil, e.g. "[1111]", "[(11)11]"; with cones of one apex that of the plane section, e.g. "[111]".
  std::string segre;
  /// Nodes, cusps, isolated points, and where curves cross or touch each other.
  std::vector<Quadric_3::Point_3> singular_points;
  std::vector<Intersection_curve> components;
};

/// Intersects two quadrics. Type, singular points, and the number and kind of components are decided exactly.
/// Components outside the box are kept if they are bounded, and left out if not.
/// Throws `std::range_error` if the pair is so nearly degenerate that 120 digits do not tell roots apart (differences of
/// about 1e-50, squared; doubles of one magnitude never come near).
/// Sources: L. Dupont, D. Lazard, S. Lazard, S. Petitjean, Near-optimal parameterization of the intersection of quadrics
/// I-III, J. Symb. Comput. 43 (2008), for the cases and the choice of a ruled quadric through a rational point; C. Tu,
/// W. Wang, B. Mourrain, J. Wang, Using signature sequences to classify intersection curves of two quadrics, CAGD 26
/// (2009), for the real morphologies.
[[nodiscard]] Quadric_intersection intersect_quadrics(const Quadric_3& a, const Quadric_3& b,
                                                      const Intersection_options& options = {});

/// Intersects a quadric and a plane: conics in all real cases. `normal_b` is the plane's, `segre` is empty.
/// \param plane (a, b, c, d), not a = b = c = 0
[[nodiscard]] Quadric_intersection intersect(const Quadric_3& quadric, const Quadric_3::Plane& plane,
                                             const Intersection_options& options = {});

}  // namespace cgal_blend

#endif
