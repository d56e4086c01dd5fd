#pragma once

#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/picking/face_map.hpp"
#include "core/drawing/picking/pick_index.hpp"

#include <cstdint>
#include <memory>
#include <utility>

namespace forefront::edit_test {

/// A drawing with what picking and commands on faces need.
struct FaceDrawing {
    explicit FaceDrawing(Document drawing)
        : document(std::make_shared<const Document>(std::move(drawing))), index(document),
          map(faceMapOf(std::make_shared<const Domain>(toDomain(*document)))) {}

    std::uint32_t faceAt(Vec2 p) const { return map->faceAt(p); }

    std::shared_ptr<const Document> document;
    PickIndex index;
    std::shared_ptr<const FaceMap> map;
};

} // namespace forefront::edit_test
