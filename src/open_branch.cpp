// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_branch.h"

#include "ball_solver.h"
#include "refusal.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace cgal_blend {

namespace {

constexpr double clear_of_facet = 0.3;  // rows keep no profile nearer to their end
constexpr double shared_of_snap = 4;    // rims that meet in a contact keep apart before it
constexpr double short_way = 1;         // radii between two balls at rest
constexpr double fade_of_width = 0.5;   // a fading strip is closed so far from the vertex, in its widths

bool is_before(const Vec& a, const Vec& b, const Vec& outward, double least) { return (b - a).dot(outward) > least; }

/// Ends a spine at a ball position instead of where it rolled to.
void end_at(std::vector<Ball_position>& positions, const Ball_position& last, int end, const Vec& outward,
            double least) {
  const auto stays = [&](const Ball_position& p) {
    return is_before(p.center, last.center, outward, least) && is_before(p.contact[0], last.contact[0], outward, 0) &&
           is_before(p.contact[1], last.contact[1], outward, 0);
  };
  if (end == 1) {
    while (!positions.empty() && !stays(positions.back())) positions.pop_back();
    positions.push_back(last);
  } else {
    const auto first = std::find_if(positions.begin(), positions.end(), stays);
    positions.erase(positions.begin(), first);
    positions.insert(positions.begin(), last);
  }
}

Ball_position ball_in_corner(const Base_surface& surface, const Blend_corner& corner, std::size_t place, int left,
                             int end) {
  const std::size_t n = corner.branches.size();
  Ball_position p;
  p.fraction = end;
  p.center = corner.ball.center;
  p.foot[left] = corner.ball.foot[(place + n - 1) % n];  // the faces right of the branch before
  p.foot[1 - left] = corner.ball.foot[place];
  for (const int side : {0, 1}) p.contact[side] = surface.position(p.foot[side]);
  p.radius = (p.contact[0] - p.center).norm();
  return p;
}

/// The ball in the plane through the vertex of a flat end that both normals there span: contacts, centre and vertex then
/// lie in it, as far as the surfaces go on straight from the edge to the contacts.
std::optional<Ball_position> ball_at_flat_end(const Ball_solver& solver, const Branch_end& end,
                                              const Ball_position& near) {
  const Base_surface& surface = solver.surface(0);
  const Blend_mesh& mesh = surface.mesh();
  const auto normal = [&](Halfedge into_vertex) {
    const Base_surface::Frame& frame = surface.frame(mesh.face(into_vertex));
    const auto corner = std::find(frame.halfedge.begin(), frame.halfedge.end(), into_vertex) - frame.halfedge.begin();
    return frame.normal[static_cast<std::size_t>(corner)];
  };
  const Vec across = normal(end.into).cross(normal(mesh.prev(mesh.opposite(end.into)))).stableNormalized();
  const Vec ahead = end.end == 1 ? end.direction : Vec(-end.direction);
  const double sign = across.dot(ahead) < 0 ? -1 : 1;
  const double fraction = end.end;
  return solver.solve({to_vec(mesh.point(end.vertex(mesh))), sign * across, near.foot, fraction}).position;
}

/// Puts a ball position in its place among others, instead of those that are nearer to it than `least`.
std::size_t insert_ball(std::vector<Ball_position>& positions, const Ball_position& ball, const Vec& ahead,
                        double least) {
  const auto height = [&](const Ball_position& p) { return (p.center - ball.center).dot(ahead); };
  positions.erase(std::remove_if(positions.begin(), positions.end(),
                                 [&](const Ball_position& p) { return std::abs(height(p)) < least; }),
                  positions.end());
  const auto after =
      std::find_if(positions.begin(), positions.end(), [&](const Ball_position& p) { return height(p) > 0; });
  return static_cast<std::size_t>(positions.insert(after, ball) - positions.begin());
}

/// A fading strip is closed where it is still wide enough to have facets.
void end_fading(std::vector<Ball_position>& positions, const Branch_end& end, const Vec& vertex) {
  const auto too_near = [&](const Ball_position& p) {
    const double width = (p.contact[0] - p.contact[1]).norm();
    return (vertex - (p.contact[0] + p.contact[1]) / 2).dot(end.direction) < fade_of_width * width;
  };
  while (positions.size() > 1 && too_near(end.end == 1 ? positions.back() : positions.front()))
    positions.erase(end.end == 1 ? positions.end() - 1 : positions.begin());
}

std::size_t nearest(const std::vector<Ball_position>& positions, const Vec& p) {
  const auto distance = [&](const Ball_position& q) { return (q.center - p).squaredNorm(); };
  return static_cast<std::size_t>(
      std::min_element(positions.begin(), positions.end(),
                       [&](const Ball_position& a, const Ball_position& b) { return distance(a) < distance(b); }) -
      positions.begin());
}

std::optional<Rim> lay_open_rim(const Base_surface& surface, const std::vector<Ball_position>& positions,
                                const std::array<Strip_end, 2>& ends, const std::array<Branch_end::Kind, 2>& kinds,
                                int side, double snap, std::size_t& stuck) {
  const std::size_t row = side == 0 ? 0 : ends[0].last.size() - 1;
  Rim rim;
  rim.surface = &surface;
  rim.keep_left = side == 0;
  rim.first = ends[0].last[row];
  rim.last = ends[1].last[row];
  std::vector<Station> points{ends[0].rim[side]};
  for (std::size_t i = rim.first; i <= rim.last && i < positions.size(); ++i) {
    stuck = i;
    if (surface.is_extension(positions[i].foot[side].face)) return std::nullopt;
    points.push_back(station_at(surface, positions[i].foot[side], 0));
  }
  points.push_back(ends[1].rim[side]);
  Path_rules rules{snap};
  for (const int end : {0, 1})
    if (kinds[end] == Branch_end::Kind::ball) rules.shared_ends[end] = shared_of_snap * snap;
  auto path = open_path(surface, points, rules, stuck);
  if (!path) {
    stuck = std::min(rim.first + std::max<std::size_t>(stuck, 1) - 1, positions.size() - 1);
    return std::nullopt;
  }
  rim.path = std::move(*path);
  std::vector<std::size_t> station_of(positions.size(), 0);
  for (std::size_t i = 0; i < positions.size(); ++i)
    station_of[i] = i < rim.first  ? 0
                    : i > rim.last ? rim.path.stations.size() - 1
                                   : rim.path.station_of[i - rim.first + 1];
  rim.path.station_of = std::move(station_of);
  return rim;
}

/// Rolls the ball along a branch, to the balls at rest where there are some.
Ball_path roll_to_balls(const Open_branch& branch, const Blend_curve& curve, const Radius_law& law,
                        const Sampling& steps) {
  const Base_surface& surface = *branch.surface;
  const double radius = law.largest();
  std::array<Ball_position, 2> at_rest;
  bool both = true;
  for (const Branch_end& end : branch.ends) {
    both = both && end.kind == Branch_end::Kind::ball;
    if (end.kind == Branch_end::Kind::ball)
      at_rest[end.end] = ball_in_corner(surface, *branch.corner[end.end], branch.place[end.end], end.left(), end.end);
  }
  if (branch.between_balls) return roll_between(surface, at_rest, curve.convex, law, steps);
  Ball_path path = roll_ball({&surface, &surface}, curve, Curve_kind::crease, law, steps);
  if (path.diagnosis.ok())
    for (const Branch_end& end : branch.ends)
      if (end.kind == Branch_end::Kind::ball)
        end_at(path.positions, at_rest[end.end], end.end, end.direction, clear_of_facet * steps.finest * radius);
  if (!both || (path.diagnosis.ok() && path.positions.size() >= 2)) return path;
  // Where little is left of a branch, the ball may not touch both sides beside its vertices.
  const Vec way = at_rest[1].center - at_rest[0].center;
  const bool is_ahead = way.dot(curve.points.back() - curve.points.front()) > 0;
  if (!law.is_constant() || !is_ahead || way.norm() > short_way * radius) return path;
  return roll_between(surface, at_rest, curve.convex, law, steps);
}

}  // namespace

