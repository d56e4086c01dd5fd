#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesher/options.hpp"

#include <memory>
#include <mutex>
#include <utility>

namespace forefront {

/// The domain and spacing of one document for several threads that need them: the first one makes them, the others
/// wait.
class SharedDomain {
  public:
    explicit SharedDomain(std::shared_ptr<const Document> document) : document_(std::move(document)) {}

    const std::shared_ptr<const Document> &document() const { return document_; }
    /// Returns jobOf() the document. Throws std::bad_alloc if memory runs out; the next call tries again.
    std::shared_ptr<const MeshingJob> job();
    /// Returns the domain of job().
    std::shared_ptr<const Domain> get();

  private:
    std::shared_ptr<const Document> document_;
    std::mutex mutex_;
    std::shared_ptr<const MeshingJob> job_;
};

} // namespace forefront
