#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/base/vec2.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

struct DiscreteDomain;
struct TriMesh;

/// The largest least angle that can be asked for, degrees. Refinement comes to an end up to about 33 degrees in
/// practice (J. R. Shewchuk, Delaunay Refinement Algorithms for Triangular Mesh Generation, 2002).
inline constexpr double kMaxLeastAngle = 33.0;

/// Why a mesh has angles below the least one at a place.
enum class ForcedBy : std::uint8_t {
    Corner,  ///< lines of the domain meet there at a smaller angle
    KeptEdge ///< an edge beside it may not be divided
};

template <>
struct EnumWords<ForcedBy> {
    static constexpr auto kLast = ForcedBy::KeptEdge;
    static constexpr std::array<std::string_view, 2> kList = {"corner", "kept-edge"};
};

/// A place where the domain itself forces angles below the least one.
struct ForcedAngle {
    ForcedBy reason = ForcedBy::Corner;
    Vec2 at;                  ///< the corner, or the centre of the sharpest element there
    double angle = 0.0;       ///< the least angle there, degrees
    std::size_t elements = 0; ///< number of elements with angles below the least one
    double reach = 0.0;       ///< greatest distance of one of these elements from the corner

    friend bool operator==(const ForcedAngle &, const ForcedAngle &) = default;
};

/// How a mesh got its least angle.
struct LeastAngleReport {
    std::size_t addedNodes = 0;   ///< all, with those on tagged edges
    std::size_t dividedEdges = 0; ///< tagged edges that were divided
    double reached = 0.0; ///< least angle of the elements that are not in the forced places, degrees; 0: all are
    std::vector<ForcedAngle> forced; ///< by reason, then the sharpest first

    friend bool operator==(const LeastAngleReport &, const LeastAngleReport &) = default;
};

/// Returns "5° at a sharp corner (1 element)".
std::string toString(const ForcedAngle &place);
/// Returns a note for each place that has smaller angles: "an angle of 5° at a sharp corner (1 element)".
Diagnostics forcedAngles(const LeastAngleReport &report);

/// What refinement may do.
struct LeastAngleRules {
    double angle = 30.0; ///< degrees, above 0, at most kMaxLeastAngle
    std::uint64_t maxElements = 50'000'000;
    std::function<bool(std::uint32_t edge)> mayDivide; ///< whether a tagged edge, by its first index, may be divided
};

/// Refines a mesh of triangles until no angle is below the least one, except where the domain forces it.
///
/// Sharp elements are first swapped away. Into the others, the sharpest first, goes a node at the place that A. Üngör
/// proposed (Off-centers, 2004): where the shortest side is seen at the least angle, or the centre of the circumcircle
/// if that is nearer. Where that node would lie beyond a tagged edge, or inside the circle over one as diameter, the
/// edge is divided instead, on its curve if it is the chord of one (J. Ruppert, 1995). Edges around each new node are
/// swapped by Delaunay's circle test. Elements that lie well are not touched. Beside edges that may not be divided, no
/// element becomes sharper than those that were there.
///
/// `mesh` and `boundary`: as the front and the improvement leave them; tagged edge i is segment i. Both get the new
/// nodes, edges and segments at their ends. Errors: "least-angle" with the places that have smaller angles, or where it
/// would take far more elements than the mesh has; "cancelled".
Status refineToLeastAngle(TriMesh &mesh, DiscreteDomain &boundary, const LeastAngleRules &rules,
                          LeastAngleReport &report, const Progress &progress = {});

} // namespace forefront
