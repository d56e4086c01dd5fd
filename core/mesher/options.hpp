#pragma once

#include "core/base/api.hpp"
#include "core/base/enum_words.hpp"
#include "core/domain/domain.hpp"
#include "core/grid/grid_kind.hpp"
#include "core/improve/improve_level.hpp"
#include "core/spacing/spec/spacing_spec.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace FOREFRONT_API forefront {

/// How the front advances.
enum class Method : std::uint8_t {
    Fast,   ///< walks along the front; one new node makes up to three elements
    Classic ///< the ten steps after Lo: shortest segment first, one element an advance
};

template <>
struct EnumWords<Method> {
    static constexpr auto kLast = Method::Classic;
    static constexpr std::array<std::string_view, 2> kList = {"fast", "classic"};
};

struct MeshingOptions {
    Method method = Method::Fast;
    GridKind grid = GridKind::Hierarchical;
    int gridColumns = 0; ///< uniform grid only; 0: chosen from the domain and the spacing
    int gridRows = 0;
    bool keepBoundary = false; ///< domain segments are edges of the mesh exactly as given
    /// After the front has closed. The fast method advances with more care where there is more of it: see FrontCare.
    ImproveLevel improve = ImproveLevel::Default;
    unsigned threads = 1; ///< the mesh does not depend on it

    friend bool operator==(const MeshingOptions &, const MeshingOptions &) = default;
};

/// All that a meshing run depends on.
struct MeshingJob {
    Domain domain;
    SpacingSpec spacing;
    MeshingOptions options;
};

} // namespace forefront
