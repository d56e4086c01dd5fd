#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_numbers.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// The two faces of a crack in a mesh. The face on the left of the line keeps its tag; the one on the right has a tag
/// and a name of its own.
struct CrackFaces {
    std::int32_t left = 1;  ///< tag
    std::int32_t right = 2; ///< tag; its name is crackFaceName()
    std::size_t edges = 0;  ///< of each face
    double length = 0.0;    ///< domain units

    friend bool operator==(const CrackFaces &, const CrackFaces &) = default;
};

/// The cracks of a mesh.
struct CrackReport {
    std::vector<CrackFaces> cracks; ///< in the order of their tags
    std::size_t addedNodes = 0;     ///< copies of nodes, those in the middles of edges included
    std::size_t tips = 0;           ///< ends inside the domain, whose nodes both faces share

    friend bool operator==(const CrackReport &, const CrackReport &) = default;
};

/// Returns the name of the right face of a crack: its name and "_right".
std::string crackFaceName(const std::string &crack);

/// Opens inner lines of a mesh: elements on their two sides no longer share nodes there. Around each node, every sector
/// between lines and the boundary gets a node of its own at the same place; so a tip inside the domain stays one node,
/// one on the boundary becomes two, and where cracks branch or cross there is a node for each sector. The first sector,
/// by the lowest element, keeps the node; copies follow the other nodes, in the order of these.
///
/// The tagged edges of a line get the nodes of the face on the left, seen along the first of its edges; those of the
/// right face follow the other tagged edges, with the lowest tag above all others, or the lowest unused one where there
/// is none above. Tagged points are given to all copies of their nodes. Errors, which leave the mesh as it was:
/// crack-outside (a line has an element on one side alone), crack-edge (a single edge between two tips, which cannot
/// open), both with their places; crack-name (another part has the name of a right face), cancelled.
Result<CrackReport> openCracks(Mesh &mesh, std::span<const std::int32_t> tags, const Progress &progress = {});

/// A line of a mesh along which the elements on its two sides share no nodes, although their edges coincide: a crack,
/// or parts whose nodes were not merged.
struct OpenLine {
    std::int32_t tag = 0;   ///< that the closed line has; 0: its edges have none
    std::int32_t other = 0; ///< tag of the other face; 0: none, or the same
    std::size_t edges = 0;
    Vec2 at; ///< the middle of its first edge
};

/// A mesh whose open lines are closed. Nodes and elements keep their numbers: of coincident nodes, elements use the one
/// with the lowest number.
struct ClosedMesh {
    Mesh mesh;
    std::vector<OpenLine> lines;
};

/// Which open lines of a mesh are closed where it becomes a domain.
enum class OpenLineRule : std::uint8_t {
    All,
    OwnTags, ///< those with a tag that only their edges have; the others stay, so that repair() can merge their sides
};

/// Closes open lines: boundary edges of equal places, to the bit, with elements on opposite sides. Where one tag is
/// named like the right face of the other, the other one stays, else the lower one. `only`: tags of the lines to close,
/// and lines without tags; empty: all. Elements must be counter-clockwise and exist.
ClosedMesh closeCracks(const MeshView &mesh, std::span<const std::int32_t> only = {});

/// Closes open lines as closeCracks() does, and makes inner lines of them that can be told from other parts: one whose
/// tag other edges have too, such as parts whose nodes were not merged, gets an unused tag, and so do lines without a
/// tag, together. Such a tag is named "crack", or "crack_2" and so on. Names that no edge and no point has any longer
/// are dropped. Returns nothing if no line is closed. Elements must be counter-clockwise and exist.
std::optional<ClosedMesh> closeOpenLines(const MeshView &mesh, OpenLineRule rule = OpenLineRule::All);

/// Returns the open lines of a mesh, as closeCracks() finds them.
std::vector<OpenLine> openLines(const MeshView &mesh);

/// Returns the faults of the cracks of a mesh: an edge of a crack without its other face (crack-closed), a node whose
/// sectors are not one node each (crack-nodes). `cracks`: tags. `numbers`: of the nodes in messages.
Diagnostics verifyCracks(const MeshView &mesh, std::span<const std::int32_t> cracks, const MeshNumbers &numbers = {});

} // namespace forefront
