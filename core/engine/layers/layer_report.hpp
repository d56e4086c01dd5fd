#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/vec2.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// The reasons for fewer boundary layers than asked for.
enum class LayerStop : std::uint8_t {
    Wall,   ///< another part of the boundary is too near
    Point,  ///< a constraint point is too near
    End,    ///< the layers end there, beside a part along which they cannot slide
    Fold,   ///< an element would be inverted
    Meeting ///< the top of the layers would meet another part of the boundary or other layers
};

template <>
struct EnumWords<LayerStop> {
    static constexpr auto kLast = LayerStop::Meeting;
    static constexpr std::array<std::string_view, 5> kList = {"wall", "point", "end", "fold", "meeting"};
};

/// A ray from a wall that has fewer layers than asked for.
struct ShortenedRay {
    Vec2 base;               ///< its node on the wall
    Vec2 end;                ///< where its layers end
    std::int32_t tag = 1;    ///< of the wall
    std::uint32_t asked = 0; ///< number of layers
    std::uint32_t made = 0;  ///< number of layers, < asked
    LayerStop stop = LayerStop::Wall;
    std::int32_t stoppedBy = 0; ///< tag of the boundary part, or of the point, that stopped it or a ray beside it
};

/// A ray from a wall and the number of its layers.
struct LayerLine {
    Vec2 base; ///< its node on the wall
    Vec2 end;  ///< the top of its layers
    std::uint32_t layers = 0;
};

/// What became of the boundary layers of a mesh.
struct LayerReport {
    std::size_t quadrilaterals = 0;
    std::size_t triangles = 0;
    std::size_t rays = 0;
    std::size_t fans = 0;                ///< convex corners with more than one ray
    std::uint32_t fewest = 0;            ///< layers of a ray
    std::uint32_t most = 0;              ///< layers of a ray
    std::vector<ShortenedRay> shortened; ///< along the walls
    std::vector<LayerLine> lines;        ///< of all rays, along the walls
};

/// Returns a note for each pair of a wall and a part that stopped its layers, with the number of rays and their first
/// places; nothing if no ray was shortened. `names`: of boundary parts.
Diagnostics shortenedLayers(const LayerReport &report, const std::map<std::int32_t, std::string> &names);

} // namespace forefront
