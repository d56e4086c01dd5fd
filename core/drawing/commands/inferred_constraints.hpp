#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/picking/inference.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A node of a shape whose place was taken with relations.
struct InferredNode {
    Vec2 at;
    std::vector<Inference> relations;
    std::vector<Vec2> path; ///< nodes of the path that was drawn up to it, which Inference::withOwn counts
};

/// A document with constraints that were inferred.
struct InferredConstraints {
    Document document;
    std::size_t added = 0;
};

/// Returns relations that a drawn path has by itself: tangents where its arcs of circles meet other arcs or straight
/// segments without a corner, and a horizontal or vertical last side of a closed path.
std::vector<InferredNode> relationsOfPath(const Shape &path);

/// Adds the relations of nodes of a shape as constraints, in order. `found`: the document in which they were found,
/// whose parts they refer to. Of a line that was divided since, its first part counts. Left out are relations whose
/// node or line does not exist, and those that the others imply.
InferredConstraints addInferred(Document document, std::uint32_t shape, std::span<const InferredNode> nodes,
                                const Document &found);

} // namespace forefront