Open_roll roll_open(Open_branch& branch, Blend_curve& curve, const Radius_law& law, const Profile& profile,
                    double chord_tolerance, const Sampling& steps, double snap) {
  Open_roll result;
  Base_surface& surface = *branch.surface;
  const double radius = law.largest();
  const std::array<const Base_surface*, 2> surfaces{&surface, &surface};
  for (const Branch_end& end : branch.ends) {
    curve.overhang[end.end] = 0;
    if (end.kind != Branch_end::Kind::faces) continue;
    curve.overhang[end.end] = end.reach;
    for (const auto& chain : end.border) surface.extend(chain, end.direction, 2 * end.reach);
  }
  Ball_path path = roll_to_balls(branch, curve, law, steps);
  result.diagnosis = path.diagnosis;
  if (!path.diagnosis.ok()) return result;
  const double facet = steps.finest * radius;
  const Ball_solver solver(surfaces, law, curve.convex);
  for (const Branch_end& end : branch.ends) {
    if (end.kind == Branch_end::Kind::cap)
      if (const auto ball =
              ball_at_flat_end(solver, end, end.end == 1 ? path.positions.back() : path.positions.front()))
        end_at(path.positions, *ball, end.end, end.direction, clear_of_facet * facet);
    if (end.kind == Branch_end::Kind::fade)
      end_fading(path.positions, end, to_vec(surface.mesh().point(end.vertex(surface.mesh()))));
  }
  for (const Branch_end& end : branch.ends) {
    if (!branch.through[end.end]) continue;
    const Vec ahead = end.end == 1 ? end.direction : Vec(-end.direction);
    branch.passed[end.end] = insert_ball(
        path.positions, ball_in_corner(surface, *branch.through[end.end], branch.place[end.end], end.left(), end.end),
        ahead, clear_of_facet * facet);
    if (end.end == 1 && branch.through[0]) branch.passed[0] = std::min(branch.passed[0], branch.passed[1]);
  }
  const Vec middle = (curve.points[(curve.points.size() - 1) / 2] + curve.points[curve.points.size() / 2]) / 2;
  if (path.positions.size() < 2) {
    result.diagnosis = refusal(Status::radius_exceeds_face, middle);
    return result;
  }
  result.positions = std::move(path.positions);
  const Virtual_surface& blend = result.surface.emplace(result.positions, surfaces, profile, false);
  branch.rows = blend.rows(chord_tolerance);
  for (const int end : {0, 1}) {
    Strip_end_result ended = end_strip(surface, branch.ends[end], result.positions, blend, branch.rows,
                                       nearest(result.positions, middle), clear_of_facet * facet, snap);
    result.diagnosis = ended.diagnosis;
    if (!ended.diagnosis.ok()) return result;
    branch.strip_ends[end] = std::move(ended.end);
  }
  for (std::size_t k = 0; k < branch.rows.size(); ++k) {
    // Rows that are cut by one end before they have come from the other: the ends take up the whole edge.
    const Vec &from = branch.strip_ends[0].hit[k], &to = branch.strip_ends[1].hit[k];
    const std::size_t i = std::min(branch.strip_ends[0].last[k], result.positions.size() - 2);
    const Vec ahead = result.positions[i + 1].center - result.positions[i].center;
    if (branch.strip_ends[0].last[k] <= branch.strip_ends[1].last[k]) continue;
    if ((to - from).dot(ahead) > 0) continue;
    result.diagnosis = refusal(Status::radius_exceeds_face, middle);
    return result;
  }
  for (const int side : {0, 1}) {
    std::size_t stuck = 0;
    auto rim = lay_open_rim(surface, result.positions, branch.strip_ends, {branch.ends[0].kind, branch.ends[1].kind},
                            side, snap, stuck);
    if (!rim) {
      result.diagnosis = refusal(Status::no_rolling_ball, result.positions[stuck].contact[side]);
      return result;
    }
    result.rims[side] = std::move(*rim);
  }
  return result;
}

