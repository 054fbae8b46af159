// SPDX-License-Identifier: GPL-3.0-or-later
#include "segment_tree.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace cgal_blend {

namespace {

/// Negative where an odd number of rings surround the point.
class Signed_distance {
 public:
  explicit Signed_distance(const std::vector<Ring>& rings) : distance_(sides_of(rings)), inside_(rings) {}
  double operator()(const Point_2& p) const {
    const double d = distance_(p);
    return inside_(p) ? -d : d;
  }

 private:
  Segment_tree distance_;
  Even_odd_test inside_;
};

/// Samples at the nodes of a regular grid, bilinear between them; beyond the grid it grows with the distance to it.
class Sampled_distance {
 public:
  Sampled_distance(const std::vector<Ring>& rings, std::size_t cells) {
    CGAL::Bbox_2 box;
    for (const Ring& ring : rings)
      for (const Point_2& p : ring) box += p.bbox();
    const double side = std::max(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    x_ = box.xmin() - side / 2;
    y_ = box.ymin() - side / 2;
    step_ = 2 * side / static_cast<double>(cells);
    nx_ = nodes(box.xmax() - box.xmin() + side);
    ny_ = nodes(box.ymax() - box.ymin() + side);
    values_.reserve(nx_ * ny_);
    const Signed_distance exact(rings);
    for (std::size_t j = 0; j < ny_; ++j)
      for (std::size_t i = 0; i < nx_; ++i)
        values_.push_back(exact({x_ + static_cast<double>(i) * step_, y_ + static_cast<double>(j) * step_}));
  }

  double operator()(const Point_2& p) const {
    const double s = std::clamp((p.x() - x_) / step_, 0.0, static_cast<double>(nx_ - 1));
    const double t = std::clamp((p.y() - y_) / step_, 0.0, static_cast<double>(ny_ - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(s), nx_ - 2),
                      j = std::min(static_cast<std::size_t>(t), ny_ - 2);
    const double u = s - static_cast<double>(i), v = t - static_cast<double>(j);
    const double* row = &values_[j * nx_ + i];
    const double low = row[0] + u * (row[1] - row[0]), high = row[nx_] + u * (row[nx_ + 1] - row[nx_]);
    return low + v * (high - low) + std::hypot(p.x() - x_ - s * step_, p.y() - y_ - t * step_);
  }

 private:
  [[nodiscard]] std::size_t nodes(double length) const {
    return static_cast<std::size_t>(std::ceil(length / step_ * (1 - 1e-12))) + 1;
  }

  double x_ = 0, y_ = 0, step_ = 1;
  std::size_t nx_ = 0, ny_ = 0;
  std::vector<double> values_;
};

/// Shared, as a std::function copies what it holds.
template <class Function>
Planar_function shared(Function&& f) {
  return [f = std::make_shared<const std::decay_t<Function>>(std::forward<Function>(f))](const Point_2& p) {
    return (*f)(p);
  };
}

}  // namespace

Opening_model distance_opening() {
  return [](const std::vector<Ring>& rings) { return shared(Signed_distance(rings)); };
}

Opening_model distance_grid_opening(std::size_t cells) {
  CGAL_precondition(cells >= 8);
  return [cells](const std::vector<Ring>& rings) { return shared(Sampled_distance(rings, cells)); };
}

}  // namespace cgal_blend
