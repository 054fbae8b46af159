// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CURVE_NETWORK_H
#define CGAL_BLEND_CURVE_NETWORK_H

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace cgal_blend {

/// A chain of mesh edges between two nodes, or a closed chain without node.
template <class Graph>
struct Branch {
  using halfedge_descriptor = typename boost::graph_traits<Graph>::halfedge_descriptor;
  static constexpr std::size_t no_node = static_cast<std::size_t>(-1);

  std::vector<halfedge_descriptor> halfedges;  ///< consecutive: the target of one is the source of the next
  std::size_t first_node = no_node;            ///< index into `Curve_network::nodes`; `no_node` if closed
  std::size_t last_node = no_node;

  [[nodiscard]] bool closed() const { return first_node == no_node; }
};

/// A vertex at which a branch ends: an end (one branch) or a corner (any other number, or two that are not one curve).
template <class Graph>
struct Node {
  typename boost::graph_traits<Graph>::vertex_descriptor vertex;
  std::vector<std::size_t> branches;  ///< those that end here; twice the same for a loop with a node

  [[nodiscard]] bool is_end() const { return branches.size() == 1; }
};

/// Blending curves of a mesh: nodes, and the branches between them.
template <class Graph>
struct Curve_network {
  std::vector<Node<Graph>> nodes;
  std::vector<Branch<Graph>> branches;
};

namespace internal {

/// Returns the edges ordered by their position in the mesh, each once, whatever order they come in.
template <class Graph, class EdgeRange>
auto edges_in_mesh_order(const Graph& mesh, const EdgeRange& selected) {
  using edge_descriptor = typename boost::graph_traits<Graph>::edge_descriptor;
  std::vector<edge_descriptor> sorted(std::begin(selected), std::end(selected));
  if constexpr (std::is_convertible_v<edge_descriptor, std::size_t>) {
    std::sort(sorted.begin(), sorted.end());  // descriptors are indices: costs nothing on a large mesh
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
  } else {  // descriptors may be addresses, which change from run to run
    std::unordered_set<edge_descriptor> seen(sorted.begin(), sorted.end());
    sorted.clear();
    for (edge_descriptor e : edges(mesh))
      if (seen.count(e) != 0) sorted.push_back(e);
    return sorted;
  }
}

/// Any two edges that meet at a vertex alone make one curve.
struct Always_one_curve {
  template <class Halfedge>
  bool operator()(Halfedge, Halfedge) const {
    return true;
  }
};

/// Chains edges into branches; lives for one call of `make_curve_network`.
template <class Graph, class Is_one_curve>
class Network_builder {
  using Traits = boost::graph_traits<Graph>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using edge_descriptor = typename Traits::edge_descriptor;
  using Halfedges = std::vector<halfedge_descriptor>;

 public:
  Network_builder(const Graph& mesh, const std::vector<edge_descriptor>& sorted, const Is_one_curve& is_one_curve)
      : mesh_(mesh), is_one_curve_(is_one_curve) {
    for (edge_descriptor e : sorted) {
      const halfedge_descriptor h = halfedge(e, mesh);
      outgoing_[source(h, mesh)].push_back(h);
      outgoing_[target(h, mesh)].push_back(opposite(h, mesh));
    }
    for (edge_descriptor e : sorted)
      if (visited_.count(e) == 0) add_branch(halfedge(e, mesh));
  }

  Curve_network<Graph> take() { return std::move(network_); }

 private:
  void add_branch(halfedge_descriptor seed) {
    Branch<Graph> branch;
    branch.halfedges = walk(seed);
    const vertex_descriptor end = target(branch.halfedges.back(), mesh_);
    const bool closed = !is_node(end);
    if (!closed) prepend(walk(opposite(seed, mesh_)), branch.halfedges);
    for (halfedge_descriptor h : branch.halfedges) visited_.insert(edge(h, mesh_));
    if (!closed) {
      branch.first_node = node_at(source(branch.halfedges.front(), mesh_));
      branch.last_node = node_at(end);
      network_.nodes[branch.first_node].branches.push_back(network_.branches.size());
      network_.nodes[branch.last_node].branches.push_back(network_.branches.size());
    }
    network_.branches.push_back(std::move(branch));
  }

  // From a halfedge on to the next node, or once around.
  Halfedges walk(halfedge_descriptor h) const {
    Halfedges chain{h};
    while (!is_node(target(h, mesh_))) {
      const Halfedges& both = outgoing_.at(target(h, mesh_));
      h = both[0] == opposite(h, mesh_) ? both[1] : both[0];
      if (h == chain.front()) break;
      chain.push_back(h);
    }
    return chain;
  }

  // `backward` starts with the opposite of the first halfedge of `chain`.
  void prepend(const Halfedges& backward, Halfedges& chain) const {
    Halfedges whole;
    for (auto it = backward.rbegin(); it + 1 != backward.rend(); ++it) whole.push_back(opposite(*it, mesh_));
    whole.insert(whole.end(), chain.begin(), chain.end());
    chain = std::move(whole);
  }

  bool is_node(vertex_descriptor v) const {
    const Halfedges& out = outgoing_.at(v);
    return out.size() != 2 || !is_one_curve_(opposite(out[0], mesh_), out[1]);
  }

  std::size_t node_at(vertex_descriptor v) {
    const auto [it, is_new] = node_index_.emplace(v, network_.nodes.size());
    if (is_new) network_.nodes.push_back({v, {}});
    return it->second;
  }

  const Graph& mesh_;
  const Is_one_curve& is_one_curve_;
  std::unordered_map<vertex_descriptor, Halfedges> outgoing_;
  std::unordered_map<vertex_descriptor, std::size_t> node_index_;
  std::unordered_set<edge_descriptor> visited_;
  Curve_network<Graph> network_;
};

}  // namespace internal

/// Chains edges of a mesh into branches between nodes; a node is every vertex where other than two of them meet, or two
/// that are not one curve.
/// \param selected a range of edge descriptors in any order; repetitions count once
/// \param is_one_curve called with two halfedges, the target of the first being the source of the second, where no third
///        edge is: whether a branch goes on from one to the other; the same for the opposites in reverse
/// Branches come in the order of their first edge in `edges(mesh)` and run along that edge's `halfedge(e, mesh)`; a
/// closed branch starts there. Nodes come in the order in which the branches name them.
/// Costs O(k log k) for k edges if descriptors are indices (`Surface_mesh`), else one more sweep over the mesh's edges.
template <class Graph, class EdgeRange, class Is_one_curve = internal::Always_one_curve>
[[nodiscard]] Curve_network<Graph> make_curve_network(const Graph& mesh, const EdgeRange& selected,
                                                      const Is_one_curve& is_one_curve = {}) {
  return internal::Network_builder<Graph, Is_one_curve>(mesh, internal::edges_in_mesh_order(mesh, selected),
                                                        is_one_curve)
      .take();
}

}  // namespace cgal_blend

#endif