namespace {

class End_assembler {
 public:
  End_assembler(Blend_mesh& mesh, const Cell_map& cells, const Open_branch& branch, int end, bool convex,
                const std::array<const Rim*, 2>& rims, double snap, End_assembly& out)
      : mesh_(mesh),
        cells_(cells),
        branch_(branch),
        end_(branch.ends[end]),
        strip_(branch.strip_ends[end]),
        convex_(convex),
        rims_(rims),
        snap_(snap),
        out_(out) {}

  Diagnosis run() {
    out_.border.last = strip_.last;
    out_.border.between.resize(strip_.hit.size());
    if (strip_.path) return cut();
    const bool fades = end_.kind == Branch_end::Kind::fade;
    for (std::size_t k = 0; k < strip_.hit.size(); ++k) {
      if (k == 0 || k + 1 == strip_.hit.size() || fades)
        out_.border.hit.push_back(rim_end(k == 0 ? 0 : 1));
      else
        out_.border.hit.push_back(mesh_.add_vertex(to_point(strip_.hit[k])));
    }
    return fades || end_.kind == Branch_end::Kind::ball ? Diagnosis{} : fill();
  }

 private:
  [[nodiscard]] Vertex rim_end(int side) const {
    return end_.end == 0 ? rims_[side]->vertices.front() : rims_[side]->vertices.back();
  }

