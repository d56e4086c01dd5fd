#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/domain/domain.hpp"

#include <memory>
#include <mutex>
#include <utility>

namespace forefront {

/// The domain of one document for several threads that need it: the first one makes it, the others wait for it.
class SharedDomain {
  public:
    explicit SharedDomain(std::shared_ptr<const Document> document) : document_(std::move(document)) {}

    const std::shared_ptr<const Document> &document() const { return document_; }
    /// Returns toDomain() of the document. Throws std::bad_alloc if memory runs out; the next call tries again.
    std::shared_ptr<const Domain> get();

  private:
    std::shared_ptr<const Document> document_;
    std::mutex mutex_;
    std::shared_ptr<const Domain> domain_;
};

} // namespace forefront
