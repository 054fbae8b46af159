// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/cut_plane.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>

#include <cmath>

namespace cgal_blend {

namespace {

template <class Number>
Number height(const Cut_plane& plane, const Point_3& p) {
  const auto term = [&](int k) -> Number { return Number(plane.normal[k]) * (Number(p[k]) - Number(plane.point[k])); };
  return term(0) + term(1) + term(2);
}

}  // namespace

Diagnosis check(const Cut_plane& plane) {
  const auto wrong = [](const char* what) { return Diagnosis{Status::invalid_parameter, what, {}, {}}; };
  for (int k = 0; k < 3; ++k)
    if (!std::isfinite(plane.point[k]) || !std::isfinite(plane.normal[k]))
      return wrong("a plane is given by six finite numbers");
  const double length = plane.normal.squared_length();
  if (!(length > 0) || !std::isfinite(length))
    return wrong("the normal of a plane must have a length, between 1e-150 and 1e150");
  return {};
}

int side_of(const Cut_plane& plane, const Point_3& p) {
  {
    const CGAL::Protect_FPU_rounding<true> upward;
    const CGAL::Uncertain<CGAL::Sign> sign = CGAL::sign(height<CGAL::Interval_nt<false>>(plane, p));
    if (CGAL::is_certain(sign)) return CGAL::get_certain(sign);
  }
  return CGAL::sign(height<CGAL::Exact_rational>(plane, p));
}

}  // namespace cgal_blend
