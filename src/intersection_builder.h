// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_INTERSECTION_BUILDER_H
#define CGAL_BLEND_INTERSECTION_BUILDER_H

#include "projective_curve.h"
#include "symmetric_form.h"

#include <cgal_blend/quadric_intersection.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cgal_blend {

/// Collects the real affine parts of an intersection: breaks curves at infinity and at cusps, cuts them by the box, and
/// finds the words for the type. Points and planes are (x, y, z, w).
class Intersection_builder {
 public:
  /// Where an arc ends: at infinity or in a cusp.
  struct Break {
    Real angle;  ///< of the parameter
    bool is_infinite;
  };

  Intersection_builder(const Quadric_3& a, const Quadric_3& b, const Intersection_options& options);

  /// Adds an irreducible curve with coordinates that are binary forms; what lies at infinity altogether is left out.
  /// \param coefficients points; the k-th is the factor of c^(n - k) s^k
  /// \param cusps form whose real roots are cusps in affine space; of degree 0 if there are none
  void add_rational(const std::string& name, const Surd_matrix& coefficients, int multiplicity,
                    const Binary_form& cusps = {Surd(1)});
  /// Adds the line through two points.
  void add_line(const Surd_vector& p, const Surd_vector& q, int multiplicity);
  /// Adds the line through a point and one that is not a number of square roots; they are not both at infinity.
  void add_line(const Surd_vector& p, const Projective<Real>& q, int multiplicity);
  /// Adds one loop of a quartic, which meets the plane at infinity at the parameters `infinite`.
  void add_quartic_loop(const std::string& name, const std::shared_ptr<const Projective_curve>& loop,
                        const std::vector<Direction>& infinite);
  /// Adds a point that no curve goes through, if it is not at infinity.
  void add_isolated_point(const Surd_vector& p);
  /// Adds a singular point of the curve, if it is not at infinity; returns whether it is not.
  bool add_singular_point(const Surd_vector& p);
  /// Appends to the type how often several curves meet: "crossing in two points".
  /// \param how nothing: that is told by the singular points; else what to say instead of "crossing in ..."
  void add_crossings(const std::string& how = "");
  /// Says of several lines that they are parallel.
  void set_parallel();
  /// Says that a surface is common.
  void set_surface(const std::string& name) { surface_ = name; }

  [[nodiscard]] Quadric_intersection finish(const std::string& segre) const;

 private:
  void note(const std::string& name, int degree, int multiplicity);
  [[nodiscard]] bool has_several_curves() const;
  void add_arcs(const std::shared_ptr<const Projective_curve>& curve, std::vector<Break> breaks, int degree,
                int multiplicity);
  // Angles where the curve meets the surface of the box, ascending.
  [[nodiscard]] std::vector<Real> entries_to_box(const Projective_curve& curve) const;
  [[nodiscard]] std::string words() const;

  std::shared_ptr<const internal::Curve_arc> surfaces_;  // the arc that all others are copies of
  Intersection_options options_;
  struct Curves {
    std::string name;
    int rank, count;  // the order in the type, and how many
  };
  std::vector<Curves> curves_;
  std::string crossings_;
  std::string surface_;
  std::vector<Quadric_3::Point_3> singular_points_;
  std::vector<Intersection_curve> components_;
};

/// Returns "no", "one", "two", ... and from ten on digits.
[[nodiscard]] std::string count_in_words(std::size_t count);

[[nodiscard]] Projective<Real> to_projective(const Surd_vector& p);

}  // namespace cgal_blend

#endif
