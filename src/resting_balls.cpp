// SPDX-License-Identifier: GPL-3.0-or-later
#include "resting_balls.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>

namespace cgal_blend {

namespace {

constexpr double same_radius = 1e-9;  // of the radius: branches in a corner that are as near as this have one
constexpr double same_ball = 1e-6;    // of the radius: no strip is left between centres so near
constexpr double straight = 0.9;      // cosine between the steps of a branch and its chord: others are not swallowed

using Branch_end_index = Resting_balls::Branch_end_index;

class Rest_finder {
 public:
  Rest_finder(const Base_surface& surface, const std::vector<Corner_branch>& branches,
              const std::unordered_set<Vertex>& flat)
      : surface_(surface), mesh_(surface.mesh()), branches_(branches), flat_(flat) {
    result_.swallowed.assign(branches.size(), false);
  }

  Resting_balls run() {
    for (std::size_t i = 0; i < branches_.size(); ++i)
      for (const int end : {0, 1})
        if (branches_[i].into[end] != Blend_mesh::null_halfedge()) parts_[vertex({i, end})].ends.emplace_back(i, end);
    for (auto part = parts_.begin(); part != parts_.end();)
      part = part->second.ends.size() > 1 ? std::next(part) : parts_.erase(part);
    for (auto& [v, part] : parts_) {
      part.vertices = {v};
      result_.corner_of[v] = v;
    }
    for (const auto& [v, part] : parts_) seek(v);
    std::set<std::size_t> open;
    for (std::size_t i = 0; i < branches_.size(); ++i) open.insert(open.end(), i);
    while (!open.empty()) {
      const std::size_t i = *open.begin();
      open.erase(open.begin());
      if (!is_swallowed(i) || !swallow(i)) continue;
      // Its neighbours end at other balls now.
      for (const auto& [k, end] : parts_.at(result_.corner_of.at(vertex({i, 0}))).ends) open.insert(k);
    }
    return std::move(result_);
  }

 private:
  /// What a corner consists of.
  struct Part {
    std::vector<Vertex> vertices;
    std::vector<Branch_end_index> ends;  // of the branches that meet there, in no order
  };

  [[nodiscard]] Vertex vertex(const Branch_end_index& end) const {
    return mesh_.target(branches_[end.first].into[end.second]);
  }

  [[nodiscard]] bool wants_balls(const std::vector<Branch_end_index>& node) const {
    const auto& [first, first_end] = node.front();
    const double radius = branches_[first].radius[first_end];
    return std::all_of(node.begin(), node.end(), [&, first = first](const Branch_end_index& b) {
      const Corner_branch& branch = branches_[b.first];
      return !branch.refused && flat_.count(vertex(b)) == 0 && branch.convex == branches_[first].convex &&
             std::abs(branch.radius[b.second] - radius) <= same_radius * radius;
    });
  }

  /// Looks for the balls of a corner; false if there are none.
  bool seek(Vertex key) {
    const std::vector<Branch_end_index>& meeting = parts_.at(key).ends;
    if (meeting.empty() || !wants_balls(meeting)) return false;
    Resting_balls::Corner corner;
    std::vector<std::vector<Halfedge>> sectors;
    if (!walk_around(meeting, corner, sectors)) return false;
    const auto& [first, end] = meeting.front();
    const double radius = branches_[first].radius[end];
    corner.balls = find_corner_balls(surface_, sectors, branches_[first].convex ? -radius : radius);
    if (corner.balls.blocked) result_.blocked[key] = *corner.balls.blocked;
    if (corner.balls.balls.empty()) return false;
    result_.corners[key] = std::move(corner);
    return true;
  }

  /// Goes counterclockwise around a corner, along swallowed branches too; false if an edge stays sharp there.
  bool walk_around(const std::vector<Branch_end_index>& meeting, Resting_balls::Corner& corner,
                   std::vector<std::vector<Halfedge>>& sectors) const {
    const auto into = [&](const Branch_end_index& b) { return branches_[b.first].into[b.second]; };
    const Halfedge start = into(meeting.front());
    Halfedge h = start;
    do {
      const auto branch =
          std::find_if(meeting.begin(), meeting.end(), [&](const Branch_end_index& b) { return into(b) == h; });
      if (branch == meeting.end() || corner.branches.size() == meeting.size()) return false;
      corner.branches.push_back(*branch);
      sectors.emplace_back();
      do {
        h = mesh_.prev(mesh_.opposite(h));
        sectors.back().push_back(h);
        while (inner_.count(mesh_.edge(h))) {
          h = mesh_.prev(h);
          sectors.back().push_back(h);
        }
      } while (surface_.crossable(h));
    } while (h != start);
    return corner.branches.size() == meeting.size();
  }

