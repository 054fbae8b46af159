// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/correspondence.h>

#include <cmath>

namespace cgal_blend {

namespace {

constexpr int spans = 64;
const double cosine_of_turn = std::cos(30 * CGAL_PI / 180);

struct Frame {
  double s;
  Boundary_point at;
};

bool is_usable(const Vector_3& v) {
  const double square = v.squared_length();
  return square > 0 && std::isfinite(square);
}

/// True if the vectors turn by less than 30 degrees; of the normal either sense may be meant.
bool close_together(const Frame& a, const Frame& b) {
  const auto cosine = [](const Vector_3& v, const Vector_3& w) {
    return v * w / std::sqrt(v.squared_length() * w.squared_length());
  };
  return cosine(a.at.derivative, b.at.derivative) > cosine_of_turn && cosine(a.at.normal, b.at.normal) > cosine_of_turn;
}

const char* fault_at(const Boundary_point& p) {
  if (!std::isfinite(p.point.x() + p.point.y() + p.point.z())) return "the curve leaves the finite there";
  if (!is_usable(p.derivative)) return "its derivative vanishes there";
  if (!is_usable(p.normal)) return "the surface has no normal there";
  return nullptr;
}

/// Halves a step until neighbours are alike: a corner of the curve or an apex of the surface never lets them.
std::optional<Boundary_point> find_break(const Boundary_curve& curve, const Frame& a, const Frame& b) {
  const Frame middle{(a.s + b.s) / 2, curve.at((a.s + b.s) / 2)};
  if (fault_at(middle.at) != nullptr) return middle.at;
  if (close_together(a, middle) && close_together(middle, b)) return std::nullopt;
  if (b.s - a.s < least_parameter_step) return middle.at;
  if (auto found = find_break(curve, a, middle)) return found;
  return find_break(curve, middle, b);
}

}  // namespace

Diagnosis check_regular(const Boundary_curve& curve) {
  Frame before{0, curve.at(0)};
  const auto refuse = [](const Boundary_point& p, const char* why) {
    return Diagnosis{Status::singular_boundary, why, p.point, {}};
  };
  if (const char* why = fault_at(before.at)) return refuse(before.at, why);
  for (int i = 1; i <= spans; ++i) {
    const double s = static_cast<double>(i) / spans;
    const Frame next{s, curve.at(s)};
    if (const char* why = fault_at(next.at)) return refuse(next.at, why);
    if (const auto found = find_break(curve, before, next)) {
      const char* why = fault_at(*found);
      return refuse(*found, why != nullptr ? why : "the curve or the surface's normal turns at once there");
    }
    before = next;
  }
  return {};
}

}  // namespace cgal_blend