  /// The strip is cut by faces: along its border.
  Diagnosis cut() {
    Rim cut;
    cut.surface = branch_.surface.get();
    cut.path = *strip_.path;
    cut.keep_left = end_.end == 1;
    cut.blend = rims_[0]->blend;
    cut.vertices.assign(cut.path.stations.size(), Blend_mesh::null_vertex());
    cut.vertices.front() = rim_end(0);
    cut.vertices.back() = rim_end(1);
    if (Diagnosis diagnosis = add_rim_vertices(mesh_, cells_, cut); !diagnosis.ok()) return diagnosis;
    for (std::size_t k = 0; k < strip_.hit.size(); ++k) {
      const std::size_t station = cut.path.station_of[k];
      out_.border.hit.push_back(cut.vertices[station]);
      if (k + 1 == strip_.hit.size()) break;
      for (std::size_t s = station + 1; s < cut.path.station_of[k + 1]; ++s)
        out_.border.between[k].push_back(cut.vertices[s]);
    }
    out_.cuts.push_back(std::move(cut));
    return {};
  }

  /// New faces close the strip: the loop that they fill runs from the vertex along the left side to the strip, along its
  /// border, and back along the right side.
  Diagnosis fill() {
    const int left = end_.left();
    std::array<std::vector<Vertex>, 2> leg;  // from the vertex outward, without the end of the rim
    for (const int side : {0, 1}) {
      const bool flat = end_.kind == Branch_end::Kind::cap;  // it may lie in the plane of faces beyond
      if (flat || !end_.inside[side])
        for (const Vertex v : border_to_rim(branch_.surface->mesh(), end_, side, strip_.rim[side]))
          leg[side].push_back(cells_.vertex(0, v));
      if (end_.inside[side] && leg[side].empty()) {
        if (Diagnosis diagnosis = cut_seam(side, leg[side]); !diagnosis.ok()) return diagnosis;
        continue;
      }
      if (leg[side].empty()) return refusal(Status::no_rolling_ball, strip_.rim[side].point);
      std::vector<Vertex> steps = leg[side];
      steps.push_back(rim_end(side));
      for (std::size_t i = 0; i + 1 < steps.size(); ++i)
        out_.filled.insert(side == left ? std::pair(steps[i], steps[i + 1]) : std::pair(steps[i + 1], steps[i]));
    }
    out_.fill = leg[left];
    std::vector<Vertex> border = out_.border.hit;
    if (left == 1) std::reverse(border.begin(), border.end());
    out_.fill.insert(out_.fill.end(), border.begin(), border.end());
    out_.fill.insert(out_.fill.end(), leg[1 - left].rbegin(), leg[1 - left].rend() - 1);
    if (end_.kind == Branch_end::Kind::cap) {
      out_.fill_normal = convex_ ? Vec(-end_.direction) : end_.direction;
    } else {
      const Blend_mesh& base = branch_.surface->mesh();
      out_.fill_normal = branch_.surface->frame(base.face(base.opposite(end_.border[left].front()))).face_normal;
    }
    return {};
  }

  /// Cuts a base face from the end of its rim to the vertex.
  Diagnosis cut_seam(int side, std::vector<Vertex>& leg) {
    const Blend_mesh& base = branch_.surface->mesh();
    const Face beside = base.face(side == end_.left() ? end_.into : base.opposite(end_.into));
    const Station vertex = station_at(*branch_.surface, beside, end_.vertex(base));
    std::size_t stuck = 0;
    auto path = open_path(*branch_.surface, {strip_.rim[side], vertex}, {end_.snap(snap_)}, stuck);
    if (!path) return refusal(Status::no_rolling_ball, strip_.rim[side].point);
    Rim seam;
    seam.surface = branch_.surface.get();
    seam.path = std::move(*path);
    seam.keep_left = (side == 0) == (end_.end == 1);
    seam.blend = rims_[0]->blend;
    seam.vertices.assign(seam.path.stations.size(), Blend_mesh::null_vertex());
    seam.vertices.front() = rim_end(side);
    if (Diagnosis diagnosis = add_rim_vertices(mesh_, cells_, seam); !diagnosis.ok()) return diagnosis;
    leg.assign(seam.vertices.rbegin(), seam.vertices.rend() - 1);
    out_.cuts.push_back(std::move(seam));
    return {};
  }

  Blend_mesh& mesh_;
  const Cell_map& cells_;
  const Open_branch& branch_;
  const Branch_end& end_;
  const Strip_end& strip_;
  bool convex_;
  const std::array<const Rim*, 2>& rims_;
  double snap_;
  End_assembly& out_;
};

}  // namespace

Diagnosis assemble_end(Blend_mesh& mesh, const Cell_map& cells, const Open_branch& branch, int end, bool convex,
                       const std::array<const Rim*, 2>& rims, double snap, End_assembly& out) {
  return End_assembler(mesh, cells, branch, end, convex, rims, snap, out).run();
}

}  // namespace cgal_blend
