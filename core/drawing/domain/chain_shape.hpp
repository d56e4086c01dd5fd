#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/domain/chains/chain_path.hpp"

namespace forefront {

/// Returns a shape, without id, name and use, along a path: a polygon, polyline, circle or ellipse.
Shape shapeOf(ChainPath path);

/// Returns a document that shows a domain. Without `ends`, fromDomain() chooses them so that no fault is added.
Document fromDomain(const Domain &domain, LooseEnds ends);

} // namespace forefront
