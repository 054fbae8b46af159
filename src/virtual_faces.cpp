// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that a base surface has and its mesh has not: beyond sharp edges, and round them.
#include "base_surface.h"

#include <Eigen/Geometry>

#include <cgal_blend/creases.h>

#include <algorithm>

namespace cgal_blend {

namespace {

constexpr double least_departure = 0.02;  // sine of the angle between an edge and the direction that leaves across it

}  // namespace

int Base_surface::index_of(Halfedge h) const {
  const Frame& f = frame(mesh_.face(h));
  return f.halfedge[0] == h ? 0 : f.halfedge[1] == h ? 1 : 2;
}

Face Base_surface::add_virtual_face(const std::array<Vec, 3>& corner, const std::array<Vec, 3>& place,
                                    const std::array<Vec, 3>& normal, const Vec& outward, Halfedge band) const {
  Frame f;
  f.corner = corner;
  f.place = place;
  f.normal = normal;
  const Vec cross = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  const Vec unit = cross.stableNormalized();
  for (int i = 0; i < 3; ++i)
    f.gradient[i] = unit.cross(corner[(i + 2) % 3] - corner[(i + 1) % 3]) / cross.stableNorm();
  f.face_normal = unit.dot(outward) < 0 ? Vec(-unit) : unit;
  const Face face(first_virtual_ + static_cast<std::uint32_t>(virtual_.size()));
  frames_.emplace(face.idx(), f);
  virtual_.push_back({{}, band});
  return face;
}

void Base_surface::extend(const std::vector<Halfedge>& chain, const Vec& direction, double length) {
  struct Quad {
    Halfedge halfedge;
    Vertex source, target;
    Face low, high;  // low has the edge; high the far side and, like low, the diagonal from source to far target
  };
  std::vector<Quad> quads;
  for (const Halfedge h : chain) {
    if (extension_beyond_.count(h.idx())) continue;
    const Frame& f = frame(mesh_.face(h));
    const int t = index_of(h), s = (t + 2) % 3;
    const Vec outward = -f.gradient[(t + 1) % 3].stableNormalized();
    if (direction.dot(outward) < least_departure) continue;
    std::array<Vec, 2> far;
    for (const int end : {0, 1}) {
      const int k = end == 0 ? s : t;
      const Vec normal = f.normal[k].stableNormalized();
      const Vec tangent = direction - direction.dot(normal) * normal;
      far[end] = f.corner[k] + length * tangent.stableNormalized();
    }
    // The face lies left of its halfedge, so beyond it the corners run target, source, far source, far target.
    Quad quad{h, mesh_.source(h), mesh_.target(h), Face(), Face()};
    const std::array<Vec, 3> low{f.corner[t], f.corner[s], far[1]}, high{f.corner[s], far[0], far[1]};
    quad.low = add_virtual_face(low, low, {f.normal[t], f.normal[s], f.normal[t]}, f.face_normal, Halfedge());
    quad.high = add_virtual_face(high, high, {f.normal[s], f.normal[s], f.normal[t]}, f.face_normal, Halfedge());
    const auto sides = [&](Face face) -> std::array<Side, 3>& { return virtual_[face.idx() - first_virtual_].sides; };
    sides(quad.low)[0] = {quad.high, 1, Halfedge()};
    sides(quad.low)[1] = sides(quad.high)[2] = sides(quad.high)[0] = {Blend_mesh::null_face(), -1, h};
    sides(quad.low)[2] = {mesh_.face(h), (t + 1) % 3, Halfedge()};
    sides(quad.high)[1] = {quad.low, 0, Halfedge()};
    extension_beyond_[h.idx()] = {quad.low, 2, Halfedge()};
    quads.push_back(quad);
  }
  // Neighbours share the side from a vertex to its far vertex: low has that of its target, high that of its source.
  for (const Quad& a : quads)
    for (const Quad& b : quads)
      if (a.target == b.source && a.low != b.low && (!rolls() || fan(a.halfedge) == fan(mesh_.prev(b.halfedge)))) {
        virtual_[a.low.idx() - first_virtual_].sides[1] = {b.high, 2, Halfedge()};
        virtual_[b.high.idx() - first_virtual_].sides[2] = {a.low, 1, Halfedge()};
      }
  if (!rolls()) return;
  for (const Quad& quad : quads) {
    extend_band(quad.low, 1, quad.halfedge, true);
    extend_band(quad.high, 2, quad.halfedge, false);
  }
}

/// Continues the band over the edge beside an extension, if there is one, along the side of the extension.
/// \param exit the side of the face, at the target or at the source of the edge h that the extension begins at
void Base_surface::extend_band(Face face, int exit, Halfedge h, bool at_target) {
  if (virtual_[face.idx() - first_virtual_].sides[exit].face != Blend_mesh::null_face()) return;
  const Halfedge edge = next_on_border(h, at_target), beyond = mesh_.opposite(edge);
  if (!rolls_over(edge)) return;
  const Halfedge corner = at_target ? beyond : mesh_.prev(beyond);
  const Frame f = frame(face);
  const Vec near_normal = f.normal[(exit + 1) % 3], far_normal = frame(mesh_.face(corner)).normal[index_of(corner)];
  const Vec source = f.corner[(exit + 1) % 3], target = f.corner[(exit + 2) % 3];
  const Vec across =
      -options_.rolling_radius * angle_between(near_normal, far_normal) * f.gradient[exit].stableNormalized();
  const Face low = add_virtual_face({target, source, target + across}, {target, source, target},
                                    {near_normal, near_normal, far_normal}, f.face_normal, Halfedge());
  const Face high = add_virtual_face({source, source + across, target + across}, {source, source, target},
                                     {near_normal, far_normal, far_normal}, f.face_normal, Halfedge());
  const Side before = band_at_end(edge, !at_target), after = at_target ? Side{low, 1, {}} : Side{high, 2, {}};
  virtual_[low.idx() - first_virtual_].sides = {{{high, 1, {}}, {}, {face, exit, {}}}};
  virtual_[high.idx() - first_virtual_].sides = {{{}, {low, 0, {}}, {}}};
  virtual_[after.face.idx() - first_virtual_].sides[after.opposite] = before;
  virtual_[before.face.idx() - first_virtual_].sides[before.opposite] = after;
  virtual_[face.idx() - first_virtual_].sides[exit] = {low, 2, {}};
  // The face beyond may be extended as well.
  const auto found = extension_beyond_.find(next_on_border(beyond, at_target).idx());
  if (found == extension_beyond_.end()) return;
  const Face near = found->second.face;  // low; its neighbour on side 0 is high
  const Side outer = at_target ? Side{virtual_[near.idx() - first_virtual_].sides[0].face, 2, {}} : Side{near, 1, {}};
  virtual_[high.idx() - first_virtual_].sides[0] = outer;
  virtual_[outer.face.idx() - first_virtual_].sides[outer.opposite] = {high, 0, {}};
}

/// The sharp edge that the surface's border goes on with at the target or the source of one.
Halfedge Base_surface::next_on_border(Halfedge h, bool at_target) const {
  const Halfedge o = mesh_.opposite(h);
  h = at_target ? mesh_.next(h) : mesh_.prev(h);
  while (crossable(h) && h != o) h = at_target ? mesh_.next(mesh_.opposite(h)) : mesh_.prev(mesh_.opposite(h));
  return h;
}

/// The side of an edge's band at the target or the source of the edge's halfedge.
Base_surface::Side Base_surface::band_at_end(Halfedge h, bool at_target) const {
  const std::array<Face, 2> faces = band(h);
  return (h < mesh_.opposite(h)) == at_target ? Side{faces[0], 1, {}} : Side{faces[1], 2, {}};
}

bool Base_surface::rolls_over(Halfedge h) const {
  const Edge e = mesh_.edge(h);
  if (!rolls() || mesh_.is_border(e) || crossable(h) || (creases_ && creases_->count(e))) return false;
  if (extension_beyond_.count(h.idx()) || extension_beyond_.count(mesh_.opposite(h).idx())) return false;
  const bool convex = edge_convexity(e, mesh_) == (options_.reversed ? CGAL::NEGATIVE : CGAL::POSITIVE);
  return convex != options_.ball_inside;
}

/// The band over an edge. With h the smaller halfedge of it, low has the corners target, source, far target, and high
/// source, far source, far target; the far ones have the normals of the face beyond. For the walk they are as far away as
/// the ball's centre moves while it turns over the edge.
std::array<Face, 2> Base_surface::band(Halfedge edge) const {
  const Halfedge h = std::min(edge, mesh_.opposite(edge)), o = mesh_.opposite(h);
  const auto found = bands_.find(h.idx());
  if (found != bands_.end()) return found->second;
  const Frame &f = frame(mesh_.face(h)), &g = frame(mesh_.face(o));
  const int t = index_of(h), s = (t + 2) % 3, beyond_s = index_of(o), beyond_t = (beyond_s + 2) % 3;
  const double width = options_.rolling_radius * angle_between(f.face_normal, g.face_normal);
  const Vec across = -width * f.gradient[(t + 1) % 3].stableNormalized();
  const Vec &target = f.corner[t], &source = f.corner[s];
  const Face low = add_virtual_face({target, source, target + across}, {target, source, target},
                                    {f.normal[t], f.normal[s], g.normal[beyond_t]}, f.face_normal, h);
  const Face high = add_virtual_face({source, source + across, target + across}, {source, source, target},
                                     {f.normal[s], g.normal[beyond_s], g.normal[beyond_t]}, f.face_normal, h);
  virtual_[low.idx() - first_virtual_].sides = {{{high, 1, {}}, {}, {mesh_.face(h), (t + 1) % 3, {}}}};
  virtual_[high.idx() - first_virtual_].sides = {{{mesh_.face(o), (beyond_s + 1) % 3, {}}, {low, 0, {}}, {}}};
  return bands_[h.idx()] = {low, high};
}

Base_surface::Side Base_surface::band_beyond(Halfedge h) const {
  const std::array<Face, 2> faces = band(h);
  return h < mesh_.opposite(h) ? Side{faces[0], 2, {}} : Side{faces[1], 0, {}};
}

/// The neighbour of a band; over the end of its edge, where the surfaces on both sides go on, the band of the next edge.
Base_surface::Side Base_surface::across_band(Face face, int exit) const {
  const Side& known = virtual_[face.idx() - first_virtual_].sides[exit];
  if (known.face != Blend_mesh::null_face()) return known;
  const Halfedge h = band_edge(face), o = mesh_.opposite(h);
  const bool at_target = face == band(h)[0];
  const Halfedge next = next_on_border(h, at_target), beyond = mesh_.opposite(next);
  const bool goes_on = rolls_over(next) && next != o &&
                       (at_target ? fan(beyond) == fan(mesh_.prev(o)) : fan(mesh_.prev(beyond)) == fan(o));
  return goes_on ? band_at_end(next, !at_target) : Side{Blend_mesh::null_face(), -1, h};
}

}  // namespace cgal_blend
