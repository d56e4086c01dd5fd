#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/mesh_numbers.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// A limit that the parts of a mesh must meet. limitInfo() describes each one.
enum class MeshLimit : std::uint8_t {
    MinAngle,
    MaxAngle,
    MinAlpha,
    MinScaledJacobian,
    MaxAspect,
    MaxLayerAspect,
    MaxGrowth,
    MinLength,
    MaxLength,
    MinDelta,
    MinAcross,
    MaxValence,
    MinIslandArea
};

/// The words are the options of the check command.
template <>
struct EnumWords<MeshLimit> {
    static constexpr auto kLast = MeshLimit::MinIslandArea;
    static constexpr std::array<std::string_view, 13> kList = {
        "min-angle",  "max-angle",  "min-alpha", "min-scaled-jacobian", "max-aspect",  "max-layer-aspect", "max-growth",
        "min-length", "max-length", "min-delta", "min-across",          "max-valence", "min-island-area"};
};

/// The description of a limit.
struct LimitInfo {
    const char *name;        ///< "minimum angle"
    const char *member;      ///< its name in project files: "minAngle"
    Measure measure;         ///< the one that it bounds
    bool isMinimum;          ///< false: a maximum
    double minimum, maximum; ///< the values that a limit can have; infinity: unbounded
    const char *meaning;     ///< for help and tooltips
};

/// Returns the description of a limit.
const LimitInfo &limitInfo(MeshLimit limit);

/// The limits that a user sets for a mesh; limits that are not set are not checked.
struct MeshLimits {
    std::array<std::optional<double>, wordsOf<MeshLimit>().size()> values;

    std::optional<double> &operator[](MeshLimit limit) { return values[static_cast<std::size_t>(limit)]; }
    const std::optional<double> &operator[](MeshLimit limit) const { return values[static_cast<std::size_t>(limit)]; }
    bool any() const;
    friend bool operator==(const MeshLimits &, const MeshLimits &) = default;
};

/// Returns limits of which those in `given` hold before those in `limits`.
MeshLimits mergedLimits(MeshLimits limits, const MeshLimits &given);

/// Returns the error in the value of a limit, "expected a number from 0 to 90, got 100"; empty if it is valid.
std::string limitFault(MeshLimit limit, double value);

/// A part of a mesh that violates a limit.
struct LimitPlace {
    std::uint32_t part = 0; ///< index of the element, edge or node
    double value = 0.0;
    Vec2 at;
    std::array<NodeId, 2> ends = {kNoNode, kNoNode}; ///< of an edge
};

/// The verdict on one limit.
struct LimitVerdict {
    MeshLimit limit = MeshLimit::MinAngle;
    double bound = 0.0;             ///< the value of the limit
    std::size_t judged = 0;         ///< number of parts checked; 0: the limit needs a spacing and none is given
    std::size_t broken = 0;         ///< number of parts that violate it
    double worst = 0.0;             ///< the value closest to violating the limit, or furthest beyond it
    std::vector<LimitPlace> places; ///< that violate it, the worst first

    /// Returns true if nothing violates the limit. A limit that needs a spacing is not met without one.
    bool met() const { return broken == 0 && (judged > 0 || limit != MeshLimit::MinDelta); }
};

/// Checks a mesh against the limits that are set, in their order. A value within a relative 1e-9 of a limit meets it,
/// so that rounding does not decide. A limit of the aspect ratio of layers judges these, as elementsOfFlatStacks()
/// finds them, and leaves the other elements to that of all. Verdicts list at most `places` places; an island is one
/// part, at its first edge. `spacing`: may be null.
std::vector<LimitVerdict> checkLimits(const MeshView &mesh, const MeshLimits &limits, const SpacingField *spacing,
                                      std::size_t places = 20);
/// Checks as above, with the edges of the mesh already known.
std::vector<LimitVerdict> checkLimits(const MeshView &mesh, const MeshEdges &edges, const MeshLimits &limits,
                                      const SpacingField *spacing, std::size_t places = 20);

/// Returns the verdict as a line: "minimum angle 25°: violated by 3 of 1200 elements, worst 12.3° at (1.5, 2)".
std::string toString(const LimitVerdict &verdict);
/// Returns an error for each place of a verdict: "element 12: min ∠ 12.3° violates the limit 25°". An edge is named by
/// its nodes. `numbers`: of the nodes and elements.
Diagnostics faultsOf(const LimitVerdict &verdict, const MeshNumbers &numbers = {});
/// Returns a warning for each verdict that is not met, with its line.
Diagnostics warningsOf(std::span<const LimitVerdict> verdicts);
/// Returns a value with the unit of the limit: "12.3°".
std::string valueText(MeshLimit limit, double value);

} // namespace forefront
