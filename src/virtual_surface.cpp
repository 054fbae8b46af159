// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_surface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace cgal_blend {

namespace {

constexpr double length_samples = 512;       // steps from contact to apex to contact, to spread parameters by length
constexpr int least_sample = 4;              // halvings, though the profile comes back to where it was
constexpr int rough_samples = 64;            // for a first idea of the length
constexpr std::size_t most_samples = 20000;  // whatever the profile
constexpr int deepest_sample = 40;
constexpr int deepest_row = 16;
constexpr double end_step = 1e-6;  // of the parameter, for tangents at the ends

}  // namespace

Virtual_surface::Virtual_surface(const std::vector<Ball_position>& positions,
                                 const std::array<const Base_surface*, 2>& surfaces, Profile profile,
                                 bool closed)
    : profile_(std::move(profile)), closed_(closed), start_{0} {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    sections_.push_back(section_at(positions[i], surfaces));
    if (sections_[i].frame.angle > sections_[widest_].frame.angle) widest_ = i;
    if (!closed_ && i + 1 == positions.size()) break;
    start_.push_back(start_.back() + (positions[(i + 1) % positions.size()].center - positions[i].center).norm());
  }
  make_even();
}

Virtual_surface::Section Virtual_surface::section_at(const Ball_position& position,
                                                     const std::array<const Base_surface*, 2>& surfaces) {
  Section section;
  section.centre = position.center;
  section.contact_1 = position.contact[0];
  section.contact_2 = position.contact[1];
  const std::array<Vec, 2> arm{position.contact[0] - position.center, position.contact[1] - position.center};
  section.frame.angle = angle_between(arm[0], arm[1]);
  // The tangents x.e_i = |e_i| meet in the apex; the two arms may differ in length where a spine was mended.
  const std::array<double, 2> size{arm[0].norm(), arm[1].norm()};
  const double c = std::cos(section.frame.angle), s = std::max(1e-12, 1 - c * c);
  const double ratio = size[1] / size[0];
  section.apex = position.center + (1 - ratio * c) / s * arm[0] + (1 - c / ratio) / s * arm[1];
  const Vec axis = arm[0].cross(arm[1]);
  for (int side = 0; side < 2; ++side) {
    const Base_surface& surface = *surfaces[side];
    const Vec across = axis.cross(arm[side]).stableNormalized();
    section.frame.curvature[side] = position.radius * curvature_towards_ball(surface, position.foot[side], arm[side], across);
    section.face_normal[side] = surface.frame(position.foot[side].face).face_normal;
  }
  return section;
}

Vec Virtual_surface::place(const Section& section, const Profile_point& p) {
  // Around the centre, so that the arc is exact to rounding; the weights sum to 1.
  return section.centre + p.contact_1 * (section.contact_1 - section.centre) +
         (p.apex != 0 ? Vec(p.apex * (section.apex - section.centre)) : Vec(Vec::Zero())) +
         p.contact_2 * (section.contact_2 - section.centre);
}

/// Spreads the parameters by length, once for all profiles, so that rows correspond.
void Virtual_surface::make_even() {
  if (profile_.is_arc()) return;
  const Section& widest = sections_[widest_];
  const auto at = [&](double parameter) { return place(widest, profile_(parameter, widest.frame)); };
  double rough_length = 0;
  for (int k = 0; k < rough_samples; ++k)
    rough_length += (at((k + 1.0) / rough_samples) - at(static_cast<double>(k) / rough_samples)).norm();
  const double longest_step = rough_length / length_samples;
  parameters_ = {0};
  lengths_ = {0};
  const std::function<void(double, const Vec&, double, const Vec&, int)> sample =
      [&](double low, const Vec& a, double high, const Vec& b, int depth) {
        const double step = (b - a).norm();
        const bool divide = depth < least_sample || step > longest_step;
        if (divide && depth < deepest_sample && parameters_.size() < most_samples) {
          const double middle = (low + high) / 2;
          const Vec between = at(middle);
          sample(low, a, middle, between, depth + 1);
          sample(middle, between, high, b, depth + 1);
        } else {
          parameters_.push_back(high);
          lengths_.push_back(lengths_.back() + step);
        }
      };
  std::vector<double> stops = profile_.kinks();
  stops.push_back(1);
  std::vector<std::size_t> corners;
  for (const double stop : stops) {
    const double low = parameters_.back();
    sample(low, at(low), stop, at(stop), 0);
    corners.push_back(parameters_.size() - 1);
  }
  corners.pop_back();
  const double total = lengths_.back();
  for (double& length : lengths_) length /= total;
  for (const std::size_t corner : corners) {  // corners in one place make one
    const double before = kinks_.empty() ? 0 : kinks_.back();
    if (lengths_[corner] > before && lengths_[corner] < 1) kinks_.push_back(lengths_[corner]);
  }
}

