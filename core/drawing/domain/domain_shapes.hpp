#pragma once

#include "core/drawing/domain/chain_shape.hpp"
#include "core/drawing/domain/document_domain.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Returns shapes, without ids and names, that show an even-odd domain: a polygon for each of boundaryLoops() where the
/// boundary is closed, else chains as in fromDomain(); then its constraints and points.
std::vector<Shape> shapesOf(const Domain &domain, LooseEnds ends = LooseEnds::MoveCurve);

/// Returns the domain of some segments and points of a domain, without markers and other nodes; both keep their order.
Domain partOf(const Domain &domain, std::span<const std::uint32_t> segments, std::span<const std::uint32_t> points);

} // namespace forefront
