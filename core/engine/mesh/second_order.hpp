#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/mesh/mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// The order of the elements of a mesh: of second order, they have nodes in the middles of their edges.
enum class ElementOrder : std::uint8_t { First, Second };

template <>
struct EnumWords<ElementOrder> {
    static constexpr auto kLast = ElementOrder::Second;
    static constexpr std::array<std::string_view, 2> kList = {"1", "2"};
};

/// The number of nodes of quadrilaterals of second order.
enum class QuadNodes : std::uint8_t {
    Eight, ///< corners and middles of edges
    Nine   ///< and the centre
};

template <>
struct EnumWords<QuadNodes> {
    static constexpr auto kLast = QuadNodes::Nine;
    static constexpr std::array<std::string_view, 2> kList = {"8", "9"};
};

/// Why an edge along a curve is straight.
enum class StraightReason : std::uint8_t {
    Folded,  ///< an element beside it would fold, or nearly
    Meeting, ///< it would bulge over another edge across the outside of the mesh, or nearly
    Crossing ///< curves cross or come too close there, so that the mesh follows chords
};

template <>
struct EnumWords<StraightReason> {
    static constexpr auto kLast = StraightReason::Crossing;
    static constexpr std::array<std::string_view, 3> kList = {"folded", "meeting", "crossing"};
};

/// An edge along a curve whose middle node lies on its chord instead.
struct StraightEdge {
    NodeId middle = kNoNode;
    Vec2 at; ///< place of its middle node
    StraightReason reason = StraightReason::Folded;

    friend bool operator==(const StraightEdge &, const StraightEdge &) = default;
};

/// An element whose Jacobian determinant varies much, as near a sharp corner of the domain.
struct UnevenElement {
    std::uint32_t element = 0;
    Vec2 at;            ///< its centre
    double ratio = 0.0; ///< minimum of the determinant over its maximum; not positive: the element is not convex

    friend bool operator==(const UnevenElement &, const UnevenElement &) = default;
};

/// How a mesh got its second order.
struct SecondOrderReport {
    std::size_t curvedEdges = 0;        ///< edges with their middle nodes on curves, off their chords
    std::size_t movedCorners = 0;       ///< corners moved for more uniform Jacobian determinants
    std::vector<StraightEdge> straight; ///< edges along curves that are straight, by number of their middle nodes
    std::vector<UnevenElement> uneven;  ///< elements below kReportedUniformity, the worst first

    friend bool operator==(const SecondOrderReport &, const SecondOrderReport &) = default;
};

/// Elements of second order are accepted if their Jacobian determinant is at least this share of that of the same
/// element with straight edges, everywhere.
inline constexpr double kLeastCurvedJacobian = 0.05;

/// Elements of second order are reported if the minimum of their Jacobian determinant is below this share of its
/// maximum.
inline constexpr double kReportedUniformity = 0.2;

/// What raiseOrder() makes of a mesh. Refers to its parts.
struct OrderRequest {
    QuadNodes quadNodes = QuadNodes::Eight;
    std::span<const std::size_t> chords = {}; ///< indices of tagged edges to be straight from the start
    /// Per node, whether it may move where the Jacobian determinant of an element varies too much; null: none may. The
    /// nodes of boundaries and tagged edges, and tagged nodes, stay in any case.
    const std::vector<bool> *movable = nullptr;
};

/// Adds a node in the middle of each edge of a mesh whose elements are of first order, and one in the centre of each
/// quadrilateral of 9 nodes. The corners keep their numbers; the middles of edges follow, then the centres. Both
/// elements of an edge share its middle node, which halves the length of the curve that a tagged edge is a chord of
/// (Mesh::edgeStretches), and else the edge. The centres are those of the same elements with 8 nodes.
///
/// Where the Jacobian determinant of an element varies too much, movable corners move first; see evenJacobians(). Where
/// an element would still fold, or nearly, its edge along a curve with the largest ratio of height to length becomes
/// straight, until the Bernstein coefficients of the determinants of all elements prove them valid; see
/// kLeastCurvedJacobian. So does an edge that would bulge over another across the outside of the mesh. Returns false if
/// it was cancelled; the mesh is then unchanged.
bool raiseOrder(Mesh &mesh, const OrderRequest &request, SecondOrderReport &report, const Progress &progress = {});

} // namespace forefront
