#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/enum_words.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace FOREFRONT_API forefront {

struct Domain;

/// The shapes of the elements of boundary layers.
enum class LayerCells : std::uint8_t {
    Quads,    ///< quadrilaterals, with a triangle wherever the number of layers changes by one
    Triangles ///< the same, with each quadrilateral divided into two triangles
};

template <>
struct EnumWords<LayerCells> {
    static constexpr auto kLast = LayerCells::Triangles;
    static constexpr std::array<std::string_view, 2> kList = {"quads", "triangles"};
};

/// Boundary layers on one part of the boundary: rows of thin elements along it, each higher than the one below by the
/// factor `growth`. Without a count and a thickness, layers are added until the next one would be as high as 0.7 times
/// the length of the wall edges below it.
struct LayerSpec {
    std::int32_t tag = 1;                 ///< of the boundary part
    double first = 0.0;                   ///< height of the first layer in domain units, > 0
    double growth = 1.2;                  ///< ratio of the heights of successive layers, 1 to 4
    std::optional<std::uint32_t> count{}; ///< number of layers, 1 to kMaxLayers
    std::optional<double> thickness{}; ///< height of all layers; the number of layers that comes nearest to it is used
    LayerCells cells = LayerCells::Quads;

    friend bool operator==(const LayerSpec &, const LayerSpec &) = default;
};

/// Maximum number of layers on a boundary part.
inline constexpr std::uint32_t kMaxLayers = 2000;
/// Minimum growth of layers that are added until they are isotropic.
inline constexpr double kMinGrowthToIsotropic = 1.01;

/// Returns the fault of the numbers of a specification; nothing if they are valid. `owner`: the boundary part, in
/// messages.
std::optional<Diagnostic> layerFault(const LayerSpec &spec, std::string_view owner);

/// Returns the faults of layers on a domain: invalid numbers ("bad-layer"), a tag that no segment has, with the list of
/// parts ("unknown-boundary"), and two specifications of one tag ("repeated-layer").
Diagnostics checkLayers(std::span<const LayerSpec> specs, const Domain &domain);

} // namespace forefront
