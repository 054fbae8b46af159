// SPDX-License-Identifier: GPL-3.0-or-later
#include "join_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cgal_blend {

namespace {

/// A line that is walked along, to its first vertex again if it is closed.
class Walk {
 public:
  Walk(const Point_line& line, bool closed) : line_(line), steps_(line.vertices.size() - (closed ? 0 : 1)) {
    if (line.vertices.size() == 1) steps_ = 0;
  }
  [[nodiscard]] bool at_end() const { return at_ == steps_; }
  [[nodiscard]] std::size_t vertex(std::size_t ahead = 0) const {
    return line_.vertices[(at_ + ahead) % line_.vertices.size()];
  }
  /// Parameter of the vertex ahead, beyond 1 on the closing step.
  [[nodiscard]] double parameter(std::size_t ahead) const {
    const std::size_t i = at_ + ahead, n = line_.parameters.size();
    return line_.parameters[i % n] + static_cast<double>(i / n);
  }
  void go() { ++at_; }

 private:
  const Point_line& line_;
  std::size_t steps_, at_ = 0;
};

}  // namespace

void join_rows(const Point_line& a, const Point_line& b, bool closed, int part, Triangle_soup& soup) {
  Walk p(a, closed), q(b, closed);
  const auto distance = [&](std::size_t v, std::size_t w) {
    return CGAL::squared_distance(soup.points[v], soup.points[w]);
  };
  while (!p.at_end() || !q.at_end()) {
    bool along_p = !p.at_end();
    if (!p.at_end() && !q.at_end()) {
      const double gap = p.parameter(1) - q.parameter(1);
      const double step = std::min(p.parameter(1) - p.parameter(0), q.parameter(1) - q.parameter(0));
      along_p = std::abs(gap) < 0.25 * step ? distance(p.vertex(1), q.vertex()) <= distance(p.vertex(), q.vertex(1))
                                            : gap < 0;
    }
    Walk& walk = along_p ? p : q;
    soup.triangles.push_back(along_p ? std::array{p.vertex(), p.vertex(1), q.vertex()}
                                     : std::array{q.vertex(1), q.vertex(), p.vertex()});
    soup.parts.push_back(part);
    walk.go();
  }
}

Point_line ascending(const Trim_curve& curve) {
  std::vector<std::size_t> order(curve.vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return curve.parameters[i] < curve.parameters[j]; });
  Point_line line;
  for (const std::size_t i : order) {
    line.vertices.push_back(curve.vertices[i]);
    line.parameters.push_back(curve.parameters[i]);
  }
  return line;
}

}  // namespace cgal_blend
