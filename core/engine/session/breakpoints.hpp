#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/vec2.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace FOREFRONT_API forefront {

/// The conditions under which a moving run can stop.
enum class StopKind : std::uint8_t {
    Rejection,   ///< a candidate was tested and rejected
    Deferral,    ///< no candidate passed: the base was put back
    Forced,      ///< the closing stage made an element from existing nodes alone
    Join,        ///< two loops of Γ became one
    Split,       ///< a loop of Γ became two
    Closure,     ///< the last element of a loop
    LowAlpha,    ///< an element with α below Breakpoints::alphaBelow
    FrontLength, ///< the number of segments of Γ reached or left Breakpoints::segments
    Place,       ///< an element covers Breakpoints::place
    Cell         ///< the search visited Breakpoints::cell of the background grid
};
inline constexpr std::size_t kStopKinds = 10;
/// Returns the condition in words, such as "Two fronts join".
const char *stopTitle(StopKind kind);

/// The conditions that stop a run while it plays, or moves several steps. Seeking and meshing to the end ignore them.
struct Breakpoints {
    std::array<bool, kStopKinds> enabled{};
    double alphaBelow = 0.6;
    std::size_t segments = 100;
    std::optional<Vec2> place;
    std::optional<Box2> cell; ///< one of SessionSnapshot::cells

    bool has(StopKind kind) const { return enabled[static_cast<std::size_t>(kind)]; }
    void set(StopKind kind, bool on) { enabled[static_cast<std::size_t>(kind)] = on; }
    /// Returns true if any condition is enabled.
    bool any() const;

    friend bool operator==(const Breakpoints &, const Breakpoints &) = default;
};

/// The reason why a run stopped: the condition that the advance at the cursor fulfils.
struct Stop {
    StopKind kind = StopKind::Rejection;
    double value = 0.0; ///< LowAlpha: the smallest α of the advance; FrontLength: segments of Γ; Rejection: how many

    friend bool operator==(const Stop &, const Stop &) = default;
};

/// The node, edge or element that MeshingSession::seekBirth() found, and the advance that made it.
struct Birth {
    enum class Kind : std::uint8_t { Node, Edge, Triangle };
    Kind kind = Kind::Triangle;
    NodeId a = kNoNode, b = kNoNode; ///< the node; the ends of the edge
    ElementId element = kNoElement;  ///< the first element that has it; kNoElement: half of a square, without a number
    std::uint64_t advance = 0;       ///< position of the timeline just after it was made

    friend bool operator==(const Birth &, const Birth &) = default;
};

} // namespace forefront
