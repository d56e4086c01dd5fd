#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// How the nodes and elements of a file are numbered: in the order in which they were made, or for a small bandwidth.
enum class Numbering : std::uint8_t { Creation, ReverseCuthillMcKee };

template <>
struct EnumWords<Numbering> {
    static constexpr auto kLast = Numbering::ReverseCuthillMcKee;
    static constexpr std::array<std::string_view, 2> kList = {"creation", "rcm"};
};

/// Returns the maximum difference between the numbers of two nodes of one element, the half-bandwidth of a matrix with
/// one unknown per node. 0: no elements.
std::size_t bandwidth(const MeshView &mesh);

/// Returns a new number for each node by the reverse Cuthill-McKee algorithm: E. Cuthill, J. McKee, "Reducing the
/// bandwidth of sparse symmetric matrices", Proc. 24th Nat. Conf. ACM, 1969; reversed after A. George, 1971. Each part
/// of the mesh starts at an end of it, in the manner of N. E. Gibbs, W. G. Poole, P. K. Stockmeyer, 1976. Nodes without
/// elements come last.
std::vector<NodeId> reverseCuthillMcKee(const MeshView &mesh);

/// Returns a copy of a mesh whose nodes have other numbers. Elements of a kind are ordered by their least node, ties as
/// before; edges and points keep their order. `numbers`: a permutation, the new number of each node.
Mesh renumbered(const MeshView &mesh, std::span<const NodeId> numbers);

} // namespace forefront