  /// The centre of the ball that a branch ends at.
  [[nodiscard]] std::optional<Vec> center(const Branch_end_index& end) const {
    const Resting_balls::Corner* corner = result_.at(vertex(end));
    if (!corner) return std::nullopt;
    const std::size_t n = corner->branches.size();
    const auto k = static_cast<std::size_t>(std::find(corner->branches.begin(), corner->branches.end(), end) -
                                            corner->branches.begin());
    for (const Corner_balls::Ball& ball : corner->balls.balls)
      if (std::binary_search(ball.sectors.begin(), ball.sectors.end(), k) &&
          std::binary_search(ball.sectors.begin(), ball.sectors.end(), (k + n - 1) % n))
        return ball.rest.center;
    return std::nullopt;
  }

  /// True if the balls at the ends of a straight branch have met, or passed each other.
  [[nodiscard]] bool is_swallowed(std::size_t i) const {
    const Corner_branch& branch = branches_[i];
    if (result_.swallowed[i] || branch.into[0] == Blend_mesh::null_halfedge() || branch.refused) return false;
    if (std::abs(branch.radius[0] - branch.radius[1]) > same_radius * branch.radius[0]) return false;
    const auto from = center({i, 0}), to = center({i, 1});
    if (!from || !to) return false;
    const Vec chord = (branch.points.back() - branch.points.front()).stableNormalized();
    for (std::size_t k = 0; k + 1 < branch.points.size(); ++k)
      if ((branch.points[k + 1] - branch.points[k]).stableNormalized().dot(chord) < straight) return false;
    return (*to - *from).dot(chord) <= same_ball * branch.radius[0];
  }

  /// Makes one corner of the ends of a branch; false, and nothing has changed, if it has no balls.
  bool swallow(std::size_t i) {
    const Vertex key = result_.corner_of.at(vertex({i, 0})), other = result_.corner_of.at(vertex({i, 1}));
    const Part own = parts_.at(key), added = key != other ? parts_.at(other) : Part{};
    Part& joined = parts_.at(key);
    joined.vertices.insert(joined.vertices.end(), added.vertices.begin(), added.vertices.end());
    joined.ends.insert(joined.ends.end(), added.ends.begin(), added.ends.end());
    joined.ends.erase(
        std::remove_if(joined.ends.begin(), joined.ends.end(), [&](const Branch_end_index& b) { return b.first == i; }),
        joined.ends.end());
    const Resting_balls::Corner before = result_.corners.at(key);
    inner_.insert(branches_[i].edges.begin(), branches_[i].edges.end());
    if (seek(key)) {
      result_.swallowed[i] = true;
      for (const Vertex v : added.vertices) result_.corner_of[v] = key;
      if (key != other) {
        result_.corners.erase(other);
        parts_.erase(other);
      }
      return true;
    }
    joined = own;
    result_.corners[key] = before;
    for (const Edge e : branches_[i].edges) inner_.erase(e);
    return false;
  }

  const Base_surface& surface_;
  const Blend_mesh& mesh_;
  const std::vector<Corner_branch>& branches_;
  const std::unordered_set<Vertex>& flat_;
  std::unordered_set<Edge> inner_;  // of swallowed branches
  std::map<Vertex, Part> parts_;    // by the keys of the corners
  Resting_balls result_;
};

}  // namespace

const Resting_balls::Corner* Resting_balls::at(Vertex v) const {
  const auto key = corner_of.find(v);
  if (key == corner_of.end()) return nullptr;
  const auto corner = corners.find(key->second);
  return corner != corners.end() ? &corner->second : nullptr;
}

Resting_balls find_resting_balls(const Base_surface& surface, const std::vector<Corner_branch>& branches,
                                 const std::unordered_set<Vertex>& flat) {
  return Rest_finder(surface, branches, flat).run();
}

}  // namespace cgal_blend