double Virtual_surface::even(double u) const {
  if (parameters_.empty()) return u;
  const auto after = std::upper_bound(lengths_.begin(), lengths_.end(), u) - lengths_.begin();
  const std::size_t k = std::clamp<std::size_t>(after, 1, lengths_.size() - 1);
  const double step = lengths_[k] - lengths_[k - 1];
  const double part = step > 0 ? std::clamp((u - lengths_[k - 1]) / step, 0.0, 1.0) : 1;
  return part < 1 ? parameters_[k - 1] + part * (parameters_[k] - parameters_[k - 1]) : parameters_[k];
}

Vec Virtual_surface::on_profile(std::size_t i, double u) const {
  return place(sections_[i], profile_(even(u), sections_[i].frame));
}

Vec Virtual_surface::operator()(double t, double u) const {
  t -= length() * std::floor(t / length());
  const auto upper = std::upper_bound(start_.begin(), start_.end(), t);
  const std::size_t i = std::min(size(), static_cast<std::size_t>(upper - start_.begin())) - 1;
  const double step = start_[i + 1] - start_[i];
  const double s = step > 0 ? (t - start_[i]) / step : 0;
  return (1 - s) * on_profile(i, u) + s * on_profile((i + 1) % size(), u);
}

std::optional<Vec> Virtual_surface::find_twist(double angle, std::size_t first, std::size_t past) const {
  constexpr std::size_t columns = 8;
  std::vector<std::array<Vec, columns + 1>> points(size());
  for (std::size_t i = 0; i < size(); ++i)
    for (std::size_t k = 0; k <= columns; ++k)
      points[i][k] = on_profile(i, static_cast<double>(k) / static_cast<double>(columns));
  const auto normal = [&](std::size_t i, std::size_t k) -> Vec {
    const auto &a = points[i % size()], &b = points[(i + 1) % size()];
    return (b[k + 1] - a[k]).cross(b[k] - a[k + 1]);  // of a quadrilateral, by its diagonals
  };
  const auto step = [&](std::size_t i) -> Vec {
    return sections_[(i + 1) % size()].centre - sections_[i % size()].centre;
  };
  for (std::size_t i = closed_ ? 0 : first; i + (closed_ ? 0 : 2) < (closed_ ? size() : std::min(past, size())); ++i) {
    const double turn = angle_between(step(i), step(i + 1));
    for (std::size_t k = 0; k < columns; ++k)
      if (angle_between(normal(i, k), normal(i + 1, k)) > angle + turn) return points[(i + 1) % size()][k];
  }
  return std::nullopt;
}

double Virtual_surface::profile_length(std::size_t i) const {
  constexpr int steps = 8;
  double length = 0;
  for (int k = 0; k < steps; ++k)
    length += (on_profile(i, (k + 1.0) / steps) - on_profile(i, static_cast<double>(k) / steps)).norm();
  return length;
}

std::vector<double> Virtual_surface::rows(double tolerance) const {
  std::vector<double> result{0};
  const Section& widest = sections_[widest_];
  if (profile_.is_arc()) {
    const double facet = 2 * std::acos(1 - tolerance);
    // Flat arcs too need the facets of a quarter circle: their volume is as small as the square of their angle.
    const double facets = std::max(2.0, std::ceil(std::max(widest.frame.angle, pi / 2) / facet - 1e-9));
    for (double k = 1; k <= facets; ++k) result.push_back(k / facets);
    return result;
  }
  const double limit = tolerance * (widest.contact_1 - widest.centre).norm();
  const std::function<void(double, double, int)> divide = [&](double low, double high, int depth) {
    constexpr int samples = 8;
    double off = 0;
    const Vec a = on_profile(widest_, low), b = on_profile(widest_, high);
    for (int k = 1; k < samples; ++k)
      off = std::max(off, off_segment(a, b, on_profile(widest_, low + (high - low) * k / samples)));
    if (depth < deepest_row && (depth == 0 || off > limit)) {
      divide(low, (low + high) / 2, depth + 1);
      divide((low + high) / 2, high, depth + 1);
    } else {
      result.push_back(high);
    }
  };
  std::vector<double> stops = kinks_;
  stops.push_back(1);
  for (const double stop : stops) divide(result.back(), stop, kinks_.empty() ? 0 : 1);
  return result;
}

double Virtual_surface::end_angle(std::size_t i, int side) const {
  const Section& section = sections_[i];
  const double u = side == 0 ? end_step : 1 - end_step;
  const Vec& contact = side == 0 ? section.contact_1 : section.contact_2;
  const Profile_point p = profile_(u, section.frame);
  // Relative to the contact, because far from the origin the step is lost in the coordinates.
  const Vec tangent = p.centre * (section.centre - contact) + p.contact_1 * (section.contact_1 - contact) +
                      p.apex * (section.apex - contact) + p.contact_2 * (section.contact_2 - contact);
  const Vec& normal = section.face_normal[side];
  return std::atan2(std::abs(tangent.dot(normal)), tangent.cross(normal).norm()) * 180 / pi;
}

}  // namespace cgal_blend
