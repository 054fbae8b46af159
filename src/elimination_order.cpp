// SPDX-License-Identifier: GPL-3.0-or-later
#include "elimination_order.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace cgal_blend {

namespace {

// Sines of the angles between normals, or directions, that count as independent.
constexpr double least_sine = 1e-4;

class Elimination {
 public:
  Elimination(const std::vector<Vec>& points, const std::vector<Vec>& normals,
              const std::vector<std::pair<std::size_t, std::size_t>>& bonds, double least_distance)
      : points_(points),
        normals_(normals),
        least_distance_(least_distance),
        planes_of_(points.size()),
        points_of_(normals.size()),
        point_gone_(points.size(), false),
        plane_gone_(normals.size(), false),
        plane_queued_(normals.size(), true) {
    for (const auto& [point, plane] : bonds) {
      planes_of_[point].push_back(plane);
      points_of_[plane].push_back(point);
    }
    for (std::size_t i = 0; i < points.size(); ++i) point_queue_.push_back(i);
    for (std::size_t i = 0; i < normals.size(); ++i) plane_queue_.push_back(i);
  }

  /// From the last one to the first. Points go as early as they can, so that as many planes as possible are found
  /// first, as they were fitted: these are few, and the coordinates stay short.
  std::vector<Eliminated> run(std::size_t first_optional) {
    while (true) {
      if (!point_queue_.empty()) {
        const std::size_t i = pop(point_queue_);
        if (!point_gone_[i] && independent_planes(i).size() == left(planes_of_[i], plane_gone_).size()) remove_point(i);
      } else if (!plane_queue_.empty()) {
        const std::size_t i = pop(plane_queue_);
        plane_queued_[i] = false;
        if (!plane_gone_[i] && is_determined(left(points_of_[i], point_gone_))) remove_plane(i);
      } else if (!give_up(first_optional)) {
        break;
      }
    }
    std::reverse(removed_.begin(), removed_.end());
    return std::move(removed_);
  }

 private:
  static std::size_t pop(std::vector<std::size_t>& queue) {
    const std::size_t i = queue.back();
    queue.pop_back();
    return i;
  }

  static std::vector<std::size_t> left(const std::vector<std::size_t>& all, const std::vector<bool>& gone) {
    std::vector<std::size_t> result;
    for (const std::size_t i : all)
      if (!gone[i]) result.push_back(i);
    return result;
  }

  /// The first of a point's planes that determine it, or all if they do not.
  [[nodiscard]] std::vector<std::size_t> independent_planes(std::size_t point) const {
    std::vector<std::size_t> chosen;
    for (const std::size_t i : left(planes_of_[point], plane_gone_)) {
      if (chosen.size() == 3) break;
      const Vec& n = normals_[i];
      const double sine = chosen.empty()       ? 1
                          : chosen.size() == 1 ? n.cross(normals_[chosen[0]]).norm()
                                               : std::abs(n.dot(normals_[chosen[0]].cross(normals_[chosen[1]])));
      if (sine > least_sine) chosen.push_back(i);
    }
    return chosen;
  }

  /// True if there is a plane through the points, and no two of them are too near each other to tell which.
  [[nodiscard]] bool is_determined(const std::vector<std::size_t>& points) const {
    if (points.size() > 3) return false;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if ((points_[points[i]] - points_[points[j]]).norm() < least_distance_) return false;
    if (points.size() < 3) return true;
    const Vec p = points_[points[1]] - points_[points[0]], q = points_[points[2]] - points_[points[0]];
    return p.cross(q).norm() > least_sine * p.norm() * q.norm();
  }

  void remove_point(std::size_t i) {
    point_gone_[i] = true;
    removed_.push_back({false, i, independent_planes(i)});
    for (const std::size_t plane : planes_of_[i]) {
      if (plane_gone_[plane] || plane_queued_[plane]) continue;
      plane_queued_[plane] = true;
      plane_queue_.push_back(plane);
    }
  }

  void remove_plane(std::size_t i) {
    plane_gone_[i] = true;
    removed_.push_back({true, i, left(points_of_[i], point_gone_)});
    requeue_points_of(i);
  }

  void requeue_points_of(std::size_t plane) {
    for (const std::size_t point : points_of_[plane])
      if (!point_gone_[point]) point_queue_.push_back(point);
  }

  /// Gives up an optional plane, else the bonds of a point beyond those that determine it; false if nothing is left.
  bool give_up(std::size_t first_optional) {
    for (std::size_t i = first_optional; i < normals_.size(); ++i)
      if (!plane_gone_[i]) {
        plane_gone_[i] = true;
        requeue_points_of(i);
        return true;
      }
    std::size_t best = points_.size(), fewest = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (point_gone_[i]) continue;
      const std::size_t bonds = left(planes_of_[i], plane_gone_).size();
      if (best != points_.size() && bonds >= fewest) continue;
      best = i;
      fewest = bonds;
    }
    if (best != points_.size()) {
      remove_point(best);
      return true;
    }
    for (std::size_t i = 0; i < normals_.size(); ++i)
      if (!plane_gone_[i]) {
        remove_plane(i);
        return true;
      }
    return false;
  }

  const std::vector<Vec>& points_;
  const std::vector<Vec>& normals_;
  double least_distance_;
  std::vector<std::vector<std::size_t>> planes_of_, points_of_;
  std::vector<bool> point_gone_, plane_gone_, plane_queued_;
  std::vector<std::size_t> point_queue_, plane_queue_;
  std::vector<Eliminated> removed_;
};

}  // namespace

std::vector<Eliminated> elimination_order(const std::vector<Vec>& points, const std::vector<Vec>& normals,
                                          const std::vector<std::pair<std::size_t, std::size_t>>& bonds,
                                          std::size_t first_optional, double least_distance) {
  return Elimination(points, normals, bonds, least_distance).run(first_optional);
}

}  // namespace cgal_blend
